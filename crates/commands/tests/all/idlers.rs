//! A wheel between two pairs on fixed axes.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "helpers of tests, which clippy does not know for such"
)]

use epicyclic_commands::shared::gearbox::Gearbox;
use epicyclic_commands::shared::load::Load;
use epicyclic_commands::{sheet, strength};

/// A pair with what its strength needs, and factors of its gears.
fn pair(id: &str, [first, second]: [&str; 2], teeth: [u32; 2], factors: &str) -> String {
    format!(
        "  - {{ id: {id}, kind: external_pair, sun: {first}, ring: {second}, teeth: {teeth:?}, module: 3 mm, face_width: 30 mm, strength: {{ materials: [18CrNiMo7-6, 18CrNiMo7-6], flank_roughness: [4 µm, 4 µm], root_roughness: [16 µm, 16 µm], factors: {{ K_A: 1.25, K_v: 1.05, K_H_beta: 1.2, K_H_alpha: 1, K_F_alpha: 1 }}{factors} }} }}\n"
    )
}

fn file(pairs: &str, more: &str, gear: &str) -> String {
    format!(
        "gearbox: train\ninput: a\noutput: c\nlife: 10000 h\noil: {{ viscosity: 220 mm²/s }}\nsets:\n{pairs}{more}gears: [{{ name: only{gear} }}]\n"
    )
}

fn rated(text: &str) -> strength::Strength {
    let load = Load {
        torque: Some("100 N·m".parse().unwrap()),
        speed: Some("1000 rpm".parse().unwrap()),
        ..Load::default()
    };
    let gearbox =
        Gearbox::parse("box.yaml", text.as_bytes()).unwrap_or_else(|error| panic!("{error}\n{text}"));
    let request = strength::Request { load, ..strength::Request::default() };
    request.answer(&gearbox).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn idlers(found: &strength::Strength) -> Vec<&str> {
    found.warnings.iter().filter(|one| one.name == "idler").map(|one| one.message.as_str()).collect()
}

fn root_safety(found: &strength::Strength, set: &str, gear: &str) -> f64 {
    let is_it = |one: &&strength::answer::records::Rated| one.set == set && one.toothed_gear == gear;
    found.at_point.iter().find(is_it).unwrap().root_safety.unwrap()
}

#[test]
fn a_wheel_between_two_pairs_is_warned_of() {
    let of = |teeth: u32, [first, second]: [&str; 2]| {
        let pairs = pair("P", ["a", "b"], [20, 31], first) + &pair("Q", ["b", "c"], [teeth, 40], second);
        rated(&file(&pairs, "", ""))
    };
    let plain = of(31, ["", ""]);
    let [message] = idlers(&plain)[..] else { panic!("{:?}", plain.warnings) };
    for part in ["gear 2 of set `P`", "gear 1 of set `Q`", "on link b"] {
        assert!(message.contains(part), "{message}");
    }
    // Other teeth are another wheel.
    assert!(idlers(&of(32, ["", ""])).is_empty());
    // What the warning says to write is read, lowers the safety of the wheel alone, and ends the warning.
    let factors = [", gear_factors: { gear 2: { Y_M: 0.7 } }", ", gear_factors: { gear 1: { Y_M: 0.7 } }"];
    for factor in factors {
        assert!(message.contains(factor.trim_start_matches(", ")), "{message}");
    }
    assert_eq!(idlers(&of(31, [factors[0], ""])).len(), 1);
    let settled = of(31, factors);
    assert!(idlers(&settled).is_empty());
    for (set, gear, share) in
        [("P", "gear 1", 1.0), ("P", "gear 2", 0.7), ("Q", "gear 1", 0.7), ("Q", "gear 2", 1.0)]
    {
        let ratio = root_safety(&settled, set, gear) / root_safety(&plain, set, gear);
        assert!((ratio - share).abs() < 1e-12, "{set} {gear}: {ratio}");
    }
}

/// A wheel passes no power on from a mesh without load.
#[test]
fn a_wheel_beside_an_idle_mesh_is_not_warned_of() {
    let pairs = pair("P", ["a", "b"], [20, 31], "") + &pair("Q", ["a", "c"], [20, 40], "");
    let found = rated(&file(&pairs, "", ""));
    assert!(idlers(&found).is_empty(), "{:?}", found.warnings);
}

/// Limits of a data sheet that are refused are shown in the unit of the file.
#[test]
fn refused_limits_of_a_data_sheet_are_in_millimetres() {
    let error = |sheet: &str| {
        let set = pair("P", ["a", "c"], [20, 31], "")
            .replace("face_width", &format!("data_sheet: {{ {sheet} }}, face_width"));
        let gearbox = Gearbox::parse("box.yaml", file(&set, "", "").as_bytes()).unwrap();
        sheet::Request::default().answer(&gearbox).unwrap_err().to_string()
    };
    for (sheet, shown) in [
        ("thickness_allowances: [[-40 um, -70 um], [-60 um, -40 um]]", "from -0.04 mm to -0.07 mm"),
        ("centre_distance_deviations: [20 um, -10 um]", "from 0.02 mm to -0.01 mm"),
    ] {
        let error = error(sheet);
        assert!(error.contains(shown), "{error}");
    }
    let error = error("centre_distance_deviations: [-70 mm, 0 mm]");
    assert!(error.contains(" mm; it must be above") && !error.contains("modules"), "{error}");
}
