//! The complete enumeration of tooth numbers, beside the trial of every combination.

use criterion::{Criterion, criterion_group, criterion_main};
use epicyclic_gears::simple_set::{Member, Mode};
use epicyclic_gears::synthesis::{Bounds, tooth_numbers_by_trial};
use std::hint::black_box;

fn synthesis(c: &mut Criterion) {
    let all = Bounds::default();
    assert_eq!(all.tooth_numbers().map(|sets| sets.len()), Ok(8016));
    c.bench_function("gears/synthesis/all_tooth_numbers", |b| b.iter(|| black_box(&all).tooth_numbers()));

    let mode = Mode::new(Member::Sun, Member::Carrier).expect("two members");
    c.bench_function("gears/synthesis/for_ratio", |b| {
        b.iter(|| black_box(&all).for_ratio(black_box(6.0), mode, 0.01));
    });

    // Trial of the whole space takes minutes; on a reduced one both are timed.
    let reduced = Bounds { sun: 12..=30, planet: 12..=30, ring: 36..=90, ..Bounds::default() };
    assert_eq!(reduced.tooth_numbers(), tooth_numbers_by_trial(&reduced));
    c.bench_function("gears/synthesis/reduced", |b| b.iter(|| black_box(&reduced).tooth_numbers()));
    c.bench_function("gears/synthesis/reduced/brute_force", |b| {
        b.iter(|| tooth_numbers_by_trial(black_box(&reduced)));
    });
}

criterion_group!(benches, synthesis);
criterion_main!(benches);
