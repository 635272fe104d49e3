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

/// As printed: the shifts to four digits, so that the centre distance by them is known to 0.003 mm and the
/// angles to 0.001°.
#[test]
fn the_data_sheet_of_a_helical_stage_has_the_printed_angles() {
    let set = &json(&["sheet", DTU])["sets"][0];
    near(&set["centre_distance_m"], 0.877_033, 3e-6);
    for (mesh, printed) in [(0, 22.4787_f64), (1, 19.9094)] {
        near(&set["meshes"][mesh]["working_angle_rad"], printed.to_radians(), 0.001_f64.to_radians());
    }
    // By hand: d = z·m_n/cos β.
    for (gear, teeth) in [(0, 26.0), (1, 31.0), (2, 89.0)] {
        near(
            &set["gears"][gear]["reference_diameter_m"],
            teeth * 0.03 / libm::cos(8_f64.to_radians()),
            1e-12,
        );
    }
}

/// The planets of a helical set have a larger centre distance than those of a spur set, and more mass.
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
fn a_helix_angle_that_is_refused_has_its_place() {
    let folder = here();
    let file = fs::read_to_string(examples().join(DTU)).unwrap();
    for (to, told) in [
        (
            "helix_angle: -80 deg",
            "16:18: sets[0].helix_angle: set `stage`: helix angle is -80 °; it must lie between -60 and 60 °",
        ),
        ("helix_angle: 8 mm", "16:18: sets[0].helix_angle: "),
        ("helix_angle: 8", "16:18: sets[0].helix_angle: "),
    ] {
        let wrong = file.replacen("helix_angle: 8 deg", to, 1);
        fs::write(folder.path().join("box.yaml"), wrong).unwrap();
        let done = output(folder.path(), &["sheet", "box.yaml"]);
        assert_eq!(done.status.code(), Some(2));
        assert!(text(&done.stderr).contains(told), "{}", text(&done.stderr));
    }
}

/// Transverse and normal values by other formulas than those of the library.
#[test]
fn the_data_sheet_tells_transverse_values_hands_and_overlap() {
    let set = &json(&["sheet", DTU])["sets"][0];
    let of = |value: &Value| value.as_f64().unwrap();
    let beta = 8_f64.to_radians();
    near(&set["transverse_module_m"], 0.03 / libm::cos(beta), 1e-15);
    let alpha_n = 20_f64.to_radians();
    // sin β_b = sin β·cos α_n
    let beta_b = libm::asin(libm::sin(beta) * libm::cos(alpha_n));
    near(&set["base_helix_angle_rad"], beta_b, 1e-14);
    let overlap = 0.8 * libm::sin(beta) / (std::f64::consts::PI * 0.03);
    for mesh in set["meshes"].as_array().unwrap() {
        near(&mesh["overlap_ratio"], overlap, 1e-12);
        near(&mesh["total_contact_ratio"], overlap + of(&mesh["contact_ratio"]), 1e-12);
    }
    for (gear, hand) in set["gears"].as_array().unwrap().iter().zip(["of_sun", "opposite", "opposite"]) {
        assert_eq!(gear["hand"], hand);
        let [z, k, d, d_b, s_t] =
            ["teeth", "spanned_teeth", "reference_diameter_m", "base_diameter_m", "transverse_thickness_m"]
                .map(|key| of(&gear[key]));
        near(&gear["lead_m"], std::f64::consts::PI * z * 0.03 / libm::sin(beta), 1e-12);
        let alpha_t = libm::acos(d_b / d);
        near(&set["transverse_pressure_angle_rad"], alpha_t, 1e-12);
        // The plates lie on the tangents of the base cylinder: base pitches and one base thickness, of a ring
        // one space.
        let is_ring = gear["toothed_gear"] == "ring";
        let arc = if is_ring { std::f64::consts::PI * d / z - s_t } else { s_t };
        let base = d_b * (arc / d + libm::tan(alpha_t) - alpha_t);
        let span = ((k - 1.0) * std::f64::consts::PI * d_b / z + base) * libm::cos(beta_b);
        near(&gear["span_m"], span, 1e-12);
        if is_ring {
            assert!(gear["span_face_width_m"].is_null());
        } else {
            near(&gear["span_face_width_m"], span * libm::sin(beta_b), 1e-12);
        }
    }
}

const RATED: [&str; 6] = ["strength", DTU, "--torque", "9947 kN·m", "--speed", "9.6 rpm"];

