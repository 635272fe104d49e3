//! Every answer in JSON is valid by its own schema, and every key of a schema is written by some answer.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "helpers of tests, which clippy does not know for such"
)]

use crate::common;

use boon::{Compiler, SchemaIndex, Schemas};
use common::{examples, output, run};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::sync::LazyLock;

/// Keys by command.
type Keys = BTreeMap<String, BTreeSet<String>>;

/// Command lines that together write all keys of their answers, a line each: the answer's section, and the
/// words as a shell reads them.
const RUNS: &str = include_str!("json/runs.txt");

/// A gear that nothing holds, and one whose losses bear themselves out in two ways.
const FREE: &str = "gearbox: free\ninput: D\noutput: B\nsets: [{ id: P, sun: D, ring: T1, carrier: B, k: 3 }]\n\
                    gears: [{ name: free }]\n";
const PATTERNS: &str = "gearbox: slow\ninput: H\noutput: a\ngrounds: [b]\nsets:\n  - { id: P, kind: stepped_rings, \
                        sun: a, ring: b, carrier: H, k: 0.99, efficiency: 97 % }\ngears: [{ name: slow }]\n";

/// A shift towards the smaller ratio in which a one-way clutch takes over.
const ONE_WAY: &str = "gearbox: one-way\ninput: D\noutput: B\nsets: [{ id: P, sun: D, ring: T1, carrier: B, k: 3 }]\nbrakes: [{ \
                       id: K1, link: T1 }]\nclutches: [{ id: F, one_way: [B, D] }]\ngears: [{ name: slow, engaged: [K1] }, { \
                       name: fast, engaged: [F] }]\n";

/// Two sets and two brakes that do the work of one.
const REDUNDANT: &str = "gearbox: redundant\ninput: D\noutput: B\nsets:\n  - { id: P1, sun: D, ring: T1, carrier: B, k: 3 }\n  \
                         - { id: P2, sun: D, ring: T1, carrier: B, k: 3 }\nbrakes:\n  - { id: K1, link: T1 }\n  - { id: \
                         K2, link: T1 }\ngears: [{ name: slow, engaged: [K1, K2] }]\n";
/// Thirteen sets in a row, each with its ring at rest: too many for a formula.
fn thirteen() -> String {
    let set = |place: u32| {
        format!("  - {{ id: P{place}, sun: n{place}, ring: ground, carrier: n{}, k: 3 }}\n", place + 1)
    };
    let sets: String = (1..=13).map(set).collect();
    format!("gearbox: thirteen\ninput: n1\noutput: n14\nsets:\n{sets}gears: [{{ name: only }}]\n")
}

/// Planets whose radii and mesh contradict each other.
const APART: &str = "gearbox: apart\ninput: s\noutput: r\ncompound_sets:\n  - id: set\n    carrier: c\n    suns: { s: 30 }\n    \
                     rings: { r: 72 }\n    planet_gears: { short: [18], long: [18] }\n    planets: 3\n    module: 2 mm\n    \
                     planet_sizes: { short: { carrier_radius: 90 mm }, long: { carrier_radius: 40 mm } }\n    meshes:\n      - { gears: [s, short] }\n      \
                     - { gears: [short, long] }\n      - { gears: [long, r] }\nbrakes: [{ id: K, link: c }]\ngears: [{ \
                     name: \"1\", engaged: [K] }]\n";

/// A motor by the cosine law, and one whose tips have no room, so that the answer has the place of the
/// overlap.
const COSINE: &str = "stator: 7\nrotor: 5\nz3: 84\nzs: 11\nmodule: 1 mm\nlaw: cosine\n";
/// A motor with a kidney at high and a hole at low pressure, and nothing said of its oil.
const PORTED: &str = "stator: 6\nrotor: 4\nz3: 66\nzs: 10\nmodule: 2 mm\nl: 80 mm\nfriction: 0.1\nports:\n  \
                      high: { angle: -15 deg, inner_radius: 48 mm, outer_radius: 56 mm, span: 12 deg }\n  \
                      low: { angle: 15 deg, diameter: 12 mm, pitch_radius: 52 mm }\n";
const TIPS: &str = "stator: 5\nrotor: 3\nz3: 55\nzs: 10\nmodule: 2 mm\nteeth: { clearance: 0.02 }\n";

/// The wind stage with a duty that wears its roots, too.
fn worn() -> String {
    wind_stage().replace("torque: 1000 kN·m", "torque: 2500 kN·m")
}

