//! Where answers go, and what happens where they cannot: pipes, full disks, signals; exit codes.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]
#![cfg(unix)]

use crate::common;

use common::{PROGRAM, SHAKEN, examples, here, output, program, run, text};
use std::fs::{self, File};
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Command, Output, Stdio};
use std::time::Duration;

const LONG: [&str; 7] = ["teeth", "--ratio", "4", "--tolerance", "50%", "--format", "json"];

/// The program with its answer going into a device.
fn into(device: &str, args: &[&str]) -> Output {
    let device = File::options().write(true).open(device).unwrap();
    program(here().path(), args)
        .stdout(device)
        .stderr(Stdio::piped())
        .spawn()
        .unwrap()
        .wait_with_output()
        .unwrap()
}

#[test]
fn a_reader_that_leaves_early_is_told_nothing() {
    for args in [&LONG[..], &["--help"], &["schemes"]] {
        let into_nothing = || {
            let (reader, writer) = std::io::pipe().unwrap();
            drop(reader);
            let folder = here();
            let mut command = program(folder.path(), args);
            command.stdout(writer).stderr(Stdio::piped()).spawn().unwrap().wait_with_output().unwrap()
        };
        // A program that another test starts at this moment holds the reading end too until it runs; the
        // little that a short answer has then goes through.
        let done = (0..20).map(|_| into_nothing()).find(|done| done.status.code() != Some(0)).unwrap();
        assert_eq!((done.status.code(), text(&done.stderr)), (Some(3), String::new()), "{args:?}");
    }
    let mut child =
        program(here().path(), &LONG).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let mut first = String::new();
    BufReader::new(child.stdout.take().unwrap()).read_line(&mut first).unwrap();
    let done = child.wait_with_output().unwrap();
    assert_eq!((first.as_str(), done.status.code(), done.stderr.len()), ("{\n", Some(3), 0));
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_told() {
    for args in
        [&["teeth", "--ratio", "6"][..], &["schemes", "--format", "json"], &["--help"], &["--version"]]
    {
        let done = into("/dev/full", args);
        assert_eq!(done.status.code(), Some(3), "{args:?}");
        assert!(text(&done.stderr).starts_with("error: standard output: No space left"), "{done:?}");
    }
    let done = output(here().path(), &["schemes", "-o", "/dev/full"]);
    assert_eq!(done.status.code(), Some(3));
    assert!(text(&done.stderr).starts_with("error: /dev/full: cannot be written: No space left"), "{done:?}");
}

#[cfg(target_os = "linux")]
#[test]
fn folders_that_take_no_file_are_told() {
    let folder = here();
    fs::create_dir(folder.path().join("folder")).unwrap();
    for (target, why) in
        [("folder", "is a directory"), ("missing/a.txt", "there is no folder missing"), ("/proc/a.txt", "")]
    {
        let done = output(folder.path(), &["schemes", "-o", target]);
        assert_eq!(done.status.code(), Some(3), "{target}");
        let message = text(&done.stderr);
        assert!(message.starts_with(&format!("error: {target}: cannot be written: {why}")), "{message}");
        assert!(!message.contains(".epicyclic-") && message.lines().count() == 1, "{message}");
    }
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
}

/// The program as a shell starts it in the foreground: Ctrl-C ends it, also where these tests are run with
/// the signal ignored, as under `nohup` or in a shell's background job, which a child would inherit.
///
/// No safe call of ours sets it, and a POSIX shell may not: its `trap` leaves alone what was ignored when it
/// started. So a program does that then becomes ours, under the same process number: `env` of coreutils 8.31
/// and later, or `perl`.
pub(crate) fn in_the_foreground(folder: &Path, args: &[&str]) -> Command {
    const ENV: [&str; 2] = ["env", "--default-signal=INT"];
    const PERL: [&str; 4] = ["perl", "-e", "$SIG{INT} = 'DEFAULT'; exec { $ARGV[0] } @ARGV or die", "--"];
    let works = |words: &[&str]| {
        let mut command = Command::new(words[0]);
        command
            .args(&words[1..])
            .arg("true")
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(Stdio::null());
        command.status().is_ok_and(|status| status.success())
    };
    let words = [&ENV[..], &PERL].into_iter().find(|words| works(words)).expect(
        "these tests need `env --default-signal=INT` (coreutils 8.31 or later) or `perl` to start the program with the usual \
         answer to Ctrl-C, and neither is here",
    );
    let mut command = Command::new(words[0]);
    command.args(&words[1..]).arg(PROGRAM).args(args).current_dir(folder);
    command.env_remove("COLUMNS").stdin(Stdio::null());
    command
}

fn interrupt(pid: u32) {
    Command::new("kill").args(["-INT", &pid.to_string()]).status().unwrap();
}

/// Ctrl-C at many moments: the file is the old one or the new one, never a part, and no other file remains.
#[test]
fn ctrl_c_leaves_no_broken_file() {
    let args = [&LONG[..], &["-o", "answer.json"]].concat();
    let whole = text(&output(here().path(), &LONG).stdout);
    let (mut old, mut new) = (0, 0);
    let mut delay = Duration::ZERO;
    for _ in 0..40 {
        let folder = here();
        let answer = folder.path().join("answer.json");
        fs::write(&answer, "old").unwrap();
        let child = in_the_foreground(folder.path(), &args).stderr(Stdio::null()).spawn().unwrap();
        std::thread::sleep(delay);
        interrupt(child.id());
        let done = child.wait_with_output().unwrap();
        let found = fs::read_to_string(&answer).unwrap();
        assert!(found == "old" || found == whole, "{} of {} bytes", found.len(), whole.len());
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1, "{delay:?}");
        if found == "old" {
            old += 1;
            delay += Duration::from_micros(1500);
        } else {
            assert!(matches!(done.status.code(), Some(0 | 130) | None), "{done:?}");
            new += 1;
            // Around the moment of writing.
            delay = delay.saturating_sub(Duration::from_micros(700));
        }
    }
    assert!(old > 0, "{old} old, {new} new");
}

