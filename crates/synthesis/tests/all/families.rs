//! Families of solutions against their ratios at random points.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use crate::common;

use common::Random;
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_synthesis::family::{Family, number};
use epicyclic_synthesis::judge::judge;
use epicyclic_synthesis::parts::Bounds;
use epicyclic_synthesis::run::{Found, Share, search};
use epicyclic_synthesis::wish::Wish;
use epicyclic_synthesis::{Class, Kind};
use std::ops::ControlFlow;

fn wish(ratios: &[f64], tolerance: f64, sets: usize, elements: usize) -> Wish {
    let around = |ratio: &f64| Bounds {
        least: ratio - tolerance * ratio.abs(),
        most: ratio + tolerance * ratio.abs(),
    };
    Wish::new(ratios.iter().map(around).collect(), elements, vec![1.4..=4.5; sets])
}

/// Orders of some sets, by choosing each place in turn.
fn orders(sets: usize) -> Vec<Vec<usize>> {
    (0..sets).fold(vec![vec![]], |orders, _| {
        orders
            .iter()
            .flat_map(|order| {
                let others = (0..sets).filter(|set| !order.contains(set));
                others.map(|set| [order.clone(), vec![set]].concat()).collect::<Vec<_>>()
            })
            .collect()
    })
}

/// Whether two solutions have the same ratios at random points, those of one taken in some order of sets with
/// the same range.
fn are_alike(one: &Found, other: &Found, wish: &Wish, points: &[Vec<f64>]) -> bool {
    if one.structure.double_planets() != other.structure.double_planets() {
        return false;
    }
    let ratios = |found: &Found, k: &[f64]| -> Vec<f64> {
        found.solution.gears.iter().map(|gear| gear.ratio.value(k)).collect()
    };
    orders(wish.k.len()).iter().any(|order| {
        order.iter().enumerate().all(|(place, set)| wish.k[place] == wish.k[*set])
            && points.iter().all(|k| {
                let moved: Vec<f64> = order.iter().map(|set| k[*set]).collect();
                let pairs = ratios(one, k).into_iter().zip(ratios(other, &moved));
                pairs.into_iter().all(|(one, other)| (one - other).abs() <= 1e-9 * one.abs())
            })
    })
}

/// Numbers of solutions and families of a search. Each pair is compared by random points, and members are
/// judged as of one function.
fn families(class: Class, wish: &Wish) -> [usize; 2] {
    let found = search(class, wish, Share::WHOLE, &|_| ControlFlow::Continue(())).unwrap().found;
    let gears: Vec<usize> = (0..wish.gears.len()).collect();
    let keys: Vec<Family> = found.iter().map(|found| Family::of(found, wish, &gears)).collect();
    let (numbers, members) = number(&keys);
    assert_eq!(members.iter().sum::<usize>(), found.len());
    let mut random = Random(0x2545_f491_4f6c_dd1d);
    let points: Vec<Vec<f64>> = (0..4)
        .map(|_| wish.k.iter().map(|_| 1.4 + 3.0 * random.below(1_000_003) as f64 / 1_000_003.0).collect())
        .collect();
    for one in 0..found.len() {
        for other in 0..one {
            assert_eq!(
                numbers[one] == numbers[other],
                are_alike(&found[one], &found[other], wish, &points),
                "{} and {}",
                found[one].structure,
                found[other].structure
            );
        }
    }
    for family in 0..members.len() {
        let judged: Vec<_> = found
            .iter()
            .zip(&numbers)
            .filter(|(_, number)| **number == family)
            .map(|(found, _)| judge(found, wish, MeshEfficiency::IDEAL).unwrap())
            .collect();
        let sorted = |k: &[f64]| {
            let mut k = k.to_vec();
            k.sort_by(f64::total_cmp);
            k
        };
        for other in &judged {
            assert!((other.refined.deviation - judged[0].refined.deviation).abs() < 1e-5);
            let near = sorted(&other.refined.k).into_iter().zip(sorted(&judged[0].refined.k));
            // The deviation is found to 10⁻⁶; where it hardly depends on a `k`, that is known less closely.
            assert!(near.into_iter().all(|(one, other)| (one / other - 1.0).abs() < 1e-3));
        }
    }
    [found.len(), members.len()]
}

#[test]
fn families_are_those_of_ratios_at_random_points() {
    let class = |sets, links| Class::new(Kind::AllSparse, sets, links).unwrap();
    let two = wish(&[3.059, 1.625, 1.0, 0.696, -2.294], 0.01, 2, 5);
    let three = wish(&[3.48718, 1.86429, 1.40276, 1.0, 0.75198, 0.6525, -4.9325], 0.01, 3, 5);
    assert_eq!(families(class(2, 5), &two), [14, 3]);
    assert_eq!(families(class(3, 6), &three), [43, 15]);
    // A set with a range of its own is not exchanged with others, nor a double-planet set.
    let apart = Wish { k: vec![1.4..=4.5, 1.4..=4.4], ..two.clone() };
    assert_eq!(families(class(2, 5), &apart), [14, 6]);
    let double = Wish { k: vec![1.4..=4.5, 0.6..=3.5], double_planets: 1, ..two };
    assert_eq!(families(class(2, 5), &double), [56, 20]);
}
