//! The command `simulate`: problems with exact answers through the program, shifts, heat, and what is refused.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::indexing_slicing,
    reason = "helpers of tests, which clippy does not know for such"
)]

mod common;

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
    let due = 193.23 * (1.0 - (-60.0_f64 / 3.14883).exp());
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
    close(&answer["events"][0]["time_s"], tau * 20.0_f64.ln(), 1e-7);
    let due = 193.23 * (1.0 - (-12.0 / tau).exp());
    close(&answer["end"][0]["speed_rad_s"], due, 1e-7);
}