/// The wind stage with tips of its sun that bite into its planets.
fn bites() -> String {
    wind_stage().replace("tip_alterations: [-0.0833333", "tip_alterations: [0.3")
}

/// The wind stage, and one after it without `K_v`.
fn lacks() -> String {
    let wind = wind_stage();
    let (set, _) = wind.split_once("  - id: stage\n").unwrap().1.split_once("oil:").unwrap();
    let other = set.replace("sun: next", "sun: last").replace("carrier: rotor", "carrier: next");
    let other = other.replace("K_v: 1.061, ", "");
    wind.replace("output: next", "output: last").replace("oil:", &format!("  - id: other\n{other}oil:"))
}

/// The travel drive with its planets and a rim given, loads that wear its teeth, and a set without
/// `strength`.
fn held() -> String {
    let drive = std::fs::read_to_string(examples().join("travel-drive-duty.yaml")).unwrap();
    let drive = drive
        .replace("    planet_teeth: [40]\n", "    planet_teeth: [40]\n    planets: 4\n    module: 4 mm\n");
    let drive = drive.replace("    strength: #", "    strength:\n      planet_rim: 12 mm #");
    let drive = drive.replace("output: track", "output: wheel");
    drive
        .replace("oil:", "  - { id: next, sun: track, ring: ground, carrier: wheel, teeth: [20, 100] }\noil:")
}

/// The travel drive with another set, of more planets than the table of load sharing contains.
fn many() -> String {
    let drive = drive().replace("output: track", "output: wheel");
    let set = &drive[drive.find("  - id: final").unwrap()..drive.find("oil:").unwrap()];
    let second = set.replace("id: final", "id: next").replace("sun: motor", "sun: track");
    let second = second.replace("carrier: track", "carrier: wheel");
    let second = second.replace("planet_teeth: [40]", "planet_teeth: [40]\n    planets: 8");
    drive.replace("oil:", &format!("{second}oil:"))
}

fn drive() -> String {
    std::fs::read_to_string(examples().join("travel-drive-duty.yaml")).unwrap()
}

/// The fan drive with its sun held in one gear and its carrier in another, and a set without `vibration`.
fn members_held() -> String {
    let drive = std::fs::read_to_string(examples().join("vibration.yaml")).unwrap();
    let drive = drive.replace("support: 20 N/µm", "support: 20 N/µm, tangential_support: 50 N/µm");
    let drive = drive.replace("support: 250 N/µm", "support: 250 N/µm, tangential_support: 60 N/µm");
    let drive = drive.replace(", engaged: [K1] }", ", engaged: [K1], input: ring }");
    let held = "brakes:\n  - { id: K3, link: motor }\n  - { id: K4, link: fan }\n";
    let drive = drive.replace("brakes:\n", held);
    let drive = drive.replace(
        "gears:\n",
        "gears:\n  - { name: a, engaged: [K3], input: ring }\n  - { name: b, engaged: [K4], output: ring }\n",
    );
    let other = "  - { id: Q, sun: fan, ring: ground, carrier: after, k: 3 }\nties:";
    drive.replace("ties:", other)
}

/// A planet meshes with other planets alone.
const CHAIN: &str = "gearbox: chain
input: sun
output: arm
compound_sets:
  - id: P
    carrier: arm
    suns: { sun: 20 }
    rings: { ground: 120 }
    planet_gears: { inner: [18], middle: [17], outer: [19] }
    planets: 3
    module: 3 mm
    meshes: [{ gears: [sun, inner] }, { gears: [inner, middle] }, { gears: [middle, outer] }, { gears: [outer, ground] }]
gears: [{ name: only }]
";

fn wind_stage() -> String {
    std::fs::read_to_string(examples().join("wind-stage.yaml")).unwrap()
}

/// Two sets; for the second the file gives no number of planets.
fn unplaced() -> String {
    let set = common::SHARP.lines().skip(4).take(4).collect::<Vec<_>>().join("\n");
    let second = set.replace("id: P, sun: sun", "id: Q, sun: arm").replace("carrier: arm", "carrier: out");
    let second = second.replace("planets: 3, ", "");
    common::SHARP
        .replacen(&set, &format!("{set}\n{second}"), 1)
        .replacen("output: arm", "output: out", 1)
        .replace("shaper: { teeth: 40", "shaper: { teeth: 20")
}

