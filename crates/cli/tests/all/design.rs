//! The command design: speeds first, directions of rotation, limits to relax, factors.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "helpers of tests, which clippy does not know for such"
)]

use crate::common;

use common::{here, output, text};
use serde_json::Value;
use std::fs;

/// Few sizes, so that a design is quick.
const QUICK: &[&str] = &[
    "--power=55kW",
    "--input=1480rpm",
    "--no-bearings",
    "--modules=3 mm, 4 mm, 6 mm",
    "--face-widths=30 mm, 60 mm",
    "--planets=3..4",
];

/// The design of some options: exit code, answer, and the last line of what is said.
fn design(options: &[&str]) -> (i32, Value, String) {
    let line = [&["design", "--format=json"], QUICK, options].concat();
    let done = output(here().path(), &line);
    let answer = serde_json::from_slice(&done.stdout).unwrap_or(Value::Null);
    (done.status.code().unwrap(), answer, text(&done.stderr).lines().last().unwrap_or_default().to_owned())
}

fn numbers(answer: &Value, key: &str) -> Vec<f64> {
    answer["speeds"].as_array().unwrap().iter().map(|speed| speed[key].as_f64().unwrap()).collect()
}

/// The option of a limit, written without the program's words.
fn typed(limit: &Value) -> Option<Vec<String>> {
    let number = |key: &str| limit[key].as_f64().unwrap().to_string();
    let one = |option: &str, value: String| Some(vec![format!("{option}={value}")]);
    match limit["limit"].as_str().unwrap() {
        "tolerance" => one("--tolerance", number("greatest")),
        "ring_to_sun_ratio" => one("--k", format!("{}..{}", number("least"), number("greatest"))),
        "efficiency" => one("--least-efficiency", number("least")),
        "link_speed" => one("--link-speed", number("greatest")),
        "planet_speed" => one("--planet-speed", number("greatest")),
        "clutch_slip" => one("--clutch-slip", number("greatest")),
        "same_direction" => Some(vec!["--may-reverse".to_owned()]),
        "drawable" => Some(vec!["--allow-crossing".to_owned()]),
        "structures" => Some(vec!["--all-structures".to_owned()]),
        "sun_teeth" => one("--sun", format!("{}..60", number("least"))),
        "planet_teeth" => one("--planet", format!("{}..80", number("least"))),
        "ring_teeth" => one("--ring", format!("50..{}", number("greatest"))),
        "ring_offset" => one("--ring-offset", format!("{}..{}", number("least"), number("greatest"))),
        _ => None,
    }
}

/// No gear reverses unless required, and the gearbox of a way out is found by the same search with the option
/// typed.
#[test]
fn ways_out_are_what_the_same_search_finds_with_the_option_typed() {
    let orders: &[&[&str]] = &[
        &["--speeds", "0.63 m/s, 1.0 m/s, 1.6 m/s"],
        &["--speeds", "0.8 m/s, 1.6 m/s"],
        &["--ratios", "2.5, 1.5", "--sun=30..32", "--planet=20..22"],
        &["--ratios", "3.9375", "--sun=40..60", "--planet=17..19"],
    ];
    let mut seen = vec![];
    for order in orders {
        let (code, answer, said) = design(order);
        // Where a structure of another kind holds, it is the answer.
        let is_found = answer["answer"] == "design-transmission";
        assert_eq!((code == 0, answer["file"].is_string()), (is_found, is_found), "{order:?}");
        let ways = answer["ways_out"].as_array().unwrap();
        assert!(!ways.is_empty(), "{order:?}");
        assert!(is_found || said.starts_with("error: no gearbox that holds was found; --"), "{said}");
        for way in ways {
            let limits = way["limits"].as_array().unwrap();
            seen.extend(limits.iter().map(|limit| limit["limit"].as_str().unwrap().to_owned()));
            let Some(options) = limits.iter().map(typed).collect::<Option<Vec<_>>>() else { continue };
            let options = options.concat();
            let is_replaced = |word: &&&str| {
                !options.iter().any(|option| option.split('=').next() == word.split('=').next())
            };
            let mut line: Vec<&str> = order.iter().filter(is_replaced).copied().collect();
            line.extend(options.iter().map(String::as_str));
            let (code, found, _) = design(&line);
            assert_eq!(code, 0, "{line:?}");
            assert_eq!(
                (&found["speeds"], &found["teeth"]["taken"]),
                (&way["speeds"], &way["teeth"]),
                "{line:?}"
            );
            assert_eq!(found["scheme"]["taken"], way["scheme"]);
            let reversed = found["speeds"].as_array().unwrap().iter().any(|speed| speed["reversed"] == true);
            assert!(!reversed || options.contains(&"--may-reverse".to_owned()), "{line:?}");
            let warned = found["warnings"].as_array().unwrap().iter();
            assert_eq!(
                warned.filter(|warning| warning["name"] == "output-reversed").count(),
                usize::from(reversed)
            );
        }
    }
    for limit in ["planet_speed", "same_direction", "sun_teeth"] {
        assert!(seen.contains(&limit.to_owned()), "{seen:?}");
    }
}

