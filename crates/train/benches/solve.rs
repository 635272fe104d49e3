//! Benchmark of a full analysis of a gear: speeds, torques, losses, sign pattern, efficiency. The topology is
//! compiled outside the timing, ratios and losses are inside. The comparison is a plain solution with
//! nalgebra.

use criterion::{Criterion, criterion_group, criterion_main};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_train::compound::{CentralKind, CompoundSpec};
use epicyclic_train::set::{MeshLoss, SetSpec};
use epicyclic_train::{CompiledGear, Direction, Gearbox, Solution};
use std::hint::black_box;

#[path = "../tests/common/mod.rs"]
mod common;

use common::oracle::{self, BoxPlan, CentralPlan, SetPlan, c, p};
use common::{machines, plain};

/// Scheme II-3 of the excavator wheel, second gear.
fn two_sets() -> Gearbox {
    let loss = MeshLoss::Set(MeshEfficiency::new(0.97).expect("0.97 is an efficiency"));
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

/// A Ravigneaux set in second gear: small sun driven, large sun held, out at the ring.
fn ravigneaux() -> BoxPlan {
    use CentralKind::{Ring, Sun};
    let meshes = [[c(0), p(0, 0)], [p(0, 0), p(1, 0)], [c(1), p(1, 0)], [p(1, 0), c(2)]];
    let set = SetPlan {
        kind: None,
        carrier: 4,
        centrals: vec![central(1, Sun, 30), central(2, Sun, 36), central(3, Ring, 72)],
        planets: vec![vec![18], vec![18]],
        meshes: meshes.map(|gears| (gears, 0.98)).into(),
    };
    let mut plan = BoxPlan::of(vec![set], 4, 1, 3);
    plan.elements.push(([2, 0], true));
    plan
}

/// A Wolfrom drive, 51 to 1.
fn wolfrom() -> BoxPlan {
    use CentralKind::{Ring, Sun};
    let meshes = [[c(0), p(0, 0)], [p(0, 0), c(1)], [p(0, 1), c(2)]];
    let set = SetPlan {
        kind: None,
        carrier: 3,
        centrals: vec![central(1, Sun, 32), central(0, Ring, 100), central(2, Ring, 96)],
        planets: vec![vec![34, 30]],
        meshes: meshes.map(|gears| (gears, 0.99)).into(),
    };
    BoxPlan::of(vec![set], 3, 1, 2)
}

fn central(link: usize, kind: CentralKind, teeth: u32) -> CentralPlan {
    CentralPlan { link, kind, teeth, planet: None }
}

/// Times the compiled gear, the plain way and the analysis, once all three agree.
fn compare(criterion: &mut Criterion, name: &str, gearbox: &Gearbox, gear: &str, plain: impl Fn() -> f64) {
    let gear = gearbox.gear(gear).expect("the gear exists");
    let compiled = CompiledGear::new(gearbox, gear).expect("the gear is driven");
    let values = gearbox.values();
    let mut solution = Solution::default();

    compiled.solve(&values, Direction::Drive, &mut solution).expect("the gear is driven");
    let fast = solution.efficiency().expect("the gear moves");
    let slow = plain();
    let full = gearbox.analyze_gear(gear).expect("the gear exists").efficiency().expect("the gear is driven");
    assert!((fast - slow).abs() < 1e-12 && (fast - full).abs() < 1e-12, "{fast} {slow} {full}");

    let mut group = criterion.benchmark_group("solve");
    group.bench_function(name, |bencher| {
        bencher.iter(|| {
            compiled.solve(black_box(&values), Direction::Drive, &mut solution).expect("the gear is driven");
            black_box(&solution);
        });
    });
    group.bench_function(format!("{name}/plain"), |bencher| bencher.iter(|| black_box(plain())));
    group.bench_function(format!("{name}/analysis"), |bencher| {
        bencher
            .iter(|| black_box(gearbox.analyze_gear(black_box(gear)).map(|found| found.driving().is_some())));
    });
    group.bench_function(format!("{name}/analysis/ratio"), |bencher| {
        bencher.iter(|| black_box(gearbox.analyze_gear(black_box(gear)).map(|found| found.ratio())));
    });
    group.finish();
}

/// Comparison with a plain solution: every set is an equation, every link a speed.
fn compare_short(criterion: &mut Criterion, name: &str, gearbox: &Gearbox, gear: &str) {
    let (ratios, values) = (plain::ratios(gearbox), gearbox.values());
    let etas: Vec<f64> = values.efficiencies.iter().map(|eta| eta.get()).collect();
    let own = gearbox.gear(gear).expect("the gear exists");
    compare(criterion, name, gearbox, gear, || {
        plain::solve(gearbox, own, black_box(&ratios), black_box(&etas))
            .expect("the gear is square")
            .efficiency
    });
}

/// Comparison with a plain solution: every mesh is a force, every body a balance.
fn compare_compound(criterion: &mut Criterion, name: &str, plan: &BoxPlan) {
    let gearbox = plan.build(None).expect("the plan is a gearbox");
    compare(criterion, name, &gearbox, "g", || {
        let speeds = oracle::speeds(black_box(plan)).expect("the gear is square");
        let (_, loads) = oracle::lossy(plan, &speeds, Direction::Drive).expect("the gear moves");
        loads.efficiency
    });
}

/// 64 sets, a quarter of them compound, in series.
fn longest() -> Gearbox {
    let loss = MeshLoss::Set(MeshEfficiency::new(0.98).expect("0.98 is an efficiency"));
    let link = |place: usize| format!("n{place}");
    let builder = Gearbox::builder("longest").links((0..=64).map(link));
    let builder = (0..64).fold(builder, |builder, place| {
        let [from, to] = [link(place), link(place + 1)];
        if place % 4 > 0 {
            return builder
                .set(SetSpec::simple(&place.to_string(), [&from, "ground", &to], 2.5).with_loss(loss));
        }
        let free = format!("free{place}");
        let eta = MeshEfficiency::new(0.99).expect("0.99 is an efficiency");
        let set = CompoundSpec::new(&place.to_string(), &to)
            .sun(&from, 30)
            .ring("ground", 72)
            .sun(&free, 36)
            .planet("short", &[18])
            .planet("long", &[18])
            .mesh(&from, "short", eta)
            .mesh("short", "long", eta)
            .mesh("long", "ground", eta)
            .mesh("long", &free, eta);
        builder.links([free]).compound_set(set)
    });
    builder.input("n0").output("n64").gear("only", [""; 0]).build().expect("64 sets are allowed")
}

fn solve(criterion: &mut Criterion) {
    compare_short(criterion, "two_sets", &two_sets(), "2");
    compare_short(criterion, "four_sets", &machines::eight_speed().gearbox, "5");
    compare_compound(criterion, "ravigneaux", &ravigneaux());
    compare_compound(criterion, "wolfrom", &wolfrom());
    let gearbox = longest();
    assert!(gearbox.analyze("only").expect("the gear exists").efficiency().is_some());
    criterion.bench_function("solve/sixty_four/analysis", |bencher| {
        bencher.iter(|| black_box(gearbox.analyze(black_box("only")).map(|found| found.driving().is_some())));
    });
}

criterion_group!(benches, solve);
criterion_main!(benches);
