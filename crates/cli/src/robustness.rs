//! Random command lines: the program must answer or refuse each of them, and never panic.

use crate::desk::captured::Captured;
use crate::{Cli, call};
use clap::CommandFactory as _;
use proptest::prelude::*;
use proptest::test_runner::TestRunner;
use std::path::{Path, PathBuf};

/// Values of every kind, valid in some places and invalid in others, or invalid everywhere.
const VALUES: [&str; 68] = [
    "6",
    "3.94",
    "-2.6",
    "0",
    "1",
    "8",
    "9",
    "-1",
    "1e308",
    "-1e308",
    "1e-308",
    "1e999",
    "nan",
    "inf",
    "4294967296",
    "99999999999999999999",
    "12..40",
    "17..",
    "..=90",
    "40..12",
    "..",
    "0..",
    "1.3..10",
    "1%",
    "10%",
    "0.5",
    "97 %",
    "1e300 %",
    "75 kW",
    "1e308 kW",
    "-75 kW",
    "1475 rpm",
    "0 rpm",
    "-1e300 rpm",
    "500 N·m",
    "0 N·m",
    "2 MPa",
    "40 cm",
    "1e-300 mm",
    "5 m/min",
    "0.02 rad/s",
    "4 kN",
    "5 kN, 6.5 kN",
    "60 deg",
    "95 deg, 110 deg",
    "90 deg",
    "0.8 m/s, 3.15 m/s",
    "0.76 m/s, 1.33 m/s, 1.95 m/s",
    "1 m/s, 1 m/s, 1 m/s",
    "2.5",
    "1.465, 2.56",
    "-2.56, -1.465",
    "1.0000001, 1e9",
    "size, speed",
    "aH^b",
    "ba^H",
    "any",
    "as-given",
    "\u{202e}",
    "\u{1b}[2J\n\u{9b}31m",
    "1e-300",
    "🦀 kW",
    "]]> & <b a=\"'\">",
    "250 cm3/rev",
    "chambers",
    "speeds",
    "",
    "-",
];

/// Valid values of an option, so that enough command lines are run and not just refused.
fn sensible(option: &str) -> &'static [&'static str] {
    match option {
        "ratio" | "ratio1" | "ratio2" => &["6", "3.94", "-2.6", "2.56", "-1.465"],
        "mode" => &["aH^b", "ab^H", "bH^a", "ba^H", "Ha^b", "Hb^a"],
        "planets" | "planet-count" => &["3", "3..5"],
        "sun" | "planet" => &["12..40", "20"],
        "ring" => &["30..90", "60"],
        "k" | "prefer" => &["1.3..10", "2..4", "2.."],
        "tolerance" => &["1%", "0.2"],
        "speeds" => &["0.8 m/s, 3.15 m/s", "0.76 m/s, 1.33 m/s, 1.95 m/s", "100rpm..900rpm/3"],
        "torques" => &["1 N·m..90 N·m/3", "engine=100 N·m"],
        "ratios" => &["2.5", "1.465, 2.56", "-4, -7"],
        "sets" => &["1", "2", "1..2"],
        "elements" | "engaged" => &["1", "2", "1..3"],
        "order" => &["size", "efficiency, error", "efficiency, drag"],
        "objectives" => &["torque, drag", "shifts"],
        "nth" | "equal-rings" | "equal-suns" | "equal-sets" | "teeth-limit" => &["1", "2"],
        "brakes" | "signs" => &["as-given", "either", "any", "alike"],
        "torque" | "load-torque" => &["500 N·m", "-3 kN·m"],
        "power" => &["75 kW", "-5 kW"],
        "speed" | "input" => &["1475 rpm", "-20 rad/s"],
        "load-factor" => &["2 MPa"],
        "efficiency" | "least-efficiency" => &["0.97", "95 %"],
        "load-sharing" => &["1, 1, 1.1, 1.2, 1.2, 1.3, 1.4"],
        "ring-diameter" => &["300 mm"],
        "least-module" => &["1 mm"],
        "greatest-module" => &["8 mm"],
        "limit" => &["0", "1", "5"],
        "gear" => &["slow", "1", "closed"],
        "transmission" => &["8HP", "TH400", "prius"],
        "format" => &["json", "csv", "table"],
        "k1" | "k2" => &["2.94", "1.5"],
        "boom-radius" | "wheel-radius" | "diameter" | "chip-width" => &["3 m", "20 m"],
        "chip" | "pick-spacing" => &["5 cm"],
        "feed" => &["4 m/min"],
        "slewing" => &["0.02 rad/s"],
        "picks" | "buckets" => &["2", "8"],
        "boom-angle" | "release" => &["60 deg", "70 deg"],
        "chute" => &["95 deg, 110 deg"],
        "radius-ratio" | "discharge" => &["0.6", "0.3"],
        "force" | "other-forces" => &["4 kN"],
        "stator" => &["5"],
        "rotor" => &["3"],
        "z3" => &["55"],
        "z1" => &["33"],
        "zs" => &["10", "9"],
        "module" => &["2 mm"],
        "l" => &["80 mm", "60 mm"],
        "part" => &["0.4", "0.01"],
        "width" => &["50 mm"],
        "pressure" => &["20 MPa"],
        "angle" => &["20 deg", "-1e6 deg"],
        "pressure-angle" => &["20 deg", "25 deg"],
        "addendum" | "clearance" | "shift" | "backlash" | "fillet" => &["0.1", "0.3", "1"],
        "view" => &["centrodes", "teeth", "motor", "chambers", "scheme", "speeds", "levers", "ladder", "map"],
        "points" => &["3"],
        "displacement" => &["250 cm3/rev"],
        "ripple" => &["10 %"],
        "places" => &["4"],
        "resolution" => &["20 %"],
        "design" => &["1", "2"],
        "families" => &["arcs", "cosine, second-harmonic"],
        "crests" => &["space", "tooth, space"],
        "contact-ratio" => &["1.1"],
        "contact-limit" => &["1500 MPa"],
        "root-limit" => &["400 MPa"],
        "youngs-modulus" => &["200 GPa"],
        "poissons-ratio" => &["0.25"],
        "flank-ripple" => &["20 %"],
        "least-torque" => &["80 %"],
        "contact-stress" | "root-stress" => &["2 GPa"],
        "allowed-pressure" => &["5 MPa"],
        "by" => &["ripple", "contact-ratio", "least-torque"],
        _ => &[],
    }
}

