//! Three speeds 0.76, 1.33, 1.95 of an excavator wheel: choice of the structure, and of the teeth over all
//! structures.
//!
//! Both orders and signs of the ratios, tolerance 10 %, default limits. Brute force over teeth on a reduced
//! space is measured for comparison.
//!
//! The whole space is `Counts::designs`; brute force takes the same time for each of its designs, so its
//! time over the whole is extrapolated by count.

use criterion::{Criterion, criterion_group, criterion_main};
use epicyclic_gears::synthesis::Bounds;
use epicyclic_schemes::RatioSeries;
use epicyclic_schemes::structures::Structure;
use epicyclic_selection::search::ToothSearch;
use epicyclic_selection::{Requirements, Space, select};
use std::hint::black_box;

#[path = "../tests/brute_common/mod.rs"]
mod brute;

fn excavator() -> Requirements {
    Requirements::new(RatioSeries::of_braked_gears(&[1.95 / 1.33, 1.95 / 0.76]).expect("two ratios"))
}

/// Rings up to 48 teeth: a few dozen combinations of tooth numbers a set.
fn reduced() -> ToothSearch {
    let mut search = ToothSearch::new(excavator());
    search.bounds = Bounds { ring: 12..=48, ..Bounds::default() };
    search
}

fn structures(criterion: &mut Criterion) {
    let requirements = excavator();
    let found = select(&requirements, &Space::All).expect("valid requirements");
    assert_eq!(found.accepted.len() + found.rejected.len(), 15);
    let mut group = criterion.benchmark_group("search/three_speed_structures");
    group.sample_size(20);
    group.bench_function("all", |bencher| bencher.iter(|| select(black_box(&requirements), &Space::All)));
    group.bench_function("brute_force", |bencher| {
        bencher.iter(|| brute::nearest_on_a_grid(black_box(&requirements), &Structure::all(), 24));
    });
    group.finish();
}

fn teeth(criterion: &mut Criterion) {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("one thread");
    let (whole, small) = (ToothSearch::new(excavator()), reduced());

    // The answers once: brute force and search agree on the reduced space.
    let (designs, tried) = brute::designs(&small.requirements, &small.structures, &small.bounds);
    let exact = brute::front(&designs);
    let found = small.front().expect("the search is one");
    let members = found.entries().iter().flat_map(|entry| found.designs(entry));
    assert_eq!(members.map(|design| design.pairs.len()).sum::<usize>(), exact.len());
    let full = pool.install(|| whole.front()).expect("the search is one");
    println!("reduced space: {tried} designs; whole: {:?}, front {}", full.counts(), full.entries().len());

    let mut group = criterion.benchmark_group("search/three_speed_teeth");
    group.sample_size(10);
    group.bench_function("front", |bencher| bencher.iter(|| pool.install(|| black_box(&whole).front())));
    group.bench_function("best_10", |bencher| bencher.iter(|| pool.install(|| black_box(&whole).best(10))));
    group.bench_function("reduced/front", |bencher| {
        bencher.iter(|| pool.install(|| black_box(&small).front()));
    });
    group.bench_function("reduced/brute_force", |bencher| {
        bencher
            .iter(|| brute::front(&brute::designs(&small.requirements, &small.structures, &small.bounds).0));
    });
    group.finish();
}

criterion_group!(benches, structures, teeth);
criterion_main!(benches);
