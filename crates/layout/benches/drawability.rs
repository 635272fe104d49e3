//! Drawability: the verdict, beside the drawing of it and the witness.

use criterion::{Criterion, criterion_group, criterion_main};
use epicyclic_layout as drawability;
use epicyclic_layout::{Options, Verdict};
use epicyclic_train::Gearbox;
use epicyclic_train::set::SetSpec;
use std::hint::black_box;

#[path = "../../train/tests/common/machines.rs"]
mod machines;

fn two_sets(sets: [[&str; 3]; 2]) -> Gearbox {
    Gearbox::builder("two sets")
        .links(["D", "B", "T1", "T2"])
        .set(SetSpec::simple("1", sets[0], 2.15))
        .set(SetSpec::simple("2", sets[1], 2.354))
        .brake("K1", "T1")
        .brake("K2", "T2")
        .clutch("direct", "D", "B")
        .input("D")
        .output("B")
        .build()
        .expect("two sets are a gearbox")
}

fn drawability(criterion: &mut Criterion) {
    let cases = [
        ("two_sets", two_sets([["T1", "D", "B"], ["T1", "B", "T2"]]), true),
        ("two_sets_crossing", two_sets([["D", "B", "T1"], ["D", "B", "T2"]]), false),
        ("four_sets", machines::eight_speed().gearbox, true),
    ];
    let mut group = criterion.benchmark_group("drawability");
    for (name, gearbox, drawable) in &cases {
        let one = Options { attempts: 1, ..Options::default() };
        let verdict = drawability::draw(gearbox, one);
        assert_eq!(matches!(verdict, Verdict::Drawable(_)), *drawable);
        assert_eq!(drawability::is_drawable(gearbox), *drawable);
        group.bench_function(*name, |bencher| {
            bencher.iter(|| black_box(drawability::is_drawable(black_box(gearbox))));
        });
        for (options, what) in [(one, "draw_once"), (Options::default(), "draw")] {
            group.bench_function(format!("{name}/{what}"), |bencher| {
                bencher.iter(|| black_box(drawability::draw(black_box(gearbox), options)));
            });
        }
    }
    group.finish();
}

criterion_group!(benches, drawability);
criterion_main!(benches);
