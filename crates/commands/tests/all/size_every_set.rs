//! Sizes of sets of every kind: files written with them, other descriptions of the same set, and the trial of
//! every design.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "helpers of tests, which clippy does not know for such"
)]

use epicyclic_commands::shared::gearbox::Gearbox;
use epicyclic_commands::shared::judgement::answer::Judged;
use epicyclic_commands::size::answer::records::SizedDesign;
use epicyclic_commands::size::{self, Request, Size};
use epicyclic_commands::strength;
use epicyclic_commands::words::request;
use epicyclic_formats::Document;
use epicyclic_gears::ToothCount;
use epicyclic_gears::geometry::GearKind;
use epicyclic_gears::involute::profile::Cutting;
use epicyclic_gears::involute::tool::{Shaper, Tool};
use epicyclic_gears::involute::{InvoluteGear, Pair, Profile};
use epicyclic_judge::{Rule, Severity};
use epicyclic_strength::material;
use epicyclic_strength::sizing::bearing::{Bearing, listed};
use std::ops::ControlFlow;
use uom::si::length::millimeter;
use uom::si::mass_density::kilogram_per_cubic_meter;

const OIL: &str = "oil: { viscosity: 220 mm²/s }\nlife: 3000 h\nrequired: { flank: 1, root: 1.3 }\n";

/// Strength of gears by name; rings of another steel.
fn steels(gears: &[&str], rings: &[&str]) -> String {
    let each = |value: &dyn Fn(&str) -> &'static str| {
        let all: Vec<String> = gears.iter().map(|gear| format!("{gear}: {}", value(gear))).collect();
        format!("{{ {} }}", all.join(", "))
    };
    let steel = |gear: &str| if rings.contains(&gear) { "34CrNiMo6" } else { "18CrNiMo7-6" };
    let shaper = if rings.is_empty() { "" } else { "shaper: { teeth: 22 }, " };
    format!(
        "strength: {{ materials: {}, flank_roughness: {}, root_roughness: {}, {shaper}factors: {{ K_A: 1.25, K_v: 1.05, K_H_beta: 1.2, K_H_alpha: 1, K_F_alpha: 1, Y_delta_rel_T_stat: 1 }} }}",
        each(&steel),
        each(&|_| "4 µm"),
        each(&|_| "16 µm"),
    )
}

fn wolfrom(more: &str) -> String {
    format!(
        "gearbox: wolfrom\ninput: s\noutput: out\ncompound_sets:\n  - id: W\n    carrier: arm\n    suns: {{ s: 18 }}\n    \
         rings: {{ ground: 66, out: 63 }}\n    planet_gears: {{ p: [24, 21] }}\n    planets: 3\n    \
         meshes: [{{ gears: [s, p.1] }}, {{ gears: [p.1, ground] }}, {{ gears: [p.2, out] }}]\n    {}\n{more}\
         gears: [{{ name: '1' }}]\nduty: [{{ gear: '1', share: 1, torque: 10 N·m, speed: 1500 rpm }}]\n{OIL}",
        steels(&["s", "ground", "out", "p.1", "p.2"], &["ground", "out"])
    )
}

fn ravigneaux() -> String {
    format!(
        "gearbox: six\ninput: turbine\noutput: ring\ncompound_sets:\n  - id: W\n    carrier: carrier\n    \
         suns: {{ small_sun: 31, large_sun: 38 }}\n    rings: {{ ring: 85 }}\n    planet_gears: {{ short: [20], long: [23] }}\n    \
         planets: 3\n    meshes: [{{ gears: [small_sun, short] }}, {{ gears: [short, long] }}, {{ gears: [large_sun, long] }}, \
         {{ gears: [long, ring] }}]\n    {}\nclutches: [{{ id: A, links: [turbine, small_sun] }}, {{ id: B, links: [turbine, carrier] }}]\n\
         brakes: [{{ id: C, link: large_sun }}, {{ id: D, link: carrier }}]\n\
         gears: [{{ name: '1', engaged: [A, D] }}, {{ name: '2', engaged: [A, C] }}, {{ name: '4', engaged: [B, C] }}]\n\
         duty: [{{ gear: '1', share: 0.2, torque: 200 N·m, speed: 1500 rpm }}, {{ gear: '2', share: 0.3, torque: 150 N·m, speed: 1500 rpm }}, \
         {{ gear: '4', share: 0.5, torque: 100 N·m, speed: 1500 rpm }}]\n{OIL}",
        steels(&["small_sun", "large_sun", "ring", "short", "long"], &["ring"])
    )
}