/// The mass that a refusal of `--max-mass` names finds a gearbox when it is typed: of schemes and of structures.
#[test]
fn a_mass_that_is_named_finds_a_gearbox() {
    for order in ["--speeds=0.8 m/s, 3.15 m/s", "--ratios=3.5", "--ratios=2", "--ratios=2.8; 1.5; 1"] {
        let (code, answer, said) = design(&[order, "--max-mass=5kg"]);
        assert_eq!((code, answer["file"].is_null()), (1, true), "{order}: {said}");
        let named = said.split("--max-mass ").last().and_then(|rest| rest.split("kg").next()).unwrap();
        let (code, answer, said) = design(&[order, &format!("--max-mass={named}kg")]);
        assert_eq!(code, 0, "{order} {named}: {said}");
        let whole = answer["masses"]["whole_kg"].as_f64().unwrap();
        let most: f64 = named.parse().unwrap();
        assert!(whole <= most && whole > 0.9 * most, "{order}: {whole} {most}");
        // The first lines and the table tell the mass from its limit.
        let limit = format!("--max-mass={whole}kg");
        let line = [&["design", order, &limit], QUICK].concat();
        let shown = text(&output_of(&line));
        let shown: f64 = shown
            .split_whitespace()
            .collect::<Vec<_>>()
            .join(" ")
            .split("whole about ")
            .nth(1)
            .and_then(|rest| rest.split(' ').next()?.parse().ok())
            .unwrap();
        assert!(shown <= whole && shown > 0.999 * whole, "{order}: {shown} {whole}");
    }
}

/// Without a train of a smaller ring a front is a sentence.
#[test]
fn a_front_without_smaller_rings_says_so() {
    let line = ["design", "--ratio=5", "--power=10kW", "--input=1450rpm", "--no-bearings", "--front"];
    let line = [&line[..], &["--sun=24", "--planet=36", "--ring=96", "--modules=3 mm"]].concat();
    let shown = text(&output_of(&line));
    assert!(
        shown.contains("No gearbox with rings 5 % smaller or more holds")
            && !shown.contains("Smaller rings,")
    );
}

