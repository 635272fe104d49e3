//! The search over the teeth of one set finds exactly what brute force finds: every combination of teeth in
//! every way to use the set through the solver of any gearbox, every pair of designs compared.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use crate::brute_common;
use epicyclic_gears::involute::closing::Closing;
use epicyclic_gears::involute::search::ProfileShift;
use epicyclic_gears::synthesis::{Bounds, ToothNumbers};
use epicyclic_schemes::RatioSeries;
use epicyclic_schemes::structures::{Role, SetRoles};
use epicyclic_selection::drawing::drawable_direct_clutches;
use epicyclic_selection::search::{MOST_TOOTH_SETS, OneSetFound, OneSetSearch};
use epicyclic_selection::size::relative_ring_diameter_of_teeth;
use epicyclic_selection::{Error, Mechanism, Objective, Order, Requirements, Signs, Space};
use proptest::prelude::*;
use std::collections::BTreeMap;
use std::ops::{ControlFlow, RangeInclusive};
use uom::si::f64::{Length, Pressure, Torque};
use uom::si::length::millimeter;
use uom::si::pressure::megapascal;
use uom::si::torque::newton_meter;

/// Links of sun, ring and carrier, the teeth, and whether the output is to reverse.
type Key = (SetRoles, ToothNumbers, bool);

fn search(ratio: f64) -> OneSetSearch {
    OneSetSearch::new(Requirements::new(RatioSeries::of_braked_gears(&[ratio]).unwrap()))
}

/// Costs of designs of one `k` that meet the criteria: efficiency, speed, ring-to-sun ratio, ratio error,
/// size. The solver is asked once for all of them.
fn costs(
    search: &OneSetSearch,
    set: SetRoles,
    wanted: f64,
    all: &[ToothNumbers],
) -> Option<Vec<(ToothNumbers, [f64; 5])>> {
    let requirements = &search.requirements;
    let limits = &requirements.limits;
    let within = |value: f64, limit: f64| value <= limit + 1e-9 * (1.0 + limit);
    let k = all[0].ring_to_sun_ratio();
    let mechanism = Mechanism::OneSet(set);
    let gearbox = mechanism.gearbox(&[k], requirements.eta0, [Role::D, Role::B]).unwrap();
    let gear = gearbox.analyze("1").unwrap();
    let error = (gear.ratio()? / wanted - 1.0).abs();
    let efficiency = gear.efficiency()?;
    let roles = [Role::D, Role::B, Role::T1];
    let speeds = roles.map(|role| gear.speed(gearbox.link(role.symbol()).unwrap()).unwrap());
    let speed = |role: Role| speeds[roles.iter().position(|one| *one == role).unwrap()];
    let links = speeds.iter().fold(0.0_f64, |most, speed| most.max(speed.abs()));
    let pairs = if limits.drawable {
        drawable_direct_clutches(mechanism).ok()?
    } else {
        vec![[Role::D, Role::B], [Role::D, Role::T1], [Role::B, Role::T1]]
    };
    let slip = pairs.iter().map(|&[x, y]| (speed(x) - speed(y)).abs()).fold(f64::INFINITY, f64::min);
    let met = limits.ring_to_sun.contains(&k)
        && within(error, requirements.tolerance)
        && within(links, limits.link_speed)
        && within(slip, limits.clutch_slip)
        && efficiency >= limits.efficiency - 1e-9 * (1.0 + limits.efficiency)
        && (wanted > 0.0 || !limits.same_direction);
    if !met {
        return None;
    }
    let (low, high) = (*limits.preferred.start(), *limits.preferred.end());
    let torque = gear.driving()?.members[0].as_ref()?[0];
    let distance = (libm::log(k) - libm::log(k.clamp(low, high))).abs();
    let shift = search.shift.as_ref();
    let of = |teeth: &ToothNumbers| {
        let planets = ((speed(set[0]) - speed(set[2])) * teeth.sun.as_f64() / teeth.planet.as_f64()).abs();
        let size = relative_ring_diameter_of_teeth(teeth, shift, torque, &requirements.rating).unwrap();
        let costs = [-efficiency, links.max(planets), distance, error, size];
        within(planets, limits.planet_speed).then_some((*teeth, costs))
    };
    Some(all.iter().filter_map(of).collect())
}

/// Designs that no other dominates, each compared with each, the cheapest first; and how many meet the
/// criteria.
fn by_trial(search: &OneSetSearch) -> (BTreeMap<Key, [f64; 5]>, usize) {
    let tried = match &search.shift {
        None => brute_common::that_turn_by_trial(&search.bounds),
        Some(shift) => brute_common::shifted_by_trial(&search.bounds, shift),
    };
    let of_k = brute_common::by_k(&tried);
    let mut all = vec![];
    for target in search.requirements.targets() {
        for &set in &search.sets {
            let found =
                of_k.values().flat_map(|of_k| costs(search, set, target[0], of_k).unwrap_or_default());
            all.extend(found.map(|(teeth, costs)| ((set, teeth, target[0] < 0.0), costs)));
        }
    }
    let free = brute_common::undominated(all.iter().map(|(_, costs)| *costs));
    (all.iter().filter(|(_, costs)| free(costs)).copied().collect(), all.len())
}

