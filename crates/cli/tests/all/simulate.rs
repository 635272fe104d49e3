//! The command `simulate`: problems with exact answers through the program, shifts, heat, and what is
//! refused.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::indexing_slicing,
    reason = "helpers of tests, which clippy does not know for such"
)]

use crate::common;

use common::{examples, here, output, text};
use serde_json::Value;
use std::fs;
use std::path::Path;

/// The answer to a scenario in JSON.
fn simulated(folder: &Path, file: &str) -> Value {
    let output = output(folder, &["simulate", file, "--format", "json"]);
    assert!(output.status.success(), "{}", text(&output.stderr));
    serde_json::from_str(&text(&output.stdout)).unwrap()
}

fn of_text(scenario: &str) -> Value {
    let folder = here();
    fs::write(folder.path().join("scenario.yaml"), scenario).unwrap();
    simulated(folder.path(), "scenario.yaml")
}

fn close(found: &Value, due: f64, relative: f64) {
    let found = found.as_f64().unwrap();
    assert!((found - due).abs() <= relative * due.abs(), "found {found:.13e}, due {due:.13e}");
}

#[test]
fn the_power_shift_has_its_exact_events() {
    let answer = simulated(&examples(), "power-shift.yaml");
    let [released, closed] = &answer["events"].as_array().unwrap()[..] else {
        panic!("{}", answer["events"])
    };
    close(&released["time_s"], 0.213_953_488_4, 1e-9);
    close(&released["speeds_rad_s"][0], 199.314_577_101_8, 1e-9);
    close(&released["speeds_rad_s"][2], 66.438_192_367_3, 1e-9);
    close(&released["accelerations_rad_s2"][0], -450.0, 1e-9);
    close(&released["accelerations_rad_s2"][2], -7.5, 1e-9);
    close(&released["element_heats_j"][1], 2_303.621_196_1, 1e-9);
    assert_eq!(released["changes"][0]["id"], "brake");
    assert_eq!(released["changes"][0]["from"], "holds");
    let inertia_phase = closed["time_s"].as_f64().unwrap() - released["time_s"].as_f64().unwrap();
    close(&inertia_phase.into(), 0.300_285_615_2, 1e-9);
    close(&closed["speeds_rad_s"][0], 64.186_050_253_1, 1e-9);
    close(&closed["accelerations_rad_s2"][0], -18.292_682_926_8, 1e-9);
    close(&closed["element_torques_n_m"][1], -102.439_024_390_2, 1e-9);
    let heat =
        closed["element_heats_j"][1].as_f64().unwrap() - released["element_heats_j"][1].as_f64().unwrap();
    close(&heat.into(), 4_788.104_032_6, 1e-9);
    assert!(answer["energies"]["residual"].as_f64().unwrap().abs() < 1e-9);
    // 281.6326531 N·m hold the ring in first gear.
    close(&answer["elements"][0]["peak_torque_n_m"], 281.632_653_1, 1e-9);
    // 160 N·m at a slip of 199.3 rad/s, where the inertia phase begins.
    close(&answer["elements"][1]["peak_power_w"], 160.0 * 199.314_577_101_8, 1e-9);
}

/// The excavator's drive with its equivalent inertia on the carrier alone.
const VISCOUS: &str = "\
scenario: P3
gearbox: { gearbox: P3, input: sun, output: carrier, sets: [{ id: P, sun: sun, ring: ground, carrier: carrier, k: 5 }] }
inertias: { carrier: 12.59532 kg·m² } # 36 × 0.34987
duration: 3.3276 s
torques:
  - { id: motor, link: sun, constant: 21.47 N·m }
  - { id: load, link: carrier, viscous: { torque: 4 N·m, at: 1 rad/s } }
thresholds: [{ id: 95 %, link: sun, speed: 183.5685 rad/s }]
";

#[test]
fn a_start_under_a_viscous_load_is_exact() {
    close(&of_text(VISCOUS)["end"][0]["speed_rad_s"], 126.067_992_6, 1e-9);
    let long = of_text(&VISCOUS.replace("3.3276 s", "60 s"));
    close(&long["events"][0]["time_s"], 9.433_051_655, 1e-9);
    let due = 193.23 * (1.0 - libm::exp(-60.0_f64 / 3.14883));
    close(&long["end"][0]["speed_rad_s"], due, 1e-9);
}

