//! The README's examples print what it shows.

use std::path::Path;
use std::process::Command;

const PROMPT: &str = "$ cargo run -q -p epicyclic -- ";

#[test]
fn the_readmes_commands_print_what_it_shows() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2).unwrap();
    let readme = std::fs::read_to_string(root.join("README.md")).unwrap();
    // Elsewhere, so that what commands write is not left in the tree.
    let folder = tempfile::tempdir().unwrap();
    let examples = folder.path().join("examples");
    std::fs::create_dir(&examples).unwrap();
    for file in std::fs::read_dir(root.join("examples")).unwrap().map(Result::unwrap) {
        std::fs::copy(file.path(), examples.join(file.file_name())).unwrap();
    }
    let mut run = 0;
    for block in readme.split("```console\n").skip(1).map(|rest| rest.split("```").next().unwrap()) {
        let Some((command, shown)) = block.strip_prefix(PROMPT).and_then(|block| block.split_once('\n'))
        else {
            continue;
        };
        let output = Command::new(env!("CARGO_BIN_EXE_epicyclic"))
            .args(words(command))
            .current_dir(folder.path())
            .output()
            .unwrap();
        let printed = String::from_utf8(output.stdout).unwrap();
        // A line of dots stands for what is left out before it, or after it.
        let (from, to) = (shown.starts_with("…\n"), shown.ends_with("\n…\n"));
        let kept = shown.trim_start_matches("…\n").trim_end_matches("…\n");
        let holds = match (from, to) {
            (true, true) => printed.contains(kept),
            (true, false) => printed.ends_with(kept),
            (false, true) => printed.starts_with(kept),
            (false, false) => printed == kept,
        };
        assert!(holds, "{command}\n{printed}");
        run += 1;
    }
    assert!(run >= 6, "{run}");
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
