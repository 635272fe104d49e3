//! Backlash and torsional stiffness at the output of a gearbox, against levers and stages in a row.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use crate::common::stages;
use epicyclic_commands::shared::gearbox::Gearbox;
use epicyclic_commands::sheet::answer::records::AtOutput;
use epicyclic_commands::sheet::{DataSheets, Request};

const TEETH: &str = "teeth: [18, 93], planet_teeth: [36], planets: 3, module: 4 mm, face_width: 60 mm, \
    profile_shifts: [0.389, 0.5039, 0.1171], tip_alterations: [-0.0833, -0.0833, 0]";
const ALLOWANCES: &str =
    ", data_sheet: { thickness_allowances: [[-90 µm, -60 µm], [-80 µm, -50 µm], [-120 µm, -70 µm]] }";

fn one(more: &str) -> String {
    format!(
        "gearbox: stage\ninput: S\noutput: H\nsets: [{{ id: A, sun: S, ring: ground, carrier: H, {TEETH}{more} }}]\n\
         gears: [{{ name: only }}]\n"
    )
}

fn sheets(text: &str, set: Option<&str>) -> DataSheets {
    let gearbox = Gearbox::parse("box.yaml", text.as_bytes()).unwrap();
    Request { set: set.map(str::to_owned) }.answer(&gearbox).unwrap()
}

fn at_output(text: &str) -> AtOutput {
    sheets(text, None).at_output.remove(0)
}

fn near(one: f64, other: f64) -> bool {
    (one / other - 1.0).abs() < 1e-9
}

/// Lever of the carrier is the sum of both base radii: thinner teeth give it their play along the line of
/// action, and the springs of both meshes are in series.
#[test]
fn one_set_is_its_lever() {
    let told = sheets(&one(ALLOWANCES), None);
    let base = |gear: usize| told.sets[0].gears[gear].base_diameter_m / 2.0;
    let lever = base(0) + base(2);
    let [with, without] = [&told.at_output[0], &at_output(&one(""))].map(|one| one.backlash_rad.unwrap());
    let cos = libm::cos(20.0_f64.to_radians());
    assert!(near((with.upper - with.lower) * lever, (30.0 + 2.0 * 30.0 + 50.0) * 1e-6 * cos));
    // Shifts to four digits leave the flanks 3 µm into each other, and no play.
    assert_eq!((without.lower, without.upper), (0.0, 0.0));
    assert!(((with.upper * lever) / ((90.0 + 2.0 * 80.0 + 120.0) * 1e-6 * cos) - 1.0).abs() < 0.02);
    assert!(with.lower < with.upper && told.at_output[0].missing.is_empty());
    // Both meshes at once: with one half as wide the stiffness is half.
    let stiffness = told.at_output[0].stiffness_n_m.unwrap();
    let half = at_output(&one("").replace("face_width: 60 mm", "face_width: 30 mm"));
    assert!(near(half.stiffness_n_m.unwrap(), stiffness / 2.0));
    let six = at_output(&one("").replace("planets: 3", "planets: 6"));
    assert!(near(six.stiffness_n_m.unwrap(), stiffness * 2.0));
    let twice = at_output(&one("").replace("module: 4 mm", "module: 8 mm"));
    assert!(near(twice.stiffness_n_m.unwrap(), stiffness * 4.0));
    // Springs of 20 N/(mm·µm), 60 mm wide, of three planets on this lever: the formulas of ISO 6336-1 are not
    // far from it.
    let usual = lever * lever * 3.0 / (2.0 / (20e9 * 0.06));
    assert!((0.5..1.5).contains(&(stiffness / usual)), "{stiffness} {usual}");
    assert!(sheets(&one(""), Some("A")).at_output.is_empty());
}