/// Factors of helical teeth by hand, with the overlap ratio above 1.
#[test]
fn helical_teeth_are_rated_with_their_factors() {
    let told = json(&[&RATED[..], &["--factors"]].concat());
    let beta = 8_f64.to_radians();
    let sheet = &json(&["sheet", DTU])["sets"][0]["meshes"];
    for (place, rated) in told["at_point"].as_array().unwrap().iter().enumerate() {
        let factor = |symbol: &str| {
            let all = rated["factors"].as_array().unwrap();
            &all.iter().find(|factor| factor["symbol"] == symbol).unwrap()["value"]
        };
        near(factor("Z_β"), libm::cos(beta).sqrt().recip(), 1e-12);
        near(factor("Y_β"), 1.0 - 8.0 / 120.0, 1e-12);
        let contact_ratio = sheet[place / 2]["contact_ratio"].as_f64().unwrap();
        near(factor("Z_ε"), contact_ratio.sqrt().recip(), 1e-12);
        near(factor("Z_B, Z_D"), 1.0, 0.0);
    }
}

/// Axial forces on the planet, which follow those on the central gears.
fn on_planet(told: &Value) -> &Value {
    let all = told["axial_forces"].as_array().unwrap();
    all.iter().find(|one| one["body"] == "planet").unwrap()
}

/// `F_a = F_t·tan β` at the reference circle, with the lever of the working circles; the values of `analyze`
/// without losses agree.
#[test]
fn axial_forces_tilt_the_planets() {
    let told = json(&RATED);
    let bodies: Vec<&str> =
        told["axial_forces"].as_array().unwrap().iter().map(|one| one["body"].as_str().unwrap()).collect();
    assert_eq!(bodies, ["sun", "ring", "planet"]);
    let axial = on_planet(&told);
    let force = told["at_point"][0]["tangential_force_n"].as_f64().unwrap() * libm::tan(8_f64.to_radians());
    let of_first = axial["meshes"][0]["axial_force_n"].as_f64().unwrap();
    for (mesh, sign) in [(0, 1.0), (1, -1.0)] {
        near(&axial["meshes"][mesh]["axial_force_n"], sign * force * of_first.signum(), 1e-12 * force);
    }
    assert_eq!((&axial["axial_force_n"], &axial["thrusts"]), (&Value::from(0.0), &Value::from("cancel")));
    // Five planets push sun and ring apart.
    for (body, sign) in [(0, -1.0), (1, 1.0)] {
        near(&told["axial_forces"][body]["axial_force_n"], sign * 5.0 * of_first, 1e-11 * force);
    }
    let meshes = &json(&["sheet", DTU])["sets"][0]["meshes"];
    let diameter =
        |mesh: usize, gear: usize| meshes[mesh]["gears"][gear]["working_diameter_m"].as_f64().unwrap();
    near(&axial["tilting_moment_n_m"], force * (diameter(0, 1) + diameter(1, 0)) / 2.0, 1e-12 * force);
    let steps = json(&["strength", DTU]);
    let steps = steps["axial_forces"].as_array().unwrap();
    assert_eq!(steps.iter().map(|one| one["step"].as_u64().unwrap()).collect::<Vec<_>>(), [1, 1, 1, 2, 2, 2]);
}

/// Safeties are continuous at the helix angle 0.
#[test]
fn a_small_helix_angle_changes_safeties_little() {
    let folder = here();
    let stage = fs::read_to_string(examples().join("wind-stage.yaml")).unwrap();
    let safeties = |text: &str| {
        fs::write(folder.path().join("box.yaml"), text).unwrap();
        let load = ["--torque", "999 kN·m", "--speed", "47.8 rpm", "--format", "json"];
        let done = output(folder.path(), &[&["strength", "box.yaml"], &load[..]].concat());
        let told: Value = serde_json::from_slice(&done.stdout).unwrap();
        let all = told["at_point"].as_array().unwrap().clone();
        all.into_iter()
            .flat_map(|one| ["flank_safety", "root_safety"].map(|key| one[key].as_f64().unwrap()))
            .collect::<Vec<f64>>()
    };
    let spur = safeties(&stage);
    let helical = stage.replacen("    module: 21 mm\n", "    module: 21 mm\n    helix_angle: 0.001 deg\n", 1);
    let helical = safeties(&helical);
    assert_eq!(spur.len(), 8);
    for (spur, helical) in spur.iter().zip(&helical) {
        // ε_β = 1.5e-4
        assert!((helical / spur - 1.0).abs() < 2e-4 && helical != spur, "{spur} {helical}");
    }
}

