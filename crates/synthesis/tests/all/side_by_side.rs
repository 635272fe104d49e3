//! Free gears side by side, whose bounds overlap, against trial of a grid and against gears with bounds of
//! their own.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use crate::found;

use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::synthesis;
use epicyclic_synthesis::judge::judge;
use epicyclic_synthesis::motion::{Element, Motion, elements};
use epicyclic_synthesis::parts::Bounds;
use epicyclic_synthesis::ratio::Ratio;
use epicyclic_synthesis::rules::Rules;
use epicyclic_synthesis::run::{Answer, Share, search};
use epicyclic_synthesis::shifts::Shifts;
use epicyclic_synthesis::teeth::{Aim, Alike, Choice, Gears, Sets, designs};
use epicyclic_synthesis::wish::Wish;
use epicyclic_synthesis::{Class, Kind, enumerate};
use found::holds;
use std::ops::ControlFlow;

/// Gears of 3 and 0.7 with two free ones between them.
fn two_free() -> Wish {
    two_free_within(0.05)
}

/// Gears of 3 and 0.7 with this tolerance, and two free ones between them.
fn two_free_within(tolerance: f64) -> Wish {
    let around = |ratio: f64| Bounds { least: (1.0 - tolerance) * ratio, most: (1.0 + tolerance) * ratio };
    let [first, last] = [3.0, 0.7].map(around);
    let free = Bounds { least: last.most.next_up(), most: first.least.next_down() };
    let wish = Wish::new(vec![first, free, free, last], 4, vec![1.4..=4.5; 2]);
    Wish { side_by_side: vec![vec![1, 2]], ..wish }
}

fn all(class: Class, wish: &Wish) -> Answer {
    search(class, wish, Share::WHOLE, &|_| ControlFlow::Continue(())).unwrap()
}

/// Functions, each with the elements of all choices that have it, as bits.
type Functions = Vec<(Ratio, usize)>;

fn functions(motion: &mut Motion<u8>, chosen: [usize; 4]) -> Functions {
    let mut all: Functions = Vec::new();
    for second in 1..4 {
        for first in 0..second {
            let Some(ratio) = Ratio::of(motion.gear(&[chosen[first], chosen[second]])) else { continue };
            let engaged = 1 << first | 1 << second;
            match all.iter_mut().find(|(known, _)| *known == ratio) {
                Some((_, known)) => *known |= engaged,
                None => all.push((ratio, engaged)),
            }
        }
    }
    all
}

/// Whether four of some functions are the gears at a point: two of them the free ones.
fn are_gears(functions: &Functions, wish: &Wish, k: &[f64]) -> bool {
    let values: Vec<f64> = functions.iter().map(|(ratio, _)| ratio.value(k)).collect();
    let within = |gear: usize| -> Vec<usize> {
        (0..values.len()).filter(|place| wish.gears[gear].contain(values[*place])).collect()
    };
    let [first, second, third, last] = [0, 1, 2, 3].map(within);
    first.iter().any(|first| {
        last.iter().any(|last| {
            second.iter().any(|second| {
                third.iter().any(|third| {
                    let of = [first, second, third, last].map(|place| functions[*place]);
                    values[*second] > values[*third]
                        && of.iter().fold(0, |all, (ratio, _)| all | ratio.variables()) == 0b11
                        && of.iter().fold(0, |all, (_, engaged)| all | engaged) == 0b1111
                })
            })
        })
    })
}

#[test]
fn trial_of_a_grid_finds_nothing_that_the_search_has_not() {
    let class = Class::new(Kind::Core, 2, 5).unwrap();
    let wish = two_free();
    let answer = all(class, &wish);
    assert_eq!(answer.tally.undecided, 0);
    let pairs = elements(class.links());
    let mut by_trial = 0;
    for structure in enumerate::all(class) {
        let mut motion = Motion::<u8>::new(structure.freedom());
        motion.take(&structure, &pairs);
        for chosen in (0..1u32 << pairs.len()).filter(|chosen| chosen.count_ones() == 4) {
            let mut places = (0..pairs.len()).filter(|place| chosen >> place & 1 == 1);
            let chosen: [usize; 4] = std::array::from_fn(|_| places.next().unwrap());
            if (0..4).any(|one| (0..one).any(|other| motion.tie_the_same(chosen[one], chosen[other]))) {
                continue;
            }
            let functions = functions(&mut motion, chosen);
            let at = |point: i32| [point % 32, point / 32].map(|step| 1.4 + 0.1 * f64::from(step));
            if functions.len() >= 4 && (0..32 * 32).any(|point| are_gears(&functions, &wish, &at(point))) {
                by_trial += 1;
                let chosen = chosen.map(|element| pairs[element]);
                assert!(holds(&answer.found, &structure, &chosen), "{structure} {chosen:?}");
            }
        }
    }
    assert!(by_trial > 20, "{by_trial} by trial, {} by the search", answer.found.len());
    let mut falling = 0;
    for found in &answer.found {
        let solution = &found.solution;
        let values: Vec<f64> = solution.gears.iter().map(|gear| gear.ratio.value(&solution.k)).collect();
        assert!(wish.are_falling(&values));
        let judged = judge(found, &wish, MeshEfficiency::IDEAL).unwrap();
        assert!(judged.ratios.iter().zip(&wish.gears).all(|(ratio, gear)| gear.contain(*ratio)));
        falling += usize::from(wish.are_falling(&judged.ratios));
        // The wanted ratios alone decide what is best.
        let ends = [0, 3].map(|gear| {
            let Bounds { least, most } = wish.gears[gear];
            (judged.ratios[gear] - 0.5 * (least + most)).abs() / (0.5 * (most - least))
        });
        assert!((judged.refined.deviation - ends[0].max(ends[1])).abs() < 1e-9, "{:?}", judged.refined);
    }
    assert_eq!(falling, answer.found.len(), "all fall at the best k, too");
}

