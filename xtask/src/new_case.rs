//! `cargo xtask new-case`: a commented starting file for a case.

use crate::calculations::{self, Calculation};
use crate::project_root;
use crate::schema::{self, write_whole};
use clap::Args;
use epicyclic_formats::nearest;
use serde_json::{Map, Value};
use std::fmt::Write;
use std::path::PathBuf;
use std::process::ExitCode;

/// Write a commented starting file for a case of a calculation.
///
/// Without a calculation, lists them.
#[derive(Debug, Args)]
#[command(
    after_help = "Example:\n  cargo xtask new-case gears.shaft --source excavator-dynamics --name winch-shaft"
)]
pub struct Arguments {
    /// Name of the calculation, such as gears.shaft.
    pub calculation: Option<String>,
    /// The source: a folder of spec-cases.
    #[arg(long)]
    pub source: Option<String>,
    /// Name of the case: small letters, digits, hyphens.
    #[arg(long, default_value = "new-case")]
    pub name: String,
    /// Folder of the cases [default: spec-cases].
    #[arg(long, value_name = "FOLDER")]
    pub cases: Option<PathBuf>,
}

/// Runs the command: writes the file, or prints it where no source is named.
///
/// # Errors
/// A message for an unknown calculation, an unknown source, or a file that is there already.
pub fn run(arguments: &Arguments) -> Result<ExitCode, String> {
    let calculations = calculations::all();
    let Some(wanted) = &arguments.calculation else {
        let width = calculations.iter().map(|known| known.name.len()).max().unwrap_or(0);
        for known in &calculations {
            println!("{:width$}  {}", known.name, known.about);
        }
        return Ok(ExitCode::SUCCESS);
    };
    let Some(calculation) = calculations.iter().find(|known| known.name == wanted) else {
        let names: Vec<String> = calculations.iter().map(|known| known.name.to_owned()).collect();
        let like = nearest(wanted, &names).map(|name| format!("; {name}?")).unwrap_or_default();
        return Err(format!("no calculation {wanted}{like} (cargo xtask new-case lists them)"));
    };
    let text = starting_file(calculation, &arguments.name);
    let Some(source) = &arguments.source else {
        print!("{text}");
        return Ok(ExitCode::SUCCESS);
    };
    let folder = arguments.cases.clone().unwrap_or_else(|| project_root().join("spec-cases")).join(source);
    if !folder.is_dir() {
        let folder = folder.display();
        return Err(format!("no source {source}: there is no folder {folder}"));
    }
    let path = folder.join(format!("{}.yaml", arguments.name));
    if path.exists() {
        return Err(format!("{} is there already: choose another --name", path.display()));
    }
    write_whole(&path, &text).map_err(|error| format!("{}: {error}", path.display()))?;
    println!("wrote {}", path.display());
    println!("next: fill it in, then run `cargo xtask verify {}`", arguments.name);
    // The first line of the file names it, for the editor.
    schema::run(&schema::Arguments {})
}

