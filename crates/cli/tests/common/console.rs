//! Console blocks of documents: a command, and what it prints.

use super::{program, text};
use std::path::{Path, PathBuf};

pub(crate) const PROMPT: &str = "$ cargo run -q -p epicyclic -- ";

/// The project's root.
pub(crate) fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2).unwrap().to_owned()
}

/// Runs every block of a document that calls the program, and holds what it prints against what is shown; how many
/// there were.
///
/// A refusal is shown too: where the program ends with an error, what it says of it follows what it printed.
pub(crate) fn check(document: &str) -> usize {
    let mut run = 0;
    for block in document.split("```console\n").skip(1).map(|rest| rest.split("```").next().unwrap()) {
        let Some((command, shown)) = block.strip_prefix(PROMPT).and_then(|block| block.split_once('\n'))
        else {
            continue;
        };
        let words = words(command);
        let words: Vec<&str> = words.iter().map(String::as_str).collect();
        let output = program(&root(), &words).output().unwrap();
        let mut printed = text(&output.stdout);
        if !output.status.success() {
            printed.push_str(&text(&output.stderr));
        }
        assert!(holds(shown, &printed), "{command}\n{printed}");
        run += 1;
    }
    run
}

/// Whether a text is shown. A line of dots stands for what is left out before it, or after it.
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

/// A command as a shell parts it: at spaces that are not between single quotes.
fn words(command: &str) -> Vec<String> {
    let mut words = vec![];
    for (place, part) in command.split('\'').enumerate() {
        if place % 2 == 1 {
            words.push(part.to_owned());
        } else {
            words.extend(part.split_whitespace().map(str::to_owned));
        }
    }
    words
}
