//! Faults put into files: each is found with its name, line, column and path, alone and with another one. In
//! gearbox files of several styles the faults are of values, in all kinds of files of their meaning.

#![allow(clippy::unwrap_used, reason = "tests")]

use epicyclic_formats::gearbox::{GearboxFile, TransmissionsFile};
use epicyclic_formats::scenario::ScenarioFile;
use epicyclic_formats::{Document, Error, Path, drive, motor};
use proptest::prelude::*;

/// Changed text, the wrong key or value in it, path and name of the fault.
type Case = (&'static str, &'static str, &'static str, &'static str, &'static str);

/// Texts between `@` and `@` are the wrong keys and values.
const CASES: [Case; 24] = [
    ("sun: D", "@sunn@: D", "sets[0].sunn", "unknown-key", ""),
    ("sun: D", "sun: @[D]@", "sets[0].sun", "wrong-type", ""),
    ("sun: D", "sun: @12@", "sets[0].sun", "wrong-type", ""),
    ("teeth: [20, 60]", "teeth: [@twenty@, 60]", "sets[0].teeth[0]", "wrong-type", ""),
    ("teeth: [20, 60]", "teeth: [20, @-60@]", "sets[0].teeth[1]", "out-of-range", ""),
    ("teeth: [20, 60]", "teeth: [20, @60.5@]", "sets[0].teeth[1]", "wrong-type", ""),
    ("teeth: [20, 60]", "teeth: @20@", "sets[0].teeth", "wrong-type", ""),
    ("planets: 3", "planets: @'3'@", "sets[0].planets", "wrong-type", ""),
    ("planets: 3", "planets: @true@", "sets[0].planets", "wrong-type", ""),
    ("planets: 3", "planets: @4294967296@", "sets[0].planets", "out-of-range", ""),
    ("module: 4 mm", "module: @4@", "sets[0].module", "missing-unit", ""),
    ("module: 4 mm", "module: @4 kW@", "sets[0].module", "wrong-dimension", ""),
    ("module: 4 mm", "module: @4 mmm@", "sets[0].module", "unknown-unit", ""),
    ("module: 4 mm", "module: @'4,5 mm'@", "sets[0].module", "decimal-comma", ""),
    ("module: 4 mm", "@modul@: 4 mm", "sets[0].modul", "unknown-key", ""),
    ("spacing: equal", "spacing: @even@", "sets[0].spacing", "unknown-name", ""),
    ("id: K1", "@name@: K1", "brakes[0].name", "unknown-key", "id"),
    ("link: T1", "link: @{ T1: 1 }@", "brakes[0].link", "wrong-type", ""),
    ("name: slow", "name: @~@", "gears[0].name", "wrong-type", ""),
    ("engaged: [K1]", "engaged: @K1@", "gears[0].engaged", "wrong-type", ""),
    ("engaged: [K1]", "engaged: [@1.5@]", "gears[0].engaged[0]", "wrong-type", ""),
    ("density: 7800 kg/m³", "density: @7800 kg@", "density", "wrong-dimension", ""),
    ("addendum: 1.0", "addendum: @1 mm@", "addendum", "unexpected-unit", ""),
    ("addendum: 1.0", "@addendums@: 1.0", "addendums", "unknown-key", ""),
];

const KEYS: [(&str, &[&[&str]]); 3] = [
    (
        "sets",
        &[&[
            "id: P",
            "sun: D",
            "ring: T1",
            "carrier: B",
            "teeth: [20, 60]",
            "planets: 3",
            "module: 4 mm",
            "spacing: equal",
        ]],
    ),
    ("brakes", &[&["id: K1", "link: T1"]]),
    ("gears", &[&["name: slow", "engaged: [K1]"]]),
];

/// A gearbox file in a style: entries in braces or line by line, remarks, depth of indentation.
fn written(is_flow: bool, has_remarks: bool, depth: usize) -> String {
    let mut text = String::from("gearbox: I\ninput: D\noutput: B\ndensity: 7800 kg/m³\naddendum: 1.0\n");
    let indent = " ".repeat(depth);
    for (list, entries) in KEYS {
        if has_remarks {
            text.push_str("# ä remark: [\n\n");
        }
        text.push_str(&format!("{list}:\n"));
        for keys in entries {
            if is_flow {
                text.push_str(&format!("{indent}- {{ {} }}\n", keys.join(", ")));
            } else {
                let between = format!("\n{indent}  ");
                text.push_str(&format!("{indent}- {}\n", keys.join(&between)));
            }
        }
    }
    text
}

/// Takes the marks out of a text: line and column of the wrong parts.
fn unmarked(text: &str) -> (String, Vec<(usize, usize)>) {
    let (mut plain, mut places, mut is_open) = (String::new(), vec![], false);
    for (line, content) in text.lines().enumerate() {
        let mut column = 1;
        for c in content.chars() {
            if c == '@' {
                is_open = !is_open;
                if is_open {
                    places.push((line + 1, column));
                }
            } else {
                plain.push(c);
                column += 1;
            }
        }
        plain.push('\n');
    }
    (plain, places)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(600))]

    #[test]
    fn faults_are_found_where_they_were_put(
        one in 0..CASES.len(), other in prop::option::of(0..CASES.len()), is_flow: bool, has_remarks: bool, depth in 0..5_usize,
    ) {
        let mut put = vec![CASES[one]];
        put.extend(other.map(|other| CASES[other]).filter(|case| case.0 != CASES[one].0));
        let mut text = written(is_flow, has_remarks, depth);
        for (from, to, ..) in &put {
            prop_assert_eq!(text.matches(from).count(), 1);
            text = text.replace(from, to);
        }
        let (text, places) = unmarked(&text);
        let error = Document::parse_one("box.yaml", text.as_bytes()).unwrap().read::<GearboxFile>().unwrap_err();
        let found: Vec<_> = error
            .faults()
            .filter(|fault| fault.problem.name() != "missing-key")
            .map(|fault| (fault.at.path.to_string(), fault.problem.name(), (fault.at.position.line, fault.at.position.column)))
            .collect();
        let mut expected: Vec<_> = put.iter().map(|case| (case.2.to_owned(), case.3)).collect();
        expected.sort();
        let mut of_found: Vec<_> = found.iter().map(|(path, name, _)| (path.clone(), *name)).collect();
        of_found.sort();
        prop_assert_eq!(of_found, expected, "{}\n{}", text, error);
        prop_assert_eq!(found.iter().map(|(.., at)| *at).collect::<Vec<_>>(), places, "{}", text);
        // A key whose likely meaning is known is not reported as missing besides.
        let missing: Vec<_> = error.faults().filter(|fault| fault.problem.name() == "missing-key").collect();
        prop_assert_eq!(missing.len(), put.iter().filter(|case| !case.4.is_empty()).count(), "{}", error);
    }
}