/// A set with two central gears; the gears in the order of their names.
fn short(keys: &str, gears: &[&str], rings: &[&str], torque: f64) -> String {
    let carrier = if keys.contains("pair") { "" } else { "carrier: h, " };
    let output = if carrier.is_empty() { "b" } else { "h" };
    let ring = if carrier.is_empty() { "b" } else { "ground" };
    format!(
        "gearbox: one\ninput: a\noutput: {output}\nsets:\n  - {{ id: W, sun: a, ring: {ring}, {carrier}{keys}, {} }}\n\
         gears: [{{ name: '1' }}]\nduty: [{{ gear: '1', share: 1, torque: {torque} N·m, speed: 1500 rpm }}]\n{OIL}",
        steels(gears, rings)
    )
}

fn every_kind() -> Vec<String> {
    let double = ["sun", "planet 1", "planet 2", "ring"];
    vec![
        wolfrom(""),
        ravigneaux(),
        // A cutter of more teeth has wider tips.
        ravigneaux().replace("teeth: 22 }", "teeth: 30 }") + "pressure_angle: 22.5 deg\n",
        short("kind: external_pair, teeth: [24, 95], helix_angle: 10 deg", &["gear 1", "gear 2"], &[], 100.0),
        short("kind: internal_pair, teeth: [20, 71]", &["gear 1", "gear 2"], &["gear 2"], 60.0),
        short(
            "kind: double_planet, teeth: [30, 72], planet_teeth: [18, 20], planets: 3",
            &double,
            &["ring"],
            60.0,
        ),
        short(
            "kind: stepped_sun_ring, teeth: [18, 117], planet_teeth: [66, 33], planets: 3",
            &double,
            &["ring"],
            40.0,
        ),
        short("teeth: [24, 84]", &["sun", "planet", "ring"], &["ring"], 90.0),
    ]
    .into_iter()
    .chain(every_tilted_kind())
    .collect()
}

/// Sets whose planets helical teeth tilt: between sun and ring, with gears of both hands, and in mesh with
/// each other. Masses are stated, so that sizes and strength have the same.
fn every_tilted_kind() -> [String; 4] {
    let of_planets = "    helix_angle: 12 deg\n    planet_sizes: { short: { mass: 0.3 kg }, long: { mass: 0.4 kg } }\n    ";
    [
        short(
            "teeth: [24, 84], helix_angle: 15 deg, planet_mass: 0.5 kg",
            &["sun", "planet", "ring"],
            &["ring"],
            90.0,
        ),
        short(
            "kind: double_planet, teeth: [30, 72], planet_teeth: [18, 20], planets: 3, helix_angle: -12 deg, planet_mass: 0.5 kg",
            &["sun", "planet 1", "planet 2", "ring"],
            &["ring"],
            60.0,
        ),
        short(
            "kind: stepped_sun_ring, teeth: [18, 117], planet_teeth: [66, 33], planets: 3, helix_angles: [8 deg, -14 deg], planet_mass: 2 kg",
            &["sun", "planet 1", "planet 2", "ring"],
            &["ring"],
            40.0,
        ),
        ravigneaux().replacen("    strength:", &format!("{of_planets}strength:"), 1),
    ]
}

fn small() -> Request {
    let words = "--modules=2mm, 3mm, 4mm|--face-widths=15mm, 20mm, 30mm, 40mm|--planet-rim=2|--bearing-type=balls,rollers|\
                 --centre-distance-step=1mm";
    request(words.split('|')).unwrap()
}

