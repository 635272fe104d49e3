//! The search over teeth finds exactly what brute force finds, whatever the number of threads.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use crate::brute_common as brute;
use epicyclic_gears::involute::closing::Closing;
use epicyclic_gears::involute::search::ProfileShift;
use epicyclic_gears::synthesis::{Bounds, ToothNumbers};
use epicyclic_schemes::RatioSeries;
use epicyclic_schemes::structures::Structure;
use epicyclic_selection::search::{Found, MOST_PAIRS, MOST_TOOTH_SETS, ToothSearch};
use epicyclic_selection::{Error, Objective, Order, Requirements, Signs};
use proptest::prelude::*;
use std::collections::BTreeMap;
use std::ops::ControlFlow;
use uom::si::f64::{Length, Pressure, Torque};
use uom::si::length::millimeter;
use uom::si::pressure::megapascal;
use uom::si::torque::newton_meter;

fn excavator() -> Requirements {
    Requirements::new(RatioSeries::of_braked_gears(&[1.95 / 1.33, 1.95 / 0.76]).unwrap())
}

type Key = (Structure, [ToothNumbers; 2], bool);

fn members(found: &Found) -> BTreeMap<Key, [f64; 5]> {
    let mut all = BTreeMap::new();
    for entry in found.entries() {
        let o = entry.objectives;
        for design in found.designs(entry) {
            for teeth in design.pairs {
                let costs = [-o.efficiency, o.speed, o.ring_to_sun, o.ratio_error, o.size];
                all.insert((design.structure, teeth, design.wanted[0] > design.wanted[1]), costs);
            }
        }
    }
    all
}

fn equals_brute_force(search: &ToothSearch) -> Result<usize, TestCaseError> {
    let (designs, _) = match &search.shift {
        None => brute::designs(&search.requirements, &search.structures, &search.bounds),
        Some(shift) => {
            let all = brute::shifted_by_trial(&search.bounds, shift);
            brute::designs_of(&search.requirements, &search.structures, &all, Some(shift))
        }
    };
    let exact: BTreeMap<Key, [f64; 5]> = brute::front(&designs)
        .into_iter()
        .map(|d| ((d.structure, d.teeth, d.wanted[0] > d.wanted[1]), d.costs))
        .collect();
    let found = search.front().unwrap();
    let ours = members(&found);
    prop_assert_eq!(ours.keys().collect::<Vec<_>>(), exact.keys().collect::<Vec<_>>());
    for (key, costs) in &ours {
        for (one, other) in costs.iter().zip(exact[key]) {
            prop_assert!((one - other).abs() < 1e-9, "{:?} {:?} {:?}", key, costs, exact[key]);
        }
    }
    let best = search.best(5).unwrap();
    let objectives =
        |found: &Found| -> Vec<_> { found.entries().iter().take(5).map(|e| e.objectives).collect() };
    prop_assert_eq!(objectives(&best), objectives(&found));
    for (one, other) in best.entries().iter().zip(found.entries()) {
        prop_assert_eq!(best.designs(one), found.designs(other));
    }
    Ok(ours.len())
}

#[test]
fn circulating_power_has_a_limit_and_is_no_objective_over_teeth() {
    let mut search = ToothSearch::new(excavator());
    search.bounds = Bounds { ring: 12..=48, ..Bounds::default() };
    let accepted = |search: &ToothSearch| search.best(1).unwrap().counts().feasible;
    let all = accepted(&search);
    search.requirements.limits.circulation = 0.2;
    let few = accepted(&search);
    assert!(0 < few && few < all, "{few} of {all}");
    assert!(equals_brute_force(&search).unwrap() > 0);
    search.order = Order::new(&[Objective::Circulation]).unwrap();
    assert!(matches!(search.front(), Err(Error::NoObjectiveOfTeeth { .. })));
}