fn example(name: &str) -> String {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(name).display().to_string()
}

/// Commands with their required arguments besides options.
fn commands() -> Vec<Vec<String>> {
    let words = |words: &[&str]| words.iter().map(|word| (*word).to_owned()).collect::<Vec<_>>();
    let mut all: Vec<Vec<String>> = [
        &["teeth"][..],
        &["select"],
        &["synthesize"],
        &["schemes"],
        &["schemes", "II-3"],
        &["schemes", "I"],
        &["machine", "list"],
        &["machine", "speeds", "0.76 m/s, 1.33 m/s, 1.95 m/s"],
        &["machine", "chain-cutter"],
        &["machine", "drum"],
        &["machine", "rotor"],
        &["motor"],
        &["motor", "search"],
        &["motor", "forms"],
        &["draw", "II-3"],
        &["draw", "III"],
        &["schema", "gearbox"],
        &["completions", "bash"],
        &["man"],
    ]
    .into_iter()
    .map(words)
    .collect();
    for file in
        ["scheme-ii-3.yaml", "sized-gearbox.yaml", "closed-by-planetary-gear.yaml", "real-transmissions.yaml"]
    {
        all.push(vec!["analyze".to_owned(), example(file)]);
    }
    all.push(vec!["losses".to_owned(), example("drags.yaml")]);
    for command in ["strength", "size", "sheet"] {
        all.push(vec![command.to_owned(), example("wind-stage.yaml")]);
    }
    all.push(["compare", "II-3", "D.T1.B+T2.B.T1"].map(str::to_owned).to_vec());
    all.push(vec!["drive".to_owned(), example("xe215cll-drive.yaml")]);
    for file in ["sized-gearbox.yaml", "self-crossing.yaml", "real-transmissions.yaml"] {
        all.push(vec!["draw".to_owned(), example(file)]);
    }
    for file in ["scheme-ii-3.yaml", "xe215cll-drive.yaml", "motor-5x3.yaml"] {
        all.push(vec!["report".to_owned(), example(file)]);
    }
    all
}

/// Options that name output files, which `try_line` chooses.
const FILES: [&str; 5] = ["output", "svg", "dxf", "csv", "save"];

/// Options of a command, with whether they take a value and whether they are required.
fn options(command: &[String]) -> Vec<(String, bool, bool)> {
    let mut found = Cli::command();
    for name in command {
        let Some(below) = found.find_subcommand(name) else { break };
        found = below.clone();
    }
    let named = found.get_arguments().filter_map(|arg| {
        let name = arg.get_long().filter(|name| !FILES.contains(name) && *name != "help")?;
        Some((name.to_owned(), arg.get_action().takes_values(), arg.is_required_set()))
    });
    named.collect()
}

