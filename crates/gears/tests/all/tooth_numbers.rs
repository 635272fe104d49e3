//! Results on tooth numbers, compared with the geometry written out.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use epicyclic_gears::geometry::GearKind;
use epicyclic_gears::mass::{FormulaEight, MassProperties, published_gear_inertia};
use epicyclic_gears::mesh::TipCircle;
use epicyclic_gears::planet_bearing::{Push, two_mesh_forces};
use epicyclic_gears::rack::BasicRack;
use epicyclic_gears::simple_set::{Member, Mode};
use epicyclic_gears::synthesis::{Bounds, Placement, tooth_numbers_by_trial};
use epicyclic_gears::{Error, ToothCount};
use std::f64::consts::PI;
use uom::si::angle::radian;
use uom::si::f64::{Force, Length, Mass, MomentOfInertia, Torque, Volume};
use uom::si::force::newton;
use uom::si::length::millimeter;
use uom::si::mass::kilogram;
use uom::si::moment_of_inertia::kilogram_square_meter;
use uom::si::torque::newton_meter;
use uom::si::volume::cubic_meter;

fn teeth(count: u32) -> ToothCount {
    ToothCount::new(count).unwrap()
}

fn circle(sun: u32, planet: u32) -> TipCircle {
    TipCircle::of_planet(teeth(sun), teeth(planet), &BasicRack::default())
}

/// Distance between the centres of two neighbouring planets with the angle `angle_rad` between them, in
/// modules.
fn apart(sun: u32, planet: u32, angle_rad: f64) -> f64 {
    f64::from(sun + planet) * libm::sin(angle_rad / 2.0)
}

#[test]
fn planets_clear_each_other_by_the_distance_of_their_centres() {
    for sun in 1..60 {
        for planet in 1..60 {
            // Tip diameter and gap, in modules.
            let needed = f64::from(planet) + 2.0 + 0.4;
            let clears = |planets: u32| apart(sun, planet, 2.0 * PI / f64::from(planets)) > needed;
            let most = (1..400).rev().find(|planets| *planets == 1 || clears(*planets)).unwrap();
            assert_eq!(circle(sun, planet).most(0.4), most, "{sun} {planet}");
        }
    }
}

#[test]
fn the_limit_of_clearance_is_where_neighbours_touch() {
    let limit = circle(18, 36).number_limit(0.0).unwrap();
    assert!((apart(18, 36, 2.0 * PI / limit) - 38.0).abs() < 1e-12, "{limit}");
    // Around a sun of two teeth even two planets touch, around one tooth they overlap.
    assert_eq!(circle(2, 36).number_limit(0.0), None);
    assert_eq!(circle(1, 36).number_limit(0.0), None);
    let tight = circle(3, 36).number_limit(0.0).unwrap();
    assert!(tight > 2.0 && (apart(3, 36, 2.0 * PI / tight) - 38.0).abs() < 1e-12, "{tight}");
}

#[test]
fn unequally_spaced_planets_clear_each_other_where_they_stand() {
    let bounds = Bounds {
        sun: 12..=24,
        planet: 12..=40,
        planets: 3..=8,
        placement: Placement::LeastUnequal,
        ..Bounds::default()
    };
    let mode = Mode::new(Member::Sun, Member::Carrier).unwrap();
    let found = bounds.for_ratio(5.0, mode, 0.2).unwrap();
    let mut unequal = 0;
    for set in &found {
        let angles: Vec<f64> = set.spacing.angles().iter().map(uom::si::f64::Angle::get::<radian>).collect();
        let next = angles.iter().skip(1).copied().chain([angles[0] + 2.0 * PI]);
        let least = angles.iter().zip(next).map(|(one, next)| next - one).fold(f64::INFINITY, f64::min);
        assert!((set.smallest_gap_rad() - least).abs() < 1e-12, "{set:?}");
        let needed = f64::from(set.teeth.planet.get()) + 2.0;
        assert!(apart(set.teeth.sun.get(), set.teeth.planet.get(), least) > needed, "{set:?}");
        unequal += usize::from(!set.spacing.is_equal());
    }
    assert!(unequal > 50, "{unequal} of {}", found.len());
    // And none is lost: every set and number of planets that clears at its least unequal places is there.
    let mut expected = 0;
    for sun in 12..=24_u32 {
        for planet in 12..=40 {
            let ring = sun + 2 * planet;
            let k = f64::from(ring) / f64::from(sun);
            if !(1.3..=10.0).contains(&k) || ((1.0 + k) / 5.0 - 1.0).abs() > 0.2 {
                continue;
            }
            for planets in 3..=8 {
                // Whole slots between neighbours: the smallest gap has ⌊slots/n⌋ of them.
                let slots = sun + ring;
                let least = 2.0 * PI * f64::from(slots / planets) / f64::from(slots);
                expected += usize::from(apart(sun, planet, least) > f64::from(planet) + 2.0);
            }
        }
    }
    assert_eq!(found.len(), expected);
}

/// Limits of `k` at values that sets reach and between them.
#[test]
fn the_range_of_k_holds_exactly_the_sets_between_its_ends() {
    let of = |low: f64, high: f64| Bounds {
        sun: 12..=24,
        planet: 6..=40,
        ring: 24..=100,
        planets: 2..=4,
        ring_to_sun_ratio: low..=high,
        ..Bounds::default()
    };
    let all = of(1.1, 8.0).tooth_numbers().unwrap();
    for (low, high) in [(1.1, 1.5), (1.5, 2.0), (2.0, 2.0), (1.8, 3.3), (3.0, 4.0), (4.2, 8.0)] {
        let found = of(low, high).tooth_numbers().unwrap();
        let is_between = |set: &f64| (low..=high).contains(set);
        let expected: Vec<_> =
            all.iter().filter(|set| is_between(&set.ring_to_sun_ratio())).copied().collect();
        assert_eq!(found, expected, "{low} {high}");
        assert_eq!(found, tooth_numbers_by_trial(&of(low, high)).unwrap(), "{low} {high}");
        assert!(!found.is_empty(), "{low} {high}");
    }
    // A ring as large as its sun leaves no planet.
    assert!(matches!(of(1.0, 8.0).count(), Err(Error::RingToSunRange { from: 1.0, to: 8.0 })));
}

