//! Vibration of every kind of set: what is one set in two descriptions has one answer, limits that follow in
//! a second way, and what every set must have.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "helpers of tests, which clippy does not know for such"
)]

use epicyclic_commands::shared::exciting::Exciting;
use epicyclic_commands::shared::gearbox::Gearbox;
use epicyclic_commands::vibrate::answer::records::{Reason, Source, VibratingBody, What};
use epicyclic_commands::vibrate::{Request, Vibration};
use proptest::prelude::*;
use std::f64::consts::TAU;
use std::ops::ControlFlow;

fn answered(text: &str, request: &Request) -> Vibration {
    let gearbox =
        Gearbox::parse("box.yaml", text.as_bytes()).unwrap_or_else(|error| panic!("{error}\n{text}"));
    let goes_on = || ControlFlow::Continue(());
    request.answer(&gearbox, &goes_on).unwrap_or_else(|error| panic!("{error:?}\n{text}"))
}

fn vibration(text: &str) -> Vibration {
    answered(text, &Request::default())
}

/// With speeds and a transmission error.
fn driven(text: &str) -> Vibration {
    let mut request = Request::default();
    request.exciting.speeds = Some("100rpm..3000rpm/3".parse().unwrap());
    request.exciting.transmission_error = vec!["3 um".parse().unwrap()];
    request.exciting.damping = Some("2%".parse().unwrap());
    answered(text, &request)
}

/// A gearbox of one set that is driven at `a`.
fn file(list: &str, set: &str, output: &str) -> String {
    format!(
        "gearbox: one\ninput: a\noutput: {output}\n{list}:\n  - {{ id: P, {set} }}\ngears: [{{ name: only }}]\n"
    )
}

const CARRIER: &str =
    "planet_bearing: 300 N/um, carrier: { mass: 9 kg, inertia: 0.05 kg·m2, support: 200 N/um }";

fn near(one: f64, other: f64, tolerance: f64) -> bool {
    (one - other).abs() <= tolerance * one.abs().max(other.abs())
}

/// Frequencies with their multiplicities.
fn frequencies(all: &Vibration) -> Vec<(f64, u32)> {
    all.sets[0].modes.iter().map(|mode| (mode.frequency_hz, mode.multiplicity)).collect()
}

fn same(one: &Vibration, other: &Vibration) {
    let [one, other] = [one, other].map(frequencies);
    assert_eq!(one.len(), other.len(), "{one:?} {other:?}");
    for (one, other) in one.iter().zip(&other) {
        assert!(near(one.0, other.0, 1e-9) && one.1 == other.1, "{one:?} {other:?}");
    }
}

/// One simple set, described in short and gear by gear.
#[test]
fn a_simple_set_gear_by_gear_is_the_same_set() {
    let short = driven(&file(
        "sets",
        &format!(
            "sun: a, ring: ground, carrier: h, teeth: [24, 84], planet_teeth: [30], planets: 4, module: 3 mm, face_width: 40 mm, vibration: {{ {CARRIER}, sun: {{ support: 20 N/um }}, ring: {{ outside_diameter: 300 mm, support: 600 N/um, tangential_support: 900 N/um }} }}"
        ),
        "h",
    ));
    let whole = driven(&file(
        "compound_sets",
        &format!(
            "carrier: h, suns: {{ a: 24 }}, rings: {{ ground: 84 }}, planet_gears: {{ p: [30] }}, meshes: [{{ gears: [a, p] }}, {{ gears: [p, ground] }}], planets: 4, module: 3 mm, face_width: 40 mm, vibration: {{ {CARRIER}, bodies: {{ a: {{ support: 20 N/um }}, ground: {{ outside_diameter: 300 mm, support: 600 N/um, tangential_support: 900 N/um }} }} }}"
        ),
        "h",
    ));
    same(&short, &whole);
    // Simple sets have their names; those of the other description are those of its links.
    assert!(short.sets[0].stiffness.is_some() && whole.sets[0].stiffness.is_none());
    let forces = |all: &Vibration| -> Vec<f64> {
        let harmonics = all.responses[0].harmonics.iter();
        harmonics.flat_map(|one| &one.meshes).map(|mesh| mesh.greatest.force_n).collect()
    };
    for (one, other) in forces(&short).iter().zip(&forces(&whole)) {
        assert!(near(*one, *other, 1e-6), "{one} {other}");
    }
    let torsional = |all: &Vibration| -> Vec<f64> {
        all.torsional[0].modes.iter().map(|mode| mode.frequency_hz).collect()
    };
    for (one, other) in torsional(&short).iter().zip(&torsional(&whole)) {
        assert!(near(*one, *other, 1e-9), "{one} {other}");
    }
}

