//! `cargo xtask schema`: the JSON Schema of the case files, so that an editor completes and checks
//! them.

use crate::calculations::{self, Calculation};
use crate::cases::case::{Case, From};
use crate::cases::index::Index;
use crate::project_root;
use clap::Args;
use schemars::generate::SchemaSettings;
use schemars::{JsonSchema, Schema};
use serde_json::{Map, Value, json};
use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::ExitCode;

/// Write the JSON Schemas of case and index files, for editors.
#[derive(Debug, Args)]
#[command(after_help = "Example:\n  cargo xtask schema\n\nA case file names it in its first line:\n  \
    # yaml-language-server: $schema=../case.schema.json")]
pub struct Arguments {}

/// Runs the command.
///
/// # Errors
/// A message where a file cannot be written.
pub fn run(_: &Arguments) -> Result<ExitCode, String> {
    let folder = project_root().join("spec-cases");
    for (name, schema) in [("case.schema.json", case_schema()), ("index.schema.json", index_schema())] {
        let path = folder.join(name);
        let mut text = serde_json::to_string_pretty(&schema).map_err(|error| error.to_string())?;
        text.push('\n');
        if !fs::read_to_string(&path).is_ok_and(|written| written == text) {
            write_whole(&path, &text).map_err(|error| format!("{}: {error}", path.display()))?;
            println!("wrote spec-cases/{name}");
        }
    }
    Ok(ExitCode::SUCCESS)
}

/// Writes a file whole or not at all.
///
/// # Errors
/// Errors of the file system.
pub fn write_whole(path: &Path, text: &str) -> std::io::Result<()> {
    let folder = path.parent().unwrap_or(Path::new("."));
    fs::create_dir_all(folder)?;
    let mut file = tempfile::NamedTempFile::new_in(folder)?;
    file.write_all(text.as_bytes())?;
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        file.as_file().set_permissions(fs::Permissions::from_mode(0o644))?;
    }
    file.persist(path).map_err(|error| error.error)?;
    Ok(())
}

/// Schema of an index file.
#[must_use]
pub fn index_schema() -> Value {
    whole::<Index>().to_value()
}

/// Schema of a case: the calculation decides what `given` holds.
#[must_use]
pub fn case_schema() -> Value {
    let mut schema = whole::<Case>().to_value();
    let calculations = calculations::all();
    let names: Vec<Value> = calculations
        .iter()
        .map(|calculation| json!({ "const": calculation.name, "description": calculation.about }))
        .collect();
    schema["properties"]["calculation"]["oneOf"] = Value::Array(names);
    schema["allOf"] = calculations.iter().map(given_of).collect();
    schema["$defs"] = json!({ "from": whole::<From>().to_value() });
    schema
}

/// Schema without references to itself, so that it can be placed anywhere in another.
fn whole<T: JsonSchema>() -> Schema {
    let settings = SchemaSettings::draft2020_12().with(|settings| settings.inline_subschemas = true);
    settings.into_generator().into_root_schema_for::<T>()
}

fn given_of(calculation: &Calculation) -> Value {
    let mut given = (calculation.schema)().to_value();
    linkable(&mut given);
    json!({
        "if": { "properties": { "calculation": { "const": calculation.name } } },
        "then": { "properties": { "given": given } },
    })
}

/// Lets every value within a `given` be taken from another case instead.
fn linkable(schema: &mut Value) {
    let Some(object) = schema.as_object_mut() else { return };
    if let Some(properties) = object.get_mut("properties").and_then(Value::as_object_mut) {
        properties.values_mut().for_each(wrap);
    }
    for key in ["items", "additionalProperties"] {
        if let Some(inner) = object.get_mut(key).filter(|inner| inner.is_object()) {
            wrap(inner);
        }
    }
    if let Some(choices) = object.get_mut("anyOf").and_then(Value::as_array_mut) {
        choices.iter_mut().for_each(linkable);
    }
}

fn wrap(schema: &mut Value) {
    linkable(schema);
    let description = schema.get("description").cloned();
    let mut either = Map::new();
    if let Some(description) = description {
        either.insert("description".into(), description);
    }
    either.insert("anyOf".into(), json!([schema.take(), { "$ref": "#/$defs/from" }]));
    *schema = Value::Object(either);
}