/// `(2 + z_g)·sin 90° = z_g + 2`: two planets about a sun of two teeth touch, and touching is not clear.
#[test]
fn planets_that_touch_do_not_clear() {
    let bounds = Bounds {
        sun: 1..=4,
        planet: 8..=20,
        ring: 17..=44,
        planets: 2..=2,
        ring_to_sun_ratio: 1.1..=50.0,
        ..Bounds::default()
    };
    let found = bounds.tooth_numbers().unwrap();
    assert_eq!(found, tooth_numbers_by_trial(&bounds).unwrap());
    // Equal spacing of two: sun and ring together even, which they are.
    let suns: Vec<u32> = found.iter().map(|set| set.sun.get()).collect();
    assert_eq!(suns, [[3; 13], [4; 13]].concat());
}

#[test]
fn the_first_of_many_are_the_first_of_all() {
    let bounds = Bounds { sun: 12..=60, planet: 12..=60, ..Bounds::default() };
    let mode = Mode::new(Member::Sun, Member::Carrier).unwrap();
    let all = bounds.for_ratio(5.0, mode, 0.05).unwrap();
    for most in [0, 1, 2, 7, all.len() - 1, all.len(), all.len() + 1] {
        let ranked =
            bounds.first_for_ratio(5.0, mode, 0.05, most, |_| std::ops::ControlFlow::Continue(())).unwrap();
        assert_eq!(ranked.found, all.len() as u64);
        assert_eq!(ranked.first, all[..most.min(all.len())], "{most}");
    }
}

#[test]
fn ring_over_sun_is_the_ratio_of_their_teeth() {
    let mode = Mode::new(Member::Sun, Member::Carrier).unwrap();
    let found = Bounds::default().for_ratio(6.0, mode, 0.0).unwrap();
    for set in found.iter().map(|set| set.teeth) {
        assert!(
            (set.ring_to_sun_ratio() - f64::from(set.ring.get()) / f64::from(set.sun.get())).abs() < 1e-15
        );
        assert!((set.ring_to_sun_ratio() - 5.0).abs() < 1e-12);
    }
}

#[test]
fn numbers_of_planets_are_told_as_they_are_said() {
    let told = |planets: std::ops::RangeInclusive<u32>| {
        let mode = Mode::new(Member::Sun, Member::Carrier).unwrap();
        Bounds { planets, ..Bounds::default() }.for_ratio(5.0, mode, 0.01).unwrap_err().to_string()
    };
    assert!(told(1..=1).starts_with("1 planet: "), "{}", told(1..=1));
    assert!(told(9..=9).starts_with("9 planets: "), "{}", told(9..=9));
    assert!(told(1..=9).starts_with("1 to 9 planets: "), "{}", told(1..=9));
    assert!(matches!(
        Bounds { planets: 1..=1, ..Bounds::default() }.count(),
        Err(Error::PlanetNumber { from: 1, to: 1, .. })
    ));
}

#[test]
fn bodies_add_up() {
    let body = |scale: f64| MassProperties {
        volume: Volume::new::<cubic_meter>(scale),
        mass: Mass::new::<kilogram>(10.0 * scale),
        polar_inertia: MomentOfInertia::new::<kilogram_square_meter>(100.0 * scale),
    };
    assert_eq!(body(1.0) + body(2.0), body(3.0));
    assert_eq!(body(1.5) * 2.0, body(3.0));
}

#[test]
fn both_readings_of_the_printed_inertia_by_hand() {
    let mm = Length::new::<millimeter>;
    let of = |reading| {
        let found =
            published_gear_inertia(reading, Mass::new::<kilogram>(2.0), mm(400.0), mm(200.0), mm(100.0));
        found.unwrap().get::<kilogram_square_meter>()
    };
    // m·r²/2: 0.04, 0.01 and 0.0025.
    assert!((of(FormulaEight::Likely) - 0.0225).abs() < 1e-15);
    assert!((of(FormulaEight::Literal) - 0.018_75).abs() < 1e-15);
}

/// A planet that only one mesh drives hands nothing on: that mesh has its own torque, the other none.
#[test]
fn a_mesh_without_torque_has_no_force_and_adds_none() {
    let mm = Length::new::<millimeter>;
    let of = |sun: f64, ring: f64| {
        let push = |kind, radius, torque| Push {
            kind,
            pitch_radius: mm(radius),
            torque: Torque::new::<newton_meter>(torque),
        };
        let gears = [push(GearKind::External, 40.0, sun), push(GearKind::Internal, 200.0, ring)];
        two_mesh_forces(&gears, 0.4, 4, mm(120.0)).unwrap().map(|force: Force| force.get::<newton>())
    };
    // 100 N·m over 4 planets at 0.12 m.
    let own = 100.0 / 0.48;
    for (found, expected) in
        [(of(100.0, 0.0), [own, 0.0]), (of(0.0, 100.0), [0.0, own]), (of(0.0, 0.0), [0.0; 2])]
    {
        assert!(
            found.iter().zip(expected).all(|(one, due)| (one - due).abs() < 1e-9),
            "{found:?} {expected:?}"
        );
    }
}
