//! The search against known gearboxes, planted ones, and trial of a grid.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use crate::common;
use crate::found;

use common::Random;
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_synthesis::judge::{judge, judge_all};
use epicyclic_synthesis::motion::{Motion, elements};
use epicyclic_synthesis::parts::Bounds;
use epicyclic_synthesis::ratio::Ratio;
use epicyclic_synthesis::rules::Rules;
use epicyclic_synthesis::run::{Answer, Found, Share, search};
use epicyclic_synthesis::search::Search;
use epicyclic_synthesis::structure::link_name;
use epicyclic_synthesis::ternary::Word;
use epicyclic_synthesis::wish::Wish;
use epicyclic_synthesis::{Class, Kind, Structure, enumerate};
use epicyclic_train::set::SetKind;
use std::ops::ControlFlow;

const SIX_SPEED: [f64; 7] = [3.48718, 1.86429, 1.40276, 1.0, 0.75198, 0.6525, -4.9325];
const FOUR_L60_E: [f64; 5] = [3.059, 1.625, 1.0, 0.696, -2.294];
const SIX_HP: [f64; 7] = [4.171, 2.340, 1.521, 1.143, 0.867, 0.691, -3.403];
const EIGHT_HP: [f64; 9] = [4.714, 3.143, 2.106, 1.667, 1.285, 1.0, 0.839, 0.667, -3.295];
const NINE_G: [f64; 10] = [5.503, 3.333, 2.315, 1.661, 1.211, 1.0, 0.865, 0.717, 0.601, -4.932];

fn around(ratio: f64, tolerance: f64) -> Bounds {
    Bounds { least: ratio - tolerance * ratio.abs(), most: ratio + tolerance * ratio.abs() }
}

fn wish(ratios: &[f64], sets: usize, elements: usize) -> Wish {
    let gears = ratios.iter().map(|ratio| around(*ratio, 0.01)).collect();
    Wish::new(gears, elements, vec![1.4..=4.5; sets])
}

fn all(class: Class, wish: &Wish, threads: usize) -> Answer {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    pool.install(|| search(class, wish, Share::WHOLE, &|_| ControlFlow::Continue(())).unwrap())
}

/// Whether a structure with these elements, by the letters of its text, is among what was found.
fn holds(found: &[Found], structure: &str, wanted: &[&str]) -> bool {
    let (structure, letters) = Structure::read(structure).unwrap();
    let pair = |name: &str| {
        let mut links: Vec<u8> = name
            .split('-')
            .map(|letter| letters.iter().position(|known| letter == known.to_string()).unwrap() as u8)
            .collect();
        if links.len() == 1 {
            links.push(0);
        }
        links.sort_unstable();
        [links[0], links[1]]
    };
    let wanted: Vec<[u8; 2]> = wanted.iter().map(|name| pair(name)).collect();
    found::holds(found, &structure, &wanted)
}

/// Every solution by the solver: each gear within its bounds.
fn confirm(answer: &Answer, wish: &Wish) {
    for found in &answer.found {
        let judged = judge(found, wish, MeshEfficiency::IDEAL).unwrap();
        for (ratio, bounds) in judged.ratios.iter().zip(&wish.gears) {
            assert!(bounds.contain(*ratio), "{}: {ratio}", found.structure);
        }
        assert!(judged.refined.deviation <= 1.0 + 1e-9);
        for (k, [least, most]) in judged.refined.k.iter().zip(&judged.refined.ranges) {
            assert!(least <= k && k <= most, "{}: {k} in {least}…{most}", found.structure);
        }
    }
}

#[test]
fn a_six_speed_of_three_sets_has_43_sets_of_elements_in_42_structures() {
    let class = Class::new(Kind::AllSparse, 3, 6).unwrap();
    let wish = wish(&SIX_SPEED, 3, 5);
    let answer = all(class, &wish, 1);
    let mut structures: Vec<&Structure> = answer.found.iter().map(|found| &found.structure).collect();
    structures.dedup();
    assert_eq!((answer.found.len(), structures.len()), (43, 42));
    assert_eq!((answer.tally.undecided, answer.tally.reducible), (0, 0));
    confirm(&answer, &wish);
    // Threads and shares change nothing.
    assert_eq!(all(class, &wish, 3), answer);
    let shares = (0..3).flat_map(|number| {
        search(class, &wish, Share { number, of: 3 }, &|_| ControlFlow::Continue(())).unwrap().found
    });
    let mut shares: Vec<Found> = shares.collect();
    shares.sort_by(|one, other| {
        (&one.structure, &one.solution.elements).cmp(&(&other.structure, &other.solution.elements))
    });
    assert_eq!(shares, answer.found);
}