#[test]
fn missing_keys_and_wrong_values_are_found_together() {
    let text = "gearbox: I\noutput: 3\nsets:\n- { id: P, sun: D, ring: T1, k: 3,94 }\n- { sun: D, k: a }\n";
    let document = Document::parse_one("box.yaml", text.replace("3,94", "'3,94'").as_bytes()).unwrap();
    let faults: Vec<String> = document
        .read::<GearboxFile>()
        .unwrap_err()
        .faults()
        .map(|fault| format!("{} {}", fault.at, fault.problem.name()))
        .collect();
    assert_eq!(
        faults,
        [
            "box.yaml:1:1 missing-key",
            "box.yaml:2:9: output wrong-type",
            "box.yaml:4:33: sets[0].k decimal-comma",
            "box.yaml:5:3: sets[1] missing-key",
            "box.yaml:5:3: sets[1] missing-key",
            "box.yaml:5:16: sets[1].k wrong-type",
        ]
    );
}

/// A file without faults, how it is read, and the faults put into it.
struct Sound {
    text: &'static str,
    read: fn(&Document) -> Result<(), Error>,
    cases: &'static [(&'static str, &'static str, &'static str, &'static str)],
}

const BOX: &str = "\
gearbox: II
input: D
output: B
links: [L]
sets:
  - { id: P, sun: D, ring: T1, carrier: B, k: 3 }
  - { id: Q, sun: D, ring: T2, carrier: T1, teeth: [20, 60], planets: 3 }
  - { id: R, sun: D, ring: T4, carrier: T1, teeth: [24, 66], planets: 3 }
  - { id: S, kind: stepped_suns, sun: D, ring: T5, carrier: T1, k: 2 }
