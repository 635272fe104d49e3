//! Every key of a hydromotor's file.

use super::common::{examples, here, output, text};
use super::keys::{Changes, Key, after, check, key, paths};
use super::schema;
use serde_json::Value;
use std::fs;
use std::path::Path;

/// The middle of the family without ports, for other numbers.
const MIDDLE: Changes = &[("\nl: 80 mm", "\npart: 0.5"), ("z3: 66\nzs: 10", "z3: 84\nzs: 12"), (PORTS, "")];
const BY_PART: Changes = &[("\nl: 80 mm", "\npart: 0.4")];
const BY_CREST: Changes = &[("\nl: 80 mm", "\na: 40 mm")];
/// Numbers with which a cosine law closes.
const COSINE: Changes = &[
    ("stator: 6\nrotor: 4\nz3: 66", "stator: 8\nrotor: 6\nz3: 88"),
    ("law: arcs", "law: cosine"),
    ("\nl: 80 mm", "\nsecond_harmonic: 0.002"),
    (HIGH, "part: 0.9"),
    (LOW, ""),
];
/// Numbers with which both laws close, without a place in the family.
const EITHER: Changes = &[
    ("stator: 6\nrotor: 4\nz3: 66", "stator: 8\nrotor: 6\nz3: 88"),
    ("law: arcs", "law: cosine"),
    ("\nl: 80 mm", ""),
    (HIGH, "part: 0.9"),
    (LOW, ""),
];
const DYNAMIC: Changes = &[("  viscosity: 46 mm²/s", "  dynamic_viscosity: 40 mPa·s")];
/// A fluid so thin that the flow is turbulent.
const WATER: Changes =
    &[("  viscosity: 46 mm²/s", "  viscosity: 0.4 mm²/s"), ("satellites: 20 µm", "satellites: 300 µm")];
const PORTS: &str = "ports: # a port of each pressure at every crest; or part: 0.9 of the greatest round holes\n  high: { angle: -15 deg, diameter: 12 mm, pitch_radius: 52 mm }\n  low: # a kidney; else high mirrored in the crest\n    angle: 15 deg\n    inner_radius: 48 mm\n    outer_radius: 56 mm\n    span: 12 deg\n    corner_radius: 3 mm # else round ends\n  dead_volume: 300 mm³ # of each chamber\n  discharge: 0.7 # coefficient of the openings; else no throttling\n  most_trapped: 5 MPa # else no warning\n";
const HIGH: &str = "high: { angle: -15 deg, diameter: 12 mm, pitch_radius: 52 mm }";
const LOW: &str = "  low: # a kidney; else high mirrored in the crest\n    angle: 15 deg\n    inner_radius: 48 mm\n    outer_radius: 56 mm\n    span: 12 deg\n    corner_radius: 3 mm # else round ends\n";
/// A kidney at high pressure and a hole at low.
const OTHER_PORTS: Changes = &[
    (
        HIGH,
        "high: { angle: -15 deg, inner_radius: 48 mm, outer_radius: 56 mm, span: 12 deg, corner_radius: 3 mm }",
    ),
    (LOW, "  low: { angle: 15 deg, diameter: 12 mm, pitch_radius: 52 mm }\n"),
];
const IDEAL: Changes = &[(HIGH, "part: 0.9"), (LOW, "")];

