//! The README's examples print what it shows.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use crate::common;

use common::console;

#[test]
fn the_readmes_commands_print_what_it_shows() {
    let path = console::root().join("README.md");
    let mut readme = std::fs::read_to_string(&path).unwrap();
    // As for the book: look at the difference.
    if std::env::var_os("UPDATE_BOOK").is_some() {
        readme = console::updated(&readme);
        std::fs::write(&path, &readme).unwrap();
    }
    let run = console::check(&readme);
    assert!(run >= 2, "{run}");
}
