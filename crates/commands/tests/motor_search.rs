//! Every hydromotor that the searches list can be made: its saved file is accepted together with its ports.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use epicyclic_commands::error::Error;
use epicyclic_commands::motor::answer as motor;
use epicyclic_commands::motor::answer::Motor;
use epicyclic_commands::motor::search::answer as motor_search;
use epicyclic_formats::Document;
use epicyclic_hydromotor::numbers::Bounds;
use epicyclic_hydromotor::search::{MotorSearch, Requirements, Size};
use epicyclic_units::Physical as _;
use uom::si::f64::{Length, Pressure, Volume};

/// Limits of practice: no design is refused for them.
const PRACTICE: [&str; 5] = [
    "pressure-above-usual",
    "contact-stress-above-usual",
    "ripple-above-usual",
    "trapped-pressure-above-drop",
    "trapped-pressure",
];

/// The motor of a file, with ports of this part of the ideal ones added.
fn read(saved: &str, part: f64) -> Result<Motor, Error> {
    let text = format!("{saved}ports: {{ part: {part} }}\n");
    let document = Document::parse_one("saved.yaml", text.as_bytes()).unwrap();
    let (_, designed) = motor::of_file(&document)?;
    motor::answer(&designed)
}

fn search(stator_lobes: [u32; 2], stator_teeth: [u32; 2], size: Size) -> motor_search::Wanted {
    let requirements = Requirements {
        pressure_drop: Some(Pressure::from_si(20e6)),
        size,
        ..Requirements::of_displacement(Volume::from_si(250e-6))
    };
    let bounds = Bounds {
        stator_lobes: stator_lobes[0]..=stator_lobes[1],
        stator_teeth: stator_teeth[0]..=stator_teeth[1],
        satellite_teeth: 6..=60,
    };
    let search = MotorSearch { bounds, points: 6, resolution: Some(0.2), ..MotorSearch::new(requirements) };
    let order = motor_search::Objective::Volume;
    motor_search::Wanted { search, order, first_of_each_set: false, most: usize::MAX }
}

#[test]
fn every_design_of_a_search_is_a_motor_that_can_be_made() {
    let of_width = || Size::ModulesAndWidth {
        modules: vec![Length::from_si(2e-3)],
        width: Length::from_si(40e-3),
        tolerance: 0.3,
    };
    let mut listed = 0;
    for wanted in [
        search([2, 4], [36, 60], of_width()),
        search([5, 7], [50, 70], Size::default()),
        search([3, 8], [84, 96], Size::WidthOverDiameter(0.3)),
    ] {
        let searched = motor_search::search(&wanted, &|_| std::ops::ControlFlow::Continue(())).unwrap();
        let answer = searched.answer();
        assert_eq!(answer.designs.len(), answer.found);
        for design in answer.designs.iter().step_by(4) {
            let saved = searched.saved(design.design).unwrap();
            // Some ports join no chamber to both pressures.
            let is_joined = |motor: &Motor| motor.warnings.iter().any(|one| one.name == "short-circuit");
            let motors = [0.95, 0.6, 0.4].into_iter().map(|part| read(&saved, part));
            let motor = motors.filter_map(Result::ok).find(|motor| !is_joined(motor));
            let motor = motor.expect("ports that can be made");
            assert!(
                motor.work.least_chamber_m2 > 0.0 && motor.size.rotor_outer_m < motor.size.stator_inner_m
            );
            let arcs = motor.arcs.as_ref().unwrap();
            assert!(arcs.l_m.max(arcs.r1_m) <= 100.0 * 0.5 * motor.size.stator_outer_m * 1.1, "{saved}");
            let others = motor.warnings.iter().filter(|warning| !PRACTICE.contains(&warning.name));
            assert_eq!(others.map(|warning| &warning.message).collect::<Vec<_>>(), [""; 0], "{saved}");
            assert_eq!(design.teeth_limits, motor_search::TeethLimits::Hold);
            // The same stress as that of the motor itself.
            let stresses = &motor.flanks.as_ref().unwrap().contact;
            let greatest = stresses.iter().filter_map(|one| one.alone_pa).fold(0.0, f64::max);
            assert!((design.contact_stress_pa.unwrap() / greatest - 1.0).abs() < 1e-6);
            listed += 1;
        }
        let beyond = answer.designs.iter().filter(|one| one.contact_stress_pa.unwrap() > 1600e6).count();
        let is_told = answer.warnings.iter().any(|warning| warning.name == "contact-stress-above-usual");
        assert_eq!(is_told, beyond > 0);
    }
    assert!(listed > 8, "{listed}");
}
