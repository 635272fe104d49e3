//! Designs for one ratio and for lists of gears: their files, calculated by other commands, are what the
//! answers say.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "helpers of tests, which clippy does not know for such"
)]

use crate::common::{GO_ON, stages, taken};
use epicyclic_commands::analyze::answer::{Input, overview};
use epicyclic_commands::design::Request;
use epicyclic_commands::design::answer::stages::Stages;
use epicyclic_commands::report;
use epicyclic_commands::shared::basis::Basis;
use epicyclic_commands::shared::gearbox::Gearbox;
use epicyclic_commands::size;
use epicyclic_commands::strength;
use epicyclic_commands::words::request;
use epicyclic_formats::Document;
use epicyclic_units::Physical;

fn gearbox(file: &str) -> Gearbox {
    Gearbox::parse("design.yaml", file.as_bytes()).unwrap()
}

/// Input speed over output speed in each gear, by the solver.
fn ratios(gearbox: &Gearbox) -> Vec<f64> {
    let gears = gearbox.train.gears().iter();
    gears.map(|gear| gearbox.train.analyze_gear(gear).unwrap().ratio().unwrap()).collect()
}

const SPACE: &str = "--sun=18..27|--planet=18..45|--ring=60..140|--modules=2mm, 3mm|--face-widths=20mm, 30mm, 50mm|--planets=3|--tolerance=0";

/// A reduction and a train that steps up between the same shafts have the same gears and loads.
#[test]
fn a_train_that_steps_up_is_the_reduction_turned_round() {
    let down = stages(&format!("--ratio=20|--power=12kW|--input=1500rpm|{SPACE}"));
    let up = stages(&format!("--ratio=0.05|--power=12kW|--input=75rpm|{SPACE}"));
    let [one, other] =
        [&down, &up].map(|stages| stages.sizes.as_ref().unwrap_or_else(|| panic!("{:?}", stages.trains)));
    assert_eq!(one.mass_kg, other.mass_kg);
    let near = |one: f64, other: f64| (one / other - 1.0).abs() < 1e-9;
    assert!(near(down.ratio.unwrap(), 20.0) && near(up.ratio.unwrap(), 0.05));
    for (stages, ratio) in [(&down, 20.0), (&up, 0.05)] {
        let torque = ratio * 12e3 / stages.input_speed_rad_s * stages.efficiency.unwrap();
        assert!(near(stages.output_torque_n_m.unwrap(), torque));
        assert!(near(stages.input_power_w.unwrap(), 12e3));
    }
    assert!(near(down.masses.unwrap().whole_kg, up.masses.unwrap().whole_kg));
    let mut reversed = taken(&up).teeth;
    reversed.reverse();
    assert_eq!(taken(&down).teeth, reversed);
    let [down, up] = [&down, &up].map(|stages| ratios(&gearbox(stages.file.as_ref().unwrap())));
    assert!(near(down[0], 20.0) && near(up[0], 0.05), "{down:?} {up:?}");
}

