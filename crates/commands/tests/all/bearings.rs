//! Planet bearings over a duty, by hand.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use epicyclic_commands::failure::Failure;
use epicyclic_commands::shared::gearbox::Gearbox;
use epicyclic_commands::strength::answer::records::{BearingOverDuty, SharingBasis, Thrusts};
use epicyclic_commands::strength::{Request, Strength};
use std::f64::consts::PI;

/// The shifted set of 18, 36 and 93 teeth, its ring held.
const STAGE: &str = "\
gearbox: stage
input: S
output: H
sets:
  - { id: A, sun: S, ring: ground, carrier: H, teeth: [18, 93], planet_teeth: [36], planets: 4, module: 4 mm,
      profile_shifts: [0.389, 0.5039, 0.1171], tip_alterations: [-0.0833, -0.0833, 0], face_width: 60 mm, planet_mass: 2 kg,
      load_rating: 60 kN, bearing_rolling: rollers, static_load_rating: 65 kN, fatigue_limit: 7 kN, bearing_diameter: 60 mm,
      strength: { materials: [18CrNiMo7-6, 18CrNiMo7-6, 18CrNiMo7-6], flank_roughness: [4 µm, 4 µm, 4 µm], \
root_roughness: [16 µm, 16 µm, 16 µm], shaper: { teeth: 30 }, factors: { K_A: 1, K_v: 1, K_H_beta: 1, K_H_alpha: 1, K_F_alpha: 1 } } }
oil: { viscosity: 220 mm²/s, working_viscosity: 60 mm²/s, contamination: 0.5 }
life: 20000 h
bearing_reliability: 95 %
duty:
  - { gear: only, share: 40 %, torque: 900 N·m, speed: 1500 rpm }
  - { gear: only, share: 50 %, torque: -400 N·m, speed: 600 rpm }
  - { gear: only, share: 10 %, torque: 0 N·m, speed: 600 rpm }
overload: [{ gear: only, torque: 2 kN·m }]
gears: [{ name: only }]
";

fn strength(text: &str) -> Result<Strength, Failure> {
    let gearbox = Gearbox::parse("stage.yaml", text.as_bytes())?;
    Request { factors: true, ..Request::default() }.answer(&gearbox)
}

fn bearing(text: &str) -> BearingOverDuty {
    strength(text).unwrap().bearings.remove(0)
}

/// Centre distance and working pressure angles from the involute functions of the shifts, forces from moments
/// about the main axis and about the planet's own.
#[test]
fn forces_and_lives_are_those_by_hand() {
    let told = bearing(STAGE);
    let alpha = 20.0_f64.to_radians();
    let inv = |angle: f64| libm::tan(angle) - angle;
    let working = |shifts: f64, teeth: f64| {
        let due = inv(alpha) + 2.0 * shifts / teeth * libm::tan(alpha);
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..200 {
            let middle = f64::midpoint(low, high);
            if inv(middle) < due { low = middle } else { high = middle }
        }
        low
    };
    let a_1 = working(0.389 + 0.5039, 54.0);
    let centre = 4e-3 * 54.0 / 2.0 * libm::cos(alpha) / libm::cos(a_1);
    let a_2 = libm::acos(4e-3 * 57.0 / 2.0 * libm::cos(alpha) / centre);
    // Four planets, a floating member assumed.
    let sharing = 1.25;
    let force = |torque: f64, rpm: f64| {
        let carrier = torque.abs() * (1.0 + 93.0 / 18.0);
        let sun = torque.abs() / (4.0 * centre * 18.0 / 54.0);
        let tangential = carrier / (4.0 * centre);
        let ring = tangential - sun;
        let omega = rpm * PI / 30.0 / (1.0 + 93.0 / 18.0);
        let radial = sharing * (sun * libm::tan(a_1) - ring * libm::tan(a_2)) + 2.0 * centre * omega * omega;
        libm::hypot(sharing * tangential, radial)
    };
    let steps = [(900.0, 1500.0, 0.4), (400.0, 600.0, 0.5)];
    let (mut basic, mut modified) = (0.0, 0.0);
    for ((torque, rpm, share), step) in steps.into_iter().zip(&told.steps) {
        let load = force(torque, rpm);
        assert!((step.force_n / load - 1.0).abs() < 1e-9, "{} {load}", step.force_n);
        let turning = rpm * (1.0 - 1.0 / (1.0 + 93.0 / 18.0)) * 18.0 / 36.0;
        assert!((step.speed_rad_s * 30.0 / PI / turning - 1.0).abs() < 1e-12);
        let needed = 45_000.0 * libm::pow(turning, -0.83) / 60.0_f64.sqrt();
        let kappa = 60.0 / needed;
        assert!((step.viscosity_ratio.unwrap() / kappa - 1.0).abs() < 1e-12);
        let film = if kappa < 1.0 { libm::pow(kappa, 0.19087) } else { libm::pow(kappa, 0.071_739) };
        let dirt: f64 = 0.5 * 7000.0 / load;
        let life = 0.1 * libm::pow(1.0 - (1.5859 - 1.2348 / film) * libm::pow(dirt, 0.4), -9.185);
        assert!((step.modification.unwrap() / life - 1.0).abs() < 1e-9);
        let hours = libm::pow(60e3 / load, 10.0 / 3.0) * 1e6 / (60.0 * turning);
        basic += share / hours;
        modified += share / (hours * 0.64 * life);
    }
    assert_eq!((told.steps[2].force_n, told.steps[2].modification), (0.0, None));
    assert!((told.basic_life_s.unwrap() / 3600.0 * basic - 1.0).abs() < 1e-9);
    let own = told.modified.unwrap();
    assert!((own.life_s.unwrap() / 3600.0 * modified - 1.0).abs() < 1e-9);
    assert_eq!((own.reliability, own.reliability_factor, told.load_sharing), (0.95, 0.64, Some(sharing)));
    let greatest = force(2000.0, 0.0);
    assert!((told.greatest_force_n.unwrap() / greatest - 1.0).abs() < 1e-9);
    assert!((told.static_safety.unwrap() / (65e3 / greatest) - 1.0).abs() < 1e-9);
}

