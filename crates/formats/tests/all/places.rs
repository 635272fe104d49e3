//! Places of faults: each kind of fault that a gearbox file can have, at its value, whatever the order of
//! keys and wherever else its names stand.

#![allow(clippy::unwrap_used, reason = "tests")]

use epicyclic_formats::gearbox::{GearboxFile, TransmissionsFile};
use epicyclic_formats::{Document, Error, Path};

/// Names of things stand elsewhere, too: in titles, notes, names of other things.
const BOX: &str = "\
gearbox: zz
note: { zz: zz, P: P, K1: K1 }
input: D
output: B
links: [L]
sets:
  - { id: P, sun: D, ring: T1, carrier: B, k: 3, note: zz }
  - { id: Q, sun: D, ring: T2, carrier: T1, teeth: [20, 60], planets: 3, note: [zz, P] }
compound_sets:
  - { id: C, carrier: B, suns: { D: 20 }, rings: { T3: 60 }, planet_gears: { p: [20] }, planet_sizes: { p: { mass: 1 kg } }, meshes: [{ gears: [D, p] }, { gears: [p, T3], efficiency: 0.99 }] }
brakes:
  - { id: K1, link: T1 }
  - { id: K2, link: T2, drag: { speeds: [0 rpm, 100 rpm], torques: [1 N·m, 2 N·m] } }
clutches:
  - { id: D, links: [T1, B] }
  - { id: F, one_way: [T2, B] }
grounds: [L]
ties:
  - [T3, T2]
drags:
  - { id: K1, between: [D, ground], curve: { speeds: [0 rpm, 3000 rpm], torques: [1 N·m, 2 N·m] } }
gears:
  - { name: P, engaged: [K1, D] }
  - { name: Q, engaged: [K2], input: D, output: B }
";

/// The keys of every map in braces in the other order.
fn reversed(text: &str) -> String {
    let mut lines: Vec<String> = vec![];
    for line in text.lines() {
        let line = line
            .find('{')
            .map_or_else(|| line.to_owned(), |from| format!("{}{}", &line[..from], of_value(&line[from..])));
        lines.push(line);
    }
    lines.join("\n") + "\n"
}

fn of_value(text: &str) -> String {
    let parts = |inner: &str| -> Vec<String> {
        let (mut depth, mut parts, mut part) = (0, vec![], String::new());
        for c in inner.chars() {
            depth += i32::from("{[".contains(c)) - i32::from("}]".contains(c));
            if c == ',' && depth == 0 {
                parts.push(std::mem::take(&mut part));
            } else {
                part.push(c);
            }
        }
        parts.push(part);
        parts.iter().map(|part| part.trim().to_owned()).collect()
    };
    let inner = |open: char, close: char| text.strip_prefix(open)?.strip_suffix(close);
    if let Some(inner) = inner('{', '}') {
        let of_key = |part: String| match part.split_once(": ") {
            Some((key, value)) => format!("{key}: {}", of_value(value)),
            None => part,
        };
        let all: Vec<String> = parts(inner).into_iter().map(of_key).rev().collect();
        return format!("{{ {} }}", all.join(", "));
    }
    match inner('[', ']') {
        Some(inner) => {
            format!("[{}]", parts(inner).iter().map(|part| of_value(part)).collect::<Vec<_>>().join(", "))
        }
        None => text.to_owned(),
    }
}

fn of_gearbox(text: &str) -> Option<Error> {
    let document = Document::parse_one("box.yaml", text.as_bytes()).unwrap();
    let file: GearboxFile = document.read().unwrap();
    let checked = file.gearbox().and_then(|gearbox| {
        file.planet_bearings(&gearbox)?;
        file.drags(&gearbox)
    });
    checked.err().map(|faults| faults.placed(&document, &Path::root()))
}

