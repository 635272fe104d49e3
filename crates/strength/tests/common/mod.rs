//! A drive of a belt conveyor as an order for trains.

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
use epicyclic_strength::series::{InputStep, Order, Teeth};
use epicyclic_strength::sizing::bearing::{Bearing, listed_rollers};
use epicyclic_strength::sizing::{Objective, Pin, STANDARD_MODULES_MM, SetTeeth, Sizing, Space};
use proptest::prelude::*;
use uom::si::angle::degree;
use uom::si::angular_velocity::revolution_per_minute;
use uom::si::f64::{Angle, AngularVelocity, KinematicViscosity, Length, Time, Torque};
use uom::si::kinematic_viscosity::square_millimeter_per_second;
use uom::si::length::{micrometer, millimeter};
use uom::si::{time::hour, torque::newton_meter};

pub(crate) fn mm(value: f64) -> Length {
    Length::new::<millimeter>(value)
}

/// The set with helical teeth of an angle in degrees.
pub(crate) fn helical(mut of_set: Sizing, degrees: f64) -> Sizing {
    for profile in &mut of_set.profiles.0 {
        profile.helix_angle = Angle::new::<degree>(degrees);
    }
    of_set
}

/// Bearings alone and as pairs, which helical teeth need.
pub(crate) fn with_pairs<'a>(all: impl IntoIterator<Item = &'a Bearing> + Clone) -> Vec<Bearing> {
    all.clone().into_iter().cloned().chain(all.into_iter().map(Bearing::pair)).collect()
}

/// Helix angles in degrees; those of a few degrees have little overlap.
pub(crate) fn helix_angles() -> impl Strategy<Value = f64> {
    prop_oneof![Just(0.0), 1.0..8.0, 8.0..30.0]
}

/// A drive of a belt conveyor: 90 kW at 1485 rpm, 1:31.6 within 3 %.
pub(crate) fn conveyor() -> Order {
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
        teeth: SetTeeth::Simple([24, 30, 84].map(|teeth| ToothCount::new(teeth).unwrap())),
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
        working_viscosity: None,
        required_root: 1.5,
        planet_rim: 3.0,
        ring_rim: 3.5,
        planet_bore: None,
        planet_mass: None,
        widens_face_load: true,
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
            length_price: 0.0,
            bearings: with_pairs(listed_rollers()).into(),
        },
    };
    Order {
        stages: 2..=2,
        ratio: 31.6 * 0.97..=31.6 * 1.03,
        rings_turn: false,
        teeth: Teeth {
            suns: 16..=30,
            planets: 16..=60,
            rings: 50..=150,
            ring_offsets: 0..=0,
            ring_to_sun_ratio: 2.0..=9.0,
            is_hunting: false,
        },
        first_pair: None,
        most_unusual: None,
        duty: vec![InputStep {
            share: 1.0,
            torque: Torque::new::<newton_meter>(579.0),
            speed: AngularVelocity::new::<revolution_per_minute>(1485.0),
        }],
        of_stage,
    }
}
