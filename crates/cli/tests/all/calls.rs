//! Calls over a desk in memory answer as the program does, byte for byte.

use epicyclic::call;
use epicyclic::desk::captured::Captured;
use epicyclic_commands::desk::Desk;
use epicyclic_commands::desk::memory::Kept;
use epicyclic_commands::desk::memory::Memory;
use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};
use std::process::Command;

fn examples() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples")
}

fn in_memory(words: &[&str], files: BTreeMap<PathBuf, Vec<u8>>) -> (u8, Kept) {
    let desk = Memory::new(files, None);
    let code = call(words, &desk);
    (code, desk.into_kept())
}

fn all_examples() -> BTreeMap<PathBuf, Vec<u8>> {
    let mut files = BTreeMap::new();
    for entry in std::fs::read_dir(examples()).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_file() {
            files.insert(path.file_name().expect("a name").into(), std::fs::read(&path).expect("a text"));
        }
    }
    files
}

/// Commands for a file, by its first key.
fn commands(text: &str) -> &'static [&'static str] {
    let has = |key: &str| text.lines().any(|line| line.starts_with(key));
    if has("scenario:") {
        &["simulate", "report"]
    } else if has("power:") {
        &["drive", "report"]
    } else if has("stator:") || has("rotor:") {
        &["draw", "report"]
    } else if has("vibration:") {
        &["vibrate", "analyze"]
    } else {
        &["analyze", "report", "draw", "sheet", "losses", "strength", "vibrate"]
    }
}

#[test]
fn calls_in_memory_answer_as_the_program_does() {
    let files = all_examples();
    let (mut answered, mut tables) = (0, BTreeMap::<&str, u32>::new());
    for (name, bytes) in &files {
        let name = name.to_str().unwrap();
        if !name.ends_with(".yaml") {
            continue;
        }
        for command in commands(std::str::from_utf8(bytes).unwrap()) {
            for format in [&["--format", "json"][..], &[]] {
                // A desk takes a table as it takes JSON: of each command some are enough.
                let shown = tables.entry(*command).or_default();
                if format.is_empty() && (*command == "report" || *shown == 8) {
                    continue;
                }
                let words = [&[*command, name], format].concat();
                let (code, kept) = in_memory(&words, files.clone());
                let program = Command::new(env!("CARGO_BIN_EXE_epicyclic"))
                    .args(&words)
                    .current_dir(examples())
                    .output()
                    .unwrap();
                assert_eq!(program.status.code(), Some(i32::from(code)), "{words:?}");
                assert!(program.stdout == kept.answer, "{words:?}");
                let told: String = kept.messages.iter().map(|message| format!("{message}\n")).collect();
                assert_eq!(String::from_utf8_lossy(&program.stderr), told, "{words:?}");
                answered += u32::from(code == 0);
                *shown += u32::from(code == 0 && format.is_empty());
            }
        }
    }
    assert!(answered >= 100, "{answered}");
}

#[test]
fn files_are_written_into_memory_and_read_there() {
    let box_of = ["synthesize", "--ratios", "2.56, 1.465", "--save", "box.yaml", "-o", "found.json"];
    let (code, kept) = in_memory(&box_of, BTreeMap::new());
    assert_eq!((code, &kept.written), (0, &vec![PathBuf::from("box.yaml"), "found.json".into()]));
    assert!(kept.answer.is_empty() && kept.files[Path::new("found.json")].starts_with(b"{"));
    let (code, kept) = in_memory(&["analyze", "box.yaml", "--format", "json"], kept.files);
    assert_eq!((code, kept.written), (0, vec![]));
    assert!(String::from_utf8(kept.answer).unwrap().contains("\"ratio\": 2.56"));
}

/// Modules of steps that differ are in the file: its data sheets are of the set that was found.
#[test]
fn saved_sets_with_two_modules_are_read_again() {
    for words in [
        &["teeth", "--kind", "stepped", "--ratio", "20", "--module-ratio", "5/4", "--save", "set.yaml"][..],
        &[
            "teeth",
            "--kind",
            "wolfrom",
            "--ratio",
            "100",
            "--module-ratio",
            "4/3",
            "--ring-offset",
            "-2..2",
            "--tolerance",
            "0.1%",
            "--save",
            "set.yaml",
        ],
    ] {
        let (code, kept) = in_memory(words, BTreeMap::new());
        assert_eq!(code, 0, "{kept:?}");
        let (code, kept) = in_memory(&["sheet", "set.yaml"], kept.files);
        assert_eq!(code, 0, "{kept:?}");
        assert!(String::from_utf8(kept.answer).unwrap().contains("centre distance, mm"));
    }
}

#[test]
fn what_is_refused_is_told_as_the_program_tells_it() {
    let (code, kept) = in_memory(&["analyze", "absent.yaml", "--format", "json"], BTreeMap::new());
    assert_eq!(code, 3);
    assert!(String::from_utf8(kept.answer).unwrap().contains("\"name\": \"cannot-be-read\""));
    assert_eq!(kept.messages, ["error: absent.yaml: cannot be read: there is no file of this name"]);
    let (code, kept) = in_memory(&["analyse"], BTreeMap::new());
    assert!(code == 2 && kept.messages[0].contains("unrecognized subcommand 'analyse'"), "{kept:?}");
    let (code, kept) = in_memory(&["--version"], BTreeMap::new());
    assert!(code == 0 && kept.answer.starts_with(b"epicyclic ") && kept.messages.is_empty());
}

#[test]
fn a_file_that_is_the_input_is_not_written_over() {
    let files = all_examples();
    let words = ["draw", "scheme-ii-3.yaml", "--svg", "scheme-ii-3.yaml"];
    let (code, kept) = in_memory(&words, files.clone());
    assert_eq!((code, kept.files, kept.written), (2, files, vec![]));
}

/// Asks every search to end at once.
struct Ending(Captured);

impl Desk for Ending {
    fn read(&self, file: Option<&Path>, most: u64) -> io::Result<epicyclic_commands::desk::Text> {
        self.0.read(file, most)
    }
    fn exists(&self, file: &Path) -> bool {
        self.0.exists(file)
    }
    fn are_one_file(&self, one: &Path, other: &Path) -> bool {
        self.0.are_one_file(one, other)
    }
    fn write(
        &self,
        files: &[epicyclic_commands::desk::Content],
        streamed: Option<(&Path, &mut epicyclic_commands::desk::Source)>,
    ) -> Result<(), epicyclic_commands::desk::NotWritten> {
        self.0.write(files, streamed)
    }
    fn make_folder(&self, folder: &Path) -> io::Result<()> {
        self.0.make_folder(folder)
    }
    fn remove(&self, file: &Path) -> io::Result<()> {
        self.0.remove(file)
    }
    fn answer(&self, source: &mut epicyclic_commands::desk::Source) -> io::Result<()> {
        self.0.answer(source)
    }
    fn message(&self, text: &str) {
        self.0.message(text);
    }
    fn asked_to_end(&self) -> Option<f64> {
        Some(0.0)
    }
    fn seconds(&self) -> f64 {
        self.0.seconds()
    }
}

#[test]
fn a_search_ends_at_once_where_its_desk_says_so() {
    let words = ["motor", "search", "--displacement", "250 cm3/rev"];
    let desk = Ending(Captured::default());
    assert_eq!(call(words, &desk), epicyclic_commands::failure::INTERRUPTED);
    let told = desk.0.into_told();
    assert!(
        told.answer.is_empty()
            && told.messages == [format!("error: {}", epicyclic_commands::failure::NOTHING_TO_SHOW)]
    );
}