/// The input gives the torque asked for on the output and the losses, by the solver and by Willis' equation
/// with losses; the report has the same on its first sheet.
#[test]
fn the_output_has_the_torque_that_is_asked_for() {
    for (ratio, speed) in [(20.0, "1500rpm"), (0.05, "75rpm"), (-19.0, "1425rpm"), (-1.0 / 19.0, "75rpm")] {
        let torque = if f64::abs(ratio) > 1.0 { 900 } else { 45 };
        let stages = stages(&format!(
            "--ratio={ratio}|--output-torque={torque} N·m|--input={speed}|--efficiency=0.96|{SPACE}"
        ));
        let near = |one: f64, other: f64| (one / other - 1.0).abs() < 1e-9;
        let output = stages.output_torque_n_m.unwrap();
        assert!(near(output, stages.asked_output_torque_n_m.unwrap()), "{output}");
        let gearbox = gearbox(stages.file.as_ref().unwrap());
        let analysis = gearbox.train.analyze_gear(&gearbox.train.gears()[0]).unwrap();
        assert!(near(stages.efficiency.unwrap(), analysis.efficiency().unwrap()));
        let back = analysis.back_driving_efficiency().unwrap();
        assert!(near(stages.back_driving_efficiency.unwrap(), back));
        let taken = taken(&stages);
        // Torque of the last carrier over that of the fast shaft, of which turning rings take one part less.
        let carrier = |of_mesh: f64| -> f64 {
            let of_stage = |teeth: &Vec<u32>| 1.0 + f64::from(teeth[2]) / f64::from(teeth[0]) * of_mesh;
            taken.teeth.iter().map(of_stage).product()
        };
        let slow = |of_mesh: f64| if ratio < 0.0 { carrier(of_mesh) - 1.0 } else { carrier(of_mesh) };
        let efficiency =
            if ratio.abs() > 1.0 { slow(0.96) / slow(1.0) } else { slow(1.0) / slow(1.0 / 0.96) };
        assert!(near(stages.efficiency.unwrap(), efficiency));
        let input = stages.input_torque_n_m.unwrap();
        assert!(near(input * stages.ratio.unwrap().abs() * efficiency, output));
        assert!(near(stages.input_power_w.unwrap(), input * stages.input_speed_rad_s));
        let (page, _) = report::Request::default().answer(&gearbox, &GO_ON).unwrap();
        let duty = page.duty.unwrap();
        let [step] = &duty.steps[..] else { panic!("{duty:?}") };
        assert!((step.input_torque_n_m / input - 1.0).abs() < 1e-9);
        assert!((step.output_torque_n_m.unwrap().abs() / output - 1.0).abs() < 1e-9);
        assert!((step.output_speed_rad_s.unwrap() / stages.output_speed_rad_s.unwrap() - 1.0).abs() < 1e-9);
        assert_eq!((&duty.application_factors[..], duty.life_s), (&[1.25][..], Some(20_000.0 * 3600.0)));
    }
}

/// Rings that turn with the output are, seen from them, held rings under an input that turns faster: the same
/// gears hold, and the output turns against the input.
#[test]
fn turning_rings_are_held_rings_seen_from_them() {
    let space = format!("{SPACE}|--no-bearings|--torque=45 N·m");
    for (turning, held) in [
        ("--ratio=-19|--input=1425rpm", "--ratio=20|--input=1500rpm"),
        ("--ratio=-4|--input=1200rpm", "--ratio=5|--input=1500rpm"),
    ] {
        let [turning, held] = [turning, held].map(|words| stages(&format!("{words}|{space}")));
        let of = |stages: &Stages| {
            let best = taken(stages);
            (best.teeth, best.ratios, best.mass_kg)
        };
        assert_eq!(of(&turning), of(&held));
        let safeties = |stages: &Stages| -> Vec<f64> {
            let designs = stages.sizes.as_ref().unwrap().sets.iter().map(|set| &set.found[0]);
            designs.flat_map(|design| &design.over_duty).map(|of| of.flank.safety).collect()
        };
        let [one, other] = [&turning, &held].map(safeties);
        assert!(
            one.iter().zip(&other).all(|(one, other)| (one / other - 1.0).abs() < 1e-9),
            "{one:?} {other:?}"
        );
        let [one, other] = [&turning, &held].map(|stages| ratios(&gearbox(stages.file.as_ref().unwrap()))[0]);
        assert!((one - (1.0 - other)).abs() < 1e-9 && (turning.ratio.unwrap() - one).abs() < 1e-9);
    }
}

/// Without a stated `K_Hβ` wide gears have that of their width, which the file states, so that `strength`
/// finds the same safeties.
#[test]
fn wide_gears_have_the_face_load_of_their_width() {
    let order = "--ratio=5|--power=30kW|--input=1500rpm|--planets=3|--modules=2.5mm|--face-widths=80mm|--bearing-type=full-complement";
    let wide = stages(order);
    let design = &wide.sizes.as_ref().unwrap().sets[0].found[0];
    let family = &design.families[0];
    let smaller = design.gears[..2].iter().map(|gear| gear.teeth).min().unwrap();
    let ratio = family.face_width_m / (f64::from(smaller) * family.module_m);
    let factor = family.face_load_factor.unwrap();
    assert!(
        ratio > 0.8 && (0.0..=1.001e-3).contains(&(factor - 1.0 - 0.4 * ratio * ratio)),
        "{ratio} {factor}"
    );
    let told = strength::Request::default().answer(&gearbox(wide.file.as_ref().unwrap())).unwrap();
    let flanks: Vec<f64> = told.over_duty.iter().map(|one| one.flank.as_ref().unwrap().safety).collect();
    let own: Vec<f64> = design.over_duty.iter().map(|of| of.flank.safety).collect();
    assert!(
        flanks.iter().zip(&own).all(|(one, other)| (one / other - 1.0).abs() < 1e-9),
        "{flanks:?} {own:?}"
    );
    let stated = stages(&format!("{order}|--factors=K_H_beta 1.25"));
    let design = &stated.sizes.as_ref().unwrap().sets[0].found[0];
    assert!(design.families[0].face_load_factor.is_none());
    assert!(stated.warnings.iter().any(|warning| warning.name == "face-load"));
}

