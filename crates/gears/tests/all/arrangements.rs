//! Searches for arrangements of gears, held against the trial of every combination.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

#[path = "../common/trial.rs"]
mod trial;

use epicyclic_gears::arrangement::{ArrangedCandidate, ArrangedTeeth, Arrangement, ArrangementBounds};
use epicyclic_gears::geometry::GearKind;
use epicyclic_gears::involute::check::{Check, Severity};
use epicyclic_gears::involute::checks::{Limits, gear_checks, mesh_checks};
use epicyclic_gears::involute::family::Aim;
use epicyclic_gears::involute::shifts::StatedDistance;
use epicyclic_gears::involute::tree::MeshTree;
use epicyclic_gears::involute::{InvoluteGear, Pair, Profile};
use epicyclic_gears::quantity::SimpleGear;
use epicyclic_gears::synthesis::{Bounds, Placement, Ranked};
use epicyclic_gears::{Error, ToothCount};
use proptest::prelude::*;
use std::ops::ControlFlow;
use trial::arranged_by_trial;
use uom::si::angle::degree;
use uom::si::f64::Angle;

fn for_ratio(
    bounds: &ArrangementBounds,
    ratio: f64,
    mode: &str,
    tolerance: f64,
) -> Result<Ranked<ArrangedCandidate>, Error> {
    let mode = bounds.arrangement.mode(mode).unwrap();
    bounds.for_ratio(ratio, mode, tolerance, usize::MAX, |_| ControlFlow::Continue(()))
}

fn usual(arrangement: Arrangement) -> ArrangementBounds {
    ArrangementBounds::of(arrangement, &Bounds::default())
}

/// Place of a set in the list for its own ratio.
fn place_of(bounds: &ArrangementBounds, teeth: &[u32], planets: u32, mode: &str) -> Option<usize> {
    let set = ArrangedTeeth::new(bounds.arrangement, teeth, 1.into(), planets).unwrap();
    let ratio = set.ratio(bounds.arrangement.mode(mode).unwrap()).unwrap();
    let ratio = *ratio.numer() as f64 / *ratio.denom() as f64;
    for_ratio(bounds, ratio, mode, 0.0).unwrap().first.iter().position(|one| one.teeth == set)
}

#[test]
fn published_sets_are_found_by_their_ratio() {
    // A robot's drive, 18/66 and 33/117.
    assert!(place_of(&usual(Arrangement::Stepped), &[18, 66, 33, 117], 3, "aH^b").is_some());
    assert!(place_of(&usual(Arrangement::Wolfrom), &[32, 34, 100, 30, 96], 3, "ae^b").is_some());
    assert!(place_of(&usual(Arrangement::Ravigneaux), &[30, 18, 18, 36, 72], 3, "ab^c").is_some());
    // The large sun has 38 teeth and the ring 85: no planet lies between them without profile shift.
    let shifted = ArrangementBounds { offsets: -1..=1, ..usual(Arrangement::Ravigneaux) };
    let plain = for_ratio(&usual(Arrangement::Ravigneaux), 5865.0 / 3813.0, "ab^c", 0.0).unwrap();
    assert!(plain.first.iter().all(|set| set.teeth.teeth()[4] == 170));
    for long in [23, 24] {
        assert!(place_of(&shifted, &[31, 20, long, 38, 85], 3, "ab^c").is_some(), "{long}");
    }
}

#[test]
fn a_ratio_out_of_reach_names_one_that_is_not() {
    let error = for_ratio(&usual(Arrangement::SteppedRings), 1e7, "He^b", 0.01).unwrap_err();
    assert!(matches!(error, Error::NoArrangement { nearest: Some(_), .. }), "{error}");
    let error = for_ratio(&usual(Arrangement::Stepped), -3.0, "aH^b", 0.01).unwrap_err().to_string();
    let expected = "no set with a stepped planet within the bounds has the ratio -3 (aH^b) within 1%; \
                    none has this sign, or none assembles: widen the bounds or choose another mode";
    assert_eq!(error, expected);
}

