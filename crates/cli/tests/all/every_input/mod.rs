//! Every key of a file and every option of a command changes the answer.
//!
//! The keys are those of the schemas, the options those of the help, so that no new one can be forgotten
//! here. Drives are in this file, gearboxes and transmissions in `gearboxes`, options in `options`.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use crate::common;
mod gearboxes;
mod keys;
mod motors;
mod options;
mod scenarios;

use common::{examples, here, output, text};
use keys::{Key, after, check, key, paths, replaced};
use serde_json::Value;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

const ARMS_AND_HUB: &str = "  arms: # one for each planet\n    length: 161 mm # from the hub's outside\n    width: 80 mm\n    thickness: 10 mm\n    hole: { radius: 30 mm, from_outer_end: 50 mm } # else none\n  hub: { outside_radius: 105 mm, inside_radius: 95 mm, width: 50 mm } # inside_radius: else 0\n";

const KEYS: &[Key] = &[
    key("title", "title: every key once", "title: another"),
    key("power", "power: 106.5 kW", "power: 100 kW"),
    key("speed", "speed: 1950 rpm", "speed: 1900 rpm"),
    key("ratio", "ratio: 6", "ratio: 5"),
    // Tooth numbers given in full miss the ratio slightly; the tolerance decides whether that is too much.
    after(
        &[
            ("sun: 17..200", "sun: 20"),
            ("planet: 17..200", "planet: 40"),
            ("ring: 12..200", "ring: 100"),
            ("planets: 3..8", "planets: 4"),
            ("ratio: 6", "ratio: 6.1"),
        ],
        "ratio_tolerance",
        "ratio_tolerance: 1 %",
        "ratio_tolerance: 3 %",
    ),
    key("teeth.sun", "sun: 17..200", "sun: 20..200"),
    key("teeth.planet", "planet: 17..200", "planet: 40..200"),
    key("teeth.ring", "ring: 12..200", "ring: 100..200"),
    key("teeth.planets", "planets: 3..8", "planets: 3"),
    // 20, 23 and 66 teeth give 4.3 and do not take four planets at equal angles.
    after(
        &[("ratio: 6", "ratio: 4.3"), ("planets: 3..8", "planets: 4")],
        "teeth.spacing",
        "spacing: equal",
        "spacing: least-unequal",
    ),
    key("teeth.tip_gap", "tip_gap: 0", "tip_gap: 0.3"),
    key("mesh_efficiency.sun_planet", "sun_planet: 0.97", "sun_planet: 0.98"),
    key("mesh_efficiency.planet_ring", "planet_ring: 0.98", "planet_ring: 0.99"),
    key("mesh_efficiency.planet_bearings", "planet_bearings: 1 ", "planet_bearings: 0.99 "),
    key("parts.sun.mass", "mass: 8.2 kg", "mass: 8.3 kg"),
    key("parts.sun.inertia", "inertia: 0.0267 kg", "inertia: 0.027 kg"),
    key("parts.planet.mass", "mass: 30.9 kg", "mass: 31 kg"),
    key("parts.planet.inertia", "inertia: 0.464 kg", "inertia: 0.47 kg"),
    key("parts.carrier.mass", "mass: 6.1 kg", "mass: 6.2 kg"),
    key("parts.carrier.inertia", "inertia: 0.15 kg", "inertia: 0.16 kg"),
    key("gear_set.module", "module: 8 mm", "module: 9 mm"),
    key("gear_set.face_width", "face_width: 60 mm", "face_width: 70 mm"),
    key("gear_set.addendum", "addendum: 1 ", "addendum: 0.9 "),
    key("gear_set.clearance", "clearance: 0.25", "clearance: 0.2"),
    key("gear_set.pressure_angle", "pressure_angle: 20 deg", "pressure_angle: 25 deg"),
    key("gear_set.pressure_angle", "pressure_angle: 20 deg", "pressure_angle: 14.5 deg"),
    key("gear_set.density", "density: 7850 kg/m³", "density: 7800 kg/m³"),
    key("gear_set.sun_bore", "sun_bore: shaft", "sun_bore: 20 mm"),
    key("gear_set.planet_bore", "planet_bore: bearing", "planet_bore: shaft"),
    key("shafts.allowable_stress", "allowable_stress: 20 MPa", "allowable_stress: 18 MPa"),
    key("shafts.bearing_series", "bearing_series: 300", "bearing_series: 200"),
    key("shafts.sun.diameter", "sun: { diameter: 53 mm }", "sun: { diameter: 55 mm }"),
    key("shafts.sun.bearing", "sun: { diameter: 53 mm }", "sun: { diameter: 53 mm, bearing: 312 }"),
    key("shafts.planet.diameter", "planet: { bearing: 314 }", "planet: { bearing: 314, diameter: 65 mm }"),
    key("shafts.planet.bearing", "planet: { bearing: 314 }", "planet: { bearing: 315 }"),
    key("shafts.carrier.diameter", "carrier: { diameter: 95 mm,", "carrier: { diameter: 94 mm,"),
    key("shafts.carrier.bearing", "bearing: 319", "bearing: 320"),
    after(
        &[(ARMS_AND_HUB, "  inertia: 0.171 kg·m²\n")],
        "carrier.inertia",
        "  inertia: 0.171 kg·m²\n",
        "  inertia: 0.2 kg·m²\n",
    ),
    key("carrier.arms.length", "length: 161 mm", "length: 162 mm"),
    key("carrier.arms.width", "width: 80 mm", "width: 81 mm"),
    key("carrier.arms.thickness", "thickness: 10 mm", "thickness: 11 mm"),
    key("carrier.arms.hole.radius", "hole: { radius: 30 mm", "hole: { radius: 29 mm"),
    key("carrier.arms.hole.from_outer_end", "from_outer_end: 50 mm", "from_outer_end: 51 mm"),
    key("carrier.hub.outside_radius", "outside_radius: 105 mm", "outside_radius: 106 mm"),
    key("carrier.hub.inside_radius", "inside_radius: 95 mm", "inside_radius: 94 mm"),
    key("carrier.hub.width", "width: 50 mm }", "width: 51 mm }"),
    key("attached.motor", "motor: 0 kg·m²", "motor: 0.1 kg·m²"),
    key("attached.machine", "machine: 0 kg·m²", "machine: 5 kg·m²"),
    key("start.driving_torque", "driving_torque: 600 N·m", "driving_torque: 610 N·m"),
    key("start.load", "load: 2400 N·m", "load: 2300 N·m"),
];