/// Orders beyond the largest bearings of the tables get rollers in the bores. Little torque has small
/// gears, whatever the least load of their bearings. Low ratios have large suns.
#[test]
fn orders_of_every_size_have_an_answer() {
    let ring = |words: &str| {
        let found = stages(words);
        let sizes = found.sizes.as_ref().unwrap_or_else(|| panic!("{words}: {:?}", found.trains));
        let kinds = found.assumed.iter().find(|one| one.key == "bearings of the planets").unwrap();
        (sizes.sets[0].found[0].ring_diameter_m.unwrap(), kinds.value.contains("rollers-in-bore"))
    };
    assert!(ring("--ratio=0.2|--power=2MW|--input=200rpm|--life=100000h").1);
    let (small, is_in_bore) = ring("--ratio=5|--output-torque=1 N·m|--input=1000rpm");
    assert!(small < 0.15 && !is_in_bore, "{small}");
    assert!(ring("--ratio=3|--power=60kW|--input=1480rpm").0 < 0.3);
}

/// A servo gearbox has its flanges in the whole, of the usual mass of its size.
#[test]
fn a_servo_gearbox_weighs_what_is_usual_of_its_flange() {
    let servo = stages(
        "--ratio=10|--output-torque=45 N·m|--overload=2.45|--input=3000rpm|--application=robot|--max-ring=90mm",
    );
    let masses = servo.masses.unwrap();
    assert!(masses.flanges_kg.is_some() && masses.shift_elements_kg.is_none());
    assert!((2.0..3.5).contains(&masses.whole_kg), "{masses:?}");
    let of_report = {
        let gearbox = gearbox(servo.file.as_ref().unwrap());
        let (page, _) = report::Request::default().answer(&gearbox, &GO_ON).unwrap();
        page.sizes[0].clone()
    };
    let near = |one: f64, other: f64| (one / other - 1.0).abs() < 1e-6;
    assert!(near(of_report.mass_kg.unwrap(), masses.gears_kg), "{of_report:?}");
    assert!(near(of_report.structure_kg.unwrap(), masses.structure_kg), "{of_report:?}");
    let named = |key: &str| servo.assumed.iter().find(|one| one.key == key).map(|one| one.value.as_str());
    assert_eq!(named("planets"), Some("3"));
    assert_eq!(named("bearings of the planets"), Some("needles"));
    assert!(named("overload").is_none() && named("modules").is_some());
}

/// The train that holds the greatest load has gears without common divisors where these are asked for.
#[test]
fn hunting_teeth_have_no_common_divisor() {
    let space = SPACE.replace("--tolerance=0", "--tolerance=3%");
    let found =
        stages(&format!("--ratio=5|--power=12kW|--input=1500rpm|--hunting-teeth|--axes=either|{space}"));
    let trains = found.trains.iter().filter_map(|trains| trains.best.as_ref());
    let mut seen = 0;
    for mates in trains.flat_map(|train| &train.teeth).flat_map(|teeth| teeth.windows(2)) {
        seen += 1;
        let divides = |of: u32| mates.iter().all(|teeth| teeth % of == 0);
        assert!(!(2..=mates[0]).any(divides), "{mates:?}");
    }
    assert!(seen > 0);
}

