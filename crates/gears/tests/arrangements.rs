//! Searches for arrangements of gears, held against the trial of every combination.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

#[path = "common/trial.rs"]
mod trial;

use epicyclic_gears::Error;
use epicyclic_gears::arrangement::{ArrangedCandidate, ArrangedTeeth, Arrangement, ArrangementBounds};
use epicyclic_gears::synthesis::{Bounds, Placement, Ranked};
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

#[test]
fn shifts_of_the_central_gears_close_a_planet() {
    let bounds = ArrangementBounds { offsets: -2..=2, ..usual(Arrangement::Wolfrom) };
    let found = for_ratio(&bounds, 100.0, "ae^b", 0.001).unwrap();
    let one_step = found.first.iter().filter(|set| set.teeth.has_one_step()).count();
    assert!(one_step > 0);
    for set in &found.first {
        let shifts = set.teeth.profile_shifts(&bounds.rack).unwrap();
        assert_eq!((shifts[1], shifts[3]), (0.0, 0.0));
        assert_eq!(shifts.iter().all(|shift| *shift == 0.0), set.teeth.is_coaxial());
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
        let mut by_trial = arranged_by_trial(&bounds, wanted, mode, tolerance);
        by_trial.sort_unstable();
        let (mut found, left_out) = match bounds.for_ratio(wanted, mode, tolerance, usize::MAX, |_| ControlFlow::Continue(())) {
            Ok(Ranked { first, left_out, .. }) => (first.iter().map(|one| one.teeth).collect(), left_out),
            Err(Error::NoArrangement { left_out, .. }) => (vec![], left_out),
            Err(error) => return Err(TestCaseError::fail(error.to_string())),
        };
        found.sort_unstable();
        let out = left_out.map_or(0, |left_out| left_out.count);
        prop_assert_eq!(found.len() as u64 + out, by_trial.len() as u64, "{:?} {:?} {:?}", bounds, found, by_trial);
        if out == 0 {
            prop_assert_eq!(found, by_trial);
        } else {
            prop_assert!(found.iter().all(|set| by_trial.contains(set)));
        }
    }
}
