//! Tests of the torque at the start.

use super::*;
use crate::contact::By;
use crate::flanks::forces::tests::{mm, motor};
use crate::motor::Motor;
use crate::profile::ToothForm;
use epicyclic_numerics::quadrature::quadrature;
use epicyclic_units::Physical;
use std::f64::consts::PI;
use uom::si::f64::{Angle, Pressure};

const RULE: SealingContact = SealingContact::Nearest;

/// No shift, no backlash: half a space is a quarter of a pitch.
fn plain() -> ToothForm {
    ToothForm { shift: 0.0, backlash: 0.0, ..ToothForm::default() }
}

fn mpa(value: f64) -> Pressure {
    Pressure::from_mpa(value)
}

fn range(low: f64, high: f64) -> FrictionRange {
    FrictionRange::new(low, high).unwrap()
}

/// `e` brought within half a base pitch.
fn within(e: f64, pitch: f64) -> f64 {
    e - pitch * (e / pitch).round()
}

/// Friction torque over `μ_f`, by differences of the satellites' motion and the offsets of the derivation. It
/// holds for plain teeth with an even number on the satellite: spaces have their middles at whole pitches.
fn lost_by_motion(motor: &Motor, rotation: f64, width: Length, drop: Pressure) -> f64 {
    let h = 1e-6;
    let alpha = plain().pressure_angle;
    let cos = libm::cos(alpha.si());
    let pitch = PI * cos;
    let forces = motor.flank_forces(alpha, Angle::from_si(rotation), width, drop).unwrap();
    let at = |rotation: f64| motor.satellites(Angle::from_si(rotation)).unwrap();
    let (back, front) = (at(rotation - h), at(rotation + h));
    let module = motor.module().si();
    let of = |force: &super::super::FlankForce| {
        let Some(push) = force.push else { return 0.0 };
        let sigma = if push == super::super::Push::Forward { 1.0 } else { -1.0 };
        let contact = motor.shape.at(By::Phase, motor.phase(rotation, force.index));
        let e3 = within(sigma * cos * contact.s3 - 0.25 * pitch, pitch);
        let e1 = within(-sigma * cos * contact.s1 - 0.25 * pitch, pitch);
        let i = force.index as usize;
        let spin = (front[i].rotation - back[i].rotation).si() / (2.0 * h);
        force.force.value * module * ((e3 * spin).abs() + (e1 * (spin - 1.0)).abs())
    };
    forces.iter().map(of).sum()
}

#[test]
fn without_friction_it_is_the_least_at_the_flanks() {
    for form in [plain(), ToothForm::default()] {
        let profile = Profile::new(&motor((6, 4, 66, 10), 1.0, 40.0), form).unwrap();
        let start = profile.starting_torque(RULE, mm(10.0), mpa(20.0), range(0.0, 0.12)).unwrap();
        let least = profile.flank_ripple(RULE).at_flanks.least.si() * 0.01 * 20e6;
        assert!((start.frictionless.value / least - 1.0).abs() < 1e-12, "{start:?} {least}");
        assert_eq!(start.range[1], start.frictionless);
    }
}

/// No angle has less, and some have hardly more.
#[test]
fn it_is_the_least_of_all_angles() {
    for (numbers, l) in [((6, 4, 66, 10), 40.0), ((5, 3, 55, 10), 40.0)] {
        let motor = motor(numbers, 1.0, l);
        let profile = Profile::new(&motor, plain()).unwrap();
        let start = profile.starting_torque(RULE, mm(10.0), mpa(20.0), range(0.0, 0.12)).unwrap();
        let worst = start.range[0].value;
        let left = |rotation: f64| {
            let flow = profile.flank_flow_per_width(RULE, Angle::from_si(rotation)).unwrap();
            flow.si() * 0.01 * 20e6 - 0.12 * lost_by_motion(&motor, rotation, mm(10.0), mpa(20.0))
        };
        let places = 4000;
        let period = motor.period();
        let mut least = f64::INFINITY;
        for i in 0..places {
            least = least.min(left(period * (f64::from(i) + 0.5) / f64::from(places)));
        }
        assert!(least > worst * (1.0 - 1e-7) && least < worst * 1.002, "{least} {worst}");
        // At the angle itself, a hair on either side of a jump.
        let beside = [-1e-7, 1e-7].map(|hair| left(start.rotation.si() + hair));
        assert!(beside.iter().any(|value| (value / worst - 1.0).abs() < 1e-5), "{beside:?} {worst}");
    }
}

/// The mean of the friction over a period is the closed form with the mean arm `p_b/4`, but for the change of
/// forces and radii within a pitch. That change fades as teeth become many.
#[test]
fn its_mean_over_the_angle_is_that_with_the_mean_arm() {
    let mut offs = Vec::new();
    for (numbers, l) in [((6, 4, 66, 10), 40.0), ((6, 4, 132, 20), 80.0), ((6, 4, 264, 40), 160.0)] {
        let motor = motor(numbers, 1.0, l);
        let profile = Profile::new(&motor, plain()).unwrap();
        let alpha = plain().pressure_angle;
        let r = motor.shape.satellite_radius();
        let sum: f64 = Flow::new(&profile, RULE)
            .pieces_of_arms()
            .iter()
            .map(|([from, to], piece)| {
                quadrature(*from, *to, 2, |rotation| torques(piece, r, alpha.si(), rotation)[1])
            })
            .sum();
        let mean = sum / motor.period() * 0.01 * 20e6 * 1e-6;
        let [_, closed] = motor.mean_friction_torque(alpha, mm(10.0), mpa(20.0), range(0.0, 1.0)).unwrap();
        offs.push(mean / closed.value - 1.0);
    }
    assert!(offs[0].abs() < 0.01 && offs[2].abs() < 0.25 * offs[0].abs(), "{offs:?}");
}

#[test]
fn bad_inputs_are_refused() {
    let profile = Profile::new(&motor((6, 4, 66, 10), 1.0, 40.0), plain()).unwrap();
    for (width, drop) in [(0.0, 1.0), (-1.0, 1.0), (1.0, 0.0), (1.0, f64::NAN)] {
        assert!(profile.starting_torque(RULE, mm(width), mpa(drop), range(0.0, 0.1)).is_err());
    }
}
