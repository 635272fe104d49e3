//! Every hydromotor that the searches list can be made: its saved file is accepted together with its ports.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use epicyclic_commands::error::Error;
use epicyclic_commands::motor::answer as motor;
use epicyclic_commands::motor::answer::Motor;
use epicyclic_commands::motor::designs::answer::{Listing, Searched as _};
use epicyclic_commands::motor::designs::request::Goal;
use epicyclic_commands::motor::search::Request;
use epicyclic_commands::motor::search::answer::TeethLimits;
use epicyclic_formats::Document;

/// Limits of practice: no design is refused for them.
const PRACTICE: [&str; 4] = ["motor-pressure", "contact-stress", "ripple", "trapped-pressure"];

/// The motor of a file, with ports of this part of the ideal ones added.
fn read(saved: &str, part: f64) -> Result<Motor, Error> {
    let text = format!("{saved}ports: {{ part: {part} }}\n");
    let document = Document::parse_one("saved.yaml", text.as_bytes()).unwrap();
    let (_, designed) = motor::of_file(&document)?;
    motor::answer(&designed)
}

/// Search for 250 cm³ at 20 MPa, with few places and a coarse front.
fn search(stator: &str, z3: &str, size: impl Fn(&mut Goal)) -> Request {
    let mut request: Request = epicyclic_commands::words::request(["--displacement", "250 cm3"]).unwrap();
    let mut goal = Goal {
        pressure: Some("20 MPa".parse().unwrap()),
        stator: stator.parse().unwrap(),
        z3: z3.parse().unwrap(),
        zs: "6..60".parse().unwrap(),
        ..request.goal
    };
    size(&mut goal);
    request.goal = goal;
    Request { places: 6, resolution: "20%".parse().unwrap(), ..request }
}

#[test]
fn every_design_of_a_search_is_a_motor_that_can_be_made() {
    let of_width = |goal: &mut Goal| {
        goal.module = Some("2 mm".parse().unwrap());
        goal.width = Some("40 mm".parse().unwrap());
        goal.tolerance = "30%".parse().unwrap();
    };
    let of_ratio = |goal: &mut Goal| goal.width_over_diameter = Some("0.3".parse().unwrap());
    let mut listed = 0;
    for request in [
        search("2..4", "36..60", of_width),
        search("5..7", "50..70", |_| ()),
        search("3..8", "84..96", of_ratio),
    ] {
        let searched = request.search(&|_| std::ops::ControlFlow::Continue(())).unwrap();
        let answer = searched.answer(Listing::default());
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
            assert_eq!(design.teeth_limits, TeethLimits::Hold);
            // The same stress as that of the motor itself.
            let stresses = &motor.flanks.as_ref().unwrap().contact;
            let greatest = stresses.iter().filter_map(|one| one.alone_pa).fold(0.0, f64::max);
            assert!((design.contact_stress_pa.unwrap() / greatest - 1.0).abs() < 1e-6);
            listed += 1;
        }
        let beyond = answer.designs.iter().filter(|one| one.contact_stress_pa.unwrap() > 1600e6).count();
        let is_told = answer.warnings.iter().any(|warning| warning.name == "contact-stress");
        assert_eq!(is_told, beyond > 0);
    }
    assert!(listed > 8, "{listed}");
}
