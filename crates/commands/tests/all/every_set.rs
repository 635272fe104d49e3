//! Teeth, data sheets and strength of every kind of set: what is one set in two descriptions has one answer,
//! published stages have their figures, and no kind of set stops an answer.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "helpers of tests, which clippy does not know for such"
)]

use epicyclic_commands::shared::gearbox::Gearbox;
use epicyclic_commands::shared::load::Load;
use epicyclic_commands::sheet::answer::records::{GearSheet, MeshSheet};
use epicyclic_commands::{analyze, sheet, strength};
use proptest::prelude::*;

const STRENGTH: &str = "factors: { K_A: 1.25, K_v: 1.05, K_H_beta: 1.2, K_H_alpha: 1, K_F_alpha: 1 }";

/// Values of gears by name.
fn by_gear(key: &str, values: &[(&str, &str)]) -> String {
    let values: Vec<String> = values.iter().map(|(gear, value)| format!("{gear}: {value}")).collect();
    format!("{key}: {{ {} }}", values.join(", "))
}

/// A gearbox of one set, with what its strength needs.
fn file(list: &str, set: &str, gears: &[&str], more: &str) -> String {
    let of_all = |key: &str, ring: &str, other: &str| {
        let value = |gear: &&str| if gear.contains("ring") { ring.to_owned() } else { other.to_owned() };
        let values: Vec<String> = gears.iter().map(value).collect();
        by_gear(key, &gears.iter().copied().zip(values.iter().map(String::as_str)).collect::<Vec<_>>())
    };
    let is_internal = gears.iter().any(|gear| gear.contains("ring")) || set.contains("internal_pair");
    let shaper = if is_internal { "shaper: { teeth: 30 }, " } else { "" };
    format!(
        "gearbox: one\ninput: a\noutput: h\nlife: 10000 h\noil: {{ viscosity: 220 mm²/s }}\n{list}:\n  - {{ id: P, {set}, strength: {{ {}, {}, {}, {shaper}{STRENGTH} }} }}\n{more}gears: [{{ name: only, engaged: [] }}]\n",
        of_all("materials", "34CrNiMo6", "18CrNiMo7-6"),
        of_all("flank_roughness", "8 µm", "4 µm"),
        of_all("root_roughness", "20 µm", "16 µm"),
    )
}