fn members(found: &OneSetFound) -> BTreeMap<Key, [f64; 5]> {
    let mut all = BTreeMap::new();
    for entry in found.entries() {
        let o = entry.objectives;
        for design in found.designs(entry) {
            for teeth in design.teeth {
                assert_eq!(teeth.ring_to_sun_ratio(), design.k);
                let costs = [-o.efficiency, o.speed, o.ring_to_sun, o.ratio_error, o.size];
                all.insert((design.set, teeth, design.wanted < 0.0), costs);
            }
        }
    }
    all
}

fn equals_brute_force(search: &OneSetSearch) -> Result<usize, TestCaseError> {
    let (exact, _) = by_trial(search);
    let ours = members(&search.front().unwrap());
    prop_assert_eq!(ours.keys().collect::<Vec<_>>(), exact.keys().collect::<Vec<_>>());
    for (key, costs) in &ours {
        for (one, other) in costs.iter().zip(exact[key]) {
            prop_assert!((one - other).abs() < 1e-9, "{:?} {:?} {:?}", key, costs, exact[key]);
        }
    }
    Ok(ours.len())
}

#[test]
fn the_conveyor_over_small_rings() {
    let mut search = search(3.9375);
    search.bounds = Bounds { ring: 12..=80, ..Bounds::default() };
    assert!(equals_brute_force(&search).unwrap() > 3);
    search.requirements.signs = Signs::Any;
    search.requirements.limits.planet_speed = 20.0;
    search.requirements.limits.link_speed = 20.0;
    assert!(equals_brute_force(&search).unwrap() > 3);
}

fn offsets(offsets: RangeInclusive<i32>) -> Option<ProfileShift> {
    Some(ProfileShift { offsets, closing: Closing::default() })
}

/// 18/36/93 of a wind gearbox, and planets that turn by their own teeth.
#[test]
fn sets_with_profile_shift_are_found() {
    let mut search = search(111.0 / 18.0);
    search.bounds =
        Bounds { sun: 17..=20, planet: 30..=44, ring: 85..=100, planets: 3..=4, ..Bounds::default() };
    search.requirements.limits.planet_speed = 20.0;
    search.requirements.tolerance = 0.03;
    assert!(equals_brute_force(&search).unwrap() > 1);
    let without = search.front().unwrap().counts();
    search.shift = offsets(-3..=3);
    assert!(equals_brute_force(&search).unwrap() > 3);
    let found = search.front().unwrap();
    assert!(found.counts().tooth_sets > without.tooth_sets && found.counts().feasible > without.feasible);
    search.shift = offsets(0..=0);
    assert!(equals_brute_force(&search).unwrap() > 1);
    search.requirements.tolerance = 1e-6;
    search.shift = offsets(3..=3);
    let found = search.front().unwrap();
    let all: Vec<String> = found
        .entries()
        .iter()
        .flat_map(|entry| found.designs(entry))
        .flat_map(|design| design.teeth)
        .map(|teeth| teeth.to_string())
        .collect();
    assert_eq!(all, ["18/36/93 ×3"]);
    search.shift = offsets(-12..=3);
    assert!(matches!(search.front(), Err(Error::GearSet(_))));
    search.shift = offsets(0..=3);
    (search.bounds.sun, search.bounds.planet, search.bounds.ring) = (1..=2000, 1..=2000, 1..=4000);
    assert!(matches!(search.front(), Err(Error::TooManyToothSets { .. })));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(6))]
    /// Compares searches with the planets' own teeth in speeds and sizes.
    #[test]
    fn search_with_profile_shift_equals_brute_force(
        ratio in prop_oneof![-6.0..-1.5_f64, 1.15..8.0_f64],
        sun in 12..24_u32,
        low in -3..=0_i32,
        more in 0..=3_i32,
        planet_speed in 0.5..6.0_f64,
        objective in 0..5_usize,
    ) {
        let mut search = search(ratio);
        search.requirements.tolerance = 0.1;
        search.requirements.limits.planet_speed = planet_speed;
        search.order = Order::new(&[Objective::ALL[objective]]).unwrap();
        search.bounds = Bounds { sun: sun..=sun + 3, planet: 12..=28, ring: 36..=76, planets: 3..=4, ..Bounds::default() };
        search.shift = offsets(low..=low + more);
        equals_brute_force(&search)?;
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(16))]
    #[test]
    fn search_equals_brute_force(
        ratio in prop_oneof![-6.0..-0.15_f64, 0.15..0.95_f64, 1.05..8.0_f64],
        sun in 8..20_u32,
        least_planets in 2..4_u32,
        tolerance in 0.005..0.5_f64,
        limits in (0.85..0.985_f64, 1.0..4.0_f64, 0.5..6.0_f64, 0.3..3.0_f64),
        switches in (any::<bool>(), any::<bool>(), any::<bool>(), any::<bool>()),
        objective in 0..5_usize,
        catalogue in any::<bool>(),
    ) {
        let mut search = search(ratio);
        let of = &mut search.requirements;
        of.tolerance = tolerance;
        (of.limits.efficiency, of.limits.link_speed) = (limits.0, limits.1);
        (of.limits.planet_speed, of.limits.clutch_slip) = (limits.2, limits.3);
        (of.limits.drawable, of.limits.same_direction) = (switches.0, switches.3);
        of.signs = if switches.1 { Signs::AsGiven } else { Signs::Alike };
        if switches.2 {
            of.rating.mesh_load_factors = [1.0, 1.0, 1.3, 1.9, 2.2, 2.4, 2.5];
        }
        search.sets = if catalogue { Space::Catalogue.sets() } else { Space::All.sets() };
        search.order = Order::new(&[Objective::ALL[objective]]).unwrap();
        search.bounds = Bounds {
            sun: sun..=sun + 14, planet: 10..=35, ring: 24..=90, planets: least_planets..=5, ..Bounds::default()
        };
        equals_brute_force(&search)?;
        // The best in the order are first.
        let found = search.front().unwrap();
        let first = |entry: &epicyclic_selection::front::Entry| {
            let o = entry.objectives;
            [-o.efficiency, o.speed, o.ring_to_sun, o.ratio_error, o.size][objective]
        };
        prop_assert!(found.entries().is_sorted_by(|one, other| first(one) <= first(other) + 1e-12));
    }
}

