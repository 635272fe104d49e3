//! The size of a three-speed gearbox of two sets, whose loads do not depend on it; the lightest of many such
//! gearboxes by bounds, and by the size of each.

use criterion::{Criterion, criterion_group, criterion_main};
use epicyclic_gears::ToothCount;
use epicyclic_gears::involute::Profile;
use epicyclic_gears::involute::family::Aim;
use epicyclic_gears::involute::profile::{Cutting, Profiles};
use epicyclic_gears::involute::set::Limits;
use epicyclic_gears::involute::tool::{Shaper as GearShaper, Tool};
use epicyclic_strength::factor::{Given, Symbol};
use epicyclic_strength::lightest::{Gearbox, LoadedSet, Wanted, lightest};
use epicyclic_strength::material;
use epicyclic_strength::mesh::{Gear, Method};
use epicyclic_strength::root::{factors::Bending, section::Shaper};
use epicyclic_strength::sizing::bearing::listed;
use epicyclic_strength::sizing::{
    Objective, Pin, STANDARD_MODULES_MM, SetStep, SetTeeth, Sizing, Space, size,
};
use std::hint::black_box;
use std::ops::ControlFlow;
use uom::si::angular_velocity::revolution_per_minute;
use uom::si::f64::{AngularVelocity, KinematicViscosity, Length, Mass, Time, Torque};
use uom::si::kinematic_viscosity::square_millimeter_per_second;
use uom::si::length::{micrometer, millimeter};
use uom::si::mass::kilogram;
use uom::si::{time::hour, torque::newton_meter};

/// A shaper of 30 teeth with rounded tips of 0.3.
fn shaped() -> Cutting {
    let shaper = GearShaper::of_teeth(ToothCount::new(30).expect("teeth"));
    Cutting { fillet: Some(0.3), tool: Some(Tool::Shaper(shaper)), ..Cutting::default() }
}

fn set(teeth: [u32; 3], steps: [[f64; 4]; 3]) -> Sizing {
    let gear = |designation, bending, shaper| Gear {
        material: material::listed(designation).expect("listed").material,
        flank_roughness: Length::new::<micrometer>(4.0),
        root_roughness: Length::new::<micrometer>(16.0),
        rim: None,
        shaper,
        bending,
    };
    let rpm = AngularVelocity::new::<revolution_per_minute>;
    let given = Given::load_factors([1.25, 1.0, 1.05, 1.2, 1.0]);
    let methods = [given, given.with(Symbol::StaticNotchSensitivity, 1.0)];
    let mm = |value: f64| Length::new::<millimeter>(value);
    Sizing {
        teeth: SetTeeth::Simple(teeth.map(|count| ToothCount::new(count).expect("teeth"))),
        profiles: Profiles::cut(Profile::default(), [Cutting::default(), Cutting::default(), shaped()]),
        aim: Aim::BalancedSliding,
        held_shifts: None,
        limits: Limits::default(),
        gears: [
            gear("18CrNiMo7-6", Bending::OneWay, None),
            gear("18CrNiMo7-6", Bending::Reversed, None),
            gear("34CrNiMo6", Bending::OneWay, Some(Shaper { teeth: 30, shift: 0.0 })),
        ],
        methods: methods.map(|given| Method { given, ..Method::default() }),
        viscosity: KinematicViscosity::new::<square_millimeter_per_second>(220.0),
        duty: steps
            .map(|[share, torque, relative, carrier]| SetStep {
                share,
                sun_torque: Torque::new::<newton_meter>(torque),
                sun_speed: rpm(relative),
                carrier_speed: rpm(carrier),
            })
            .to_vec(),
        overloads: vec![],
        life: Time::new::<hour>(10_000.0),
        required_contact: 1.1,
        working_viscosity: None,
        required_root: 1.4,
        planet_rim: 3.0,
        ring_rim: 3.5,
        planet_bore: None,
        planet_mass: None,
        widens_face_load: false,
        planet_pin: Pin::default(),
        least_planet_angle: None,
        objective: Objective::Mass,
        practice: None,
        space: Space {
            modules: STANDARD_MODULES_MM[..11].iter().map(|module| mm(*module)).collect(),
            face_widths: (2..=16).map(|width| mm(5.0 * f64::from(width))).collect(),
            planets: vec![3, 4, 5, 6],
            centre_distance_step: mm(0.5),
            reach: 1.0,
            width_ratio: Some(1.2),
            largest_ring: None,
            length_price: 0.0,
            bearings: listed().into(),
        },
    }
}

