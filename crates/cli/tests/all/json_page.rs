//! The page `docs/src/reference/json.md` lists the keys of every answer as the schemas have them.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use crate::common;

use common::{output, text};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::path::Path;

/// The page is generated from this line on.
const MARK: &str = "<!-- From here on made from the schemas: UPDATE_BOOK=1 cargo test -p epicyclic -->\n";

fn printed(args: &[&str]) -> String {
    let done = output(Path::new("."), args);
    assert!(done.status.success(), "{args:?} {done:?}");
    text(&done.stdout)
}

/// The answers that `epicyclic schema` knows.
fn answers() -> Vec<String> {
    let help = printed(&["schema", "-h"]);
    let list = help.split("[possible values: ").nth(1).unwrap().split(']').next().unwrap();
    let names = list.split(',').map(|name| name.split_whitespace().collect::<String>());
    names.filter_map(|name| name.strip_prefix("answer-").map(str::to_owned)).collect()
}

/// A part of a schema: itself, or what it refers to.
fn resolved<'a>(schema: &'a Value, part: &'a Value) -> &'a Value {
    match part.get("$ref").and_then(Value::as_str) {
        Some(name) => resolved(schema, schema.pointer(name.strip_prefix('#').unwrap()).unwrap()),
        None => part,
    }
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

/// Answers by their keys: if one is part of another, the page names it instead of listing its keys again.
type Answers = BTreeMap<BTreeSet<String>, String>;

/// Writes a line for each key below a part of a schema: `[]` for each entry of a list, `*` for each name of a
/// map.
fn lines(schema: &Value, part: &Value, path: &str, answers: &Answers, page: &mut String) {
    for choice in choices(schema, part) {
        if let Some(entries) = choice.get("items") {
            lines(schema, entries, &format!("{path}[]"), answers, page);
        }
        if let Some(entries) = choice.get("additionalProperties").filter(|entries| entries.is_object()) {
            lines(schema, entries, &format!("{path}.*"), answers, page);
        }
        for (key, inner) in choice.get("properties").and_then(Value::as_object).into_iter().flatten() {
            let path = if path.is_empty() { key.clone() } else { format!("{path}.{key}") };
            let told = inner.get("description").or_else(|| resolved(schema, inner).get("description"));
            let told =
                told.and_then(Value::as_str).unwrap_or_default().replace('\n', " ").replace('|', "\\|");
            let words = words(schema, inner);
            let one_of =
                if words.len() < 2 { String::new() } else { format!(" One of {}.", words.join(", ")) };
            let entries = inner.get("items").unwrap_or(inner);
            let whole = answers.get(&keys(resolved(schema, entries)));
            let as_answer = whole.map_or_else(String::new, |name| format!(" Keys as of [{name}](#{name})."));
            writeln!(page, "| `{path}` | {told}{one_of}{as_answer} |").unwrap();
            if whole.is_none() {
                lines(schema, inner, &path, answers, page);
            }
        }
    }
}

fn made() -> String {
    let mut page = MARK.to_owned();
    let schema = |name: String| {
        let schema = serde_json::from_str(&printed(&["schema", &format!("answer-{name}")])).unwrap();
        (name, schema)
    };
    let schemas: Vec<(String, Value)> = answers().into_iter().map(schema).collect();
    let by_keys = schemas.iter().map(|(name, schema)| (keys(schema), name.clone())).collect();
    for (name, schema) in &schemas {
        write!(page, "\n## {name}\n\n| key | is |\n|---|---|\n").unwrap();
        lines(schema, schema, "", &by_keys, &mut page);
    }
    page
}

#[test]
fn the_page_lists_the_keys_of_every_answer() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/src/reference/json.md");
    let page = std::fs::read_to_string(&path).unwrap();
    let (own, there) = page.split_once(MARK).unwrap();
    let made = made();
    if std::env::var_os("UPDATE_BOOK").is_some() {
        std::fs::write(path, format!("{own}{made}")).unwrap();
        return;
    }
    let there = format!("{MARK}{there}");
    for (line, (here, there)) in made.lines().zip(there.lines()).enumerate() {
        assert_eq!(there, here, "line {} after the mark; UPDATE_BOOK=1 rewrites the page", line + 1);
    }
    assert_eq!(made.lines().count(), there.lines().count());
}