/// Tooth numbers of scheme I by trial of all: none that are nearer to the ratio by a class are passed over
/// for mass, only for usual practice.
#[test]
fn deviations_come_before_mass() {
    for (ratio, tolerance) in [(3.9375, 0.03), (3.7, 0.03), (4.3, 0.01), (5.1, 0.1), (3.0, 0.0)] {
        let (ratio_of, within) = (format!("--ratios={ratio}"), format!("--tolerance={tolerance}"));
        let (code, answer, said) = design(&[&ratio_of, &within]);
        assert_eq!(code, 0, "{said}");
        let of = |key: &str| numbers(&answer, key).into_iter().fold(0.0_f64, |most, of| most.max(of.abs()));
        let off = of("speed_deviation").max(of("ratio_deviation"));
        assert!(off <= tolerance + 1e-12, "{ratio}: {off}");
        let taken = answer["teeth"]["tolerance"].as_f64().unwrap();
        assert!(off <= taken + 1e-12 && taken <= tolerance);
        // Planets at equal angles, without profile shift, three or four of them that do not touch.
        let mut nearest = f64::INFINITY;
        for (sun, planet) in (17..=60_u32).flat_map(|sun| (17..=80_u32).map(move |planet| (sun, planet))) {
            let ring = sun + 2 * planet;
            let fits = |planets: u32| (sun + ring).is_multiple_of(planets);
            if (50..=140).contains(&ring) && (fits(3) || fits(4)) {
                let reached = 1.0 + f64::from(ring) / f64::from(sun);
                nearest = nearest.min((reached / ratio - 1.0).abs().max((ratio / reached - 1.0).abs()));
            }
        }
        let classes = [0.1, 1.0 / 3.0, 1.0].map(|part| part * tolerance);
        let least = classes.into_iter().find(|class| nearest <= class + 1e-12).unwrap();
        let missed = |answer: &Value| answer["teeth"]["taken"]["rules_missed"].as_f64().unwrap();
        let narrower = format!("--tolerance={least}");
        assert!(
            (taken - least).abs() < 1e-12
                || taken > least && missed(&answer) < missed(&design(&[&ratio_of, &narrower]).1),
            "{ratio}: within {taken}, and there are some within {least}"
        );
    }
}

/// Speeds by hand: what the ratios of the file give from the input and the fastest speed.
#[test]
fn the_answer_begins_with_the_speeds_asked_for_and_reached() {
    let asked = [0.8, 3.15];
    let (code, answer, _) = design(&["--speeds", "0.8 m/s, 3.15 m/s"]);
    assert_eq!(code, 0);
    assert_eq!(numbers(&answer, "asked_speed_m_s"), asked);
    let [sun, _, ring] =
        [0, 1, 2].map(|gear: usize| answer["teeth"]["taken"]["sets"][0][gear].as_f64().unwrap());
    let ratio = 1.0 + ring / sun;
    let reached = [3.15 / ratio, 3.15];
    for (place, speed) in numbers(&answer, "speed_m_s").into_iter().enumerate() {
        assert!((speed / reached[place] - 1.0).abs() < 1e-12);
        let off = numbers(&answer, "speed_deviation")[place];
        assert!((off - (reached[place] / asked[place] - 1.0)).abs() < 1e-12);
    }
    let output = numbers(&answer, "output_speed_rad_s")[0];
    assert!((output - 1480.0 * std::f64::consts::TAU / 60.0 / ratio).abs() < 1e-9);
    let line = [&["design", "--speeds", "0.8 m/s, 3.15 m/s"], QUICK].concat();
    let shown = text(&output_of(&line));
    let first_heading = shown.split("\n\n").nth(1).unwrap();
    assert!(first_heading.starts_with("Speeds asked and reached"), "{shown}");
}

fn output_of(line: &[&str]) -> Vec<u8> {
    output(here().path(), line).stdout
}

/// A minus is an order for a reverse gear; without one no gear reverses.
#[test]
fn a_reverse_gear_is_one_that_is_asked_for() {
    let (code, answer, _) = design(&["--ratios=-3"]);
    assert_eq!(code, 0);
    assert_eq!(answer["speeds"][0]["reversed"], false);
    assert!(answer["speeds"][0]["ratio"].as_f64().unwrap() < 0.0);
    let (code, answer, _) = design(&["--ratios=3"]);
    assert!(code == 0 && answer["speeds"][0]["ratio"].as_f64().unwrap() > 0.0);
}

#[test]
fn a_factor_acts_in_any_spelling() {
    let order = ["--ratios=4"];
    let sizes = |factors: &str| {
        let (code, answer, said) = design(&[&order[..], &["--factors", factors]].concat());
        assert_eq!(code, 0, "{factors}: {said}");
        answer["sizes"].clone()
    };
    let usual = design(&order).1["sizes"].clone();
    let expected = sizes("K_A 3");
    assert_ne!(usual, expected);
    for spelling in ["KA=3", "K_A=3", "K_A: 3", "KA 3", "K_A = 3"] {
        assert_eq!(sizes(spelling), expected, "{spelling}");
    }
    assert_eq!(sizes("K_Hβ 1.4"), sizes("KHbeta=1.4"));
    let of_ring = sizes("Y_delta_rel_T_stat 0.5");
    assert_eq!(of_ring, sizes("Y_δrelTstat=0.5"));
}

