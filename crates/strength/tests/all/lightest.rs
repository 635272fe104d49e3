//! The lightest gearbox against the size of every one.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use crate::common::{conveyor, helical, helix_angles, mm, with_pairs};
use epicyclic_gears::ToothCount;
use epicyclic_strength::lightest::{Costed, Gearbox, LoadedSet, Wanted, lightest};
use epicyclic_strength::sizing::bearing::listed_rollers;
use epicyclic_strength::sizing::{Objective, SetOverload, SetStep, SetTeeth, Sizing, Space, size};
use proptest::prelude::*;
use std::ops::ControlFlow;
use uom::si::angular_velocity::revolution_per_minute;
use uom::si::f64::{AngularVelocity, Time, Torque};
use uom::si::mass::kilogram;
use uom::si::{time::hour, torque::newton_meter};

/// A set with a small space of sizes.
fn of_set(objective: Objective) -> Sizing {
    let own = conveyor().of_stage;
    let space = Space {
        modules: [1.5, 2.5, 4.0].map(mm).to_vec(),
        face_widths: [20.0, 35.0, 50.0, 80.0, 120.0, 180.0, 260.0].map(mm).to_vec(),
        centre_distance_step: mm(1.0),
        largest_ring: None,
        bearings: with_pairs(listed_rollers().iter().step_by(3)).into(),
        ..own.space.clone()
    };
    Sizing { objective, space, life: Time::new::<hour>(5000.0), ..own }
}

/// Sets and loads of a gearbox: numbers of teeth, torque in N·m and speed of the sun in rpm, both over those
/// of the order.
type Drawn = (usize, Vec<([u32; 3], f64, f64)>);

fn drawn() -> impl Strategy<Value = Drawn> {
    let set = (18_u32..30, 24_u32..40, prop_oneof![Just(1.0), 0.9..1.1], prop_oneof![Just(1.0), 0.9..1.1]);
    // Teeth of a few kinds, so that gearboxes share sets.
    let set = set.prop_map(|(sun, planet, torque, speed)| {
        let [sun, planet] = [sun / 3 * 3, planet / 6 * 6];
        ([sun, planet, sun + 2 * planet], torque, speed)
    });
    (0_usize..3, prop::collection::vec(set, 2)).prop_map(|(group, sets)| {
        let count = if group == 0 { 1 } else { 2 };
        (group, sets.into_iter().take(count).collect())
    })
}

fn gearbox((group, sets): &Drawn, torque: f64) -> Gearbox {
    let set = |(place, (teeth, of_torque, of_speed)): (usize, &([u32; 3], f64, f64))| {
        let scale = [1.0, -2.5][place];
        let torque = Torque::new::<newton_meter>(torque * of_torque * scale);
        let speed = |rpm: f64| AngularVelocity::new::<revolution_per_minute>(rpm * of_speed);
        let step = |share: f64, part: f64, [sun, carrier]: [f64; 2]| SetStep {
            share,
            sun_torque: torque * part,
            sun_speed: speed(sun),
            carrier_speed: speed(carrier),
        };
        let overload = SetOverload { sun_torque: torque * 1.5, required_contact: 1.0, required_root: 1.2 };
        LoadedSet {
            teeth: SetTeeth::Simple(teeth.map(|teeth| ToothCount::new(teeth).unwrap())),
            duty: vec![step(0.6, 1.0, [900.0, 200.0]), step(0.4, 0.3, [0.0, 700.0])],
            overloads: vec![overload],
        }
    };
    let rules_missed = u32::from(*group == 1);
    let others_kg = 3.0 * sets.len() as f64;
    Gearbox { group: *group, sets: sets.iter().enumerate().map(set).collect(), rules_missed, others_kg }
}

/// Sets beyond usual practice, price and whole mass of a gearbox by the size of each of its sets.
fn by_trial(of_set: &Sizing, gearbox: &Gearbox) -> Option<[f64; 3]> {
    let mut sum = [0.0, 0.0, gearbox.others_kg];
    for LoadedSet { teeth, duty, overloads } in &gearbox.sets {
        let (duty, overloads) = (duty.clone(), overloads.clone());
        let sizing = Sizing { teeth: *teeth, duty, overloads, ..of_set.clone() };
        let found = size(&sizing, 1, &|| ControlFlow::Continue(())).ok()?;
        let best = found.found.first()?;
        let whole = of_set.objective == Objective::Whole;
        let mass = best.mass + if whole { best.structure } else { uom::si::f64::Mass::default() };
        let missed = best.rules_missed;
        let price = 1.25_f64.powi(i32::try_from(missed).unwrap()) * mass.get::<kilogram>();
        let mass_with_structure = (best.mass + best.structure).get::<kilogram>();
        sum = [sum[0] + f64::from(missed.min(1)), sum[1] + price, sum[2] + mass_with_structure];
    }
    let missed = gearbox.rules_missed;
    let price = 1.25_f64.powi(i32::try_from(missed).unwrap()) * sum[1];
    Some([sum[0] + f64::from(missed.min(1)), price, sum[2]])
}