#[test]
fn what_is_missing_and_what_is_wrong_is_said() {
    let without = |old: &str, new: &str| {
        assert!(STAGE.contains(old), "{old}");
        STAGE.replace(old, new)
    };
    let told = bearing(&without(", contamination: 0.5", ""));
    assert_eq!((told.modified, told.missing), (None, vec!["oil.contamination".to_owned()]));
    let other = "  - { id: B, sun: H, ring: ground, carrier: K, k: 3, load_rating: 20 kN }\noil:";
    let told = strength(&without("oil:", other)).unwrap().bearings.remove(1);
    assert_eq!((told.basic_life_s, told.greatest_force_n), (None, None));
    assert_eq!(
        told.missing,
        ["planets", "module with teeth, or carrier_radius", "planet_mass or face_width"]
    );
    let told = bearing(&without("speed: 600", "speed: 3"));
    assert!(told.modified.is_none() && told.missing[0].ends_with("in gear only"), "{:?}", told.missing);
    let own = bearing(&without("K_A: 1,", "K_A: 1, K_gamma: 1.5,"));
    assert_eq!((own.load_sharing, own.load_sharing_is_given), (Some(1.5), true));
    // By any spelling, and with that of the mesh of the sun before that of both.
    assert_eq!(bearing(&without("K_A: 1,", "K_A: 1, K_γ: 1.5,")).load_sharing, Some(1.5));
    let of_mesh = "sun_mesh_factors: { K_γ: 1.7 }, factors: { K_A: 1, K_gamma: 1.5,";
    assert_eq!(bearing(&without("factors: { K_A: 1,", of_mesh)).load_sharing, Some(1.7));
    // Without a floating member, and with one that is stated.
    let floating = |word: &str| {
        strength(&without("load_rating: 60 kN,", &format!("floating: {word}, load_rating: 60 kN,"))).unwrap()
    };
    let warned = |told: &Strength| told.warnings.iter().any(|one| one.name == "rigid-load-sharing");
    let rigid = floating("none");
    assert!((rigid.bearings[0].load_sharing.unwrap() - 1.25 * 1.15).abs() < 1e-12 && warned(&rigid));
    assert_eq!(rigid.load_sharing[0].basis, SharingBasis::Rigid);
    let sun = floating("sun");
    assert_eq!((sun.bearings[0].load_sharing, warned(&sun)), (Some(1.25), false));
    assert_eq!(sun.load_sharing[0].basis, SharingBasis::Floating);
    assert_eq!(strength(STAGE).unwrap().load_sharing[0].basis, SharingBasis::Assumed);
    // Its teeth have the same.
    let factor = |told: &Strength| {
        let one = told.over_duty[0].factors.iter().find(|factor| factor.symbol == "K_γ").unwrap();
        (one.greatest, one.formula.clone().unwrap())
    };
    let (value, from) = factor(&rigid);
    assert!(
        (value - 1.25 * 1.15).abs() < 1e-12 && from.contains("without a floating member"),
        "{value} {from}"
    );
    assert_eq!(
        factor(&sun),
        (1.25, "IEC 61400-4, load sharing of planets with a floating member".to_owned())
    );
    // Its table ends at 7 planets: without the factor neither teeth nor bearings of 8 are rated.
    let eight = strength(&without("planets: 4", "planets: 8")).unwrap_err().to_string();
    assert!(eight.contains("K_γ missing: its table ends at 7 planets"), "{eight}");
    let eight = bearing(&without("planets: 4", "planets: 8").replace("K_A: 1,", "K_A: 1, K_gamma: 1.5,"));
    assert_eq!((eight.load_sharing, eight.missing.len()), (Some(1.5), 0));
    // A life that is too short is warned of, and with a looser requirement is not.
    let warned = |text: &str| strength(text).unwrap().warnings.iter().any(|one| one.name == "bearing-life");
    assert!(warned(&without("load_rating: 60 kN, bearing", "load_rating: 30 kN, bearing")));
    assert!(!warned(&without("life: 20000 h", "life: 2 h")));
    for (old, new, place) in [
        ("contamination: 0.5", "contamination: 1.5", "oil.contamination"),
        ("working_viscosity: 60", "working_viscosity: -60", "oil.working_viscosity"),
        ("bearing_diameter: 60 mm", "bearing_diameter: 0 mm", "sets[0].bearing_diameter"),
        ("fatigue_limit: 7 kN", "fatigue_limit: -7 kN", "sets[0].fatigue_limit"),
        ("static_load_rating: 65 kN", "static_load_rating: 0 kN", "sets[0].static_load_rating"),
        ("bearing_reliability: 95 %", "bearing_reliability: 94 %", "bearing_reliability"),
    ] {
        let refused = strength(&without(old, new)).unwrap_err().to_string();
        assert!(refused.contains(place) && refused.starts_with("stage.yaml:"), "{refused}");
    }
}

