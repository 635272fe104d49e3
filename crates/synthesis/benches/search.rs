//! The parts of a search, beside their plain ways.

use criterion::{Criterion, criterion_group, criterion_main};
use epicyclic_synthesis::motion::{Motion, elements};
use epicyclic_synthesis::parts::{Bounds, Grid};
use epicyclic_synthesis::ratio::Ratio;
use epicyclic_synthesis::run::{Share, search};
use epicyclic_synthesis::search::Search;
use epicyclic_synthesis::wish::Wish;
use epicyclic_synthesis::{Class, Kind, Structure, enumerate};
use std::hint::black_box;
use std::ops::ControlFlow;

const EIGHT_SPEED: [f64; 9] = [4.714, 3.143, 2.106, 1.667, 1.285, 1.0, 0.839, 0.667, -3.295];
const SIX_SPEED: [f64; 7] = [3.48718, 1.86429, 1.40276, 1.0, 0.75198, 0.6525, -4.9325];

fn wish(ratios: &[f64], sets: usize, elements: usize) -> Wish {
    let bounds = |ratio: &f64| Bounds { least: ratio - 0.01 * ratio.abs(), most: ratio + 0.01 * ratio.abs() };
    Wish::new(ratios.iter().map(bounds).collect(), elements, vec![1.4..=4.5; sets])
}

fn parts(bench: &mut Criterion) {
    let structure: Structure = "a-b-c a-d-1 d-f-g f-c-2".parse().expect("a structure");
    let pairs = elements(structure.links());

    let mut motion = Motion::<u16>::new(structure.freedom());
    bench.bench_function("synthesis/functions/of_all_gears", |bench| {
        bench.iter(|| {
            motion.take(&structure, &pairs);
            let mut driven = 0;
            motion.for_each_gear(&mut |_, last| {
                driven += last.iter().filter(|speeds| !speeds.input.is_zero()).count();
            });
            black_box(driven)
        });
    });
    bench.bench_function("synthesis/functions/one_by_one", |bench| {
        bench.iter(|| {
            motion.take(&structure, &pairs);
            let mut driven = 0;
            for third in 2..pairs.len() {
                for second in 1..third {
                    driven += (0..second)
                        .filter(|first| !motion.gear(&[*first, second, third]).input.is_zero())
                        .count();
                }
            }
            black_box(driven)
        });
    });

    let grid = Grid::new(&vec![1.4..=4.5; 4]);
    let gears = wish(&EIGHT_SPEED, 4, 5).gears;
    let speeds = motion.gear(&[0, 1, 20]);
    if let Some(ratio) = Ratio::of(speeds) {
        bench.bench_function("synthesis/bounds/all_parts", |bench| {
            bench.iter(|| black_box(grid.reach(black_box(ratio), &gears)));
        });
    }

    let mut eight_speed = Search::<u16>::new(wish(&EIGHT_SPEED, 4, 5), 8);
    assert!(!eight_speed.structure(&structure).is_empty(), "the 8HP is found in its structure");
    bench.bench_function("synthesis/structure/four_sets", |bench| {
        bench.iter(|| black_box(eight_speed.structure(&structure).len()));
    });
}

fn classes(bench: &mut Criterion) {
    let class = Class::new(Kind::AllSparse, 3, 6).expect("a class");
    bench.bench_function("synthesis/enumerate/three_sets_all_sparse", |bench| {
        bench.iter(|| black_box(enumerate::all(class).len()));
    });
    let mut group = bench.benchmark_group("synthesis/class");
    group.sample_size(10);
    let six_speed = wish(&SIX_SPEED, 3, 5);
    for (name, threads) in [("three_sets_all_sparse", 1), ("three_sets_all_sparse/two_threads", 2)] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        group.bench_function(name, |bench| {
            bench.iter(|| {
                let answer =
                    pool.install(|| search(class, &six_speed, Share::WHOLE, &|_| ControlFlow::Continue(())));
                black_box(answer.map(|answer| answer.found.len()))
            });
        });
    }
}

criterion_group!(benches, parts, classes);
criterion_main!(benches);
