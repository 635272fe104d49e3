//! The complete enumeration of tooth numbers, beside the trial of every combination.

#[path = "../tests/common/trial.rs"]
mod trial;

use criterion::{Criterion, criterion_group, criterion_main};
use epicyclic_gears::arrangement::{Arrangement, ArrangementBounds};
use epicyclic_gears::simple_set::{Member, Mode};
use epicyclic_gears::synthesis::{Bounds, tooth_numbers_by_trial};
use std::hint::black_box;
use std::ops::ControlFlow;
use trial::arranged_by_trial;

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

/// A request for each arrangement within the usual bounds; on reduced ones also the trial of every
/// combination.
fn arrangements(c: &mut Criterion) {
    let requests = [
        ("stepped", Arrangement::Stepped, 14.0),
        ("wolfrom", Arrangement::Wolfrom, 51.0),
        ("ravigneaux", Arrangement::Ravigneaux, 1.5),
    ];
    for (name, arrangement, ratio) in requests {
        let mode = arrangement.mode(arrangement.usual_mode()).expect("a mode of its own");
        let find = |bounds: &ArrangementBounds| {
            let found =
                bounds.for_ratio(black_box(ratio), mode, 0.01, usize::MAX, |_| ControlFlow::Continue(()));
            found.map(|ranked| (ranked.found, ranked.left_out)).ok()
        };
        let usual = ArrangementBounds::of(arrangement, &Bounds::default());
        c.bench_function(&format!("gears/arrangement/{name}/usual"), |b| b.iter(|| find(black_box(&usual))));

        // Shifts of all gears are chosen for the sets whose centre distances differ.
        let shifted = ArrangementBounds { offsets: -1..=1, ..usual };
        let mut slow = c.benchmark_group(format!("gears/arrangement/{name}"));
        slow.sample_size(10).bench_function("shifted", |b| b.iter(|| find(black_box(&shifted))));
        slow.finish();

        let teeth = Bounds { sun: 20..=36, planet: 17..=36, ring: 72..=100, ..Bounds::default() };
        let reduced = ArrangementBounds::of(arrangement, &teeth);
        let by_trial = || arranged_by_trial(black_box(&reduced), ratio, mode, 0.01).plain;
        let found =
            find(&reduced).map(|(found, left_out)| found + left_out.map_or(0, |left_out| left_out.count));
        assert_eq!(found.unwrap_or(0), by_trial().len() as u64);
        c.bench_function(&format!("gears/arrangement/{name}/reduced"), |b| {
            b.iter(|| find(black_box(&reduced)));
        });
        let mut slow = c.benchmark_group(format!("gears/arrangement/{name}/reduced"));
        slow.sample_size(10).bench_function("brute_force", |b| b.iter(by_trial));
        slow.finish();
    }
}

criterion_group!(benches, synthesis, arrangements);
criterion_main!(benches);