compound_sets:
  - { id: C, carrier: B, suns: { D: 20 }, rings: { T3: 60 }, planet_gears: { p: [20] }, meshes: [{ gears: [D, p] }, { gears: [p, T3] }] }
brakes:
  - { id: K1, link: T1 }
  - { id: K2, link: T2, drag: { speeds: [0 rpm, 100 rpm], torques: [1 N·m, 2 N·m] } }
clutches:
  - { id: K3, links: [T1, B] }
  - { id: F, one_way: [T2, B] }
grounds: [L]
ties: [[T3, T2]]
drags:
  - { id: seal, between: [D, ground], curve: { speeds: [0 rpm, 3000 rpm], torques: [1 N·m, 3 N·m] } }
gears:
  - { name: one, engaged: [K1, K3] }
  - { name: two, engaged: [K2], input: D }
";

const LIST: &str = "\
transmissions:
- name: n_x
  sets:
  - { id: P, planet: simple, sun: X, ring: Y, carrier: Z, z_s: 20, z_r: 60, n_p: 3 }
  - { id: Q, planet: pair, gear_a: V, gear_b: W, z_a: 24, z_b: 77 }
  links: { n_x: [X, V], n_y: [Y], n_z: [Z], n_w: [W] }
  input: n_x
  output: n_z
  shift_elements: { C: [n_y, ground] }
  one_way: { F: [n_w, n_z] }
  gears:
  - { name: one, engaged: [C], published_ratio: 4.00, printed_decimals: 2 }
";

const DRIVE: &str = "\
power: 30 kW
speed: 1450 rpm
ratio: 5
teeth: { sun: 18..30, planets: 3 }
mesh_efficiency: { sun_planet: 0.97, planet_ring: 98 % }
gear_set: { module: 5 mm, face_width: 50 mm, sun_bore: 10 mm }
shafts: { sun: { diameter: 40 mm, bearing: 6310 } }
carrier: { inertia: 1 kg·m² }
parts: { sun: { mass: 3 kg }, planet: { inertia: 0.1 kg·m² } }
attached: { motor: 2 kg·m² }
start: { driving_torque: 700 N·m }
";

const DRIVE_IN_FULL: &str = "\
power: 106.5 kW
speed: 1950 rpm
ratio_tolerance: 1 %
teeth: { sun: 20, planet: 40, planets: 4, tip_gap: 0.1 }
gear_set: { module: 8 mm, face_width: 60 mm, clearance: 0.2, addendum: 1, density: 7900 kg/m³ }
shafts: { allowable_stress: 20 MPa }
carrier:
  arms: { length: 170 mm, width: 80 mm, thickness: 20 mm, hole: { radius: 30 mm, from_outer_end: 40 mm } }
  hub: { outside_radius: 105 mm, inside_radius: 95 mm, width: 50 mm }
attached: { machine: 1 kg·m² }
";

const SCENARIO: &str = "\
scenario: run up
gearbox:
  gearbox: I
  input: D
  output: B
  sets: [{ id: P, sun: D, ring: T1, carrier: B, k: 3 }]
  brakes: [{ id: K1, link: T1 }]
inertias: { D: 1 kg·m² }
engaged: [K1]
start: { input_speed: 100 rpm }
duration: 2 s
";

const MOTOR: &str = "stator: 5\nrotor: 3\nz3: 55\nzs: 10\nmodule: 2 mm\nwidth: 30 mm\n";

