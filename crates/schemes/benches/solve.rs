//! A full analysis of a gear (speeds, torques, losses, sign pattern, efficiency), topology compiled
//! outside the timing, ratios and losses inside; beside it the plain way with nalgebra.

use criterion::{Criterion, criterion_group, criterion_main};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_schemes::set::{MeshLoss, SetSpec};
use epicyclic_schemes::{CompiledGear, Direction, Gearbox, Solution};
use std::hint::black_box;

#[path = "../tests/common/mod.rs"]
mod common;

use common::{machines, plain};

/// Scheme II-3 of the excavator wheel, second gear.
fn two_row() -> Gearbox {
    let loss = MeshLoss::Row(MeshEfficiency::new(0.97).expect("0.97 is an efficiency"));
    Gearbox::builder("II-3")
        .links(["D", "B", "T1", "T2"])
        .set(SetSpec::simple("1", ["T1", "D", "B"], 2.15).with_loss(loss))
        .set(SetSpec::simple("2", ["T1", "B", "T2"], 2.354).with_loss(loss))
        .brake("K2", "T2")
        .input("D")
        .output("B")
        .gear("2", ["K2"])
        .build()
        .expect("II-3 is a gearbox")
}

fn compare(criterion: &mut Criterion, name: &str, gearbox: &Gearbox, gear: &str) {
    let gear = gearbox.gear(gear).expect("the gear exists");
    let compiled = CompiledGear::new(gearbox, gear).expect("the gear is driven");
    let values = gearbox.values();
    let (ratios, etas) =
        (plain::ratios(gearbox), values.efficiencies.iter().map(|eta| eta.get()).collect::<Vec<_>>());
    let mut solution = Solution::default();

    // Both ways once, against each other and the analysis.
    compiled.solve(&values, Direction::Drive, &mut solution).expect("the gear is driven");
    let fast = solution.efficiency().expect("the gear moves");
    let slow = plain::solve(gearbox, gear, &ratios, &etas).expect("the gear is square").efficiency;
    let full = gearbox.analyze_gear(gear).expect("the gear exists").efficiency().expect("the gear is driven");
    assert!((fast - slow).abs() < 1e-12 && (fast - full).abs() < 1e-12, "{fast} {slow} {full}");

    let mut group = criterion.benchmark_group("solve");
    group.bench_function(name, |bencher| {
        bencher.iter(|| {
            compiled.solve(black_box(&values), Direction::Drive, &mut solution).expect("the gear is driven");
            black_box(&solution);
        });
    });
    group.bench_function(format!("{name}/plain"), |bencher| {
        bencher.iter(|| black_box(plain::solve(gearbox, gear, black_box(&ratios), black_box(&etas))));
    });
    group.bench_function(format!("{name}/analysis"), |bencher| {
        bencher
            .iter(|| black_box(gearbox.analyze_gear(black_box(gear)).map(|found| found.driving().is_some())));
    });
    group.finish();
}

fn solve(criterion: &mut Criterion) {
    compare(criterion, "two_row", &two_row(), "2");
    compare(criterion, "four_row", &machines::eight_speed().gearbox, "5");
}

criterion_group!(benches, solve);
criterion_main!(benches);
