//! Console blocks of documents: a command, and what it prints.

use super::{program, text};
use std::path::{Path, PathBuf};

pub(crate) const PROMPT: &str = "$ cargo run -q -p epicyclic -- ";
/// Columns that every table fits in.
const WIDTH: usize = 80;

/// The project's root.
pub(crate) fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2).unwrap().to_owned()
}

/// Runs every block of a document that calls the program, one after another in one folder, and compares the
/// output with the text shown. Returns the number of blocks.
pub(crate) fn check(document: &str) -> usize {
    let mut run = 0;
    let folder = bench();
    for (_, command, shown) in blocks(document) {
        let printed = printed(folder.path(), command);
        assert!(holds(shown, &printed), "{command}\n{printed}");
        if !command.contains("--format") && !printed.contains("error: ") {
            for line in printed.lines() {
                assert!(line.chars().count() <= WIDTH, "{command}\n{line}");
            }
        }
        run += 1;
    }
    run
}

/// Document with every block replaced by the present output. If a part is shown, the same number of sections
/// or lines from the same line on is used.
pub(crate) fn updated(document: &str) -> String {
    let mut text = document.to_owned();
    let folder = bench();
    for (block, command, shown) in blocks(document) {
        let printed = printed(folder.path(), command);
        if holds(shown, &printed) {
            continue;
        }
        let (from, to) = (shown.starts_with("…\n"), shown.ends_with("\n…\n"));
        let kept = shown.trim_start_matches("…\n").trim_end_matches("…\n");
        let first = kept.lines().next().unwrap_or_default();
        let lines: Vec<&str> = printed.lines().collect();
        let start = if from { lines.iter().position(|line| *line == first) } else { Some(0) };
        // A block whose first line no longer occurs must be changed by hand.
        let Some(start) = start else { continue };
        let sections = kept.lines().filter(|line| line.is_empty()).count();
        let end_of_sections = || {
            let mut ends = lines.iter().enumerate().skip(start).filter(|(_, line)| line.is_empty());
            ends.nth(sections.checked_sub(1)?).map(|(at, _)| at + 1)
        };
        let end = match to {
            false => lines.len(),
            true if kept.ends_with("\n\n") => end_of_sections().unwrap_or(lines.len()),
            true => lines.len().min(start + kept.lines().count()),
        };
        let shown: String = lines[start..end].iter().map(|line| format!("{line}\n")).collect();
        let (before, after) =
            (if start > 0 { "…\n" } else { "" }, if end < lines.len() { "…\n" } else { "" });
        text = text.replacen(block, &format!("{PROMPT}{command}\n{before}{shown}{after}"), 1);
    }
    text
}

/// Blocks that call the program: the whole, the command, and what is shown.
fn blocks(document: &str) -> impl Iterator<Item = (&str, &str, &str)> {
    let blocks = document.split("```console\n").skip(1).map(|rest| rest.split("```").next().unwrap());
    blocks.filter_map(|block| {
        let (command, shown) = block.strip_prefix(PROMPT)?.split_once('\n')?;
        Some((block, command, shown))
    })
}

/// A folder with the examples alone, so that what commands write is not left in the tree.
fn bench() -> tempfile::TempDir {
    let folder = super::here();
    let examples = folder.path().join("examples");
    std::fs::create_dir(&examples).unwrap();
    for file in std::fs::read_dir(root().join("examples")).unwrap().map(Result::unwrap) {
        std::fs::copy(file.path(), examples.join(file.file_name())).unwrap();
    }
    folder
}

/// Output of a command; if the program ends with an error, its message follows.
fn printed(folder: &Path, command: &str) -> String {
    let words = words(command);
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    let output = program(folder, &words).output().unwrap();
    let mut printed = text(&output.stdout);
    if !output.status.success() {
        printed.push_str(&text(&output.stderr));
    }
    printed
}

/// Whether a text is contained in the output. A line of dots marks a part left out before it, or after it.
fn holds(shown: &str, printed: &str) -> bool {
    let (from, to) = (shown.starts_with("…\n"), shown.ends_with("\n…\n"));
    let kept = shown.trim_start_matches("…\n").trim_end_matches("…\n");
    match (from, to) {
        (true, true) => printed.contains(kept),
        (true, false) => printed.ends_with(kept),
        (false, true) => printed.starts_with(kept),
        (false, false) => printed == kept,
    }
}

/// A command as a shell parts it.
pub(crate) fn words(command: &str) -> Vec<String> {
    shlex::split(command).unwrap()
}