/// Simulation of one hour of a vibrating motor: the first Ctrl-C ends it, and the results up to then are
/// printed.
#[test]
fn ctrl_c_tells_the_motion_up_to_there() {
    let folder = here();
    fs::write(folder.path().join("shaken.yaml"), SHAKEN).unwrap();
    // On a busy machine the program reacts late, and may have no time to print.
    for wait in [100, 300, 1000, 3000, 6000] {
        let child = in_the_foreground(folder.path(), &["simulate", "shaken.yaml", "--csv", "shaken.csv"])
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        std::thread::sleep(Duration::from_millis(wait));
        interrupt(child.id());
        let done = child.wait_with_output().unwrap();
        let (told, refused) = (text(&done.stdout), text(&done.stderr));
        // Before its handlers are installed, the program ends like any other.
        if done.status.code() == Some(130) && !told.is_empty() {
            assert!(told.contains("ended at ") && refused.contains("error: interrupted"), "{told}{refused}");
            assert!(folder.path().join("shaken.csv").exists());
            return;
        }
        assert!(told.is_empty(), "{told}");
    }
    panic!("it never told anything");
}

/// A search is long before it writes, and Ctrl-C ends it at once.
#[test]
fn ctrl_c_ends_a_search() {
    let folder = here();
    let answer = folder.path().join("answer.txt");
    fs::write(&answer, "old").unwrap();
    let search = [
        "select",
        "--ratios",
        "1.5, 2.5",
        "--teeth",
        "--all-structures",
        "--tolerance",
        "60%",
        "--signs",
        "any",
    ];
    let child = in_the_foreground(folder.path(), &[&search[..], &["-o", "answer.txt"]].concat())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    std::thread::sleep(Duration::from_millis(50));
    interrupt(child.id());
    let stopped = child.wait_with_output().unwrap();
    let told = text(&stopped.stderr);
    // Before it hears it ends by the signal.
    assert!(
        !stopped.status.success() && (told.is_empty() || told.contains("error: interrupted: ")),
        "{stopped:?}"
    );
    assert_eq!(fs::read_to_string(&answer).unwrap(), "old");
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
}