fn of_transmission(text: &str) -> Option<Error> {
    let document = Document::parse_one("box.yaml", text.as_bytes()).unwrap();
    let file: TransmissionsFile = document.read().unwrap();
    let base = Path::root().key("transmissions").index(0);
    file.transmissions[0].gearbox().err().map(|faults| faults.placed(&document, &base))
}

/// The refusal of a text, which is the same with its keys in the other order: path and name, and what begins
/// at its position.
fn refusal(text: &str, of: fn(&str) -> Option<Error>) -> [String; 3] {
    let told = |text: &str| {
        let refused = of(text);
        assert!(refused.is_some(), "nothing is refused in\n{text}");
        let error = refused.unwrap();
        // Another name may be missing elsewhere; any other fault is alone.
        let is_of_names = ["duplicate", "unknown"].contains(&error.name());
        assert!(is_of_names || error.faults().count() == 1, "{error}");
        let at = error.at();
        let line = text.lines().nth(at.position.line - 1).unwrap();
        let rest: String = line.chars().skip(at.position.column - 1).collect();
        (at.path.to_string(), error.name().to_owned(), at.position.line, rest)
    };
    let (path, name, line, rest) = told(text);
    let (other_path, other_name, other_line, _) = told(&reversed(text));
    assert_eq!((&path, &name, line), (&other_path, &other_name, other_line), "{text}");
    assert_ne!(name, "refused");
    [path, name, rest]
}

