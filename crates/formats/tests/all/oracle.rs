//! Every YAML file of the repository, and texts with each form of scalar, have the values that `serde_yaml`
//! reads.

#![allow(clippy::unwrap_used, reason = "tests")]

use epicyclic_formats::Document;
use serde::Deserialize;
use serde_yaml::Value;
use std::path::{Path, PathBuf};

fn both(name: &str, text: &str) -> (Result<Vec<Value>, String>, Result<Vec<Value>, String>) {
    let documents = Document::parse_all(name, text.as_bytes()).map_err(|error| error.to_string());
    let ours = documents.map(|documents| documents.iter().map(|document| document.value().clone()).collect());
    let theirs = serde_yaml::Deserializer::from_str(text).map(Value::deserialize).collect::<Result<_, _>>();
    (ours, theirs.map_err(|error| error.to_string()))
}

fn files(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap().map(Result::unwrap) {
        let (path, name) = (entry.path(), entry.file_name());
        if entry.file_type().unwrap().is_dir() {
            if !["target", "node_modules", ".git"].iter().any(|other| name == *other) {
                files(&path, found);
            }
        } else if path.extension().is_some_and(|ending| ending == "yaml" || ending == "yml") {
            found.push(path);
        }
    }
}

#[test]
fn every_file_of_the_repository_has_equal_values() {
    let mut found = vec![];
    files(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../.."), &mut found);
    let mut equal = 0;
    for path in found {
        let Ok(text) = std::fs::read_to_string(&path) else { continue };
        let (Ok(ours), Ok(theirs)) = both("file.yaml", &text) else { continue };
        assert!(ours == theirs, "{}", path.display());
        equal += 1;
    }
    assert!(equal > 20, "{equal}");
}

#[test]
fn every_form_of_a_scalar_has_an_equal_value() {
    for scalar in [
        "1",
        "-1",
        "+1",
        "0",
        "-0",
        "007",
        "1e3",
        "1E-3",
        "-1.5e+3",
        ".5",
        "5.",
        "1_000",
        "0x10",
        "-0x10",
        "0X10",
        "0o17",
        "0b101",
        "0x-1",
        "1e999",
        "inf",
        "nan",
        "NaN",
        "infinity",
        "~",
        "null",
        "Null",
        "NULL",
        "nUll",
        "true",
        "True",
        "TRUE",
        "tRue",
        "yes",
        "no",
        "on",
        "false",
        "\"1\"",
        "'1.5'",
        "'true'",
        "\"~\"",
        "18446744073709551615",
        "-9223372036854775808",
        "+-1",
        "--1",
        "1 kW",
        "3,94",
        "12..40",
        "1:30",
        "2026-01-01",
        "|\n  one\n  two",
        ">-\n  one\n  two",
        ">\n  one\n\n  two\n",
        "\"a\\tb\\u00e9\"",
        "'it''s'",
        "plain\n  over lines",
        "1.0",
        "100000000000000000000000000000000000000000",
        "[]",
        "{}",
        "[1, [2, a]]",
        "{ a: 1, 'b': ~ }",
        "",
        "-",
        "e5",
        "- 1",
        "-.5",
        "0.0",
        "00",
        "0e0",
        "0x",
        "1e",
        "α",
    ] {
        let (ours, theirs) = both("a.yaml", &format!("a: {scalar}\n"));
        match (&ours, &theirs) {
            (Ok(ours), Ok(theirs)) => assert_eq!(ours, theirs, "{scalar:?}"),
            (ours, theirs) => assert!(ours.is_err() && theirs.is_err(), "{scalar:?}: {ours:?} {theirs:?}"),
        }
    }
}

/// Refused here by name, though YAML allows it.
#[test]
fn anchors_and_numbers_that_are_not_finite_are_refused() {
    for (text, name) in [
        ("a: &x 1\n", "anchor"),
        ("a: &x 1\nb: *x\n", "anchor"),
        ("a: .inf\n", "not-finite"),
        ("a: -.INF\n", "not-finite"),
        ("a: .nan\n", "not-finite"),
        ("a: 18446744073709551616\n", "syntax"),
    ] {
        assert_eq!(Document::parse_all("a.yaml", text.as_bytes()).unwrap_err().name(), name, "{text}");
    }
}
