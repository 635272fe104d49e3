//! Every limit of every rule, as numbers: a value just inside and one just outside.
//!
//! The numbers are written here once more, so that a changed limit is seen.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use Severity::{Error, Remark, Warning};
use epicyclic_judge::{Limits, Range, Rule, Severity, Verdict};

/// Rule, value inside, value outside, severity outside.
const ENDS: &[(&str, f64, f64, Severity)] = &[
    ("face-width", 0.501, 0.499, Remark),
    ("face-width", 1.099, 1.101, Remark),
    ("face-width", 0.401, 0.399, Warning),
    ("face-width", 1.199, 1.201, Warning),
    ("face-width", 1.999, 2.001, Error),
    ("specific-sliding", 1.99, 2.01, Remark),
    ("specific-sliding", 2.99, 3.01, Warning),
    ("sun-shift", 0.201, 0.199, Remark),
    ("sun-shift", 0.649, 0.651, Remark),
    ("sun-shift", 0.001, -0.001, Warning),
    ("sun-shift", 0.849, 0.851, Warning),
    ("sun-shift", -0.999, -1.001, Error),
    ("sun-shift", 0.999, 1.001, Error),
    ("planet-shift", -0.199, -0.201, Remark),
    ("planet-shift", 0.549, 0.551, Remark),
    ("planet-shift", -0.399, -0.401, Warning),
    ("planet-shift", 0.849, 0.851, Warning),
    ("planet-shift", -0.999, -1.001, Error),
    ("planet-shift", 0.999, 1.001, Error),
    ("ring-shift", -0.599, -0.601, Remark),
    ("ring-shift", 0.499, 0.501, Remark),
    ("ring-shift", -0.799, -0.801, Warning),
    ("ring-shift", 0.699, 0.701, Warning),
    ("ring-shift", -0.999, -1.001, Error),
    ("ring-shift", 0.999, 1.001, Error),
    ("gear-shift", -0.199, -0.201, Remark),
    ("gear-shift", 0.849, 0.851, Remark),
    ("gear-shift", -0.599, -0.601, Warning),
    ("gear-shift", 0.949, 0.951, Warning),
    ("gear-shift", -0.999, -1.001, Error),
    ("gear-shift", 0.999, 1.001, Error),
    ("shift-sum", 0.001, -0.001, Warning),
    ("shift-sum", 1.449, 1.451, Warning),
    ("external-angle", 20.01, 19.99, Warning),
    ("external-angle", 28.49, 28.51, Warning),
    ("internal-angle", 15.01, 14.99, Warning),
    ("internal-angle", 21.99, 22.01, Warning),
    ("hardened-tips", 0.401, 0.399, Warning),
    ("spur-contact", 1.301, 1.299, Remark),
    ("spur-contact", 1.201, 1.199, Warning),
    ("spur-contact", 1.101, 1.099, Error),
    ("helical-contact", 1.201, 1.199, Error),
    ("root-clearance", 0.151, 0.149, Warning),
    ("root-clearance", 0.0501, 0.0499, Error),
    ("hunting-tooth", 1.0, 2.0, Remark),
    ("ring-rim", 3.501, 3.499, Remark),
    ("ring-rim", 1.751, 1.749, Error),
    ("planet-rim", 2.701, 2.699, Remark),
    ("planet-rim", 1.131, 1.129, Error),
    ("neighbour-gap", 0.501, 0.499, Warning),
    ("neighbour-gap-length", 1.001, 0.999, Warning),
    ("pin-speed", 499_900.0, 500_100.0, Warning),
    ("full-pin-speed", 199_900.0, 200_100.0, Warning),
    ("orbit-acceleration", 149.9, 150.1, Warning),
    ("needle-acceleration", 2999.0, 3001.0, Warning),
    ("spur-speed", 14.99, 15.01, Remark),
    ("spur-speed", 19.99, 20.01, Warning),
    ("helical-speed", 14.99, 15.01, Remark),
    ("helical-speed", 49.99, 50.01, Warning),
    ("bearing-static-safety", 1.501, 1.499, Warning),
    ("ball-load", 9.99, 10.01, Warning),
    ("bearing-least-load", 0.0201, 0.0199, Warning),
    ("plain-load", 0.999, 1.001, Error),
    ("oil-film", 1.001, 0.999, Warning),
    ("dynamic-factor", 1.299, 1.301, Warning),
    ("dynamic-factor", 1.999, 2.001, Error),
    ("resonance", 0.151, 0.149, Warning),
    ("circulating-power", 0.499, 0.501, Warning),
    ("stage-efficiency", 0.9701, 0.9699, Remark),
    ("stage-efficiency", 0.9501, 0.9499, Warning),
    ("oil-temperature", 89.9, 90.1, Warning),
    ("oil-temperature", 109.9, 110.1, Error),
    ("ratio-deviation", 0.0299, 0.0301, Warning),
    ("direction", 1.0, -1.0, Error),
    ("motor-pressure", 24.99, 25.01, Warning),
    ("contact-stress", 1599.0, 1601.0, Warning),
    ("ripple", 0.0499, 0.0501, Remark),
    ("ripple", 0.0999, 0.1001, Warning),
    ("axial-gap", 5.01, 4.99, Warning),
    ("axial-gap", 14.99, 15.01, Warning),
    ("volumetric-efficiency", 0.851, 0.849, Warning),
    ("overlap", 0.0, -0.001, Error),
    ("chamber-area", 0.0, -0.001, Error),
    // Rounding alone: a part of the width of the range, of its only end, or of 1 where this end is 0.
    ("face-width", 0.5 - 5.7e-10, 0.5 - 6.3e-10, Remark),
    ("specific-sliding", 2.0 + 1.9e-9, 2.0 + 2.1e-9, Remark),
    ("bearing-least-load", 0.02 - 1.9e-11, 0.02 - 2.1e-11, Warning),
    ("overlap", -9.5e-10, -1.05e-9, Error),
];

