//! Stages in series against the trial of every train.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use crate::common::{conveyor, helical, helix_angles, mm, with_pairs};
use epicyclic_gears::ToothCount;
use epicyclic_strength::factor::Given;
use epicyclic_strength::mesh::Method;
use epicyclic_strength::series::{FirstPair, InputStep, KnownSets, Order, Teeth, Train, search};
use epicyclic_strength::sizing::bearing::{listed_plain, listed_rollers};
use epicyclic_strength::sizing::{Objective, SetOverload, SetStep, SetTeeth, Sizing, Space, size};
use proptest::prelude::*;
use std::ops::ControlFlow;
use uom::si::f64::{Mass, Time, Torque};
use uom::si::length::meter;
use uom::si::mass::kilogram;
use uom::si::{time::hour, torque::newton_meter};

/// Cost of a stage by its size alone, for loads written once more.
fn alone(order: &Order, teeth: SetTeeth, [before, product]: [f64; 2]) -> Option<[f64; 2]> {
    // Speeds over that of the input by Willis: the rings stand still, or turn as the output against it.
    let ring = if order.rings_turn { -1.0 / (product - 1.0) } else { 0.0 };
    let sun = ring + (1.0 - ring) / before;
    let (carrier, of_stage) = match (teeth, &order.first_pair) {
        (SetTeeth::Pair(_), Some(pair)) => (0.0, &pair.of_pair),
        _ => {
            let k = teeth.ratio() - 1.0;
            ((sun + k * ring) / (1.0 + k), &order.of_stage)
        }
    };
    let step = |step: &InputStep| SetStep {
        share: step.share,
        sun_torque: step.torque * before,
        sun_speed: step.speed * (sun - carrier),
        carrier_speed: step.speed * carrier,
    };
    let overload = |one: &SetOverload| SetOverload { sun_torque: one.sun_torque * before, ..*one };
    let sizing = Sizing {
        teeth,
        duty: order.duty.iter().map(step).collect(),
        overloads: of_stage.overloads.iter().map(overload).collect(),
        ..of_stage.clone()
    };
    let found = size(&sizing, 1, &|| ControlFlow::Continue(())).ok()?;
    let best = found.found.first()?;
    let structure = if of_stage.objective == Objective::Whole { best.structure } else { Mass::default() };
    let missed = best.rules_missed;
    let price = 1.25_f64.powi(i32::try_from(missed).unwrap());
    let of_length = of_stage.space.length_price * best.length.get::<meter>();
    Some([f64::from(missed.min(1)), price * (best.mass + structure).get::<kilogram>() + of_length])
}

/// Cost of every train, the best first.
fn every_train(order: &Order, stages: usize) -> Vec<[f64; 2]> {
    let Teeth { suns, planets, rings, ring_offsets, ring_to_sun_ratio, is_hunting } = &order.teeth;
    let mut sets = vec![];
    for (sun, planet) in suns.clone().flat_map(|sun| planets.clone().map(move |planet| (sun, planet))) {
        for offset in ring_offsets.clone() {
            let ring = (sun + 2 * planet).checked_add_signed(offset).unwrap();
            let has_divisor = (2..=planet).any(|of| planet % of == 0 && (sun % of == 0 || ring % of == 0));
            if *is_hunting && has_divisor {
                continue;
            }
            if rings.contains(&ring) && ring_to_sun_ratio.contains(&(f64::from(ring) / f64::from(sun))) {
                sets.push(SetTeeth::Simple([sun, planet, ring].map(|teeth| ToothCount::new(teeth).unwrap())));
            }
        }
    }
    let pairs = order.first_pair.as_ref().map(|pair| {
        let teeth = pair.pinions.clone().flat_map(|one| pair.wheels.clone().map(move |other| [one, other]));
        let all = teeth.map(|teeth| SetTeeth::Pair(teeth.map(|teeth| ToothCount::new(teeth).unwrap())));
        let allowed = all.filter(|teeth| {
            let divisors = 2..=teeth.gears()[0].get();
            let is_common = |of: u32| teeth.gears().iter().all(|teeth| teeth.get() % of == 0);
            pair.ratio.contains(&teeth.ratio())
                && !(order.teeth.is_hunting && divisors.into_iter().any(is_common))
        });
        allowed.collect::<Vec<_>>()
    });
    let mut trains = vec![(1.0, vec![])];
    for place in 0..stages {
        let of_place = pairs.as_ref().filter(|_| place == 0).unwrap_or(&sets);
        let longer = |(ratio, train): (f64, Vec<SetTeeth>)| {
            let with = move |set: &SetTeeth| (ratio * set.ratio(), [&train[..], &[*set]].concat());
            of_place.iter().map(with).collect::<Vec<_>>()
        };
        trains = trains.into_iter().flat_map(longer).collect();
    }
    trains.retain(|(ratio, _)| order.ratio.contains(ratio));
    let cost = |(product, train): &(f64, Vec<SetTeeth>)| {
        let mut before = 1.0;
        let mut sum = [0.0, 0.0];
        for teeth in train {
            let [warnings, mass] = alone(order, *teeth, [before, *product])?;
            sum = [sum[0] + warnings, sum[1] + mass];
            before *= teeth.ratio();
        }
        Some(sum)
    };
    let mut all: Vec<_> = trains.iter().filter_map(cost).collect();
    all.sort_by(|one, other| one[0].total_cmp(&other[0]).then(one[1].total_cmp(&other[1])));
    all
}

