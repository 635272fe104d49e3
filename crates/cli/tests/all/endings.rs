//! Every long calculation ends soon after a request, at any moment, with a documented exit code, and without
//! half-written files.

#![cfg(unix)]
#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use crate::common;
use crate::streams::in_the_foreground;

use common::{SHAKEN, examples, here, text};
use epicyclic::call;
use epicyclic::desk::captured::Captured;
use epicyclic_commands::desk::{Content, Desk, NotWritten, Source, Text};
use epicyclic_commands::failure::INTERRUPTED;
use std::collections::BTreeSet;
use std::io;
use std::path::Path;
use std::process::{Command, Output, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};
use std::{fs, thread};

/// The program ends within a second; a machine that is busy with other tests takes longer for everything.
const SOON: Duration = Duration::from_secs(6);

/// Moments for each command and signal; `ENDINGS=10` tries more.
fn moments() -> usize {
    std::env::var("ENDINGS").ok().and_then(|count| count.parse().ok()).unwrap_or(1)
}

const WIDE: &str = "--sun 1..5000 --planet 1..5000 --ring 1..9000 --tolerance 0.1%";

/// Every command that computes, with a long input if there is one, and the files that it writes. A word
/// `@name` is a file that is read from the examples.
fn commands() -> Vec<(String, &'static [&'static str])> {
    const ANSWER: &[&str] = &["answer.json"];
    let long = |line: &str| (format!("{line} -o answer.json"), ANSWER);
    vec![
        long(&format!("teeth --ratio 4 {WIDE}")),
        long("teeth --ratio -1.6 --double-planet --sun 1..3000 --ring 1..6000 --planet ..3000 --k 1.1..20"),
        long(
            "teeth --ratio 5 --ring-offset=-3..3 --sun 12..300 --planet 12..300 --ring 12..900 --tolerance 5%",
        ),
        long("select --ratios 1.5,2.5 --teeth --all-structures --tolerance 60% --signs any"),
        long(&format!("select --ratios 3.9 --teeth {WIDE}")),
        long("synthesize --ratios 4.7,3.1 --sets 4 --elements 5 --engaged 3 --longest 9000h"),
        long("synthesize --ratios 4.7,3.1 --sets 5"),
        long("synthesize --ratios 4.7,3.1 --sets 6"),
        long("synthesize --ratios 4.7,3.1 --sets 5 --longest 90000h"),
        long(
            "synthesize --ratios 4.7,3.1,2.1,1.67,1.29,1,0.84,0.67 --sets 4 --elements 5 --engaged 3 --class all-sparse",
        ),
        (
            "synthesize --ratios 4.7,3.1 --sets 5 --elements 4 --engaged 2 --shard 1/900 -o part.parquet"
                .into(),
            &["part.parquet", "part.parquet.progress"],
        ),
        ("atlas -o .".into(), &["structures.parquet", "functions.parquet", "gears.parquet"]),
        long("design --speeds 0.8m/s,3.15m/s --power 75kW --input 1475rpm"),
        long("size @travel-drive-duty.yaml"),
        long("strength @wind-stage.yaml"),
        long("sheet @wind-stage.yaml"),
        long("analyze @real-transmissions.yaml --transmission 8HP"),
        long("losses @drags.yaml --gear slow --speeds 500rpm..3000rpm/200 --torques 10N·m..100N·m/200"),
        long("compare @scheme-ii-3.yaml @simpson.yaml"),
        long("vibrate @vibration.yaml --speeds 10rpm..9000rpm/200"),
        ("draw @real-transmissions.yaml --transmission 8HP -o scheme.svg".into(), &["scheme.svg"]),
        ("report @real-transmissions.yaml --transmission 8HP -o page.html".into(), &["page.html"]),
        ("simulate @shaken.yaml --csv samples.csv -o answer.json".into(), &["samples.csv", "answer.json"]),
        long("simulate @shaken.yaml --sweep torques[motor].harmonic.amplitude=1N·m..30N·m --steps 200"),
        long("motor @motor-5x3.yaml"),
        long("motor search --displacement 250cm3/rev --z3 40..90 --places 200"),
        long("motor forms --torque 600N·m --pressure 20MPa --places 60"),
        long("drive @xe215cll-drive.yaml"),
        long("machine speeds 0.8m/s,3.15m/s"),
        long("schemes"),
    ]
}

/// The words of a command, its files those of a folder.
fn words(folder: &Path, line: &str) -> Vec<String> {
    let file = |name: &str| {
        let beside = folder.join("read");
        fs::create_dir_all(&beside).unwrap();
        let place = beside.join(name);
        match name {
            "shaken.yaml" => fs::write(&place, SHAKEN).unwrap(),
            _ => drop(fs::copy(examples().join(name), &place).unwrap()),
        }
        format!("read/{name}")
    };
    let word = |word: &str| word.strip_prefix('@').map_or_else(|| word.to_owned(), file);
    line.split(' ').map(word).collect()
}

