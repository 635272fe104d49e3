//! Planets on plain bearings: designs, their files, and what the checks of the files say of load and oil film.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "helpers of tests, which clippy does not know for such"
)]

use crate::common::{GO_ON, stages, taken};
use epicyclic_commands::design::answer::stages::Stages;
use epicyclic_commands::design::answer::ways_out::Limit;
use epicyclic_commands::shared::gearbox::Gearbox;
use epicyclic_commands::size;
use epicyclic_commands::strength::{self, Strength};
use epicyclic_commands::words::request;
use epicyclic_judge::Severity;
use epicyclic_strength::bearing::BearingStep;
use epicyclic_strength::plain_bearing::{self, film_ratio};
use uom::si::angular_velocity::radian_per_second;
use uom::si::f64::{AngularVelocity, Force, KinematicViscosity, Length};
use uom::si::kinematic_viscosity::square_millimeter_per_second;
use uom::si::{force::newton, length::meter};

const SPACE: &str = "--modules=2mm, 3mm, 4mm, 5mm|--face-widths=30mm, 50mm, 80mm, 120mm|--stages=1";

fn strength_of(file: &str) -> Strength {
    let gearbox =
        Gearbox::parse("box.yaml", file.as_bytes()).unwrap_or_else(|error| panic!("{error}: {file}"));
    strength::Request::default().answer(&gearbox).unwrap_or_else(|error| panic!("{error}: {file}"))
}

/// Value and severity of a rule for the planet bearing.
fn judged(strength: &Strength, rule: &str) -> Option<(f64, Option<Severity>)> {
    let check = strength.judgement.checks.iter().find(|check| check.name == rule)?;
    Some((check.value.unwrap(), (!check.holds).then_some(check.severity)))
}

fn designed(helix: u32) -> Stages {
    stages(&format!(
        "--ratio=5|--output-torque=4 kN·m|--input=900rpm|--bearing-type=plain|--helix-angle={helix}deg|{SPACE}"
    ))
}

/// The answer of a design and that of its file agree on load and film, each written once more here.
#[test]
fn the_file_of_a_design_has_its_load_and_film() {
    for helix in [0, 15] {
        let stages = designed(helix);
        let file = stages.file.clone().unwrap();
        let bearing =
            stages.sizes.as_ref().unwrap().sets[0].found[0].planet_sizes[0].bearing.clone().unwrap();
        assert_eq!((bearing.rolling, bearing.life_s), ("plain", None));
        let [diameter, width] = [bearing.bore_m.unwrap(), bearing.width_m.unwrap()];
        assert!((bearing.load_rating_n / (7e6 * diameter * width) - 1.0).abs() < 1e-9, "{bearing:?}");
        assert_eq!(bearing.span_m, (helix > 0).then_some(width / 2.0));
        let strength = strength_of(&file);
        let [row] = &strength.bearings[..] else { panic!("{:?}", strength.bearings) };
        let [step] = &row.steps[..] else { panic!("{:?}", row.steps) };
        assert!((step.equivalent_load_n > step.force_n * 1.01) == (helix > 0), "{step:?}");
        assert!(step.equivalent_load_n <= bearing.load_rating_n, "{step:?}");
        let own = BearingStep {
            share: 1.0,
            load: Force::new::<newton>(step.equivalent_load_n),
            speed: AngularVelocity::new::<radian_per_second>(step.speed_rad_s),
            modification: 1.0,
        };
        let oil =
            plain_bearing::viscosity(KinematicViscosity::new::<square_millimeter_per_second>(220.0), None);
        let film = film_ratio([diameter, width].map(Length::new::<meter>), &[own], oil).unwrap();
        assert!((row.film_ratio.unwrap() / film - 1.0).abs() < 1e-9 && film >= 1.0, "{row:?} {film}");
        assert_eq!(row.basic_life_s, None);
        assert!((row.pressure_pa.unwrap() * diameter * width / step.equivalent_load_n - 1.0).abs() < 1e-9);
        let safety = judged(&strength, "bearing-static-safety").unwrap();
        assert!(
            (safety.0 * step.equivalent_load_n / (20e6 * diameter * width) - 1.0).abs() < 1e-9,
            "{safety:?}"
        );
        let (load, severity) = judged(&strength, "plain-load").unwrap();
        assert!(
            (load * bearing.load_rating_n / step.equivalent_load_n - 1.0).abs() < 1e-9 && severity.is_none()
        );
        assert_eq!(judged(&strength, "oil-film").unwrap().1, None);
        for rule in ["bearing-life", "pin-speed", "orbit-acceleration", "bearing-least-load"] {
            assert!(judged(&strength, rule).is_none(), "{rule}");
        }
        let not_judged =
            |name: &str| strength.judgement.not_judged.iter().any(|one| one.rules.contains(&name));
        assert!(not_judged("plain-heat"), "nothing calculates it");
        assert!(
            !not_judged("bearing-life") && !not_judged("plain-load"),
            "{:?}",
            strength.judgement.not_judged
        );
    }
}

