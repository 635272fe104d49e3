//! Double-planet sets, held against every gear placed by coordinates and every tooth turned by its phase.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use epicyclic_gears::double_planet::DoublePlanetNumbers;
use epicyclic_gears::rack::BasicRack;
use epicyclic_gears::simple_set::Mode;
use epicyclic_gears::spacing::PlanetSpacing;
use epicyclic_gears::synthesis::{Bounds, Placement};
use epicyclic_gears::{Error, ToothCount};
use proptest::prelude::*;
use std::cmp::Reverse;
use std::f64::consts::{PI, TAU};
use uom::si::angle::radian;
use uom::si::f64::Angle;

fn set([sun, inner, outer, ring]: [u32; 4], pairs: u32) -> DoublePlanetNumbers {
    let z = |count| ToothCount::new(count).unwrap();
    DoublePlanetNumbers { sun: z(sun), ring: z(ring), inner: z(inner), outer: z(outer), pairs }
}

fn counts(of: &DoublePlanetNumbers) -> [f64; 4] {
    [of.sun, of.inner, of.outer, of.ring].map(ToothCount::as_f64)
}

type Point = [f64; 2];

fn polar(radius: f64, angle: f64) -> Point {
    [radius * libm::cos(angle), radius * libm::sin(angle)]
}

fn apart(one: Point, other: Point) -> f64 {
    libm::hypot(one[0] - other[0], one[1] - other[1])
}

/// Centres of the inner and the outer planets, by their distances from the axis and from each other; none
/// where they cannot mesh.
fn centres(of: &DoublePlanetNumbers, angles: &[f64]) -> Option<Vec<[Point; 2]>> {
    let [a, g, f, b] = counts(of);
    let (inner, outer, distance) = ((a + g) / 2.0, (b - f) / 2.0, (g + f) / 2.0);
    let too_far = |angle: f64| apart(polar(inner, 0.0), polar(outer, angle)) - distance;
    // The farther round, the farther apart.
    if outer <= 0.0 || too_far(0.0) > 0.0 || too_far(PI) < 0.0 {
        return None;
    }
    let (mut near, mut far) = (0.0, PI);
    for _ in 0..100 {
        let middle = (near + far) / 2.0;
        if too_far(middle) > 0.0 { far = middle } else { near = middle }
    }
    Some(angles.iter().map(|angle| [polar(inner, *angle), polar(outer, angle + near)]).collect())
}

/// Whether no two gears that do not mesh come nearer than the gap, all pairs at these angles.
fn apart_by(of: &DoublePlanetNumbers, angles: &[f64], addendum: f64, gap: f64) -> bool {
    let Some(centres) = centres(of, angles) else { return false };
    let [a, g, f, b] = counts(of);
    let [sun, inner, outer] = [a, g, f].map(|teeth| teeth / 2.0 + addendum);
    let ring = b / 2.0 - addendum;
    let axis = [0.0, 0.0];
    // Gears that only touch, by more than rounding.
    let gap = gap + 1e-9;
    let mut clear = true;
    for (place, [one, partner]) in centres.iter().enumerate() {
        clear &= ring - apart(axis, *one) - inner > gap && apart(axis, *partner) - outer - sun > gap;
        for [other, its] in &centres[..place] {
            clear &= apart(*one, *other) - 2.0 * inner > gap && apart(*partner, *its) - 2.0 * outer > gap;
            clear &= apart(*one, *its) - inner - outer > gap && apart(*partner, *other) - inner - outer > gap;
        }
    }
    clear
}

/// Teeth between a direction and the tooth at the phase of a gear.
fn teeth_to(teeth: f64, phase: f64, direction: f64) -> f64 {
    teeth * (direction - phase) / TAU
}

/// Phase of a gear in mesh with another: a tooth of one lies in a space of the other on the line of centres.
fn meshing(of: (f64, f64), at: Point, teeth: f64, its: Point) -> f64 {
    let direction = libm::atan2(its[1] - at[1], its[0] - at[0]);
    let behind = direction + PI;
    // Round their own centres the two count against each other: u + v = 1/2.
    behind - (0.5 - teeth_to(of.0, of.1, direction)) / teeth * TAU
}

