//! Sets that `teeth` finds, held against the gearbox that they make: its ratio, assembly and clearances.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use epicyclic_commands::shared::gearbox::Gearbox as File;
use epicyclic_commands::teeth::{ArrangedNumbers, ArrangedSets, Request};
use epicyclic_commands::words::request;
use epicyclic_gears::rack::BasicRack;
use epicyclic_train::planet_set::GearOf;
use epicyclic_train::tooth_checks::PlanetFit;
use epicyclic_train::{Gearbox, PlanetSet};
use std::collections::BTreeMap;
use std::ops::ControlFlow;

fn asked(words: &str) -> Request {
    request(words.split_ascii_whitespace()).unwrap()
}

fn found(request: &Request) -> ArrangedSets {
    request.answer_arranged(|_| ControlFlow::Continue(())).unwrap()
}

const REQUESTS: [&str; 15] = [
    "--kind stepped --ratio 14",
    "--kind stepped --ratio 20 --module-ratio 1.25,4/5,3/2",
    "--kind stepped --ratio 14 --spacing least-unequal --gear a=17..20",
    "--kind stepped --ratio 14 --angles 0deg,80deg,180deg,260deg",
    "--kind stepped --ratio -9 --mode ab^H --ring-offset -1..1 --tolerance 0.02%",
    "--kind stepped-suns --ratio 40",
    "--kind stepped-rings --ratio -35 --mode Hb^e",
    "--kind stepped-rings --ratio 25 --ring-offset -1..1 --tolerance 0.2%",
    "--kind wolfrom --ratio 51",
    "--kind wolfrom --ratio 100 --ring-offset -2..2 --tolerance 0.1%",
    "--kind wolfrom --ratio 0.02 --mode ea^b",
    "--kind ravigneaux --ratio 1.5 --gear a=28..36",
    "--kind ravigneaux --ratio 1.5382 --ring-offset -1..1 --gear c=38,b=80..90 --tolerance 0.1%",
    "--kind pair --ratio -2.5",
    "--kind pair --ratio 2.5",
];

/// Compares the shifted gears of a set in mesh with those printed.
fn is_closed(set: &ArrangedNumbers, own: &PlanetSet, of: &str) {
    let toothed = own.toothed(&BasicRack::default(), &[]).unwrap();
    for mesh in &toothed.meshes {
        assert!(mesh.pair.backlash().abs() < 1e-9, "{} {of}", mesh.pair.backlash());
    }
    let same = |one: f64, other: f64| assert!((one - other).abs() < 1e-12, "{one} {other} {of}");
    let mut centrals = 0;
    for printed in &set.gears {
        let is_planet = ["step", "planet"].iter().any(|word| printed.gear.contains(word));
        let place = if !is_planet {
            centrals += 1;
            GearOf::Central(centrals - 1)
        } else {
            match (own.planets(), printed.letter) {
                ([_, _], 'f') => GearOf::Planet(1, 0),
                ([one], 'f') if one.gears.len() == 2 => GearOf::Planet(0, 1),
                _ => GearOf::Planet(0, 0),
            }
        };
        let gear = toothed.gear(place).unwrap();
        assert_eq!(gear.teeth().get(), printed.teeth, "{of}");
        same(gear.shift(), printed.profile_shift);
        same(gear.tip_alteration(), printed.tip_alteration);
        assert!(gear.tip_thickness() >= 0.2 - 1e-9, "{of}");
    }
}

/// A saved set is read with the same teeth, to the last digit.
#[test]
fn a_saved_set_keeps_its_shifts_tips_and_tools() {
    for words in [
        "--kind ravigneaux --ratio 1.5382 --ring-offset -1..1 --gear a=31,g=20,c=38,b=85 --tolerance 0.1%",
        "--kind wolfrom --ratio 100 --ring-offset -2..2 --tolerance 0.1%",
        "--kind stepped --ratio 14 --ring-offset 1 --module-ratio 5/4 --tolerance 0.1% --aim tip-alteration",
    ] {
        let request = asked(words);
        let answer = found(&request);
        let (number, set) = (1..).zip(&answer.tooth_numbers).find(|(_, set)| set.aim_met.is_some()).unwrap();
        let gearbox = set.gearbox(&request).unwrap();
        let text = epicyclic_formats::gearbox::written(&gearbox, &[]).unwrap();
        let read = File::parse("set.yaml", text.as_bytes()).unwrap().train;
        // A file may have its planets in another order.
        let toothed = |gearbox: &Gearbox| {
            let set = &gearbox.sets()[0];
            let toothed = set.toothed(&BasicRack::default(), &[]).unwrap();
            let gear = |of: GearOf| (set.gear_name(of), *toothed.gear(of).unwrap());
            set.gears().into_iter().map(gear).collect::<BTreeMap<_, _>>()
        };
        assert_eq!(toothed(&read), toothed(&gearbox), "{words} {number} {text}");
        let missed = |gearbox: &Gearbox| gearbox.tooth_checks(&BasicRack::default());
        assert_eq!((missed(&read), missed(&gearbox)), (vec![], vec![]), "{words} {number} {text}");
    }
}

