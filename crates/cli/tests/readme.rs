//! The README's examples print what it shows.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

mod common;

use common::console;

#[test]
fn the_readmes_commands_print_what_it_shows() {
    let readme = std::fs::read_to_string(console::root().join("README.md")).unwrap();
    let run = console::check(&readme);
    assert!(run >= 6, "{run}");
}