fn folder() -> tempfile::TempDir {
    let folder = common::here();
    for file in std::fs::read_dir(examples()).unwrap() {
        let file = file.unwrap();
        std::fs::copy(file.path(), folder.path().join(file.file_name())).unwrap();
    }
    std::fs::write(folder.path().join("free.yaml"), FREE).unwrap();
    std::fs::write(folder.path().join("worn.yaml"), worn()).unwrap();
    let bearing =
        "face_width: 550 mm\n    load_rating: 2 MN\n    bearing_rolling: plain\n    bearing_diameter: 450 mm";
    let plain = wind_stage().replace("face_width: 550 mm", bearing);
    std::fs::write(folder.path().join("plain.yaml"), plain).unwrap();
    // Driven both ways, each flank of its planets is in both meshes.
    let reversed = wind_stage().replace("torque: 600 kN·m", "torque: -600 kN·m");
    std::fs::write(folder.path().join("reversed.yaml"), reversed).unwrap();
    std::fs::write(folder.path().join("sharp.yaml"), common::SHARP).unwrap();
    std::fs::write(folder.path().join("unplaced.yaml"), unplaced()).unwrap();
    std::fs::write(folder.path().join("many.yaml"), many()).unwrap();
    std::fs::write(folder.path().join("bites.yaml"), bites()).unwrap();
    std::fs::write(folder.path().join("lacks.yaml"), lacks()).unwrap();
    std::fs::write(folder.path().join("held.yaml"), held()).unwrap();
    let weary = drive().replace("flank: 1.0, root: 1.4", "flank: 0.4, root: 1.0");
    std::fs::write(folder.path().join("weary.yaml"), weary).unwrap();
    std::fs::write(folder.path().join("rims.yaml"), "strength: { planet_rim: 12 mm }\n").unwrap();
    std::fs::write(folder.path().join("broken.yaml"), FREE.replace("k: 3", "k: 0.3")).unwrap();
    std::fs::write(folder.path().join("patterns.yaml"), PATTERNS).unwrap();
    std::fs::write(folder.path().join("one-way.yaml"), ONE_WAY).unwrap();
    std::fs::write(folder.path().join("redundant.yaml"), REDUNDANT).unwrap();
    std::fs::write(folder.path().join("apart.yaml"), APART).unwrap();
    std::fs::write(folder.path().join("sun-held.yaml"), members_held()).unwrap();
    std::fs::write(folder.path().join("thirteen.yaml"), thirteen()).unwrap();
    std::fs::write(folder.path().join("cosine.yaml"), COSINE).unwrap();
    let scenario = std::fs::read_to_string(examples().join("every-scenario-key.yaml")).unwrap();
    // It ends before its shift does.
    let short = scenario.replace("duration: 2 s", "duration: 0.7 s");
    std::fs::write(folder.path().join("short.yaml"), short).unwrap();
    std::fs::write(folder.path().join("tips.yaml"), TIPS).unwrap();
    std::fs::write(folder.path().join("ported.yaml"), PORTED).unwrap();
    std::fs::write(folder.path().join("chain.yaml"), CHAIN).unwrap();
    folder
}

fn collect(value: &Value, path: &str, found: &mut BTreeSet<String>) {
    let below = |key: &str| if path.is_empty() { key.to_owned() } else { format!("{path}.{key}") };
    match value {
        Value::Object(entries) => {
            entries.iter().for_each(|(key, value)| collect(value, &below(key), found));
        }
        // An empty list gives no information about its entries.
        Value::Array(entries) => match entries.first() {
            None => {}
            Some(Value::Object(_)) => {
                entries.iter().for_each(|entry| collect(entry, &format!("{path}[]"), found));
            }
            Some(_) => _ = found.insert(path.to_owned()),
        },
        _ => _ = found.insert(path.to_owned()),
    }
}

/// The answers of all runs, by section. Several tests read them.
static ANSWERS: LazyLock<Vec<(&str, Value)>> = LazyLock::new(|| {
    let folder = folder();
    let answer = |run: &'static str| {
        let (section, words) = run.split_once(": ").unwrap();
        let words = shlex::split(words).unwrap();
        let args: Vec<&str> = words.iter().map(String::as_str).chain(["--format", "json"]).collect();
        let done = output(folder.path(), &args);
        // A refusal is an answer, too.
        let is_refused = section == "error" && done.status.code() == Some(2);
        assert!(is_refused || matches!(done.status.code(), Some(0 | 1)), "{args:?} {done:?}");
        (section, serde_json::from_slice(&done.stdout).unwrap())
    };
    RUNS.lines().filter(|line| !line.starts_with('#')).map(answer).collect()
});