fn sized(text: &str, request: &Request) -> Size {
    let gearbox =
        Gearbox::parse("box.yaml", text.as_bytes()).unwrap_or_else(|error| panic!("{error}: {text}"));
    request.answer(&gearbox, &|| ControlFlow::Continue(())).unwrap_or_else(|error| panic!("{error}: {text}"))
}

/// Least safeties of flank and root of each gear in each mesh over the duty, and lives of the bearings.
fn rated(text: &str) -> (Vec<[f64; 2]>, Vec<f64>) {
    let gearbox =
        Gearbox::parse("box.yaml", text.as_bytes()).unwrap_or_else(|error| panic!("{error}: {text}"));
    let told =
        strength::Request::default().answer(&gearbox).unwrap_or_else(|error| panic!("{error}: {text}"));
    let safeties = told
        .over_duty
        .iter()
        .map(|one| [one.flank.as_ref().unwrap().safety, one.root.as_ref().unwrap().safety])
        .collect();
    (safeties, told.bearings.iter().map(|one| one.basic_life_s.unwrap()).collect())
}

fn safeties(design: &SizedDesign) -> Vec<[f64; 2]> {
    design.over_duty.iter().map(|one| [one.flank.safety, one.root.safety]).collect()
}

/// `strength` rates the saved file of every kind of set, in which the safeties and lives are those found.
#[test]
fn the_saved_file_of_every_kind_has_what_was_found() {
    for text in every_kind() {
        let size = sized(&text, &small());
        assert_eq!((size.sets.len(), size.not_sized.len()), (1, 0), "{text}");
        let Some(best) = size.sets[0].found.first() else {
            panic!("{:?} {:?} {text}", size.warnings, size.sets[0].left_out)
        };
        let saved = size::saved(&Document::parse_one("box.yaml", text.as_bytes()).unwrap(), &size).unwrap();
        let (told, lives) = rated(&saved);
        let found = safeties(best);
        assert_eq!(found.len(), told.len(), "{saved}");
        for (one, other) in found.iter().flatten().zip(told.iter().flatten()) {
            assert!((one / other - 1.0).abs() < 1e-9, "{found:?} {told:?} {saved}");
        }
        assert!(told.iter().all(|[flank, root]| *flank >= 1.0 && *root >= 1.3));
        // Masses of planets that are not stated differ by the density of material and file.
        let is_mass_stated = text.contains("mass");
        let nearness = if is_mass_stated { 1e-9 } else { 1e-2 };
        for (planet, life) in best.planet_sizes.iter().zip(&lives) {
            let bearing = planet.bearing.as_ref().unwrap();
            let found = bearing.life_s.unwrap();
            assert!(
                (found / life - 1.0).abs() < nearness && *life > (1.0 - nearness) * 3000.0 * 3600.0,
                "{found} {life} {saved}"
            );
            // Helical teeth, and steps side by side, ask for two rows.
            let is_tilted = text.contains("helix") && is_mass_stated
                || text.contains("stepped")
                || text.contains("wolfrom");
            assert_eq!(bearing.span_m.is_some(), is_tilted && saved.contains("bearing_span"));
        }
        assert!(!size.warnings.iter().any(|one| one.name == "tilting-moment"), "{:?}", size.warnings);
    }
}

