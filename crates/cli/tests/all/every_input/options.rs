//! Every option of every command, by the program's own list of them.

use super::common::console::words;
use super::common::{examples, text};
use epicyclic::{Memory, call};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;
use std::time::Instant;

/// Command lines in which options have an effect, each with the options to add below it. An added option
/// replaces that of the line.
const TRIED: &str = include_str!("options.txt");

/// Options without effect in their place, with the correct form.
const REFUSED: &str = include_str!("options_refused.txt");

/// Bearings of one's own.
const MINE: &str = "designation,rolling,d_mm,D_mm,B_mm,C_kN\nmine,rollers,20,40,15,80\n";

/// A command line, and what is added to it.
struct Line {
    command: &'static str,
    words: Vec<String>,
    added: Vec<Vec<String>>,
}

impl Line {
    /// The command and its words.
    fn new(text: &'static str) -> Self {
        let (command, line) = text.split_once(':').unwrap();
        Self { command, words: words(line), added: vec![] }
    }
}

/// Lines of a table but its comments.
fn lines(table: &'static str) -> impl Iterator<Item = &'static str> {
    table.lines().filter(|line| !line.starts_with('#'))
}

fn tried() -> Vec<Line> {
    let mut all: Vec<Line> = vec![];
    for text in lines(TRIED) {
        match text.strip_prefix("  ") {
            Some(added) => all.last_mut().unwrap().added.push(words(added)),
            None => all.push(Line::new(text)),
        }
    }
    all
}

/// Results of a call: its exit code, its answer, its files.
type Left = (u8, String, BTreeMap<PathBuf, Vec<u8>>);

/// Results of a call and its messages. The call is one in memory, which answers as the program does.
fn left(command: &str, args: &[String]) -> (Left, String) {
    let folder = examples();
    let named = args.iter().filter(|arg| arg.ends_with(".yaml") && folder.join(arg).exists());
    let read = |name: &String| (name.into(), fs::read(folder.join(name)).unwrap());
    let mut files: BTreeMap<PathBuf, Vec<u8>> = named.map(read).collect();
    if args.iter().any(|arg| arg == "mine.csv") {
        files.insert("mine.csv".into(), MINE.into());
    }
    static BEGUN: LazyLock<Instant> = LazyLock::new(Instant::now);
    let desk = Memory::new(files, Some(|| BEGUN.elapsed().as_secs_f64()));
    let code = call(command.split(' ').chain(args.iter().map(String::as_str)), &desk);
    let told = desk.into_kept();
    ((code, text(&told.answer), told.files), told.messages.join("\n"))
}

/// A line with other options in place of its own.
fn with(line: &[String], more: &[String]) -> Vec<String> {
    let mut all = vec![];
    let mut words = line.iter();
    while let Some(word) = words.next() {
        if word.starts_with("--") && more.contains(word) {
            words.next();
        } else {
            all.push(word.clone());
        }
    }
    all.extend_from_slice(more);
    all
}

/// The options of each command, as completions know them.
fn all_options() -> BTreeMap<String, BTreeSet<String>> {
    let (left, _) = left("completions", &words("bash"));
    let lines: Vec<&str> = left.1.lines().map(str::trim).collect();
    let mut all = BTreeMap::new();
    for pair in lines.windows(2) {
        let Some(path) = pair[0].strip_prefix("epicyclic__subcmd__").and_then(|path| path.strip_suffix(')'))
        else {
            continue;
        };
        let Some(opts) = pair[1].strip_prefix("opts=\"") else { continue };
        let options: BTreeSet<String> = opts
            .trim_end_matches('"')
            .split(' ')
            .filter(|word| word.starts_with("--") && !word.starts_with("--help"))
            .map(str::to_owned)
            .collect();
        // A hyphen in a name is written as a level of its own.
        let name = path.replace("chain__subcmd__cutter", "chain-cutter").replace("__subcmd__", " ");
        if !options.is_empty() {
            all.insert(name, options);
        }
    }
    all
}

fn check(commands: &[&str]) {
    let mut faults = vec![];
    for Line { command, words, added } in tried().iter().filter(|line| commands.contains(&line.command)) {
        let before = left(command, words).0;
        for more in added {
            let (after, told) = left(command, &with(words, more));
            // Nothing found is an answer too; `--z1` is a check, and nothing but a refusal shows it; all
            // parts together with `--merge` give the same, and only parts that are not all show it;
            // `--longest` refuses.
            if before == after {
                faults.push(format!("{command} {words:?}: {more:?} changes nothing: {told}"));
            } else if after.0 > 1 && !["--z1", "--merge", "--longest"].contains(&more[0].as_str()) {
                faults.push(format!("{command} {words:?}: {more:?} ends with {}: {told}", after.0));
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn every_option_of_gearboxes_changes_the_answer() {
    check(&[
        "teeth",
        "drive",
        "analyze",
        "strength",
        "sheet",
        "size",
        "losses",
        "simulate",
        "vibrate",
        "compare",
        "schemes",
        "draw",
        "report",
        "init",
        "schema",
        "completions",
        "man",
    ]);
    check(&["synthesize", "atlas"]);
}

#[test]
fn every_option_of_machines_changes_the_answer() {
    check(&["machine list", "machine speeds", "machine chain-cutter", "machine drum", "machine rotor"]);
}

#[test]
fn every_option_of_a_choice_changes_the_answer() {
    check(&["select"]);
}

#[test]
fn every_option_of_a_design_changes_the_answer() {
    check(&["design"]);
}

#[test]
fn every_option_of_motors_changes_the_answer() {
    check(&["motor", "motor search", "motor forms"]);
}

#[test]
fn no_option_is_left_out() {
    let mut all: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for line in tried() {
        let options = line.added.iter().map(|more| more[0].clone());
        all.entry(line.command.to_owned()).or_default().extend(options);
    }
    // It does not end: the tests of the server try them.
    all.insert("serve".to_owned(), ["--app", "--no-browser", "--port"].map(str::to_owned).into());
    assert_eq!(all, all_options());
}

#[test]
fn an_option_that_would_change_nothing_says_what_it_needs() {
    for row in lines(REFUSED) {
        let (line, wanted) = row.split_once(" | ").unwrap();
        let Line { command, words, .. } = Line::new(line);
        let ((code, answer, files), told) = left(command, &words);
        let is_refused = answer.is_empty() || answer.contains("\"answer\": \"error\"");
        assert!(code == 2 && is_refused && told.contains(wanted), "{row}: {code} {told}");
        let is_given = |file: &PathBuf| file == Path::new("mine.csv") || examples().join(file).exists();
        assert!(files.keys().all(is_given), "{row} writes one of {:?}", files.keys());
    }
}