fn written() -> Keys {
    let mut keys = Keys::new();
    for (section, json) in &*ANSWERS {
        collect(json, "", keys.entry((*section).to_owned()).or_default());
    }
    keys
}

/// Schema of an answer as the program prints it.
fn schema(name: &str) -> Value {
    let done = output(Path::new("."), &["schema", &format!("answer-{name}")]);
    assert!(done.status.success(), "{name}: {done:?}");
    serde_json::from_slice(&done.stdout).unwrap()
}

/// Every key that a schema has, `[]` for the entries of a list and `*` for those of a map.
fn keys_of(schema: &Value, part: &Value, path: &str, found: &mut BTreeSet<String>) {
    if let Some(name) = part.get("$ref").and_then(Value::as_str) {
        let part = schema.pointer(name.strip_prefix('#').unwrap()).unwrap();
        return keys_of(schema, part, path, found);
    }
    for choices in ["anyOf", "oneOf", "allOf"] {
        for choice in part.get(choices).and_then(Value::as_array).into_iter().flatten() {
            keys_of(schema, choice, path, found);
        }
    }
    if let Some(entries) = part.get("items") {
        keys_of(schema, entries, &format!("{path}[]"), found);
    }
    if let Some(entries) = part.get("additionalProperties").filter(|entries| entries.is_object()) {
        keys_of(schema, entries, &format!("{path}.*"), found);
    }
    for (key, inner) in part.get("properties").and_then(Value::as_object).into_iter().flatten() {
        let path = format!("{path}.{key}");
        keys_of(schema, inner, &path, found);
        found.insert(path);
    }
}

/// Every key of an answer that has a value, in the words of [`keys_of`].
fn keys_with_values(schema: &BTreeSet<String>, value: &Value, path: &str, found: &mut BTreeSet<String>) {
    match value {
        Value::Null => {}
        Value::Object(entries) => {
            for (key, inner) in entries {
                let named = format!("{path}.{key}");
                let path = if schema.contains(&named) { named } else { format!("{path}.*") };
                keys_with_values(schema, inner, &path, found);
            }
            found.insert(path.to_owned());
        }
        Value::Array(entries) => {
            entries.iter().for_each(|entry| keys_with_values(schema, entry, &format!("{path}[]"), found));
            if !entries.is_empty() {
                found.insert(path.to_owned());
            }
        }
        _ => _ = found.insert(path.to_owned()),
    }
}

