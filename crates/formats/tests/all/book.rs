//! The book and the examples name every key of every file, and every unit.

use epicyclic_formats::Document;
use epicyclic_formats::drive::{self, DriveFile};
use epicyclic_formats::gearbox::{GearboxFile, TransmissionsFile};
use epicyclic_formats::motor::MotorFile;
use epicyclic_formats::scenario::{self, ScenarioFile};
use epicyclic_units::Dimension;
use epicyclic_units::find_unit;
use schemars::schema_for;
use serde_json::Value;
use std::collections::BTreeSet;
use std::path::Path;

fn text(path: &str) -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    std::fs::read_to_string(root.join(path)).expect("it is part of the project")
}

/// Every key of a schema, and of what is in it.
fn keys(schema: &Value, found: &mut BTreeSet<String>) {
    match schema {
        Value::Object(map) => {
            if let Some(Value::Object(properties)) = map.get("properties") {
                found.extend(properties.keys().cloned());
            }
            map.values().for_each(|value| keys(value, found));
        }
        Value::Array(values) => values.iter().for_each(|value| keys(value, found)),
        _ => {}
    }
}

fn keys_of(schema: &schemars::Schema) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    keys(schema.as_value(), &mut found);
    found
}

#[test]
fn the_example_of_a_drive_has_every_key() {
    let (name, found) = ("examples/every-drive-key.yaml", text("examples/every-drive-key.yaml"));
    for key in keys_of(&schema_for!(DriveFile)) {
        assert!(found.contains(&format!("{key}:")), "{key}");
    }
    let document = Document::parse_one(name, found.as_bytes()).expect("the example is YAML");
    drive::read(&document).expect("the example reads");
}

#[test]
fn the_example_of_a_gearbox_has_every_key() {
    let (name, found) = ("examples/every-gearbox-key.yaml", text("examples/every-gearbox-key.yaml"));
    for key in keys_of(&schema_for!(GearboxFile)) {
        assert!(found.contains(&format!("{key}:")), "{key}");
    }
    let document = Document::parse_one(name, found.as_bytes()).expect("the example is YAML");
    let file: GearboxFile = document.read().expect("the example reads");
    let gearbox = file.gearbox().expect("it is a gearbox");
    for gear in gearbox.gears() {
        let found = gearbox.analyze(gear.name()).expect("it is analysed");
        assert!(found.ratio().is_some() || gear.name() == "curve", "{}", gear.name());
    }
}

#[test]
fn the_example_of_a_scenario_has_every_key_and_stands_in_the_book() {
    let (name, found) = ("examples/every-scenario-key.yaml", text("examples/every-scenario-key.yaml"));
    let gearbox = keys_of(&schema_for!(GearboxFile));
    // These stand in the place of others.
    let instead = ["gearbox_file", "transmission", "csv"];
    for key in keys_of(&schema_for!(ScenarioFile)) {
        let is_own = !gearbox.contains(&key) && !instead.contains(&key.as_str());
        assert!(!is_own || found.contains(&format!("{key}:")), "{key}");
    }
    let document = Document::parse_one(name, found.as_bytes()).expect("the example is YAML");
    scenario::read(&document).expect("the example reads");
    assert!(text("docs/src/reference/files.md").contains(&found));
}

#[test]
fn the_book_names_every_key() {
    let chapter = text("docs/src/reference/files.md");
    let mut all = keys_of(&schema_for!(DriveFile));
    all.extend(keys_of(&schema_for!(GearboxFile)));
    all.extend(keys_of(&schema_for!(TransmissionsFile)));
    all.extend(keys_of(&schema_for!(MotorFile)));
    all.extend(keys_of(&schema_for!(ScenarioFile)));
    for key in all {
        let named = [format!("{key}:"), format!("`{key}`")].iter().any(|text| chapter.contains(text));
        assert!(named, "{key}");
    }
}

#[test]
fn the_book_names_every_unit_and_no_other() {
    let chapter = text("docs/src/reference/units.md");
    for dimension in Dimension::ALL {
        let row = chapter
            .lines()
            .find_map(|line| line.strip_prefix(&format!("| {dimension} |")))
            .unwrap_or_else(|| panic!("{dimension}"));
        let shown: BTreeSet<&str> = row.split('`').skip(1).step_by(2).collect();
        for text in &shown {
            assert!(find_unit(text).is_some_and(|unit| unit.dimension == dimension), "{text}");
        }
        // What differs from the symbol in superscripts alone is said once for all units.
        let plain = |symbol: &str| symbol.replace('²', "2").replace('³', "3").replace('µ', "u");
        for unit in dimension.units() {
            assert!(shown.contains(unit.symbol), "{}", unit.symbol);
            for spelling in unit.spellings() {
                assert!(shown.contains(spelling) || plain(unit.symbol) == *spelling, "{spelling}");
            }
        }
    }
}
