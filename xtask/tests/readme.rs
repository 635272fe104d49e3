//! The README's examples print what it shows.

use std::process::Command;

const PROMPT: &str = "$ cargo xtask ";

#[test]
fn the_readmes_commands_print_what_it_shows() {
    let readme = std::fs::read_to_string(xtask::project_root().join("README.md")).unwrap();
    let mut run = 0;
    for block in readme.split("```console\n").skip(1).map(|rest| rest.split("```").next().unwrap()) {
        let Some((command, shown)) = block.strip_prefix(PROMPT).and_then(|block| block.split_once('\n'))
        else {
            continue;
        };
        if command.contains('#') {
            continue;
        }
        let output =
            Command::new(env!("CARGO_BIN_EXE_xtask")).args(command.split_whitespace()).output().unwrap();
        let printed = String::from_utf8(output.stdout).unwrap();
        assert_eq!(printed, shown, "{command}");
        run += 1;
    }
    assert!(run >= 1);
}