/// Rule, the limit of the gearbox or motor, value inside, value outside, severity outside.
const OWN: &[(&str, f64, f64, f64, Severity)] = &[
    ("bearing-life", 20_000.0, 20_001.0, 19_999.0, Error),
    ("load-sharing", 1.1, 1.101, 1.099, Warning),
    ("face-load", 1.144, 1.145, 1.143, Warning),
    ("flank-safety", 1.2, 1.201, 1.199, Error),
    ("root-safety", 1.5, 1.501, 1.499, Error),
    ("ratio-deviation", 0.01, 0.0099, 0.0101, Error),
    ("ratio-deviation", 0.4, 0.399, 0.401, Error),
    ("allowed-pressure", 21.0, 20.99, 21.01, Warning),
    ("trapped-pressure", 18.0, 17.99, 18.01, Warning),
];

/// Rule, by how much its bounds move, value inside, value outside, which gets a warning.
const MOVED: [(&str, f64, f64, f64); 4] = [
    ("external-angle", 2.5, 22.51, 22.49),
    ("external-angle", 2.5, 30.99, 31.01),
    ("internal-angle", -5.0, 10.01, 9.99),
    ("internal-angle", -5.0, 16.99, 17.01),
];

/// Rule with the least and greatest value that its quantity can have; all others from 0 on.
const VALUES: [(&str, f64, f64); 14] = [
    ("sun-shift", f64::NEG_INFINITY, f64::INFINITY),
    ("planet-shift", f64::NEG_INFINITY, f64::INFINITY),
    ("ring-shift", f64::NEG_INFINITY, f64::INFINITY),
    ("gear-shift", f64::NEG_INFINITY, f64::INFINITY),
    ("shift-sum", f64::NEG_INFINITY, f64::INFINITY),
    ("overlap", f64::NEG_INFINITY, f64::INFINITY),
    ("oil-temperature", -273.15, f64::INFINITY),
    ("external-angle", 0.0, 90.0),
    ("internal-angle", 0.0, 90.0),
    ("stage-efficiency", 0.0, 1.0),
    ("volumetric-efficiency", 0.0, 1.0),
    ("hunting-tooth", 1.0, f64::INFINITY),
    ("dynamic-factor", 1.0, f64::INFINITY),
    ("direction", -1.0, 1.0),
];

/// Rules that nothing here calculates a value for.
const WITHOUT_VALUE: [Rule; 3] = [Rule::PlainHeat, Rule::Scuffing, Rule::Micropitting];

fn named(name: &str) -> Rule {
    name.parse().unwrap()
}

fn trips(inside: Verdict, outside: Verdict, severity: Severity) {
    assert!(inside.severity < Some(severity), "{inside:?}");
    assert_eq!(outside.severity, Some(severity), "{outside:?}");
    assert!(outside.miss().is_some() && !outside.remedy().is_empty());
}