#[test]
fn the_parts_of_the_excavators_drive_have_its_equivalent_inertia() {
    let folder = examples();
    let drive = output(&folder, &["drive", "xe215cll-drive.yaml", "--format", "json"]);
    let drive: Value = serde_json::from_str(&text(&drive.stdout)).unwrap();
    let inertia = drive["equivalent_inertia"]["total_kg_m2"].as_f64().unwrap();
    let answer = simulated(&folder, "excavator-start.yaml");
    // ω = ω_∞·(1 − e^(−t/τ)) with τ = J·i²/c: 95 % after τ·ln 20.
    let tau = inertia * 36.0 / 4.0;
    close(&answer["events"][0]["time_s"], tau * libm::log(20.0_f64), 1e-7);
    let due = 193.23 * (1.0 - libm::exp(-12.0 / tau));
    close(&answer["end"][0]["speed_rad_s"], due, 1e-7);
}

/// A file, a change that makes it wrong, and nothing else.
const WRONG: &[(&str, &str)] = &[
    ("", "engaged: [K9]\n"),
    ("inertias: { carrier:", "inertias: { arm:"),
    ("inertias: { carrier: 12.59532 kg·m² }", "inertias: { carrier: 0 kg·m² }"),
    ("link: sun, constant", "link: shaft, constant"),
    ("constant: 21.47 N·m", "constant: 21.47"),
    ("constant: 21.47 N·m", "constant: 21.47 N·m, resistance: 1 N·m"),
    (", constant: 21.47 N·m", ""),
    ("id: load", "id: motor"),
    ("constant: 21.47 N·m", "over_time: { times: [0 s, 1 s], torques: [1 N·m] }"),
    ("constant: 21.47 N·m", "over_time: { times: [1 s, 0 s], torques: [1 N·m, 2 N·m] }"),
    ("constant: 21.47 N·m", "over_time: { csv: none.csv }"),
    ("constant: 21.47 N·m", "over_time: { csv: wrong.csv }"),
    ("viscous: { torque: 4 N·m, at: 1 rad/s }", "viscous: { torque: 4 N·m, at: 0 rad/s }"),
    ("3.3276 s", "0 s"),
    ("3.3276 s", "3 s\nsample_every: 1 µs"),
    ("3.3276 s", "3 s\nsample_every: 0.01 ms"),
    ("", "elements: [{ id: K9, holding: 1 N·m }]\n"),
    ("", "gear: high\n"),
    ("", "start: { speeds: { sun: 100 rpm, carrier: 100 rpm } }\n"),
    ("", "start: { input_speed: 100 rpm }\n"),
    ("", "start: {}\n"),
    ("", "gearbox_file: box.yaml\n"),
    ("", "transmission: 8HP\n"),
    ("", "efficiency: 110 %\n"),
    ("", "shifts: [{ at: 1 s, to: high, release: 1 s, apply: 1 s }]\n"),
    ("", "torque: 1\n"),
];

#[test]
fn scenarios_that_are_refused() {
    let folder = here();
    fs::write(folder.path().join("wrong.csv"), "s,N·m\n0,1\n1,2,3\n").unwrap();
    let mut seen = String::new();
    for (from, to) in WRONG {
        let wrong = if from.is_empty() { format!("{VISCOUS}{to}") } else { VISCOUS.replacen(from, to, 1) };
        assert!(wrong != VISCOUS, "{from}");
        fs::write(folder.path().join("scenario.yaml"), wrong).unwrap();
        let output = output(folder.path(), &["simulate", "scenario.yaml"]);
        assert_eq!(output.status.code(), Some(2), "{to}");
        assert!(output.stdout.is_empty());
        seen += &text(&output.stderr);
    }
    insta::assert_snapshot!(seen);
}