/// The starting file of a case.
#[must_use]
pub fn starting_file(calculation: &Calculation, name: &str) -> String {
    let mut text = String::new();
    let _ = writeln!(text, "# yaml-language-server: $schema=../case.schema.json");
    let _ = writeln!(text, "case: {name}");
    let _ = writeln!(text, "# Places of the source, by the names of its index.yaml, separated by commas.");
    let _ = writeln!(text, "cite: PLACE");
    let _ = writeln!(text, "# {}", calculation.about);
    let _ = writeln!(text, "calculation: {}", calculation.name);
    let _ = writeln!(
        text,
        "# A value may come from another case: {{ from: case/result, as: exact }}, or as: published."
    );
    let schema = (calculation.schema)().to_value();
    if schema["properties"].as_object().is_none_or(Map::is_empty) {
        let _ = writeln!(text, "given: {{}}");
    } else {
        let _ = writeln!(text, "given:");
        properties(&mut text, &schema, 2);
    }
    text.push_str(
        "expect:
  # A line a published figure, by the name of the result; `cargo xtask verify` lists the names.
  RESULT: { published: \"1.23\" }
  # Digits cut off instead of rounded:
  # RESULT: { published: \"1.23\", rounding: truncated }
  # Further off than its digits; beyond ten half-units or 2 % with `cause`, too: constant, rounding or rough:
  # RESULT: { published: \"1.23\", tolerance: \"0.02\", because: the document takes π = 3.14 }
  # A figure that does not follow from the source's own inputs:
  # RESULT:
  #   published: \"1.23\"
  #   verdict: contradicted
  #   computed: \"2.345678\"
  #   arithmetic: 2 + 0.345678
  #   because: how the right value comes about
  # One by a formula that the print lost (the case then says in `restored` how it was inferred):
  # RESULT: { published: \"1.23\", verdict: reconstructed }
  # One that the source sets, and one that the copy lost:
  # RESULT: { published: \"1.23\", verdict: given }
  # RESULT: { verdict: unrecoverable, legible: the last digit }
",
    );
    text
}

/// Lines for the properties of a schema; what is optional is commented out.
fn properties(text: &mut String, schema: &Value, indent: usize) {
    let Some(known) = schema["properties"].as_object() else { return };
    let required: Vec<&str> =
        schema["required"].as_array().into_iter().flatten().filter_map(Value::as_str).collect();
    for (at, (name, property)) in known.iter().enumerate() {
        // Where each is optional one of them is needed: the first stands.
        let stands = required.contains(&name.as_str()) || (required.is_empty() && at == 0);
        let optional = !stands;
        if let Some(description) = property["description"].as_str() {
            for line in description.lines() {
                let _ = writeln!(text, "{:indent$}# {line}", "");
            }
        }
        let property = resolve(schema, property);
        if !optional && property["properties"].is_object() {
            let _ = writeln!(text, "{:indent$}{name}:", "");
            properties(text, property, indent + 2);
        } else {
            let mark = if optional { "# " } else { "" };
            let _ = writeln!(text, "{:indent$}{mark}{name}: {}", "", sample(schema, property));
        }
    }
}

/// The schema behind a reference or an optional value.
fn resolve<'a>(root: &'a Value, schema: &'a Value) -> &'a Value {
    if let Some(name) = schema["$ref"].as_str().and_then(|path| path.rsplit('/').next()) {
        return &root["$defs"][name];
    }
    for key in ["anyOf", "oneOf"] {
        if let Some(choice) = schema[key].as_array().and_then(|choices| choices.first()) {
            return resolve(root, choice);
        }
    }
    schema
}

/// A value of the right kind to start from.
fn sample(root: &Value, schema: &Value) -> String {
    let schema = resolve(root, schema);
    if let Some(example) = schema["examples"].as_array().and_then(|examples| examples.first()) {
        return example.as_str().map_or_else(|| example.to_string(), ToOwned::to_owned);
    }
    if let Some(name) = schema["enum"].as_array().and_then(|names| names.first()).or(schema.get("const")) {
        return name.as_str().unwrap_or_default().to_owned();
    }
    let kind = schema["type"].as_str().or_else(|| schema["type"][0].as_str()).unwrap_or_default();
    match kind {
        "integer" => "20".into(),
        "number" => "1.0".into(),
        "boolean" => "true".into(),
        "string" => "\"…\"".into(),
        "array" => {
            // As many as there must be, of a pair two.
            let least = schema["minItems"].as_u64().unwrap_or(1).max(1) as usize;
            format!("[{}]", vec![sample(root, &schema["items"]); least].join(", "))
        }
        _ => {
            let inner: Vec<String> = schema["properties"]
                .as_object()
                .into_iter()
                .flatten()
                .map(|(name, property)| format!("{name}: {}", sample(root, property)))
                .collect();
            format!("{{ {} }}", inner.join(", "))
        }
    }
}