#[test]
fn the_excavator_wheel_over_small_rings() {
    let mut search = ToothSearch::new(excavator());
    search.bounds = Bounds { ring: 12..=48, ..Bounds::default() };
    assert!(equals_brute_force(&search).unwrap() > 10);
}

/// Planets of one ring and sun with several tooth numbers, so that `k` alone decides neither speeds nor
/// sizes.
#[test]
fn the_excavator_wheel_with_profile_shift() {
    let mut search = ToothSearch::new(excavator());
    search.bounds = Bounds { sun: 12..=20, ring: 30..=48, planets: 3..=4, ..Bounds::default() };
    search.requirements.limits.planet_speed = 2.5;
    search.structures = Structure::catalogue();
    // Sets without an offset are closed as well: of those with few teeth some are undercut whatever the
    // shifts.
    let mut levels = vec![];
    for offsets in [0..=0, -2..=2] {
        search.shift = Some(ProfileShift { offsets: offsets.clone(), closing: Closing::default() });
        for objective in [Objective::Size, Objective::Speed] {
            search.order = Order::new(&[objective]).unwrap();
            let found = equals_brute_force(&search).unwrap();
            assert!(offsets == (0..=0) || found > 10, "{found}");
        }
        levels.push(search.front().unwrap().counts().levels);
    }
    assert!(levels[1] > 2 * levels[0], "{levels:?}");
    search.shift = Some(ProfileShift { offsets: 10..=11, closing: Closing::default() });
    assert!(matches!(search.front(), Err(Error::GearSet(_))));
}

/// A search of what the document's question leaves open.
fn any_search(signs: Signs) -> impl Strategy<Value = ToothSearch> {
    let ratios = (1.05..2.5_f64, 1.05..3.0_f64, 0.005..0.2_f64);
    let bounds = (8..20_u32, 2..4_u32);
    let limits = (0.85..0.97_f64, 1.0..4.0_f64, 1.0..6.0_f64, 0.8..3.0_f64);
    let circulation = prop_oneof![2 => Just(f64::INFINITY), 1 => 0.0..1.5_f64];
    let switches = (any::<bool>(), any::<bool>());
    let some = proptest::collection::vec(0..111_usize, 12);
    (ratios, bounds, limits, circulation, switches, 0..5_usize, some).prop_map(
        move |(
            (q, step, tolerance),
            (sun, least_planets),
            limits,
            circulation,
            switches,
            objective,
            some,
        )| {
            let mut requirements = Requirements::new(RatioSeries::of_braked_gears(&[q, q * step]).unwrap());
            requirements.tolerance = tolerance;
            (requirements.limits.efficiency, requirements.limits.link_speed) = (limits.0, limits.1);
            (requirements.limits.planet_speed, requirements.limits.clutch_slip) = (limits.2, limits.3);
            requirements.limits.circulation = circulation;
            requirements.limits.drawable = switches.0;
            requirements.signs = signs;
            if switches.1 {
                requirements.rating.mesh_load_factors = [1.0, 1.0, 1.3, 1.9, 2.2, 2.4, 2.5];
            }
            let mut search = ToothSearch::new(requirements);
            let all = Structure::all();
            search.structures = some.into_iter().map(|place| all[place]).collect();
            search.structures.sort();
            search.structures.dedup();
            search.order = Order::new(&[Objective::ALL[objective]]).unwrap();
            search.bounds = Bounds {
                sun: sun..=sun + 9,
                planet: 10..=25,
                ring: 24..=60,
                planets: least_planets..=5,
                ..Bounds::default()
            };
            search
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(8))]
    #[test]
    fn search_equals_brute_force_for_any_signs(search in any_search(Signs::Any)) {
        equals_brute_force(&search)?;
    }

    #[test]
    fn search_with_profile_shift_equals_brute_force(search in any_search(Signs::Alike), low in -2..=0_i32, more in 0..=2_i32) {
        let shift = ProfileShift { offsets: low..=low + more, closing: Closing::default() };
        // Closing each set takes nearly all the time: few suns.
        let sun = *search.bounds.sun.start();
        let bounds = Bounds { sun: sun..=sun + 4, planet: 14..=22, ..search.bounds.clone() };
        equals_brute_force(&ToothSearch { bounds, shift: Some(shift), ..search })?;
    }

    #[test]
    fn search_equals_brute_force_for_like_signs(search in any_search(Signs::Alike)) {
        equals_brute_force(&search)?;
    }
}