/// Whether the line searches for motors.
fn seeks_motors(command: &[String]) -> bool {
    command[0] == "motor" && command.len() == 2
}

/// Whether the line searches for motors with tooth forms, and names few of them.
fn seeks_forms(command: &[String]) -> bool {
    seeks_motors(command) && command[1] == "forms"
}

/// Whether an option is required, alone or by its group.
fn is_due(command: &[String], option: &str, required: bool, seed: u64) -> bool {
    let wanted = if seed.is_multiple_of(2) { &["displacement"][..] } else { &["torque", "pressure"] };
    required
        || (command[0] == "select" && option == "ratios")
        || (command[0] == "synthesize" && CLASS.contains(&option))
        || (seeks_motors(command) && (BOUNDS.contains(&option) || wanted.contains(&option)))
        || (seeks_forms(command) && FORMS.contains(&option))
}

/// Options that bound the classes of a synthesis; with limits that nothing meets, the search would continue
/// with ever larger classes.
const CLASS: [&str; 2] = ["sets", "elements"];

/// Options that bound the numbers of motors in a search.
const BOUNDS: [&str; 4] = ["stator", "rotor", "z3", "zs"];

/// Options that bound the tooth forms.
const FORMS: [&str; 4] = ["places", "pressure-angle", "addendum", "shift"];

/// Random command line: the command, and options with values that fit or do not. Searches that take seconds
/// are left out: those over all tooth numbers, and over motors of many sets.
fn line() -> impl Strategy<Value = Vec<String>> {
    let choice = (any::<prop::sample::Index>(), 0..10_u8, any::<prop::sample::Index>());
    let choices = prop::collection::vec(choice, 0..6);
    (prop::sample::select(commands()), choices, any::<u64>()).prop_map(|(command, choices, seed)| {
        let options = options(&command);
        let is_search = command[0] == "select";
        let seeks_motors = seeks_motors(&command);
        let due = options.iter().enumerate().filter(|(_, (name, _, due))| is_due(&command, name, *due, seed));
        let mut all: Vec<(usize, u8, usize)> =
            due.map(|(place, _)| (place, 0, (seed as usize).wrapping_add(place))).collect();
        if !options.is_empty() {
            all.extend(
                choices
                    .iter()
                    .map(|(place, wild, value)| (place.index(options.len()), *wild, value.index(1 << 16))),
            );
        }
        let mut line = command;
        let mut used = vec![];
        for (place, wild, value) in all {
            let (name, takes_value, _) = &options[place];
            if used.contains(&place) || (name == "teeth" && is_search) {
                continue;
            }
            used.push(place);
            let fits = sensible(name);
            // A wild range of tooth numbers may take minutes, one of sets hours.
            let bounded = ["sun", "planet", "ring", "sets", "elements", "engaged"].contains(&name.as_str())
                || (seeks_motors && BOUNDS.contains(&name.as_str()));
            let from = if (wild < 7 || bounded) && !fits.is_empty() { fits } else { &VALUES[..] };
            line.push(if *takes_value {
                format!("--{name}={}", from[value % from.len()])
            } else {
                format!("--{name}")
            });
        }
        line
    })
}

/// Runs a line; returns whether it had an answer.
fn try_line(line: &[String], answer: &PathBuf) -> bool {
    let mut all = line.to_vec();
    all.extend(["-o".to_owned(), answer.display().to_string()]);
    let saves = (line[0] == "motor" && line.get(1).is_some_and(|word| word == "search" || word == "forms"))
        || ["select", "synthesize"].contains(&line[0].as_str());
    if saves {
        all.push(format!("--save={}", answer.with_extension("yaml").display()));
    }
    if line[0] == "motor" {
        for kind in ["svg", "dxf", "csv"] {
            all.push(format!("--{kind}={}", answer.with_extension(kind).display()));
        }
    }
    let is_plain = |text: &str| !text.contains(|c: char| c.is_control() && c != '\n');
    let desk = Captured::default();
    match call(all, &desk) {
        0 => {
            let text = std::fs::read_to_string(answer).unwrap();
            let mut words = text.split(|c: char| !c.is_alphanumeric());
            // Titles of pictures and pages may contain any word.
            let says = ["--title", "--project", "--customer", "--author", "--date"];
            let is_titled = line.iter().any(|word| says.iter().any(|option| word.starts_with(option)));
            let no_number = |word: &str| word == "NaN" || word == "inf";
            assert!(!text.is_empty() && (is_titled || !words.any(no_number)), "{line:?}\n{text}");
            // JSON and CSV contain names unchanged; text for people must have no control characters.
            assert!(
                is_plain(&text) || line.iter().any(|word| word.starts_with("--format")),
                "{line:?}\n{text}"
            );
            true
        }
        code => {
            let told = desk.into_told().messages.concat();
            assert!((1..=3).contains(&code) && !told.is_empty() && is_plain(&told), "{line:?}\n{told:?}");
            false
        }
    }
}