#[test]
fn the_4l60_e_and_the_6hp_come_out_of_their_ratios() {
    let four = wish(&FOUR_L60_E, 2, 5);
    let answer = all(Class::new(Kind::AllSparse, 2, 5).unwrap(), &four, 1);
    confirm(&answer, &four);
    assert!(holds(&answer.found, "x-h-2 y-2-h", &["y", "h", "1-x", "1-h", "1-y"]));
    let six = wish(&SIX_HP, 3, 5);
    let answer = all(Class::new(Kind::AllSparse, 3, 6).unwrap(), &six, 1);
    confirm(&answer, &six);
    // Its third set has double planets: for speeds a simple set with ring and carrier exchanged.
    assert!(holds(&answer.found, "0-1-c x-2-h y-h-2", &["x", "h", "c-x", "c-y", "1-h"]));
}

#[test]
fn the_6hp_is_found_with_its_double_planet_set() {
    let class = Class::new(Kind::AllSparse, 3, 6).unwrap();
    let mut wish = wish(&SIX_HP, 3, 5);
    (wish.k[2], wish.double_planets) = (0.6..=3.5, 1);
    let simple: Structure = "0-1-c x-2-h y-h-2".parse().unwrap();
    let mut found = 0;
    for structure in simple.with_double_planets(1) {
        let mut search = Search::<u8>::new(wish.clone(), class.links());
        for solution in search.structure(&structure) {
            let one = Found { structure: structure.clone(), solution };
            let judged = judge(&one, &wish, MeshEfficiency::new(0.97).unwrap()).unwrap();
            assert!(judged.ratios.iter().zip(&wish.gears).all(|(ratio, gear)| gear.contain(*ratio)));
            // Two of its sets may be one compound set, which is drawn as the two.
            let of_kind = |kind: SetKind| {
                let sets = judged.gearbox.drawn_sets().iter().filter(move |set| set.kind == kind);
                sets.map(|set| set.basic_ratio(&judged.gearbox).abs()).collect::<Vec<f64>>()
            };
            let (simple, double) = (of_kind(SetKind::Simple), of_kind(SetKind::DoublePlanet));
            assert_eq!((simple.len(), double.len()), (2, 1));
            // k 1.919, 2.237 and 2.742 of the real box.
            let k = [simple, double].concat();
            found += usize::from(
                [1.919, 2.237, 2.742].iter().zip(&k).all(|(real, k)| (k / real - 1.0).abs() < 0.02),
            );
        }
    }
    assert_eq!(found, 1);
}

#[test]
fn tags_of_double_planet_sets_that_an_automorphism_exchanges_are_one() {
    let mut tagged = 0;
    for structure in enumerate::all(Class::new(Kind::Core, 3, 5).unwrap()) {
        let automorphisms = structure.automorphisms();
        // Burnside: sets of one place that each automorphism keeps.
        let fixed: usize = automorphisms
            .iter()
            .map(|order| order.iter().enumerate().filter(|(place, set)| place == *set).count())
            .sum();
        let all = structure.with_double_planets(1);
        assert_eq!(all.len() * automorphisms.len(), fixed, "{structure}");
        assert_eq!(structure.with_double_planets(0), std::slice::from_ref(&structure));
        tagged += all.len();
    }
    assert!(tagged > 3 * 3000);
}

#[test]
fn the_8hp_and_the_9g_tronic_are_the_only_solution_of_their_structures() {
    for (structure, ratios, wanted) in [
        ("a-b-c a-d-1 d-f-g f-c-2", &EIGHT_HP[..], &["a", "b", "1-f", "g-2", "d-f"][..]),
        ("1-b-a c-x-b x-r-2 x-2-d", &NINE_G[..], &["a", "c", "r", "a-x", "1-d", "1-a"][..]),
    ] {
        let wish = wish(ratios, 4, wanted.len());
        let structure_read: Structure = structure.parse().unwrap();
        let found: Vec<Found> = Search::<u16>::new(wish.clone(), 8)
            .structure(&structure_read)
            .into_iter()
            .map(|solution| Found { structure: structure_read.clone(), solution })
            .collect();
        assert_eq!(found.len(), 1, "{structure}");
        assert!(holds(&found, structure, wanted), "{structure}: {:?}", found[0].solution.elements);
    }
}