#[test]
fn analyze_tells_axial_forces_with_losses() {
    let file = fs::read_to_string(examples().join(DTU)).unwrap();
    let folder = here();
    let run = |text: &str| -> Value {
        fs::write(folder.path().join("box.yaml"), text).unwrap();
        let load = ["--gear", "only", "--torque", "9947 kN·m", "--speed", "9.6 rpm", "--format", "json"];
        let done = output(folder.path(), &[&["analyze", "box.yaml"], &load[..]].concat());
        serde_json::from_slice(&done.stdout).unwrap()
    };
    let lossless = run(&file.replacen("    friction: [0.04, 0.04]\n", "", 1));
    let told = json(&RATED);
    let axial = on_planet(&told);
    let bearing = &lossless["planet_bearings"][0];
    for place in [0, 1] {
        let of_mesh = axial["meshes"][place]["axial_force_n"].as_f64().unwrap();
        near(&bearing["axial_forces_n"][place], of_mesh.abs(), 1e-3);
    }
    near(&bearing["tilting_moment_n_m"], axial["tilting_moment_n_m"].as_f64().unwrap(), 1e-3);
    // With losses the sun, which drives out, has less of it than the ring.
    let lossy = run(&file);
    let forces = &lossy["planet_bearings"][0]["axial_forces_n"];
    assert!(forces[0].as_f64().unwrap() < forces[1].as_f64().unwrap(), "{forces}");
}

/// `H_V` of helical teeth by its definition: the friction of the normal force is that of the tangential force
/// over the cosine of the base helix angle.
#[test]
fn friction_losses_have_the_base_helix_angle() {
    let set = &json(&["sheet", DTU])["sets"][0];
    let told = json(&["analyze", DTU, "--gear", "only", "--torque", "1 MN·m", "--speed", "10 rpm"]);
    let losses: Vec<f64> = told["meshes"]
        .as_array()
        .unwrap()
        .iter()
        .map(|mesh| 1.0 - mesh["efficiency"].as_f64().unwrap())
        .collect();
    let of = |value: &Value| value.as_f64().unwrap();
    let beta_b = of(&set["base_helix_angle_rad"]);
    let base_pitch = of(&set["gears"][0]["base_diameter_m"]) * std::f64::consts::PI / 26.0;
    // Sun and planets: the sliding speed over the rolling speed, |ξ|·p_et·(1/r_b1 + 1/r_b2), over the path of
    // contact, shared by as many pairs as are in contact.
    let radii = [0, 1].map(|gear| of(&set["gears"][gear]["base_diameter_m"]) / 2.0);
    let mesh = &set["meshes"][0];
    let alpha = of(&mesh["working_angle_rad"]);
    let line = [0, 1].map(|gear| {
        let tip = of(&set["gears"][gear]["tip_diameter_m"]) / 2.0;
        ((tip * tip - radii[gear] * radii[gear]).sqrt() - radii[gear] * libm::tan(alpha)) / base_pitch
    });
    let steps = 200_000;
    let length = line[0] + line[1];
    let mut sum = 0.0;
    for step in 0..steps {
        let at = -line[1] + length * (f64::from(step) + 0.5) / f64::from(steps);
        let pairs = 1.0 + (at + line[1]).floor() + (line[0] - at).floor();
        sum += at.abs() / pairs * length / f64::from(steps);
    }
    let loss = 0.04 * base_pitch * (1.0 / radii[0] + 1.0 / radii[1]) * sum / libm::cos(beta_b);
    assert!(losses.iter().any(|told| (told / loss - 1.0).abs() < 1e-4), "{losses:?} {loss}");
}

/// Sizes that `size` finds and saves have equal safeties in `strength`; without the helix angle they differ.
#[test]
fn helical_sets_are_sized_as_they_are_rated() {
    let folder = here();
    let spur = fs::read_to_string(examples().join("travel-drive-duty.yaml")).unwrap();
    let helical =
        spur.replacen("    planet_teeth: [40]\n", "    planet_teeth: [40]\n    helix_angle: 12 deg\n", 1);
    let run = |args: &[&str]| -> Value {
        let done = output(folder.path(), &[args, &["--format", "json"]].concat());
        assert!(done.status.success(), "{done:?}");
        serde_json::from_slice(&done.stdout).unwrap()
    };
    let best = |text: &str| {
        fs::write(folder.path().join("box.yaml"), text).unwrap();
        run(&["size", "box.yaml", "--save", "sized.yaml"])["sets"][0]["found"][0].clone()
    };
    assert_ne!(best(&spur)["mass_kg"], best(&helical)["mass_kg"]);
    let best = best(&helical);
    assert!(fs::read_to_string(folder.path().join("sized.yaml")).unwrap().contains("helix_angle: 12 deg"));
    let rated = run(&["strength", "sized.yaml"]);
    let [sized, rated] = [&best, &rated].map(|told| told["over_duty"].as_array().unwrap());
    assert_eq!((sized.len(), rated.len()), (4, 4));
    for (sized, rated) in sized.iter().zip(rated) {
        for kind in ["flank", "root"] {
            near(&sized[kind]["safety"], rated[kind]["safety"].as_f64().unwrap(), 1e-9);
        }
    }
    let sheet = &run(&["sheet", "sized.yaml"])["sets"][0];
    near(&sheet["centre_distance_m"], best["centre_distance_m"].as_f64().unwrap(), 1e-12);
}
