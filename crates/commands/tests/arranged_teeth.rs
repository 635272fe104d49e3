//! Sets that `teeth` finds, held against the gearbox that they make: its ratio, assembly and clearances.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use epicyclic_commands::teeth::{ArrangedSets, Request};
use epicyclic_commands::words::request;
use epicyclic_gears::rack::BasicRack;
use epicyclic_train::tooth_checks::PlanetFit;
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
                let is_shifted = set.gears.iter().any(|gear| gear.profile_shift != 0.0);
                shifted += usize::from(is_shifted);
                assert!(fit.clears == Some(true) || is_shifted && fit.clears.is_none(), "{fit:?} {of}");
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
        ("--kind stepped --ratio 14 --ring-offset 1 --aim tip-alteration", "--aim"),
        ("--kind stepped --ratio 14 --ring-offset 1 --tip-thickness 0.3", "--tip-thickness"),
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