/// In direct drive bearings of planets stand still and need no least load; power that circulates costs nothing. A
/// gearbox with sizes is a basis without its rims.
#[test]
fn direct_drive_asks_nothing_of_what_stands_still_in_it() {
    let of = |words: &str| -> Request { request(words.split('|')).unwrap() };
    let two = "--ratios=4, 1|--power=22kW|--input=1500rpm|--modules=2mm|--face-widths=25mm|--planets=3..4";
    let two = of(two).answer_gears(&GO_ON).unwrap();
    assert!(
        two.file.is_some() && two.warnings.iter().all(|one| one.name != "bearing-least-load"),
        "{:?}",
        two.warnings
    );
    let sets = "--modules=3mm, 4mm|--face-widths=30mm, 50mm, 70mm|--planets=3..4";
    let three =
        of(&format!("--ratios=4.0 2.0 1|--power=60kW|--input=2200rpm|{sets}")).answer_gears(&GO_ON).unwrap();
    let file = three.file.unwrap();
    let document = Document::parse_one("three.yaml", file.as_bytes()).unwrap();
    let basis = Basis::of(&document).unwrap();
    assert!(file.contains("planet_rim") && !format!("{:?}", basis.strength).contains("rim"), "{basis:?}");
}

/// A front has the best train under each limit of the rings, and smaller rings never cost less.
#[test]
fn a_front_has_the_best_train_of_each_ring() {
    let words = "--ratio=5|--power=20kW|--input=1475rpm|--sun=18..24|--planet=27..40|--modules=2mm, 2.5mm, 3mm|--face-widths=20mm, 30mm, 40mm";
    let all = stages(&format!("{words}|--front"));
    let front = all.front.as_ref().unwrap();
    assert!(front.len() > 1, "{front:?}");
    let mut before = 0.0;
    for point in front {
        let most = point.limits[0].greatest.unwrap();
        assert!(point.ring_diameter_m <= most * (1.0 + 1e-9));
        let alone = stages(&format!("{words}|--max-ring={most}m"));
        let taken = alone.trains.iter().find(|trains| trains.taken).unwrap().best.as_ref().unwrap();
        assert_eq!((&taken.teeth, taken.rules_missed), (&point.teeth, point.rules_missed));
        assert_eq!(alone.masses.unwrap().whole_kg, point.whole_kg.unwrap());
        let price = taken.price_kg + if taken.unusual_stages > 0 { 1e6 } else { 0.0 };
        assert!(price >= before, "{point:?}");
        before = price;
    }
    assert!(stages(words).front.is_none());
}

/// Where the bearings that can be bought decide a size, others are named; not where they are chosen from.
#[test]
fn bearings_that_decide_a_size_are_told() {
    let words =
        "--ratio=5|--torque=30 kN·m|--input=60rpm|--life=60000h|--sun=20..22|--planet=28..36|--planets=3";
    let of = |kinds: &str| stages(&format!("{words}{kinds}"));
    let is_told = |of: &Stages| of.warnings.iter().any(|one| one.name == "bearings-decide");
    let whole = |of: &Stages| of.masses.unwrap().whole_kg;
    let of_tables = of("|--bearing-type=balls,rollers");
    assert!(is_told(&of_tables));
    assert!(!is_told(&of("|--bearing-type=rollers,rollers-in-bore,full-complement")));
    // Where no kinds are asked for, rollers in the bores are taken if they save a fifth of the mass.
    let open = of("");
    assert!(whole(&open) < 0.8 * whole(&of_tables), "{:?} {:?}", open.masses, of_tables.masses);
    assert_eq!(open.masses, of("|--bearing-type=balls,rollers,rollers-in-bore").masses);
}

/// Analysis, sizes and the page of a gearbox warn of roots that a duty bends both ways, as its strength does.
#[test]
fn a_torque_that_reverses_is_warned_of_by_every_command() {
    let one_way = stages(&format!("--ratio=20|--power=12kW|--input=1500rpm|{SPACE}")).file.unwrap();
    let at = one_way.find("duty:").unwrap();
    let step =
        |torque: &str| format!("- {{ gear: only, share: 0.5, torque: {torque} N·m, speed: 1500 rpm }}\n");
    let both = format!("{}duty:\n{}{}", &one_way[..at], step("60"), step("-60"));
    for (file, reverses) in [(one_way, false), (both, true)] {
        let gearbox = gearbox(&file);
        let overview = overview::answer(&gearbox, Input::default(), None).unwrap();
        let (page, _) = report::Request::default().answer(&gearbox, &GO_ON).unwrap();
        let sizes = request::<size::Request>(["--no-bearings"]).unwrap().answer(&gearbox, &GO_ON).unwrap();
        let all = [&overview.warnings, &page.overview.warnings, &page.strength[0].warnings, &sizes.warnings];
        for (place, warnings) in all.into_iter().enumerate() {
            let is_warned = warnings.iter().any(|one| one.name == "reversed-bending");
            assert_eq!(is_warned, reverses, "{place}");
        }
    }
}