/// Compares a set in short form with the same set described gear by gear, behind the stage. Forces, lives,
/// safety and refusals are the same.
#[test]
fn a_compound_set_has_the_lives_of_the_same_set_in_short() {
    const SHORT: &str = "  - { id: B, sun: H, ring: ground, carrier: K, teeth: [20, 70], planet_teeth: [25], planets: 3, module: 8 mm, planet_mass: 5 kg, \
        load_rating: 200 kN, bearing_rolling: rollers, static_load_rating: 260 kN, fatigue_limit: 28 kN, bearing_diameter: 90 mm }\n";
    const LONG: &str = "compound_sets:\n  - { id: B, carrier: K, suns: { H: 20 }, rings: { ground: 70 }, planet_gears: { p: [25] }, \
        meshes: [{ gears: [H, p] }, { gears: [p, ground] }], planets: 3, module: 8 mm, planet_sizes: { p: { mass: 5 kg, \
        load_rating: 200 kN, bearing_rolling: rollers, static_load_rating: 260 kN, fatigue_limit: 28 kN, bearing_diameter: 90 mm } } }\n";
    let file = |set: &str| {
        let stage = STAGE
            .replace("output: H\n", "output: K\n")
            .replace("1 } } }\noil", &format!("1 }} }} }}\n{set}oil"));
        let mut all = strength(&stage).unwrap().bearings;
        all.retain(|bearing| bearing.set == "B");
        all.remove(0)
    };
    let (short, long) = (file(SHORT), file(LONG));
    let near = |one: f64, other: f64| assert!((one / other - 1.0).abs() < 1e-9, "{one} {other}");
    near(long.greatest_force_n.unwrap(), short.greatest_force_n.unwrap());
    near(long.static_safety.unwrap(), short.static_safety.unwrap());
    near(long.basic_life_s.unwrap(), short.basic_life_s.unwrap());
    let lives = [&long, &short].map(|one| one.modified.unwrap());
    near(lives[0].life_s.unwrap(), lives[1].life_s.unwrap());
    assert_eq!((lives[0].reliability_factor, &long.missing), (0.64, &short.missing));
    let told = file(&LONG.replace(", fatigue_limit: 28 kN", ""));
    assert_eq!((told.modified, told.missing), (None, vec!["fatigue_limit".to_owned()]));
    assert!(told.static_safety.is_some());
    let set = LONG.replace("static_load_rating: 260 kN", "static_load_rating: 0 kN");
    let stage =
        STAGE.replace("output: H\n", "output: K\n").replace("1 } } }\noil", &format!("1 }} }} }}\n{set}oil"));
    let refused = strength(&stage).unwrap_err().to_string();
    assert!(refused.contains("static_load_rating must be above 0"), "{refused}");
}

