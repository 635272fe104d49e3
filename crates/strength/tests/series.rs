//! Stages in series against the trial of every train.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use epicyclic_gears::ToothCount;
use epicyclic_gears::involute::Profile;
use epicyclic_gears::involute::family::Aim;
use epicyclic_gears::involute::profile::{Cutting, Profiles};
use epicyclic_gears::involute::set::Limits;
use epicyclic_gears::involute::tool::{Shaper as GearShaper, Tool};
use epicyclic_strength::factor::{Given, Symbol};
use epicyclic_strength::material;
use epicyclic_strength::mesh::{Gear, Method};
use epicyclic_strength::root::{factors::Bending, section::Shaper};
use epicyclic_strength::series::{InputStep, Order, Teeth, search};
use epicyclic_strength::sizing::bearing::listed_rollers;
use epicyclic_strength::sizing::{
    Objective, Pin, STANDARD_MODULES_MM, SetOverload, SetStep, Sizing, Space, size,
};
use proptest::prelude::*;
use std::ops::ControlFlow;
use uom::si::angular_velocity::revolution_per_minute;
use uom::si::f64::{AngularVelocity, KinematicViscosity, Length, Mass, Time, Torque};
use uom::si::kinematic_viscosity::square_millimeter_per_second;
use uom::si::length::{micrometer, millimeter};
use uom::si::mass::kilogram;
use uom::si::{time::hour, torque::newton_meter};

fn mm(value: f64) -> Length {
    Length::new::<millimeter>(value)
}

/// A drive of a belt conveyor: 90 kW at 1485 rpm, 1:31.6 within 3 %.
fn conveyor() -> Order {
    let gear = |designation, bending, shaper| Gear {
        material: material::listed(designation).unwrap().material,
        flank_roughness: Length::new::<micrometer>(4.0),
        root_roughness: Length::new::<micrometer>(16.0),
        rim: None,
        shaper,
        bending,
    };
    let shaper = GearShaper::of_teeth(ToothCount::new(20).unwrap());
    let shaped = Cutting { fillet: Some(0.3), tool: Some(Tool::Shaper(shaper)), ..Cutting::default() };
    let given = Given::load_factors([1.5, 1.25, 1.1, 1.25, 1.0]);
    let ring = given.with(Symbol::StaticNotchSensitivity, 1.0);
    let of_stage = Sizing {
        teeth: [24, 30, 84].map(|teeth| ToothCount::new(teeth).unwrap()),
        profiles: Profiles::cut(Profile::default(), [Cutting::default(), Cutting::default(), shaped]),
        aim: Aim::BalancedSliding,
        held_shifts: None,
        limits: Limits::default(),
        gears: [
            gear("18CrNiMo7-6", Bending::OneWay, None),
            gear("18CrNiMo7-6", Bending::Reversed, None),
            gear("34CrNiMo6", Bending::OneWay, Some(Shaper { teeth: 20, shift: 0.0 })),
        ],
        methods: [given, ring].map(|given| Method { given, ..Method::default() }),
        viscosity: KinematicViscosity::new::<square_millimeter_per_second>(220.0),
        duty: vec![],
        overloads: vec![],
        life: Time::new::<hour>(30_000.0),
        required_contact: 1.2,
        required_root: 1.5,
        planet_rim: 3.0,
        ring_rim: 3.5,
        planet_bore: None,
        planet_mass: None,
        planet_pin: Pin::default(),
        least_planet_angle: None,
        objective: Objective::Whole,
        practice: Some(epicyclic_judge::Limits::default()),
        space: Space {
            modules: STANDARD_MODULES_MM.iter().map(|module| mm(*module)).collect(),
            face_widths: (2..=32).map(|fives| mm(5.0 * f64::from(fives))).collect(),
            planets: vec![3, 4],
            centre_distance_step: mm(1.0),
            reach: 1.0,
            width_ratio: None,
            largest_ring: Some(mm(540.0)),
            bearings: listed_rollers()
                .iter()
                .cloned()
                .chain(listed_rollers().iter().map(epicyclic_strength::sizing::bearing::Bearing::pair))
                .collect(),
        },
    };
    Order {
        stages: 2..=2,
        ratio: 31.6 * 0.97..=31.6 * 1.03,
        teeth: Teeth {
            suns: 16..=30,
            planets: 16..=60,
            rings: 50..=150,
            ring_offsets: 0..=0,
            ring_to_sun_ratio: 2.0..=9.0,
            is_hunting: false,
        },
        duty: vec![InputStep {
            share: 1.0,
            torque: Torque::new::<newton_meter>(579.0),
            speed: AngularVelocity::new::<revolution_per_minute>(1485.0),
        }],
        of_stage,
    }
}