/// By every command that takes the factors of a file.
#[test]
fn a_factor_that_a_file_gives_twice_is_refused() {
    let folder = here();
    let line = [&["design", "--ratios=4", "--save=box.yaml"], QUICK].concat();
    assert_eq!(output(folder.path(), &line).status.code(), Some(0));
    let file = fs::read_to_string(folder.path().join("box.yaml")).unwrap();
    let twice = file.replace("K_A: 1.25", "K_A: 1.25\n      KA: 3");
    assert_ne!(file, twice);
    fs::write(folder.path().join("twice.yaml"), twice).unwrap();
    let basis = [&["design", "--ratios=4", "--basis=twice.yaml"], QUICK].concat();
    let lines: &[&[&str]] = &[
        &["strength", "twice.yaml"],
        &["size", "twice.yaml"],
        &["report", "twice.yaml", "-o=r.html"],
        &basis,
    ];
    for line in lines {
        let done = output(folder.path(), line);
        let said = text(&done.stderr);
        let both = said.contains("`K_A` and `KA` are the same factor, K_A; give it once");
        assert!(done.status.code() == Some(2) && both && said.contains("twice.yaml:"), "{line:?}: {said}");
    }
}

/// Few sizes of stages in series.
const STAGES: &[&str] = &[
    "design",
    "--format=json",
    "--power=10kW",
    "--input=1450rpm",
    "--no-bearings",
    "--modules=1.5 mm, 2 mm, 3 mm",
    "--face-widths=20 mm, 40 mm",
    "--planets=3..4",
];

/// Stages in series: exit code, answer, and what is said.
fn stages(options: &[&str]) -> (i32, Value, String) {
    let done = output(here().path(), &[STAGES, options].concat());
    let answer = serde_json::from_slice(&done.stdout).unwrap_or(Value::Null);
    (done.status.code().unwrap(), answer, text(&done.stderr))
}

/// The error of a command line that is refused.
fn refusal(folder: &std::path::Path, line: &[&str]) -> String {
    let done = output(folder, line);
    assert_eq!(done.status.code(), Some(2), "{line:?}: {}", text(&done.stdout));
    text(&done.stderr)
}

/// A minus between input and output makes the rings turn with the output; none between them holds the rings.
#[test]
fn the_output_of_stages_in_series_turns_as_asked_for() {
    let folder = here();
    let said = refusal(folder.path(), &["design", "--power=10kW", "--input=1450rpm", "--ratio=-1"]);
    assert!(said.contains("a ratio other than 0, 1 and -1"), "{said}");
    let (_, against, _) = stages(&["--output-speed=-290rpm"]);
    let file = against["file"].as_str().unwrap();
    assert!(file.contains("ring: output") && file.contains("carrier: ground"), "{file}");
    assert!(
        against["ratio"].as_f64().unwrap() < 0.0 && against["output_speed_rad_s"].as_f64().unwrap() < 0.0
    );
    let (_, forward, _) = stages(&["--output-speed=290rpm"]);
    let line: Vec<&str> = STAGES.iter().copied().filter(|word| !word.starts_with("--input")).collect();
    let line = [&line[..], &["--input=-1450rpm", "--output-speed=-290rpm"]].concat();
    let done = output(folder.path(), &line);
    let backward: Value = serde_json::from_slice(&done.stdout).unwrap();
    assert_eq!((&forward["ratio"], &forward["sizes"]), (&backward["ratio"], &backward["sizes"]));
    let speed = |of: &Value| of["output_speed_rad_s"].as_f64().unwrap();
    assert!(speed(&forward) > 0.0 && speed(&forward) == -speed(&backward));
}

