//! Helical sets from the file to the answers.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use crate::common;

use common::{examples, here, output, text};
use serde_json::Value;
use std::fs;

const DTU: &str = "wind-stage-helical.yaml";

fn json(args: &[&str]) -> Value {
    let done = output(&examples(), &[args, &["--format", "json"]].concat());
    assert!(done.status.success(), "{done:?}");
    serde_json::from_slice(&done.stdout).unwrap()
}

#[track_caller]
fn near(value: &Value, expected: f64, tolerance: f64) {
    let value = value.as_f64().unwrap();
    assert!((value - expected).abs() <= tolerance, "{value}, {expected} expected");
}

#[test]
fn a_helix_angle_of_0_changes_no_answer() {
    let folder = here();
    let stage = fs::read_to_string(examples().join("wind-stage.yaml")).unwrap();
    let with = stage.replacen("    module: 21 mm\n", "    module: 21 mm\n    helix_angle: 0 deg\n", 1);
    let every = fs::read_to_string(examples().join("every-gearbox-key.yaml")).unwrap();
    let line = every.lines().find(|line| line.contains("helix_angle: 0 deg")).unwrap();
    let without = every.replacen(&format!("{line}\n"), "", 1);
    assert!(with != stage && without != every);
    let load = &["--torque", "999 kN·m", "--speed", "47.8 rpm"][..];
    for (texts, commands) in [
        (
            [stage, with],
            &[
                &["analyze"][..],
                &["sheet"],
                &["strength"],
                &[&["strength", "--factors"], load].concat(),
                &[&["losses"], load].concat(),
                &["draw", "--view", "teeth"],
                &["draw", "--to-scale"],
            ][..],
        ),
        ([without, every], &[&["vibrate"][..], &["sheet"], &["analyze"]][..]),
    ] {
        let run = |text: &String, command: &[&str]| {
            fs::write(folder.path().join("box.yaml"), text).unwrap();
            output(folder.path(), &[&command[..1], &["box.yaml"], &command[1..]].concat())
        };
        for command in commands {
            let [without, with] = texts.each_ref().map(|text| run(text, command));
            assert_eq!(text(&without.stderr), text(&with.stderr), "{command:?}");
            assert!(without.status.success(), "{command:?} {without:?}");
            assert_eq!(text(&without.stdout), text(&with.stdout), "{command:?}");
        }
    }
}

/// As printed: the shifts to four digits, so that the centre distance by them is known to 0.003 mm and the angles to 0.001°.
#[test]
fn the_data_sheet_of_a_helical_stage_has_the_printed_angles() {
    let set = &json(&["sheet", DTU])["sets"][0];
    near(&set["centre_distance_m"], 0.877_033, 3e-6);
    for (mesh, printed) in [(0, 22.4787_f64), (1, 19.9094)] {
        near(&set["meshes"][mesh]["working_angle_rad"], printed.to_radians(), 0.001_f64.to_radians());
    }
    // By hand: d = z·m_n/cos β.
    for (gear, teeth) in [(0, 26.0), (1, 31.0), (2, 89.0)] {
        near(&set["gears"][gear]["reference_diameter_m"], teeth * 0.03 / 8_f64.to_radians().cos(), 1e-12);
    }
}

/// The planets of a helical set stand further out than those of a spur set, and weigh more.
#[test]
fn forces_on_planets_are_at_the_helical_centre_distance() {
    let told = json(&["analyze", DTU, "--gear", "only", "--torque", "1 MN·m", "--speed", "10 rpm"]);
    let bearing = &told["planet_bearings"][0];
    near(&bearing["carrier_radius_m"], 0.877_033, 3e-6);
    // T_H/(N·a)
    let radius = bearing["carrier_radius_m"].as_f64().unwrap();
    near(&bearing["tangential_force_n"], 1e6 / 5.0 / radius, 1e-3);
    let named = |warning: &Value| warning["name"] == "tilting-moment";
    assert!(told["warnings"].as_array().unwrap().iter().any(named));
}

#[test]
fn vibration_of_helical_sets_is_refused() {
    let done = output(&examples(), &["vibrate", DTU]);
    assert!(!done.status.success());
    let told = text(&done.stderr).replace('\n', " ");
    assert!(
        told.contains("set stage: its teeth are helical; vibrate takes spur teeth alone, helix_angle: 0 deg"),
        "{told}"
    );
}

#[test]
fn a_helix_angle_that_is_refused_has_its_place() {
    let folder = here();
    let file = fs::read_to_string(examples().join(DTU)).unwrap();
    for (to, told) in [
        ("helix_angle: -8 deg", "16:18: set `stage`: helix angle is -8"),
        ("helix_angle: 8 mm", "16:18: "),
        ("helix_angle: 8", "16:18: "),
    ] {
        let wrong = file.replacen("helix_angle: 8 deg", to, 1);
        fs::write(folder.path().join("box.yaml"), wrong).unwrap();
        let done = output(folder.path(), &["sheet", "box.yaml"]);
        assert_eq!(done.status.code(), Some(2));
        assert!(text(&done.stderr).contains(told), "{}", text(&done.stderr));
    }
}