/// What the program shows on a terminal until it has shown all of `expected`, then it is ended, or until its
/// end; `None` if there is no `script` to emulate a terminal.
fn on_a_terminal(args: &str, no_color: bool, expected: &[&str]) -> Option<String> {
    let folder = here();
    let log = folder.path().join("log");
    let mut script = Command::new("script");
    script.args(["-qefc", &format!("exec {PROGRAM} {args}")]).arg(&log).current_dir(Path::new("/"));
    script.env("TERM", "xterm").env_remove("NO_COLOR").env_remove("CLICOLOR").stdin(Stdio::null());
    if no_color {
        script.env("NO_COLOR", "1");
    }
    let mut script = script.stdout(Stdio::null()).stderr(Stdio::null()).spawn().ok()?;
    loop {
        let is_over = script.try_wait().unwrap().is_some();
        let seen = String::from_utf8_lossy(&fs::read(&log).unwrap_or_default()).into_owned();
        let is_all = !expected.is_empty() && expected.iter().all(|text| seen.contains(text));
        if is_over || is_all {
            // Without its terminal the program ends, too.
            let _ = script.kill();
            let _ = script.wait();
            return Some(seen);
        }
        std::thread::sleep(Duration::from_millis(10));
    }
}

#[test]
fn colour_and_progress_are_for_terminals() {
    for args in [&["--help-all"][..], &["teeth"], &["schemes"]] {
        let piped = output(here().path(), args);
        assert!(!piped.stdout.contains(&0x1b) && !piped.stderr.contains(&0x1b), "{args:?}");
    }
    let Some(coloured) = on_a_terminal("--help-all", false, &[]) else { return };
    assert!(coloured.contains("\u{1b}["), "{coloured}");
    assert!(!on_a_terminal("--help-all", true, &[]).unwrap().contains("\u{1b}["));
    // Tables are plain everywhere.
    assert!(!on_a_terminal("schemes", false, &[]).unwrap().contains('\u{1b}'));
}

/// Searches, and what each shows of its size and progress.
const LONG_SEARCHES: [(&str, &[&str]); 7] = [
    (
        "select --ratios 1.5\\;2.5 --teeth --all-structures --tolerance 60% --ring ..110 --limit 1",
        &["searching: "],
    ),
    (
        "teeth --ratio 4 --sun 1..2000 --planet 1..2000 --ring 1..4000 --tolerance 9% --k 1.1..20",
        &["searching: ", "sets of tooth numbers found"],
    ),
    (WIDE, &["combinations of sun, planet and number of planets", "searching: "]),
    (
        "teeth --ratio -1.6 --double-planet --sun 1..3000 --ring 1..6000 --planet ..3000 --limit 1 --k 1.1..20",
        &["combinations of sun, ring and pairs of planets"],
    ),
    (
        "select --ratios 3.9 --teeth --sun 1..6000 --planet 1..6000 --ring 1..9000 --tolerance 0.1% --limit 1",
        &[" combinations of sun, planet"],
    ),
    (
        "select --ratios 1.5\\;2.5 --teeth --all-structures --tolerance 60% --limit 1",
        &[" designs: 7943 combinations of tooth numbers a set, "],
    ),
    ("motor search --displacement 250cm3/rev --z3 40..60 --places 80", &[" sets of lobes and teeth, "]),
];

const WIDE: &str = "teeth --ratio 4 --sun 1..6000 --planet 1..6000 --ring 1..9000 --tolerance 0.1% --limit 1";

/// A long search prints its size, then its progress; a short one prints neither, and without a terminal
/// nothing is printed.
#[test]
fn a_long_search_tells_its_size_on_a_terminal() {
    for (search, expected) in LONG_SEARCHES {
        let Some(seen) = on_a_terminal(search, false, expected) else { return };
        let places: Vec<Option<usize>> = expected.iter().map(|text| seen.find(text)).collect();
        assert!(places.iter().all(Option::is_some) && places.is_sorted(), "{search}: {expected:?} in {seen}");
    }
    let short = on_a_terminal("teeth --ratio 6", false, &[]).unwrap();
    assert!(!short.contains("searching"), "{short}");
    let piped = run(here().path(), WIDE);
    assert!(piped.status.success() && piped.stderr.is_empty(), "{piped:?}");
}

