//! Designs for one ratio and for lists of gears: their files, calculated by other commands, are what the
//! answers say.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "helpers of tests, which clippy does not know for such"
)]

use epicyclic_commands::design::Request;
use epicyclic_commands::design::answer::stages::Stages;
use epicyclic_commands::shared::gearbox::Gearbox;
use epicyclic_commands::size;
use epicyclic_commands::words::request;
use std::ops::ControlFlow;

const GO_ON: fn() -> ControlFlow<()> = || ControlFlow::Continue(());

fn stages(words: &str) -> Stages {
    let request: Request = request(words.split('|')).unwrap();
    request.answer_stages(&GO_ON).unwrap()
}

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
    assert!(near(down.output_torque_n_m.unwrap(), 20.0 * 12e3 / down.input_speed_rad_s));
    assert!(near(up.output_torque_n_m.unwrap(), 0.05 * 12e3 / up.input_speed_rad_s));
    assert!(near(down.masses.unwrap().whole_kg, up.masses.unwrap().whole_kg));
    let taken = |stages: &Stages| {
        let best = stages.trains.iter().find(|trains| trains.taken).unwrap().best.clone().unwrap();
        best.teeth
    };
    let mut reversed = taken(&up);
    reversed.reverse();
    assert_eq!(taken(&down), reversed);
    let [down, up] = [&down, &up].map(|stages| ratios(&gearbox(stages.file.as_ref().unwrap())));
    assert!(near(down[0], 20.0) && near(up[0], 0.05), "{down:?} {up:?}");
}

/// The train that holds the greatest load has gears without common divisors where these are asked for.
#[test]
fn hunting_teeth_have_no_common_divisor() {
    let space = SPACE.replace("--tolerance=0", "--tolerance=3%");
    let found = stages(&format!("--ratio=5|--power=12kW|--input=1500rpm|--hunting-teeth|{space}"));
    let trains = found.trains.iter().filter_map(|trains| trains.best.as_ref());
    let mut seen = 0;
    for [sun, planet, ring] in trains.flat_map(|train| &train.teeth) {
        seen += 1;
        let divides = |of: u32| planet % of == 0 && (sun % of == 0 || ring % of == 0);
        assert!(!(2..=*planet).any(divides), "{sun} {planet} {ring}");
    }
    assert!(seen > 0);
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
        // The taken one is the best of all that are listed.
        let rank = |of: usize| (design.gearboxes[of].mass_kg.is_none(), design.gearboxes[of].warnings);
        assert!((1..design.gearboxes.len()).all(|other| rank(0) <= rank(other)));
    }
}
