//! Sets with equal `k` as a wish, against trial of every point of a grid of the common `k`, planted gearboxes
//! and a scan.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use crate::common;
use crate::found;

use common::Random;
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_synthesis::equal::Equal;
use epicyclic_synthesis::judge::{Judged, judge};
use epicyclic_synthesis::motion::{Element, Motion, elements};
use epicyclic_synthesis::parts::Bounds;
use epicyclic_synthesis::ratio::{Polynomial, Ratio};
use epicyclic_synthesis::run::{Answer, Found, Share, search};
use epicyclic_synthesis::search::Search;
use epicyclic_synthesis::ternary::Ternary;
use epicyclic_synthesis::wish::Wish;
use epicyclic_synthesis::{Class, Kind, enumerate};
use found::holds;
use std::ops::ControlFlow;

fn around(ratio: f64, tolerance: f64) -> Bounds {
    Bounds { least: ratio - tolerance * ratio.abs(), most: ratio + tolerance * ratio.abs() }
}

fn wish(ratios: &[f64], tolerance: f64, sets: usize, elements: usize, equal_k: usize) -> Wish {
    let gears = ratios.iter().map(|ratio| around(*ratio, tolerance)).collect();
    Wish { equal_k, ..Wish::new(gears, elements, vec![1.4..=4.5; sets]) }
}

fn all(class: Class, wish: &Wish) -> Answer {
    search(class, wish, Share::WHOLE, &|_| ControlFlow::Continue(())).unwrap()
}

/// Judges a solution by the solver: its ratios are within their bounds at `k` with the requested number of
/// equal values, and their ranges are equal too.
fn confirmed(found: &Found, wish: &Wish) -> Judged {
    let judged = judge(found, wish, MeshEfficiency::IDEAL).unwrap();
    assert!(judged.ratios.iter().zip(&wish.gears).all(|(ratio, gear)| gear.contain(*ratio)));
    let equal: Vec<usize> = found.solution.equal.sets().collect();
    assert_eq!(equal.len(), wish.equal_k);
    for pair in equal.windows(2) {
        assert_eq!(found.solution.k[pair[0]].to_bits(), found.solution.k[pair[1]].to_bits());
        assert_eq!(judged.refined.k[pair[0]].to_bits(), judged.refined.k[pair[1]].to_bits());
        assert_eq!(judged.refined.ranges[pair[0]], judged.refined.ranges[pair[1]]);
        assert_eq!(found.structure.is_double_planet(pair[0]), found.structure.is_double_planet(pair[1]));
    }
    judged
}

fn wide(speed: Ternary<u8>) -> Polynomial {
    Polynomial { plus: speed.plus.into(), minus: speed.minus.into() }
}

/// The ratios of each pair of three elements at a common `k`, by the speeds before anything is cancelled;
/// ratios with a speed at rest are left out.
fn ratios_at(speeds: &[[Polynomial; 2]], k: f64) -> Vec<f64> {
    let values = speeds.iter().map(|[input, output]| [input.value(&[k; 2]), output.value(&[k; 2])]);
    values.filter(|[input, output]| input.abs() > 1e-9 && output.abs() > 1e-9).map(|[p, q]| p / q).collect()
}

