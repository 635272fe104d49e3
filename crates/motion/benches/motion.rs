//! The power shift P2 from start to the locked clutch, and ten seconds of driving with a gearbox of four
//! sets.

use criterion::{Criterion, criterion_group, criterion_main};
use epicyclic_motion::Start;
use std::hint::black_box;

#[path = "../tests/common/mod.rs"]
mod common;

use common::{at, drive_cycle, power_shift, s, start, table};

fn motion(criterion: &mut Criterion) {
    let hand_over = 46.0 / 215.0;
    let mut shift = power_shift(150.0, 300.0);
    let clutch = table(&[(0.0, 0.0), (hand_over, 500.0 * hand_over), (hand_over, 160.0)]);
    shift.shift_element("clutch", clutch, 1.0).expect("the gearbox has this clutch");
    let begin = start(&[("sun", 200.0), ("ring", 0.0)]);
    let run = shift.run(&begin, s(0.6), None).expect("the shift has a motion");
    assert!((at(&run.events[1]) - 0.514_239_103_6).abs() < 1e-9);
    criterion.bench_function("motion/shift/p2", |bencher| {
        bencher.iter(|| black_box(&shift).run(&begin, s(0.6), None));
    });

    let cycle = drive_cycle();
    let run = cycle.run(&Start::at_rest(), s(10.0), None).expect("the cycle has a motion");
    assert!(run.audit.residual().abs() < 1e-9, "{}", run.audit.residual());
    criterion.bench_function("motion/cycle/four_sets_10_s", |bencher| {
        bencher.iter(|| black_box(&cycle).run(&Start::at_rest(), s(10.0), None));
    });
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(20);
    targets = motion
}
criterion_main!(benches);