fn agrees(order: &Order) -> Result<bool, TestCaseError> {
    let found = search(order, 1, &mut KnownSets::default(), &|| ControlFlow::Continue(())).unwrap();
    let mut is_any = false;
    for trains in &found.all {
        let tried = every_train(order, trains.stages);
        prop_assert!(trains.is_complete);
        let of_length = order.of_stage.space.length_price;
        let price = |train: &Train| train.price_kg + of_length * train.length_m;
        let best = trains.found.first().map(|train| [f64::from(train.unusual_stages), price(train)]);
        match (best, tried.first()) {
            (None, None) => {}
            (Some(best), Some(cost)) => {
                is_any = true;
                let is_same = best[0] == cost[0] && (best[1] / cost[1] - 1.0).abs() < 1e-9;
                prop_assert!(is_same, "{:?} for {:?}", best, tried.first());
            }
            (best, tried) => prop_assert!(false, "{:?} for {:?}", best, tried),
        }
    }
    Ok(is_any)
}

/// Modules in mm, with gaps between them, and numbers of planets.
fn sizes() -> impl Strategy<Value = (Vec<f64>, Vec<u32>)> {
    let modules = prop::sample::subsequence(vec![1.0, 1.25, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0], 2..=3);
    (modules, prop::sample::subsequence(vec![3, 4, 5], 1..=3))
}

/// A small space of trains, with torque in N·m and speed over the usual one.
fn small(
    (ratio, torque, suns): (f64, f64, u32),
    (modules, planets): (Vec<f64>, Vec<u32>),
    (faster, helix, whole): (f64, f64, bool),
) -> Order {
    let order = conveyor();
    let objective = if whole { Objective::Whole } else { Objective::Mass };
    // Plain bearings among the others, or alone.
    let rolling = with_pairs(listed_rollers().iter().step_by(3));
    let plain = || listed_plain().iter().step_by(4).cloned();
    let bearings = match suns % 4 {
        0 => rolling.into_iter().chain(plain()).collect(),
        1 => plain().collect(),
        _ => rolling,
    };
    let space = Space {
        modules: modules.into_iter().map(mm).collect(),
        planets,
        face_widths: [20.0, 35.0, 50.0, 80.0].map(mm).to_vec(),
        centre_distance_step: mm(1.0),
        largest_ring: None,
        bearings: bearings.into(),
        ..order.of_stage.space.clone()
    };
    let torque = Torque::new::<newton_meter>(torque);
    let step = InputStep { torque, speed: order.duty[0].speed * faster, ..order.duty[0] };
    let of_stage = Sizing { objective, space, life: Time::new::<hour>(5000.0), ..order.of_stage };
    Order {
        stages: 1..=2,
        ratio: ratio * 0.97..=ratio * 1.03,
        rings_turn: false,
        first_pair: None,
        teeth: Teeth {
            suns: suns..=suns + 4,
            planets: 27..=45,
            ring_offsets: -1..=0,
            is_hunting: suns.is_multiple_of(3),
            ..order.teeth
        },
        most_unusual: None,
        duty: vec![
            InputStep { share: 0.7, ..step },
            InputStep { share: 0.3, torque: step.torque * 0.5, ..step },
        ],
        of_stage: helical(of_stage, helix),
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 8, ..ProptestConfig::default() })]

    #[test]
    fn the_best_train_is_that_of_every_trial(
        ratio in prop_oneof![4.0..6.5, 18.0..32.0],
        torque in 5.0..150.0,
        faster in prop_oneof![Just(1.0), 1.0..6.0],
        suns in 18_u32..26,
        whole in any::<bool>(),
        rings_turn in any::<bool>(),
        helix in helix_angles(),
        sizes in sizes(),
        length_price in prop_oneof![Just(0.0), 10.0..3000.0],
    ) {
        let mut order = small((ratio, torque, suns), sizes, (faster, helix, whole));
        order.of_stage.space.length_price = length_price;
        agrees(&Order { rings_turn, ..order })?;
    }
}