/// A design is usual if and only if its file misses none of the rules that follow from sizes.
#[test]
fn a_usual_design_has_no_warning_of_its_sizes() {
    let of_sizes = [
        Rule::FaceWidth,
        Rule::FaceLoad,
        Rule::SpecificSliding,
        Rule::SunShift,
        Rule::PlanetShift,
        Rule::RingShift,
        Rule::GearShift,
        Rule::ShiftSum,
        Rule::ExternalAngle,
        Rule::InternalAngle,
        Rule::HardenedTips,
        Rule::SpurContact,
        Rule::HelicalContact,
        Rule::RootClearance,
        Rule::RingRim,
        Rule::PlanetRim,
        Rule::NeighbourGap,
        Rule::NeighbourGapLength,
        Rule::PinSpeed,
        Rule::FullPinSpeed,
        Rule::OrbitAcceleration,
        Rule::NeedleAcceleration,
        Rule::SpurSpeed,
        Rule::HelicalSpeed,
        Rule::BearingStaticSafety,
        Rule::BallLoad,
        Rule::BearingLeastLoad,
        Rule::LoadSharing,
    ];
    let is_of_sizes = |name: &str| of_sizes.iter().any(|rule| rule.name() == name);
    let peak = "overload: [{ gear: '1', torque: 90 N·m }]\n";
    let mut seen = [0; 2];
    for text in every_kind() {
        // Slow and fast, with wide gears, with a factor for narrow ones, against an overload.
        let texts = [
            text.clone(),
            text.replace("speed: 1500 rpm", "speed: 12000 rpm"),
            text.replace("K_H_beta: 1.2", "K_H_beta: 1.05"),
            text.clone() + peak,
        ];
        let narrow = Request { face_widths: Some("6 mm, 10 mm".parse().unwrap()), ..small() };
        for (text, request) in texts.iter().map(|text| (text, small())).chain([(&text, narrow)]) {
            let size = sized(text, &request);
            let Some(best) = size.sets[0].found.first() else { continue };
            let misses = |check: &&Judged| !check.holds && check.severity > Severity::Remark;
            let missed: Vec<&Judged> = size.judgement.checks.iter().filter(misses).collect();
            let own: Vec<&&Judged> = missed.iter().filter(|check| is_of_sizes(check.name)).collect();
            assert_eq!(best.rules_missed == 0, own.is_empty(), "{own:?} {text}");
            seen[usize::from(best.rules_missed == 0)] += 1;
        }
    }
    assert!(seen.iter().all(|count| *count > 2), "{seen:?}");
}

/// A saved file, sized again, has the design that it was saved with.
#[test]
fn a_saved_file_has_the_same_size_again() {
    for text in every_kind() {
        let first = sized(&text, &small());
        let saved = |text: &str, size: &Size| {
            size::saved(&Document::parse_one("box.yaml", text.as_bytes()).unwrap(), size).unwrap()
        };
        let text = saved(&text, &first);
        let second = sized(&text, &small());
        let [one, other] = [&first, &second]
            .map(|size| size.sets[0].found.first().unwrap_or_else(|| panic!("{:?} {text}", size.warnings)));
        let near = |one: f64, other: f64| assert!((one / other - 1.0).abs() < 1e-9, "{one} {other} {text}");
        near(one.mass_kg, other.mass_kg);
        assert_eq!(one.planets, other.planets);
        for (one, other) in one.families.iter().zip(&other.families) {
            near(one.module_m, other.module_m);
        }
        for (one, other) in one.gears.iter().zip(&other.gears) {
            near(one.face_width_m, other.face_width_m);
            assert!((one.profile_shift - other.profile_shift).abs() < 1e-9, "{text}");
        }
        for (one, other) in one.planet_sizes.iter().zip(&other.planet_sizes) {
            let [one, other] = [one, other].map(|planet| planet.bearing.as_ref().unwrap());
            near(one.load_rating_n, other.load_rating_n);
            near(one.outside_diameter_m.unwrap(), other.outside_diameter_m.unwrap());
            near(one.life_s.unwrap(), other.life_s.unwrap());
        }
        for (one, other) in safeties(one).iter().flatten().zip(safeties(other).iter().flatten()) {
            near(*one, *other);
        }
    }
}

