//! Benchmark of all gears of a four-speed gearbox for many basic ratios, compared with an analysis of every
//! variant.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_train::Gearbox;
use epicyclic_train::set::{MeshLoss, SetSpec};
use epicyclic_train::sweep::Sweep;
use std::hint::black_box;

/// A Simpson set with these `k`, three gears forward and one back.
fn simpson([front, rear]: [f64; 2]) -> Gearbox {
    let loss = MeshLoss::Set(MeshEfficiency::new(0.97).expect("0.97 is an efficiency"));
    Gearbox::builder("Simpson")
        .links(["in", "RA", "S", "CB", "out"])
        .set(SetSpec::simple("PA", ["S", "RA", "out"], front).with_loss(loss))
        .set(SetSpec::simple("PB", ["S", "out", "CB"], rear).with_loss(loss))
        .clutch("FWD", "in", "RA")
        .clutch("DIR", "in", "S")
        .brake("INT", "S")
        .brake("LR", "CB")
        .input("in")
        .output("out")
        .gear("1", ["FWD", "LR"])
        .gear("2", ["FWD", "INT"])
        .gear("3", ["FWD", "DIR"])
        .gear("R", ["DIR", "LR"])
        .build()
        .expect("a Simpson set is a gearbox")
}

/// Sum of ratios and efficiencies, so that the compiler removes none of them.
fn analysed(k: [f64; 2]) -> f64 {
    let gearbox = simpson(k);
    let of = |gear: &str| {
        let found = gearbox.analyze(gear).expect("the gear exists");
        found.ratio().unwrap_or(0.0) + found.efficiency().unwrap_or(0.0)
    };
    ["1", "2", "3", "R"].map(of).iter().sum()
}

fn sweep(criterion: &mut Criterion) {
    let gearbox = simpson([2.0, 2.0]);
    let mut sweep = Sweep::new(&gearbox, gearbox.gears(), &["PA", "PB"]).expect("the sets exist");
    let mut found = vec![];
    let mut swept = |k: [f64; 2]| -> f64 {
        sweep.solve(&k, &mut found).expect("these are ratios of simple sets");
        found.iter().map(|one| one.ratio.unwrap_or(0.0) + one.efficiency.unwrap_or(0.0)).sum()
    };
    for k in [[1.5, 2.5], [2.0, 3.0], [4.0, 1.2]] {
        assert!((swept(k) - analysed(k)).abs() < 1e-10, "{k:?}");
    }
    let mut group = criterion.benchmark_group("sweep/four_gears");
    group.throughput(Throughput::Elements(1));
    group.bench_function("variant", |bencher| bencher.iter(|| black_box(swept(black_box([2.1, 2.4])))));
    group.bench_function("analysis", |bencher| bencher.iter(|| black_box(analysed(black_box([2.1, 2.4])))));
    group.finish();
}

criterion_group!(benches, sweep);
criterion_main!(benches);