/// Phase of the ring in teeth that a planet in mesh with it requires.
fn ring_phase(planet: (f64, f64), at: Point, ring: f64) -> f64 {
    let direction = libm::atan2(at[1], at[0]);
    // Inside each other the two count alike: u − v = 1/2; a ring's tooth is where v is whole.
    let v = teeth_to(planet.0, planet.1, direction) - 0.5;
    (ring * direction / TAU - v).rem_euclid(1.0)
}

/// Whether all pairs ask for one phase of the ring, the sun at rest.
fn assembles(of: &DoublePlanetNumbers, angles: &[f64]) -> bool {
    let [a, g, f, b] = counts(of);
    let phases: Vec<f64> = centres(of, angles)
        .unwrap()
        .iter()
        .map(|[one, partner]| {
            let inner = meshing((a, 0.0), [0.0, 0.0], g, *one);
            let outer = meshing((g, inner), *one, f, *partner);
            ring_phase((f, outer), *partner, b)
        })
        .collect();
    let off = |phase: &f64| {
        let off = (phase - phases[0]).abs();
        off.min(1.0 - off)
    };
    phases.iter().all(|phase| off(phase) < 1e-6)
}

fn equal(pairs: u32) -> Vec<f64> {
    (0..pairs).map(|pair| TAU * f64::from(pair) / f64::from(pairs)).collect()
}

/// Order of preference: the least comes first.
fn preference(set: &DoublePlanetNumbers) -> impl Ord + use<> {
    let (inner, outer) = (set.inner, set.outer);
    (Reverse(set.pairs), Reverse(inner.min(outer)), inner.max(outer), Reverse(outer))
}

fn by_trial(bounds: &Bounds) -> Vec<DoublePlanetNumbers> {
    let mut found = vec![];
    let addendum = bounds.rack.addendum;
    for sun in bounds.sun.clone() {
        for ring in bounds.ring.clone() {
            if !bounds.ring_to_sun_ratio.contains(&(f64::from(ring) / f64::from(sun))) {
                continue;
            }
            for pairs in bounds.planets.clone() {
                for inner in bounds.planet.clone() {
                    for outer in bounds.planet.clone() {
                        let one = set([sun, inner, outer, ring], pairs);
                        let spacing = one.spacing().unwrap();
                        let angles = spacing.angles();
                        let angles: Vec<f64> = angles.iter().map(Angle::get::<radian>).collect();
                        let placed = spacing.is_equal() || bounds.placement == Placement::LeastUnequal;
                        if placed && apart_by(&one, &angles, addendum, bounds.tip_gap) {
                            assert!(assembles(&one, &angles), "{one}");
                            found.push(one);
                        }
                    }
                }
            }
        }
    }
    found
}

#[test]
fn the_pairs_of_a_6hp_stand_by_hand() {
    // 31 and 85 teeth of the second sun and the ring of ZF's 6HP; planets of 21 teeth.
    let one = set([31, 21, 21, 85], 3);
    let pair = one.pair(&BasicRack::default()).unwrap();
    assert_eq!([pair.inner.centre_radius, pair.outer.centre_radius], [26.0, 32.0]);
    assert_eq!([pair.inner.tip_radius, pair.outer.tip_radius], [11.5, 11.5]);
    // 26² + 32² − 21² = 1259 over 2·26·32 = 1664.
    assert!((pair.angle_rad - libm::acos(1259.0f64 / 1664.0)).abs() < 1e-15);
    assert_eq!(one.basic_ratio().get(), 85.0 / 31.0);
    assert!((one.ring_to_sun_ratio() - 85.0 / 31.0).abs() < 1e-15);
    assert_eq!(one.to_string(), "31/21+21/85 ×3");
}