/// Ratios of the file by the solver, and sizes that `size` finds again.
#[test]
fn a_list_of_gears_is_what_its_file_says() {
    for (words, asked) in [
        ("--ratios=2; 1|--power=20kW|--input=1475rpm", vec![2.0, 1.0]),
        ("--speeds=0.8 m/s, 1.6 m/s|--power=20kW|--input=1475rpm", vec![2.0, 1.0]),
        ("--ratios=2.8; 1.5; 1; -2.2|--power=20kW|--input=1475rpm", vec![2.8, 1.5, 1.0, -2.2]),
    ] {
        let more = "--modules=2mm, 3mm|--face-widths=20mm, 30mm, 40mm|--planets=3..4|--tolerance=3%";
        let asking: Request = request(format!("{words}|{more}").split('|')).unwrap();
        let design = asking.answer_gears(&GO_ON).unwrap();
        let file = design.file.as_ref().unwrap_or_else(|| panic!("{words}: {:?}", design.gearboxes));
        let gearbox = gearbox(file);
        let own = ratios(&gearbox);
        assert_eq!(own.len(), asked.len());
        for ((own, asked), gear) in own.iter().zip(asked).zip(&design.gears) {
            assert!((own / asked - 1.0).abs() < 0.03, "{words}: {own} for {asked}");
            assert!(
                (own / gear.ratio.unwrap() - 1.0).abs() < 1e-12,
                "{words}: {own} in the answer {:?}",
                gear.ratio
            );
        }
        let again = request::<size::Request>(["--no-bearings"]).unwrap().answer(&gearbox, &GO_ON).unwrap();
        let mass = design.sizes.as_ref().unwrap().mass_kg.unwrap();
        assert!(
            (again.mass_kg.unwrap() / mass - 1.0).abs() < 1e-9,
            "{words}: {:?} for {mass}",
            again.mass_kg
        );
        // Brakes and clutches are part of the whole.
        let masses = design.masses.unwrap();
        let elements = masses.shift_elements_kg.unwrap();
        let sum = masses.gears_kg + masses.structure_kg + masses.slow_shaft_kg.unwrap() + elements;
        assert!(elements > 0.0 && (sum / masses.whole_kg - 1.0).abs() < 1e-12);
        let assumed = |key: &str| design.assumed.iter().any(|one| one.key == key);
        assert!(assumed("K_γ") && assumed("shares of the gears") && assumed("standards"));
        // The taken one is the best of all that are listed.
        let rank = |of: usize| (design.gearboxes[of].mass_kg.is_none(), design.gearboxes[of].warnings);
        assert!((1..design.gearboxes.len()).all(|other| rank(0) <= rank(other)));
    }
}