/// Cost of a stage by its size alone, for loads written once more.
fn alone(order: &Order, teeth: [ToothCount; 3], before: f64) -> Option<[f64; 2]> {
    let ratio = 1.0 + teeth[2].as_f64() / teeth[0].as_f64();
    let step = |step: &InputStep| SetStep {
        share: step.share,
        sun_torque: step.torque * before,
        sun_speed: step.speed * ((1.0 - 1.0 / ratio) / before),
        carrier_speed: step.speed / (before * ratio),
    };
    let overload = |one: &SetOverload| SetOverload { sun_torque: one.sun_torque * before, ..*one };
    let of_stage = &order.of_stage;
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
    Some([f64::from(missed.min(1)), price * (best.mass + structure).get::<kilogram>()])
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
                sets.push([sun, planet, ring].map(|teeth| ToothCount::new(teeth).unwrap()));
            }
        }
    }
    let of = |teeth: &[ToothCount; 3]| 1.0 + teeth[2].as_f64() / teeth[0].as_f64();
    let mut trains = vec![(1.0, vec![])];
    for _ in 0..stages {
        let longer = |(ratio, train): (f64, Vec<[ToothCount; 3]>)| {
            sets.iter().map(move |set| (ratio * of(set), [&train[..], &[*set]].concat())).collect::<Vec<_>>()
        };
        trains = trains.into_iter().flat_map(longer).collect();
    }
    trains.retain(|(ratio, _)| order.ratio.contains(ratio));
    let cost = |train: &[[ToothCount; 3]]| {
        let mut before = 1.0;
        let mut sum = [0.0, 0.0];
        for teeth in train {
            let [warnings, mass] = alone(order, *teeth, before)?;
            sum = [sum[0] + warnings, sum[1] + mass];
            before *= of(teeth);
        }
        Some(sum)
    };
    let mut all: Vec<_> = trains.iter().filter_map(|(_, train)| cost(train)).collect();
    all.sort_by(|one, other| one[0].total_cmp(&other[0]).then(one[1].total_cmp(&other[1])));
    all
}

fn agrees(order: &Order) -> Result<bool, TestCaseError> {
    let found = search(order, 1, &|| ControlFlow::Continue(())).unwrap();
    let mut is_any = false;
    for trains in &found.all {
        let tried = every_train(order, trains.stages);
        prop_assert!(trains.is_complete);
        let best = trains.found.first().map(|train| [f64::from(train.unusual_stages), train.price_kg]);
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

/// A small space of trains, with torque in N·m.
fn small(ratio: f64, torque: f64, suns: u32, objective: Objective) -> Order {
    let order = conveyor();
    let bearings = listed_rollers().iter().step_by(3).cloned().collect();
    let space = Space {
        modules: [1.5, 2.5, 4.0].map(mm).to_vec(),
        face_widths: [20.0, 35.0, 50.0, 80.0].map(mm).to_vec(),
        centre_distance_step: mm(1.0),
        largest_ring: None,
        bearings,
        ..order.of_stage.space.clone()
    };
    let step = InputStep { torque: Torque::new::<newton_meter>(torque), ..order.duty[0] };
    Order {
        stages: 1..=2,
        ratio: ratio * 0.97..=ratio * 1.03,
        teeth: Teeth {
            suns: suns..=suns + 4,
            planets: 27..=45,
            ring_offsets: -1..=0,
            is_hunting: suns.is_multiple_of(3),
            ..order.teeth
        },
        duty: vec![
            InputStep { share: 0.7, ..step },
            InputStep { share: 0.3, torque: step.torque * 0.5, ..step },
        ],
        of_stage: Sizing { objective, space, life: Time::new::<hour>(5000.0), ..order.of_stage },
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 8, ..ProptestConfig::default() })]

    #[test]
    fn the_best_train_is_that_of_every_trial(
        ratio in prop_oneof![4.0..6.5, 18.0..32.0],
        torque in 5.0..150.0,
        suns in 18_u32..26,
        whole in any::<bool>(),
    ) {
        agrees(&small(ratio, torque, suns, if whole { Objective::Whole } else { Objective::Mass }))?;
    }
}

/// The order of a conveyor gets the split that engineers give it.
#[test]
fn a_conveyor_has_two_stages_of_usual_split() {
    let found = search(&conveyor(), 1, &|| ControlFlow::Continue(())).unwrap();
    let train = &found.all[0].found[0];
    let ratios: Vec<f64> =
        train.stages.iter().map(|[sun, _, ring]| 1.0 + ring.as_f64() / sun.as_f64()).collect();
    assert!((5.5..7.2).contains(&ratios[0]) && (4.4..5.6).contains(&ratios[1]), "{ratios:?}");
    assert!(train.rules_missed <= 1 && found.all[0].is_complete, "{train:?}");
}