/// A double planet, described in short and gear by gear.
#[test]
fn a_double_planet_gear_by_gear_is_the_same_set() {
    let bodies = |sun: &str, ring: &str| {
        format!(
            "vibration: {{ {CARRIER}, bodies: {{ {sun}: {{ support: 20 N/um }}, {ring}: {{ outside_diameter: 260 mm, support: 600 N/um }} }} }}"
        )
    };
    let size = "planets: 3, module: 3 mm, face_width: 40 mm";
    let short = file(
        "sets",
        &format!(
            "kind: double_planet, sun: a, ring: ground, carrier: h, teeth: [30, 72], planet_teeth: [15, 18], {size}, {}",
            bodies("sun", "ring")
        ),
        "h",
    );
    let whole = file(
        "compound_sets",
        &format!(
            "carrier: h, suns: {{ a: 30 }}, rings: {{ ground: 72 }}, planet_gears: {{ one: [15], two: [18] }}, meshes: [{{ gears: [a, one] }}, {{ gears: [one, two] }}, {{ gears: [two, ground] }}], {size}, {}",
            bodies("a", "ground")
        ),
        "h",
    );
    same(&vibration(&short), &vibration(&whole));
    // Where planets stand behind each other the flanks in contact are others, and so are the frequencies.
    let behind = vibration(&whole.replace("[one, two] }", "[one, two], behind: true }"));
    let ahead = vibration(&whole);
    let pairs = frequencies(&ahead).into_iter().zip(frequencies(&behind));
    assert!(pairs.into_iter().any(|(one, other)| !near(one.0, other.0, 1e-3)));
    // Three meshes of one frequency: the phase between them is not known, and the answer says so.
    let driven = driven(&short);
    assert!(driven.responses.is_empty());
    let unknown = driven.not_calculated.iter().find(|one| one.what == What::Forces).unwrap();
    assert_eq!((unknown.reason, unknown.missing.len()), (Reason::PhasesUnknown, 3));
}

/// Two inertias with a mesh between them: `ω² = k·(r_1²/I_1 + r_2²/I_2)`; on held centres the planar modes
/// are the torsional ones.
#[test]
fn a_pair_swings_as_two_inertias() {
    for (kind, teeth, more) in [
        ("external_pair", "[24, 95]", ""),
        ("internal_pair", "[24, 95]", "bodies: { gear 2: { outside_diameter: 320 mm } }"),
    ] {
        let set = format!(
            "kind: {kind}, sun: a, ring: h, teeth: {teeth}, module: 3 mm, helix_angle: 10 deg, face_width: 40 mm, vibration: {{ {more} }}"
        );
        let all = vibration(&file("sets", &set, "h"));
        let set = &all.sets[0];
        let inertia = |body: usize| {
            let body = &set.bodies[body];
            body.radius_m.powi(2) / body.inertia_kg_m2.unwrap()
        };
        let mesh = &set.springs[0];
        let wanted = (mesh.stiffness_n_m * (inertia(0) + inertia(1))).sqrt() / TAU;
        assert!((mesh.helix_angle_rad.unwrap() - 10_f64.to_radians()).abs() < 1e-12);
        let found = frequencies(&all);
        assert!(found.len() == 2 && near(found[1].0, wanted, 1e-12), "{found:?} {wanted}");
        assert!(near(all.torsional[0].modes[1].frequency_hz, wanted, 1e-12));
    }
}

