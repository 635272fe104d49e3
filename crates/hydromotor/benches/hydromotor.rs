//! A closed motor from its numbers and a distance, with displacement and ripple; its tooth profiles.

use criterion::{Criterion, criterion_group, criterion_main};
use epicyclic_hydromotor::centrode::Wheel;
use epicyclic_hydromotor::closure::Family;
use epicyclic_hydromotor::profile::limits::Limit;
use epicyclic_hydromotor::profile::{Profile, ToothForm};
use epicyclic_hydromotor::{Motor, MotorNumbers};
use std::hint::black_box;
use uom::si::area::square_millimeter;
use uom::si::f64::Length;
use uom::si::length::millimeter;

fn closed_motor(c: &mut Criterion) {
    let mm = Length::new::<millimeter>;
    let numbers = MotorNumbers::new(5, 3, 55, 10).expect("admissible");
    let working = |l: Length| {
        let motor = Motor::of_two_arcs(numbers, mm(1.0), l).expect("within the family");
        (motor.displacement_per_width().get::<square_millimeter>(), motor.ripple().delta)
    };
    let (displacement, delta) = working(mm(40.0));
    assert!((displacement - 1412.9151).abs() < 5e-5 && (delta - 0.0764).abs() < 5e-5);
    c.bench_function("hydromotor/closed_motor", |b| b.iter(|| working(black_box(mm(40.0)))));
    c.bench_function("hydromotor/family", |b| b.iter(|| Family::new(black_box(numbers), mm(1.0))));
}

fn profiles(c: &mut Criterion) {
    let mm = Length::new::<millimeter>;
    let of = |n: (u32, u32, u32, u32)| {
        let numbers = MotorNumbers::new(n.0, n.1, n.2, n.3).expect("admissible");
        Motor::of_two_arcs(numbers, mm(1.0), mm(40.0)).expect("within the family")
    };
    // 10⁵ points, evenly among the teeth of all wheels.
    let outlines = |motor: &Motor| {
        let profile = Profile::new(motor, ToothForm::default()).expect("within the limits");
        let numbers = motor.numbers();
        let wheels = [
            (Wheel::Stator, numbers.stator_teeth()),
            (Wheel::Rotor, numbers.rotor_teeth()),
            (Wheel::Satellite, numbers.satellite_teeth()),
        ];
        let a_tooth = 100_000_u32.div_ceil(wheels.iter().map(|(_, teeth)| teeth).sum());
        wheels.map(|(wheel, teeth)| profile.outline(wheel, a_tooth * teeth).expect("in range"))
    };
    for (name, numbers) in [("5x3", (5, 3, 55, 10)), ("6x4", (6, 4, 66, 10))] {
        let motor = of(numbers);
        assert!(outlines(&motor).iter().map(|outline| outline.points.len()).sum::<usize>() >= 100_000);
        c.bench_function(&format!("hydromotor/profile/outlines_1e5/{name}"), |b| {
            b.iter(|| outlines(black_box(&motor)));
        });
    }
    let cosine = Motor::of_cosine_law(MotorNumbers::new(8, 6, 88, 10).expect("admissible"), mm(1.0));
    let cosine = cosine.expect("closes");
    c.bench_function("hydromotor/profile/outlines_1e5/cosine_8x6", |b| {
        b.iter(|| outlines(black_box(&cosine)));
    });
    let motor = of((5, 3, 55, 10));
    let profile = Profile::new(&motor, ToothForm::default()).expect("within the limits");
    assert!(profile.limits().iter().all(Limit::holds));
    c.bench_function("hydromotor/profile/limits", |b| b.iter(|| black_box(&profile).limits()));
    assert!(profile.clearances(120).expect("in range").free());
    let mut slow = c.benchmark_group("hydromotor/profile");
    slow.sample_size(10);
    slow.bench_function("clearances_120", |b| b.iter(|| black_box(&profile).clearances(120)));
    slow.finish();
}

criterion_group!(benches, closed_motor, profiles);
criterion_main!(benches);