#[test]
fn steps_of_other_modules_close_exactly() {
    let bounds =
        ArrangementBounds { module_ratios: vec!["5/4".parse().unwrap()], ..usual(Arrangement::Stepped) };
    let found = for_ratio(&bounds, 14.0, "aH^b", 0.01).unwrap();
    assert!(found.found > 50, "{}", found.found);
    for one in &found.first {
        let z = one.teeth.teeth();
        assert_eq!(4 * (z[0] + z[1]), 5 * (z[3] - z[2]), "{}", one.teeth);
        assert!(one.teeth.is_coaxial());
    }
    let wrong = ArrangementBounds { arrangement: Arrangement::Ravigneaux, ..bounds.clone() };
    let wrong = ArrangementBounds { teeth: usual(Arrangement::Ravigneaux).teeth, ..wrong };
    let error = for_ratio(&wrong, 1.5, "ab^c", 0.01).unwrap_err().to_string();
    assert_eq!(error, "module ratio 5/4, Ravigneaux set: its gears have one module, leave it at 1");
}

#[test]
fn the_most_exact_and_then_the_smallest_come_first() {
    let found = for_ratio(&usual(Arrangement::Stepped), 14.0, "aH^b", 0.01).unwrap();
    let order = |one: &ArrangedCandidate| (one.ratio_error.abs(), one.teeth.size());
    assert!(found.first.is_sorted_by(|one, other| order(one) <= order(other)));
    let mode = Arrangement::Stepped.mode("aH^b").unwrap();
    let few =
        usual(Arrangement::Stepped).for_ratio(14.0, mode, 0.01, 7, |_| ControlFlow::Continue(())).unwrap();
    assert_eq!((few.found, &few.first[..]), (found.found, &found.first[..7]));
}

/// Meshes of a planet with central gears at its carrier radius, of two planets at their own distance.
fn pairs(set: &ArrangedTeeth, gears: &[InvoluteGear]) -> Vec<Pair> {
    let places = set.arrangement().gears();
    let own = set.arrangement().meshes().iter();
    let pair = |mesh: &[usize; 2]| {
        let [one, other] = mesh.map(|gear| gears[gear]);
        if mesh.iter().all(|gear| places[*gear].role == SimpleGear::Planet) {
            return Pair::without_backlash(one, other).unwrap();
        }
        let planet = mesh.iter().find(|gear| places[**gear].role == SimpleGear::Planet).unwrap();
        let ratio = set.module_ratio();
        let module = f64::from(*ratio.numer()) / f64::from(*ratio.denom());
        let module = if places[*planet].step == 0 { 1.0 } else { module };
        Pair::at_centre_distance(one, other, set.carrier_radius(*planet) / module).unwrap()
    };
    own.map(pair).collect()
}

/// The first check of gears or meshes that fails, remarks apart.
fn first_fault(gears: &[InvoluteGear], pairs: &[Pair], limits: &Limits) -> Option<Check<String>> {
    let mut first = None;
    let mut see = |check: Check<String>| {
        let fails = check.rule.severity() > Severity::Remark && !check.holds();
        if fails && first.is_none() {
            first = Some(check);
        }
    };
    for (place, gear) in gears.iter().enumerate() {
        gear_checks(&format!("gear {place}"), gear, limits, &mut see);
    }
    for (place, pair) in pairs.iter().enumerate() {
        let name = format!("mesh {place}");
        mesh_checks(&name, &[name.clone(), name.clone()], pair, limits, &mut see);
    }
    first
}