#[test]
fn a_fault_of_a_gearbox_is_at_its_value() {
    assert_eq!(of_gearbox(BOX), None);
    assert_eq!(of_gearbox(&reversed(BOX)), None);
    for (from, to, path, name, begins) in [
        // Names that stand twice, before what else is wrong with the first.
        (
            "id: Q, sun: D, ring: T2",
            "id: P, sun: D, ring: T2",
            "sets[1]",
            "duplicate",
            "{ id: P, sun: D, ring: T2",
        ),
        ("id: C, carrier", "id: Q, carrier", "compound_sets[0]", "duplicate", "{ id: Q, carrier"),
        ("id: K2, link", "id: K1, link", "brakes[1]", "duplicate", "{ id: K1, link: T2"),
        ("id: F, one_way", "id: K2, one_way", "clutches[1]", "duplicate", "{ id: K2, one_way"),
        ("name: Q, engaged", "name: P, engaged", "gears[1]", "duplicate", "{ name: P, engaged: [K2]"),
        ("id: K1, between", "id: K2, between", "drags[0]", "duplicate", "{ id: K2, between"),
        // Names that nothing has.
        ("id: K1, link: T1", "id: zz, link: zz", "brakes[0].link", "unknown", "zz"),
        ("id: D, links: [T1, B]", "id: zz, links: [T1, zz]", "clutches[0].links[1]", "unknown", "zz]"),
        ("one_way: [T2, B]", "one_way: [zz, B]", "clutches[1].one_way[0]", "unknown", "zz, B]"),
        ("name: P, engaged: [K1, D]", "name: zz, engaged: [K1, zz]", "gears[0].engaged[1]", "unknown", "zz]"),
        (
            "name: Q, engaged: [K2], input: D",
            "name: zz, engaged: [K2], input: zz",
            "gears[1].input",
            "unknown",
            "zz",
        ),
        ("output: B }", "output: zz }", "gears[1].output", "unknown", "zz"),
        ("input: D\n", "input: zz\n", "input", "unknown", "zz"),
        ("output: B\n", "output: zz\n", "output", "unknown", "zz"),
        ("grounds: [L]", "grounds: [L, zz]", "grounds[1]", "unknown", "zz]"),
        ("[T3, T2]", "[T3, zz]", "ties[0][1]", "unknown", "zz]"),
        ("between: [D, ground]", "between: [zz, ground]", "drags[0].between[0]", "unknown", "zz, ground"),
        // Values.
        ("k: 3,", "k: 0.5,", "sets[0].k", "ring-to-sun-ratio", "0.5"),
        ("k: 3,", "", "sets[0]", "row-known-in-one-way", "{ id: P"),
        ("k: 3,", "k: 3, teeth: [20, 60],", "sets[0].teeth", "row-known-in-one-way", "[20"),
        ("teeth: [20, 60]", "teeth: [20, 0]", "sets[1].teeth[1]", "no-teeth", "0]"),
        ("planets: 3", "planets: 3, planet_teeth: [0]", "sets[1].planet_teeth[0]", "no-teeth", "0]"),
        ("planets: 3", "planets: 3, planet_teeth: [1, 2, 3]", "sets[1].planet_teeth", "planet-teeth", "[1"),
        ("planets: 3", "planets: 0", "sets[1].planets", "planet-count", "0"),
        ("k: 3,", "k: 3, efficiency: 1.2,", "sets[0].efficiency", "efficiency", "1.2"),
        ("k: 3,", "k: 3, meshes: [0.98, 1.2],", "sets[0].meshes[1]", "efficiency", "1.2"),
        ("k: 3,", "k: 3, meshes: [0.98],", "sets[0].meshes", "losses", "[0.98"),
        (
            "planets: 3",
            "planets: 3, efficiency: 0.9, friction: [0.05, 0.05]",
            "sets[1].friction",
            "losses-twice",
            "[0.05",
        ),
        ("k: 3,", "k: 3, friction: [0.05, 0.05],", "sets[0].friction", "friction", "[0.05"),
        ("planets: 3", "planets: 3, friction: [0, 0.05]", "sets[1].friction", "not-positive", "[0, "),
        ("k: 3,", "k: 3, profile_shifts: [0, 0, 0],", "sets[0].profile_shifts", "shifts", "[0"),
        ("planets: 3", "planets: 3, tip_alterations: [0, 0, 0]", "sets[1].tip_alterations", "shifts", "[0"),
        ("k: 3,", "k: 3, helix_angle: 8 deg,", "sets[0].helix_angle", "helix-angle", "8"),
        ("planets: 3", "planets: 3, helix_angle: 80 deg", "sets[1].helix_angle", "out-of-range", "80"),
        (
            "sun: D, ring: T1, carrier: B, k",
            "sun: D, ring: D, carrier: B, k",
            "sets[0]",
            "coincident-members",
            "{ id: P",
        ),
        ("carrier: B, k", "k", "sets[0]", "carrier", "{ id: P"),
        ("k: 3,", "k: 3, kind: external_pair,", "sets[0].carrier", "carrier", "B"),
        ("planets: 3", "planets: 3, module: -1 mm", "sets[1].module", "not-positive", "-1"),
        (
            "planets: 3",
            "planets: 3, module: 2 mm, face_width: -1 mm",
            "sets[1].face_width",
            "not-positive",
            "-1",
        ),
        // Compound sets.
        ("suns: { D: 20 }", "suns: { D: 0 }", "compound_sets[0].suns.D", "compound", "0"),
        (
            "[p, T3], efficiency: 0.99",
            "[p, zz], efficiency: 0.99",
            "compound_sets[0].meshes[1].gears[1]",
            "compound",
            "zz",
        ),
        (
            "efficiency: 0.99",
            "efficiency: 1.99",
            "compound_sets[0].meshes[1].efficiency",
            "efficiency",
            "1.99",
        ),
        (
            "planet_sizes: { p",
            "planet_sizes: { zz",
            "compound_sets[0].planet_sizes.zz",
            "no-such-planet",
            "{ mass",
        ),
        // Connections.
        ("  - [T3, T2]\n", "  - [T3, T2]\n  - [T2, T3]\n", "ties[1]", "cyclic-grounds", "[T2, T3]"),
        ("grounds: [L]", "grounds: [L, L]", "grounds[1]", "cyclic-grounds", "L]"),
        ("links: [T1, B]", "links: [T1, T1]", "clutches[0]", "shift-element-joins-itself", "{ id: D"),
        ("one_way: [T2, B] }", "one_way: [T2, B], links: [T2, B] }", "clutches[1]", "clutch", "{ id: F"),
        ("input: D\n", "input: ground\n", "input", "grounded-terminal", "ground"),
        ("input: D,", "input: ground,", "gears[1].input", "grounded-terminal", "ground"),
        // Curves of drags, of a drag and of a brake.
        ("speeds: [0 rpm, 3000 rpm]", "speeds: [0 rpm, 0 rpm]", "drags[0].curve.speeds[1]", "drag", "0 rpm]"),
        (
            "torques: [1 N·m, 2 N·m] } }\nclutches",
            "torques: [1 N·m, -2 N·m] } }\nclutches",
            "brakes[1].drag.torques[1]",
            "drag",
            "-2",
        ),
        ("between: [D, ground]", "between: [D, D]", "drags[0].between", "drag", "[D, D]"),
    ] {
        assert_eq!(BOX.matches(from).count(), 1, "{from}");
        let [found, of, rest] = refusal(&BOX.replace(from, to), of_gearbox);
        assert_eq!((found.as_str(), of.as_str()), (path, name), "{to}");
        // A place within what stands: `sets[0]` begins with its first key.
        assert!(
            rest.starts_with(begins.trim_start_matches("{ ")) || rest.starts_with(begins),
            "{to}: {rest}"
        );
    }
}

