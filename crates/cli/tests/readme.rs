//! The README's examples print what it shows.

use std::path::Path;
use std::process::Command;

const PROMPT: &str = "$ cargo run -q -p epicyclic -- ";

#[test]
fn the_readmes_commands_print_what_it_shows() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2).unwrap();
    let readme = std::fs::read_to_string(root.join("README.md")).unwrap();
    let mut run = 0;
    for block in readme.split("```console\n").skip(1).map(|rest| rest.split("```").next().unwrap()) {
        let Some((command, shown)) = block.strip_prefix(PROMPT).and_then(|block| block.split_once('\n'))
        else {
            continue;
        };
        let output = Command::new(env!("CARGO_BIN_EXE_epicyclic"))
            .args(command.split_whitespace())
            .current_dir(root)
            .output()
            .unwrap();
        let printed = String::from_utf8(output.stdout).unwrap();
        // A line of dots stands for what is left out before it.
        let holds = match shown.strip_prefix("…\n") {
            Some(end) => printed.ends_with(end),
            None => printed == shown,
        };
        assert!(holds, "{command}\n{printed}");
        run += 1;
    }
    assert!(run >= 2);
}