#[test]
fn every_answer_is_one_by_its_schema_and_every_key_is_written() {
    let (mut schemas, mut compiler) = (Schemas::new(), Compiler::new());
    let mut written: BTreeMap<String, (SchemaIndex, BTreeSet<String>, BTreeSet<String>)> = BTreeMap::new();
    for (section, json) in &*ANSWERS {
        let name = json["answer"].as_str().unwrap();
        let (index, keys, found) = written.entry(name.to_owned()).or_insert_with(|| {
            let (schema, mut keys) = (schema(name), BTreeSet::new());
            keys_of(&schema, &schema, "", &mut keys);
            let place = format!("{name}.json");
            compiler.add_resource(&place, schema).unwrap();
            (compiler.compile(&place, &mut schemas).unwrap(), keys, BTreeSet::new())
        });
        if let Err(error) = schemas.validate(json, *index) {
            panic!("{section}: {error:#}");
        }
        keys_with_values(keys, json, "", found);
    }
    let mut faults = vec![];
    // A judgement is one record in all answers: what one of them writes the others can.
    let of_judgement = |key: &String| Some(key.split_once("judgement")?.1.to_owned());
    let judged: BTreeSet<String> =
        written.values().flat_map(|(_, _, found)| found.iter().filter_map(of_judgement)).collect();
    // So are the sizes and masses of designs, and the limits that would have to give.
    let of_designs = |name: &str, key: &str| {
        let key = &key.replace(".front", ".ways_out");
        let is_shared = [".sizes.", ".ways_out", ".masses."].iter().any(|of| key.starts_with(of));
        (is_shared && name.starts_with("design")).then(|| key.to_owned())
    };
    let designed: BTreeSet<String> = written
        .iter()
        .flat_map(|(name, (_, _, found))| found.iter().filter_map(|key| of_designs(name, key)))
        .collect();
    for (name, (_, keys, found)) in &written {
        // What these answer has all that the checks need, and keeps them.
        let is_whole = |key: &str| {
            let mut never = ["tooth_checks.not_checked", "checks[].message", "checks[].remedy"].into_iter();
            // Stages are taken only with sizes that hold.
            (name == "design-stages" && key.contains("nearest_miss"))
                // Lengths are bounded of stages alone.
                || (name.starts_with("design") && [".limits.length_m", ".limits.shortest_m"].contains(&key))
                || of_designs(name, key).is_some_and(|key| designed.contains(&key))
                // Only designs assume a factor that grows with the width.
                || (name == "size" && key.contains("face_load_factor"))
                // Sets of a list of gears have the shifts of their sizes.
                || (name == "design-transmission" && key.contains(".shifts"))
                || of_judgement(&key.to_owned()).is_some_and(|key| judged.contains(&key))
                || (name.starts_with("teeth") || name == "size") && never.any(|of| key.contains(of))
        };
        let missing: Vec<&String> = keys.difference(found).filter(|key| !is_whole(key)).collect();
        if !missing.is_empty() {
            faults.push(format!("{name}: no run here gives a value to {missing:?}"));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// Answers without a judgement, and why.
const WITHOUT_JUDGEMENT: [(&str, &[&str]); 5] = [
    ("a refusal", &["error"]),
    ("gearboxes of a list; each is judged when it is named", &["transmissions"]),
    ("schemes with formulas alone", &["schemes"]),
    ("machines", &["machines", "machine-speeds", "machine-drum", "machine-rotor", "machine-chain-cutter"]),
    ("arcs, no motor", &["motor-construction"]),
];

/// The judgements of an answer, wherever they are.
fn judgements<'j>(json: &'j Value, found: &mut Vec<&'j Value>) {
    match json {
        Value::Object(entries) => {
            for (key, value) in entries {
                if key == "judgement" { found.push(value) } else { judgements(value, found) }
            }
        }
        Value::Array(entries) => entries.iter().for_each(|entry| judgements(entry, found)),
        _ => {}
    }
}

#[test]
fn every_answer_that_shows_a_gearbox_or_motor_is_judged() {
    // Searches without a result and gearboxes without data have nothing to judge, so one run is enough.
    let mut is_judged: BTreeMap<&str, bool> = BTreeMap::new();
    for (_, json) in &*ANSWERS {
        let mut found = vec![];
        judgements(json, &mut found);
        let is_filled = found.iter().any(|one| !one["checks"].as_array().unwrap().is_empty());
        *is_judged.entry(json["answer"].as_str().unwrap()).or_default() |= is_filled;
    }
    let is_excused = |name: &str| WITHOUT_JUDGEMENT.iter().any(|(_, names)| names.contains(&name));
    let faults: Vec<&str> = is_judged
        .iter()
        .filter(|(name, judged)| is_excused(name) == **judged)
        .map(|(name, _)| *name)
        .collect();
    assert!(faults.is_empty(), "neither judged nor excused, or both: {faults:?}");
}

/// Answer, rule, factor and offset from the unit of the rule to that of the answer's own figure, its key.
const FIGURES: [(&str, &str, f64, f64, &str); 17] = [
    ("strength", "bearing-life", 3600.0, 0.0, "life_s"),
    ("strength", "ball-load", 1e3, 0.0, "force_n"),
    ("strength", "bearing-static-safety", 1.0, 0.0, "static_safety"),
    ("strength", "flank-safety", 1.0, 0.0, "safety"),
    ("strength", "root-safety", 1.0, 0.0, "safety"),
    ("losses", "oil-temperature", 1.0, -20.0, "rise_k"),
    ("drive", "stage-efficiency", 1.0, 0.0, "overall"),
    ("drive", "neighbour-gap-length", 1e-3, 0.0, "tip_gap_m"),
    ("motor", "motor-pressure", 1e6, 0.0, "pressure_pa"),
    ("motor", "allowed-pressure", 1e6, 0.0, "pressure_pa"),
    ("motor", "contact-stress", 1e6, 0.0, "alone_pa"),
    ("motor", "chamber-area", 1e-6, 0.0, "least_chamber_m2"),
    ("motor", "axial-gap", 1e-6, 0.0, "satellite_gap_m"),
    ("motor", "volumetric-efficiency", 1.0, 0.0, "volumetric"),
    ("motor", "overlap", 1.0, 0.0, "clearance_in_modules"),
    ("motor", "trapped-pressure", 1e6, 0.0, "change_pa"),
    ("motor", "ripple", 1.0, 0.0, "ripple"),
];

fn figures(json: &Value, name: &str, key: &str, found: &mut Vec<f64>) {
    match json {
        Value::Object(entries) => entries
            .iter()
            .filter(|(key, _)| *key != "judgement")
            .for_each(|(own, value)| figures(value, own, key, found)),
        Value::Array(entries) => entries.iter().for_each(|entry| figures(entry, name, key, found)),
        _ => found.extend(json.as_f64().filter(|_| name == key)),
    }
}

/// A limit is no better than the unit of what it is held against.
#[test]
fn judged_values_are_figures_of_the_answer() {
    for (answer, rule, factor, offset, key) in FIGURES {
        let is_met = ANSWERS.iter().filter(|(_, json)| json["answer"] == answer).any(|(_, json)| {
            let mut found = vec![];
            figures(json, "", key, &mut found);
            let checks = json["judgement"]["checks"].as_array().unwrap().iter();
            let values =
                checks.filter(|check| check["name"] == rule).filter_map(|check| check["value"].as_f64());
            let mut values = values.map(|value| value * factor + offset).filter(|value| *value != 0.0);
            let is_own = |value: f64| found.iter().any(|own| (own.abs() / value.abs() - 1.0).abs() < 1e-9);
            values.any(is_own)
        });
        assert!(is_met, "{answer}: {rule} is no {key}");
    }
}

/// The book names every warning that is met here.
#[test]
fn the_names_of_warnings_stand_in_the_book() {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/src/reference/json.md");
    // Rules of practice have a page of their own.
    let page = std::fs::read_to_string(&page).unwrap()
        + &std::fs::read_to_string(page.with_file_name("practice.md")).unwrap();
    let names: BTreeSet<String> = ANSWERS
        .iter()
        .flat_map(|(_, json)| json["warnings"].as_array().into_iter().flatten())
        .map(|warning| warning["name"].as_str().unwrap().to_owned())
        .collect();
    assert!(names.len() > 8, "{names:?}");
    for name in names {
        assert!(page.contains(&format!("`{name}`")), "{name}");
    }
}

/// Standard output always has exactly one object.
#[test]
fn there_is_always_one_object() {
    let folder = folder();
    for (line, code, name) in [
        ("teeth --ratio 24", 1, "no-tooth-numbers"),
        ("teeth --ratio 6 --planets 9", 2, "planet-number"),
        ("synthesize --ratios '2.56, 1.465' --sets 1 --elements 2 --engaged 1", 1, "nothing-found"),
        (
            "motor search --torque '600 N·m' --pressure '20 MPa' --stator 5..6 --z3 55..66 --outer-diameter '10 mm'",
            1,
            "no-motor",
        ),
        ("analyze missing.yaml", 3, "cannot-be-read"),
        ("analyze ravigneaux.yaml --gear 9", 2, "no-gear"),
    ] {
        let done = run(folder.path(), &format!("{line} --format json"));
        assert_eq!(done.status.code(), Some(code), "{line} {done:?}");
        let json: Value =
            serde_json::from_slice(&done.stdout).unwrap_or_else(|error| panic!("{line}: {error}"));
        if json["answer"] == "error" {
            assert_eq!((json["name"].as_str(), json["exit_code"].as_i64()), (Some(name), Some(code.into())));
        }
        let text = String::from_utf8(done.stderr).unwrap();
        assert!(text.contains("error: "), "{text}");
    }
    let to_file = output(folder.path(), &["teeth", "--ratio", "24", "-o", "no.json"]);
    assert!(to_file.stdout.is_empty() && !folder.path().join("no.json").exists());
}

/// Quantities have their unit in the key, and no key occurs both with and without a unit.
#[test]
fn a_key_keeps_its_unit_where_there_is_no_value() {
    const UNITS: [&str; 12] =
        ["_m_s", "_rad_s2", "_rad_s", "_rad", "_kg_m2", "_kg", "_n_m", "_n", "_w", "_pa", "_j", "_m"];
    for (section, keys) in written() {
        for key in &keys {
            let bare = UNITS.iter().find_map(|unit| key.strip_suffix(unit));
            assert!(!bare.is_some_and(|bare| keys.contains(bare)), "{section}: {key}");
        }
    }
}
