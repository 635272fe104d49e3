//! Files that nobody would write: the examples with lines lost, doubled and exchanged, and with other
//! scalars. Each is read and worked through, or refused with its place; nothing panics, and no number that is
//! none comes out.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use epicyclic_dynamics::drive::design;
use epicyclic_formats::gearbox::{GearboxFile, TransmissionsFile};
use epicyclic_formats::{Document, Faults, Path, drive, motor};
use epicyclic_train::{Gearbox, InputLoad};
use proptest::prelude::*;
use uom::si::angular_velocity::radian_per_second;
use uom::si::f64::{AngularVelocity, Torque};
use uom::si::torque::newton_meter;

/// Replacements of a name or a number.
const SCALARS: [&str; 40] = [
    "0",
    "-1",
    "1",
    "3",
    "1e308",
    "-1e308",
    "1e-308",
    "1e999",
    "4294967295",
    "4294967296",
    "-9223372036854775808",
    "99999999999999999999999999",
    "0.1",
    "1.0000000001",
    ".nan",
    ".inf",
    "-.inf",
    "nan",
    "~",
    "null",
    "true",
    "''",
    "' '",
    "ground",
    "T1",
    "D",
    "simple",
    "external_pair",
    "97 %",
    "1e300 kW",
    "12..40",
    "..",
    "\u{221e}",
    "π²",
    "\u{202e}K1",
    "🦀",
    "&a",
    "*a",
    "!!int x",
    "\"\\u0000\"",
];

#[derive(Debug, Clone)]
enum Change {
    Lose(usize),
    Double(usize),
    Exchange(usize, usize),
    /// The scalar of this number becomes one of [`SCALARS`], or another one of the file.
    Replace(usize, usize),
    Borrow(usize, usize),
    /// Bytes cut off at the end.
    Cut(usize),
    Write(usize, String),
}

fn change() -> impl Strategy<Value = Change> {
    let place = || any::<usize>();
    prop_oneof![
        2 => place().prop_map(Change::Lose),
        1 => place().prop_map(Change::Double),
        1 => (place(), place()).prop_map(|(one, other)| Change::Exchange(one, other)),
        6 => (place(), place()).prop_map(|(one, other)| Change::Replace(one, other)),
        3 => (place(), place()).prop_map(|(one, other)| Change::Borrow(one, other)),
        1 => place().prop_map(Change::Cut),
        1 => (place(), any::<String>()).prop_map(|(place, text)| Change::Write(place, text)),
    ]
}

/// Where the words of a text stand: what lies between spaces, brackets, commas and colons.
fn words(text: &str) -> Vec<(usize, usize)> {
    let mut words = vec![];
    let mut from = None;
    for (at, c) in text.char_indices().chain([(text.len(), ' ')]) {
        let is_mark = c.is_whitespace() || ":,[]{}#\"'".contains(c);
        match (is_mark, from) {
            (false, None) => from = Some(at),
            (true, Some(start)) => {
                words.push((start, at));
                from = None;
            }
            _ => {}
        }
    }
    words
}

fn apply(text: &str, change: &Change) -> String {
    let mut lines: Vec<&str> = text.split_inclusive('\n').collect();
    let words = words(text);
    if lines.is_empty() || words.is_empty() {
        return text.to_owned();
    }
    let count = lines.len();
    let replaced = |place: usize, by: &str| {
        let (from, to) = words[place % words.len()];
        format!("{}{by}{}", &text[..from], &text[to..])
    };
    match change {
        Change::Lose(place) => drop(lines.remove(place % count)),
        Change::Double(place) => lines.insert(place % count, lines[place % count]),
        Change::Exchange(one, other) => lines.swap(one % count, other % count),
        Change::Replace(place, by) => return replaced(*place, SCALARS[by % SCALARS.len()]),
        Change::Borrow(place, other) => {
            let (from, to) = words[other % words.len()];
            return replaced(*place, &text[from..to]);
        }
        Change::Cut(place) => return text.chars().take(place % text.chars().count()).collect(),
        Change::Write(place, by) => return replaced(*place, by),
    }
    lines.concat()
}

fn changed(example: &'static str) -> impl Strategy<Value = String> {
    prop::collection::vec(change(), 1..4)
        .prop_map(move |changes| changes.iter().fold(example.to_owned(), |text, change| apply(&text, change)))
}

/// Everything that the program asks of a gearbox.
fn work_through(gearbox: &Gearbox) {
    let speed = AngularVelocity::new::<radian_per_second>(150.0);
    for gear in gearbox.gears() {
        let Ok(analysis) = gearbox.analyze(gear.name()) else { continue };
        let numbers = [analysis.ratio(), analysis.efficiency(), analysis.back_driving_efficiency()];
        assert!(numbers.iter().flatten().all(|number| !number.is_nan()), "{gearbox:?} {numbers:?}");
        assert!(analysis.speeds().iter().flatten().all(|speed| !speed.is_nan()), "{gearbox:?}");
        for torque_n_m in [500.0, -1e300] {
            let _ = analysis.at(speed, InputLoad::Torque(Torque::new::<newton_meter>(torque_n_m)));
        }
    }
    if gearbox.shift_elements().len() <= 6 {
        let _ = gearbox.combinations(0..=gearbox.shift_elements().len());
    }
}

/// An error says where it is.
fn is_placed(error: &str) {
    assert!(error.starts_with("file.yaml:") && error.len() > "file.yaml:1:1: ".len(), "{error}");
}