#[test]
fn shifts_of_all_gears_close_every_mesh_without_faults() {
    let three_fifths = vec![1.into(), "3/5".parse().unwrap()];
    let requests = [
        (Arrangement::Wolfrom, 100.0, -2..=2, vec![1.into()]),
        (Arrangement::Stepped, 14.0, -2..=1, three_fifths),
        (Arrangement::SteppedRings, 25.0, -1..=1, vec![1.into()]),
        (Arrangement::SteppedSuns, 40.0, -1..=1, vec![1.into()]),
        (Arrangement::Ravigneaux, 1.5382, -1..=1, vec![1.into()]),
    ];
    for (arrangement, ratio, offsets, module_ratios) in requests {
        for aim in [Aim::BalancedSliding, Aim::LeastTipAlteration] {
            let limits = Limits { tip_thickness: 0.35, ..Limits::default() };
            let bounds = ArrangementBounds {
                offsets: offsets.clone(),
                module_ratios: module_ratios.clone(),
                aim,
                limits,
                ..usual(arrangement)
            };
            let found = for_ratio(&bounds, ratio, arrangement.usual_mode(), 0.0002).unwrap();
            let (mut one_gear, mut shifted_planets) = (0, 0);
            for set in &found.first {
                let Some(shifts) = set.shifts else {
                    assert!(set.teeth.is_coaxial(), "{}", set.teeth);
                    continue;
                };
                assert!(!set.teeth.is_coaxial(), "{}", set.teeth);
                let gears = set.teeth.shifted_gears(&shifts, &bounds.rack).unwrap();
                let pairs = pairs(&set.teeth, &gears);
                assert!(pairs.iter().all(|pair| pair.backlash().abs() < 1e-9), "{}", set.teeth);
                assert_eq!(first_fault(&gears, &pairs, &limits), None, "{}", set.teeth);
                if set.teeth.has_one_step() {
                    one_gear += 1;
                    let step = if arrangement == Arrangement::Wolfrom { 3 } else { 2 };
                    assert_eq!(shifts.profile()[1], shifts.profile()[step], "{}", set.teeth);
                }
                shifted_planets += usize::from(shifts.profile()[1] != 0.0);
            }
            assert!(shifted_planets > 5, "{arrangement} {aim:?}: {shifted_planets}");
            assert_eq!(one_gear > 0, arrangement == Arrangement::Wolfrom, "{arrangement}");
        }
    }
}

#[test]
fn more_sets_assemble_at_unequal_angles() {
    let equal = usual(Arrangement::Stepped);
    let unequal = ArrangementBounds { placement: Placement::LeastUnequal, ..equal.clone() };
    let [equal, unequal] =
        [equal, unequal].map(|bounds| for_ratio(&bounds, 14.0, "aH^b", 0.01).unwrap().found);
    assert!(unequal > equal, "{unequal} {equal}");
}

