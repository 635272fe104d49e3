//! The judgement of files: no rule is left out in silence.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "helpers of tests, which clippy does not know for such"
)]

use epicyclic_commands::analyze::request::overview;
use epicyclic_commands::shared::gearbox::Gearbox;
use epicyclic_commands::shared::judgement::answer::{Judgement, NotJudged};
use epicyclic_commands::strength;
use epicyclic_commands::words::request;
use epicyclic_formats::gearbox::GearboxFile;
use epicyclic_judge::{Rule, Severity};
use std::path::Path;

/// A set with all that its strength and its bearings need.
const WHOLE: &str = "\
gearbox: whole
input: s
output: h
sets:
  - { id: A, sun: s, ring: r, carrier: h, teeth: [24, 84], planet_teeth: [30], planets: 3, module: 3 mm, planet_bore: 60 mm, face_width: 40 mm,
      profile_shifts: [0, 0, 0], load_rating: 50 kN, static_load_rating: 40 kN, bearing_diameter: 50 mm, STRENGTH }
brakes: [{ id: B, link: r }]
gears: [{ name: '1', engaged: [B] }]
DUTY
LIFE
OIL
";

const STRENGTH: &str = "strength: { materials: [18CrNiMo7-6, 18CrNiMo7-6, 34CrNiMo6], flank_roughness: [4 µm, 4 µm, 6 µm], \
    root_roughness: [16 µm, 16 µm, 20 µm], shaper: { teeth: 30 }, ring_factors: { Y_delta_rel_T_stat: 1 }, \
    factors: { K_A: 1.25, K_v: 1.05, K_H_beta: 1.2, K_H_alpha: 1, K_F_alpha: 1 } }";

fn whole() -> String {
    WHOLE
        .replace("STRENGTH", STRENGTH)
        .replace("DUTY", "duty: [{ gear: '1', share: 1, torque: 200 N·m, speed: 1500 rpm }]")
        .replace("LIFE", "life: 5000 h")
        .replace("OIL", "oil: { viscosity: 220 mm²/s }")
}

fn judged(text: &str) -> (Gearbox, Judgement) {
    let subject =
        Gearbox::parse("box.yaml", text.as_bytes()).unwrap_or_else(|error| panic!("{error}: {text}"));
    let judgement = overview(&subject, Default::default(), None).unwrap().judgement;
    (subject, judgement)
}

/// Whether a rule is a check of a set, or of its parts, or is named as not judged.
fn is_named(judgement: &Judgement, rule: Rule, set: &str) -> bool {
    let is_own = |one: &NotJudged| one.of == set || one.of.starts_with(&format!("{set}, "));
    judgement.checks.iter().any(|check| check.name == rule.name() && check.of[0] == set)
        || judgement.not_judged.iter().any(|one| is_own(one) && one.rules.contains(&rule.name()))
}

fn every_rule_is_named(subject: &Gearbox, judgement: &Judgement, of: &str) {
    let file: GearboxFile = subject.document.read().unwrap();
    for set in subject.train.sets().iter().filter(|set| file.set_data(set).is_some()) {
        let of_teeth = [Rule::FlankSafety, Rule::RootSafety, Rule::DynamicFactor, Rule::FaceLoad];
        let of_bearings = [Rule::BearingLife, Rule::BearingStaticSafety, Rule::BearingLeastLoad];
        let of_bearings = of_bearings.into_iter().filter(|_| !set.is_pair());
        for rule in of_teeth.into_iter().chain(of_bearings) {
            assert!(is_named(judgement, rule, set.id()), "{rule:?} of {} in {of}", set.id());
        }
    }
    for one in &judgement.not_judged {
        assert!(!one.missing.is_empty(), "{one:?} in {of}");
    }
}