/// In all three forms of the command every set of the file has the angle. `size` finds the same sizes again,
/// `strength` the same lives of bearings, and centre distances are those of normal modules.
#[test]
fn helical_teeth_are_those_of_every_set() {
    let more =
        "--power=20kW|--input=1475rpm|--modules=2mm, 3mm|--face-widths=20mm, 30mm, 40mm|--planets=3..4";
    let asking = |words: &str| request::<Request>(format!("{words}|{more}").split('|')).unwrap();
    let designed = |words: &str| {
        let asking = asking(words);
        let (file, sizes, assumed) = if words.contains("--ratio=") {
            let of = asking.answer_stages(&GO_ON).unwrap();
            (of.file, of.sizes, of.assumed)
        } else if words.contains(';') {
            let of = asking.answer_gears(&GO_ON).unwrap();
            (of.file, of.sizes, of.assumed)
        } else {
            let of = asking.answer(&|_| GO_ON()).unwrap();
            (of.file, of.sizes, of.assumed)
        };
        let told = assumed.into_iter().find(|one| one.key == "helix angle").unwrap().value;
        (file.unwrap(), sizes.unwrap(), told)
    };
    for (words, degrees) in [
        ("--ratio=20|--helix-angle=15deg", 15.0),
        ("--ratios=3.5|--helix-angle=15deg", 15.0),
        ("--ratio=5|--ring-offset=-2..-1|--helix-angle=15deg", 15.0),
        ("--ratios=2.8; 1.5; 1; -2.2|--helix-angle=-15deg", -15.0),
        ("--ratios=2; 1|--application=automatic", 20.0),
        ("--ratios=2; 1|--application=automatic|--helix-angle=0deg", 0.0),
        ("--ratio=5", 0.0),
    ] {
        let (file, sizes, told) = designed(words);
        let gearbox = gearbox(&file);
        assert_eq!(file.contains("helix_angle"), degrees != 0.0, "{words}");
        for set in gearbox.train.sets() {
            let angle = set.tooth_shape().signed_helix_angle(0).degrees();
            assert!((angle - degrees).abs() < 1e-9, "{words}: {angle}");
        }
        assert!(told.starts_with(&degrees.to_string()), "{told}");
        let again = request::<size::Request>(["--no-bearings"]).unwrap().answer(&gearbox, &GO_ON).unwrap();
        assert!((again.mass_kg.unwrap() / sizes.mass_kg.unwrap() - 1.0).abs() < 1e-9, "{words}");
        let rated = strength::Request::default().answer(&gearbox).unwrap();
        let is_promised = |name: &str| ["tilting-moment", "bearing-life"].contains(&name);
        assert!(!rated.warnings.iter().any(|one| is_promised(one.name)), "{:?}", rated.warnings);
        let found = sizes.sets.iter().flat_map(|set| &set.found[0].planet_sizes);
        for (planet, of) in found.zip(&rated.bearings) {
            let own = planet.bearing.as_ref().unwrap();
            assert_eq!(own.span_m.is_some(), degrees != 0.0, "{words}");
            // Masses of planets differ by the density of material and file.
            assert!((of.basic_life_s.unwrap() / own.life_s.unwrap() - 1.0).abs() < 1e-2, "{words}: {of:?}");
        }
        for set in &sizes.sets {
            let best = &set.found[0];
            let [sun, planet] = [0, 1].map(|gear| f64::from(best.gears[gear].teeth));
            let module = best.families[0].module_m;
            let natural = module * (sun + planet) / (2.0 * libm::cos(degrees.to_radians()));
            assert!((best.centre_distance_m - natural).abs() < 1.01 * module, "{words}: {best:?}");
        }
    }
}

/// Steps of a load are those of the file. The whole load in one step or in two gives the same gearbox, a load that
/// is rarely full a lighter one. `strength` finds its safeties again.
#[test]
fn a_load_in_steps_is_rated_by_its_steps() {
    let order = |more: &str| format!("--ratio=20|--power=12kW|--input=1500rpm|--no-bearings{more}|{SPACE}");
    let [whole, one, two, mild] = [
        "",
        "|--spectrum=100% 1",
        "|--spectrum=40 % 1 1, 60 % 1 1",
        "|--spectrum=5% 1, 65% 0.4 1.2, 30% 0 0",
    ]
    .map(|more| stages(&order(more)));
    let price = |stages: &Stages| taken(stages).price_kg;
    assert!((price(&whole) / price(&one) - 1.0).abs() < 1e-9);
    assert!((price(&whole) / price(&two) - 1.0).abs() < 1e-9);
    assert!(price(&mild) < 0.97 * price(&whole), "{} {}", price(&mild), price(&whole));
    let file = mild.file.as_ref().unwrap();
    let told = strength::Request::default().answer(&gearbox(file)).unwrap();
    let flanks = told.over_duty.iter().map(|one| one.flank.as_ref().unwrap().safety);
    let own = mild.sizes.as_ref().unwrap().sets.iter().flat_map(|set| &set.found[0].over_duty);
    for (one, other) in flanks.zip(own) {
        assert!((one / other.flank.safety - 1.0).abs() < 1e-9, "{one} {other:?}");
    }
    let duty = told.duty.iter().map(|step| (step.share, step.torque_n_m, step.speed_rad_s));
    let torque = mild.input_torque_n_m.unwrap();
    for ((share, of_torque, speed), wanted) in duty.zip([[0.05, 1.0, 1.0], [0.65, 0.4, 1.2], [0.3, 0.0, 0.0]])
    {
        let near = |one: f64, other: f64| (one - other).abs() < 1e-9 * (1.0 + other);
        let is_same = near(share, wanted[0])
            && near(of_torque, wanted[1] * torque)
            && near(speed, wanted[2] * mild.input_speed_rad_s);
        assert!(is_same, "{share} {of_torque} {speed}");
    }
    for (wrong, why) in [
        ("60% 1, 60% 0.5", "'50 %, 50 %'"),
        ("100% 0", "above 0"),
        ("50%", "over those of the load"),
        ("5% 1 0, 95% 1 1", "write 0.05 0 0"),
        ("5% 2 1, 95% 1 1", "write --overload 2 or more"),
    ] {
        let words = order(&format!("|--overload=1.5|--spectrum={wrong}"));
        let refused = match request::<Request>(words.split('|')) {
            Ok(request) => request.answer_stages(&GO_ON).unwrap_err().to_string(),
            Err(error) => error.to_string(),
        };
        assert!(refused.contains(why), "{wrong}: {refused}");
    }
}

