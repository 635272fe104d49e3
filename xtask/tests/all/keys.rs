//! No key of a schema goes unseen: programs read answers by their keys, and files are written with them.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::path::Path;
use xtask::book::keys::{all_keys, schemas};
use xtask::schema::{case_schema, index_schema};

/// Every key listed in `keys.txt` still exists. A change that removes a key removes it there too and raises
/// the version of the records; `UPDATE_BOOK=1` adds new keys.
#[test]
fn no_key_has_gone() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/keys.txt");
    let listed = std::fs::read_to_string(&file).unwrap_or_default();
    let mut now = schemas().unwrap();
    now.extend([("case".to_owned(), case_schema()), ("index".to_owned(), index_schema())]);
    let now: Vec<(String, BTreeSet<String>)> =
        now.iter().map(|(name, schema)| (name.clone(), all_keys(schema))).collect();
    for line in listed.lines() {
        let (name, keys) = line.split_once(": ").unwrap();
        let own = now.iter().find(|(one, _)| one == name);
        let (_, own) = own.unwrap_or_else(|| panic!("the schema {name} has gone"));
        let gone: Vec<&str> = keys.split(' ').filter(|key| !own.contains(*key)).collect();
        assert!(gone.is_empty(), "keys of {name} have gone: {gone:?}");
    }
    if std::env::var_os("UPDATE_BOOK").is_some() {
        let mut text = String::new();
        for (name, keys) in &now {
            writeln!(text, "{name}: {}", keys.iter().map(String::as_str).collect::<Vec<_>>().join(" "))
                .unwrap();
        }
        std::fs::write(file, text).unwrap();
    }
    assert!(!listed.is_empty(), "keys.txt lists nothing: write it with UPDATE_BOOK=1");
}