#[test]
fn the_number_of_threads_changes_nothing() {
    let mut search = ToothSearch::new(excavator());
    search.bounds = Bounds { ring: 12..=80, ..Bounds::default() };
    let run = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let found = pool.install(|| search.front()).unwrap();
        let best = pool.install(|| search.best(7)).unwrap();
        assert_eq!(best.entries()[6].objectives, found.entries()[6].objectives);
        (found.entries().to_vec(), found.counts(), best.entries().to_vec())
    };
    let alone = run(1);
    assert!(alone == run(2) && alone == run(5));
}

/// More than 256 entries are not looked for before a bound.
#[test]
fn the_first_before_a_bound_are_the_first_of_all() {
    let mut search = ToothSearch::new(excavator());
    search.bounds.ring = 12..=80;
    search.requirements.signs = Signs::Any;
    let of_teeth = Objective::ALL.into_iter().filter(|objective| *objective != Objective::Circulation);
    for objective in of_teeth {
        search.order = Order::new(&[objective]).unwrap();
        let all = search.best(257).unwrap();
        for count in [1, 10, 100] {
            let few = search.best(count).unwrap();
            assert_eq!((few.entries().len(), few.counts()), (count, all.counts()));
            for (one, other) in few.entries().iter().zip(all.entries()) {
                assert_eq!((one.objectives, few.designs(one)), (other.objectives, all.designs(other)));
            }
        }
    }
}

/// Gives the same first designs for any number of designs held, or refuses the search.
#[test]
fn what_is_held_changes_nothing_or_is_refused() {
    let mut search = ToothSearch::new(excavator());
    search.bounds.ring = 12..=80;
    let (best, whole) = (search.best(20).unwrap(), search.front().unwrap());
    assert_eq!(best.entries().len(), 20);
    for entry in best.entries() {
        let (all, (first, count)) = (best.designs(entry), best.first_design(entry).unwrap());
        assert_eq!(count, all.iter().map(|design| design.pairs.len() as u64).sum::<u64>());
        assert_eq!((first.structure, first.k, first.pairs[0]), (all[0].structure, all[0].k, all[0].pairs[0]));
    }
    let (mut told, mut refused) = (0, 0);
    for most_held in [4, 200, 2000, 6000, 10_000, 15_000, 20_000, 200_000] {
        let little = ToothSearch { most_held, ..search.clone() };
        match little.best(20) {
            Ok(found) => {
                let objectives = |found: &Found| -> Vec<_> {
                    found.entries().iter().map(|entry| (entry.objectives, found.designs(entry))).collect()
                };
                assert_eq!(objectives(&found), objectives(&best), "{most_held}");
                assert_eq!(found.counts(), best.counts());
                told += 1;
            }
            Err(Error::FrontTooLarge { .. }) => refused += 1,
            Err(other) => panic!("{other}"),
        }
        match little.front() {
            Ok(found) => assert_eq!(members(&found), members(&whole), "{most_held}"),
            Err(Error::FrontTooLarge { .. }) => refused += 1,
            Err(other) => panic!("{other}"),
        }
    }
    assert!(told >= 4 && refused >= 3, "{told} told, {refused} refused");
}