/// A stated distance of the rows is kept, load ratings without one leave the moment out with a warning, and one
/// row alone is refused. An axial force that stays on stepped planets is warned of.
#[test]
fn rows_of_tilted_planets_are_stated_or_chosen_or_refused() {
    let [simple, double, stepped, ravigneaux] = every_tilted_kind();
    let with = |keys: &str| simple.replace("planet_mass", &format!("{keys}, planet_mass"));
    let warned = |size: &Size, name: &str| size.warnings.iter().any(|one| one.name == name);
    let bearing = |size: &Size| size.sets[0].found[0].planet_sizes[0].bearing.clone().unwrap();
    let chosen = sized(&simple, &small());
    let (own, width) = (bearing(&chosen), chosen.sets[0].found[0].families[0].face_width_m);
    assert!((own.span_m.unwrap() - (width - own.width_m.unwrap() / 2.0)).abs() < 1e-12, "{own:?}");
    assert!(own.designation.unwrap().starts_with("2 x "));
    let stated = sized(&with("bearing_span: 13 mm"), &small());
    assert!((bearing(&stated).span_m.unwrap() - 0.013).abs() < 1e-12 && !warned(&stated, "tilting-moment"));
    let rating = "load_rating: 60 kN, bearing_rolling: rollers, planet_bore: 40 mm";
    let [alone, spanned] = ["", ", bearing_span: 13 mm"].map(|span| {
        let size = sized(&with(&format!("{rating}{span}")), &small());
        (bearing(&size).life_s.unwrap(), bearing(&size).span_m, warned(&size, "tilting-moment"))
    });
    assert!(spanned.0 < alone.0 && alone.1.is_none() && alone.2 && !spanned.2, "{alone:?} {spanned:?}");
    for text in [&simple, &double, &ravigneaux] {
        let gearbox = Gearbox::parse("box.yaml", text.as_bytes()).unwrap();
        let one_row = Request { bearing_rows: 1, ..small() };
        let refused = one_row.answer(&gearbox, &|| ControlFlow::Continue(())).unwrap_err().to_string();
        assert!(refused.contains("--bearing-rows") && refused.contains("pairs of bearings"), "{refused}");
        assert!(!warned(&sized(text, &small()), "axial-force"));
    }
    assert!(warned(&sized(&stepped, &small()), "axial-force"));
    let bearings = Request { bearing_rows: 1, no_bearings: true, ..small() };
    assert!(sized(&simple, &bearings).warnings.iter().all(|one| one.name != "tilting-moment"));
}

/// A stated bore takes bearings of this outside diameter; where there are none, it is said.
#[test]
fn bearings_fit_a_stated_bore_or_are_missed() {
    let with = |bore: &str| {
        let text = short("teeth: [24, 84]", &["sun", "planet", "ring"], &["ring"], 90.0);
        sized(&text.replace("teeth: [24, 84]", &format!("teeth: [24, 84], planet_bore: {bore}")), &small())
    };
    let told = |size: &Size| {
        let of = |warning: &epicyclic_commands::answer::Warning| warning.name == "no-bearing";
        size.warnings.iter().find(|one| of(one)).map(|warning| warning.message.clone())
    };
    let fits = with("35 mm");
    let bearing = fits.sets[0].found[0].planet_sizes[0].bearing.as_ref().unwrap();
    assert!((bearing.outside_diameter_m.unwrap() - 0.035).abs() < 1e-12 && bearing.designation.is_some());
    assert_eq!(told(&fits), None);
    let none = with("36.5 mm");
    assert_eq!(none.sets[0].found[0].planet_sizes[0].bearing, None);
    assert!(told(&none).unwrap().contains("keep their bore of 36.5 mm without a bearing"), "{none:?}");
    let solid = Request { no_bearings: true, ..small() };
    let text = short("teeth: [24, 84], planet_bore: 36.5 mm", &["sun", "planet", "ring"], &["ring"], 90.0);
    assert_eq!(told(&sized(&text, &solid)), None);
}