#[test]
fn every_set_found_is_accepted_by_the_checks_of_a_gearbox() {
    for words in REQUESTS {
        let request = asked(words);
        let answer = found(&request);
        // Of long lists every so many.
        let step = answer.tooth_numbers.len().div_ceil(250);
        let mut shifted = 0;
        for set in answer.tooth_numbers.iter().step_by(step) {
            let gearbox = set.gearbox(&request).unwrap();
            let of = format!("{words}: {set:?}");
            let ratio = gearbox.analyze("1").unwrap().exact_ratio().unwrap();
            assert_eq!(
                (*ratio.numer(), *ratio.denom()),
                (set.exact_ratio.numerator, set.exact_ratio.denominator),
                "{of}"
            );
            let warnings = gearbox.tooth_checks(&BasicRack::default());
            let is_fault = |warning: &&String| {
                ["assembl", "overlap", "centre distance", "clear"].iter().any(|word| warning.contains(word))
            };
            assert_eq!(warnings.iter().find(is_fault), None, "{of}");
            if set.planets.is_some() {
                let own = &gearbox.sets()[0];
                assert_eq!(own.assembly_positions().filter(|all| *all > 0), set.assembly_positions, "{of}");
                let fit = own.planet_fit(&BasicRack::default());
                assert_eq!(fit.assembles, Some(true), "{of}");
                assert_eq!(fit.clears, Some(true), "{of}");
                if set.aim_met.is_some() {
                    shifted += 1;
                    is_closed(set, own, &of);
                    let missed = gearbox.set_checks(&BasicRack::default(), |_| vec![]);
                    assert_eq!(missed.warnings().next(), None, "{of}");
                }
            }
        }
        assert_eq!(shifted > 0, words.contains("offset"), "{words}");
    }
    // A set that does not assemble is one that the checks refuse.
    let mut set = found(&asked(REQUESTS[0])).tooth_numbers.remove(0);
    set.planets = Some(5);
    let fit = set.gearbox(&asked(REQUESTS[0])).unwrap().sets()[0].planet_fit(&BasicRack::default());
    assert!(matches!(fit, PlanetFit { assembles: Some(false), .. }), "{fit:?}");
}

#[test]
fn options_of_other_kinds_are_refused() {
    for (words, option) in [
        ("--kind stepped --ratio 14 --k 2..3", "--k"),
        ("--kind stepped --ratio 14 --ring-offset 10", "--ring-offset"),
        ("--kind stepped --ratio 14 --ring-offset 1 --tip-thickness -0.1", "--tip-thickness"),
        ("--kind stepped --ratio 14 --mode ae^b", "--mode"),
        ("--kind stepped --ratio 14 --gear e=20", "--gear"),
        ("--kind stepped --ratio 14 --angles 0deg", "--angles"),
        ("--kind ravigneaux --ratio 1.5 --module-ratio 1.25", "--module-ratio"),
        ("--kind pair --ratio 2 --ring-offset 1", "--ring-offset"),
        ("--kind pair --ratio 2 --angles 0deg,180deg", "--angles"),
    ] {
        let failure = asked(words).answer_arranged(|_| ControlFlow::Continue(())).unwrap_err().to_string();
        assert!(failure.starts_with(&format!("{option}: ")), "{words}: {failure}");
    }
    for (words, option) in [
        ("--ratio 6 --gear a=20", "--gear"),
        ("--ratio 6 --module-ratio 2", "--module-ratio"),
        ("--ratio 6 --angles 0deg,180deg", "--angles"),
        ("--ratio 6 --mode ae^b", "--mode"),
        ("--ratio -1.6 --kind double-planet --ring-offset 1", "--ring-offset"),
    ] {
        let request = asked(words);
        let failure = request.answer(|_| ControlFlow::Continue(())).unwrap_err().to_string();
        assert!(failure.starts_with(&format!("{option}: ")), "{words}: {failure}");
    }
}

#[test]
fn a_kind_has_one_answer_by_either_spelling() {
    let [short, long] = ["--ratio -1.6 --double-planet", "--ratio -1.6 --kind double-planet"]
        .map(|words| asked(words).answer_double_planet(|_| ControlFlow::Continue(())).unwrap());
    assert_eq!(short, long);
}