#[test]
fn points_out_of_order_are_told_where_they_stand() {
    let folder = here();
    let right = fs::read_to_string(examples().join("tip-in.yaml")).unwrap();
    fs::write(folder.path().join("full.csv"), "rpm,N·m\n0,120\n5000,150\n\n2000,180\n").unwrap();
    let full = "{ speeds: [0 rpm, 2000 rpm, 5000 rpm], torques: [120 N·m, 180 N·m, 150 N·m] }";
    for (from, to, told) in [
        (
            "speeds: [0 rpm, 5000 rpm]",
            "speeds: [0 rpm, -300 rpm]",
            "torques[0].throttle.closed.speeds[1]: point 2 of a torque over speed is at -31.4159265359 rad/s",
        ),
        (
            "speeds: [0 rpm, 2000 rpm, 5000 rpm]",
            "speeds: [0 rpm, 2000 rpm, 300 rpm]",
            "torques[0].throttle.full.speeds[2]: point 3",
        ),
        ("times: [0.1 s, 0.15 s]", "times: [0.1 s, 0.05 s]", "torques[0].throttle.times[1]: point 2"),
        (
            full,
            "{ csv: full.csv }",
            "error: full.csv:5:1: 2000 rpm, and the line before has 5000 rpm: the first column ascends",
        ),
    ] {
        assert!(right.contains(from), "{from}");
        fs::write(folder.path().join("scenario.yaml"), right.replacen(from, to, 1)).unwrap();
        let output = output(folder.path(), &["simulate", "scenario.yaml"]);
        assert_eq!(output.status.code(), Some(2), "{to}");
        assert!(text(&output.stderr).contains(told), "{}", text(&output.stderr));
    }
}

/// The shift of the example with something wrong in its program.
const WRONG_SHIFTS: &[(&str, &str)] = &[
    ("gear: \"2\"\n", ""),
    ("to: \"3\"", "to: \"2\""),
    ("to: \"3\"", "to: \"9\""),
    ("to: \"3\"", "to: \"4\""),
    ("release: 150 ms", "release: 0 ms"),
    ("overlap: 200 ms }", "overlap: 200 ms }\n  - { at: 0.3 s, to: \"2\", release: 1 ms, apply: 1 ms }"),
    ("holding: 400 N·m,", "holding: 400 N·m, capacity: { times: [0 s], torques: [1 N·m] },"),
    ("holding: 400 N·m,", "holding: -400 N·m,"),
    ("holding: 400 N·m,", "holding: 400 N·m, static_ratio: 0.9,"),
    ("holding: 400 N·m, friction_area: 900 cm², heat_capacity: 0.8 kJ/K,", "holding: 400 N·m,"),
    ("friction_area: 900 cm²", "friction_area: 0 cm²"),
    ("transmission: 8HP", "transmission: 9HP"),
    ("transmission: 8HP\n", ""),
    ("real-transmissions.yaml", "no.yaml"),
    ("n_in: 0.2 kg·m²", "ground: 0.2 kg·m²"),
];

#[test]
fn shifts_that_are_refused() {
    let folder = here();
    let read = |name: &str| fs::read_to_string(examples().join(name)).unwrap();
    fs::write(folder.path().join("real-transmissions.yaml"), read("real-transmissions.yaml")).unwrap();
    let right = read("shift-two-three.yaml");
    // The comment names the file of the gearbox, too.
    let right = right.split_once("\nscenario").unwrap().1;
    let mut seen = String::new();
    for (from, to) in WRONG_SHIFTS {
        assert!(right.contains(from), "{from}");
        let wrong = format!("scenario{}", right.replacen(from, to, 1));
        fs::write(folder.path().join("scenario.yaml"), wrong).unwrap();
        let output = output(folder.path(), &["simulate", "scenario.yaml"]);
        assert_eq!(output.status.code(), Some(2), "{to}");
        seen += &text(&output.stderr);
    }
    insta::assert_snapshot!(seen);
}

#[test]
fn samples_are_a_table_over_time() {
    let folder = here();
    fs::copy(examples().join("power-shift.yaml"), folder.path().join("shift.yaml")).unwrap();
    let output = output(folder.path(), &["simulate", "shift.yaml", "--csv", "samples.csv"]);
    assert!(output.status.success());
    let table = fs::read_to_string(folder.path().join("samples.csv")).unwrap();
    let mut lines = table.lines();
    assert_eq!(
        lines.next().unwrap(),
        "time_s,sun_speed_rpm,ring_speed_rpm,carrier_speed_rpm,engine_torque_n_m,load_torque_n_m,brake_torque_n_m,brake_slip_rpm,\
         brake_heat_j,clutch_torque_n_m,clutch_capacity_n_m,clutch_slip_rpm,clutch_heat_j,output_torque_n_m"
    );
    assert_eq!(lines.clone().count(), 201);
    assert!(lines.next().unwrap().starts_with("0.0,1909.85931710") || table.contains("\n0,1909.8593171"));
}