/// `size` and `strength` refuse the same values at the same place.
#[test]
fn sizes_and_strength_refuse_alike() {
    let text = |keys: &str, speed: &str| {
        let keys = format!("teeth: [24, 84], planet_teeth: [30], planets: 3, {keys}");
        short(&keys, &["sun", "planet", "ring"], &["ring"], 90.0).replace("speed: 1500 rpm", speed)
    };
    let sized_keys = "module: 3 mm, face_width: 30 mm, profile_shifts: [0, 0, 0]";
    let span = text(&format!("{sized_keys}, bearing_span: 0 mm"), "speed: 1500 rpm");
    let still = text(sized_keys, "speed: 0 rpm");
    let cases = [
        (span, "sets[0].bearing_span: bearing_span must be above 0"),
        (still, "duty[0].speed: speed 0 with a torque: a torque at standstill is a static load"),
    ];
    for (text, why) in cases {
        let gearbox = Gearbox::parse("box.yaml", text.as_bytes()).unwrap();
        let size = small().answer(&gearbox, &|| ControlFlow::Continue(())).unwrap_err().to_string();
        let strength = strength::Request::default().answer(&gearbox).unwrap_err().to_string();
        assert!(size.contains(why) && strength.contains(why), "{size}\n{strength}");
    }
    let gearbox = Gearbox::parse("box.yaml", text("module: 3 mm", "speed: 1500 rpm").as_bytes()).unwrap();
    let rimless = Request { ring_rim: "0".parse().ok(), ..small() };
    let refused = rimless.answer(&gearbox, &|| ControlFlow::Continue(())).unwrap_err().to_string();
    assert!(
        refused.starts_with("--ring-rim: rim of the ring is 0 modules; it must be finite and above 0"),
        "{refused}"
    );
}

/// A search without a size tells what most gears fail.
#[test]
fn the_usual_fault_of_gears_is_told() {
    let size = sized(&(ravigneaux() + "pressure_angle: 22.5 deg\n"), &small());
    let told: Vec<&str> = size.warnings.iter().map(|warning| warning.message.as_str()).collect();
    assert!(told[0].contains("the tool does not cut the ring: the tips of a shaper"), "{told:?}");
    let out = &size.sets[0].left_out;
    assert_eq!(out.geometry, size.sets[0].designs, "{out:?}");
}

/// A simple set gear by gear has the same sizes; with helical teeth the moment on its planets comes from the
/// function for all sets, where that of a simple set is a formula.
#[test]
fn a_simple_set_gear_by_gear_has_the_same_sizes() {
    for helix in ["", "helix_angle: 15 deg, "] {
        let shifts = [0.3, 0.2, -0.7];
        let simple = short(
            &format!(
                "teeth: [24, 84], planet_teeth: [30], planets: 3, {helix}profile_shifts: [0.3, 0.2, -0.7], tip_alterations: [0, 0, -0.4]"
            ),
            &["sun", "planet", "ring"],
            &["ring"],
            90.0,
        );
        let compound = format!(
            "gearbox: one\ninput: a\noutput: h\ncompound_sets:\n  - {{ id: W, suns: {{ a: 24 }}, rings: {{ ground: 84 }}, carrier: h, planets: 3, {helix}\
         planet_gears: {{ p: [30] }}, meshes: [{{ gears: [a, p] }}, {{ gears: [p, ground] }}], \
         profile_shifts: {{ a: {}, p: {}, ground: {} }}, tip_alterations: {{ ground: -0.4 }}, {} }}\n\
         gears: [{{ name: '1' }}]\nduty: [{{ gear: '1', share: 1, torque: 90 N·m, speed: 1500 rpm }}]\n{OIL}",
            shifts[0],
            shifts[1],
            shifts[2],
            steels(&["a", "p", "ground"], &["ground"])
        );
        let [one, other] = [&simple, &compound].map(|text| sized(text, &small()));
        assert!(!one.sets[0].found.is_empty(), "{:?} {:?}", one.warnings, one.sets[0].left_out);
        assert_eq!(one.sets[0].left_out, other.sets[0].left_out);
        assert_eq!(one.sets[0].found.len(), other.sets[0].found.len());
        for (one, other) in one.sets[0].found.iter().zip(&other.sets[0].found) {
            assert!((one.mass_kg / other.mass_kg - 1.0).abs() < 1e-12);
            assert_eq!(one.families[0].module_m, other.families[0].module_m);
            for (one, other) in safeties(one).iter().flatten().zip(safeties(other).iter().flatten()) {
                assert!((one / other - 1.0).abs() < 1e-12, "{one} {other}");
            }
            let [one, other] = [one, other].map(|one| one.planet_sizes[0].bearing.as_ref().unwrap());
            assert_eq!((one.span_m, one.span_m.is_some()), (other.span_m, !helix.is_empty()));
            assert!((one.life_s.unwrap() / other.life_s.unwrap() - 1.0).abs() < 1e-9);
        }
    }
}