/// Without stages that hold, each way out is what the same command finds with its option typed.
#[test]
fn stages_that_are_not_found_name_the_limits_in_the_way() {
    let typed = |limit: &Value| {
        let number = |key: &str| limit[key].as_f64().unwrap();
        let range = || format!("{}..{}", number("least"), number("greatest"));
        Some(match limit["limit"].as_str().unwrap() {
            "largest_ring" => format!("--max-ring={}m", number("greatest")),
            "whole_mass" => format!("--max-mass={}kg", number("greatest")),
            "length" => format!("--max-length={}m", number("greatest")),
            "tolerance" => format!("--tolerance={}", number("greatest")),
            "stages" => format!("--stages={}", range()),
            "sun_teeth" => format!("--sun={}", range()),
            "planet_teeth" => format!("--planet={}", range()),
            "ring_teeth" => format!("--ring={}", range()),
            "ring_to_sun_ratio" => format!("--k={}", range()),
            "ring_offset" => format!("--ring-offset={}", range()),
            // Options that are left out.
            _ => return None,
        })
    };
    let orders: &[(&[&str], &str)] = &[
        (&["--ratio=5", "--max-ring=100mm"], "largest_ring"),
        (&["--ratio=5", "--max-mass=5kg"], "whole_mass"),
        (&["--ratio=5", "--max-length=20mm"], "length"),
        (&["--ratio=20", "--stages=1"], "stages"),
        (&["--ratio=2.5", "--sun=17..30"], "sun_teeth"),
        (&["--ratio=5.013", "--stages=1", "--tolerance=0"], "tolerance"),
    ];
    for (order, limit) in orders {
        let (code, answer, said) = stages(order);
        assert_eq!((code, answer["file"].is_null()), (1, true), "{order:?}: {said}");
        let ways = answer["ways_out"].as_array().unwrap();
        let of = |way: &Value| way["limits"].as_array().unwrap().clone();
        assert!(
            ways.iter().any(|way| of(way).iter().any(|one| one["limit"] == *limit)),
            "{order:?}: {ways:?}"
        );
        assert!(said.starts_with("error: no stages that hold were found; --"), "{said}");
        for way in ways {
            let Some(options) = of(way).iter().map(typed).collect::<Option<Vec<_>>>() else { continue };
            let is_kept = |word: &&&str| {
                !options.iter().any(|option| option.split('=').next() == word.split('=').next())
            };
            let mut line: Vec<&str> = order.iter().filter(is_kept).copied().collect();
            line.extend(options.iter().map(String::as_str));
            let (code, found, said) = stages(&line);
            assert_eq!(code, 0, "{line:?}: {said}");
            let taken = found["trains"].as_array().unwrap().iter().find(|of| of["taken"] == true).unwrap();
            assert_eq!(taken["best"]["teeth"], way["teeth"], "{line:?}");
        }
        let shown: Vec<&str> = STAGES.iter().copied().filter(|word| *word != "--format=json").collect();
        let shown = text(&output(here().path(), &[&shown[..], order].concat()).stdout);
        assert!(!shown.contains("No warnings"), "{shown}");
    }
    let shown: Vec<&str> = STAGES.iter().copied().filter(|word| *word != "--format=json").collect();
    let up = text(&output(here().path(), &[&shown[..], &["--ratio=1/5"]].concat()).stdout);
    assert!(up.lines().next().is_some_and(|line| line.contains("steps up")), "{up}");
    let (code, answer, said) = stages(&["--ratio=1.5"]);
    assert!(code == 1 && answer["ways_out"].as_array().is_some(), "{said}");
    assert!(said.contains("--axes either gives 1 stage, i = -1.5"), "{said}");
}

