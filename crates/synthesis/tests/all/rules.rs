//! Rules of a wish against the solutions without them.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_synthesis::judge::judge;
use epicyclic_synthesis::parts::Bounds;
use epicyclic_synthesis::ratio::Ratio;
use epicyclic_synthesis::rules::Rules;
use epicyclic_synthesis::run::{Answer, Found, Share, search};
use epicyclic_synthesis::shifts::Shifts;
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

fn all(class: Class, wish: &Wish) -> Answer {
    every(1, class, wish)
}

/// Searches one of this number of shares of a class.
fn every(of: usize, class: Class, wish: &Wish) -> Answer {
    search(class, wish, Share { number: 0, of }, &|_| ControlFlow::Continue(())).unwrap()
}

/// Structure and elements of each solution, whatever pair of an element comes first.
fn names(found: &[Found]) -> Vec<String> {
    let name = |found: &Found| {
        let mut elements = found.solution.elements.clone();
        elements.iter_mut().for_each(|pairs| pairs.sort_unstable());
        format!("{} {elements:?}", found.structure)
    };
    let mut names: Vec<String> = found.iter().map(name).collect();
    names.sort_unstable();
    names
}

fn four_speeds() -> (Class, Wish) {
    let class = Class::new(Kind::AllSparse, 2, 5).unwrap();
    (class, wish(&[3.059, 1.625, 1.0, 0.696, -2.294], 0.04, 2, 5))
}

#[test]
fn brakes_and_clutches_keep_the_solutions_that_can_have_them() {
    let (class, wish) = four_speeds();
    let every = all(class, &wish);
    let mut kept = 0;
    for (brakes, clutches) in
        [(0..=2, 0..=64), (0..=1, 0..=64), (0..=64, 0..=2), (3..=64, 1..=2), (2..=2, 3..=3)]
    {
        let rules = Rules { brakes: brakes.clone(), clutches: clutches.clone(), ..Rules::default() };
        let found = all(class, &Wish { rules, ..wish.clone() });
        // Of each element a brake or a clutch, as its pairs allow: some choice has both numbers.
        let can = |found: &&Found| {
            let elements = &found.solution.elements;
            (0..1u32 << elements.len()).any(|choice| {
                let brake = |place: usize| choice >> place & 1 == 1;
                let exists = |place: usize| elements[place].iter().any(|pair| (pair[0] == 0) == brake(place));
                let count = choice.count_ones() as usize;
                (0..elements.len()).all(exists)
                    && brakes.contains(&count)
                    && clutches.contains(&(elements.len() - count))
            })
        };
        let expected: Vec<Found> = every.found.iter().filter(can).cloned().collect();
        assert_eq!(names(&found.found), names(&expected), "{brakes:?} brakes, {clutches:?} clutches");
        for found in &found.found {
            let count = found.solution.elements.iter().filter(|pairs| pairs[0][0] == 0).count();
            assert!(brakes.contains(&count) && clutches.contains(&(5 - count)));
        }
        kept += found.found.len();
        assert!(found.found.len() < every.found.len());
    }
    assert!(kept > 0);
}

#[test]
fn single_shifts_keep_the_solutions_that_can_shift_so_and_count_the_others() {
    let class = Class::new(Kind::AllSparse, 3, 6).unwrap();
    let wish = wish(&[3.48718, 1.86429, 1.40276, 1.0, 0.75198, 0.6525, -4.9325], 0.01, 3, 5);
    let without = all(class, &wish);
    let mut left_out = 0;
    for (neighbours, skips) in [(true, false), (true, true)] {
        let rules = Rules { shifts: Shifts { neighbours, skips }, ..Rules::default() };
        let bound = Wish { rules, ..wish.clone() };
        let found = all(class, &bound);
        assert_eq!(found.found.len() as u64 + found.tally.without_single_shifts, without.found.len() as u64);
        let names_found = names(&found.found);
        for found in &without.found {
            let judged = judge(found, &wish, MeshEfficiency::IDEAL).unwrap();
            let keeps = judged.multiple_shifts == 0 && !skips;
            assert!(!keeps || names_found.contains(&names(std::slice::from_ref(found))[0]));
        }
        for found in &found.found {
            let judged = judge(found, &bound, MeshEfficiency::IDEAL).unwrap();
            assert_eq!(judged.multiple_shifts, 0);
            let far = |by: usize| {
                (by..6).all(|gear| {
                    let before = &judged.engaged[gear - by];
                    judged.engaged[gear].iter().filter(|element| !before.contains(element)).count() <= 1
                })
            };
            assert!(far(1) && (!skips || far(2)), "{}", found.structure);
        }
        left_out += found.tally.without_single_shifts;
    }
    assert!(left_out > 0);
}

#[test]
fn a_direct_gear_turns_as_one_block_whatever_the_k() {
    let class = Class::new(Kind::Core, 3, 6).unwrap();
    // Some functions come near 1 without being it.
    let wish = wish(&[3.4, 1.0, -2.2], 0.05, 3, 4);
    let of = 8;
    let without = every(of, class, &wish);
    let rules = Rules { direct: true, ..Rules::default() };
    let found = every(of, class, &Wish { rules, ..wish });
    assert_eq!(found.found.len() as u64 + found.tally.without_direct, without.found.len() as u64);
    assert!(found.found.iter().all(|found| found.solution.gears[1].ratio == Ratio::ONE));
    assert!(found.tally.without_direct > 0 && !found.found.is_empty(), "{:?}", found.tally);
}
