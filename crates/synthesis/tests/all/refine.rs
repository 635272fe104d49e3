//! The best points of solutions and their ranges against bisection, and against points of the whole range.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use crate::bisection;
use crate::common;

use common::Random;
use epicyclic_synthesis::equal::Equal;
use epicyclic_synthesis::parts::{Bounds, Cuboid};
use epicyclic_synthesis::ratio::{Polynomial, Ratio};
use epicyclic_synthesis::refine::{Refined, refine};
use epicyclic_synthesis::run::{Share, search};
use epicyclic_synthesis::search::Search;
use epicyclic_synthesis::wish::Wish;
use epicyclic_synthesis::{Class, Kind, Structure};
use std::ops::ControlFlow;

fn wish(ratios: &[f64], tolerance: f64, sets: usize, elements: usize) -> Wish {
    let around = |ratio: &f64| Bounds {
        least: ratio - tolerance * ratio.abs(),
        most: ratio + tolerance * ratio.abs(),
    };
    Wish::new(ratios.iter().map(around).collect(), elements, vec![1.4..=4.5; sets])
}

/// Refines a point, and compares with bisection, both within 10⁻⁶.
fn agrees(ratios: &[Ratio], wish: &Wish, point: &[f64]) -> Refined {
    let whole: Cuboid = wish.k.iter().map(|range| [*range.start(), *range.end()]).collect();
    let refined = refine(ratios, &wish.gears, &[], &whole, point, Equal::NONE);
    let plain = bisection::refine(ratios, &wish.gears, &whole, point);
    let at_best = bisection::deviation(ratios, &wish.gears, &refined.k);
    assert!((at_best - refined.deviation).abs() < 1e-9, "{at_best}: {refined:?}");
    assert!(refined.deviation <= plain.deviation + 1e-6, "{refined:?} {plain:?}");
    assert!(plain.deviation - refined.deviation <= bisection::CLOSE + 1e-6, "{refined:?} {plain:?}");
    for (range, by_bisection) in refined.ranges.iter().zip(&plain.ranges) {
        for (end, other) in range.iter().zip(by_bisection) {
            assert!((end - other).abs() <= 2.0 * bisection::CLOSE * other, "{refined:?} {plain:?}");
        }
    }
    refined
}

#[test]
fn six_speeds_of_three_sets_are_refined_as_by_bisection() {
    let six_speed = wish(&[3.48718, 1.86429, 1.40276, 1.0, 0.75198, 0.6525, -4.9325], 0.01, 3, 5);
    let class = Class::new(Kind::AllSparse, 3, 6).unwrap();
    let answer = search(class, &six_speed, Share::WHOLE, &|_| ControlFlow::Continue(())).unwrap();
    for found in &answer.found {
        let ratios: Vec<Ratio> = found.solution.gears.iter().map(|gear| gear.ratio).collect();
        agrees(&ratios, &six_speed, &found.solution.k);
    }
}

#[test]
fn gears_that_do_not_bound_the_deviation_come_as_near_as_they_can() {
    // 1 + k₁ can have its ratio wherever the others, of k₂ alone, contradict each other.
    let wish = wish(&[3.059, 0.696, -2.294], 0.01, 2, 5);
    let polynomial = |plus: u64, minus: u64| Polynomial { plus, minus };
    let ratios = [
        (polynomial(0b11, 0), polynomial(1, 0)),
        (polynomial(0b100, 0), polynomial(0b101, 0)),
        (polynomial(0, 0b100), polynomial(1, 0)),
    ]
    .map(|(above, below)| Ratio::new(above, below).unwrap());
    let refined = agrees(&ratios, &wish, &[2.04, 2.29]);
    assert!((refined.k[0] - 2.059).abs() < 1e-5, "{refined:?}");
}

#[test]
fn a_loose_wish_has_wide_ranges_and_no_better_point() {
    // Four gears of two sets, within 5 %.
    let loose = wish(&[3.5, 1.9, 1.0, 0.7], 0.05, 2, 4);
    let class = Class::new(Kind::AllSparse, 2, 5).unwrap();
    let answer = search(class, &loose, Share::WHOLE, &|_| ControlFlow::Continue(())).unwrap();
    assert!(answer.found.len() > 5, "{}", answer.found.len());
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    for found in &answer.found {
        let ratios: Vec<Ratio> = found.solution.gears.iter().map(|gear| gear.ratio).collect();
        let refined = agrees(&ratios, &loose, &found.solution.k);
        for _ in 0..2000 {
            let k: Vec<f64> =
                loose.k.iter().map(|_| 1.4 + 3.1 * random.below(1_000_003) as f64 / 1_000_003.0).collect();
            let deviation = bisection::deviation(&ratios, &loose.gears, &k);
            assert!(deviation >= refined.deviation - 1e-6, "{}: {k:?} {refined:?}", found.structure);
            let outside = k
                .iter()
                .zip(&refined.ranges)
                .any(|(k, [least, most])| *k < least - 2e-6 * least || *k > most + 2e-6 * most);
            assert!(deviation > 1.0 || !outside, "{}: {k:?} {refined:?}", found.structure);
        }
    }
}

#[test]
fn the_8hp_has_its_tooth_numbers_within_its_ranges() {
    let eight_speed = wish(&[4.714, 3.143, 2.106, 1.667, 1.285, 1.0, 0.839, 0.667, -3.295], 0.01, 4, 5);
    let structure: Structure = "a-b-c a-d-1 d-f-g f-c-2".parse().unwrap();
    let found = Search::<u16>::new(eight_speed.clone(), 8).structure(&structure);
    let ratios: Vec<Ratio> = found[0].gears.iter().map(|gear| gear.ratio).collect();
    let refined = refine(&ratios, &eight_speed.gears, &[], &vec![[1.4, 4.5]; 4], &found[0].k, Equal::NONE);
    // 96/48, 96/48, 96/60 and 104/28 in the order of the sets of the canonical word.
    let (canonical, order) = Structure::canonical(&[[3, 4, 5], [3, 6, 1], [6, 7, 8], [7, 5, 2]], 8).unwrap();
    assert_eq!(canonical, structure);
    let teeth: Vec<f64> = order.iter().map(|set| [2.0, 2.0, 1.6, 104.0 / 28.0][*set]).collect();
    for (k, [least, most]) in teeth.iter().zip(&refined.ranges) {
        assert!((*least..=*most).contains(k), "{teeth:?} {refined:?}");
    }
    assert!(refined.deviation <= bisection::deviation(&ratios, &eight_speed.gears, &teeth));
}
