use super::*;
use crate::shared::gearbox::{Choice, one};
use epicyclic_formats::Document;

fn front_of(text: &str, gear: Option<&str>) -> Front {
    let document = Document::parse_one("g.yaml", text.as_bytes()).unwrap();
    let subject = one(&document, &Choice::default()).unwrap();
    answer(&subject, gear).unwrap()
}

fn short(sets: &str, gear: Option<&str>) -> Front {
    let text = format!(
        "gearbox: g\ninput: D\noutput: B\nsets:\n{sets}\nbrakes: [{{ id: K, link: T }}]\ngears: [{{ name: '1', engaged: [K] }}]\n"
    );
    front_of(&text, gear)
}

fn example(name: &str, gear: &str) -> Front {
    let file = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(name);
    front_of(&std::fs::read_to_string(file).unwrap(), Some(gear))
}

const TOOTHED: &str = "  - { id: P, sun: D, ring: T, carrier: B, teeth: [24, 72], planets: 4 }";
const DOUBLE: &str = "  - { id: P, kind: double_planet, sun: D, ring: T, carrier: B, teeth: [30, 72], planet_teeth: [18, 18], planets: 3 }";
const STEPPED: &str = "  - { id: P, kind: stepped_sun_ring, sun: D, ring: T, carrier: B, teeth: [20, 80], planet_teeth: [40, 20], planets: 3 }";

/// Gear at its place: the gear, its centre, and its turn with that of its centre about the axis.
type Standing<'f> = (&'f FrontGear, [f64; 2], f64);

/// Gears of a set with the planets of one copy.
fn standing(set: &FrontSet, copy: usize, of_each: usize) -> Vec<Standing<'_>> {
    let centrals = set
        .gears
        .iter()
        .filter(|gear| gear.part != Part::Planet)
        .map(|gear| (gear, gear.centre, gear.turn_rad));
    let planets = set.planets[copy * of_each..(copy + 1) * of_each].iter().flat_map(|planet| {
        let (sin, cos) = libm::sincos(planet.angle_rad);
        let centre = [planet.centre_distance * cos, planet.centre_distance * sin];
        planet.gears.iter().map(move |own| (&set.gears[own.gear], centre, own.turn_rad))
    });
    centrals.chain(planets).collect()
}

/// Gears whose pitch circles touch must mesh at the pitch point and have the same speed there.
fn check_meshes(set: &FrontSet, of_each: usize, expected: usize) {
    let carrier = set.carrier_of_input.unwrap();
    // A pair has no planets, and its gears are seen once.
    for copy in 0..(set.planets.len() / of_each.max(1)).max(1) {
        let all = standing(set, copy, of_each);
        let mut met = 0;
        let pairs = (0..all.len()).flat_map(|one| (0..all.len()).map(move |other| (one, other)));
        for (one, other) in pairs {
            // Each pair is checked once; a ring comes last.
            let (is_ring, of_one) = (all[other].0.part == Part::Ring, all[one].0.part == Part::Ring);
            if of_one || (one >= other && !is_ring) {
                continue;
            }
            let [(a, [x1, y1], t1), (b, [x2, y2], t2)] = [all[one], all[other]];
            let apart = libm::hypot(x2 - x1, y2 - y1);
            let touching =
                if is_ring { b.pitch_radius - a.pitch_radius } else { a.pitch_radius + b.pitch_radius };
            if apart < 1e-12 || (apart - touching).abs() > 1e-9 {
                continue;
            }
            met += 1;
            // The pitch point lies towards the other gear; for a ring, beyond the planet.
            let along = a.pitch_radius / apart * if is_ring { -1.0 } else { 1.0 };
            let [px, py] = [x1 + along * (x2 - x1), y1 + along * (y2 - y1)];
            if set.has_teeth {
                let phase = |gear: &FrontGear, [x, y]: [f64; 2], turn: f64| {
                    f64::from(gear.teeth.unwrap()) * (libm::atan2(py - y, px - x) - turn)
                };
                let sign = if is_ring { -1.0 } else { 1.0 };
                let sum = phase(a, [x1, y1], t1) + sign * phase(b, [x2, y2], t2);
                assert!(libm::cos(sum) < -1.0 + 1e-9, "{} {} {sum} copy {copy}", a.name, b.name);
            }
            let velocity = |gear: &FrontGear, [x, y]: [f64; 2]| {
                let omega = gear.speed_of_input.unwrap();
                [-carrier * y - omega * (py - y), carrier * x + omega * (px - x)]
            };
            let ([a1, a2], [b1, b2]) = (velocity(a, [x1, y1]), velocity(b, [x2, y2]));
            assert!(libm::hypot(a1 - b1, a2 - b2) < 1e-9, "{} {}", a.name, b.name);
        }
        assert_eq!(met, expected, "copy {copy}");
    }
}