/// The motion without frequency turns the bodies by their ratios: its kinetic energy has the shares that the
/// speeds of Willis give. Of a stepped planet `z_f` meshes with the ring that stands still.
#[test]
fn the_motion_without_frequency_is_that_of_willis() {
    let set = format!(
        "kind: stepped_sun_ring, sun: a, ring: ground, carrier: h, teeth: [18, 117], planet_teeth: [66, 33], planets: 3, module: 2 mm, face_width: 30 mm, vibration: {{ {CARRIER}, sun: {{ support: 0 N/um }} }}"
    );
    let all = vibration(&file("sets", &set, "h"));
    let set = &all.sets[0];
    let inertia = |body: usize| set.bodies[body].inertia_kg_m2.unwrap_or_default();
    let (circle, mass) = (set.bodies[2].radius_m, set.bodies[3].mass_kg.unwrap());
    // Relative to the carrier, whose speed is 1: the ring −1, planet −117/33, sun (117/33)·(66/18).
    let [sun, planet] = [1.0 + 117.0 / 33.0 * 66.0 / 18.0, 1.0 - 117.0 / 33.0];
    let parts =
        [inertia(0) * sun * sun, inertia(2), 3.0 * (inertia(3) * planet * planet + mass * circle * circle)];
    let whole: f64 = parts.iter().sum();
    let first = &set.modes[0];
    assert_eq!((first.frequency_hz, first.multiplicity), (0.0, 1));
    for (part, name) in parts.into_iter().zip(["sun", "carrier", "planets"]) {
        assert!(near(first.kinetic.of(name).unwrap(), part / whole, 1e-9), "{name}");
    }
}

/// Two planetary stages and a helical parallel one, with rotor and generator.
#[test]
fn the_wind_gearbox_vibrates() {
    let text = std::fs::read_to_string("../../examples/wind-gearbox.yaml").unwrap();
    let all = vibration(&text);
    assert_eq!(all.sets.len(), 3);
    assert!(all.not_calculated.is_empty(), "{:?}", all.not_calculated);
    // All gears that the rotor and the generator leave free: one motion.
    assert_eq!(all.torsional[0].freedoms, 1);
    // The pair with its centres held: the two inertias of its gears.
    let third = &all.sets[2];
    assert!((third.springs[0].helix_angle_rad.unwrap() - 10_f64.to_radians()).abs() < 1e-12);
    assert_eq!(third.modes.iter().map(|mode| mode.multiplicity).sum::<u32>(), 6);
    every_mode_has_its_energy(&all);
    // The rotor holds most of the motion at 0 Hz at the speed of the generator 97 times its own.
    let zero = &all.torsional[0].modes[0];
    let share: f64 = zero
        .kinetic
        .iter()
        .filter(|one| one.links.iter().any(|link| link == "rotor" || link == "generator"))
        .map(|one| one.share)
        .sum();
    assert!(share > 0.95, "{share}");
}

/// Frequencies are numbers of at least 0, and the shares of each energy add up to 1.
fn every_mode_has_its_energy(all: &Vibration) {
    for set in &all.sets {
        for mode in &set.modes {
            let sum = |shares: &[(String, f64)]| shares.iter().map(|one| one.1).sum::<f64>();
            assert!(mode.frequency_hz.is_finite() && mode.frequency_hz >= 0.0);
            assert!(near(sum(&mode.kinetic.0), 1.0, 1e-9), "{}: {mode:?}", set.set);
            match &mode.strain {
                Some(strain) => assert!(near(sum(&strain.0), 1.0, 1e-9), "{}: {mode:?}", set.set),
                None => assert_eq!(mode.frequency_hz, 0.0),
            }
        }
    }
    for mode in all.torsional.iter().flat_map(|gear| &gear.modes) {
        let strain: f64 = mode.strain.iter().map(|one| one.share).sum();
        assert!(near(mode.kinetic.iter().map(|one| one.share).sum(), 1.0, 1e-9));
        assert!(mode.frequency_hz == 0.0 || near(strain, 1.0, 1e-9), "{mode:?}");
    }
}

