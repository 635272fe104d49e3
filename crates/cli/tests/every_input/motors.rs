//! Every key of a hydromotor's file.

use super::common::{examples, here, output, text};
use super::{replaced, schema};
use serde_json::Value;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// A key with another value; the file is changed first where the key asks for it.
struct Key {
    path: &'static str,
    first: &'static [(&'static str, &'static str)],
    from: &'static str,
    to: &'static str,
}

const fn key(path: &'static str, from: &'static str, to: &'static str) -> Key {
    Key { path, first: &[], from, to }
}

/// The middle of the family and ideal ports, for other numbers.
const MIDDLE: &[(&str, &str)] = &[("\nl: 80 mm", "\npart: 0.5"), (HIGH, "part: 0.9"), (LOW, "")];
const BY_PART: &[(&str, &str)] = &[("\nl: 80 mm", "\npart: 0.4")];
const BY_CREST: &[(&str, &str)] = &[("\nl: 80 mm", "\na: 40 mm")];
/// Numbers with which a cosine law closes.
const COSINE: &[(&str, &str)] = &[
    ("stator: 6\nrotor: 4\nz3: 66", "stator: 8\nrotor: 6\nz3: 88"),
    ("law: arcs", "law: cosine"),
    ("\nl: 80 mm", "\nsecond_harmonic: 0.002"),
    (HIGH, "part: 0.9"),
    (LOW, ""),
];
/// Numbers with which both laws close, without a place in the family.
const EITHER: &[(&str, &str)] = &[
    ("stator: 6\nrotor: 4\nz3: 66", "stator: 8\nrotor: 6\nz3: 88"),
    ("law: arcs", "law: cosine"),
    ("\nl: 80 mm", ""),
    (HIGH, "part: 0.9"),
    (LOW, ""),
];
const DYNAMIC: &[(&str, &str)] = &[("  viscosity: 46 mm²/s", "  dynamic_viscosity: 40 mPa·s")];
/// A fluid so thin that the flow is turbulent.
const WATER: &[(&str, &str)] =
    &[("  viscosity: 46 mm²/s", "  viscosity: 0.4 mm²/s"), ("satellites: 20 µm", "satellites: 300 µm")];
const HIGH: &str = "high: { angle: -15 deg, diameter: 12 mm, pitch_radius: 52 mm }";
const LOW: &str = "  low: # a kidney; else high mirrored in the crest\n    angle: 15 deg\n    inner_radius: 48 mm\n    outer_radius: 56 mm\n    span: 12 deg\n    corner_radius: 3 mm # else round ends\n";
/// A kidney at high pressure and a hole at low.
const OTHER_PORTS: &[(&str, &str)] = &[
    (
        HIGH,
        "high: { angle: -15 deg, inner_radius: 48 mm, outer_radius: 56 mm, span: 12 deg, corner_radius: 3 mm }",
    ),
    (LOW, "  low: { angle: 15 deg, diameter: 12 mm, pitch_radius: 52 mm }\n"),
];
const IDEAL: &[(&str, &str)] = &[(HIGH, "part: 0.9"), (LOW, "")];

