//! The command `motor forms` from outside: its answers, its refusals, and that what it lists is what `motor`
//! calculates.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "helpers of tests, which clippy does not know for such"
)]

use crate::common;

use common::{here, output, text};
use serde_json::Value;

/// Few motors and forms.
const SMALL: &str = "motor forms --torque 600N·m --pressure 20MPa --stator 6 --z3 66 --zs 10 --module 2mm --places 4 --pressure-angle 25deg --addendum 0.8..0.85/2";

/// Steels with limits, so that the allowed pressure follows.
const STEEL: [&str; 4] = ["--contact-limit", "1500 MPa", "--root-limit", "400 MPa"];

fn with<'a>(more: &[&'a str]) -> Vec<&'a str> {
    SMALL.split(' ').chain(more.iter().copied()).collect()
}

fn json(more: &[&str]) -> Value {
    let done = output(here().path(), &with(&[more, &["--format", "json"]].concat()));
    assert!(done.status.success(), "{}", text(&done.stderr));
    serde_json::from_slice(&done.stdout).unwrap()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

/// Motors times forms are the points of refused motors, those refused, left out and admissible.
#[test]
fn every_point_of_the_space_is_told() {
    let answer = json(&["--shift", "0..0.3/4", "--ripple", "8 %", "--outer-diameter", "140 mm"]);
    let funnel = &answer["funnel"];
    let count = |key: &str| funnel[key].as_u64().unwrap();
    let sum = |list: &str, key: &str| -> u64 {
        funnel[list].as_array().unwrap().iter().map(|one| one[key].as_u64().unwrap()).sum()
    };
    // Two addenda, four shifts, two crests.
    assert_eq!(count("forms"), 16);
    assert_eq!(count("points"), count("motors") * 16);
    assert_eq!(count("points_of_refused_motors"), sum("motors_refused", "motors") * 16);
    let parts =
        [count("points_of_refused_motors"), sum("refused", "points"), count("as_good"), count("admissible")];
    assert_eq!(parts.iter().sum::<u64>(), count("points"));
    assert!(parts.iter().all(|part| *part > 0), "{parts:?}");
    assert_eq!(count("front"), answer["found"].as_u64().unwrap());
}

/// A design is the motor that `motor` makes of its numbers, place, form and size, with the same flanks.
#[test]
fn a_design_is_what_motor_calculates() {
    for crest in ["space", "tooth"] {
        designs_are_what_motor_calculates(crest);
    }
}

fn designs_are_what_motor_calculates(crest: &str) {
    let asked = ["--shift", "0.1..0.3/3", "--families", "arcs", "--crests", crest, "--exact"];
    let objectives = ["--objectives", "volume, ripple, contact-ratio, flank-ripple, allowed-pressure"];
    let answer = json(&[&asked[..], &STEEL, &objectives].concat());
    let designs = answer["designs"].as_array().unwrap();
    for design in designs.iter().take(3) {
        let words = |value: f64, unit: &str| format!("{value:?} {unit}").trim().to_owned();
        let whole = |key: &str| design[key].as_u64().unwrap().to_string();
        let (form, size) = (&design["form"], &design["size"]);
        let line = [
            ("--stator", whole("stator_lobes")),
            ("--rotor", whole("rotor_lobes")),
            ("--z3", whole("stator_teeth")),
            ("--zs", whole("satellite_teeth")),
            ("--module", words(number(&size["module_m"]), "m")),
            ("--l", words(number(&size["l_m"]), "m")),
            ("--width", words(number(&size["width_m"]), "m")),
            ("--pressure", "20 MPa".to_owned()),
            ("--pressure-angle", words(number(&form["pressure_angle_rad"]), "rad")),
            ("--addendum", words(number(&form["addendum"]), "")),
            ("--shift", words(number(&form["shift"]), "")),
            ("--crest", form["crest"].as_str().unwrap().to_owned()),
            ("--material", "contact_limit: 1500 MPa, root_limit: 400 MPa".to_owned()),
            ("--format", "json".to_owned()),
        ];
        let line: Vec<&str> = line.iter().flat_map(|(option, value)| [*option, value]).collect();
        let done = output(here().path(), &[&["motor"][..], &line].concat());
        assert!(done.status.success(), "{}", text(&done.stderr));
        let motor: Value = serde_json::from_slice(&done.stdout).unwrap();
        let near = |one: &Value, other: &Value| {
            let (one, other) = (number(one), number(other));
            assert!((one / other - 1.0).abs() < 1e-6, "{one} {other}: {design}");
        };
        let (own, flanks) = (&design["flanks"], &motor["flanks"]);
        near(&motor["size"]["displacement_by_volume"], &design["displacement_by_volume"]);
        near(&motor["size"]["stator_outer_m"], &size["outer_diameter_m"]);
        near(&motor["work"]["ripple"], &design["ripple"]);
        near(&motor["work"]["displacement_m3"], &size["displacement_m3"]);
        near(&motor["work"]["torque_n_m"], &size["torque_n_m"]);
        near(&motor["work"]["least_torque_n_m"], &size["least_torque_n_m"]);
        near(&flanks["ripple"], &own["ripple"]);
        near(&flanks["least_over_mean"], &own["least_over_mean"]);
        near(&flanks["allowed"]["on_path_pa"], &own["allowed"]["on_path_pa"]);
        let greatest = |list: &str, keys: &[&str]| {
            let all = flanks[list].as_array().unwrap();
            let figures = all.iter().flat_map(|one| keys.iter().filter_map(|key| one[key].as_f64()));
            Value::from(figures.fold(0.0, f64::max))
        };
        near(&greatest("contact", &["at_pitch_point_pa", "on_path_pa"]), &own["contact_on_path_pa"]);
        near(&greatest("roots", &["on_path_pa"]), &own["root_on_path_pa"]);
        let limits = motor["tooth_limits"].as_array().unwrap();
        assert!(limits.iter().all(|limit| limit["verdict"] != "fails"), "{limits:?}");
        let ratio = limits
            .iter()
            .filter(|limit| limit["limit"] == "contact_path")
            .map(|limit| number(&limit["value_m"]) / number(&limit["bound_m"]))
            .fold(f64::INFINITY, f64::min);
        near(&Value::from(ratio), &design["contact_ratio"]);
    }
    assert!(designs.len() > 1, "{crest} {designs:?}");
}

/// Stresses are those of the modulus, whatever the limits.
#[test]
fn stresses_do_not_depend_on_the_limits() {
    let alone = json(&["--shift", "0.2", "--limit", "1"]);
    let limited = json(&[&["--shift", "0.2", "--limit", "1"][..], &STEEL].concat());
    let [alone, limited] = [&alone, &limited].map(|answer| &answer["designs"][0]["flanks"]);
    for key in ["contact_on_path_pa", "root_on_path_pa"] {
        assert!((number(&alone[key]) / number(&limited[key]) - 1.0).abs() < 1e-9, "{key}");
    }
    assert!(alone["allowed"].is_null() && limited["allowed"].is_object());
}

#[test]
fn every_family_is_drawn() {
    // Numbers with which the cosine law has a motor, too.
    let numbers =
        "motor forms --displacement 250cm3/rev --stator 5 --rotor 4 --z3 110 --zs 10 --places 4 --view teeth";
    for family in ["arcs", "cosine", "second-harmonic"] {
        let folder = here();
        let files = ["--families", family, "--svg", "teeth.svg", "--csv", "a.csv"];
        let line: Vec<&str> = numbers.split(' ').chain(files).collect();
        let done = output(folder.path(), &line);
        assert!(done.status.success(), "{family}: {}", text(&done.stderr));
        let svg = std::fs::read_to_string(folder.path().join("teeth.svg")).unwrap();
        assert!(svg.contains("<svg") && folder.path().join("a.csv").exists(), "{family}");
    }
}

/// A saved design has the figures of the search, for every family, with and without a material.
#[test]
fn a_saved_design_has_the_figures_of_the_search() {
    let numbers = "motor forms --stator 5 --rotor 4 --z3 110 --zs 10 --places 4 --crests tooth --pressure-angle 25deg --addendum 0.7..0.8/2 \
                   --shift 0.1..0.4/4 --fillet 0.12 --backlash 0.05 --clearance 0.2 --format json --save saved.yaml";
    let duty = ["--torque", "600 N·m", "--pressure", "20 MPa", "--speed", "60 rpm"];
    let displacement = ["--displacement", "250 cm3/rev"];
    for (family, design, wanted) in [
        ("arcs", "1", [&duty[..], &STEEL].concat()),
        ("arcs", "1", displacement.to_vec()),
        ("cosine", "1", displacement.to_vec()),
        (
            "second-harmonic",
            "1",
            [&duty[..], &["--youngs-modulus", "200 GPa", "--poissons-ratio", "0.28"]].concat(),
        ),
    ] {
        let folder = here();
        let asked = ["--families", family, "--design", design, "--exact"];
        let line: Vec<&str> = numbers.split_whitespace().chain(asked).chain(wanted).collect();
        saved_as_told(folder.path(), &line, design);
        let page = output(folder.path(), &["report", "saved.yaml", "-o", "page.html"]);
        assert!(page.status.success(), "{}", text(&page.stderr));
    }
}

#[test]
fn a_saved_design_of_motor_search_has_its_figures() {
    let line = "motor search --displacement 250cm3/rev --speed 60rpm --stator 5 --rotor 3 --z3 55 --zs 10 --places 4 \
                --crest tooth --design 1 --format json --save saved.yaml";
    let folder = here();
    saved_as_told(folder.path(), &line.split_whitespace().collect::<Vec<_>>(), "1");
}

/// Runs a search and compares its design with what `motor` says of the file.
fn saved_as_told(folder: &std::path::Path, line: &[&str], design: &str) {
    let done = output(folder, line);
    assert!(done.status.success(), "{}", text(&done.stderr));
    let found: Value = serde_json::from_slice(&done.stdout).unwrap();
    let designs = found["designs"].as_array().unwrap();
    let design = designs.iter().find(|one| one["design"].as_u64() == design.parse().ok()).unwrap();
    let done = output(folder, &["motor", "saved.yaml", "--format", "json"]);
    let saved = std::fs::read_to_string(folder.join("saved.yaml")).unwrap();
    assert!(done.status.success(), "{}\n{saved}", text(&done.stderr));
    let motor: Value = serde_json::from_slice(&done.stdout).unwrap();
    let near = |one: &Value, other: &Value| {
        if one.is_null() && other.is_null() {
            return;
        }
        let (one, other) = (number(one), number(other));
        assert!((one / other - 1.0).abs() < 1e-9, "{one} {other}: {design}\n{saved}");
    };
    let (size, work, flanks) = (&design["size"], &motor["work"], &motor["flanks"]);
    let own = if design["flanks"].is_object() { &design["flanks"] } else { &design["at_flanks"] };
    near(&motor["size"]["displacement_by_volume"], &design["displacement_by_volume"]);
    near(&motor["size"]["stator_outer_m"], &size["outer_diameter_m"]);
    near(&work["ripple"], &design["ripple"]);
    near(&work["width_m"], &size["width_m"]);
    for key in ["displacement_m3", "torque_n_m", "least_torque_n_m", "flow_m3_s", "power_w"] {
        near(&work[key], &size[key]);
    }
    near(&flanks["ripple"], &own["ripple"]);
    near(&flanks["least_over_mean"], &own["least_over_mean"]);
    if own["allowed"].is_object() {
        near(&flanks["allowed"]["on_path_pa"], &own["allowed"]["on_path_pa"]);
    }
    if !own["contact_on_path_pa"].is_null() {
        let contacts = flanks["contact"].as_array().unwrap();
        let keys = ["at_pitch_point_pa", "on_path_pa"];
        let figures = contacts.iter().flat_map(|one| keys.iter().filter_map(|key| one[key].as_f64()));
        near(&Value::from(figures.fold(0.0, f64::max)), &own["contact_on_path_pa"]);
    }
}