/// Rings turn as the output of their own train. With the middle of the allowed ratios the planets of the best
/// train would be beyond their usual acceleration, and a train of 16.39 kg would be found.
#[test]
fn speeds_of_turning_rings_are_those_of_the_ratio_of_the_train() {
    let order = small((27.324, 108.344, 23), (vec![2.5, 4.0], vec![4]), (5.17495, 1.0, false));
    let order = Order { rings_turn: true, ..order };
    assert!(agrees(&order).unwrap());
    let found = search(&order, 1, &mut KnownSets::default(), &|| ControlFlow::Continue(())).unwrap();
    let best = &found.all[1].found[0];
    assert!((best.mass_kg - 16.073).abs() < 1e-3 && best.rules_missed == 0, "{best:?}");
}

/// The order with a pair as the first stage, whose mesh shares no load.
fn behind_a_pair(order: Order, pinions: u32) -> Order {
    let given = Given::load_factors([1.5, 1.0, 1.1, 1.25, 1.0]);
    let space = Space { planets: vec![1], bearings: [].into(), ..order.of_stage.space.clone() };
    let methods = [Method { given, ..Method::default() }; 2];
    let of_pair = Sizing { methods, space, ..order.of_stage.clone() };
    let first_pair = FirstPair { pinions: pinions..=pinions + 2, wheels: 30..=80, ratio: 1.5..=3.5, of_pair };
    Order { first_pair: Some(first_pair), ..order }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 8, ..ProptestConfig::default() })]

    #[test]
    fn the_best_train_behind_a_pair_is_that_of_every_trial(
        ratio in prop_oneof![1.5..3.5, 9.0..14.0],
        torque in 5.0..150.0,
        faster in prop_oneof![Just(1.0), 1.0..6.0],
        suns in 18_u32..26,
        pinions in 17_u32..24,
        whole in any::<bool>(),
        helix in helix_angles(),
        sizes in sizes(),
    ) {
        let order = small((ratio, torque, suns), sizes, (faster, helix, whole));
        agrees(&behind_a_pair(order, pinions))?;
    }
}

/// A price of the length gives the lightest of all trains that are as short, and no train is lighter within a
/// length than the bound that it gives.
#[test]
fn the_price_of_the_length_shortens_trains() {
    let of = |length_price: f64| {
        let mut order = conveyor();
        order.of_stage.space.length_price = length_price;
        search(&order, 1, &mut KnownSets::default(), &|| ControlFlow::Continue(())).unwrap().all[0].found[0]
            .clone()
    };
    let free = of(0.0);
    let dear = [200.0, 1000.0, 5000.0].map(|price| (price, of(price)));
    for (price, train) in &dear {
        assert!(train.length_m <= free.length_m && train.price_kg >= free.price_kg, "{price}: {train:?}");
        // Of each other train, too, the cost at this price is no less.
        for (_, other) in &dear {
            let cost = |of: &Train| (of.unusual_stages, of.price_kg + price * of.length_m);
            assert!(
                cost(train).0 <= cost(other).0 && cost(train).1 <= cost(other).1 * (1.0 + 1e-9),
                "{price}"
            );
        }
    }
    assert!(dear[2].1.length_m < 0.95 * free.length_m, "{dear:?} {free:?}");
}

/// The order of a conveyor gets the split that engineers give it.
#[test]
fn a_conveyor_has_two_stages_of_usual_split() {
    let found = search(&conveyor(), 1, &mut KnownSets::default(), &|| ControlFlow::Continue(())).unwrap();
    let train = &found.all[0].found[0];
    let ratios: Vec<f64> = train.stages.iter().map(SetTeeth::ratio).collect();
    assert!((5.5..7.2).contains(&ratios[0]) && (4.4..5.6).contains(&ratios[1]), "{ratios:?}");
    assert!(train.rules_missed <= 1 && found.all[0].is_complete, "{train:?}");
}