/// Limits of a basis judge the design, and what a basis lacks is that of the application.
#[test]
fn a_basis_gives_its_limits_and_takes_what_it_lacks_of_the_application() {
    let folder = here();
    let write = |text: &str| fs::write(folder.path().join("basis.yaml"), text).unwrap();
    let designed = |more: &[&str]| {
        let line = [STAGES, &["--ratio=5", "--basis=basis.yaml", "--save=box.yaml"], more].concat();
        let done = output(folder.path(), &line);
        assert_eq!(done.status.code(), Some(0), "{}", text(&done.stderr));
        let answer: Value = serde_json::from_slice(&done.stdout).unwrap();
        (answer, fs::read_to_string(folder.path().join("box.yaml")).unwrap())
    };
    write("life: 4000 h\nlimits: { face-width: ..0.3, oil-temperature: ..80 }\n");
    let (answer, file) = designed(&["--application=mixer"]);
    assert!(file.contains("face-width: ..0.3") && file.contains("K_A: 1.5"), "{file}");
    assert!(file.contains("life: 4000 h") && file.contains("flank: 1.2"), "{file}");
    let checks = answer["sizes"]["judgement"]["checks"].as_array().unwrap();
    let of_width: Vec<&Value> = checks.iter().filter(|check| check["name"] == "face-width").collect();
    assert!(!of_width.is_empty() && of_width.iter().all(|check| check["source"] == "what is stated"));
    // A stated limit that nothing judges is listed as not judged.
    let not_judged = answer["sizes"]["judgement"]["not_judged"].to_string();
    assert!(not_judged.contains("oil-temperature"), "{not_judged}");
    let warned = answer["warnings"].to_string();
    assert!(warned.contains("application-not-used") && warned.contains("life 20000 h"), "{warned}");
    write("strength: { factors: { K_A: 2 } }\n");
    let (answer, file) = designed(&[]);
    assert!(file.contains("K_A: 2") && file.contains("K_v: 1.1"), "{file}");
    assert!(!answer["warnings"].to_string().contains("application-not-used"));
}

/// A warning lists the values of the application in whose place a file to size states others.
#[test]
fn values_of_an_application_that_are_not_used_are_told() {
    let folder = here();
    let line = [STAGES, &["--ratio=5", "--application=conveyor", "--save=box.yaml"]].concat();
    assert_eq!(output(folder.path(), &line).status.code(), Some(0));
    let size = |application: &str| {
        let line = ["size", "box.yaml", "--no-bearings", "--application", application];
        text(&output(folder.path(), &line).stdout)
    };
    assert!(!size("conveyor").contains("not used"));
    let said = size("robot").split_whitespace().collect::<Vec<_>>().join(" ");
    let told = "--application: life 20000 h, required.flank 1, required.root 1.4, K_A 1.1 are not used: the file states other values";
    assert!(said.contains(told), "{said}");
}