/// Results for a drive.
fn drive(folder: &Path, file: &str) -> String {
    fs::write(folder.join("drive.yaml"), file).unwrap();
    let output = output(folder, &["drive", "drive.yaml", "--format", "json"]);
    assert!(output.status.success(), "{}", text(&output.stderr));
    text(&output.stdout)
}

#[test]
fn every_key_of_a_drive_changes_its_answer() {
    let example = fs::read_to_string(examples().join("every-drive-key.yaml")).unwrap();
    let folder = here();
    check(&example, KEYS, |file, ()| Ok(drive(folder.path(), file)));
}

/// A set given in full keeps what was asked of its spacing and its gap.
#[test]
fn every_key_of_teeth_given_in_full_changes_the_answer() {
    let example = fs::read_to_string(examples().join("every-drive-key.yaml")).unwrap();
    let given = [
        ("sun: 17..200", "sun: 23"),
        ("planet: 17..200", "planet: 40"),
        ("ring: 12..200", "ring: 103"),
        ("planets: 3..8", "planets: 4"),
    ];
    let before = given.into_iter().fold(example, |file, (from, to)| replaced(&file, from, to));
    let folder = here();
    let plain = drive(folder.path(), &before);
    for (from, to) in [("spacing: equal", "spacing: least-unequal"), ("tip_gap: 0", "tip_gap: 2")] {
        assert!(plain != drive(folder.path(), &replaced(&before, from, to)), "{to} changes nothing");
    }
}

/// Paths of the values that a schema allows.
fn leaves(root: &Value, schema: &Value, at: &str, into: &mut BTreeSet<String>) {
    if let Some(name) = schema.get("$ref").and_then(Value::as_str) {
        let name = name.rsplit('/').next().unwrap();
        return leaves(root, &root["$defs"][name], at, into);
    }
    if let Some(any) = schema.get("anyOf").and_then(Value::as_array) {
        for one in any.iter().filter(|one| one.get("type") != Some(&Value::from("null"))) {
            leaves(root, one, at, into);
        }
        return;
    }
    let below = |key: &str| schema.get(key).filter(|below| below.is_object());
    match schema.get("properties").and_then(Value::as_object) {
        Some(properties) => {
            for (name, schema) in properties {
                let at = if at.is_empty() { name.clone() } else { format!("{at}.{name}") };
                leaves(root, schema, &at, into);
            }
        }
        // The entries of a list or a map have the path of the list.
        None => match below("items").or_else(|| below("additionalProperties")) {
            Some(held) => leaves(root, held, at, into),
            None => _ = into.insert(at.to_owned()),
        },
    }
}

/// Paths of the schema that the program prints.
fn schema(of: &str) -> BTreeSet<String> {
    let schema = output(here().path(), &["schema", of]);
    let schema: Value = serde_json::from_slice(&schema.stdout).unwrap();
    let mut all = BTreeSet::new();
    leaves(&schema, &schema, "", &mut all);
    all
}

#[test]
fn no_key_is_left_out() {
    assert_eq!(paths(KEYS), schema("drive"));
}