const KEYS: &[Key] = &[
    key("title", "title: every key once", "title: each key"),
    after(MIDDLE, "stator", "stator: 6", "stator: 7"),
    after(MIDDLE, "rotor", "rotor: 4", "rotor: 3"),
    after(MIDDLE, "z3", "z3: 84", "z3: 90"),
    key("zs", "zs: 10", "zs: 9"),
    key("module", "module: 2 mm", "module: 2.1 mm"),
    after(EITHER, "law", "law: cosine", "law: arcs"),
    after(COSINE, "second_harmonic", "second_harmonic: 0.002", "second_harmonic: 0.004"),
    key("l", "l: 80 mm", "l: 82 mm"),
    after(BY_CREST, "a", "a: 40 mm", "a: 40.2 mm"),
    after(BY_PART, "part", "part: 0.4", "part: 0.5"),
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
    key("teeth.crest", "crest: space", "crest: tooth"),
    key("material.youngs_modulus", "youngs_modulus: 206 GPa", "youngs_modulus: 170 GPa"),
    key("material.poissons_ratio", "poissons_ratio: 0.3", "poissons_ratio: 0.28"),
    key("material.contact_limit", "contact_limit: 2000 MPa", "contact_limit: 1900 MPa"),
    key("material.root_limit", "root_limit: 400 MPa", "root_limit: 300 MPa"),
    key("oil.viscosity", "viscosity: 46 mm²/s", "viscosity: 40 mm²/s"),
    after(DYNAMIC, "oil.dynamic_viscosity", "dynamic_viscosity: 40 mPa·s", "dynamic_viscosity: 36 mPa·s"),
    key("oil.density", "density: 870 kg/m³", "density: 900 kg/m³"),
    key("oil.bulk_modulus", "bulk_modulus: 1.4 GPa", "bulk_modulus: 1.6 GPa"),
    after(WATER, "oil.turbulence.factor", "factor: 0.3", "factor: 0.4"),
    after(WATER, "oil.turbulence.exponent", "exponent: 0.25", "exponent: 0.3"),
    key("gaps.satellites", "satellites: 20 µm", "satellites: 22 µm"),
    key("gaps.rotor", "rotor: 15 µm", "rotor: 16 µm"),
    key("gaps.rotor_bore", "rotor_bore: 30 mm", "rotor_bore: 35 mm"),
    key("gaps.expansion", "expansion: 12e-6 /K", "expansion: 11e-6 /K"),
    key("gaps.temperature_rise", "temperature_rise: 20 K", "temperature_rise: 10 K"),
    key("friction", "friction: 0.05..0.1", "friction: 0.05..0.12"),
    after(IDEAL, "ports.part", "  part: 0.9", "  part: 0.8"),
    key("ports.high.angle", "angle: -15 deg", "angle: -15.2 deg"),
    key("ports.high.diameter", "diameter: 12 mm", "diameter: 11.5 mm"),
    key("ports.high.pitch_radius", "pitch_radius: 52 mm", "pitch_radius: 52.2 mm"),
    after(OTHER_PORTS, "ports.high.inner_radius", "inner_radius: 48 mm", "inner_radius: 48.5 mm"),
    after(OTHER_PORTS, "ports.high.outer_radius", "outer_radius: 56 mm", "outer_radius: 55.5 mm"),
    after(OTHER_PORTS, "ports.high.span", "span: 12 deg", "span: 11 deg"),
    after(OTHER_PORTS, "ports.high.corner_radius", "corner_radius: 3 mm", "corner_radius: 2 mm"),
    key("ports.low.angle", "    angle: 15 deg", "    angle: 15.2 deg"),
    after(OTHER_PORTS, "ports.low.diameter", "diameter: 12 mm", "diameter: 11.5 mm"),
    after(OTHER_PORTS, "ports.low.pitch_radius", "pitch_radius: 52 mm", "pitch_radius: 52.2 mm"),
    key("ports.low.inner_radius", "inner_radius: 48 mm", "inner_radius: 48.5 mm"),
    key("ports.low.outer_radius", "outer_radius: 56 mm", "outer_radius: 55.5 mm"),
    key("ports.low.span", "span: 12 deg", "span: 11 deg"),
    key("ports.low.corner_radius", "corner_radius: 3 mm", "corner_radius: 2 mm"),
    key("ports.dead_volume", "dead_volume: 300 mm³", "dead_volume: 500 mm³"),
    key("ports.discharge", "discharge: 0.7", "discharge: 0.6"),
    key("ports.most_trapped", "most_trapped: 5 MPa", "most_trapped: 0.1 MPa"),
];

/// Results for a motor without its file, or the reason why it is refused.
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
    check(&example, KEYS, |file, ()| seen(folder.path(), file));
}

#[test]
fn no_key_of_a_motor_is_left_out() {
    assert_eq!(paths(KEYS), schema("motor"));
}