#[test]
fn a_fault_of_a_transmission_is_at_its_value() {
    const LIST: &str = "\
transmissions:
- name: n_x
  note: { X: X, P: P }
  sets:
  - { id: P, planet: simple, sun: X, ring: Y, carrier: Z, z_s: 20, z_r: 60, n_p: 3, note: [X, Y] }
  - { id: Q, planet: pair, gear_a: V, gear_b: W, z_a: 24, z_b: 77 }
  links: { n_x: [X, V], n_y: [Y], n_z: [Z], n_w: [W] }
  input: n_x
  output: n_z
  shift_elements: { P: [n_y, ground] }
  one_way: { F: [n_w, n_z] }
  gears:
  - { name: X, engaged: [P], published_ratio: 4.00, printed_decimals: 2 }
";
    assert_eq!(of_transmission(LIST), None);
    for (from, to, path, name) in [
        ("id: Q", "id: P", "sets[1]", "duplicate"),
        ("F: [", "P: [", "one_way.P", "duplicate"),
        ("ring: Y, carrier", "ring: zz, carrier", "sets[0].ring", "member-in-no-link"),
        ("gear_b: W", "gear_b: zz", "sets[1].gear_b", "member-in-no-link"),
        ("n_y: [Y]", "n_y: [Y, X]", "links.n_y[1]", "member-in-two-links"),
        ("n_y: [Y]", "n_y: [Y, Y]", "links.n_y[1]", "member-in-two-links"),
        ("z_r: 60", "z_r: 0", "sets[0].z_r", "no-teeth"),
        ("z_a: 24", "z_a: 0", "sets[1].z_a", "no-teeth"),
        ("n_p: 3", "n_p: 3, z_pa: 0", "sets[0].z_pa", "no-teeth"),
        ("n_p: 3", "n_p: 0", "sets[0].n_p", "planet-count"),
        ("z_s: 20, ", "", "sets[0]", "missing"),
        ("P: [n_y, ground]", "P: [n_y, X]", "shift_elements.P[1]", "unknown"),
        ("engaged: [P]", "engaged: [X]", "gears[0].engaged[0]", "unknown"),
        ("input: n_x", "input: X", "input", "unknown"),
    ] {
        assert_eq!(LIST.matches(from).count(), 1, "{from}");
        let [found, of, _] = refusal(&LIST.replace(from, to), of_transmission);
        assert_eq!((found, of.as_str()), (format!("transmissions[0].{path}"), name), "{to}");
    }
}
