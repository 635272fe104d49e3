//! Tooth numbers of solutions with double-planet sets, against trial, the solver and its tooth checks.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::involute::check::Severity;
use epicyclic_gears::rack::BasicRack;
use epicyclic_gears::synthesis::{self, ToothNumbers};
use epicyclic_synthesis::judge::{judge, planet_speed};
use epicyclic_synthesis::parts::Bounds;
use epicyclic_synthesis::run::Found;
use epicyclic_synthesis::search::Search;
use epicyclic_synthesis::teeth::{Aim, Alike, Choice, Designs, Gears, SetTeeth, Sets, designs};
use epicyclic_synthesis::wish::Wish;
use epicyclic_synthesis::{Class, Kind, Structure};
use epicyclic_train::Gearbox;
use epicyclic_train::planet_set::Description;
use std::collections::BTreeSet;
use std::ops::RangeInclusive;

const SIX_HP: [f64; 7] = [4.171, 2.340, 1.521, 1.143, 0.867, 0.691, -3.403];

fn wish(ratios: &[f64], elements: usize, k: Vec<RangeInclusive<f64>>) -> Wish {
    let around = |ratio: &f64| Bounds { least: ratio - 0.01 * ratio.abs(), most: ratio + 0.01 * ratio.abs() };
    Wish { double_planets: 1, ..Wish::new(ratios.iter().map(around).collect(), elements, k) }
}

/// Solutions of the structures with one double-planet set among these sets.
fn solutions(class: Class, sets: &str, wish: &Wish) -> Vec<Found> {
    let simple: Structure = sets.parse().unwrap();
    let tagged = simple.with_double_planets(1);
    let of = |structure: &Structure| {
        let found = Search::<u8>::new(wish.clone(), class.links()).structure(structure);
        found.into_iter().map(|solution| Found { structure: structure.clone(), solution }).collect::<Vec<_>>()
    };
    tagged.iter().flat_map(of).collect()
}

fn all(found: &Found, wish: &Wish, choices: &[&Choice]) -> Designs {
    let ratios: Vec<_> = found.solution.gears.iter().map(|gear| gear.ratio).collect();
    designs(
        &ratios,
        Gears::apart(&wish.gears),
        &wish.k,
        Sets::apart(choices),
        (Alike::default(), Aim::Deviation, usize::MAX),
        &|| false,
    )
}

/// The gearbox of the solver with these teeth.
fn with_teeth(found: &Found, wish: &Wish, teeth: &[SetTeeth]) -> Gearbox {
    let judged = judge(found, wish, MeshEfficiency::IDEAL).unwrap();
    let mut teeth = teeth.iter();
    judged.gearbox.to_builder().map_sets(|set| teeth.next().unwrap().put_into(set)).build().unwrap()
}

#[test]
fn ratios_with_a_double_planet_set_are_those_of_the_solver_and_nothing_is_lost() {
    let class = Class::new(Kind::Core, 2, 4).unwrap();
    let k = vec![1.4..=4.5, 1.6 - 1.0..=4.5 - 1.0];
    let wish = wish(&[2.56, 1.465], 2, k);
    let found = solutions(class, "1-a-2 1-b-a", &wish);
    assert_eq!(found.len(), 1);
    assert_eq!(found[0].structure.to_string(), "1-a-2 1-a-b*");
    let bounds = synthesis::Bounds { ring: 60..=90, planets: 3..=4, ..synthesis::Bounds::default() };
    let simple = Choice::within(&bounds).unwrap();
    let real = synthesis::Bounds { ring_to_sun_ratio: 1.6..=4.5, ..bounds.clone() };
    let double = Choice::of_double_planets(&real).unwrap();
    let designs = all(&found[0], &wish, &[&simple, &double]);
    // By trial of all, with the ratios of the solver as fractions.
    let mut tried = Vec::new();
    let mut one_of_each: Vec<ToothNumbers> = bounds.tooth_numbers().unwrap();
    one_of_each.sort_by_key(|set| (set.sun, set.ring, std::cmp::Reverse(set.planets)));
    one_of_each.dedup_by_key(|set| (set.sun, set.ring));
    for one in one_of_each.iter().filter(|one| (1.4..=4.5).contains(&one.ring_to_sun_ratio())) {
        // (1 + k₁)·(1 + k₂′)/(1 + k₁ + k₂′) and 1 + k₁, over the suns; far fewer pass the second.
        let first = 1.0 + one.ring_to_sun_ratio();
        if !wish.gears[0].contain(first) {
            continue;
        }
        for two in real.double_planet_choices().unwrap().0 {
            let teeth = [SetTeeth::Simple(*one), SetTeeth::DoublePlanet(two)];
            let gearbox = with_teeth(&found[0], &wish, &teeth);
            let ratios: Vec<f64> = gearbox
                .gears()
                .iter()
                .map(|gear| gearbox.analyze_gear(gear).unwrap().ratio().unwrap())
                .collect();
            if ratios.iter().zip(&wish.gears).all(|(ratio, gear)| gear.contain(*ratio)) {
                tried.push(teeth);
            }
        }
    }
    let mut teeth: Vec<[SetTeeth; 2]> =
        designs.first.iter().map(|design| [design.sets[0], design.sets[1]]).collect();
    teeth.sort_unstable();
    tried.sort_unstable();
    assert!(designs.complete && teeth.len() > 30, "{}", teeth.len());
    assert_eq!(teeth, tried);
}