const RAVIGNEAUX: &str = "gearbox: Ravigneaux
input: in
output: ring
compound_sets:
  - id: R
    carrier: carrier
    suns: { small_sun: 31, large_sun: 38 }
    rings: { ring: 85 }
    planet_gears: { short: [19], long: [23] }
    planets: 3
    spacing: least_unequal
    module: 2 mm
    face_width: 30 mm
    profile_shifts: { large_sun: 0.28, long: 0.25, ring: 0.25 }
    meshes:
      - { gears: [small_sun, short] }
      - { gears: [short, long] }
      - { gears: [large_sun, long] }
      - { gears: [long, ring] }
    vibration:
      planet_bearing: 200 N/um
      carrier: { mass: 4 kg, inertia: 0.01 kg·m2, support: 200 N/um }
      bodies:
        small_sun: { support: 20 N/um, bore: 20 mm }
        large_sun: { support: 30 N/um, bore: 30 mm }
        ring: { support: 300 N/um, outside_diameter: 200 mm }
clutches: [{ id: C1, links: [in, small_sun] }, { id: C2, links: [in, large_sun] }]
brakes: [{ id: B1, link: carrier }, { id: B2, link: large_sun }]
gears: [{ name: first, engaged: [C1, B1] }, { name: second, engaged: [C1, B2] }, { name: back, engaged: [C2, B1] }]
";

/// Of each gear one motion keeps its frequency 0; in gears that load other flanks the frequencies differ, and
/// modes of equal sets of planets are of one kind.
#[test]
fn a_ravigneaux_set_has_modes_in_each_gear() {
    let all = vibration(RAVIGNEAUX);
    every_mode_has_its_energy(&all);
    assert_eq!(all.sets.len(), 3);
    assert!(all.torsional.iter().all(|gear| gear.freedoms == 1));
    for set in &all.sets {
        let zeros = set.modes.iter().filter(|mode| mode.frequency_hz == 0.0);
        assert_eq!(zeros.map(|mode| mode.multiplicity).sum::<u32>(), 1);
        // Five members and six planets with three coordinates each, less the rotation of the held one.
        assert_eq!(set.modes.iter().map(|mode| mode.multiplicity).sum::<u32>(), 3 * (4 + 6) - 1);
    }
    let first = |place: usize| all.sets[place].modes[2].frequency_hz;
    assert!(!near(first(0), first(2), 1e-3));
}

#[test]
fn a_wolfrom_drive_has_modes() {
    let set = "carrier: arm, suns: { a: 32 }, rings: { ground: 100, h: 96 }, planet_gears: { p: [34, 30] }, planets: 4, module: 2 mm, face_width: 30 mm, profile_shifts: {}, meshes: [{ gears: [a, p.1] }, { gears: [p.1, ground] }, { gears: [p.2, h], module: 2 mm }], vibration: { planet_bearing: 300 N/um, carrier: { mass: 4 kg, inertia: 0.02 kg·m2, support: 100 N/um }, bodies: { a: { support: 0 N/um }, h: { outside_diameter: 240 mm, support: 500 N/um } } }";
    let all = driven(&file("compound_sets", set, "h"));
    every_mode_has_its_energy(&all);
    assert_eq!(all.torsional[0].freedoms, 1);
    // The meshes of sun and fixed ring share a frequency and a planet's gear between them; the second step
    // has another frequency.
    let orders: Vec<&str> =
        all.orders.iter().filter(|one| one.harmonic == 1).filter_map(|one| one.part.as_deref()).collect();
    assert!(orders.contains(&"a, ground") && orders.contains(&"h"), "{orders:?}");
    assert!(all.not_calculated.iter().all(|one| one.reason != Reason::PhasesUnknown));
}