fn gearbox(text: &str) -> Result<(), String> {
    let document = Document::parse_one("file.yaml", text.as_bytes()).map_err(|e| e.to_string())?;
    let file: GearboxFile = document.read().map_err(|e| e.to_string())?;
    let at = |faults: Faults| faults.placed(&document, &Path::root()).to_string();
    let gearbox = file.gearbox().map_err(at)?;
    work_through(&gearbox);
    let speed = AngularVelocity::new::<radian_per_second>(150.0);
    let torques = [1.0, 3.0, -4.0].map(Torque::new::<newton_meter>);
    for (entry, gear) in file.gears.iter().zip(gearbox.gears()) {
        let speeds = entry.speeds.iter().filter_map(|(link, speed)| Some((gearbox.link(link)?, speed.0)));
        let torques = entry.torques.iter().filter_map(|(link, torque)| Some((gearbox.link(link)?, torque.0)));
        let (speeds, torques): (Vec<_>, Vec<_>) = (speeds.collect(), torques.collect());
        if let Ok(state) = gearbox.with_inputs(gear, &speeds, &torques) {
            assert!(state.speeds.iter().flatten().all(|speed| !speed.value.is_nan()), "{text}");
        }
    }
    for bearing in file.planet_bearings(&gearbox).map_err(at)? {
        let _ = bearing.forces(Some(&torques), Some(speed));
    }
    Ok(())
}

fn hydromotor(text: &str) -> Result<(), String> {
    let document = Document::parse_one("file.yaml", text.as_bytes()).map_err(|e| e.to_string())?;
    motor::read(&document).map(|_| ()).map_err(|e| e.to_string())
}

fn transmissions(text: &str) -> Result<(), String> {
    let document = Document::parse_one("file.yaml", text.as_bytes()).map_err(|e| e.to_string())?;
    let file: TransmissionsFile = document.read().map_err(|e| e.to_string())?;
    for (index, transmission) in file.transmissions.iter().enumerate() {
        let base = Path::root().key("transmissions").index(index);
        let gearbox = transmission.gearbox().map_err(|faults| faults.placed(&document, &base).to_string())?;
        work_through(&gearbox);
        for gear in &transmission.gears {
            let _ = gear.stands_for(3.0);
        }
    }
    Ok(())
}

fn whole_drive(text: &str) -> Result<(), String> {
    let document = Document::parse_one("file.yaml", text.as_bytes()).map_err(|e| e.to_string())?;
    let (_, spec) = drive::read(&document).map_err(|e| e.to_string())?;
    if let Err(error) = design(&spec) {
        let _ = drive::place(&error);
        assert!(!error.to_string().is_empty());
    }
    Ok(())
}

/// Number of cases: that of `PROPTEST_CASES`, or the usual one.
fn cases(usual: u32) -> u32 {
    std::env::var("PROPTEST_CASES").ok().and_then(|cases| cases.parse().ok()).unwrap_or(usual)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: cases(1500), ..ProptestConfig::default() })]

    #[test]
    fn gearboxes(text in prop_oneof![
        changed(include_str!("../../../../examples/scheme-ii-3.yaml")),
        changed(include_str!("../../../../examples/sized-gearbox.yaml")),
        changed(include_str!("../../../../examples/closed-by-ordinary-train.yaml")),
        changed(include_str!("../../../../examples/every-gearbox-key.yaml")),
        changed(include_str!("../../../../examples/ravigneaux.yaml")),
        changed(include_str!("../../../../examples/wolfrom.yaml")),
        changed(include_str!("../../../../examples/power-split.yaml")),
    ]) {
        if let Err(error) = gearbox(&text) { is_placed(&error); }
    }

    #[test]
    fn motors(text in changed(include_str!("../../../../examples/motor-5x3.yaml"))) {
        if let Err(error) = hydromotor(&text) { is_placed(&error); }
    }

    #[test]
    fn drives(text in prop_oneof![
        changed(include_str!("../../../../examples/minimal-drive.yaml")),
        changed(include_str!("../../../../examples/xe215cll-drive.yaml")),
    ]) {
        if let Err(error) = whole_drive(&text) { is_placed(&error); }
    }
}

proptest! {
    // The file is long.
    #![proptest_config(ProptestConfig { cases: cases(200), ..ProptestConfig::default() })]

    #[test]
    fn lists_of_transmissions(text in changed(include_str!("../../../../examples/real-transmissions.yaml"))) {
        if let Err(error) = transmissions(&text) { is_placed(&error); }
    }

    #[test]
    fn any_bytes_at_all(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        if let Ok(document) = Document::parse_one("file.yaml", &bytes) {
            let _ = document.read::<GearboxFile>();
            let _ = document.read::<TransmissionsFile>();
            let _ = drive::read(&document);
        }
    }
}

#[test]
fn an_efficiency_near_nothing_is_refused() {
    let text = include_str!("../../../../examples/sized-gearbox.yaml").replace("97 %", "1e-308 %");
    assert!(gearbox(&text).unwrap_err().contains("mesh efficiency 1e-310: at least 0.000001"));
}

/// The changes leave enough files that are read: otherwise the properties say little.
#[test]
fn many_changed_files_are_still_gearboxes() {
    use proptest::strategy::ValueTree as _;
    use proptest::test_runner::TestRunner;
    let mut runner = TestRunner::deterministic();
    let strategy = changed(include_str!("../../../../examples/sized-gearbox.yaml"));
    let read =
        (0..300).filter(|_| gearbox(&strategy.new_tree(&mut runner).unwrap().current()).is_ok()).count();
    assert!(read > 40, "{read}");
}