/// Options without effect on a kind of order are refused.
#[test]
fn options_without_effect_are_refused() {
    let list = "--ratios=3.2 1.8 1|--torque=100 N·m|--input=3000rpm";
    for option in [
        "--scheme=II-3",
        "--tooth-design=2",
        "--all-structures",
        "--signs=alike",
        "--brakes=as-given",
        "--prefer=2..4",
        "--allow-crossing",
        "--may-reverse",
    ] {
        let asking: Request = request(format!("{list}|{option}").split('|')).unwrap();
        let refused = asking.answer_gears(&GO_ON).unwrap_err().to_string();
        let name = option.split('=').next().unwrap();
        assert!(refused.starts_with(&format!("{name}: leave it out")), "{refused}");
    }
    for option in ["--sun=20..25", "--planet=20..30", "--ring=60..90", "--ring-offset=0..1"] {
        let pair = "--ratio=3|--torque=100 N·m|--input=3000rpm|--axes=parallel|--stages=1";
        let asking: Request = request(format!("{pair}|{option}").split('|')).unwrap();
        let refused = asking.answer_stages(&GO_ON).unwrap_err().to_string();
        assert!(refused.contains("a pair alone has no sun, planets or ring; leave it out"), "{refused}");
    }
}

/// Sets of a list of gears have the efficiency that the order asks for. The answer shows this value.
#[test]
fn gears_of_a_list_have_the_efficiency_of_the_order() {
    let with = |efficiency: f64| {
        let words = format!(
            "--ratios=4 1|--power=22kW|--input=1500rpm|--modules=2mm|--face-widths=25mm|--planets=3|--efficiency={efficiency}"
        );
        let asking: Request = request(words.split('|')).unwrap();
        asking.answer_gears(&GO_ON).unwrap()
    };
    for efficiency in [0.95, 0.98] {
        let list = with(efficiency);
        let told = list.basis.iter().find(|key| key.key == "efficiency").unwrap();
        assert_eq!(told.value, efficiency.to_string());
        // A simple set with its ring held passes 1/i of the power on without rolling.
        let slow = list.gears[0].efficiency.unwrap();
        let ratio = list.gears[0].ratio.unwrap();
        assert!((slow - (1.0 + (ratio - 1.0) * efficiency) / ratio).abs() < 1e-9, "{slow}");
    }
}

/// Whole and length of a train are kept, and a tighter limit makes it no lighter.
#[test]
fn limits_of_the_whole_are_kept() {
    let of = |more: &str| stages(&format!("--ratio=20|--power=12kW|--input=1500rpm|{SPACE}{more}"));
    let length = |of: &Stages| {
        let sets = of.sizes.as_ref().unwrap().sets.iter();
        sets.map(|set| set.found[0].length_m).sum::<f64>()
    };
    let free = of("");
    let (whole, long) = (free.masses.unwrap().whole_kg, length(&free));
    let kept = of(&format!("|--max-mass={whole}kg|--max-length={long}m"));
    assert_eq!((&kept.ratio, kept.masses.unwrap().whole_kg), (&free.ratio, whole));
    // A shorter train may be lighter, but not of as few rules missed at the same ratio.
    let cost = |of: &Stages| (taken(of).unusual_stages, taken(of).price_kg);
    let shortest = of("|--max-length=20mm").limits.shortest_m.unwrap();
    let mut before = cost(&free);
    for part in [0.5, 0.01] {
        let most = shortest + part * (long - shortest);
        let short = of(&format!("|--max-length={most}m"));
        let own = cost(&short);
        assert!(length(&short) <= most && own >= before, "{own:?} {before:?}");
        before = own;
    }
    // What is too long or too heavy names the least, with which it is found.
    let none = of(&format!("|--max-mass={}kg", 0.5 * whole));
    let lightest = none.limits.lightest_kg.unwrap();
    assert!(none.file.is_none() && none.masses.is_none() && lightest <= whole * (1.0 + 1e-9), "{lightest}");
    assert!(of(&format!("|--max-mass={}kg", lightest * 1.001)).file.is_some());
    let none = of("|--max-length=20mm");
    assert!(none.file.is_none() && none.limits.shortest_m.unwrap() < long);
}