/// Plants random gearboxes of a class and seeks them in their own structure; one in so many in the whole
/// class.
fn planted<W: Word>(class: Class, count: usize, elements_of: usize, gears: usize, whole_class_every: usize) {
    let structures = enumerate::all(class);
    let mut random = Random(0x2545_f491_4f6c_dd1d);
    let pairs = elements(class.links());
    let mut planted = 0;
    while planted < count {
        let structure = &structures[random.below(structures.len())];
        let mut chosen: Vec<usize> = Vec::new();
        while chosen.len() < elements_of {
            let element = random.below(pairs.len());
            if !chosen.contains(&element) {
                chosen.push(element);
            }
        }
        let k: Vec<f64> =
            (0..class.sets()).map(|_| 1.5 + 2.8 * random.below(100_003) as f64 / 100_003.0).collect();
        let mut motion = Motion::<W>::new(structure.freedom());
        let kept: Vec<_> = chosen.iter().map(|element| pairs[*element]).collect();
        motion.take(structure, &kept);
        // The different ratios of all choices of the elements.
        let mut ratios: Vec<Ratio> = Vec::new();
        motion.for_each_gear(&mut |_, last| {
            for speeds in last {
                if let Some(ratio) = Ratio::of(*speeds)
                    && !ratios.contains(&ratio)
                {
                    ratios.push(ratio);
                }
            }
        });
        let moved = ratios.iter().fold(0, |all, ratio| all | ratio.variables());
        let values: Vec<f64> = ratios.iter().map(|ratio| ratio.value(&k)).collect();
        let apart = (0..values.len()).all(|one| {
            (0..one).all(|other| {
                (values[one] - values[other]).abs() > 0.025 * values[one].abs().max(values[other].abs())
            })
        });
        let usual = values.iter().all(|value| (0.05..20.0).contains(&value.abs()));
        if values.len() < gears || moved + 1 != 1 << class.sets() || !apart || !usual {
            continue;
        }
        planted += 1;
        let wish = wish(&values, class.sets(), elements_of);
        let found: Vec<Found> = if planted % whole_class_every == 0 {
            all(class, &wish, 2).found
        } else {
            let solutions = Search::<W>::new(wish, class.links()).structure(structure).into_iter();
            solutions.map(|solution| Found { structure: structure.clone(), solution }).collect()
        };
        let letters = |link: u8| link_name(link).to_string();
        let names: Vec<String> =
            kept.iter()
                .map(|[one, other]| {
                    if *one == 0 { letters(*other) } else { format!("{}-{}", letters(*one), letters(*other)) }
                })
                .collect();
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        // Elements that lock the same count once, so the set may be a smaller one; then it is not sought
        // here.
        let distinct = {
            let mut motion = Motion::<W>::new(structure.freedom());
            motion.take(structure, &kept);
            (0..kept.len()).all(|one| (0..one).all(|other| !motion.tie_the_same(one, other)))
        };
        assert!(
            !distinct || holds(&found, &structure.to_string(), &names),
            "{structure} {names:?} {k:?} {values:?}"
        );
    }
}

/// `PLANTED=10` plants ten times as many, those of two and three sets all in their whole class.
#[test]
fn planted_gearboxes_of_two_to_four_sets_are_found() {
    let class = |kind, sets, links| Class::new(kind, sets, links).unwrap();
    let times = std::env::var("PLANTED").map_or(1, |times| times.parse().unwrap());
    let every = if times > 1 { 1 } else { 10 };
    planted::<u8>(class(Kind::AllSparse, 2, 5), 30 * times, 4, 4, every);
    planted::<u8>(class(Kind::AllSparse, 3, 6), 30 * times, 4, 5, every);
    planted::<u16>(class(Kind::Core, 4, 8), 5 * times, 5, 6, usize::MAX);
}