/// Every module, pair of widths and bearing of a Wolfrom set, each as a file of its own under `strength`.
#[test]
fn the_best_of_a_wolfrom_set_is_that_of_every_trial() {
    let mm = |length: uom::si::f64::Length| length.get::<millimeter>();
    let bearings: Vec<Bearing> = listed()
        .iter()
        .filter(|bearing| ["6000", "6201", "6203", "6302", "6305"].contains(&bearing.designation.as_str()))
        .cloned()
        .collect();
    let request = Request {
        bearings: Some(bearings.clone()),
        bearing_rows: 2,
        most: 1,
        modules: Some("2mm, 2.5mm, 3mm".parse().unwrap()),
        face_widths: Some("10mm, 15mm, 20mm, 25mm".parse().unwrap()),
        ..small()
    };
    let shifts = "    profile_shifts: { s: 0 }\n    tip_alterations: { ground: -0.25, out: -0.3 }\n";
    let size = sized(&wolfrom(shifts), &request);
    let shaper = Tool::Shaper(Shaper::of_teeth(ToothCount::new(22).unwrap()));
    let gear = |kind, teeth, tip: f64| {
        let cutting = if kind == GearKind::Internal {
            Cutting { tool: Some(shaper), ..Cutting::default() }
        } else {
            Cutting::default()
        };
        let gear =
            InvoluteGear::new(kind, ToothCount::new(teeth).unwrap(), cutting.of(Profile::default()), 0.0);
        gear.unwrap().with_tip_alteration(tip).unwrap()
    };
    let gears = [
        gear(GearKind::External, 18, 0.0),
        gear(GearKind::Internal, 66, -0.25),
        gear(GearKind::Internal, 63, -0.3),
        gear(GearKind::External, 24, 0.0),
        gear(GearKind::External, 21, 0.0),
    ];
    assert!(Pair::without_backlash(gears[0], gears[3]).unwrap().centre_distance() - 21.0 < 1e-12);
    let density =
        |steel: &str| material::listed(steel).unwrap().material.density.get::<kilogram_per_cubic_meter>();
    let (steel, ring_steel) = (density("18CrNiMo7-6"), density("34CrNiMo6"));
    let mut best: Option<(f64, String)> = None;
    for module in [2.0, 2.5, 3.0_f64] {
        for widths in (0..16).map(|place| [place % 4, place / 4].map(|one| 10.0 + 5.0 * f64::from(one))) {
            for bearing in bearings.iter().map(Bearing::pair) {
                let bore = mm(bearing.outside_diameter);
                let rims = [3, 4].map(|place: usize| (gears[place].root_diameter() * module - bore) / 2.0);
                if rims.iter().any(|rim| *rim < 2.0 * module) || mm(bearing.width) > widths[0] + widths[1] {
                    continue;
                }
                let text = wolfrom(&format!(
                    "{shifts}    module: {module} mm\n    face_widths: {{ s: {0} mm, ground: {0} mm, p.1: {0} mm, p.2: {1} mm, out: {1} mm }}\n    \
                     planet_sizes: {{ p: {{ bore: {bore} mm, load_rating: {2} N, bearing_span: {3} mm }} }}\n",
                    widths[0],
                    widths[1],
                    bearing.load_rating.value,
                    widths[0] + widths[1] - mm(bearing.width) / 2.0,
                ))
                .replace("factors:", &format!("rims: {{ p.1: {} mm, p.2: {} mm, ground: {2} mm, out: {2} mm }}, factors:", rims[0], rims[1], 3.5 * module));
                let (safe, lives) = rated(&text);
                let holds = safe.iter().all(|[flank, root]| *flank >= 1.0 && *root >= 1.3);
                if !holds || lives[0] < 3000.0 * 3600.0 {
                    continue;
                }
                let square = |diameter: f64| (diameter * module / 1e3).powi(2);
                let filled =
                    |gear: &InvoluteGear| (square(gear.tip_diameter()) + square(gear.root_diameter())) / 2.0;
                let ring = |gear: &InvoluteGear| square(gear.root_diameter() + 7.0) - filled(gear);
                let planet = |gear: &InvoluteGear| 3.0 * (filled(gear) - (bore / 1e3).powi(2));
                let first = steel * (filled(&gears[0]) + planet(&gears[3])) + ring_steel * ring(&gears[1]);
                let second = steel * planet(&gears[4]) + ring_steel * ring(&gears[2]);
                let mass = std::f64::consts::FRAC_PI_4 * (first * widths[0] + second * widths[1]) / 1e3;
                if best.as_ref().is_none_or(|(least, _)| mass < *least) {
                    best = Some((mass, format!("{module} {widths:?} {}", bearing.designation)));
                }
            }
        }
    }
    let (mass, what) = best.unwrap();
    let found = &size.sets[0].found[0];
    assert!(
        (found.mass_kg / mass - 1.0).abs() < 1e-9,
        "{} for {mass}: {what}, {:?}",
        found.mass_kg,
        found.families
    );
}