/// A speed without load costs no life, but rules of speeds see it.
#[test]
fn a_runaway_speed_is_judged_and_wears_nothing() {
    let of = |more: &str| stages(&format!("--ratio=20|--power=12kW|--input=1500rpm|{SPACE}{more}"));
    let checks = |of: &Stages, rule: &str| {
        let all = &of.sizes.as_ref().unwrap().judgement.checks;
        let own = all.iter().filter(|check| check.name == rule).filter_map(|check| check.value);
        own.fold(0.0, f64::max)
    };
    let (usual, fast) = (of(""), of("|--runaway=1.5"));
    for rule in ["spur-speed", "pin-speed"] {
        let [one, other] = [&usual, &fast].map(|of| checks(of, rule));
        assert!(one > 0.0 && (other / one - 1.5).abs() < 1e-9, "{rule}: {one} {other}");
    }
    let [one, other] = [&usual, &fast].map(|of| checks(of, "orbit-acceleration"));
    assert!((other / one - 2.25).abs() < 1e-9, "{one} {other}");
    let safeties = |of: &Stages| {
        let sets = of.sizes.as_ref().unwrap().sets.iter();
        let gears = sets.flat_map(|set| &set.found[0].over_duty);
        gears.map(|gear| (gear.flank.safety, gear.root.safety)).collect::<Vec<_>>()
    };
    assert_eq!(safeties(&usual), safeties(&fast));
    assert!(fast.file.unwrap().contains("share: 0"));
    // Where the speed is too high, it is warned of.
    let wild = of("|--runaway=20");
    let judgement = &wild.sizes.as_ref().unwrap().judgement;
    assert!(judgement.misses()[0] + judgement.misses()[1] > 0 && !wild.warnings.is_empty());
}

/// A side load is kept and said to be left out.
#[test]
fn a_side_load_is_not_judged_and_says_so() {
    let of = stages(&format!("--ratio=20|--power=12kW|--input=1500rpm|{SPACE}|--side-load=40kN"));
    assert_eq!(of.limits.side_load_n, Some(40e3));
    let warning = of.warnings.iter().find(|one| one.name == "side-load-not-judged").unwrap();
    assert!(warning.message.contains("40000 N"), "{}", warning.message);
}

/// `size` finds the same sizes in the file of a design, even if planets are at the limit of their gap.
#[test]
fn a_design_is_what_size_finds_in_its_file() {
    for order in [
        "--ratio=31.6|--power=90kW|--input=1485rpm|--max-ring=480mm|--application=conveyor|--factors=K_A 1.5",
        "--ratio=-53|--output-torque=14 kN·m|--input=2400rpm|--max-ring=420mm|--application=travel",
        "--ratio=10|--output-torque=45 N·m|--input=3000rpm|--max-ring=90mm|--application=robot",
    ] {
        let designed = stages(order);
        let subject = gearbox(designed.file.as_ref().unwrap());
        let found =
            request::<size::Request>(std::iter::empty::<&str>()).unwrap().answer(&subject, &GO_ON).unwrap();
        let near = |one: f64, other: f64| (one / other - 1.0).abs() < 1e-9;
        for (one, other) in designed.sizes.as_ref().unwrap().sets.iter().zip(&found.sets) {
            assert!(near(one.found[0].mass_kg, other.found[0].mass_kg), "{order}: {}", one.set);
        }
        assert_eq!(found.sets.len(), designed.sizes.unwrap().sets.len(), "{order}");
    }
}