/// The 6HP's own 38 and 85 teeth of the second set leave 23.5 for a planet, which needs shifted profiles.
/// Other tooth numbers need none.
#[test]
fn a_6hp_has_tooth_numbers() {
    let class = Class::new(Kind::AllSparse, 3, 6).unwrap();
    let wish = wish(&SIX_HP, 5, vec![1.4..=4.5, 1.4..=4.5, 0.6..=3.5]);
    let found = solutions(class, "0-1-c x-2-h y-h-2", &wish);
    let real = found.iter().find(|found| {
        let k = &found.solution.k;
        [1.919, 2.237, 1.742].iter().zip(k).all(|(real, k)| (k / real - 1.0).abs() < 0.05)
    });
    let real = real.unwrap();
    let bounds = synthesis::Bounds { ring: 60..=110, planet: 14..=60, ..synthesis::Bounds::default() };
    let (simple, double) = (Choice::within(&bounds).unwrap(), Choice::of_double_planets(&bounds).unwrap());
    let judged = judge(real, &wish, MeshEfficiency::IDEAL).unwrap();
    let [compound] = &judged.sharing.compounds[..] else { panic!("{:?}", judged.sharing) };
    let sets = Sets {
        choices: &[&simple, &simple, &double],
        compounds: &judged.sharing.compounds,
        bounds: Some(&bounds),
    };
    let ratios: Vec<_> = real.solution.gears.iter().map(|gear| gear.ratio).collect();
    let gears = Gears::apart(&wish.gears);
    let designs =
        designs(&ratios, gears, &wish.k, sets, (Alike::default(), Aim::Deviation, usize::MAX), &|| false);
    assert!(designs.complete && designs.count > 10, "{}", designs.count);
    for design in designs.first.iter().take(50) {
        let [front, large, small] = design.sets[..] else { panic!("three sets") };
        assert_eq!(large.ring(), small.ring());
        let (SetTeeth::Simple(large), SetTeeth::DoublePlanet(small)) = (large, small) else {
            panic!("kinds")
        };
        assert_eq!((large.planet, large.planets), (small.outer, small.pairs));
        let builder = judged.gearbox.to_builder().map_descriptions(|set| match set {
            Description::Short(set) => front.put_into(set).into(),
            Description::Compound(set) => compound.put_into(set, &design.sets).into(),
        });
        let gearbox = builder.build().unwrap();
        for (gear, ratio) in gearbox.gears().iter().zip(&design.ratios) {
            let (analysis, without_teeth) =
                (gearbox.analyze_gear(gear).unwrap(), judged.gearbox.analyze(gear.name()).unwrap());
            assert_eq!(analysis.exact_ratio().as_ref(), Some(ratio));
            // Each planet's speed follows from the teeth; without them a bound is told, at nearly the same k.
            let [_, motion] = analysis.sets() else { panic!("two sets") };
            let greatest =
                motion.planets.iter().map(|planet| planet.unwrap().relative.abs()).fold(0.0, f64::max);
            assert!(planet_speed(&analysis) >= greatest);
            assert!(planet_speed(&without_teeth) <= 1.1 * planet_speed(&analysis));
        }
        let all = gearbox.set_checks(&BasicRack::default(), |_| vec![]).checks;
        let missed = all.iter().filter(|check| check.miss.is_some() && check.severity > Severity::Remark);
        let missed: BTreeSet<&str> = missed.map(|check| check.rule).collect();
        assert!(missed.is_subset(&BTreeSet::from(["undercut", "full-tips"])), "{missed:?}");
    }
}

#[test]
fn sets_of_two_kinds_with_equal_teeth_are_not_alike() {
    let class = Class::new(Kind::Core, 2, 4).unwrap();
    let wish = wish(&[2.56, 1.465], 2, vec![1.4..=4.5, 0.6..=3.5]);
    let found = &solutions(class, "1-a-2 1-b-a", &wish)[0];
    let ratios: Vec<_> = found.solution.gears.iter().map(|gear| gear.ratio).collect();
    let bounds = synthesis::Bounds::default();
    let (simple, double) = (Choice::within(&bounds).unwrap(), Choice::of_double_planets(&bounds).unwrap());
    let count = |alike| {
        designs(
            &ratios,
            Gears::apart(&wish.gears),
            &wish.k,
            Sets::apart(&[&simple, &double]),
            (alike, Aim::Teeth, 3),
            &|| false,
        )
        .count
    };
    assert_eq!(count(Alike { sets: 2, ..Alike::default() }), 0);
    let (any, rings) = (count(Alike::default()), count(Alike { rings: 2, ..Alike::default() }));
    assert!(rings > 0 && rings < any, "{rings} of {any}");
}