#[test]
fn what_was_searched_is_counted() {
    let search = search(3.9375);
    let found = search.front().unwrap();
    let counts = found.counts();
    assert_eq!((counts.tooth_sets, counts.patches, counts.designs), (8016, 12, 12 * 8016));
    assert!(counts.tried >= counts.feasible && counts.feasible > 0 && counts.patches_tried < 12);
    let (best, of) = (found.entries()[0].objectives, found.designs(&found.entries()[0]));
    assert_eq!(of[0].set, [Role::D, Role::T1, Role::B]);
    assert!(best.efficiency > 0.97 && best.ratio_error <= 0.1);
}

#[test]
fn limits_of_module_and_ring_need_a_torque_and_are_kept() {
    let mut search = search(3.9375);
    search.bounds.ring = 12..=90;
    let mm = Length::new::<millimeter>;
    search.ring_diameter = Some(mm(200.0));
    assert!(matches!(search.front(), Err(Error::SizeWithoutTorque)));
    search.requirements.rating.load =
        Some((Torque::new::<newton_meter>(500.0), Pressure::new::<megapascal>(2.0)));
    let unit = search.requirements.rating.unit().unwrap();
    let free = OneSetSearch { ring_diameter: None, ..search.clone() }.front().unwrap();
    search.module = Some(mm(2.0)..=mm(3.0));
    let found = search.front().unwrap();
    assert!(found.counts().feasible < free.counts().feasible && !found.entries().is_empty());
    for entry in found.entries() {
        let ring = unit * entry.objectives.size;
        assert!(ring <= mm(200.0));
        for teeth in found.designs(entry).iter().flat_map(|design| &design.teeth) {
            let module = ring / teeth.ring.as_f64();
            assert!(module >= mm(2.0 - 1e-9) && module <= mm(3.0 + 1e-9), "{module:?}");
        }
    }
}

#[test]
fn what_cannot_be_searched_is_refused() {
    let two = Requirements::new(RatioSeries::of_braked_gears(&[1.5, 2.5]).unwrap());
    assert_eq!(OneSetSearch::new(two).front().unwrap_err(), Error::OneRatio { count: 2 });
    let mut wide = search(3.9375);
    wide.order = Order::new(&[Objective::Circulation]).unwrap();
    assert!(matches!(wide.front(), Err(Error::NoObjectiveOfTeeth { .. })));
    wide.order = Order::default();
    wide.requirements.tolerance = 0.9;
    (wide.bounds.sun, wide.bounds.planet, wide.bounds.ring) = (1..=2000, 1..=2000, 1..=4000);
    match wide.front() {
        Err(Error::TooManyNear { tooth_sets, most: MOST_TOOTH_SETS }) => {
            assert!(tooth_sets > MOST_TOOTH_SETS);
        }
        other => panic!("{other:?}"),
    }
    // Near the ratio there are few of the same.
    wide.requirements.tolerance = 0.001;
    let mut shares = vec![];
    let found = wide.front_watched(|share| {
        shares.push(share);
        ControlFlow::Continue(())
    });
    let found = found.unwrap();
    assert!(!found.entries().is_empty() && found.counts().tooth_sets as u64 > MOST_TOOTH_SETS);
    assert!(shares.is_sorted() && shares.last() == Some(&1.0));
}