#[test]
fn every_limit_trips_outside_and_holds_inside() {
    for &(name, inside, outside, severity) in ENDS {
        let judged = |value| Limits::default().judge(named(name), value);
        trips(judged(inside), judged(outside), severity);
        let worst = ENDS.iter().filter(|row| row.0 == name).map(|row| row.3).max().unwrap();
        if named(name).own_limit().is_none() {
            assert_eq!(judged(inside).worst, worst, "{name}");
        }
    }
    for (name, by, inside, outside) in MOVED {
        let judged = |value| Limits::default().judge_by(named(name), named(name).bounds().moved(by), value);
        trips(judged(inside), judged(outside), Warning);
    }
    for &(name, limit, inside, outside, severity) in OWN {
        let judged = |value| match named(name).own_limit().unwrap().1.starts_with("at least") {
            true => Limits::default().judge_least(named(name), limit, value),
            false => Limits::default().judge_most(named(name), limit, value),
        };
        trips(judged(inside), judged(outside), severity);
    }
}

/// A limit without a row, and a rule without a limit.
#[test]
fn every_limit_has_a_row() {
    for &rule in Rule::ALL {
        for severity in Severity::ALL {
            let range = rule.bounds().0[severity as usize];
            for end in [range.least, range.most].into_iter().filter(|end| end.is_finite()) {
                let is_own = |&&(name, inside, outside, of): &&(&str, f64, f64, Severity)| {
                    let is_between = (end - inside) * (end - outside) <= 0.0;
                    named(name) == rule && of == severity && is_between
                };
                assert!(ENDS.iter().any(|row| is_own(&row)), "{rule:?}: {end}");
            }
        }
        let is_listed = ENDS.iter().any(|row| named(row.0) == rule) || WITHOUT_VALUE.contains(&rule);
        assert!(is_listed || OWN.iter().any(|row| named(row.0) == rule), "{rule:?}");
        assert_eq!(rule.own_limit().is_some(), OWN.iter().any(|row| named(row.0) == rule), "{rule:?}");
    }
}

#[test]
fn values_that_quantities_can_have() {
    for &rule in Rule::ALL {
        let due =
            VALUES.iter().find(|row| named(row.0) == rule).map_or((0.0, f64::INFINITY), |row| (row.1, row.2));
        let Range { least, most } = rule.values();
        assert_eq!((least, most), due, "{rule:?}");
    }
}

/// Rules without a range that a file may state: their limit follows from the gearbox or motor, or nothing that a
/// file describes is judged by them.
const NOT_STATABLE: [&str; 19] = [
    "bearing-life",
    "flank-safety",
    "root-safety",
    "load-sharing",
    "face-load",
    "ratio-deviation",
    "allowed-pressure",
    "trapped-pressure",
    "direction",
    "plain-heat",
    "scuffing",
    "micropitting",
    "motor-pressure",
    "contact-stress",
    "ripple",
    "axial-gap",
    "volumetric-efficiency",
    "overlap",
    "chamber-area",
];

/// Rules whose values never reach the least one, so that a range up to it leaves none.
const ABOVE_LEAST: [&str; 7] = [
    "face-width",
    "spur-contact",
    "helical-contact",
    "external-angle",
    "internal-angle",
    "oil-temperature",
    "stage-efficiency",
];

/// Rules whose ratio of value and limit says nothing.
const WITHOUT_MARGIN: [&str; 18] = [
    "direction",
    "ratio-deviation",
    "sun-shift",
    "planet-shift",
    "ring-shift",
    "gear-shift",
    "shift-sum",
    "external-angle",
    "internal-angle",
    "hunting-tooth",
    "load-sharing",
    "face-load",
    "stage-efficiency",
    "dynamic-factor",
    "volumetric-efficiency",
    "oil-temperature",
    "scuffing",
    "micropitting",
];

#[test]
fn what_each_rule_allows() {
    for &rule in Rule::ALL {
        let is_in = |all: &[&str]| all.contains(&rule.name());
        assert_eq!(rule.is_statable(), !is_in(&NOT_STATABLE), "{rule:?}");
        assert_eq!(rule.is_above_least(), is_in(&ABOVE_LEAST), "{rule:?}");
        assert_eq!(rule.has_margin(), !is_in(&WITHOUT_MARGIN), "{rule:?}");
    }
}

#[test]
fn the_narrower_of_two_limits_is_the_nearest_one() {
    let limits = Limits::default();
    for (own, limit) in [(0.01, 0.01), (0.4, 0.03)] {
        assert_eq!(limits.judge_most(Rule::RatioDeviation, own, 0.001).limit, limit);
    }
}

#[test]
fn only_values_outside_a_stated_range_are_against_it() {
    let mut limits = Limits::default();
    limits.state(Rule::SpecificSliding, Range::at_most(1.0));
    for (rule, value, is_against) in [
        (Rule::SpecificSliding, 0.999, false),
        (Rule::SpecificSliding, 1.001, true),
        (Rule::FaceWidth, 9.0, false),
    ] {
        assert_eq!(limits.judge(rule, value).is_against_stated, is_against, "{rule:?} {value}");
    }
}