/// With more designs than an answer holds, standard output and file are equal, and contain the whole front.
#[test]
fn a_whole_front_is_written_as_it_comes() {
    let folder = here();
    let search = ["select", "--ratios", "1.465, 2.56", "--teeth", "--ring", "..44", "--limit", "1000000"];
    let front = |more: &[&str]| {
        let done = output(folder.path(), &[&search, more].concat());
        assert!(done.status.success() && done.stderr.is_empty(), "{done:?}");
        text(&done.stdout)
    };
    let (csv, json) = (front(&["--format", "csv"]), front(&["--format", "json"]));
    assert!(front(&["--format", "csv", "-o", "front.csv"]).is_empty());
    assert_eq!(fs::read_to_string(folder.path().join("front.csv")).unwrap(), csv);
    let found: serde_json::Value = serde_json::from_str(&json).unwrap();
    let designs = found["designs"].as_array().unwrap();
    assert!(designs.len() > 20 && found["shown"] == designs.len(), "{}", designs.len());
    assert_eq!(csv.lines().count(), designs.len() + 1);
    // The first of them alone are the same.
    let few = "select --ratios '1.465, 2.56' --teeth --ring ..44 --limit 20 --format csv";
    let few = text(&run(folder.path(), few).stdout);
    assert_eq!(few.lines().collect::<Vec<_>>(), csv.lines().take(21).collect::<Vec<_>>());
    // A table is for people.
    let table = output(folder.path(), &search);
    assert!(table.status.code() == Some(2) && text(&table.stderr).contains("at most 10000"), "{table:?}");
}

/// The file that a shell has opened for standard output is written at the position of the stream.
#[cfg(unix)]
#[test]
fn standard_output_by_its_name_keeps_what_stands_in_its_file() {
    let folder = here();
    let script = format!(
        "{{ echo before; '{PROGRAM}' teeth --ratio 6 --limit 1 --format csv -o /dev/stdout; echo after; }} > log.txt"
    );
    let done = Command::new("sh").args(["-c", &script]).current_dir(folder.path()).output().unwrap();
    assert!(done.status.success(), "{done:?}");
    let log = fs::read_to_string(folder.path().join("log.txt")).unwrap();
    let lines: Vec<&str> = log.lines().collect();
    assert!(lines.len() == 4 && lines[0] == "before" && lines[3] == "after", "{log}");
}

#[test]
fn the_end_of_a_name_says_the_format() {
    let folder = here();
    let run = |arguments: &[&str]| output(folder.path(), arguments);
    let read = |name: &str| fs::read_to_string(folder.path().join(name)).unwrap();
    assert!(run(&["teeth", "--ratio", "6", "-o", "a.json"]).status.success());
    assert!(read("a.json").starts_with('{'));
    assert!(run(&["teeth", "--ratio", "6", "-o", "a.csv"]).status.success());
    assert!(read("a.csv").starts_with("sun,"));
    assert!(run(&["teeth", "--ratio", "6", "-o", "a.txt"]).status.success());
    assert!(run(&["teeth", "--ratio", "6", "-o", "b.csv", "--format", "json"]).status.success());
    assert!(read("b.csv").starts_with('{'), "what is said goes before the name");
}

/// A list in CSV has no place for warnings, so they are printed as messages.
#[test]
fn warnings_of_a_list_in_csv_are_told() {
    let file = examples().join("ravigneaux.yaml");
    let done = output(here().path(), &["analyze", file.to_str().unwrap(), "--format", "csv"]);
    assert!(
        done.status.success() && text(&done.stderr).contains("warning: set `set`: the tips of the ring"),
        "{done:?}"
    );
}

/// Without an accepted design nothing is saved; a rejected one is saved only on request, with a note in the
/// file.
#[test]
fn rejected_designs_are_saved_only_on_demand() {
    let folder = here();
    let done = output(folder.path(), &["select", "--ratios", "50", "--save", "none.yaml"]);
    assert_eq!(done.status.code(), Some(1));
    assert!(!folder.path().join("none.yaml").exists());
    let speeds = ["select", "--speeds", "0.76 m/s, 1.33 m/s, 1.95 m/s", "--nth", "3", "--save", "third.yaml"];
    let done = output(folder.path(), &speeds);
    assert!(done.status.success());
    assert!(
        text(&done.stderr).contains("note: design 3 is saved; it does not meet every required criterion"),
        "{done:?}"
    );
    assert!(fs::read_to_string(folder.path().join("third.yaml")).unwrap().contains("# It was rejected"));
}