#[test]
fn gears_mesh_and_points_of_contact_have_one_speed_on_both() {
    check_meshes(&short(TOOTHED, Some("1")).sets[0], 1, 2);
    check_meshes(&short("  - { id: P, sun: D, ring: T, carrier: B, k: 2.94 }", Some("1")).sets[0], 1, 2);
    check_meshes(&short(DOUBLE, Some("1")).sets[0], 2, 3);
    check_meshes(
        &short("  - { id: P, kind: double_planet, sun: D, ring: T, carrier: B, k: 2.5 }", Some("1")).sets[0],
        2,
        3,
    );
    check_meshes(&short(STEPPED, Some("1")).sets[0], 1, 2);
    let ravigneaux = example("ravigneaux.yaml", "2");
    check_meshes(&ravigneaux.sets[0], 2, 4);
    assert!(ravigneaux.left_out.is_empty());
    check_meshes(&example("wolfrom.yaml", "only").sets[0], 1, 3);
    // Helical teeth, and pairs on fixed axes.
    let helical = "  - { id: P, kind: double_planet, sun: D, ring: T, carrier: B, teeth: [30, 72], planet_teeth: [18, 18], planets: 3, helix_angle: 15 deg }";
    check_meshes(&short(helical, Some("1")).sets[0], 2, 3);
    let wind = example("wind-gearbox.yaml", "only");
    assert!(wind.left_out.is_empty() && wind.uncut.is_empty() && wind.sets.iter().all(|set| set.has_teeth));
    check_meshes(&wind.sets[2], 0, 1);
    assert!(wind.sets[2].planets.is_empty() && wind.sets[2].planets_are_given);
    let inside = "{ gearbox: g, input: D, output: B, gears: [{ name: only }],\n  sets: [{ id: P, kind: internal_pair, sun: D, ring: B, teeth: [20, 61], helix_angle: 12 deg, profile_shifts: [0.2, 0.1] }] }";
    check_meshes(&front_of(inside, Some("only")).sets[0], 0, 1);
}

#[test]
fn teeth_give_outlines_and_k_gives_circles_of_three_planets() {
    let toothed = &short(TOOTHED, None).sets[0];
    assert!(toothed.has_teeth && toothed.planets.len() == 4 && toothed.carrier_of_input.is_none());
    assert!(toothed.gears.iter().all(|gear| gear.outline.len() > 200));
    let reach = |points: &[[f64; 2]]| points.iter().map(|[x, y]| libm::hypot(*x, *y)).fold(0.0, f64::max);
    let ring = toothed.gears.iter().find(|gear| gear.part == Part::Ring).unwrap();
    assert!(reach(&ring.outline) < ring.rim_radius && ring.rim_radius <= toothed.reach);
    let unsaid = &short(&TOOTHED.replace(", planets: 4", ""), None).sets[0];
    assert!(!unsaid.planets_are_given && unsaid.planets.len() == 3);
    let circles = &short("  - { id: P, sun: D, ring: T, carrier: B, k: 3 }", None).sets[0];
    assert!(!circles.has_teeth && !circles.planets_are_given && circles.planets.len() == 3);
    assert_eq!(circles.gears.iter().map(|gear| gear.pitch_radius).collect::<Vec<_>>(), [1.0, 3.0, 1.0]);
}

#[test]
fn as_many_planets_are_shown_as_have_room() {
    // Planets of 120 teeth around a sun of 18: three would overlap.
    let wide = &short("  - { id: P, sun: D, ring: T, carrier: B, teeth: [18, 258] }", None).sets[0];
    let two = &short(
        &STEPPED.replace("[20, 80]", "[12, 100]").replace("[40, 20]", "[70, 18]").replace(", planets: 3", ""),
        None,
    )
    .sets[0];
    for set in [wide, two] {
        assert!(set.has_teeth && set.planets.len() < 3, "{}", set.planets.len());
    }
}

#[test]
fn teeth_that_no_tool_leaves_are_named_and_shown_as_circles() {
    let front = short("  - { id: P, sun: D, ring: T, carrier: B, teeth: [2, 10] }", None);
    assert_eq!((front.uncut.len(), front.sets.len(), front.left_out.len()), (1, 1, 0));
    assert!(front.uncut[0].set == "P" && !front.uncut[0].why.is_empty() && !front.sets[0].has_teeth);
    assert!(short(TOOTHED, None).uncut.is_empty());
}

#[test]
fn sets_without_places_are_named() {
    for set in [
        "  - { id: P, kind: stepped_sun_ring, sun: D, ring: T, carrier: B, k: 2.5 }",
        "  - { id: P, kind: bevel, sun: D, ring: T, carrier: B, k: 1 }",
    ] {
        let front = short(set, Some("1"));
        assert_eq!((front.sets.len(), front.left_out), (0, vec!["P".to_owned()]), "{set}");
    }
}