/// A set of any kind with the ring, or second gear, on its own link.
fn any_set() -> impl Strategy<Value = (String, u32)> {
    let bodies = |one: &str, other: &str, ring: &str| {
        format!(
            "vibration: {{ {CARRIER}, bodies: {{ {one}: {{ support: 20 N/um }}, {other}: {{ support: 40 N/um{ring} }} }} }}"
        )
    };
    let rim = |teeth: u32| format!(", outside_diameter: {} mm", 2 * teeth + 20);
    (0..6_u32, 18..30_u32, 17..26_u32, 17..26_u32, 3..6_u32).prop_map(move |(kind, sun, one, two, planets)| {
        let set = |kind: &str, teeth: [u32; 2], planet_teeth: &str, bodies: String| {
            format!(
                "kind: {kind}, sun: a, ring: b, carrier: h, teeth: [{}, {}], {planet_teeth}, planets: {planets}, spacing: least_unequal, module: 2 mm, face_width: 30 mm, {bodies}",
                teeth[0], teeth[1]
            )
        };
        let pair = |kind: &str, teeth: [u32; 2], ring: &str| {
            format!(
                "kind: {kind}, sun: a, ring: b, teeth: [{}, {}], module: 2 mm, face_width: 30 mm, vibration: {{ bodies: {{ gear 1: {{ support: 20 N/um }}, gear 2: {{ support: 40 N/um{ring} }} }} }}",
                teeth[0], teeth[1]
            )
        };
        let ring = sun + 2 * one;
        let steps = format!("planet_teeth: [{one}, {two}]");
        let single = format!("planet_teeth: [{one}]");
        match kind {
            0 => (set("simple", [sun, ring], &single, bodies("sun", "ring", &rim(ring))), 2),
            1 => {
                let ring = sun + one + two;
                (set("stepped_sun_ring", [sun, ring], &steps, bodies("sun", "ring", &rim(ring + one))), 2)
            }
            // Three planets stand around suns whose teeth three divides, whatever their own.
            2 => {
                let suns = [3 * (sun / 3), 3 * (sun / 3 + 1)];
                let set = set("stepped_suns", suns, &steps, bodies("sun 1", "sun 2", ""));
                (set.replace(&format!("planets: {planets}"), "planets: 3"), 2)
            }
            3 => {
                let ring = sun + one + two + 6;
                (set("double_planet", [sun, ring], &steps, bodies("sun", "ring", &rim(ring))), 2)
            }
            4 => (pair("external_pair", [sun, ring], ""), 1),
            _ => (pair("internal_pair", [sun, ring], &rim(ring)), 1),
        }
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// With free links a planet set keeps two motions, a pair one; all others have energy in every mode.
    #[test]
    fn sets_of_every_kind_keep_their_freedoms((set, freedoms) in any_set()) {
        let output = if set.contains("_pair") { "b" } else { "h" };
        let all = vibration(&file("sets", &set, output).replace("gears: [{ name: only }]\n", ""));
        every_mode_has_its_energy(&all);
        let zeros = all.sets[0].modes.iter().filter(|mode| mode.frequency_hz == 0.0);
        prop_assert_eq!(zeros.map(|mode| mode.multiplicity).sum::<u32>(), freedoms, "{}", set);
    }
}

/// A mesh may be named from either gear, once.
#[test]
fn meshes_are_named_from_either_gear() {
    let of = |key: &str| {
        let set = format!(
            "sun: a, ring: ground, carrier: h, teeth: [21, 63], planet_teeth: [21], planets: 3, module: 3 mm, face_width: 30 mm, vibration: {{ {CARRIER}, ring: {{ outside_diameter: 230 mm }}, mesh_stiffness: {{ {key} }} }}"
        );
        Gearbox::parse("box.yaml", file("sets", &set, "h").as_bytes()).map_err(|error| error.to_string())
    };
    let answer =
        |key: &str| Request::default().answer(&of(key).unwrap(), &|| ControlFlow::Continue(())).unwrap();
    same(&answer("sun-planet: 400 N/um"), &answer("planet-sun: 400 N/um"));
    assert!(answer("sun-planet: 400 N/um") != answer("sun-planet: 500 N/um"));
    let twice = of("sun-planet: 400 N/um, planet-sun: 500 N/um").unwrap_err();
    assert!(twice.contains("`mesh_stiffness` gives sun-planet twice"), "{twice}");
    let wrong = of("ring-sun: 400 N/um").unwrap_err();
    assert!(wrong.contains("`mesh_stiffness` has a value of `ring-sun`"), "{wrong}");
}

/// The whole gearbox vibrates only if every set has its data: each set without is named with the keys that it
/// lacks, for each model of the whole that is asked for.
#[test]
fn sets_that_the_whole_gearbox_lacks_are_named() {
    let set = |id: &str, [sun, carrier]: [&str; 2], vibration: &str| {
        format!(
            "  - {{ id: {id}, sun: {sun}, ring: ground, carrier: {carrier}, teeth: [20, 64], planet_teeth: [22], planets: 4, module: 3 mm, face_width: 30 mm{vibration} }}\n"
        )
    };
    let whole = format!(", vibration: {{ {CARRIER}, ring: {{ outside_diameter: 240 mm }} }}");
    let no_bearing = whole.replace("planet_bearing: 300 N/um, ", "");
    let states =
        [(whole.as_str(), None), ("", Some("vibration")), (&no_bearing, Some("vibration.planet_bearing"))];
    for (first, lacks_first) in states {
        for (second, lacks_second) in states {
            let text = format!(
                "gearbox: two\ninput: a\noutput: h\nsets:\n{}{}gears: [{{ name: only }}]\n",
                set("P", ["a", "b"], first),
                set("Q", ["b", "h"], second),
            );
            let request = |coupled| Request {
                exciting: Exciting { coupled, ..Exciting::default() },
                ..Request::default()
            };
            let gearbox = Gearbox::parse("box.yaml", text.as_bytes()).unwrap();
            let lacks: Vec<(&str, &str)> = [("P", lacks_first), ("Q", lacks_second)]
                .into_iter()
                .filter_map(|(set, key)| Some((set, key?)))
                .collect();
            if lacks.len() == 2 {
                assert!(request(false).answer(&gearbox, &|| ControlFlow::Continue(())).is_err());
                continue;
            }
            for coupled in [false, true] {
                let found = answered(&text, &request(coupled));
                assert_eq!(found.torsional.is_empty(), !lacks.is_empty());
                for (what, is_asked) in [(What::Torsional, true), (What::Coupled, coupled)] {
                    let named: Vec<(&str, &str)> = found
                        .not_calculated
                        .iter()
                        .filter(|one| one.what == what && one.reason == Reason::KeysMissing)
                        .map(|one| (one.set.as_str(), one.missing[0].as_str()))
                        .collect();
                    assert_eq!(named, if is_asked { lacks.clone() } else { vec![] }, "{what:?} {coupled}");
                }
            }
            // One set alone misses nothing of the others.
            let name = if lacks_first.is_none() { "P" } else { "Q" };
            let one = answered(&text, &Request { set: Some(name.to_owned()), ..Request::default() });
            assert!(one.not_calculated.is_empty(), "{:?}", one.not_calculated);
        }
    }
}

/// Values that are refused are shown in the units of files.
#[test]
fn refused_values_have_the_units_of_files() {
    let error = |vibration: &str| {
        let set = format!(
            "sun: a, ring: ground, carrier: h, teeth: [20, 64], planet_teeth: [22], planets: 4, module: 3 mm, face_width: 30 mm, vibration: {{ {vibration} }}"
        );
        let gearbox = Gearbox::parse("box.yaml", file("sets", &set, "h").as_bytes()).unwrap();
        let request = Request::default();
        request.answer(&gearbox, &|| ControlFlow::Continue(())).unwrap_err().to_string()
    };
    let rest = "ring: { outside_diameter: 240 mm }";
    for (vibration, shown) in [
        (
            format!("{CARRIER}, {rest}, mesh_stiffness: [-400 N/um, 400 N/um]"),
            "is -400 N/µm; it must be finite and above 0",
        ),
        (
            format!("{CARRIER}, {rest}, pressure_angles: [120 deg, 25 deg]"),
            "is 120 deg; it must lie between 0 deg and 90 deg",
        ),
        (
            format!("{CARRIER}, {rest}, base_radii: [28.1 mm, -31 mm, 90.2 mm]"),
            "is -31 mm; it must be finite and above 0",
        ),
        (
            format!("{}, {rest}", CARRIER.replace("300 N/um", "-300 N/um")),
            "is -300 N/µm; it must be finite and above 0",
        ),
    ] {
        let error = error(&vibration);
        assert!(error.contains(shown), "{vibration}: {error}");
    }
}

/// The inertia at the input by the energy of each body: `ω_H = ω/i`, a planet turns with `ω_H·(1 − z_r/z_p)`.
#[test]
fn the_inertia_of_the_gearbox_is_by_the_energy_of_its_bodies() {
    let set = format!(
        "sun: a, ring: ground, carrier: h, teeth: [20, 64], planet_teeth: [22], planets: 4, module: 3 mm, face_width: 30 mm, vibration: {{ {CARRIER}, ring: {{ outside_diameter: 240 mm }} }}"
    );
    let text = file("sets", &set, "h") + "vibration: { link_inertias: { a: 0.02 kg·m2, h: 5 kg·m2 } }\n";
    let gearbox = Gearbox::parse("box.yaml", text.as_bytes()).unwrap();
    let request = Request {
        exciting: Exciting { speeds: Some("0rpm..600rpm/3".parse().unwrap()), ..Exciting::default() },
        ..Request::default()
    };
    let answer = request.answer(&gearbox, &|| ControlFlow::Continue(())).unwrap();
    let body = |name: &str| answer.sets[0].bodies.iter().find(|body| body.body == name).unwrap();
    let (sun, planet, carrier) = (body("sun"), body("planet"), body("carrier"));
    let inertia = |body: &VibratingBody| body.inertia_kg_m2.unwrap();
    let ratio = 1.0 + 64.0 / 20.0;
    let turn = 1.0 - 64.0 / 22.0;
    let on_carrier = 5.0
        + inertia(carrier)
        + 4.0 * (planet.mass_kg.unwrap() * carrier.radius_m.powi(2) + inertia(planet) * turn * turn);
    let expected = 0.02 + inertia(sun) + on_carrier / (ratio * ratio);
    let told = &answer.torsional[0];
    assert!(near(told.inertia_at_input_kg_m2.unwrap(), expected, 1e-9), "{told:?} {expected}");
    assert!(near(told.inertia_at_output_kg_m2.unwrap(), expected * ratio * ratio, 1e-9), "{told:?}");
    // Teeth of the ring pass the planets at the speed of the carrier, 600 rpm over the ratio.
    let mesh = answer.orders.iter().find(|one| one.source == Source::Mesh && one.harmonic == 1).unwrap();
    assert!(near(mesh.frequency_hz, 64.0 * 10.0 / ratio, 1e-12), "{mesh:?}");
}