#[test]
fn a_space_beyond_all_memory_is_refused_with_its_size() {
    let mut search = ToothSearch::new(excavator());
    let every = 1..=10_000;
    (search.bounds.sun, search.bounds.planet, search.bounds.ring) = (every.clone(), every.clone(), every);
    match search.best(1) {
        Err(Error::TooManyToothSets { tooth_sets, most: MOST_TOOTH_SETS }) => {
            assert_eq!(tooth_sets, search.bounds.count().unwrap());
        }
        Err(other) => panic!("{other}"),
        Ok(_) => panic!("it was tried"),
    }
    let range = 1..=600;
    (search.bounds.sun, search.bounds.planet, search.bounds.ring) = (range.clone(), range.clone(), range);
    search.requirements.tolerance = 0.5;
    match search.best(1) {
        Err(Error::TooManyPairs { tooth_sets, pairs, most: MOST_PAIRS, .. }) => {
            assert!(tooth_sets < 80_313 && tooth_sets > 79_000 && pairs > MOST_PAIRS, "{tooth_sets}");
        }
        Err(other) => panic!("{other}"),
        Ok(_) => panic!("it was tried"),
    }
}

#[test]
fn what_the_document_missed_wins_over_all_teeth() {
    let found = ToothSearch::new(excavator()).best(1).unwrap();
    let counts = found.counts();
    assert_eq!((counts.tooth_sets, counts.levels), (8016, 2696));
    let best = &found.entries()[0];
    assert!((best.objectives.efficiency - 0.98158).abs() < 1e-5 && best.objectives.speed <= 2.0);
    assert!(found.designs(best).iter().all(|design| design.structure.to_string() == "D.T1.B+T2.B.T1"));
}

#[test]
fn a_search_can_be_watched_and_cancelled() {
    let mut search = ToothSearch::new(excavator());
    search.bounds = Bounds { ring: 12..=90, ..Bounds::default() };
    let seen = std::sync::atomic::AtomicUsize::new(0);
    let all = search.front_watched(&|progress| {
        assert!(progress.done <= progress.of);
        seen.fetch_add(1, std::sync::atomic::Ordering::Relaxed);
        ControlFlow::Continue(())
    });
    assert!(all.is_ok() && seen.into_inner() > 1);
    assert!(matches!(search.front_watched(&|_| ControlFlow::Break(())), Err(Error::Cancelled)));
    assert!(matches!(search.best_watched(3, &|_| ControlFlow::Break(())), Err(Error::Cancelled)));
}

#[test]
fn limits_of_module_and_ring_need_a_torque_and_are_kept() {
    let mut search = ToothSearch::new(excavator());
    search.bounds = Bounds { ring: 12..=72, ..Bounds::default() };
    let mm = Length::new::<millimeter>;
    search.ring_diameter = Some(mm(300.0));
    assert!(matches!(search.front(), Err(Error::SizeWithoutTorque)));
    search.requirements.rating.load =
        Some((Torque::new::<newton_meter>(800.0), Pressure::new::<megapascal>(2.0)));
    let unit = search.requirements.rating.unit().unwrap();
    let free = ToothSearch { ring_diameter: None, ..search.clone() }.front().unwrap();
    let limit = free.entries().iter().map(|e| e.objectives.size).fold(0.0, f64::max) * 0.7;
    search.ring_diameter = Some(unit * limit);
    search.module = Some(mm(3.0)..=mm(5.0));
    let found = search.front().unwrap();
    assert!(found.counts().feasible < free.counts().feasible && !found.entries().is_empty());
    for entry in found.entries() {
        assert!(entry.objectives.size <= limit);
        let designs = found.designs(entry);
        assert!(designs.iter().all(|design| !design.pairs.is_empty()));
        // The larger ring is the entry's size; its module is within limits.
        for pair in designs.iter().flat_map(|design| &design.pairs) {
            let modules = pair.map(|teeth| unit * entry.objectives.size / teeth.ring.as_f64());
            assert!(modules.iter().any(|m| *m >= mm(3.0 - 1e-9) && *m <= mm(5.0 + 1e-9)), "{modules:?}");
        }
    }
}