/// Two planets of 13 teeth each leave 52 between sun and ring: centres on one line. With one tooth less they
/// do not reach.
#[test]
fn the_triangle_is_flat_where_the_planets_just_reach() {
    let rack = BasicRack::default();
    assert_eq!(set([30, 13, 13, 82], 2).pair(&rack).unwrap().angle_rad, 0.0);
    assert_eq!(set([30, 13, 12, 82], 2).pair(&rack), None);
    assert!(set([30, 13, 13, 82], 2).fits(&rack, 0.0) && !set([30, 13, 12, 82], 2).fits(&rack, 0.0));
    // A ring smaller than the planet in it, or than the sun.
    assert_eq!(set([30, 20, 90, 82], 2).pair(&rack), None);
    assert!(!set([82, 20, 20, 30], 2).fits(&rack, 0.0));
    assert_eq!(set([82, 20, 20, 30], 2).spacing(), None);
}

#[test]
fn pairs_assemble_where_their_number_divides_ring_less_sun_and_nowhere_else() {
    let mut seen = [0; 2];
    for (sun, ring) in [(30, 78), (31, 85), (24, 73), (40, 91)] {
        for inner in 14..22 {
            for outer in 14..22 {
                for pairs in 2..=6 {
                    let one = set([sun, inner, outer, ring], pairs);
                    if one.pair(&BasicRack::default()).is_some() {
                        let whole = (ring - sun) % pairs == 0;
                        assert_eq!(assembles(&one, &equal(pairs)), whole, "{one}");
                        seen[usize::from(whole)] += 1;
                    }
                }
            }
        }
    }
    assert!(seen[0] > 200 && seen[1] > 200, "{seen:?}");
}

#[test]
fn one_more_tooth_and_neighbours_overlap() {
    // Five pairs of planets alike: the largest that fit 40 and 100, by coordinates.
    let rack = BasicRack::default();
    let fits = |teeth| set([40, teeth, teeth, 100], 5).fits(&rack, 0.0);
    let most = (15..30).rev().find(|teeth| fits(*teeth)).unwrap();
    assert!(apart_by(&set([40, most, most, 100], 5), &equal(5), 1.0, 0.0));
    assert!(!apart_by(&set([40, most + 1, most + 1, 100], 5), &equal(5), 1.0, 0.0));
}

#[test]
fn a_choice_of_each_sun_and_ring_is_the_one_preferred() {
    let bounds = Bounds { ring: 60..=100, planet: 12..=40, ..Bounds::default() };
    let all = bounds.double_planet_numbers().unwrap();
    let mut chosen: Vec<DoublePlanetNumbers> = vec![];
    for one in &all {
        match chosen.iter_mut().find(|known| (known.sun, known.ring) == (one.sun, one.ring)) {
            None => chosen.push(*one),
            Some(known) if preference(one) < preference(known) => *known = *one,
            Some(_) => {}
        }
    }
    assert_eq!(bounds.double_planet_choices().unwrap().0, chosen);
    assert!(chosen.len() > 300 && chosen.iter().any(|one| one.inner != one.outer), "{}", chosen.len());
}

#[test]
fn invalid_bounds_are_refused() {
    let bounds = Bounds { sun: 0..=20, ..Bounds::default() };
    assert!(bounds.double_planet_numbers().is_err() && bounds.double_planet_choices().is_err());
    assert_eq!(PlanetSpacing::of_pairs(ToothCount::new(30).unwrap(), ToothCount::new(30).unwrap(), 3), None);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn double_planet_sets_are_those_that_trial_finds(
        sun in 8..60_u32, suns in 0..4_u32,
        ring in 30..150_u32, rings in 0..5_u32,
        planet in 4..40_u32, spread in 0..30_u32,
        pairs in 2..=8_u32, more in 0..4_u32,
        addendum in prop_oneof![Just(1.0), 0.5..1.2_f64],
        tip_gap in prop_oneof![Just(0.0), 0.0..1.5_f64],
        unequal in any::<bool>(),
    ) {
        let bounds = Bounds {
            sun: sun..=sun + suns,
            planet: planet..=planet + spread,
            ring: ring..=ring + rings,
            planets: pairs..=(pairs + more).min(8),
            ring_to_sun_ratio: 1.05..=10.0,
            rack: BasicRack { addendum, ..BasicRack::default() },
            tip_gap,
            placement: if unequal { Placement::LeastUnequal } else { Placement::Equal },
        };
        prop_assert_eq!(bounds.double_planet_numbers().unwrap(), by_trial(&bounds));
    }
}