fn files(folder: &Path) -> BTreeSet<String> {
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name());
    entries.map(|name| name.to_string_lossy().into_owned()).filter(|name| name != "read").collect()
}

/// Whether the content of a file is whole, as far as its kind says.
fn is_whole(name: &str, content: &[u8]) -> bool {
    let ends = |end: &[u8]| content.ends_with(end);
    match name.rsplit('.').next() {
        Some("json") => serde_json::from_slice::<serde_json::Value>(content).is_ok(),
        Some("parquet" | "progress") => content.starts_with(b"PAR1") && ends(b"PAR1"),
        Some("svg") => ends(b"</svg>\n") || ends(b"</svg>"),
        Some("html") => ends(b"</html>\n") || ends(b"</html>"),
        _ => ends(b"\n"),
    }
}

fn wait(mut child: std::process::Child, most: Duration) -> Option<Output> {
    let begun = Instant::now();
    while child.try_wait().unwrap().is_none() {
        if begun.elapsed() > most {
            let _ = child.kill();
            let _ = child.wait();
            return None;
        }
        thread::sleep(Duration::from_millis(5));
    }
    Some(child.wait_with_output().unwrap())
}

/// SIGINT and SIGTERM at random moments: the program ends soon, says why, and leaves whole files alone.
#[test]
fn every_command_ends_soon_after_a_signal() {
    let mut random = 0x2545_f491_4f6c_dd1d_u64 ^ u64::from(std::process::id());
    let mut next = || {
        // Xorshift.
        random ^= random << 13;
        random ^= random >> 7;
        random ^= random << 17;
        random
    };
    let (mut ended, mut slowest) = (0, Duration::ZERO);
    for (line, written) in commands() {
        for signal in ["-INT", "-TERM"] {
            for _ in 0..moments() {
                let delay = Duration::from_millis(20 + next() % 600);
                let folder = here();
                let words = words(folder.path(), &line);
                let words: Vec<&str> = words.iter().map(String::as_str).collect();
                let child = in_the_foreground(folder.path(), &words)
                    .stdout(Stdio::piped())
                    .stderr(Stdio::piped())
                    .spawn()
                    .unwrap();
                thread::sleep(delay);
                let asked = Instant::now();
                let _ = Command::new("kill")
                    .args([signal, &child.id().to_string()])
                    .stderr(Stdio::null())
                    .status();
                let done = wait(child, SOON)
                    .unwrap_or_else(|| panic!("{line}: {signal} after {delay:?} did not end it"));
                let (code, told) = (done.status.code(), text(&done.stderr));
                if code == Some(i32::from(INTERRUPTED)) {
                    assert!(told.contains("error: interrupted"), "{line}: {told}");
                    ended += 1;
                    slowest = slowest.max(asked.elapsed());
                    if std::env::var_os("ENDINGS").is_some() {
                        println!(
                            "{:6.0} ms {signal} after {delay:?}: {line}",
                            asked.elapsed().as_secs_f64() * 1e3
                        );
                    }
                } else {
                    // Before the handlers are installed the signal ends the program, and some commands end
                    // before the signal.
                    assert!(
                        matches!(code, Some(0 | 1) | None) || told.contains("--longest"),
                        "{line}: {code:?} {told}"
                    );
                }
                assert!(!told.contains("panicked"), "{line}: {told}");
                let left = files(folder.path());
                for name in &left {
                    assert!(written.contains(&name.as_str()), "{line}: {signal} after {delay:?} left {name}");
                    let content = fs::read(folder.path().join(name)).unwrap();
                    assert!(
                        is_whole(name, &content),
                        "{line}: {signal} after {delay:?}: {name} is not whole"
                    );
                }
                if line.starts_with("atlas") {
                    assert!(matches!(left.len(), 0 | 3), "{left:?}");
                }
            }
        }
    }
    assert!(ended > 10, "{ended} were ended, the slowest after {slowest:?}");
    println!("{ended} were ended, the slowest after {slowest:?}");
}

/// Desk that asks its call to end after a number of queries of the time, and leaves time to print the
/// results.
struct Impatient {
    disk: Captured,
    asked: AtomicUsize,
    after: usize,
    /// How much faster its clock is.
    haste: f64,
}

impl Impatient {
    fn new(after: usize, haste: f64) -> Self {
        Self { disk: Captured::default(), asked: AtomicUsize::new(0), after, haste }
    }
}