#[test]
fn every_rule_of_strength_is_judged_or_named_in_every_example() {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let mut sets = 0;
    for path in std::fs::read_dir(examples).unwrap().map(|entry| entry.unwrap().path()) {
        let bytes = std::fs::read(&path).unwrap();
        // Drives, motors and lists of transmissions have no gearbox to judge.
        let Ok(subject) = Gearbox::parse("box.yaml", &bytes) else { continue };
        if subject.document.read::<GearboxFile>().is_err() {
            continue;
        }
        let Ok(overview) = overview(&subject, Default::default(), None) else { continue };
        every_rule_is_named(&subject, &overview.judgement, &path.display().to_string());
        sets += subject.train.sets().len();
    }
    assert!(sets > 20, "{sets}");
}

#[test]
fn exactly_what_is_missing_is_named() {
    let (subject, all) = judged(&whole());
    every_rule_is_named(&subject, &all, "whole");
    let named = |one: &NotJudged| !one.rules.contains(&Rule::Scuffing.name());
    assert!(!all.not_judged.iter().any(named), "{:?}", all.not_judged);
    let lines = |key: &'static str| move |line: &&str| !line.starts_with(key);
    let without_line =
        |key: &'static str| whole().lines().filter(lines(key)).map(|line| line.to_owned() + "\n").collect();
    let cases: [(String, &str, &[&str]); 8] = [
        (without_line("duty"), "A", &["duty"]),
        (without_line("life"), "A", &["life"]),
        (without_line("oil"), "A", &["oil"]),
        (whole().replace(STRENGTH, "tip_alterations: [0, 0, 0]"), "A", &["strength"]),
        (whole().replace("face_width: 40 mm,", ""), "A", &["face_width"]),
        (whole().replace("planets: 3,", ""), "A", &["planets"]),
        (whole().replace("static_load_rating: 40 kN,", ""), "A, planet bearing", &["static_load_rating"]),
        (whole().replace("bearing_diameter: 50 mm,", ""), "A, planet bearing", &["bearing_diameter"]),
    ];
    for (text, of, missing) in cases {
        let (subject, judgement) = judged(&text);
        every_rule_is_named(&subject, &judgement, &text);
        let own: Vec<&NotJudged> =
            judgement.not_judged.iter().filter(|one| one.of == of && one.rules != ["teeth"]).collect();
        assert!(!own.is_empty(), "{text}");
        assert!(own.iter().all(|one| one.missing == missing), "{own:?} {text}");
    }
}

/// A part of a set that has no result is named beside the others that are judged.
#[test]
fn a_root_that_is_not_rated_is_named() {
    let text = whole().replace("ring_factors: { Y_delta_rel_T_stat: 1 }, ", "");
    let (subject, judgement) = judged(&text);
    every_rule_is_named(&subject, &judgement, &text);
    let of = "A, root of the ring in the mesh planet–ring";
    let own = judgement.not_judged.iter().find(|one| one.of == of);
    assert_eq!(own.map(|one| &one.rules[..]), Some(&["root-safety"][..]), "{:?}", judgement.not_judged);
}

/// At an operating point lives are not calculated, and that is said.
#[test]
fn an_operating_point_names_what_needs_a_duty() {
    let subject = Gearbox::parse("box.yaml", whole().as_bytes()).unwrap();
    let at_point: strength::Request = request(["--torque=200 N·m", "--speed=1500 rpm"]).unwrap();
    every_rule_is_named(&subject, &at_point.answer(&subject).unwrap().judgement, "a point");
}

#[test]
fn safeties_and_lives_are_shown_themselves() {
    let text = whole().replace("life: 5000 h", "life: 5000 h\nrequired: { flank: 3, root: 1.2 }");
    let (_, judgement) = judged(&text);
    let check = |rule: Rule| judgement.checks.iter().find(|check| check.name == rule.name()).unwrap();
    let flank = check(Rule::FlankSafety);
    assert_eq!((flank.limit, flank.holds), (3.0, false));
    assert!((1.0..3.0).contains(&flank.value.unwrap()), "{flank:?}");
    let life = check(Rule::BearingLife);
    assert_eq!((life.limit, life.unit), (5000.0, "h"));
    let face = check(Rule::FaceLoad);
    let ratio = 40.0_f64 / 72.0;
    assert!((face.limit - (1.0 + 0.4 * ratio * ratio)).abs() < 1e-12 && face.value == Some(1.2), "{face:?}");
}