/// Compares the best two gearboxes, and those of other groups, with every trial.
fn agrees(of_set: &Sizing, all: &[Drawn], torque: f64) -> Result<(), TestCaseError> {
    let gearboxes: Vec<Gearbox> = all.iter().map(|one| gearbox(one, torque)).collect();
    let go_on = || ControlFlow::Continue(());
    let search = |whole_kg| lightest(of_set, &gearboxes, Wanted { most: 2, whole_kg }, &go_on).unwrap();
    let found = search(None);
    prop_assert!(found.is_complete);
    let all = gearboxes.iter().enumerate();
    let tried = all.filter_map(|(place, gearbox)| Some((place, by_trial(of_set, gearbox)?)));
    let mut tried: Vec<(usize, [f64; 3])> = tried.collect();
    tried.sort_by(|(_, one), (_, other)| one[0].total_cmp(&other[0]).then(one[1].total_cmp(&other[1])));
    let is_of = |one: &Costed, [unusual, price, whole]: [f64; 3]| {
        f64::from(one.unusual) == unusual
            && (one.price_kg / price - 1.0).abs() < 1e-9
            && (one.whole_kg / whole - 1.0).abs() < 1e-9
    };
    prop_assert_eq!(found.best.len(), tried.len().min(2));
    for (best, (_, cost)) in found.best.iter().zip(&tried) {
        prop_assert!(is_of(best, *cost), "{:?} for {:?}", best, cost);
    }
    // The best of the groups that are left.
    let group = |place: usize| gearboxes[place].group;
    let is_seen = |place: usize| found.best.iter().any(|best| group(best.place) == group(place));
    for other in &found.of_other_groups {
        prop_assert!(!is_seen(other.place));
        let cost = tried.iter().find(|(place, _)| group(*place) == group(other.place)).unwrap().1;
        prop_assert!(is_of(other, cost), "{:?} for {:?}", other, cost);
    }
    // With every limit of the mass the best are those within it.
    let masses = tried.iter().map(|(_, [.., whole])| *whole);
    for most in masses.clone().flat_map(|mass| [mass, 0.999 * mass]) {
        let within: Vec<_> = tried.iter().filter(|(_, [.., whole])| *whole <= most * (1.0 + 1e-9)).collect();
        let found = search(Some(most));
        prop_assert!(found.is_complete && found.best.len() == within.len().min(2), "{} {:?}", most, found);
        for (best, (_, cost)) in found.best.iter().zip(within) {
            prop_assert!(is_of(best, *cost), "{:?} for {:?}", best, cost);
        }
        let above = found.above.map_or(f64::INFINITY, |above| above.whole_kg);
        let least = masses.clone().filter(|mass| *mass > most).reduce(f64::min).unwrap_or(f64::INFINITY);
        prop_assert!(above > most && above >= least * (1.0 - 1e-9), "{} {}", above, least);
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, ..ProptestConfig::default() })]

    #[test]
    fn the_best_gearboxes_are_those_of_every_trial(
        all in prop::collection::vec(drawn(), 1..8),
        torque in 5.0..150.0,
        whole in any::<bool>(),
        helix in helix_angles(),
    ) {
        let of_set = of_set(if whole { Objective::Whole } else { Objective::Mass });
        agrees(&helical(of_set, helix), &all, torque)?;
    }
}

/// Planets are largest at a centre distance that no trial has, flanks gain from the overlap of a wider face,
/// and widths count over the transverse diameter: beyond practice either of the first two decides, else the
/// last.
#[test]
fn bounds_of_helical_sets_lie_below_their_costs() {
    for (torque, objective, helix, other, beyond) in [
        (5.0, Objective::Mass, 23.722479, [24, 24, 72], true),
        (146.701798, Objective::Whole, 4.740688, [24, 24, 72], true),
        (62.688972, Objective::Mass, 25.223213, [27, 36, 99], false),
    ] {
        let sets = [[18, 24, 66], other].map(|teeth| (teeth, 1.0, 1.0));
        let of_set = helical(of_set(objective), helix);
        let practice = of_set.practice.clone().filter(|_| !beyond);
        agrees(&Sizing { practice, ..of_set }, &[(1, sets.to_vec())], torque).unwrap();
    }
}