#[test]
fn what_has_bounds_of_its_own_is_found_with_free_gears_as_well() {
    let class = Class::new(Kind::Core, 2, 5).unwrap();
    for shifts in [Shifts::default(), Shifts { neighbours: true, skips: false }] {
        let rules = Rules { shifts, ..Rules::default() };
        let free = Wish { rules, ..two_free() };
        let found = all(class, &free).found;
        let mut narrower = 0;
        for parted in [0.9, 1.2, 1.6, 2.1] {
            let mut wish = Wish { side_by_side: vec![], ..free.clone() };
            (wish.gears[1].least, wish.gears[2].most) = (parted * 1.000_001, parted);
            for one in all(class, &wish).found {
                let elements: Vec<Element> = one.solution.elements.iter().map(|pairs| pairs[0]).collect();
                assert!(holds(&found, &one.structure, &elements), "{} {elements:?}", one.structure);
                narrower += 1;
            }
        }
        assert!(narrower > 20, "{narrower}");
    }
}

/// Every choice of tooth numbers by trial: within the bounds, and the free gears in their order.
#[test]
fn tooth_numbers_keep_the_order_of_gears_side_by_side() {
    let class = Class::new(Kind::Core, 2, 5).unwrap();
    // So wide that the order of the free gears changes within it.
    let wish = two_free_within(0.2371);
    let bounds = synthesis::Bounds { ring: 70..=80, ..synthesis::Bounds::default() };
    let choice = Choice::within(&bounds).unwrap();
    // Tooth numbers that differ in the number of planets alone are one choice.
    let mut suns_and_rings: Vec<[f64; 2]> = Vec::new();
    for teeth in bounds.tooth_numbers().unwrap() {
        let pair = [teeth.sun.as_f64(), teeth.ring.as_f64()];
        if !suns_and_rings.contains(&pair) {
            suns_and_rings.push(pair);
        }
    }
    let k: Vec<f64> =
        suns_and_rings.iter().map(|[sun, ring]| ring / sun).filter(|k| (1.4..=4.5).contains(k)).collect();
    let (mut falling, mut in_any_order, mut told) = (0, 0, 0);
    for found in all(class, &wish).found {
        let ratios: Vec<Ratio> = found.solution.gears.iter().map(|gear| gear.ratio).collect();
        let gears = Gears { bounds: &wish.gears, side_by_side: &wish.side_by_side };
        let by_search = designs(
            &ratios,
            gears,
            &wish.k,
            Sets::apart(&[&choice, &choice]),
            (Alike::default(), Aim::Deviation, 5),
            &|| false,
        );
        assert!(by_search.complete);
        let mut by_trial = 0;
        for one in &k {
            for other in &k {
                let values: Vec<f64> = ratios.iter().map(|ratio| ratio.value(&[*one, *other])).collect();
                if wish.gears.iter().zip(&values).all(|(gear, value)| gear.contain(*value)) {
                    in_any_order += 1;
                    by_trial += u64::from(values[1] > values[2] * (1.0 + 1e-12));
                }
            }
        }
        assert_eq!(by_search.count, by_trial, "{}", found.structure);
        falling += by_trial;
        for design in &by_search.first {
            assert!(design.ratios.windows(2).all(|pair| pair[0] > pair[1]), "{:?}", design.ratios);
            // The ratios of free gears do not count.
            let off = [0, 3].map(|gear| {
                let Bounds { least, most } = wish.gears[gear];
                let value = *design.ratios[gear].numer() as f64 / *design.ratios[gear].denom() as f64;
                (value - 0.5 * (least + most)).abs() / (0.5 * (most - least))
            });
            assert!((design.deviation - off[0].max(off[1])).abs() < 1e-9);
            told += 1;
        }
    }
    assert!(falling > 100 && in_any_order > falling && told > 20, "{falling} of {in_any_order}, {told} told");
}

#[test]
fn gears_side_by_side_need_falling_bounds() {
    let class = Class::new(Kind::Core, 2, 5).unwrap();
    let wish = two_free();
    assert!(wish.check(class).is_ok());
    for side_by_side in [vec![vec![1, 3]], vec![vec![3, 0]], vec![vec![1, 1]], vec![vec![1, 4]], vec![]] {
        let refused = Wish { side_by_side, ..wish.clone() }.check(class).unwrap_err().to_string();
        assert!(refused.contains("side by side") || refused.contains("overlap"), "{refused}");
    }
}
