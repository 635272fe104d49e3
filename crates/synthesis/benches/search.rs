//! The parts of a search, beside their plain ways.

#[path = "../tests/common/bisection.rs"]
mod bisection;

use criterion::{Criterion, criterion_group, criterion_main};
use epicyclic_synthesis::equal::Equal;
use epicyclic_synthesis::motion::{Motion, elements};
use epicyclic_synthesis::parts::{Bounds, Grid};
use epicyclic_synthesis::ratio::Ratio;
use epicyclic_synthesis::refine::refine;
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
    motion.take(&structure, &pairs);
    let mut ratios: Vec<Ratio> = Vec::new();
    motion.for_each_gear(&mut |_, last| ratios.extend(last.iter().filter_map(|speeds| Ratio::of(*speeds))));
    let ratio = *ratios.iter().find(|ratio| ratio.variables() == 0b1111).expect("a ratio of all four k");
    bench.bench_function("synthesis/bounds/all_parts", |bench| {
        bench.iter(|| black_box(grid.reach(black_box(ratio), &gears)));
    });
    // The corners of each part in turn.
    let part_by_part = |ratio: Ratio| -> Vec<usize> {
        let mut reached = vec![0; gears.len()];
        for part in 0..grid.count() {
            let cuboid = grid.part(part);
            let corner =
                |corner: usize| -> Vec<f64> { (0..4).map(|set| cuboid[set][corner >> set & 1]).collect() };
            let corners: Vec<[f64; 2]> = (0..16)
                .map(|place| {
                    let k = corner(place);
                    [ratio.numerator.value(&k), ratio.denominator.value(&k)]
                })
                .collect();
            for (reached, gear) in reached.iter_mut().zip(&gears) {
                let above = |bound: f64| corners.iter().filter(move |[p, q]| p - bound * q > 0.0).count();
                let (lower, upper) = (above(gear.least), above(gear.most));
                *reached += usize::from(!(lower == 0 && upper == 0 || lower == 16 && upper == 16));
            }
        }
        reached
    };
    let of_all: Vec<usize> = grid.reach(ratio, &gears).iter().map(|parts| parts.count() as usize).collect();
    assert_eq!(part_by_part(ratio), of_all);
    bench.bench_function("synthesis/bounds/part_by_part", |bench| {
        bench.iter(|| black_box(part_by_part(black_box(ratio))));
    });

    let mut eight_speed = Search::<u16>::new(wish(&EIGHT_SPEED, 4, 5), 8);
    assert!(!eight_speed.structure(&structure).is_empty(), "the 8HP is found in its structure");
    bench.bench_function("synthesis/structure/four_sets", |bench| {
        bench.iter(|| black_box(eight_speed.structure(&structure).len()));
    });
    coverage(bench, &structure);

    let found = eight_speed.structure(&structure).swap_remove(0);
    let ratios: Vec<Ratio> = found.gears.iter().map(|gear| gear.ratio).collect();
    let whole = vec![[1.4, 4.5]; 4];
    let (best, plain) = (
        refine(&ratios, &gears, &[], &whole, &found.k, Equal::NONE).deviation,
        bisection::refine(&ratios, &gears, &whole, &found.k).deviation,
    );
    assert!((best - plain).abs() < bisection::CLOSE, "{best} by linear programmes, {plain} by bisection");
    bench.bench_function("synthesis/refine/linear_programmes", |bench| {
        bench.iter(|| black_box(refine(&ratios, &gears, &[], &whole, &found.k, Equal::NONE)));
    });
    bench.bench_function("synthesis/refine/bisection", |bench| {
        bench.iter(|| black_box(bisection::refine(&ratios, &gears, &whole, &found.k)));
    });
}

/// Benchmark of the sets of five elements whose functions are at least as many as the gears and reach every
/// gear somewhere. The search of the structure is compared with a test of every set of elements.
fn coverage(bench: &mut Criterion, structure: &Structure) {
    let wish = wish(&EIGHT_SPEED, 4, 5);
    let grid = Grid::new(&wish.k);
    let pairs = elements(structure.links());
    let mut motion = Motion::<u16>::new(structure.freedom());
    motion.take(structure, &pairs);
    // Each choice of three elements, as bits, with the gears in reach.
    let mut choices: Vec<(u64, Ratio, u32)> = Vec::new();
    motion.for_each_gear(&mut |first, last| {
        let chosen = first.iter().fold(0u64, |chosen, element| chosen | 1 << element);
        for (element, speeds) in (first[1] + 1..).zip(last) {
            let Some(ratio) = Ratio::of(*speeds) else { continue };
            let reached = grid.reach(ratio, &wish.gears).into_iter().enumerate();
            let gears = reached.fold(0, |all, (gear, parts)| all | u32::from(!parts.is_empty()) << gear);
            if gears != 0 {
                choices.push((chosen | 1 << element, ratio, gears));
            }
        }
    });
    let covers = |chosen: u64| {
        let having = choices.iter().filter(|(choice, ..)| choice & !chosen == 0);
        let ratios: std::collections::HashSet<Ratio> = having.clone().map(|(_, ratio, _)| *ratio).collect();
        having.fold(0, |all, (.., gears)| all | gears) == (1 << wish.gears.len()) - 1
            && ratios.len() >= wish.gears.len()
    };
    // Every thousandth of the sets of five.
    let mut some: Vec<u64> = Vec::new();
    let mut count = 0;
    for chosen in 0u64..1 << pairs.len().min(25) {
        if chosen.count_ones() == 5 {
            count += 1;
            if count % 1000 == 0 {
                some.push(chosen);
            }
        }
    }
    let mut search = Search::<u16>::new(wish.clone(), structure.links());
    assert_eq!(search.structure(structure).len(), 1);
    bench.bench_function("synthesis/coverage/every_thousandth_set_one_by_one", |bench| {
        bench.iter(|| black_box(some.iter().filter(|chosen| covers(**chosen)).count()));
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