/// Refusals name the option or key, what is wrong, and what to type.
#[test]
fn values_that_make_no_sense_are_refused_with_what_to_type() {
    let folder = here();
    let cases: &[(&[&str], &[&str])] = &[
        (&["--ratio=5", "--factors=K_A=0.01"], &["--factors", "K_A is given as 0.01", "not below 1"]),
        (&["--ratio=5", "--factors=K_v 0.5"], &["--factors", "K_v is given as 0.5"]),
        (&["--ratio=5", "--factors=Y_S -1"], &["--factors", "above 0"]),
        (&["--ratio=5", "--overload=0.5"], &["--overload: 0.5", "write 1 or more"]),
        (&["--ratios=4 4 1"], &["--ratios: 4 is given twice", "write it once"]),
        (&["--ratio=5", "--life=10000"], &["--life", "write '10000 h'"]),
        (&["--ratio=5", "--life=-5h"], &["--life", "a life is above 0"]),
        (&["--ratio=5", "--tolerance=3"], &["--tolerance: 3", "write '3 %'"]),
        (&["--ratios=3", "--tolerance=3"], &["--tolerance: 3", "write '3 %'"]),
        (&["--ratios=3; 2; 1", "--tolerance=3"], &["--tolerance: 3", "write '3 %'"]),
        (&["--speeds=1m/s, 2m/s", "--shares=0.5, 0.6"], &["--shares", "110 %", "'45.45 %, 54.55 %'"]),
        (&["--speeds=1m/s, 2m/s", "--shares=-50%, 150%"], &["--shares: -50 %"]),
        (&["--ratios=3; 2; 1", "--shares=50%, 10%, 10%"], &["--shares", "70 %"]),
        (&["--ratios=4; 2; 1", "--shares=20%, 50%"], &["--shares: 2 shares of the time for 3 gears"]),
        (&["--ratio=5", "--efficiency=97"], &["--efficiency: mesh efficiency 97", "write 97%"]),
        (&["--output-speed=0rpm"], &["--output-speed: the output must turn"]),
        (&["--ratio=5", "--max-ring=0mm"], &["--max-ring: largest ring is 0 mm"]),
        (&["--ratio=5", "--max-mass=0kg"], &["--max-mass", "must be above 0"]),
        (&["--ratio=5", "--max-mass=5mm"], &["--max-mass", "kg"]),
        (&["--ratio=5", "--max-length=-1mm"], &["--max-length", "must be above 0"]),
        (&["--ratios=3.5", "--max-length=1m"], &["'--max-length", "'--ratios"]),
        (&["--ratio=5", "--application=robot", "--max-length=1m"], &["--max-length", "flanges"]),
        (&["--ratio=5", "--runaway=0.9"], &["--runaway: 0.9", "write 1 or more"]),
        (&["--ratios=3.5", "--runaway=0"], &["--runaway: 0"]),
        (&["--ratio=5", "--runaway=1e9"], &["--runaway: 1000000000", "at most 6580"]),
        (&["--ratios=3; 2; 1", "--runaway=1e9"], &["--runaway: 1000000000", "at most 6580"]),
        (&["--ratio=5", "--side-load=0kN"], &["--side-load", "must be above 0"]),
        (&["--ratio=5", "--helix-angle=70deg"], &["--helix-angle", "between 0 and 60 °", "other hand"]),
        (&["--ratio=5", "--helix-angle=20"], &["--helix-angle", "deg"]),
        (&["--speeds=20rpm, 60rpm"], &["--speeds", "speeds of a shaft", "write --ratios"]),
        (&["--ratio=5", "--tooth-design=2"], &["tip: leave out '--ratio', or '--tooth-design'"]),
    ];
    for (options, parts) in cases {
        let line = [&["design", "--power=10kW", "--input=1450rpm"], *options].concat();
        let said = refusal(folder.path(), &line);
        assert!(parts.iter().all(|part| said.contains(part)), "{options:?}: {said}");
        assert!(!said.contains("in the making"), "{said}");
    }
}

/// Criteria that are stricter than usual are named before what else may help.
#[test]
fn criteria_in_the_way_of_a_list_of_gears_are_named() {
    let folder = here();
    let line = ["design", "--ratios=4, 1", "--power=22kW", "--input=1500rpm", "--least-efficiency=0.999"];
    let done = output(folder.path(), &line);
    assert_eq!(done.status.code(), Some(1), "{}", text(&done.stdout));
    let said = text(&done.stderr);
    assert!(said.contains("was found; a lower --least-efficiency, a larger --tolerance"), "{said}");
}

/// The file with the pasted lines is complete.
#[test]
fn keys_that_sheet_and_vibrate_lack_are_given_to_paste() {
    let folder = here();
    let set = |more: &str| {
        format!(
            "gearbox: P\ninput: s\noutput: c\nsets:\n  - {{ id: P, sun: s, ring: ground, carrier: c, teeth: [20, 70], planets: 3{more} }}\ngears: [{{ name: only }}]\n"
        )
    };
    for command in ["sheet", "vibrate"] {
        fs::write(folder.path().join("box.yaml"), set("")).unwrap();
        let said = refusal(folder.path(), &[command, "box.yaml"]);
        assert!(said.contains("missing: `module`"), "{said}");
        let pasted = said.lines().find(|line| line.starts_with(", ")).unwrap();
        fs::write(folder.path().join("box.yaml"), set(pasted)).unwrap();
        let done = output(folder.path(), &[command, "box.yaml"]);
        assert_eq!(done.status.code(), Some(0), "{command}: {}", text(&done.stderr));
    }
}
