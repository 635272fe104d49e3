//! The machines that cases describe are the gearboxes of the examples that their notes name.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]

use epicyclic_formats::Document;
use epicyclic_formats::yaml::Value;
use std::fs;

const CASES: &str = "spec-cases/multispeed-gearboxes/05-machines-with-planetary-gears.yaml";

fn documents(file: &str) -> Vec<Document> {
    Document::parse_all(file, &fs::read(xtask::project_root().join(file)).unwrap()).unwrap()
}

/// The example that a case's note names.
fn example(case: &Value) -> Option<String> {
    let note = case.get("note")?.as_str()?.strip_prefix('`')?;
    Some(note.split('`').next()?.to_owned())
}

#[test]
fn every_machine_of_a_case_is_that_of_its_example() {
    let mut compared = vec![];
    for case in documents(CASES) {
        let case = case.value();
        let Some(name) = example(case) else { continue };
        let gearbox = case.get("given").and_then(|given| given.get("gearbox")).unwrap();
        assert_eq!(gearbox, documents(&name)[0].value(), "{name}");
        compared.push(name);
    }
    compared.dedup();
    assert_eq!(compared.len(), 9, "{compared:?}");
}