#[test]
fn trial_of_common_k_finds_nothing_that_the_search_has_not() {
    let class = Class::new(Kind::Core, 2, 5).unwrap();
    let pairs = elements(class.links());
    let (mut by_trial, mut without) = (0, 0);
    for ratios in [[2.8, 1.0, -2.1], [3.0, 1.6, 0.7], [3.5, 1.4, -2.5]] {
        let wish = wish(&ratios, 0.05, 2, 3, 2);
        let answer = all(class, &wish);
        assert_eq!(answer.tally.undecided, 0);
        without += all(class, &Wish { equal_k: 0, ..wish.clone() }).found.len();
        let mut hits = 0;
        for structure in enumerate::all(class) {
            let mut motion = Motion::<u8>::new(structure.freedom());
            motion.take(&structure, &pairs);
            for third in 2..pairs.len() {
                for second in 1..third {
                    for first in 0..second {
                        let speeds = [[first, second], [first, third], [second, third]].map(|engaged| {
                            let speeds = motion.gear(&engaged);
                            [wide(speeds.input), wide(speeds.output)]
                        });
                        let ratios: Vec<Ratio> =
                            speeds.iter().filter_map(|[input, output]| Ratio::new(*input, *output)).collect();
                        if ratios.iter().fold(0, |all, ratio| all | ratio.variables()) != 0b11 {
                            continue;
                        }
                        let hit = (0..=310).any(|step| {
                            let values = ratios_at(&speeds, 1.4 + 0.01 * f64::from(step));
                            values.len() == 3
                                && wish
                                    .gears
                                    .iter()
                                    .all(|gear| values.iter().any(|value| gear.contain(*value)))
                        });
                        if hit {
                            hits += 1;
                            let chosen = [first, second, third].map(|element| pairs[element]);
                            assert!(holds(&answer.found, &structure, &chosen), "{structure} {chosen:?}");
                        }
                    }
                }
            }
        }
        by_trial += hits;
        for found in &answer.found {
            let judged = confirmed(found, &wish);
            scanned(found, &wish, &judged);
        }
    }
    assert!(by_trial > 5 && without > by_trial, "{by_trial} by trial, {without} with any k");
}

/// The best common `k` and its range by a scan.
fn scanned(found: &Found, wish: &Wish, judged: &Judged) {
    let deviation = |k: f64| {
        let of = found.solution.gears.iter().zip(&wish.gears).map(|(gear, bounds)| {
            let middle = 0.5 * (bounds.least + bounds.most);
            (gear.ratio.value(&[k; 2]) - middle).abs() / (0.5 * (bounds.most - bounds.least))
        });
        of.fold(0.0, f64::max)
    };
    let steps = 200_000;
    let at = |step: i32| 1.4 + 3.1 * f64::from(step) / f64::from(steps);
    let within: Vec<f64> = (0..=steps).map(at).filter(|k| deviation(*k) <= 1.0).collect();
    let best = (0..=steps).map(at).map(deviation).fold(f64::INFINITY, f64::min);
    let Judged { refined, .. } = judged;
    assert!((refined.deviation - deviation(refined.k[0])).abs() < 1e-12);
    assert!(refined.deviation <= best + 2e-6 && refined.deviation >= best - 2e-3, "{refined:?} {best}");
    let [least, most] = refined.ranges[0];
    let (first, last) = (within[0], within[within.len() - 1]);
    assert!((least - first).abs() < 4e-5 && (most - last).abs() < 4e-5, "{least}…{most} {first}…{last}");
}