/// Every set of three elements of every structure, at every point of a grid of k: those with all gears at
/// some point must be among the solutions. How many there were.
fn found_by_trial(class: Class, ratios: [f64; 3]) -> usize {
    let gears: Vec<Bounds> = ratios.iter().map(|ratio| around(*ratio, 0.05)).collect();
    let wish = Wish::new(gears, 3, vec![1.5..=4.0; 2]);
    let answer = all(class, &wish, 1);
    let pairs = elements(class.links());
    let mut by_trial = 0;
    for structure in enumerate::all(class) {
        let mut motion = Motion::<u8>::new(structure.freedom());
        motion.take(&structure, &pairs);
        let mut ratio_of = |engaged: [usize; 2]| {
            let speeds = motion.gear(&engaged);
            Ratio::of(speeds)
        };
        for chosen in (0..pairs.len() * pairs.len() * pairs.len())
            .map(|code| {
                [code % pairs.len(), code / pairs.len() % pairs.len(), code / pairs.len() / pairs.len()]
            })
            .filter(|[first, second, third]| first < second && second < third)
        {
            let [first, second, third] = chosen;
            let ratios = [[first, second], [first, third], [second, third]].map(&mut ratio_of);
            let ratios: Vec<Ratio> = ratios.into_iter().flatten().collect();
            if ratios.len() < 3 || ratios.iter().fold(0, |all, ratio| all | ratio.variables()) != 0b11 {
                continue;
            }
            let hit = (0..26 * 26).any(|point| {
                let k = [point % 26, point / 26].map(|step| 1.5 + 0.1 * f64::from(step));
                let values: Vec<f64> = ratios.iter().map(|ratio| ratio.value(&k)).collect();
                wish.gears.iter().all(|gear| values.iter().any(|value| gear.contain(*value)))
            });
            if hit {
                by_trial += 1;
                let names = chosen.map(|element| pairs[element].map(|link| link_name(link).to_string()));
                let names =
                    names.map(|[one, other]| if one == "0" { other } else { format!("{one}-{other}") });
                let names = names.each_ref().map(String::as_str);
                assert!(
                    holds(&answer.found, &structure.to_string(), &names),
                    "{structure} {names:?} was not found"
                );
            }
        }
    }
    by_trial
}

#[test]
fn trial_of_a_grid_finds_nothing_that_the_search_has_not() {
    let class = Class::new(Kind::Core, 2, 5).unwrap();
    let found = [[2.8, 1.0, -2.1], [3.0, 1.6, 0.7]].map(|ratios| found_by_trial(class, ratios));
    assert!(found.iter().sum::<usize>() > 0, "{found:?}");
}

#[test]
fn wishes_that_nothing_can_have_are_refused() {
    let class = Class::new(Kind::Core, 2, 4).unwrap();
    let usual = wish(&[2.5, 1.5], 2, 2);
    for (wish, why) in [
        (Wish { gears: vec![], ..usual.clone() }, "0 gears"),
        (Wish { gears: vec![around(2.5, 0.01), around(2.51, 0.01)], ..usual.clone() }, "overlap"),
        (Wish { gears: vec![Bounds { least: -1.0, most: 1.0 }], ..usual.clone() }, "one sign"),
        (
            Wish { gears: [2.5, 1.5, 4.0].map(|ratio| around(ratio, 0.01)).into(), ..usual.clone() },
            "give 2 at most",
        ),
        (Wish { elements: 0, gears: vec![around(2.5, 0.01)], ..usual.clone() }, "engages 1"),
        (Wish { k: vec![3.0..=2.0; 2], ..usual.clone() }, "range is empty"),
        (Wish { k: vec![1.4..=4.5; 3], ..usual.clone() }, "3 ranges of k for 2 planet sets"),
        (Wish { elements: 20, ..usual.clone() }, "there may be 8 at most"),
        (
            Wish { rules: Rules { direct: true, ..Rules::default() }, ..usual.clone() },
            "no gear may have the ratio 1",
        ),
        (
            Wish { rules: Rules { brakes: 0..=0, clutches: 0..=1, ..Rules::default() }, ..usual.clone() },
            "2 shift elements are not 0 to 0 brakes and 0 to 1 clutches",
        ),
    ] {
        let message =
            search(class, &wish, Share::WHOLE, &|_| ControlFlow::Continue(())).unwrap_err().to_string();
        assert!(message.contains(why), "{message}");
    }
}