impl Desk for Impatient {
    fn read(&self, file: Option<&Path>, most: u64) -> io::Result<Text> {
        self.disk.read(file, most)
    }
    fn exists(&self, file: &Path) -> bool {
        self.disk.exists(file)
    }
    fn are_one_file(&self, one: &Path, other: &Path) -> bool {
        self.disk.are_one_file(one, other)
    }
    fn write(&self, files: &[Content], streamed: Option<(&Path, &mut Source)>) -> Result<(), NotWritten> {
        self.disk.write(files, streamed)
    }
    fn make_folder(&self, folder: &Path) -> io::Result<()> {
        self.disk.make_folder(folder)
    }
    fn remove(&self, file: &Path) -> io::Result<()> {
        self.disk.remove(file)
    }
    fn answer(&self, source: &mut Source) -> io::Result<()> {
        self.disk.answer(source)
    }
    fn message(&self, text: &str) {
        self.disk.message(text);
    }
    fn asked_to_end(&self) -> Option<f64> {
        (self.asked.fetch_add(1, Ordering::Relaxed) >= self.after).then_some(f64::INFINITY)
    }
    fn seconds(&self) -> f64 {
        self.haste * self.disk.seconds()
    }
}

/// A synthesis that is ended at any of its queries has an incomplete answer that says so, or none, but never
/// another.
#[test]
fn a_synthesis_that_is_ended_tells_what_it_found() {
    let words = "synthesize --ratios 3.059,1.625,1,0.696,-2.294 --class all-sparse --sets 2 --elements 5 --engaged 2 --format json";
    let (mut some, mut none) = (0, 0);
    for after in [0, 1, 2, 5, 10, 20, 40, 60, 80, 100, 150, 200] {
        let desk = Impatient::new(after, 1.0);
        let code = call(words.split(' '), &desk);
        let told = desk.disk.into_told();
        let answer: serde_json::Value = serde_json::from_slice(&told.answer).unwrap();
        if code == 0 {
            assert_eq!(answer["complete"], true);
            continue;
        }
        assert_eq!(code, INTERRUPTED, "after {after}: {:?}", told.messages);
        if answer["answer"] == "synthesize" {
            assert_eq!(answer["complete"], false);
            assert!(answer["found"].as_u64().unwrap() > 0);
            some += 1;
        } else {
            assert_eq!(answer["name"], "interrupted", "{answer}");
            none += 1;
        }
    }
    assert!(some > 0 && none > 0, "{some} had found something, {none} nothing");
}

/// The size is printed before anything else, also for classes that take long to count.
#[test]
fn the_size_of_a_large_synthesis_is_told_first() {
    // Counting and sampling take 20 s of the clock.
    for sets in ["5", "6"] {
        let desk = Impatient::new(usize::MAX, 15.0);
        let words =
            ["synthesize", "--ratios", "4.7,3.1", "--elements", "6", "--engaged", "3", "--sets", sets];
        let begun = Instant::now();
        let code = call(words, &desk);
        let told = desk.disk.into_told().messages;
        assert_eq!(code, 2, "{told:?}");
        assert!(told[0].starts_with(&format!("searching core structures of {sets} sets and")), "{told:?}");
        assert!(told[1].contains(": a greater --longest begins it here; or in "), "{told:?}");
        assert!(begun.elapsed() < Duration::from_secs(120), "{:?}", begun.elapsed());
    }
}

/// The limits in the help are those that are kept.
#[test]
fn numbers_beyond_the_limits_of_a_synthesis_are_refused() {
    let run = |words: &[&str]| {
        let desk = Impatient::new(usize::MAX, 1.0);
        let code = call([&["synthesize", "--ratios", "4.7,3.1"][..], words].concat(), &desk);
        (code, desk.disk.into_told())
    };
    let help = text(&run(&["--help-all"]).1.answer).split_whitespace().collect::<Vec<_>>().join(" ");
    for (option, most, begins) in [
        ("--sets", 6, "Number of planet sets, at most"),
        ("--elements", 8, "Number of shift elements, at most"),
        ("--engaged", 4, "Shift elements that a gear engages, at most"),
        ("--links", 11, "Number of moving links: sets, engaged elements and one more; at most"),
    ] {
        assert!(help.contains(&format!("{begins} {most}")), "{option}: {help}");
        for span in [format!("1..{}", most + 1), format!("{}", most + 1), "0".into()] {
            let (code, told) = run(&[option, &span]);
            let why = told.messages.join("\n");
            assert!(code == 2 && why.contains(&format!("error: {option} {span}: allowed is ")), "{why}");
            assert!(why.ends_with(&format!("to {most}")), "{why}");
        }
    }
}