#[test]
fn planted_gearboxes_with_equal_k_are_found() {
    let class = Class::new(Kind::AllSparse, 3, 6).unwrap();
    let structures = enumerate::all(class);
    let pairs = elements(class.links());
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    for equal_k in [2, 3] {
        let mut planted = 0;
        while planted < 40 {
            let structure = &structures[random.below(structures.len())];
            let mut kept: Vec<Element> = Vec::new();
            while kept.len() < 4 {
                let pair = pairs[random.below(pairs.len())];
                if !kept.contains(&pair) {
                    kept.push(pair);
                }
            }
            let mut k: Vec<f64> =
                (0..3).map(|_| 1.5 + 2.8 * random.below(100_003) as f64 / 100_003.0).collect();
            let free = random.below(3);
            let equal = (0..3).filter(|set| equal_k == 3 || *set != free);
            equal.for_each(|set| k[set] = k[(free + 1) % 3]);
            let mut motion = Motion::<u8>::new(structure.freedom());
            motion.take(structure, &kept);
            let distinct = (0..4).all(|one| (0..one).all(|other| !motion.tie_the_same(one, other)));
            let (mut ratios, mut values): (Vec<Ratio>, Vec<f64>) = (Vec::new(), Vec::new());
            let mut engaged = [false; 4];
            for second in 1..4 {
                for first in 0..second {
                    let speeds = motion.gear(&[first, second]);
                    let at = [speeds.input, speeds.output].map(|speed| wide(speed).value(&k));
                    if let Some(ratio) = Ratio::of(speeds)
                        && at.iter().all(|speed| speed.abs() > 1e-9)
                    {
                        (engaged[first], engaged[second]) = (true, true);
                        if !ratios.contains(&ratio) {
                            ratios.push(ratio);
                            values.push(at[0] / at[1]);
                        }
                    }
                }
            }
            let apart = (0..values.len()).all(|one| {
                (0..one).all(|other| {
                    (values[one] - values[other]).abs() > 0.025 * values[one].abs().max(values[other].abs())
                })
            });
            let usual = values.iter().all(|value| (0.05..20.0).contains(&value.abs()));
            let moved = ratios.iter().fold(0, |all, ratio| all | ratio.variables());
            // An element that drives at other k alone is not needed.
            let distinct = distinct && engaged == [true; 4];
            if !distinct || values.len() < 3 || !apart || !usual || moved != 0b111 {
                continue;
            }
            planted += 1;
            let wish = wish(&values, 0.01, 3, 4, equal_k);
            let solutions = Search::<u8>::new(wish.clone(), 6).structure(structure).into_iter();
            let found: Vec<Found> =
                solutions.map(|solution| Found { structure: structure.clone(), solution }).collect();
            assert!(holds(&found, structure, &kept), "{structure} {kept:?} {k:?} {values:?}");
            found.iter().for_each(|found| drop(confirmed(found, &wish)));
        }
    }
}

#[test]
fn a_search_with_equal_k_finds_those_of_the_search_without_that_can_have_them() {
    let class = Class::new(Kind::AllSparse, 3, 6).unwrap();
    let ratios = [3.48718, 1.86429, 1.40276, 1.0, 0.75198, 0.6525, -4.9325];
    let free = wish(&ratios, 0.02, 3, 5, 0);
    let without = all(class, &free).found;
    let bound = wish(&ratios, 0.02, 3, 5, 2);
    let found = all(class, &bound).found;
    assert!(!found.is_empty() && found.len() < without.len(), "{} of {}", found.len(), without.len());
    for one in &found {
        let elements: Vec<Element> = one.solution.elements.iter().map(|pairs| pairs[0]).collect();
        assert!(holds(&without, &one.structure, &elements));
        // With all k free nothing is worse.
        let tied = confirmed(one, &bound).refined.deviation;
        let same = without.iter().find(|other| {
            other.structure == one.structure && other.solution.elements == one.solution.elements
        });
        let best = judge(same.unwrap(), &free, MeshEfficiency::IDEAL).unwrap().refined.deviation;
        assert!(best <= tied + 2e-6, "{best} with any k, {tied} with equal ones");
    }
}

#[test]
fn double_planet_sets_have_no_k_in_common_with_simple_ones() {
    let class = Class::new(Kind::AllSparse, 3, 6).unwrap();
    let mut bound = wish(&[4.171, 2.340, 1.521, 1.143, 0.867, 0.691, -3.403], 0.03, 3, 5, 2);
    (bound.k[2], bound.double_planets) = (0.6..=3.5, 1);
    let share = Share { number: 0, of: 4 };
    let found = search(class, &bound, share, &|_| ControlFlow::Continue(())).unwrap().found;
    assert!(found.iter().all(|found| found.solution.equal == [0, 1].into_iter().collect::<Equal>()));
    for (double_planets, k, why) in [
        (2, vec![1.4..=4.5, 0.6..=3.5, 0.6..=3.5], None),
        (0, vec![1.4..=4.5, 1.4..=4.4, 1.4..=4.5], Some("need one range of k")),
    ] {
        let refused = Wish { k, double_planets, ..bound.clone() }.check(class).err();
        assert_eq!(refused.is_some(), why.is_some());
        assert!(refused.is_none_or(|error| error.to_string().contains(why.unwrap())));
    }
    let refused = Wish { equal_k: 3, ..bound }.check(class).unwrap_err().to_string();
    assert!(refused.contains("3 sets of one kind with equal k, yet there are 2 of one kind"), "{refused}");
}