fn gearbox(document: &Document) -> Result<(), Error> {
    let file: GearboxFile = document.read()?;
    let built = file.gearbox().and_then(|gearbox| {
        let drags = file.drags(&gearbox);
        match file.planet_bearings(&gearbox) {
            Ok(_) => drags.map(drop),
            Err(faults) => Err(faults.and(drags.err())),
        }
    });
    built.map_err(|faults| faults.placed(document, &Path::root()))
}

fn transmission(document: &Document) -> Result<(), Error> {
    let file: TransmissionsFile = document.read()?;
    let base = Path::root().key("transmissions").index(0);
    file.transmissions[0].gearbox().map(drop).map_err(|faults| faults.placed(document, &base))
}

fn scenario(document: &Document) -> Result<(), Error> {
    let file: ScenarioFile = document.read()?;
    let gearbox = file.gearbox.unwrap().gearbox();
    gearbox.map(drop).map_err(|faults| faults.placed(document, &Path::root().key("gearbox")))
}

/// Faults of one list are found together; those of values come before the others.
const SOUND: [Sound; 12] = [
    Sound {
        text: BOX,
        read: gearbox,
        cases: &[
            ("link: T1 }", "link: @zz@ }", "brakes[0].link", "unknown"),
            ("links: [T1, B]", "links: [T1, @zz@]", "clutches[0].links[1]", "unknown"),
            ("one_way: [T2, B]", "one_way: [@zz@, B]", "clutches[1].one_way[0]", "unknown"),
            ("[T3, T2]", "[@zz@, T2]", "ties[0][0]", "unknown"),
            ("grounds: [L]", "grounds: [@zz@]", "grounds[0]", "unknown"),
            ("grounds: [L]", "grounds: [L, @L@]", "grounds[1]", "cyclic-grounds"),
            ("[K1, K3]", "[K1, @K9@]", "gears[0].engaged[1]", "unknown"),
            ("[K1, K3]", "[K1, @K1@]", "gears[0].engaged[1]", "engaged-twice"),
            ("input: D }", "input: @yy@ }", "gears[1].input", "unknown"),
            ("input: D }", "input: @ground@ }", "gears[1].input", "grounded-terminal"),
            ("output: B\n", "output: @xx@\n", "output", "unknown"),
            ("output: B\n", "output: @ground@\n", "output", "grounded-terminal"),
            ("{ id: Q", "@{ id: P@", "sets[1]", "duplicate"),
            ("{ id: C", "@{ id: R@", "compound_sets[0]", "duplicate"),
            ("{ id: F", "@{ id: K3@", "clutches[1]", "duplicate"),
            ("{ name: two", "@{ name: one@", "gears[1]", "duplicate"),
            ("k: 3", "k: @0.5@", "sets[0].k", "ring-to-sun-ratio"),
            ("k: 3", "k: 3, efficiency: @1.2@", "sets[0].efficiency", "efficiency"),
            ("k: 3", "k: 3, meshes: @[0.9]@", "sets[0].meshes", "losses"),
            ("k: 3", "k: 3, teeth: @[20, 60]@", "sets[0].teeth", "row-known-in-one-way"),
            ("[20, 60], planets: 3", "[20, @0@], planets: 3", "sets[1].teeth[1]", "no-teeth"),
            ("[20, 60], planets: 3", "[20, 60], planets: @0@", "sets[1].planets", "planet-count"),
            ("66], planets: 3", "66], planet_angles: @[0 deg, 0 deg]@", "sets[2].planet_angles", "spacing"),
            ("[24, 66]", "[24, 66], helix_angle: @80 deg@", "sets[2].helix_angle", "out-of-range"),
            ("{ id: R, sun: D, ring: T4", "@{ id: R, sun: D, ring: D@", "sets[2]", "coincident-members"),
            (
                "{ id: S, kind: stepped_suns, sun: D, ring: T5, carrier: T1, k: 2",
                "@{ id: S, kind: stepped_suns, sun: D, ring: T5, carrier: T1, teeth: [20, 30]@",
                "sets[3]",
                "steps-missing",
            ),
            ("suns: { D: 20 }", "suns: { D: @0@ }", "compound_sets[0].suns.D", "compound"),
            ("rings: { T3: 60 }", "rings: { T3: @60.5@ }", "compound_sets[0].rings.T3", "compound"),
            ("{ p: [20] }", "{ p: [@0@] }", "compound_sets[0].planet_gears.p[0]", "compound"),
            ("[D, p]", "[@zz@, p]", "compound_sets[0].meshes[0].gears[0]", "compound"),
            ("[p, T3]", "[p, @zz@]", "compound_sets[0].meshes[1].gears[1]", "compound"),
            ("{ gears: [p, T3] }", "@{ gears: [T3, D] }@", "compound_sets[0].meshes[1]", "compound"),
            (
                "gears: [p, T3]",
                "gears: [p, T3], efficiency: @2@",
                "compound_sets[0].meshes[1].efficiency",
                "efficiency",
            ),
            (
                "{ id: K3, links: [T1, B]",
                "@{ id: K3, links: [B, B]@",
                "clutches[0]",
                "shift-element-joins-itself",
            ),
            (
                "{ id: F, one_way: [T2, B]",
                "@{ id: F, one_way: [T2, B], links: [T2, B]@",
                "clutches[1]",
                "clutch",
            ),
            ("[0 rpm, 3000 rpm]", "[0 rpm, @0 rpm@]", "drags[0].curve.speeds[1]", "drag"),
            ("[1 N·m, 2 N·m]", "[1 N·m, @-2 N·m@]", "brakes[1].drag.torques[1]", "drag"),
        ],
    },
    Sound {
        text: BOX,
        read: gearbox,
        cases: &[
            ("between: [D, ground]", "between: [@zz@, ground]", "drags[0].between[0]", "unknown"),
            ("between: [D, ground]", "between: @[D, D]@", "drags[0].between", "drag"),
            ("[0 rpm, 3000 rpm]", "[0 rpm, @0 rpm@]", "drags[0].curve.speeds[1]", "drag"),
            ("[0 rpm, 100 rpm]", "[@-1 rpm@, 100 rpm]", "brakes[1].drag.speeds[0]", "drag"),
            ("{ id: seal", "@{ id: K2@", "drags[0]", "duplicate"),
            ("[20, 60]", "[20, 60], module: @-1 mm@", "sets[1].module", "not-positive"),
        ],
    },
    Sound {
        text: BOX,
        read: gearbox,
        cases: &[
            ("[20, 60]", "[20, 60], tip_alterations: @[0, 0, 0]@", "sets[1].tip_alterations", "shifts"),
            ("[24, 66]", "[24, 66], module: 1 mm, modules: @[1 mm, 1 mm]@", "sets[2].modules", "twice"),
            ("[24, 66]", "[24, 66], modules: @[1 mm]@", "sets[2].modules", "values"),
            ("[24, 66]", "[24, 66], modules: [1 mm, @2 mm@]", "sets[2].modules[1]", "two-modules"),
            (
                "meshes: [{ gears: [D, p] }, { gears: [p, T3] }]",
                "module: 1 mm, meshes: [{ gears: [D, p] }, { gears: [p, T3], module: @2 mm@ }]",
                "compound_sets[0].meshes[1].module",
                "two-modules",
            ),
            (
                "[24, 66]",
                "[24, 66], centre_distance: @60 mm@",
                "sets[2].centre_distance",
                "centre-distance-alone",
            ),
            (
                "[24, 66]",
                "[24, 66], module: 1 mm, planet_teeth: [21], profile_shifts: { sun: 0.1 }, centre_distance: 23 mm, carrier_radius: @23 mm@",
                "sets[2].carrier_radius",
                "twice",
            ),
            (
                "[24, 66]",
                "[24, 66], module: 1 mm, planet_teeth: [21], profile_shifts: { sun: 0.1 }, centre_distance: @26 mm@",
                "sets[2].centre_distance",
                "shift-follows",
            ),
            (
                "[24, 66]",
                "[24, 66], planet_teeth: [21], tip_alterations: @{ sun: -0.1 }@",
                "sets[2].tip_alterations",
                "tips-alone",
            ),
            (
                "[24, 66]",
                "[24, 66], module: 1 mm, planet_teeth: [21], centre_distance: @23 mm@",
                "sets[2].centre_distance",
                "shifts-open",
            ),
            (
                "[24, 66]",
                "[24, 66], module: 1 mm, planet_teeth: [21], profile_shifts: [0.1, 0.2, 0], centre_distance: @23 mm@",
                "sets[2].centre_distance",
                "shifts-fixed",
            ),
            (
                "{ gears: [p, T3] }",
                "{ gears: [p, T3], centre_distance: @20 mm@ }",
                "compound_sets[0].meshes[1].centre_distance",
                "centre-distance-alone",
            ),
            (
                "[24, 66]",
                "[24, 66], face_widths: { gear 1: @1 mm@ }",
                "sets[2].face_widths[\"gear 1\"]",
                "no-such-gear",
            ),
            (
                "suns: { D: 20 }",
                "suns: { D: 20 }, profile_shifts: @[0.1]@",
                "compound_sets[0].profile_shifts",
                "by-name",
            ),
            (
                "gears: [D, p]",
                "gears: [D, p], helix_angle: @80 deg@",
                "compound_sets[0].meshes[0].helix_angle",
                "out-of-range",
            ),
            (
                "gears: [p, T3]",
                "gears: [p, T3], efficiency: 99 %, friction: @0.05@",
                "compound_sets[0].meshes[1].friction",
                "twice",
            ),
        ],
    },
    Sound {
        text: LIST,
        read: transmission,
        cases: &[
            ("{ id: Q", "@{ id: P@", "transmissions[0].sets[1]", "duplicate"),
            ("F: [n_w, n_z]", "C: @[n_w, n_z]@", "transmissions[0].one_way.C", "duplicate"),
            ("ring: Y", "ring: @zz@", "transmissions[0].sets[0].ring", "member-in-no-link"),
            ("gear_b: W", "gear_b: @zz@", "transmissions[0].sets[1].gear_b", "member-in-no-link"),
            ("n_y: [Y]", "n_y: [Y, @X@]", "transmissions[0].links.n_y[1]", "member-in-two-links"),
            ("n_y: [Y]", "n_y: [Y, @Y@]", "transmissions[0].links.n_y[1]", "member-in-two-links"),
            ("z_r: 60", "z_r: @0@", "transmissions[0].sets[0].z_r", "no-teeth"),
            ("z_r: 60", "z_r: @10@", "transmissions[0].sets[0].z_r", "ring-to-sun-ratio"),
            ("n_p: 3", "n_p: @0@", "transmissions[0].sets[0].n_p", "planet-count"),
            (
                "{ id: Q, planet: pair, gear_a: V, gear_b: W, z_a: 24, z_b: 77",
                "@{ id: Q, planet: pair, gear_a: V, gear_b: W, z_a: 24@",
                "transmissions[0].sets[1]",
                "missing",
            ),
            ("C: [n_y, ground]", "C: [n_y, @zz@]", "transmissions[0].shift_elements.C[1]", "unknown"),
            ("engaged: [C]", "engaged: [@Z@]", "transmissions[0].gears[0].engaged[0]", "unknown"),
            ("input: n_x", "input: @X@", "transmissions[0].input", "unknown"),
        ],
    },
    Sound {
        text: DRIVE,
        read: |document| drive::read(document).map(drop),
        cases: &[
            ("sun: 18..30", "sun: @0..30@", "teeth.sun", "no-teeth"),
            ("planets: 3", "planets: @9..@", "teeth.planets", "range"),
            ("0.97", "@1.97@", "mesh_efficiency.sun_planet", "efficiency"),
            ("98 %", "@0 %@", "mesh_efficiency.planet_ring", "efficiency"),
            ("sun_bore: 10 mm", "sun_bore: @-10 mm@", "gear_set.sun_bore", "negative"),
            ("diameter: 40 mm", "diameter: @0 mm@", "shafts.sun.diameter", "not-positive"),
            ("bearing: 6310", "bearing: @6999@", "shafts.sun.bearing", "unknown-bearing"),
            ("power: 30 kW", "power: @0 kW@", "power", "not-positive"),
            ("ratio: 5", "ratio: @-5@", "ratio", "not-positive"),
            ("planets: 3", "planets: @9@", "teeth.planets", "planet-number"),
            ("module: 5 mm", "module: @0 mm@", "gear_set.module", "not-positive"),
            ("inertia: 1 kg·m²", "inertia: @-1 kg·m²@", "carrier.inertia", "impossible"),
            ("motor: 2 kg·m²", "motor: @-2 kg·m²@", "attached.motor", "impossible"),
            ("torque: 700 N·m", "torque: @0 N·m@", "start.driving_torque", "not-positive"),
            ("mass: 3 kg", "mass: @0 kg@", "parts.sun.mass", "not-positive"),
            ("mass: 3 kg", "mass: @-3 kg@", "parts.sun.mass", "negative"),
            ("inertia: 0.1 kg·m²", "inertia: @-1 kg·m²@", "parts.planet.inertia", "negative"),
            (
                "inertia: 1 kg·m²",
                "inertia: @1 kg·m²@, hub: { outside_radius: 1 mm, width: 1 mm }",
                "carrier.inertia",
                "carrier-twice",
            ),
        ],
    },
    Sound {
        text: DRIVE_IN_FULL,
        read: |document| drive::read(document).map(drop),
        cases: &[
            ("speed: 1950 rpm", "speed: @-1950 rpm@", "speed", "not-positive"),
            ("tolerance: 1 %", "tolerance: @100 %@", "ratio_tolerance", "tolerance"),
            ("sun: 20", "sun: @20000@", "teeth.sun", "tooth-range"),
            ("tip_gap: 0.1", "tip_gap: @-0.1@", "teeth.tip_gap", "negative"),
            ("face_width: 60 mm", "face_width: @0 mm@", "gear_set.face_width", "not-positive"),
            ("density: 7900 kg/m³", "density: @0 kg/m³@", "gear_set.density", "not-positive"),
            ("stress: 20 MPa", "stress: @0 MPa@", "shafts.allowable_stress", "not-positive"),
            ("machine: 1 kg·m²", "machine: @-1 kg·m²@", "attached.machine", "impossible"),
            ("length: 170 mm", "length: @0 mm@", "carrier.arms.length", "not-positive"),
            ("width: 80 mm", "width: @-80 mm@", "carrier.arms.width", "not-positive"),
            ("thickness: 20 mm", "thickness: @0 mm@", "carrier.arms.thickness", "not-positive"),
            ("radius: 30 mm", "radius: @0 mm@", "carrier.arms.hole.radius", "not-positive"),
            (
                "outside_radius: 105 mm",
                "outside_radius: @0 mm@",
                "carrier.hub.outside_radius",
                "not-positive",
            ),
            ("width: 50 mm", "width: @0 mm@", "carrier.hub.width", "not-positive"),
        ],
    },
    Sound {
        text: DRIVE_IN_FULL,
        read: |document| drive::read(document).map(drop),
        cases: &[
            ("clearance: 0.2", "clearance: @-0.2@", "gear_set.clearance", "negative"),
            ("addendum: 1", "addendum: @0@", "gear_set.addendum", "not-positive"),
            ("end: 40 mm", "end: @20 mm@", "carrier.arms.hole.from_outer_end", "out-of-range"),
            ("inside_radius: 95 mm", "inside_radius: @105 mm@", "carrier.hub.inside_radius", "out-of-range"),
        ],
    },
    Sound {
        text: DRIVE,
        read: |document| drive::read(document).map(drop),
        cases: &[
            ("power: 30 kW", "power: @30@", "power", "missing-unit"),
            ("ratio: 5", "ratio: @5 mm@", "ratio", "unexpected-unit"),
            ("sun: 18..30", "sun: @many@", "teeth.sun", "invalid-value"),
            ("sun_planet", "@sun_planets@", "mesh_efficiency.sun_planets", "unknown-key"),
            ("module: 5 mm", "module: @5 kg@", "gear_set.module", "wrong-dimension"),
            ("mass: 3 kg", "mass: @'3,5 kg'@", "parts.sun.mass", "decimal-comma"),
        ],
    },
    Sound {
        text: SCENARIO,
        read: scenario,
        cases: &[
            ("duration: 2 s", "duration: @2@", "duration", "missing-unit"),
            ("1 kg·m²", "@1 kg@", "inertias.D", "wrong-dimension"),
            ("engaged: [K1]", "engaged: @K1@", "engaged", "wrong-type"),
            ("input_speed: 100 rpm", "input_speed: @100@", "start.input_speed", "missing-unit"),
            ("k: 3", "k: @three@", "gearbox.sets[0].k", "wrong-type"),
        ],
    },
    Sound {
        text: SCENARIO,
        read: scenario,
        cases: &[
            ("k: 3", "k: @0.5@", "gearbox.sets[0].k", "ring-to-sun-ratio"),
            ("link: T1", "link: @zz@", "gearbox.brakes[0].link", "unknown"),
            ("input: D", "input: @xx@", "gearbox.input", "unknown"),
        ],
    },
    Sound {
        text: MOTOR,
        read: |document| motor::read(document).map(drop),
        cases: &[
            ("stator: 5", "stator: @five@", "stator", "wrong-type"),
            ("rotor: 3", "rotor: @-3@", "rotor", "out-of-range"),
            ("z3: 55", "z3: @5.5@", "z3", "wrong-type"),
            ("module: 2 mm", "module: @2@", "module", "missing-unit"),
            ("width: 30 mm", "@widht@: 30 mm", "widht", "unknown-key"),
        ],
    },
    Sound {
        text: MOTOR,
        read: |document| motor::read(document).map(drop),
        cases: &[
            ("rotor: 3", "rotor: @5@", "rotor", "lobes-not-more"),
            ("z3: 55", "z3: @54@", "z3", "teeth-per-lobe"),
            ("zs: 10", "zs: @0@", "zs", "no-teeth"),
            ("module: 2 mm", "module: @0 mm@", "module", "not-positive"),
            ("width: 30 mm", "part: @2@", "part", "out-of-range"),
        ],
    },
];