/// Play of the first of two stages reaches the output divided by the ratio of the second.
#[test]
fn stages_in_a_row_add_over_the_ratio() {
    let [single] = [at_output(&one(ALLOWANCES))];
    let two = format!(
        "gearbox: two\ninput: S\noutput: H\nsets:\n  - {{ id: A, sun: S, ring: ground, carrier: M, {TEETH}{ALLOWANCES} }}\n\
         \x20 - {{ id: B, sun: M, ring: ground, carrier: H, {TEETH}{ALLOWANCES} }}\ngears: [{{ name: only }}]\n"
    );
    let ratio = 1.0 + 93.0 / 18.0;
    let both = at_output(&two);
    let [own, all] = [&single, &both].map(|one| one.backlash_rad.unwrap());
    assert!(
        near(all.upper, own.upper * (1.0 + 1.0 / ratio)) && near(all.lower, own.lower * (1.0 + 1.0 / ratio))
    );
    let [own, all] = [&single, &both].map(|one| one.stiffness_n_m.unwrap());
    assert!(near(1.0 / all, (1.0 + 1.0 / (ratio * ratio)) / own));
    // What is not known is said.
    let narrow = at_output(&two.replacen("face_width: 60 mm, ", "", 1));
    assert!(
        narrow.stiffness_n_m.is_none()
            && near(narrow.backlash_rad.unwrap().upper, both.backlash_rad.unwrap().upper)
    );
    assert_eq!(narrow.missing, ["planets or face_width of set A, for the stiffness"]);
    let unknown = two.replacen(TEETH, "k: 3", 1).replacen(ALLOWANCES, "", 1);
    let unknown = at_output(&unknown);
    assert_eq!((unknown.backlash_rad, unknown.stiffness_n_m), (None, None));
    assert_eq!(unknown.missing, ["the teeth of set A"]);
}

/// At every centre distance in the tolerance the output turns no less and no more than at its ends.
#[test]
fn the_ends_of_a_tolerance_bound_the_play() {
    let within = |lower: &str, upper: &str| {
        let deviations = format!(", data_sheet: {{ centre_distance_deviations: [{lower} mm, {upper} mm] }}");
        at_output(&one(&deviations)).backlash_rad.unwrap()
    };
    let all = within("-0.2", "0.2");
    for at in ["-0.2", "-0.1", "-0.03", "0", "0.07", "0.15", "0.2"] {
        let one = within(at, at);
        assert!(one.lower >= all.lower - 1e-15 && one.upper <= all.upper + 1e-15, "{at}");
    }
}

/// The allowances of a design leave the output the play asked for, less a step of theirs: by the sheet of its file, and
/// by the lever of its only set.
#[test]
fn a_design_keeps_the_backlash_asked_for() {
    const SIZES: &str =
        "--input=3000rpm|--modules=1mm, 1.5mm, 2mm|--face-widths=15mm, 20mm, 30mm|--planets=3";
    for (order, is_fine) in [
        ("--ratio=6|--torque=20 N·m|--backlash=6arcmin", false),
        ("--ratio=6|--torque=20 N·m|--backlash=1arcmin", true),
        ("--ratio=30|--torque=5 N·m|--backlash=8arcmin|--stages=2", false),
        ("--ratio=60|--torque=2 N·m|--backlash=8arcmin|--kind=wolfrom", false),
    ] {
        let stages = stages(&format!("{order}|{SIZES}"));
        let backlash = stages.backlash.unwrap();
        let file = stages.file.unwrap();
        let told = sheets(&file, None);
        let play = told.at_output[0].backlash_rad.unwrap();
        assert_eq!(backlash.reached_rad, [play.lower, play.upper]);
        let share = play.upper / backlash.asked_rad;
        assert!((0.9..1.0 + 1e-9).contains(&share), "{order}: {share}");
        let is_warned = stages.warnings.iter().any(|warning| warning.name == "fine-backlash");
        assert_eq!(is_warned, is_fine, "{order}");
        if let [set] = &told.sets[..]
            && set.gears.len() == 3
        {
            let lever = (set.gears[0].base_diameter_m + set.gears[2].base_diameter_m) / 2.0;
            let [thin, _] = backlash.thickness_allowances_m;
            let cos = libm::cos(20.0_f64.to_radians());
            assert!((play.upper * lever / (-4.0 * thin * cos) - 1.0).abs() < 0.03, "{order}");
        }
        assert!(file.starts_with("# "), "the bearings stay named: {file}");
    }
}
