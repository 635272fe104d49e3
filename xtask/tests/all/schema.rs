//! The schema of the case files against the cases themselves.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]

use boon::{Compiler, SchemaIndex, Schemas};
use epicyclic_formats::Document;
use serde_json::Value;
use std::fs;
use xtask::schema::{case_schema, index_schema};

/// Every document of the project's cases and indices, as JSON.
fn documents() -> Vec<(String, bool, Value)> {
    let mut documents = Vec::new();
    for source in fs::read_dir(xtask::project_root().join("spec-cases")).unwrap() {
        let source = source.unwrap().path();
        if !source.is_dir() {
            continue;
        }
        for file in fs::read_dir(&source).unwrap() {
            let file = file.unwrap().path();
            if file.extension().is_some_and(|extension| extension == "yaml") {
                let name = file.display().to_string();
                for document in Document::parse_all(&name, &fs::read(&file).unwrap()).unwrap() {
                    let json = serde_json::to_value(document.value()).unwrap();
                    documents.push((name.clone(), file.ends_with("index.yaml"), json));
                }
            }
        }
    }
    documents
}

fn compiled(schema: Value) -> (Schemas, SchemaIndex) {
    let (mut schemas, mut compiler) = (Schemas::new(), Compiler::new());
    compiler.add_resource("schema.json", schema).unwrap();
    let index = compiler.compile("schema.json", &mut schemas).unwrap();
    (schemas, index)
}

#[test]
fn every_case_meets_the_schema() {
    let (cases, indices) = (compiled(case_schema()), compiled(index_schema()));
    for (name, is_index, json) in documents() {
        let (schemas, index) = if is_index { &indices } else { &cases };
        // Cases of bad input are bad by the schema too, where it can tell.
        if json.get("expect_error").is_none() {
            let validated = schemas.validate(&json, *index);
            assert!(validated.is_ok(), "{name}: {}: {}", json["case"], validated.unwrap_err());
        }
    }
}

#[test]
fn what_the_reader_refuses_the_schema_refuses() {
    let (schemas, index) = compiled(case_schema());
    let case = |given: &str| {
        let yaml = format!(
            "case: shaft\ncite: here\ncalculation: gears.shaft\ngiven: {given}\n\
             expect: {{ diameter: {{ published: \"51 mm\" }} }}\n"
        );
        let document = Document::parse_one("case.yaml", yaml.as_bytes()).unwrap();
        schemas.validate(&serde_json::to_value(document.value()).unwrap(), index).is_ok()
    };
    assert!(case("{ torque: 521.8 N·m, allowable_stress: 20 MPa }"));
    assert!(case("{ torque: { from: loads/sun_torque, as: exact }, allowable_stress: 20 MPa }"));
    assert!(!case("{ torqe: 521.8 N·m, allowable_stress: 20 MPa }"));
    assert!(!case("{ torque: 521.8, allowable_stress: 20 MPa }"));
    assert!(!case("{ torque: \"521,8 N·m\", allowable_stress: 20 MPa }"));
    assert!(!case("{ torque: 521.8 N·m }"));
    assert!(!case("{ torque: { from: loads/sun_torque }, allowable_stress: 20 MPa }"));
}
