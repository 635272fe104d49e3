//! A closed motor from its numbers and a distance, with displacement and ripple.

use criterion::{Criterion, criterion_group, criterion_main};
use epicyclic_hydromotor::closure::Family;
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

criterion_group!(benches, closed_motor);
criterion_main!(benches);