fn read(text: &str) -> Gearbox {
    Gearbox::parse("box.yaml", text.as_bytes()).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn rated(text: &str, torque: &str) -> strength::Strength {
    let load = Load {
        torque: Some(torque.parse().unwrap()),
        speed: Some("1000 rpm".parse().unwrap()),
        ..Load::default()
    };
    let request = strength::Request { load, ..strength::Request::default() };
    request.answer(&read(text)).unwrap_or_else(|error| panic!("{error:?}\n{text}"))
}

fn near(one: f64, other: f64, tolerance: f64) -> bool {
    (one - other).abs() <= tolerance * one.abs().max(other.abs())
}

/// The rows of a rating in an order that does not depend on names: by the number of cycles and stress.
fn figures(strength: &strength::Strength) -> Vec<[f64; 8]> {
    let row = |one: &strength::answer::records::Rated| {
        [
            one.cycles,
            one.contact_stress_pa.unwrap(),
            one.contact_limit_pa.unwrap(),
            one.flank_safety.unwrap(),
            one.root_stress_pa.unwrap(),
            one.root_limit_pa.unwrap(),
            one.root_safety.unwrap(),
            one.tangential_force_n,
        ]
    };
    let mut all: Vec<[f64; 8]> = strength.at_point.iter().map(row).collect();
    all.sort_by(|one, other| one.partial_cmp(other).unwrap());
    all
}

fn alike(one: &strength::Strength, other: &strength::Strength) {
    let (one, other) = (figures(one), figures(other));
    assert_eq!(one.len(), other.len());
    for (one, other) in one.iter().flatten().zip(other.iter().flatten()) {
        assert!(near(*one, *other, 1e-12), "{one} {other}");
    }
}

const SHIFTS: [(&str, &str); 3] = [("sun", "0.389"), ("planet", "0.5039"), ("ring", "0.1171")];
const TIPS: [(&str, &str); 3] = [("sun", "-0.0833"), ("planet", "-0.0833"), ("ring", "0")];

fn simple(helix: &str) -> String {
    let set = format!(
        "sun: a, ring: ground, carrier: h, teeth: [18, 93], planet_teeth: [36], planets: 3, module: 4 mm, face_width: 60 mm, helix_angle: {helix}, profile_shifts: [0.389, 0.5039, 0.1171], tip_alterations: [-0.0833, -0.0833, 0]"
    );
    file("sets", &set, &["sun", "planet", "ring"], "")
}

fn compound(helix: &str) -> String {
    // The members of a compound set are named as their links.
    let name = |(gear, value): (&'static str, &'static str)| match gear {
        "sun" => ("a", value),
        "ring" => ("ring", value),
        other => (other, value),
    };
    let set = format!(
        "carrier: h, suns: {{ a: 18 }}, rings: {{ ring: 93 }}, planet_gears: {{ planet: [36] }}, meshes: [{{ gears: [a, planet] }}, {{ gears: [planet, ring] }}], planets: 3, module: 4 mm, face_width: 60 mm, helix_angle: {helix}, {}, {}",
        by_gear("profile_shifts", &SHIFTS.map(name)),
        by_gear("tip_alterations", &TIPS.map(name)),
    );
    file("compound_sets", &set, &["a", "planet", "ring"], "grounds: [ring]\n")
}

/// A simple set written gear by gear is the same set.
#[test]
fn a_simple_set_in_two_descriptions_has_one_answer() {
    for helix in ["0 deg", "12 deg"] {
        let [one, other] = [simple(helix), compound(helix)];
        alike(&rated(&one, "500 N·m"), &rated(&other, "500 N·m"));
        let sheets =
            [&one, &other].map(|text| sheet::Request::default().answer(&read(text)).unwrap().sets.remove(0));
        let gear = |sheet: &sheet::answer::records::SetSheet, teeth: u32| -> GearSheet {
            sheet.gears.iter().find(|gear| gear.teeth == teeth).unwrap().clone()
        };
        for teeth in [18, 36, 93] {
            let both = [0, 1].map(|place: usize| gear(&sheets[place], teeth));
            let [one, other] = both.map(|gear| {
                [
                    gear.tip_diameter_m,
                    gear.root_diameter_m,
                    gear.span_m,
                    gear.over_balls_m.unwrap(),
                    gear.tip_thickness_m,
                ]
            });
            assert!(one.iter().zip(other).all(|(one, other)| near(*one, other, 1e-12)), "{teeth}");
        }
        let mesh = |mesh: &MeshSheet| [mesh.contact_ratio, mesh.working_angle_rad, mesh.backlash_m];
        for (one, other) in sheets[0].meshes.iter().zip(&sheets[1].meshes) {
            assert!(mesh(one).iter().zip(mesh(other)).all(|(one, other)| (one - other).abs() < 1e-12));
        }
    }
}

/// Planets with two gears alike are planets with one, but for the way their teeth are bent: each gear is then
/// loaded on one flank alone.
#[test]
fn a_step_of_one_diameter_is_a_planet_bent_one_way() {
    let stepped = file(
        "sets",
        "kind: stepped_sun_ring, sun: a, ring: ground, carrier: h, teeth: [18, 93], planet_teeth: [36, 36], planets: 3, module: 4 mm, face_width: 60 mm, profile_shifts: [0.389, 0.5039, 0.5039, 0.1171], tip_alterations: [-0.0833, -0.0833, -0.0833, 0], modules: [4 mm, 4 mm]",
        &["sun", "planet 1", "planet 2", "ring"],
        "",
    )
    .replace(" module: 4 mm,", "");
    let [plain, stepped] = [simple("0 deg"), stepped].map(|text| rated(&text, "500 N·m"));
    for (one, other) in plain.at_point.iter().zip(&stepped.at_point) {
        assert!(near(one.flank_safety.unwrap(), other.flank_safety.unwrap(), 1e-12));
        let bent = if one.toothed_gear == "planet" { 0.7 } else { 1.0 };
        assert!(
            near(one.root_safety.unwrap(), bent * other.root_safety.unwrap(), 1e-12),
            "{}",
            one.toothed_gear
        );
    }
}

/// The mesh of sun and planet as a pair on fixed axes, with the torque of one planet: the same stresses; the
/// sun has a third of the cycles, and no planet shares its load.
#[test]
fn a_mesh_is_rated_as_a_lone_pair() {
    let in_set = rated(&simple("12 deg").replace("K_A: 1.25", "K_A: 1.25, K_gamma: 1"), "450 N·m");
    let pair = file(
        "sets",
        "kind: external_pair, sun: a, ring: h, teeth: [18, 36], module: 4 mm, face_width: 60 mm, helix_angle: 12 deg, profile_shifts: [0.389, 0.5039], tip_alterations: [-0.0833, -0.0833]",
        &["gear 1", "gear 2"],
        "",
    );
    let alone = rated(&pair, "150 N·m");
    for (one, other) in in_set.at_point.iter().zip(&alone.at_point) {
        assert!(near(one.contact_stress_pa.unwrap(), other.contact_stress_pa.unwrap(), 1e-12));
        assert!(near(one.root_stress_pa.unwrap(), other.root_stress_pa.unwrap(), 1e-12));
    }
    // The sun turns (1 − 18/(18 + 93)) times as fast under the carrier, and meets three planets.
    let cycles = [&in_set, &alone].map(|rating| rating.at_point[0].cycles);
    assert!(near(cycles[0], 3.0 * cycles[1] * 93.0 / 111.0, 1e-12));
    assert!(alone.load_sharing.is_empty());
}

/// The parallel stage of a wind gearbox, behind two planetary ones in one file: forces, limits and safeties
/// of a commercial calculation.
#[test]
fn a_published_parallel_stage_has_its_safeties() {
    let text = std::fs::read_to_string("../../examples/wind-gearbox.yaml").unwrap();
    let gearbox = Gearbox::parse("wind-gearbox.yaml", text.as_bytes()).unwrap();
    let load = Load {
        torque: Some("3946.0 kN·m".parse().unwrap()),
        speed: Some("12.1 rpm".parse().unwrap()),
        ..Load::default()
    };
    let request = strength::Request { load, ..strength::Request::default() };
    let strength = request.answer(&gearbox).unwrap();
    let third: Vec<_> = strength.at_point.iter().filter(|one| one.set == "third").collect();
    for (one, [flank, root, limit]) in third.iter().zip([[1.81, 3.26, 1338.30e6], [1.88, 3.09, 1387.31e6]]) {
        assert!(near(one.flank_safety.unwrap(), flank, 0.01) && near(one.root_safety.unwrap(), root, 0.01));
        assert!(near(one.contact_limit_pa.unwrap(), limit, 1e-4));
        assert!(near(one.tangential_force_n, 240_064.0, 0.001));
    }
    assert_eq!(strength.at_point.len(), 10);
    assert!(strength.not_rated.is_empty());
    let sheets = sheet::Request::default().answer(&gearbox).unwrap();
    assert!(near(sheets.sets[2].centre_distance_m.unwrap(), 0.861, 1e-6));
}

/// Both sides of a published stepped planet lie on one centre distance with the sign of a ring's shift that
/// ISO 21771 has; with the printed sign they do not.
#[test]
fn a_published_stepped_planet_closes_on_both_sides() {
    let stage = |shift: &str| {
        let set = format!(
            "kind: stepped_sun_ring, sun: a, ring: ground, carrier: h, teeth: [57, 107], planet_teeth: [54, 18], planets: 3, profile_shifts: [0.4618, 0.45, 0.5038, {shift}], modules: [2.75 mm, 3.5 mm], face_width: 40 mm"
        );
        let text = file("sets", &set, &["sun", "planet 1", "planet 2", "ring"], "");
        sheet::Request::default().answer(&read(&text)).unwrap().sets.remove(0)
    };
    let sheet = stage("-0.2935");
    assert!(sheet.meshes.iter().all(|mesh| near(mesh.centre_distance_m, 0.155, 1e-5)));
    assert!(sheet.meshes.iter().all(|mesh| mesh.backlash_m.abs() < 2e-6));
    // 152.72 mm without backlash, so at 155 mm the flanks of the ring's mesh overlap or gape.
    assert!(stage("0.2935").meshes[1].backlash_m.abs() > 1e-3);
}

/// Every set that a file can describe has an answer or a reason that names what it lacks.
fn tried(text: &str) {
    let Ok(gearbox) = Gearbox::parse("box.yaml", text.as_bytes()) else { return };
    let load = Load {
        torque: Some("100 N·m".parse().unwrap()),
        speed: Some("1000 rpm".parse().unwrap()),
        ..Load::default()
    };
    let request = strength::Request { load, factors: true, ..strength::Request::default() };
    if let Ok(strength) = request.answer(&gearbox) {
        for one in &strength.at_point {
            // Both gears of a mesh push each other with one force.
            let mate = strength.at_point.iter().find(|other| {
                (&other.gear, &other.mesh) == (&one.gear, &one.mesh) && other.toothed_gear != one.toothed_gear
            });
            assert_eq!(mate.unwrap().tangential_force_n.to_bits(), one.tangential_force_n.to_bits());
        }
    }
    if let Ok(sheets) = sheet::Request::default().answer(&gearbox) {
        for set in &sheets.sets {
            // Of a planet all meshes with central gears have one centre distance in mm.
            let names = |mesh: &MeshSheet| mesh.mesh.gears.clone();
            let central =
                set.meshes.iter().filter(|mesh| names(mesh).iter().any(|gear| !gear.starts_with("planet")));
            let distances: Vec<f64> = central.map(|mesh| mesh.centre_distance_m).collect();
            if set.gears.len() < 5 && set.meshes.len() < 3 {
                assert!(distances.iter().all(|one| near(*one, distances[0], 1e-9)), "{text}");
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn no_kind_of_set_stops_an_answer(
        kind in 0..8_usize, z1 in 15..40_u32, z2 in 12..40_u32, z3 in 12..40_u32, more in 0..30_u32,
        x in proptest::array::uniform4(-0.4..0.6_f64), shifted: bool, helix in 0..20_u32,
    ) {
        let ring = z1 + 2 * z2 + more;
        let (kind, gears, teeth, planets): (_, &[&str], _, _) = match kind {
            0 => ("simple", &["sun", "planet", "ring"], [z1, z1 + 2 * z2], vec![z2]),
            1 => ("double_planet", &["sun", "planet 1", "planet 2", "ring"], [z1, ring], vec![z2, z3]),
            2 => ("stepped_sun_ring", &["sun", "planet 1", "planet 2", "ring"], [z1, ring], vec![z2, z3]),
            3 => ("stepped_suns", &["sun 1", "planet 1", "planet 2", "sun 2"], [z1, z1 + more], vec![z2, z3]),
            4 => ("stepped_rings", &["ring 1", "planet 1", "planet 2", "ring 2"], [ring, ring + 3], vec![z2, z3]),
            5 => ("meshing_suns", &["sun 1", "planet 1", "planet 2", "sun 2"], [z1, z1 + more], vec![z2, z3]),
            6 => ("external_pair", &["gear 1", "gear 2"], [z1, z2], vec![]),
            _ => ("internal_pair", &["gear 1", "gear 2"], [z2, ring], vec![]),
        };
        let mut set = format!("kind: {kind}, sun: a, teeth: {teeth:?}, module: 3 mm, face_width: 30 mm, helix_angle: {helix} deg");
        if planets.is_empty() {
            set += ", ring: h";
        } else {
            set += &format!(", ring: ground, carrier: h, planet_teeth: {planets:?}, planets: 3");
        }
        if shifted {
            let shifts: Vec<String> = x[..gears.len()].iter().map(|x| format!("{x:.3}")).collect();
            set += &format!(", profile_shifts: [{}]", shifts.join(", "));
        }
        tried(&file("sets", &set, gears, ""));
    }
}

/// What stands under the name of no gear or mesh is refused and not passed over.
#[test]
fn values_of_gears_that_there_are_not_are_refused() {
    let text = simple("0 deg");
    for (key, named) in [
        (
            "rims: { rong: 9 mm }",
            "strength.rims.rong: `rims` has no `rong`; there are sun, planet, ring; write ring?",
        ),
        ("gear_factors: { moon: { Y_ST: 2 } }", "strength.gear_factors.moon"),
        ("gear_factors: { sun: { K_A: 2 } }", "strength.gear_factors.sun.K_A: K_A is of a mesh"),
        ("mesh_factors: { sun-planet: { K_A: 2 }, planet-sun: { K_A: 2 } }", "`mesh_factors` is given twice"),
        ("mesh_factors: { sun-ring: { K_A: 1.2 } }", "mesh_factors"),
        (
            "accuracy: { pitch_deviations: [8 µm, 8 µm, 8 µm], profile_deviations: [8 µm, 8 µm, 8 µm], bores: { moon: 9 mm } }",
            "accuracy.bores",
        ),
        (
            "accuracy: { pitch_deviations: { sun: 8 µm }, profile_deviations: [8 µm, 8 µm, 8 µm] }",
            "pitch_deviations",
        ),
    ] {
        let wrong = text.replace("shaper: { teeth: 30 }", &format!("shaper: {{ teeth: 30 }}, {key}"));
        let load = Load {
            torque: Some("100 N·m".parse().unwrap()),
            speed: Some("1000 rpm".parse().unwrap()),
            ..Load::default()
        };
        let request = strength::Request { load, ..strength::Request::default() };
        let error = match Gearbox::parse("box.yaml", wrong.as_bytes()) {
            Ok(gearbox) => request.answer(&gearbox).unwrap_err().to_string(),
            Err(error) => error.to_string(),
        };
        assert!(error.contains(named), "{error}");
    }
}

/// Keys for gears of a kind that a set has not, and misspelt gears, each at its place, all at once.
#[test]
fn keys_for_kinds_of_gears_that_there_are_not_are_refused() {
    let given = "planet_rim: 9 mm, ring_rim: 9 mm, sun_mesh_factors: { K_v: 1.1 }, ring_mesh_factors: { K_v: 1.1 }, sun_factors: { Y_S: 2 }, \
                 planet_factors: { Y_S: 2 }, ring_factors: { Y_S: 2 }, shaper: { teeth: 30 }";
    let set = "kind: external_pair, sun: a, ring: h, teeth: [19, 40], module: 3 mm, face_width: 30 mm";
    let wrong =
        file("sets", set, &["gear 1", "gear 2"], "").replace("factors: {", &format!("{given}, factors: {{"));
    let load = Load {
        torque: Some("100 N·m".parse().unwrap()),
        speed: Some("1000 rpm".parse().unwrap()),
        ..Load::default()
    };
    let request = strength::Request { load, ..strength::Request::default() };
    let error = request.answer(&read(&wrong)).unwrap_err().to_string();
    for (key, _) in given.split(", ").filter_map(|one| one.trim().split_once(':')) {
        assert!(error.contains(&format!("strength.{key}: set `P`: `{key}` is of")), "{key}: {error}");
    }
    let names = "profile_shifts: { gear1: 0.1 }, face_widths: { gear 3: 9 mm }";
    let set = set.replace("face_width: 30 mm", names);
    let wrong = Gearbox::parse("box.yaml", file("sets", &set, &["gear 1", "gear 2"], "").as_bytes())
        .unwrap_err()
        .to_string();
    for at in ["profile_shifts.gear1: ", "face_widths[\"gear 3\"]: ", "write gear 1?"] {
        assert!(wrong.contains(at), "{at}: {wrong}");
    }
}

/// Gears without allowances beside gears that have some are named, and their limits are those of 0 as
/// written.
#[test]
fn allowances_of_gears_that_are_left_out_are_warned_of() {
    let of = |given: &[&str]| {
        let given: Vec<String> = given.iter().map(|gear| format!("{gear}: [-60 um, -40 um]")).collect();
        let sheet =
            format!("data_sheet: {{ thickness_allowances: {{ {} }} }}, face_width:", given.join(", "));
        let text = simple("0 deg").replace("face_width:", &sheet);
        sheet::Request::default().answer(&read(&text)).unwrap()
    };
    let gears = ["sun", "planet", "ring"];
    for given in [&["sun"][..], &["planet", "ring"], &gears] {
        let found = of(given);
        let warned: Vec<_> = found.warnings.iter().filter(|one| one.name == "allowances-assumed").collect();
        let missing: Vec<&str> = gears.into_iter().filter(|gear| !given.contains(gear)).collect();
        assert_eq!(warned.len(), usize::from(!missing.is_empty()), "{given:?}");
        if let [warning] = warned[..] {
            let named = format!("has nothing of {};", missing.join(" and "));
            assert!(warning.message.contains(&named), "{}", warning.message);
        }
        let limits = found.sets[0].thickness_allowances_m.clone().unwrap();
        for (gear, limits) in gears.iter().zip(limits) {
            assert_eq!(limits.upper < 0.0, given.contains(gear), "{gear}");
        }
    }
    let plain = sheet::Request::default().answer(&read(&simple("0 deg"))).unwrap();
    assert!(plain.warnings.iter().all(|one| one.name != "allowances-assumed"));
}

/// Allowances that leave flanks no room are warned of, in `sheet` and in its chapter of a report.
#[test]
fn flanks_that_overlap_within_their_allowances_are_warned_of() {
    let sheet =
        "data_sheet: { thickness_allowances: [[-0.05 mm, 0.02 mm], [-0.05 mm, 0 mm], [-0.05 mm, 0 mm]] }";
    let text = simple("0 deg").replace("face_width:", &format!("{sheet}, face_width:"));
    let found = sheet::Request::default().answer(&read(&text)).unwrap();
    let warned: Vec<&str> =
        found.warnings.iter().filter(|one| one.name == "backlash").map(|one| one.message.as_str()).collect();
    assert_eq!(warned.len(), 1, "{:?}", found.warnings);
    assert!(warned[0].contains("the flanks of sun and planet press into each other"), "{}", warned[0]);
    let text = text.replace("0.02 mm]", "-0.01 mm]");
    let found = sheet::Request::default().answer(&read(&text)).unwrap();
    assert!(found.warnings.iter().all(|one| one.name != "backlash"), "{:?}", found.warnings);
}

/// In gear 2 the large sun is held: it and the ring load one flank of the long planet. In gear 1 it is free.
#[test]
fn several_meshes_on_one_flank_are_warned_of() {
    let gears = ["s", "l", "r", "short", "long"];
    let set = "carrier: h, suns: { s: 31, l: 38 }, rings: { r: 85 }, planet_gears: { short: [20], long: [23] }, planets: 3, module: 2 mm, face_width: 30 mm, \
               meshes: [{ gears: [s, short] }, { gears: [short, long] }, { gears: [l, long] }, { gears: [long, r] }], \
               profile_shifts: { s: 0.1, l: 0.1, short: 0.1, long: 0.1, r: 0.1 }";
    let text = file("compound_sets", set, &gears, "brakes: [{ id: B1, link: l }, { id: B2, link: h }]\n");
    let text = text
        .replace("input: a\noutput: h", "input: s\noutput: r")
        .replace("{ name: only, engaged: [] }", "{ name: '2', engaged: [B1] }, { name: '1', engaged: [B2] }")
        .replace("factors: {", "shaper: { teeth: 30 }, factors: {");
    let duty = "duty: [{ gear: '2', share: 100 %, speed: 1000 rpm, torque: 100 N·m }]\n";
    let over_duty = strength::Request::default().answer(&read(&format!("{text}{duty}"))).unwrap();
    // In one step the damage together is the sum of those of the meshes.
    let [shared] = &over_duty.shared_flanks[..] else { panic!("{:?}", over_duty.shared_flanks) };
    let own = over_duty
        .over_duty
        .iter()
        .filter(|one| one.toothed_gear == "long" && shared.meshes.contains(&one.mesh));
    let own: Vec<f64> = own.map(|one| one.flank.as_ref().unwrap().damage.unwrap()).collect();
    assert!(
        own.len() == 2 && near(shared.flank_damage.unwrap(), own.iter().sum(), 1e-12),
        "{shared:?} {own:?}"
    );
    // Its safety together is below that of each mesh; stresses that many times higher, by the square of the
    // torque, bring the damage 1.
    let own = over_duty.over_duty.iter().filter(|one| one.toothed_gear == "long");
    let own = own.filter(|one| shared.meshes.contains(&one.mesh));
    let least = own.map(|one| one.flank.as_ref().unwrap().safety).fold(f64::INFINITY, f64::min);
    assert!(shared.flank_safety <= least, "{shared:?} {least}");
    let at_limit = format!("{} N·m }}]", 100.0 * shared.flank_safety.powi(2));
    let at_limit = format!("{text}{}", duty.replace("100 N·m }]", &at_limit));
    let at_limit = strength::Request::default().answer(&read(&at_limit)).unwrap().shared_flanks.remove(0);
    assert!(
        near(at_limit.flank_damage.unwrap(), 1.0, 1e-6) && near(at_limit.flank_safety, 1.0, 1e-9),
        "{at_limit:?}"
    );
    // A simple set that is driven both ways loads each flank of its planets by both meshes in turn.
    let both = "duty: [{ gear: only, share: 50 %, speed: 1000 rpm, torque: 400 N·m }, { gear: only, share: 50 %, speed: 1000 rpm, torque: -400 N·m }]\n";
    let both = strength::Request::default().answer(&read(&format!("{}{both}", simple("0 deg")))).unwrap();
    let gears: Vec<&str> = both.shared_flanks.iter().map(|one| one.toothed_gear.as_str()).collect();
    assert_eq!(gears, ["planet"]);
    let warned = rated(&text, "100 N·m").warnings;
    let warned: Vec<&str> =
        warned.iter().filter(|one| one.name == "shared-flank").map(|one| one.message.as_str()).collect();
    assert_eq!(warned.len(), 1, "{warned:?}");
    assert!(warned[0].contains("the long in gear 2"), "{warned:?}");
}

/// Friction of the gearbox that a set's teeth do not suffice for is no loss, and a warning says so.
#[test]
fn friction_that_is_not_applied_is_warned_of() {
    let of = |set: &str| {
        let text = format!(
            "gearbox: P\ninput: a\noutput: h\nfriction: 0.05\nsets: [{{ id: P, sun: a, ring: ground, carrier: h, {set} }}]\ngears: [{{ name: only }}]\n"
        );
        let gearbox = read(&text);
        let analyze::Analysis::Overview(overview) = analyze::Request::default().answer(&gearbox).unwrap()
        else {
            panic!()
        };
        let told: Vec<String> = overview
            .warnings
            .into_iter()
            .filter(|one| one.name == "friction")
            .map(|one| one.message)
            .collect();
        (told, gearbox.has_losses())
    };
    for (set, lacks) in [
        ("k: 3", "`teeth` are missing"),
        ("teeth: [20, 63], planet_teeth: [21]", "it needs `profile_shifts`"),
    ] {
        let (told, loses) = of(set);
        assert!(!loses && told.len() == 1 && told[0].contains(lacks), "{told:?}");
    }
    assert_eq!(of("teeth: [20, 60], planet_teeth: [20]"), (vec![], true));
    assert_eq!(of("k: 3, efficiency: 0.97"), (vec![], true));
}

/// A pair has no planets: each key of theirs is refused at its place, all at once.
#[test]
fn keys_of_planets_are_refused_in_a_pair() {
    let keys = [
        ("planet_teeth", "[20]"),
        ("planets", "3"),
        ("spacing", "equal"),
        ("floating", "sun"),
        ("planet_bore", "9 mm"),
        ("planet_mass", "9 kg"),
        ("load_rating", "9 kN"),
        ("bearing_rolling", "balls"),
        ("static_load_rating", "9 kN"),
        ("fatigue_limit", "9 kN"),
        ("bearing_diameter", "9 mm"),
        ("bearing_span", "9 mm"),
    ];
    let given: Vec<String> = keys.iter().map(|(key, value)| format!("{key}: {value}")).collect();
    let set = format!(
        "kind: external_pair, sun: a, ring: h, teeth: [19, 40], profile_shifts: [0.1, 0], {}",
        given.join(", ")
    );
    let text =
        format!("gearbox: P\ninput: a\noutput: h\nsets: [{{ id: P, {set} }}]\ngears: [{{ name: only }}]\n");
    let error = Gearbox::parse("box.yaml", text.as_bytes()).unwrap_err().to_string();
    assert_eq!(error.lines().count(), keys.len(), "{error}");
    for (key, _) in keys {
        assert!(error.contains(&format!("sets[0].{key}: set `P`: `{key}` is of planets")), "{key}: {error}");
    }
}