#[test]
fn a_search_that_is_ended_keeps_what_it_has() {
    let class = Class::new(Kind::AllSparse, 3, 6).unwrap();
    let wish = wish(&SIX_SPEED, 3, 5);
    let end = |progress: epicyclic_synthesis::run::Progress| {
        if progress.found > 0 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let answer = search(class, &wish, Share::WHOLE, &end).unwrap();
    assert!(!answer.complete && !answer.found.is_empty() && answer.tally.structures < 24_702);
}

/// Bounds of round numbers that gears reach together at one point, or along a line, where they are at their
/// bounds: `k₂·k₃` up to 3.6·1.05 beside `k₂ ≥ 3·0.9` and `k₃ ≥ 1.4`. Without a point there all of the line
/// would be halved to the smallest boxes, 10⁷ of them.
#[test]
fn gears_that_meet_at_their_bounds_alone_are_found() {
    let ratios = [3.6, 2.2, 1.4, 1.0, 0.7, -3.0];
    let gears: Vec<Bounds> =
        ratios.iter().zip([0.05, 0.05, 0.05, 0.025, 0.05, 0.1]).map(|(ratio, t)| around(*ratio, t)).collect();
    let wish = Wish::new(gears.clone(), 5, vec![1.4..=4.5; 3]);
    let mut search = Search::<u8>::new(wish.clone(), 6);
    for (structure, count) in [("0-1-a 1-b-0 c-2-d", 1), ("0-a-2 1-b-c a-c-d", 3), ("0-2-a b-1-c b-d-a", 1)] {
        let structure: Structure = structure.parse().unwrap();
        let found = search.structure(&structure);
        assert_eq!(found.len(), count, "{structure}");
        let at_bounds = found.iter().filter(|solution| {
            let near = |gear: &Bounds, ratio: f64| {
                [gear.least, gear.most].iter().any(|bound| (ratio / bound - 1.0).abs() < 2e-8)
            };
            let ratios = solution.gears.iter().map(|gear| gear.ratio.value(&solution.k));
            let met = gears.iter().zip(ratios).filter(|(gear, ratio)| near(gear, *ratio));
            met.count() >= 2
        });
        assert!(at_bounds.count() >= 1, "{structure}: {found:?}");
        for solution in found {
            let found = Found { structure: structure.clone(), solution };
            let judged = judge(&found, &wish, MeshEfficiency::IDEAL).unwrap();
            for (gear, ratio) in gears.iter().zip(&judged.ratios) {
                let widened = around(
                    0.5 * (gear.least + gear.most),
                    0.5 * (gear.most - gear.least) / (0.5 * (gear.least + gear.most)).abs() + 1e-7,
                );
                assert!((widened.least..=widened.most).contains(ratio), "{ratio} {gear:?}");
            }
        }
    }
    assert_eq!(search.take_tally().undecided, 0);
}

#[test]
fn a_structure_whose_search_is_ended_is_not_counted() {
    let structure: Structure = "a-b-c a-d-1 d-f-g f-c-2".parse().unwrap();
    let mut search = Search::<u16>::new(wish(&EIGHT_HP, 4, 5), 8);
    assert_eq!(search.structure_unless(&structure, &|| true), None);
    assert_eq!(search.take_tally(), epicyclic_synthesis::tally::Tally::default());
    let found = search.structure_unless(&structure, &|| false);
    assert_eq!(found.map(|found| found.len()), Some(1));
    assert_eq!(search.take_tally().structures, 1);
}

#[test]
fn judging_that_is_ended_leaves_the_rest_unjudged() {
    let class = Class::new(Kind::AllSparse, 2, 5).unwrap();
    let wish = wish(&FOUR_L60_E, 2, 5);
    let found = all(class, &wish, 1).found;
    let all_of_them =
        judge_all(&found, &wish, MeshEfficiency::IDEAL, &|_| ControlFlow::Continue(())).unwrap();
    assert!(all_of_them.iter().all(Option::is_some));
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    let ended = pool.install(|| {
        judge_all(&found, &wish, MeshEfficiency::IDEAL, &|done| {
            if done < 3 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
        })
    });
    let ended = ended.unwrap();
    assert_eq!((ended.len(), ended.iter().flatten().count()), (found.len(), 3));
    assert!(ended.iter().zip(&all_of_them).all(|(one, other)| one.is_none() || one == other));
}