#[test]
fn whatever_the_options_say_nothing_panics() {
    let folder = tempfile::tempdir().unwrap();
    let answer = folder.path().join("answer");
    let answered = std::cell::Cell::new(0);
    let cases = cases(800);
    let mut runner = TestRunner::new(ProptestConfig { cases, ..ProptestConfig::default() });
    let done = runner.run(&line(), |line| {
        answered.set(answered.get() + u32::from(try_line(&line, &answer)));
        Ok(())
    });
    if let Err(error) = done {
        panic!("{error}");
    }
    // Enough lines must be run and not just refused.
    assert!(answered.get() > cases / 5, "{} of {cases}", answered.get());
}

/// Number of cases, unless `PROPTEST_CASES` gives it.
fn cases(usual: u32) -> u32 {
    std::env::var("PROPTEST_CASES").ok().and_then(|cases| cases.parse().ok()).unwrap_or(usual)
}

/// Examples with the commands that read them.
const READ: [(&str, &[&str]); 18] = [
    ("every-gearbox-key.yaml", GEARBOXES),
    ("ravigneaux.yaml", GEARBOXES),
    ("simpson.yaml", GEARBOXES),
    ("lepelletier.yaml", GEARBOXES),
    ("power-split.yaml", GEARBOXES),
    ("wolfrom.yaml", GEARBOXES),
    ("wolfrom-self-locking.yaml", GEARBOXES),
    ("sized-gearbox.yaml", GEARBOXES),
    ("closed-by-planetary-gear.yaml", GEARBOXES),
    ("scheme-ii-3.yaml", GEARBOXES),
    ("self-crossing.yaml", GEARBOXES),
    ("every-drive-key.yaml", &["drive", "report"]),
    ("every-scenario-key.yaml", &["simulate", "simulate --format=json"]),
    ("power-shift.yaml", &["simulate", "simulate --format=csv"]),
    ("tip-in.yaml", &["simulate"]),
    ("minimal-drive.yaml", &["drive", "report"]),
    ("motor-5x3.yaml", &["report", "draw --view=teeth", "draw --view=chambers"]),
    (
        "real-transmissions.yaml",
        &[
            "analyze",
            "analyze --transmission=8HP --speed=2000rpm --torque=300N·m",
            "draw --transmission=TH400",
        ],
    ),
];

const GEARBOXES: &[&str] = &[
    "analyze",
    "analyze --format=json --speed=2000rpm --torque=300N·m",
    "analyze --gear=1 --speed=2000rpm --torque=-300N·m",
    "analyze --gear=curve",
    "analyze --gear=drive --format=csv",
    "analyze --all-combinations",
    "draw",
    "draw --view=levers",
    "draw --view=ladder",
    "draw --view=speeds --gear=1",
    "report",
];

/// Text with some words replaced by values of every kind or by other words of it, and some lines removed or
/// doubled.
fn mutated(text: &str, changes: &[(usize, usize, u8)]) -> String {
    let mut text = text.to_owned();
    for (place, by, how) in changes {
        let mut from = 0;
        let mut words = vec![];
        for part in text.split_inclusive(|c: char| c.is_whitespace() || ":,[]{}#\"'".contains(c)) {
            let word = part.trim_end_matches(|c: char| c.is_whitespace() || ":,[]{}#\"'".contains(c));
            if !word.is_empty() {
                words.push(from..from + word.len());
            }
            from += part.len();
        }
        let mut lines: Vec<&str> = text.split_inclusive('\n').collect();
        if words.is_empty() || lines.is_empty() {
            break;
        }
        let at = words[place % words.len()].clone();
        text = match how {
            0 => {
                lines.remove(place % lines.len());
                lines.concat()
            }
            1 => {
                lines.insert(place % lines.len(), lines[by % lines.len()]);
                lines.concat()
            }
            2..6 => {
                let other = words[by % words.len()].clone();
                format!("{}{}{}", &text[..at.start], &text[other], &text[at.end..])
            }
            // A slightly changed number is still a valid number.
            6..8 => match text[at.clone()].parse::<f64>() {
                Ok(number) => {
                    let number = number + (by % 5) as f64 - 2.0;
                    format!("{}{number}{}", &text[..at.start], &text[at.end..])
                }
                Err(_) => continue,
            },
            // A name may be `inf`; the numbers of the answer may not.
            _ => match VALUES[by % VALUES.len()] {
                "inf" => continue,
                value => format!("{}{value}{}", &text[..at.start], &text[at.end..]),
            },
        };
    }
    text
}