#[test]
fn too_little_load_rating_and_thin_oil_are_named() {
    let file = designed(0).file.unwrap();
    let rating = file.lines().find(|line| line.contains("load_rating:")).unwrap();
    let small = strength_of(&file.replace(rating, "  load_rating: 1 kN"));
    assert_eq!(judged(&small, "plain-load").unwrap().1, Some(Severity::Error));
    let thin = file.replace("oil:\n", "oil:\n  working_viscosity: 1 mm²/s\n");
    assert_ne!(thin, file);
    let thin = strength_of(&thin);
    assert_eq!(judged(&thin, "oil-film").unwrap().1, Some(Severity::Warning));
    assert!(
        thin.warnings.iter().any(|warning| warning.message.contains("thicker oil")),
        "{:?}",
        thin.warnings
    );
    // Without the diameter the film cannot be known, and the answer says so.
    let diameter = file.lines().find(|line| line.contains("bearing_diameter:")).unwrap();
    let without = strength_of(&file.replace(&format!("{diameter}\n"), ""));
    let missing = without.judgement.not_judged.iter().find(|one| one.rules.contains(&"oil-film")).unwrap();
    assert!(missing.missing.iter().any(|key| key.contains("bearing_diameter")), "{missing:?}");
}

/// A fast and heavy set, for whose planets no bearing of the table is large enough.
#[test]
fn where_no_rolling_bearing_holds_plain_ones_are_a_way_out() {
    let words = "--ratio=-5|--power=15MW|--input=9000rpm|--life=100000h|--helix-angle=25deg|--stages=1|--planets=3|\
                 --sun=24..30|--modules=6mm, 8mm, 10mm|--face-widths=200mm, 250mm, 300mm, 400mm";
    let none = stages(&format!("{words}|--bearing-type=rollers"));
    assert!(none.file.is_none());
    let ways = none.ways_out.unwrap();
    let way = ways
        .iter()
        .find(|way| way.limits[0].limit == Limit::PlainBearings)
        .unwrap_or_else(|| panic!("{ways:?}"));
    let held = stages(&format!("{words}|--bearing-type=plain"));
    assert_eq!(way.teeth, taken(&held).teeth);
}

/// A torque that comes a few times is no load of the film, but of the bush.
#[test]
fn an_overload_is_judged_by_the_static_safety() {
    let file = designed(0).file.unwrap();
    let peak = |newton_metres: u32| {
        strength_of(&format!("{file}overload:\n- gear: only\n  torque: {newton_metres} N·m\n"))
    };
    let [usual, much] = [peak(1000), peak(20_000)];
    assert_eq!(judged(&usual, "bearing-static-safety").unwrap().1, None);
    assert_eq!(judged(&much, "bearing-static-safety").unwrap().1, Some(Severity::Warning));
    assert_eq!(judged(&usual, "plain-load"), judged(&much, "plain-load"));
}

/// Of very thin oil, and of a fast step without load: the film is no thicker.
#[test]
fn thin_oil_and_idle_steps_make_no_film() {
    let step = |share, load, speed| BearingStep {
        share,
        load: Force::new::<newton>(load),
        speed: AngularVelocity::new::<radian_per_second>(speed),
        modification: 1.0,
    };
    let size = [0.2, 0.18].map(Length::new::<meter>);
    let film = |duty: &[BearingStep], viscosity: f64| {
        let oil = plain_bearing::viscosity(
            KinematicViscosity::new::<square_millimeter_per_second>(viscosity),
            None,
        );
        film_ratio(size, duty, oil).unwrap()
    };
    let steady = [step(1.0, 1e5, 20.0)];
    let all = [0.01, 0.1, 1.0, 2.0, 10.0, 220.0].map(|viscosity| film(&steady, viscosity));
    assert!(all.windows(2).all(|two| two[0] < two[1]), "{all:?}");
    let idle = film(&[step(0.5, 1e5, 20.0), step(0.5, 0.0, 200.0)], 220.0);
    let nearly = film(&[step(0.5, 1e5, 20.0), step(0.5, 1.0, 200.0)], 220.0);
    assert!((idle / nearly - 1.0).abs() < 1e-9 && idle < all[5], "{idle} {nearly} {all:?}");
}

/// `size` keeps what the file states of a plain bearing, and seeks one where it states the kind alone.
#[test]
fn sizes_take_the_plain_bearing_that_a_file_states() {
    let file = designed(0).file.unwrap();
    let sized = |text: &str| {
        let gearbox = Gearbox::parse("box.yaml", text.as_bytes()).unwrap();
        let request: size::Request = request("--most=1|--width-ratio=1.2".split('|')).unwrap();
        request.answer(&gearbox, &GO_ON).unwrap()
    };
    let line =
        |key: &str| file.lines().find(|line| line.trim_start().starts_with(key)).unwrap().to_owned() + "\n";
    let without = |keys: &[&str]| keys.iter().fold(file.clone(), |text, key| text.replace(&line(key), ""));
    let free =
        without(&["load_rating:", "static_load_rating:", "planet_bore:", "bearing_diameter:", "face_width:"]);
    let found = sized(&free);
    let bearing = found.sets[0].found[0].planet_sizes[0].bearing.clone().unwrap();
    assert_eq!(bearing.rolling, "plain");
    let bored = sized(&without(&["load_rating:", "static_load_rating:", "bearing_diameter:"]));
    let bore = bored.sets[0].found[0].planet_sizes[0].bearing.clone().unwrap().outside_diameter_m;
    assert!((bore.unwrap() - bearing.outside_diameter_m.unwrap()).abs() < 1e-3, "{bored:?}");
    // Less than the load: no width helps.
    let weak = without(&["face_width:"]).replace(&line("load_rating:"), "  load_rating: 100 N\n");
    assert!(sized(&weak).sets[0].found.is_empty());
}