fn sizing(c: &mut Criterion) {
    // Two sets, 24/30/84 and 30/24/78; in the third gear both turn as a block.
    let sets = [
        set([24, 30, 84], [[0.3, 500.0, 1200.0, 330.0], [0.4, 320.0, 600.0, 900.0], [0.3, 0.0, 0.0, 1500.0]]),
        set([30, 24, 78], [[0.3, 0.0, 0.0, 330.0], [0.4, 900.0, 800.0, 400.0], [0.3, 0.0, 0.0, 1500.0]]),
    ];
    let mut group = c.benchmark_group("sizing");
    group.sample_size(10);
    for set in &sets {
        let found = size(set, 5, &|| ControlFlow::Continue(())).expect("a search");
        assert_eq!(found.found.len(), 5);
        println!(
            "{} designs of {} centre distances, {} rated, {} left out",
            found.space,
            found.geometries,
            found.rated,
            found.left_out.total()
        );
    }
    group.bench_function("three_speeds", |b| {
        b.iter(|| sets.each_ref().map(|set| size(black_box(set), 5, &|| ControlFlow::Continue(()))));
    });
    group.finish();
}

/// Gearboxes of two sets, of four tooth numbers each.
fn lightest_of_many(c: &mut Criterion) {
    let firsts = [[24, 30, 84], [27, 33, 93], [21, 27, 75], [30, 36, 102]];
    let seconds = [[30, 24, 78], [33, 27, 87], [36, 30, 96], [27, 21, 69]];
    let loaded = |teeth, steps| {
        let Sizing { teeth, duty, overloads, .. } = set(teeth, steps);
        LoadedSet { teeth, duty, overloads }
    };
    let pairs = firsts.iter().flat_map(|first| seconds.iter().map(move |second| (*first, *second)));
    let gearbox = |(first, second)| Gearbox {
        group: 0,
        sets: vec![
            loaded(first, [[0.3, 500.0, 1200.0, 330.0], [0.4, 320.0, 600.0, 900.0], [0.3, 0.0, 0.0, 1500.0]]),
            loaded(second, [[0.3, 0.0, 0.0, 330.0], [0.4, 900.0, 800.0, 400.0], [0.3, 0.0, 0.0, 1500.0]]),
        ],
        rules_missed: 0,
        others_kg: 0.0,
    };
    let gearboxes: Vec<Gearbox> = pairs.map(gearbox).collect();
    let mut of_set = set(firsts[0], [[0.0; 4]; 3]);
    of_set.space.modules.truncate(8);
    let go_on = || ControlFlow::Continue(());
    let by_bounds = || {
        lightest(&of_set, black_box(&gearboxes), Wanted { most: 1, whole_kg: None }, &go_on)
            .expect("a search")
    };
    let one_by_one = || {
        let mass = |set: &LoadedSet| {
            let LoadedSet { teeth, duty, overloads } = set.clone();
            let sizing = Sizing { teeth, duty, overloads, ..of_set.clone() };
            let found = size(&sizing, 1, &go_on).expect("a search").found;
            // Some sets have no size that holds.
            found.first().map_or(Mass::new::<kilogram>(f64::INFINITY), |best| best.mass)
        };
        let masses = black_box(&gearboxes).iter().map(|one| one.sets.iter().map(mass).sum::<Mass>());
        masses.fold(Mass::new::<kilogram>(f64::INFINITY), Mass::min)
    };
    let best = by_bounds().best[0].mass_kg;
    assert!((best / one_by_one().get::<kilogram>() - 1.0).abs() < 1e-9);
    let mut group = c.benchmark_group("lightest");
    group.sample_size(10);
    group.bench_function("by_bounds", |b| b.iter(by_bounds));
    group.bench_function("one_by_one", |b| b.iter(one_by_one));
    group.finish();
}

criterion_group!(benches, sizing, lightest_of_many);
criterion_main!(benches);