#[test]
fn whatever_a_file_says_nothing_panics() {
    let folder = tempfile::tempdir().unwrap();
    let (file, answer) = (folder.path().join("file.yaml"), folder.path().join("answer"));
    let texts: Vec<String> =
        READ.iter().map(|(name, _)| std::fs::read_to_string(example(name)).unwrap()).collect();
    let answered = std::cell::Cell::new(0);
    // With 2000 changed files, 543 were still answered. For 600 files a fifth is four standard deviations
    // below that, for 150 it was two.
    let cases = cases(600);
    let mut runner =
        TestRunner::new(ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() });
    let change = (any::<usize>(), any::<usize>(), 0..11_u8);
    let strategy = (0..READ.len(), any::<usize>(), prop::collection::vec(change, 1..4));
    let done = runner.run(&strategy, |(place, command, changes)| {
        std::fs::write(&file, mutated(&texts[place], &changes)).unwrap();
        let commands = READ[place].1;
        let mut line: Vec<String> =
            commands[command % commands.len()].split(' ').map(str::to_owned).collect();
        line.insert(1, file.display().to_string());
        answered.set(answered.get() + u32::from(try_line(&line, &answer)));
        Ok(())
    });
    if let Err(error) = done {
        panic!("{error}");
    }
    assert!(answered.get() > cases / 5, "{} of {cases}", answered.get());
}

/// Whatever outputs are named, the input must remain, and each output must be a separate file or none is
/// written.
#[cfg(unix)]
#[test]
fn whatever_files_are_named_none_is_lost() {
    use std::os::unix::fs::symlink;
    /// Names with the file that each denotes.
    const NAMES: [(&str, &str); 9] = [
        ("in.yaml", "in.yaml"),
        ("./in.yaml", "in.yaml"),
        ("link.yaml", "in.yaml"),
        ("hard.yaml", "in.yaml"),
        ("a", "a"),
        ("sub/../a", "a"),
        ("to-a", "a"),
        ("b", "b"),
        ("sub/b", "sub/b"),
    ];
    let name = || prop::sample::select(&NAMES[..]);
    let mut runner = TestRunner::new(ProptestConfig::default());
    let done = runner.run(&(name(), name(), 0..4_usize, any::<bool>()), |(svg, dxf, input, there)| {
        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        let text = std::fs::read_to_string(example("scheme-ii-3.yaml")).unwrap();
        std::fs::write(path("in.yaml"), &text).unwrap();
        std::fs::create_dir(path("sub")).unwrap();
        symlink("in.yaml", path("link.yaml")).unwrap();
        symlink("a", path("to-a")).unwrap();
        std::fs::hard_link(path("in.yaml"), path("hard.yaml")).unwrap();
        if there {
            std::fs::write(path("a"), "old").unwrap();
        }
        let shown = |name: &str| path(name).display().to_string();
        let line = ["draw", &shown(NAMES[input].0), "--svg", &shown(svg.0), "--dxf", &shown(dxf.0)];
        let code = call(line, &Captured::default());
        let apart = svg.1 != "in.yaml" && dxf.1 != "in.yaml" && svg.1 != dxf.1;
        prop_assert_eq!(code == 0, apart);
        prop_assert_eq!(std::fs::read_to_string(path("in.yaml")).unwrap(), text);
        prop_assert!(path("link.yaml").is_symlink() && path("to-a").is_symlink());
        let begins = |name: &str| std::fs::read_to_string(path(name)).ok().map(|text| text[..3].to_owned());
        for name in ["a", "b", "sub/b"] {
            let old = (there && name == "a").then_some("old");
            let due = match name {
                _ if !apart => old,
                _ if name == svg.1 => Some("<sv"),
                _ if name == dxf.1 => Some("999"),
                _ => old,
            };
            prop_assert_eq!(begins(name), due.map(str::to_owned), "{}", name);
        }
        let entries = std::fs::read_dir(folder.path()).unwrap().map(|entry| entry.unwrap().file_name());
        prop_assert!(entries.into_iter().all(|name| !name.to_string_lossy().starts_with(".epicyclic-")));
        Ok(())
    });
    if let Err(error) = done {
        panic!("{error}");
    }
}