/// A bore, or a bearing, that leaves little of the teeth's rim is an error, whether a rim is stated or not.
#[test]
fn a_bore_close_to_the_roots_is_an_error() {
    let rim = |bore: &str, mean: &str| {
        let text = whole().replace("planet_bore: 60 mm,", bore);
        let (_, judgement) =
            judged(&text.replace("bearing_diameter: 50 mm", &format!("bearing_diameter: {mean}")));
        let lacks = judgement.not_judged.iter().any(|one| one.rules.contains(&Rule::PlanetRim.name()));
        let own = judgement.checks.into_iter().find(|check| check.name == Rule::PlanetRim.name());
        (own.map(|own| (own.value.unwrap(), own.holds)), lacks)
    };
    let near = |one: Option<(f64, bool)>, (value, holds): (f64, bool)| {
        let (own, own_holds) = one.unwrap();
        assert!((own - value).abs() < 1e-12 && own_holds == holds, "{one:?}");
    };
    // The root circle of 30 teeth has a diameter of 27.5 modules.
    near(rim("planet_bore: 64.5 mm,", "50 mm").0, (3.0, true));
    near(rim("planet_bore: 79.5 mm,", "50 mm").0, (0.5, false));
    near(rim("planet_bore: 64.5 mm,", "79.5 mm").0, (0.5, false));
    near(rim("", "79.5 mm").0, (0.5, false));
    assert_eq!(rim("", "50 mm"), (None, true));
}

#[test]
fn a_pinion_in_a_ring_has_a_width() {
    let text = "gearbox: pair\ninput: a\noutput: b\nsets:\n  - { id: W, kind: internal_pair, sun: a, ring: b, teeth: [20, 71], \
                module: 2 mm, face_width: 3.2 mm, profile_shifts: [0, 0] }\ngears: [{ name: '1' }]\n";
    let (subject, judgement) = judged(text);
    every_rule_is_named(&subject, &judgement, text);
    let width = judgement.checks.iter().find(|check| check.name == Rule::FaceWidth.name()).unwrap();
    assert!((width.value.unwrap() - 0.08).abs() < 1e-12 && !width.holds, "{width:?}");
}

/// A stated limit in place of the usual one, in what `analyze` and `strength` answer: a miss that holds, and
/// a value that holds and misses.
#[test]
fn stated_limits_take_the_place_of_usual_ones() {
    let text = whole().replace("face_width: 40 mm", "face_width: 90 mm");
    let check = |judgement: &Judgement, name: &str| {
        let check = judgement.checks.iter().find(|check| check.name == name).unwrap();
        (check.holds, check.severity, check.source)
    };
    for (limits, name, usual, stated) in [
        ("face-width: 0.4..1.4", "face-width", (false, Severity::Warning), true),
        ("dynamic-factor: ..1.01", "dynamic-factor", (true, Severity::Error), false),
    ] {
        let with_limits = format!("{text}limits: {{ {limits} }}\n");
        let of = |text: &str| {
            let (subject, overview) = judged(text);
            let strength = strength::Request::default().answer(&subject).unwrap();
            [check(&overview, name), check(&strength.judgement, name)]
        };
        for (holds, severity, _) in of(&text) {
            assert_eq!((holds, severity), usual, "{name}");
        }
        for (holds, severity, source) in of(&with_limits) {
            assert_eq!(holds, stated, "{name}");
            assert!(holds || severity == Severity::Warning, "{name}");
            assert_eq!(source, "what is stated");
        }
    }
}