/// Gears that a duty loads on both flanks are named, unless the file states how they are bent.
#[test]
fn gears_that_are_driven_both_ways_are_named() {
    let keys = "kind: external_pair, teeth: [24, 95], module: 3 mm, face_width: 40 mm";
    let one_way = short(keys, &["gear 1", "gear 2"], &[], 40.0);
    let step = "{ gear: '1', share: 1, torque: 40 N·m, speed: 1500 rpm }";
    let half = "{ gear: '1', share: 0.5, torque: 40 N·m, speed: 1500 rpm }";
    let both = one_way.replace(step, &format!("{half}, {}", half.replace("40 N·m", "-40 N·m")));
    let stated =
        both.replace("factors:", "gear_factors: { gear 1: { Y_M: 0.7 }, gear 2: { Y_M: 0.7 } }, factors:");
    let warned = |text: &str| {
        let gearbox = Gearbox::parse("box.yaml", text.as_bytes()).unwrap();
        let told = strength::Request::default().answer(&gearbox).unwrap();
        told.warnings.into_iter().find(|warning| warning.name == "reversed-bending")
    };
    assert_eq!((warned(&one_way), warned(&stated)), (None, None));
    assert!(warned(&both).unwrap().message.contains("gear 1, gear 2"));
}

/// Mass, load sharing and widths that the file states of some planets count in their sizes.
#[test]
fn what_the_file_states_of_planets_counts() {
    let heavy = ravigneaux().replace(
        "planets: 3",
        "planets: 3\n    planet_sizes: { long: { mass: 0.6 kg, load_sharing: 1.2 } }\n    face_widths: { long: 32 mm }",
    );
    let size = sized(&heavy, &small());
    let best = size.sets[0].found.first().unwrap_or_else(|| panic!("{:?}", size.warnings));
    let saved = size::saved(&Document::parse_one("box.yaml", heavy.as_bytes()).unwrap(), &size).unwrap();
    let (_, lives) = rated(&saved);
    let found: Vec<f64> =
        best.planet_sizes.iter().map(|planet| planet.bearing.as_ref().unwrap().life_s.unwrap()).collect();
    for (found, life) in found.iter().zip(&lives) {
        assert!((found / life - 1.0).abs() < 1e-2, "{found} {life} {saved}");
    }
    assert!(best.gears.iter().all(|gear| gear.face_width_m == 0.032));
}