/// Of every mode, against the trial of all sets: each pair of sun and ring once, the most exact first, with
/// as many choices of planets as there are.
#[test]
fn sets_for_a_ratio_are_those_of_all_within_tolerance() {
    let bounds = Bounds { sun: 20..=34, ring: 60..=84, planet: 10..=30, planets: 3..=5, ..Bounds::default() };
    let all = bounds.double_planet_numbers().unwrap();
    let choices = bounds.double_planet_choices().unwrap().0;
    let mut met = 0;
    for mode in Mode::ALL {
        let wanted = choices[choices.len() / 2].basic_ratio().ratio(mode).unwrap();
        let found = bounds
            .double_planets_for_ratio(wanted, mode, 0.03, usize::MAX, |_| std::ops::ControlFlow::Continue(()))
            .unwrap();
        let error = |set: &DoublePlanetNumbers| set.basic_ratio().ratio(mode).unwrap() / wanted - 1.0;
        let mut due: Vec<_> = choices.iter().filter(|set| error(set).abs() <= 0.03).collect();
        due.sort_by(|one, other| {
            let key = |set: &DoublePlanetNumbers| (set.ring, set.sun);
            error(one).abs().total_cmp(&error(other).abs()).then(key(one).cmp(&key(other)))
        });
        assert_eq!(found.first.iter().map(|one| &one.teeth).collect::<Vec<_>>(), due);
        assert_eq!(found.found, due.len() as u64);
        for one in &found.first {
            let alike = all.iter().filter(|set| (set.sun, set.ring) == (one.teeth.sun, one.teeth.ring));
            assert_eq!(one.choices, alike.count() as u64);
            let exact = *one.exact_ratio.numer() as f64 / *one.exact_ratio.denom() as f64;
            assert!((exact / one.ratio - 1.0).abs() < 1e-15);
            assert_eq!(one.ratio_error, error(&one.teeth));
            assert!(one.spacing.is_equal());
            met += 1;
        }
        let few = bounds
            .double_planets_for_ratio(wanted, mode, 0.03, 2, |_| std::ops::ControlFlow::Continue(()))
            .unwrap();
        assert_eq!((few.found, &few.first[..]), (found.found, &found.first[..2.min(found.first.len())]));
        let none =
            bounds.double_planets_for_ratio(-wanted, mode, 0.03, 2, |_| std::ops::ControlFlow::Continue(()));
        assert!(matches!(none, Err(Error::NoDoublePlanetSet { nearest: Some(_), .. })), "{none:?}");
    }
    assert!(met > 30, "{met}");
    #[allow(clippy::reversed_empty_ranges, reason = "the bad input")]
    let empty = Bounds { sun: 30..=20, ..bounds };
    let refused =
        empty.double_planets_for_ratio(2.6, Mode::ALL[0], 0.03, 2, |_| std::ops::ControlFlow::Continue(()));
    assert!(matches!(refused, Err(Error::ToothRange { .. })) && empty.space(true).is_err());
}

/// Counts the space by visiting every combination.
#[test]
fn the_space_is_what_is_gone_through() {
    let bounds = Bounds { sun: 12..=40, planet: 12..=30, ring: 30..=70, planets: 3..=5, ..Bounds::default() };
    let pairs = (12..=40_u64).map(|sun| (30..=70).filter(|ring| *ring > sun).count() as u64).sum::<u64>();
    assert_eq!(bounds.space(true), Ok(3 * pairs));
    let fits = |sun: u32, planet: u32| {
        let ring = sun + 2 * planet;
        let k = f64::from(ring) / f64::from(sun);
        (30..=70).contains(&ring) && (1.3..=10.0).contains(&k)
    };
    let within =
        (12..=40).map(|sun| (12..=30).filter(|planet| fits(sun, *planet)).count() as u64).sum::<u64>();
    let space = bounds.space(false).unwrap();
    // A planet more at each end of a sun's range.
    assert!(space >= 3 * within && space <= 3 * (within + 2 * 29), "{space} {within}");
}