/// A Ravigneaux set alone has no teeth that are rated, and its planets' bearings are.
#[test]
fn planets_of_a_compound_set_alone_are_rated() {
    const ALONE: &str = "\
gearbox: four-speed
input: turbine
output: ring
links: [carrier]
compound_sets:
  - { id: R, carrier: carrier, suns: { turbine: 30, large: 36 }, rings: { ring: 72 }, planet_gears: { long: [18], short: [18] },
      meshes: [{ gears: [turbine, short] }, { gears: [short, long] }, { gears: [large, long] }, { gears: [long, ring] }], planets: 3, module: 3 mm,
      planet_sizes: { long: { mass: 0.5 kg, load_rating: 25 kN, bearing_rolling: rollers, static_load_rating: 30 kN, fatigue_limit: 3 kN,
        bearing_diameter: 26 mm }, short: { mass: 0.4 kg, load_rating: 25 kN, bearing_rolling: rollers, static_load_rating: 30 kN,
        fatigue_limit: 3 kN, bearing_diameter: 26 mm } } }
brakes: [{ id: LR, link: carrier }, { id: B, link: large }]
oil: { viscosity: 100 mm²/s, working_viscosity: 30 mm²/s, contamination: 0.5 }
life: 500 h
duty:
  - { gear: \"1\", share: 30 %, torque: 60 N·m, speed: 1500 rpm }
  - { gear: \"2\", share: 70 %, torque: 60 N·m, speed: 2000 rpm }
gears: [{ name: \"1\", engaged: [LR] }, { name: \"2\", engaged: [B] }]
";
    let told = strength(ALONE).unwrap();
    assert!(told.governing.is_none() && told.over_duty.is_empty() && told.not_rated.len() == 1);
    let names: Vec<&str> = told.bearings.iter().map(|bearing| bearing.planet.as_str()).collect();
    assert_eq!(names, ["long", "short"]);
    for bearing in &told.bearings {
        assert_eq!((bearing.missing.as_slice(), bearing.steps.len()), ([].as_slice(), 2));
        let safety = 30e3 / bearing.greatest_force_n.unwrap();
        assert!((bearing.static_safety.unwrap() / safety - 1.0).abs() < 1e-12);
        // By hand from the steps: Miner's sum of both with their own a_ISO.
        let damage = bearing.steps.iter().zip([0.3, 0.7]).map(|(step, share)| {
            let revolutions = libm::pow(25e3 / step.force_n, 10.0 / 3.0) * 1e6 * step.modification.unwrap();
            share * step.speed_rad_s / (2.0 * PI) / revolutions
        });
        let life = 1.0 / damage.sum::<f64>();
        assert!((bearing.modified.unwrap().life_s.unwrap() / life - 1.0).abs() < 1e-9);
    }
    let without = ALONE.replace("load_rating: 25 kN, ", "").replace("static_load_rating: 30 kN, ", "");
    let without = without.replace("static_load_rating: 30 kN,\n", "\n");
    let refused = strength(&without).unwrap_err().to_string();
    assert!(refused.contains("missing: "), "{refused}");
}

/// Forces on bevel planets are not calculated, and the bearing is listed with the reason why it has no life.
#[test]
fn bevel_planets_are_not_rated() {
    let set = "compound_sets:\n  - { id: B, carrier: H, bevels_left: { K: 16 }, bevels_right: { ground: 16 }, planet_gears: { p: [10] }, \
        meshes: [{ gears: [K, p] }, { gears: [p, ground] }], planets: 2, planet_sizes: { p: { mass: 1 kg, load_rating: 20 kN, \
        static_load_rating: 20 kN } } }\n";
    let stage =
        STAGE.replace("output: H\n", "output: K\n").replace("1 } } }\noil", &format!("1 }} }} }}\n{set}oil"));
    let told = strength(&stage).unwrap().bearings;
    let told = told.iter().find(|bearing| bearing.set == "B").unwrap();
    assert_eq!((told.basic_life_s, told.static_safety), (None, None));
    assert_eq!(told.missing, ["forces on bevel planets are not calculated"]);
}

/// The stage with helical teeth of equal centre distances and a span of its bearings.
fn helical(angle: &str, span: &str) -> BearingOverDuty {
    let shifts = "profile_shifts: [0.389, 0.5039, 0.1171], tip_alterations: [-0.0833, -0.0833, 0], ";
    assert!(STAGE.contains(shifts));
    bearing(&STAGE.replace(shifts, "").replace("teeth: [18, 93]", "teeth: [18, 90]").replace(
        "bearing_diameter: 60 mm,",
        &format!("bearing_diameter: 60 mm, {span}helix_angle: {angle},"),
    ))
}

/// Rows by the balance of one planet: tangential force and centrifugal force shared by halves, the axial
/// forces of sun and ring at their pitch points turned by two forces outwards and inwards.
#[test]
fn two_rows_share_force_and_moment_by_hand() {
    let span = "bearing_span: 80 mm, ";
    let told = helical("12 deg", span);
    let beta = 12.0_f64.to_radians();
    let cos = libm::cos(beta);
    let sharing = told.load_sharing.unwrap();
    let centre = 4e-3 * 54.0 / 2.0 / cos;
    // 900 N·m on the sun, four planets.
    let f_t = sharing * 900.0 / 4.0 / (4e-3 * 18.0 / 2.0 / cos);
    let moment = f_t * libm::tan(beta) * 2.0 * (4e-3 * 36.0 / 2.0 / cos);
    let step = &told.steps[0];
    assert!((step.tilting_moment_n_m.unwrap() / moment - 1.0).abs() < 1e-9);
    assert_eq!(step.axial_force_n, Some(0.0));
    let carrier = 1500.0 / (1.0 + 90.0 / 18.0) * PI / 30.0;
    let outwards = 2.0 * centre * carrier * carrier;
    let mut rows = [1.0, -1.0].map(|end| libm::hypot(f_t, outwards / 2.0 + end * moment / 0.08));
    rows.sort_by(f64::total_cmp);
    let mut own = step.row_forces_n.unwrap();
    own.sort_by(f64::total_cmp);
    for (own, row) in own.iter().zip(rows) {
        assert!((own / row - 1.0).abs() < 1e-9, "{own} {row}");
    }
    // Rollers: P = 2·((F_1^4.5 + F_2^4.5)/2)^(1/4.5); the static load rating is that of two equal rows.
    let mean = rows.iter().map(|row| libm::pow(*row, 4.5)).sum::<f64>() / 2.0;
    assert!((step.equivalent_load_n / (2.0 * libm::pow(mean, 1.0 / 4.5)) - 1.0).abs() < 1e-9);
    assert!(
        (told.static_safety.unwrap() * 2.0 * told.greatest_row_force_n.unwrap() / 65e3 - 1.0).abs() < 1e-12
    );
    // The other hand exchanges the rows.
    let other = helical("-12 deg", span);
    let [first, second] = step.row_forces_n.unwrap();
    let swapped = other.steps[0].row_forces_n.unwrap();
    assert!((swapped[0] / second - 1.0).abs() < 1e-12 && (swapped[1] / first - 1.0).abs() < 1e-12);
    let without = helical("12 deg", "");
    assert!(told.basic_life_s < without.basic_life_s && told.static_safety < without.static_safety);
    assert!(without.span_m.is_none() && without.steps[0].row_forces_n.is_none());
    assert_eq!(without.steps[0].equivalent_load_n, without.steps[0].force_n);
}

/// Spur teeth tilt nothing: both rows are the unit that they are rated as. A moment that is not part of a
/// life is warned of, and a span must be above 0.
#[test]
fn a_span_changes_no_life_of_spur_teeth() {
    let [without, with] = ["", "bearing_span: 80 mm, "].map(|span| helical("0 deg", span));
    let near = |one: Option<f64>, other: Option<f64>| (one.unwrap() / other.unwrap() - 1.0).abs() < 1e-12;
    assert!(near(without.basic_life_s, with.basic_life_s) && near(without.static_safety, with.static_safety));
    assert_eq!(with.steps[0].tilting_moment_n_m, Some(0.0));
    let warned = |span: &str| {
        let keys = format!("bearing_diameter: 60 mm, {span}helix_angle: 12 deg,");
        let text = STAGE.replace("bearing_diameter: 60 mm,", &keys);
        strength(&text).map(|told| told.warnings.iter().any(|one| one.name == "tilting-moment"))
    };
    assert_eq!((warned("").unwrap(), warned("bearing_span: 8 cm, ").unwrap()), (true, false));
    let error = warned("bearing_span: 0 mm, ").unwrap_err().to_string();
    assert!(error.contains("sets[0].bearing_span: bearing_span must be above 0"), "{error}");
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Stepped planets with hands of every kind as rigid bodies in space: the load of a row follows from the
/// moments of all forces about the other row. Equal hands act against each other on the pin, opposite ones
/// together.
#[test]
fn rows_of_stepped_planets_balance_as_rigid_bodies() {
    let teeth = [20.0, 40.0, 20.0, 80.0];
    for (first, second) in [(10.0_f64, 17.0_f64), (10.0, -17.0), (-21.0, 6.0), (-14.0, -3.0)] {
        for torque in [700.0, -450.0] {
            let text = format!(
                "gearbox: one\ninput: S\noutput: H\nlife: 10000 h\noil: {{ viscosity: 220 mm²/s }}\nsets:\n  - {{ id: A, kind: stepped_sun_ring, sun: S, ring: ground, carrier: H, \
                 teeth: [20, 80], planet_teeth: [40, 20], planets: 3, module: 3 mm, helix_angles: [{first} deg, {second} deg], planet_mass: 3 kg, load_rating: 60 kN, \
                 bearing_span: 70 mm, face_width: 30 mm, strength: {{ materials: [18CrNiMo7-6, 18CrNiMo7-6, 18CrNiMo7-6, 18CrNiMo7-6], flank_roughness: [4 µm, 4 µm, 4 µm, 4 µm], \
                 root_roughness: [16 µm, 16 µm, 16 µm, 16 µm], shaper: {{ teeth: 30 }}, factors: {{ K_A: 1, K_gamma: 1, K_v: 1, K_H_beta: 1, K_H_alpha: 1, K_F_alpha: 1 }} }} }}\n\
                 duty: [{{ gear: only, share: 100 %, torque: {torque} N·m, speed: 900 rpm }}]\ngears: [{{ name: only }}]\n"
            );
            let told = strength(&text).unwrap();
            let betas = [first, second].map(f64::to_radians);
            let tan = betas.map(|beta| libm::tan(beta.abs()));
            let alpha = betas.map(|beta| libm::tan(20_f64.to_radians()) / libm::cos(beta));
            let centre = 3e-3 / libm::cos(betas[0]) * (teeth[0] + teeth[1]) / 2.0;
            let radii =
                [centre * teeth[1] / (teeth[0] + teeth[1]), centre * teeth[2] / (teeth[3] - teeth[2])];
            let of_sun = torque / 3.0 / (centre - radii[0]);
            let of_ring = of_sun * radii[0] / radii[1];
            let hands = [first.signum(), second.signum()];
            let omega = 900.0 / (1.0 + 80.0 * 40.0 / (20.0 * 20.0)) * PI / 30.0;
            // x outwards, y along the positive rotation, z along the axis; the sun is inside, the ring
            // outside. Both gears lie side by side, 30 mm wide each.
            let forces = [
                ([-radii[0], 0.0, -0.015], [of_sun.abs() * alpha[0], of_sun, hands[0] * of_sun * tan[0]]),
                ([radii[1], 0.0, 0.015], [-of_ring.abs() * alpha[1], of_ring, -hands[1] * of_ring * tan[1]]),
                ([0.0; 3], [3.0 * centre * omega * omega, 0.0, 0.0]),
            ];
            let (mut sum, mut about_second) = ([0.0; 3], [0.0; 3]);
            for (at, force) in forces {
                let turn = cross([at[0], at[1], at[2] + 0.035], force);
                (0..3).for_each(|axis| sum[axis] += force[axis]);
                (0..3).for_each(|axis| about_second[axis] += turn[axis]);
            }
            let row = [about_second[1] / 0.07, -about_second[0] / 0.07];
            let rows = [libm::hypot(row[0], row[1]), libm::hypot(sum[0] - row[0], sum[1] - row[1])];
            let step = &told.bearings[0].steps[0];
            let own = step.row_forces_n.unwrap();
            for (own, row) in own.iter().zip(rows) {
                assert!((own / row - 1.0).abs() < 1e-9, "{own} {row} {first} {second} {torque}");
            }
            assert!((step.axial_force_n.unwrap() / sum[2] - 1.0).abs() < 1e-9, "{step:?} {sum:?}");
            let planet = told.axial_forces.iter().find(|one| one.body == "planet").unwrap();
            let thrusts = if hands[0] == hands[1] { Thrusts::PartlyCancel } else { Thrusts::Add };
            assert_eq!(planet.thrusts, Some(thrusts));
        }
    }
}