/// Faults are put in alone and in pairs of one list: exactly those are found, where they are.
#[test]
fn faults_of_all_kinds_of_files_are_found_together() {
    for Sound { text, read, cases } in SOUND {
        let faults = |text: &str| -> Vec<(String, &str, (usize, usize))> {
            let error = read(&Document::parse_one("x.yaml", text.as_bytes()).unwrap()).err();
            let found = |fault: &epicyclic_formats::Fault| {
                let position = fault.at.position;
                (fault.at.path.to_string(), fault.problem.name(), (position.line, position.column))
            };
            error.iter().flat_map(Error::faults).map(found).collect()
        };
        assert_eq!(faults(text), []);
        for (number, one) in cases.iter().enumerate() {
            for other in &cases[number..] {
                let mut put = vec![one];
                // Two changes of one place do not go together.
                if other != one {
                    if !text.replace(one.0, "").contains(other.0) {
                        continue;
                    }
                    put.push(other);
                }
                let marked = put.iter().fold(text.to_owned(), |text, case| {
                    assert_eq!(text.matches(case.0).count(), 1, "{}", case.0);
                    text.replace(case.0, case.1)
                });
                let (changed, places) = unmarked(&marked);
                let found = faults(&changed);
                let at: Vec<_> = found.iter().map(|(.., at)| *at).collect();
                assert_eq!(at, places, "{changed}{found:?}");
                let mut found: Vec<_> = found.into_iter().map(|(path, name, _)| (path, name)).collect();
                let mut expected: Vec<_> = put.iter().map(|case| (case.2.to_owned(), case.3)).collect();
                found.sort();
                expected.sort();
                assert_eq!(found, expected, "{changed}");
            }
        }
    }
}
