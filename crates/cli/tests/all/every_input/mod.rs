//! Every key of a file and every option of a command changes the answer.
//!
//! The keys are those of the schemas, the options those of the help, so that no new one can be forgotten
//! here.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use crate::common;
mod keys;
mod options;

use common::{here, output};
use serde_json::Value;
use std::collections::BTreeSet;

/// Paths of the values that a schema allows.
fn leaves(root: &Value, schema: &Value, at: &str, into: &mut BTreeSet<String>) {
    if let Some(name) = schema.get("$ref").and_then(Value::as_str) {
        let name = name.rsplit('/').next().unwrap();
        return leaves(root, &root["$defs"][name], at, into);
    }
    if let Some(any) = schema.get("anyOf").and_then(Value::as_array) {
        for one in any.iter().filter(|one| one.get("type") != Some(&Value::from("null"))) {
            leaves(root, one, at, into);
        }
        return;
    }
    let below = |key: &str| schema.get(key).filter(|below| below.is_object());
    match schema.get("properties").and_then(Value::as_object) {
        Some(properties) => {
            for (name, schema) in properties {
                let at = if at.is_empty() { name.clone() } else { format!("{at}.{name}") };
                leaves(root, schema, &at, into);
            }
        }
        // The entries of a list or a map have the path of the list.
        None => match below("items").or_else(|| below("additionalProperties")) {
            Some(held) => leaves(root, held, at, into),
            None => _ = into.insert(at.to_owned()),
        },
    }
}

/// Paths of the schema that the program prints.
fn schema(of: &str) -> BTreeSet<String> {
    let schema = output(here().path(), &["schema", of]);
    let schema: Value = serde_json::from_slice(&schema.stdout).unwrap();
    let mut all = BTreeSet::new();
    leaves(&schema, &schema, "", &mut all);
    all
}
