//! The book: its commands print what it shows, its files and links are there, its quotations are those of the
//! files.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use crate::common;

use common::console::{self, root};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// Collects the files of a folder and its subfolders.
fn files(folder: &Path, found: &mut Vec<PathBuf>) {
    let mut entries: Vec<PathBuf> =
        fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    entries.sort();
    for path in entries {
        if path.is_dir() {
            files(&path, found);
        } else {
            found.push(path);
        }
    }
}

/// The chapters, each with its text.
fn chapters() -> Vec<(PathBuf, String)> {
    let mut found = vec![];
    files(&root().join("docs/src"), &mut found);
    found.retain(|path| path.extension().is_some_and(|extension| extension == "md"));
    found.into_iter().map(|path| (path.clone(), fs::read_to_string(path).unwrap())).collect()
}

/// With `UPDATE_BOOK=1` the blocks are rewritten as the program prints them now; look at the difference.
#[test]
fn the_commands_print_what_the_book_shows() {
    if std::env::var_os("UPDATE_BOOK").is_some() {
        for (path, chapter) in chapters() {
            let updated = console::updated(&chapter);
            if updated != chapter {
                fs::write(path, updated).unwrap();
            }
        }
    }
    let run: usize = chapters().iter().map(|(_, chapter)| console::check(chapter)).sum();
    assert!(run >= 120, "{run}");
}

/// Commands of `cargo xtask` are run by its own tests.
#[test]
fn every_command_of_the_book_is_run_by_a_test() {
    for (path, chapter) in chapters() {
        for block in fenced(&chapter, "```console\n") {
            let run = [console::PROMPT, "$ cargo xtask "].iter().any(|prompt| block.starts_with(prompt));
            assert!(run && block.matches("$ cargo").count() == 1, "{}:\n{block}", path.display());
        }
    }
}

/// Contents of the blocks between fences that begin with this text.
fn fenced<'a>(text: &'a str, fence: &'static str) -> impl Iterator<Item = &'a str> {
    text.split(fence).skip(1).map(|rest| rest.split("```").next().unwrap())
}

/// Text without its fenced blocks.
fn prose(text: &str) -> String {
    text.split("```").step_by(2).collect()
}

#[test]
fn yaml_in_the_book_stands_in_files_that_are_read() {
    let mut paths = vec![];
    for folder in ["examples", "spec-cases"] {
        files(&root().join(folder), &mut paths);
    }
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "yaml"));
    let texts: Vec<String> = paths.iter().map(|path| fs::read_to_string(path).unwrap()).collect();
    for (path, chapter) in chapters() {
        for block in fenced(&chapter, "```yaml\n") {
            assert!(texts.iter().any(|text| text.contains(block)), "{}:\n{block}", path.display());
        }
    }
}

/// Targets of the links in a text.
fn links(text: &str) -> Vec<String> {
    let prose = prose(text);
    prose.split("](").skip(1).map(|rest| rest.split(')').next().unwrap().to_owned()).collect()
}

/// The anchor that a heading gets.
fn anchor(heading: &str) -> String {
    let kept = |c: &char| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_');
    heading.to_lowercase().chars().filter(kept).map(|c| if c == ' ' { '-' } else { c }).collect()
}

#[test]
fn every_link_leads_somewhere() {
    for (path, chapter) in chapters() {
        for link in links(&chapter).iter().filter(|link| !link.contains("://")) {
            let (file, place) = link.split_once('#').unwrap_or((link, ""));
            let target = if file.is_empty() { path.clone() } else { path.parent().unwrap().join(file) };
            let text = fs::read_to_string(&target).unwrap_or_else(|_| panic!("{}: {link}", path.display()));
            let found = place.is_empty()
                || prose(&text)
                    .lines()
                    .filter_map(|line| line.trim_start_matches('#').strip_prefix(' '))
                    .any(|heading| anchor(heading) == place);
            assert!(found, "{}: {link}", path.display());
        }
    }
}

#[test]
fn the_contents_list_every_chapter_once() {
    let folder = root().join("docs/src");
    let contents = fs::read_to_string(folder.join("SUMMARY.md")).unwrap();
    let listed = links(&contents);
    let names: BTreeSet<&String> = listed.iter().collect();
    assert_eq!(names.len(), listed.len());
    for (path, _) in chapters() {
        let name = path.strip_prefix(&folder).unwrap().to_string_lossy().into_owned();
        assert!(name == "SUMMARY.md" || names.contains(&name), "{name} is not in SUMMARY.md");
    }
}

#[test]
fn every_file_that_the_book_names_is_there() {
    let folders = ["crates/", "examples/", "spec-cases/", "xtask/", "docs/"];
    let mut named = 0;
    for (path, chapter) in chapters() {
        for code in prose(&chapter).split('`').skip(1).step_by(2) {
            if folders.iter().any(|folder| code.starts_with(folder)) && !code.contains('<') {
                assert!(root().join(code).exists(), "{}: {code}", path.display());
                named += 1;
            }
        }
    }
    assert!(named >= 40, "{named}");
}
