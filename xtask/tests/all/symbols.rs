//! The table of symbols: it has each symbol of the theory, at the place of its first use, and no other.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use xtask::book::{formulas, symbols};

/// The table whose symbols mean the same in every chapter.
const COMMON: &str = "In all chapters";

fn read(path: &str) -> String {
    fs::read_to_string(xtask::project_root().join("docs/src").join(path)).unwrap()
}

/// The chapters of the theory in the book's order.
fn chapters() -> Vec<String> {
    let summary = read("SUMMARY.md");
    let links = summary.split("](").skip(1).map(|rest| rest.split(')').next().unwrap());
    links.filter(|path| path.starts_with("theory/")).map(str::to_owned).collect()
}

/// The id that mdBook gives a heading.
fn id(heading: &str) -> String {
    let kept = heading.chars().filter(|letter| letter.is_alphanumeric() || matches!(letter, ' ' | '-' | '_'));
    kept.collect::<String>().to_lowercase().replace(' ', "-")
}

/// Section of a chapter that contains a byte, in the form of a link.
fn section(path: &str, markdown: &str, at: usize) -> String {
    let heading = markdown[..at].lines().rev().find_map(|line| line.strip_prefix("## "));
    heading.map_or_else(|| path.to_owned(), |heading| format!("{path}#{}", id(heading)))
}

/// Every symbol of a chapter, with the section of its first use.
fn used(path: &str) -> BTreeMap<String, String> {
    let markdown = read(path);
    let mut used = BTreeMap::new();
    for formula in formulas::of(&markdown) {
        for symbol in symbols::of(&formula.latex) {
            used.entry(symbol).or_insert_with(|| section(path, &markdown, formula.range.start));
        }
    }
    used
}

/// The tables by their headings: symbol and the link of its first use.
fn tables() -> BTreeMap<String, BTreeMap<String, String>> {
    let mut tables: BTreeMap<String, BTreeMap<String, String>> = BTreeMap::new();
    let mut heading = String::new();
    for line in read("symbols.md").lines() {
        if let Some(next) = line.strip_prefix("## ") {
            heading = next.trim_start_matches('[').split("](").next().unwrap().to_owned();
        }
        let cells: Vec<&str> = line.split(" | ").collect();
        let [symbol, meaning, _unit, link] = cells.as_slice() else { continue };
        if !symbol.starts_with("| $") {
            continue;
        }
        assert!(!meaning.trim().is_empty(), "{line}");
        let link = link.split("](").nth(1).unwrap().split(')').next().unwrap();
        for formula in formulas::of(symbol) {
            for symbol in symbols::of(&formula.latex) {
                let before =
                    tables.entry(heading.clone()).or_default().insert(symbol.clone(), link.to_owned());
                assert!(before.is_none(), "{symbol} stands twice under {heading}");
            }
        }
    }
    tables
}

fn title(path: &str) -> String {
    read(path).lines().next().unwrap().trim_start_matches("# ").to_owned()
}

#[test]
fn each_symbol_of_the_theory_is_in_the_table_where_it_is_first_used() {
    let mut tables = tables();
    let mut common = tables.remove(COMMON).unwrap_or_default();
    let known: BTreeSet<String> = common.keys().cloned().collect();
    let mut faults = Vec::new();
    for path in chapters() {
        let title = title(&path);
        let mut own = tables.remove(&title).unwrap_or_default();
        for (symbol, place) in used(&path) {
            let listed = own.remove(&symbol).or_else(|| common.remove(&symbol));
            match listed {
                Some(link) if link == place => {}
                Some(link) => {
                    faults.push(format!("{title}: {symbol} is first used in {place}, not in {link}"));
                }
                None if known.contains(&symbol) => {}
                None => faults.push(format!("{title}: {symbol}, first used in {place}, is in no table")),
            }
        }
        faults
            .extend(own.keys().map(|symbol| format!("{title}: {symbol} is in the table and in no formula")));
    }
    faults.extend(common.keys().map(|symbol| format!("{COMMON}: {symbol} is in no formula")));
    faults.extend(tables.keys().map(|title| format!("{title} is no chapter of the theory")));
    assert!(faults.is_empty(), "\n{}", faults.join("\n"));
}
