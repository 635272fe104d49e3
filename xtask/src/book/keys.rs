//! Keys of the answers in JSON for a chapter of the book, from the schemas that the program prints.

use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;

/// Schemas of the files that the program reads and of its answers, by the words of `epicyclic schema`.
///
/// # Errors
/// A message where the program does not print one.
pub fn schemas() -> Result<Vec<(String, Value)>, String> {
    let line = epicyclic::command_line();
    let values = line.find_subcommand("schema").and_then(|schema| schema.get_positionals().next());
    let names = values.map(clap::Arg::get_possible_values).unwrap_or_default();
    names.iter().map(|name| Ok((name.get_name().to_owned(), schema(name.get_name())?))).collect()
}

fn schema(name: &str) -> Result<Value, String> {
    let desk = epicyclic::desk::captured::Captured::default();
    let code = epicyclic::call(["schema", name], &desk);
    let said = desk.into_told();
    serde_json::from_slice(&said.answer)
        .map_err(|error| format!("epicyclic schema {name}: exit code {code}: {error}: {:?}", said.messages))
}

/// Tables of all keys, an answer a section.
///
/// # Errors
/// As [`schemas`].
pub fn tables() -> Result<String, String> {
    let of_answer =
        |(name, schema): (String, Value)| Some((name.strip_prefix("answer-")?.to_owned(), schema));
    let schemas: Vec<(String, Value)> = schemas()?.into_iter().filter_map(of_answer).collect();
    let by_keys = schemas.iter().map(|(name, schema)| (keys(schema), name.clone())).collect();
    let mut page = String::new();
    for (name, schema) in &schemas {
        let _ = write!(page, "\n## {name}\n\n| key | is |\n|---|---|\n");
        rows(schema, schema, "", &by_keys, &mut page);
    }
    Ok(page)
}

/// A part of a schema: itself, or the definition that it refers to.
fn resolved<'a>(schema: &'a Value, part: &'a Value) -> &'a Value {
    let name = part.get("$ref").and_then(Value::as_str).and_then(|name| name.strip_prefix('#'));
    name.and_then(|name| schema.pointer(name)).map_or(part, |part| resolved(schema, part))
}

/// The choices of a part but for `null`.
fn choices<'a>(schema: &'a Value, part: &'a Value) -> Vec<&'a Value> {
    let part = resolved(schema, part);
    let all = ["anyOf", "oneOf", "allOf"].into_iter().filter_map(|key| part.get(key)?.as_array()).flatten();
    let all: Vec<&Value> = all.flat_map(|choice| choices(schema, choice)).collect();
    if all.is_empty() { vec![part] } else { all }
}

/// The words that a value may be.
fn words(schema: &Value, part: &Value) -> Vec<String> {
    let of = |choice: &Value| -> Vec<String> {
        let listed = choice.get("enum").and_then(Value::as_array).into_iter().flatten();
        let all = listed.chain(choice.get("const"));
        all.filter_map(Value::as_str).map(|word| format!("`{word}`")).collect()
    };
    choices(schema, part).into_iter().flat_map(of).collect()
}

/// The keys of an object but for those that every answer has.
fn keys(part: &Value) -> BTreeSet<String> {
    let own = part.get("properties").and_then(Value::as_object).into_iter().flatten();
    own.map(|(key, _)| key.clone()).filter(|key| key != "schema_version" && key != "answer").collect()
}

/// Answers by their keys: an answer that is part of another one is named there, without its keys.
type Answers = BTreeMap<BTreeSet<String>, String>;

/// Adds a row for each key below a part of a schema: `[]` means each entry of a list, `*` each name of a map.
fn rows(schema: &Value, part: &Value, path: &str, answers: &Answers, page: &mut String) {
    for choice in choices(schema, part) {
        if let Some(entries) = choice.get("items") {
            rows(schema, entries, &format!("{path}[]"), answers, page);
        }
        if let Some(entries) = choice.get("additionalProperties").filter(|entries| entries.is_object()) {
            rows(schema, entries, &format!("{path}.*"), answers, page);
        }
        for (key, inner) in choice.get("properties").and_then(Value::as_object).into_iter().flatten() {
            let path = if path.is_empty() { key.clone() } else { format!("{path}.{key}") };
            let description = inner.get("description").or_else(|| resolved(schema, inner).get("description"));
            let description = description.and_then(Value::as_str).unwrap_or_default();
            let description = description.replace('\n', " ").replace('|', "\\|");
            let words = words(schema, inner);
            let one_of =
                if words.len() < 2 { String::new() } else { format!(" One of {}.", words.join(", ")) };
            let entries = inner.get("items").unwrap_or(inner);
            let whole = answers.get(&keys(resolved(schema, entries)));
            let as_answer = whole.map_or_else(String::new, |name| format!(" Keys as of [{name}](#{name})."));
            let _ = writeln!(page, "| `{path}` | {description}{one_of}{as_answer} |");
            if whole.is_none() {
                rows(schema, inner, &path, answers, page);
            }
        }
    }
}

/// Every key of a schema, at any depth.
#[must_use]
pub fn all_keys(schema: &Value) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    let mut open = vec![schema];
    while let Some(part) = open.pop() {
        match part {
            Value::Array(parts) => open.extend(parts),
            Value::Object(parts) => {
                let own = parts.get("properties").and_then(Value::as_object).into_iter().flatten();
                found.extend(own.map(|(key, _)| key.clone()));
                open.extend(parts.values());
            }
            _ => {}
        }
    }
    found
}