#[test]
fn invalid_requirements_are_refused() {
    let one = ToothSearch::new(Requirements::new(RatioSeries::of_braked_gears(&[2.0]).unwrap()));
    assert_eq!(one.front().unwrap_err(), Error::RatioCount { count: 1 });
    let mut empty = ToothSearch::new(excavator());
    #[allow(clippy::reversed_empty_ranges, reason = "the bad input")]
    {
        empty.bounds.ring = 60..=50;
    }
    assert!(matches!(empty.front().unwrap_err(), Error::GearSet(_)));
    let mut odd = ToothSearch::new(excavator());
    odd.requirements.tolerance = f64::NAN;
    assert!(matches!(odd.best(1).unwrap_err(), Error::Tolerance { .. }));
    assert!(odd.requirements.tolerance.is_nan());
    let mut none = ToothSearch::new(excavator());
    none.bounds = Bounds { sun: 12..=12, planet: 12..=12, ring: 36..=36, ..Bounds::default() };
    none.requirements.tolerance = 1e-3;
    assert!(none.front().unwrap().entries().is_empty());
}

/// In both gears the efficiency and in gear 1 all else comes from set 1 alone. The efficiency of k = 20/9
/// lies half-way between two points of the grid of objectives, where the last bit of a double decides.
#[test]
fn what_set_2_does_not_change_is_equal_beside_every_set_2() {
    let mut requirements = Requirements::new(
        RatioSeries::of_braked_gears(&[2.236_511_666_619_74, 2.929_021_708_935_084]).unwrap(),
    );
    requirements.tolerance = 0.134;
    (requirements.limits.link_speed, requirements.limits.clutch_slip) = (1.0, 0.8);
    (requirements.limits.planet_speed, requirements.limits.drawable) = (5.43, false);
    let mut search = ToothSearch::new(requirements);
    search.structures.retain(|structure| structure.to_string() == "D.T1.B+D.T2.T1");
    search.bounds =
        Bounds { sun: 9..=18, planet: 10..=25, ring: 24..=60, planets: 2..=5, ..Bounds::default() };
    equals_brute_force(&search).unwrap();
    let found = search.front().unwrap();
    let at = |k: f64| found.entries().iter().flat_map(|e| found.designs(e)).filter(move |d| d.k[0] == k);
    let beside: Vec<f64> = at(40.0 / 18.0).map(|design| design.k[1]).collect();
    assert!(beside.len() > 5 && beside.contains(&3.0), "{beside:?}");
    assert_eq!(found.entries().iter().filter(|e| found.designs(e)[0].k[0] == 40.0 / 18.0).count(), 1);
}

/// The best of each structure is what a search of that structure alone finds first.
#[test]
fn the_best_of_each_structure_is_the_first_of_a_search_of_it_alone() {
    let mut search = ToothSearch::new(excavator());
    search.bounds = Bounds { ring: 12..=48, ..Bounds::default() };
    let best = search.best_of_each_watched(&|_| std::ops::ControlFlow::Continue(())).unwrap();
    assert!(best.len() > 1, "{}", best.len());
    let mut told = 0;
    for structure in search.structures.clone() {
        let alone = ToothSearch { structures: vec![structure], ..search.clone() }.best(1).unwrap();
        let Some(first) = alone.entries().first() else { continue };
        let of_it = best
            .iter()
            .find(|found| found.first_design(&found.entries()[0]).unwrap().0.structure == structure);
        let of_it = of_it.unwrap();
        assert_eq!(of_it.entries()[0].objectives, first.objectives);
        assert_eq!(of_it.first_design(&of_it.entries()[0]), alone.first_design(first));
        told += 1;
    }
    assert_eq!(told, best.len());
    // The first of all is the first of its structure.
    let all = search.best(1).unwrap();
    assert_eq!(best[0].entries()[0].objectives, all.entries()[0].objectives);
}