const KEYS: &[Key] = &[
    key("title", "title: every key once", "title: each key"),
    Key { path: "stator", first: MIDDLE, from: "stator: 6", to: "stator: 3" },
    Key { path: "rotor", first: MIDDLE, from: "rotor: 4", to: "rotor: 3" },
    Key { path: "z3", first: MIDDLE, from: "z3: 66", to: "z3: 72" },
    key("zs", "zs: 10", "zs: 9"),
    key("module", "module: 2 mm", "module: 2.1 mm"),
    Key { path: "law", first: EITHER, from: "law: cosine", to: "law: arcs" },
    Key {
        path: "second_harmonic",
        first: COSINE,
        from: "second_harmonic: 0.002",
        to: "second_harmonic: 0.004",
    },
    key("l", "l: 80 mm", "l: 82 mm"),
    Key { path: "a", first: BY_CREST, from: "a: 40 mm", to: "a: 40.2 mm" },
    Key { path: "part", first: BY_PART, from: "part: 0.4", to: "part: 0.5" },
    key("width", "width: 40 mm", "width: 42 mm"),
    key("pressure", "pressure: 20 MPa", "pressure: 21 MPa"),
    key("speed", "speed: 100 rpm", "speed: 110 rpm"),
    key("angle", "\nangle: 7 deg", "\nangle: 9 deg"),
    key("teeth.pressure_angle", "pressure_angle: 25 deg", "pressure_angle: 24 deg"),
    key("teeth.addendum", "addendum: 0.85", "addendum: 0.8"),
    key("teeth.clearance", "clearance: 0.25", "clearance: 0.2"),
    key("teeth.shift", "shift: 0.2", "shift: 0.15"),
    key("teeth.backlash", "backlash: 0.04", "backlash: 0.05"),
    key("teeth.fillet", "fillet: 0.1", "fillet: 0.12"),
    key("material.youngs_modulus", "youngs_modulus: 206 GPa", "youngs_modulus: 170 GPa"),
    key("material.poissons_ratio", "poissons_ratio: 0.3", "poissons_ratio: 0.28"),
    key("material.contact_limit", "contact_limit: 2000 MPa", "contact_limit: 1900 MPa"),
    key("material.root_limit", "root_limit: 400 MPa", "root_limit: 300 MPa"),
    key("oil.viscosity", "viscosity: 46 mm²/s", "viscosity: 40 mm²/s"),
    Key {
        path: "oil.dynamic_viscosity",
        first: DYNAMIC,
        from: "dynamic_viscosity: 40 mPa·s",
        to: "dynamic_viscosity: 36 mPa·s",
    },
    key("oil.density", "density: 870 kg/m³", "density: 900 kg/m³"),
    key("oil.bulk_modulus", "bulk_modulus: 1.4 GPa", "bulk_modulus: 1.6 GPa"),
    Key { path: "oil.turbulence.factor", first: WATER, from: "factor: 0.3", to: "factor: 0.4" },
    Key { path: "oil.turbulence.exponent", first: WATER, from: "exponent: 0.25", to: "exponent: 0.3" },
    key("gaps.satellites", "satellites: 20 µm", "satellites: 22 µm"),
    key("gaps.rotor", "rotor: 15 µm", "rotor: 16 µm"),
    key("gaps.rotor_bore", "rotor_bore: 30 mm", "rotor_bore: 35 mm"),
    key("gaps.expansion", "expansion: 12e-6 /K", "expansion: 11e-6 /K"),
    key("gaps.temperature_rise", "temperature_rise: 20 K", "temperature_rise: 10 K"),
    key("friction", "friction: 0.05..0.1", "friction: 0.05..0.12"),
    Key { path: "ports.part", first: IDEAL, from: "  part: 0.9", to: "  part: 0.8" },
    key("ports.high.angle", "angle: -15 deg", "angle: -15.2 deg"),
    key("ports.high.diameter", "diameter: 12 mm", "diameter: 11.5 mm"),
    key("ports.high.pitch_radius", "pitch_radius: 52 mm", "pitch_radius: 52.2 mm"),
    Key {
        path: "ports.high.inner_radius",
        first: OTHER_PORTS,
        from: "inner_radius: 48 mm",
        to: "inner_radius: 48.5 mm",
    },
    Key {
        path: "ports.high.outer_radius",
        first: OTHER_PORTS,
        from: "outer_radius: 56 mm",
        to: "outer_radius: 55.5 mm",
    },
    Key { path: "ports.high.span", first: OTHER_PORTS, from: "span: 12 deg", to: "span: 11 deg" },
    Key {
        path: "ports.high.corner_radius",
        first: OTHER_PORTS,
        from: "corner_radius: 3 mm",
        to: "corner_radius: 2 mm",
    },
    key("ports.low.angle", "    angle: 15 deg", "    angle: 15.2 deg"),
    Key { path: "ports.low.diameter", first: OTHER_PORTS, from: "diameter: 12 mm", to: "diameter: 11.5 mm" },
    Key {
        path: "ports.low.pitch_radius",
        first: OTHER_PORTS,
        from: "pitch_radius: 52 mm",
        to: "pitch_radius: 52.2 mm",
    },
    key("ports.low.inner_radius", "inner_radius: 48 mm", "inner_radius: 48.5 mm"),
    key("ports.low.outer_radius", "outer_radius: 56 mm", "outer_radius: 55.5 mm"),
    key("ports.low.span", "span: 12 deg", "span: 11 deg"),
    key("ports.low.corner_radius", "corner_radius: 3 mm", "corner_radius: 2 mm"),
    key("ports.dead_volume", "dead_volume: 300 mm³", "dead_volume: 500 mm³"),
    key("ports.discharge", "discharge: 0.7", "discharge: 0.6"),
    key("ports.most_trapped", "most_trapped: 5 MPa", "most_trapped: 0.1 MPa"),
];

/// What is told of a motor, without its file; or why it is refused.
fn seen(folder: &Path, file: &str) -> Result<Value, String> {
    fs::write(folder.join("motor.yaml"), file).unwrap();
    let output = output(folder, &["report", "motor.yaml", "--format", "json"]);
    if !output.status.success() {
        return Err(text(&output.stderr));
    }
    let mut answer: Value = serde_json::from_slice(&output.stdout).unwrap();
    answer.as_object_mut().unwrap().remove("file");
    Ok(answer)
}

#[test]
fn every_key_of_a_motor_changes_its_answer() {
    let example = fs::read_to_string(examples().join("every-motor-key.yaml")).unwrap();
    let folder = here();
    let mut faults = vec![];
    for key in KEYS {
        let plain = key.first.iter().fold(example.clone(), |file, (from, to)| replaced(&file, from, to));
        let before = seen(folder.path(), &plain);
        let after = seen(folder.path(), &replaced(&plain, key.from, key.to));
        match (before, after) {
            (Ok(before), Ok(after)) if before != after => {}
            (Ok(_), Ok(_)) => faults.push(format!("{} changes nothing: {} → {}", key.path, key.from, key.to)),
            (Err(error), _) => faults.push(format!("{}: before {}: {error}", key.path, key.to)),
            (_, Err(error)) => faults.push(format!("{}: {}: {error}", key.path, key.to)),
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn no_key_of_a_motor_is_left_out() {
    let tried: BTreeSet<String> = KEYS.iter().map(|key| key.path.to_owned()).collect();
    assert_eq!(tried, schema("motor"));
}