#[test]
fn planets_stand_at_stated_angles_that_are_assembly_positions() {
    let at = |degrees: &[f64]| {
        let angles = degrees.iter().map(|angle| Angle::new::<degree>(*angle)).collect();
        ArrangementBounds { angles, ..usual(Arrangement::Stepped) }
    };
    let equal = ArrangementBounds { planets: 4..=4, ..usual(Arrangement::Stepped) };
    let [equal, stated] =
        [equal, at(&[0.0, 90.0, 180.0, 270.0])].map(|bounds| for_ratio(&bounds, 14.0, "aH^b", 0.01).unwrap());
    assert_eq!(equal, stated);
    // Two pairs of planets opposite each other, 80° apart.
    let pairs = for_ratio(&at(&[0.0, 80.0, 180.0, 260.0]), 14.0, "aH^b", 0.01).unwrap();
    assert!(
        pairs.first.iter().all(|set| set.teeth.assembly_positions().is_multiple_of(18)) && pairs.found > 0
    );
    let error = for_ratio(&at(&[0.0, 360.0]), 14.0, "aH^b", 0.01).unwrap_err().to_string();
    assert_eq!(error, "2 angles of planets: give 2 or more finite angles, no two the same");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(512))]
    #[test]
    fn the_search_finds_what_trial_finds(
        arrangement in prop::sample::select(Arrangement::ALL.to_vec()),
        least in prop::array::uniform5(8..40_u32),
        spread in prop::array::uniform5(2..7_u32),
        near in any::<bool>(),
        planets in 2..=5_u32, more in 0..4_u32,
        pick in any::<prop::sample::Index>(),
        wanted in prop_oneof![0.2..8.0_f64, -8.0..-0.2_f64, 8.0..200.0_f64],
        tolerance in prop_oneof![Just(0.0), 0.001..0.1_f64, 0.3..0.9_f64],
        offsets in prop_oneof![Just((0, 0)), (-2..=0_i32, 0..=2_i32)],
        tip_gap in prop_oneof![Just(0.0), 0.0..1.5_f64],
        own in any::<prop::sample::Index>(),
    ) {
        // Central gears that lie where the planet does not are seldom a set: most requests put them there.
        let [a, g, f, _, _] = least;
        let least = match arrangement {
            _ if !near => least,
            Arrangement::Stepped => [a, g, f, a + g + f, 0],
            Arrangement::SteppedSuns => [a + f, g, f, a + g, 0],
            Arrangement::SteppedRings => [a + 2 * g + f, g, f, a + g + 2 * f, 0],
            Arrangement::Wolfrom => [a, g, a + 2 * g, f, a + g + f],
            Arrangement::Ravigneaux => [a, g / 2 + 6, f, a + 4, a + 4 + 2 * f],
            Arrangement::ExternalPair | Arrangement::InternalPair => least,
        };
        let teeth: Vec<_> = (0..arrangement.gears().len()).map(|gear| {
            let from = least[gear].saturating_sub(spread[gear] / 2).max(4);
            from..=from + spread[gear]
        }).collect();
        let bounds = ArrangementBounds {
            teeth: teeth.clone(), planets: planets..=(planets + more).min(8), offsets: offsets.0..=offsets.1, tip_gap,
            ..usual(arrangement)
        };
        let modes = arrangement.modes();
        let mode = modes[pick.index(modes.len())];
        // The ratio of some gears within the bounds, so that tolerance 0 is met as well.
        let exact: Vec<u32> = teeth.iter().map(|range| range.start() + own.index(range.clone().count()) as u32).collect();
        let exact = ArrangedTeeth::new(arrangement, &exact, 1.into(), 3).unwrap().ratio(mode);
        let exact = exact.map(|ratio| *ratio.numer() as f64 / *ratio.denom() as f64).filter(|ratio| *ratio != 0.0);
        let wanted = exact.filter(|_| near).unwrap_or(wanted);
        let by_trial = arranged_by_trial(&bounds, wanted, mode, tolerance);
        let (found, left_out): (Vec<ArrangedTeeth>, _) = match bounds.for_ratio(wanted, mode, tolerance, usize::MAX, |_| ControlFlow::Continue(())) {
            Ok(Ranked { first, left_out, .. }) => (first.iter().map(|one| one.teeth).collect(), left_out),
            Err(Error::NoArrangement { left_out, .. }) => (vec![], left_out),
            Err(error) => return Err(TestCaseError::fail(error.to_string())),
        };
        let (mut plain, mut shifted): (Vec<ArrangedTeeth>, Vec<ArrangedTeeth>) = found.iter().partition(|set| set.is_coaxial());
        plain.sort_unstable();
        shifted.sort_unstable();
        prop_assert_eq!(&shifted, &by_trial.shifted, "{:?}", bounds);
        let out = left_out.map_or(0, |left_out| left_out.count);
        prop_assert_eq!(
            plain.len() as u64 + out, by_trial.plain.len() as u64 + by_trial.left_out,
            "{:?} {:?} {:?}", bounds, found, by_trial.plain
        );
        if out == by_trial.left_out {
            prop_assert_eq!(plain, by_trial.plain);
        } else {
            prop_assert!(plain.iter().all(|set| by_trial.plain.contains(set)));
        }
    }

    /// Against the trial of every shift of one gear, step by step: large sun, long planet and ring.
    #[test]
    fn a_tree_has_shifts_where_some_have_no_fault(
        sun in 14..40_u32, planet in 14..40_u32, offset in -3..=3_i32, thick in 0.2..0.7_f64,
        aim in prop::sample::select(vec![Aim::BalancedSliding, Aim::LeastTipAlteration]),
    ) {
        let ring = (sun + 2 * planet).checked_add_signed(offset).unwrap();
        let gear = |kind, teeth| InvoluteGear::searched(kind, ToothCount::new(teeth).unwrap(), Profile::default()).unwrap();
        let gears = vec![
            gear(GearKind::External, sun), gear(GearKind::External, planet), gear(GearKind::Internal, ring),
        ];
        let distance = f64::from(sun + ring) / 4.0;
        let meshes = [[0, 1], [1, 2]].map(|gears| StatedDistance { gears, distance }).to_vec();
        let limits = Limits { tip_thickness: thick, ..Limits::default() };
        let tree = MeshTree::new(gears, meshes).unwrap();
        let is_free = |step: &i32| tree
            .at(f64::from(*step) * 0.02)
            .is_ok_and(|chosen| first_fault(&chosen.gears, &chosen.pairs, &limits).is_none());
        let by_trial = (-150..150).filter(is_free).count();
        match tree.choose(aim, &limits) {
            Ok(chosen) => prop_assert_eq!(first_fault(&chosen.gears, &chosen.pairs, &limits), None),
            // A stretch shorter than 1/64 of the range without undercut may be passed over.
            Err(error) => prop_assert!(by_trial <= 4, "{} steps of 300, {:?}", by_trial, error),
        }
    }
}
