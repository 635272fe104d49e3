use super::*;
use crate::MotorNumbers;
use epicyclic_units::Physical;
use proptest::prelude::*;
use uom::si::f64::{Angle, AngularVelocity, DynamicViscosity, Length, Pressure};

fn mm(value: f64) -> Length {
    Length::from_mm(value)
}

fn mpa(value: f64) -> Pressure {
    Pressure::from_mpa(value)
}

fn motor(module: f64) -> Motor {
    Motor::of_two_arcs(MotorNumbers::new(6, 4, 66, 10).unwrap(), mm(module), mm(40.0 * module)).unwrap()
}

fn alpha() -> Angle {
    Angle::from_degrees(25.0)
}

fn range(low: f64, high: f64) -> FrictionRange {
    FrictionRange::new(low, high).unwrap()
}

fn part(motor: &Motor, width: Length, drop: Pressure, friction: f64) -> f64 {
    let [low, high] = motor.mean_friction_torque(alpha(), width, drop, range(0.0, friction)).unwrap();
    assert_eq!(low.value, 0.0);
    (high / motor.theoretical_torque(width, drop).unwrap()).value
}

/// Sliding by differences of the satellites' motion, and of pairs spread over a base pitch: power over `μ_f`
/// a radian.
fn loss_by_motion(motor: &Motor, rotation: f64, width: Length, drop: Pressure) -> f64 {
    const PAIRS: u32 = 200;
    let h = 1e-6;
    let forces = motor.flank_forces(alpha(), Angle::from_si(rotation), width, drop).unwrap();
    let at = |rotation: f64| motor.satellites(Angle::from_si(rotation)).unwrap();
    let pitch = PI * motor.module().si() * libm::cos(alpha().si());
    at(rotation - h)
        .iter()
        .zip(at(rotation + h))
        .zip(forces)
        .map(|((back, front), force)| {
            let spin = (front.rotation - back.rotation).si() / (2.0 * h);
            let slid: f64 = (0..PAIRS)
                .map(|i| {
                    let e = pitch * ((f64::from(i) + 0.5) / f64::from(PAIRS) - 0.5);
                    (e * spin).abs() + (e * (spin - 1.0)).abs()
                })
                .sum();
            force.force.value * slid / f64::from(PAIRS)
        })
        .sum()
}

#[test]
fn the_part_lost_is_that_computed_apart() {
    assert!((part(&motor(1.0), mm(20.0), mpa(20.0), 0.1) - 0.0469).abs() < 5e-5);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    #[test]
    fn the_part_lost_depends_on_shape_and_friction_alone(
        module in 0.5..4.0, width in 5.0..80.0, drop in 1.0..40.0, friction in 0.0..0.3,
    ) {
        let one = part(&motor(1.0), mm(20.0), mpa(20.0), 0.1);
        let other = part(&motor(module), mm(width), mpa(drop), friction);
        prop_assert!((other - 10.0 * friction * one).abs() < 1e-12);
    }

    #[test]
    fn the_loss_is_that_of_the_satellites_motion(rotation in -9.0..9.0, lobes in prop::sample::select(vec![(6, 66, 40.0), (5, 55, 40.0)])) {
        let (stator, teeth, l) = lobes;
        let numbers = MotorNumbers::new(stator, stator - 2, teeth, 10).unwrap();
        let motor = Motor::of_two_arcs(numbers, mm(1.0), mm(l)).unwrap();
        let [_, loss] = motor.friction_torque(alpha(), Angle::from_si(rotation), mm(10.0), mpa(10.0), range(0.0, 1.0)).unwrap();
        let by_motion = loss_by_motion(&motor, rotation, mm(10.0), mpa(10.0));
        prop_assert!((loss.value / by_motion - 1.0).abs() < 1e-6, "{} {by_motion}", loss.value);
    }
}

#[test]
fn the_mean_loss_is_that_of_all_angles() {
    let motor = motor(1.0);
    let period = TAU / 12.0;
    let sum: f64 = (0..2000)
        .map(|i| loss_by_motion(&motor, period * (f64::from(i) + 0.5) / 2000.0, mm(10.0), mpa(10.0)))
        .sum();
    let [_, mean] = motor.mean_friction_torque(alpha(), mm(10.0), mpa(10.0), range(0.0, 1.0)).unwrap();
    assert!((mean.value / (sum / 2000.0) - 1.0).abs() < 1e-5, "{}", mean.value);
}

#[test]
fn the_drag_is_that_of_points_of_the_faces() {
    let motor = motor(1.0);
    let um = Length::from_um;
    let gaps = EndGaps { satellite: um(8.0), rotor: um(12.0) };
    let viscosity = DynamicViscosity::from_si(0.03);
    let speed = AngularVelocity::from_si;
    let drag = motor.gap_drag(gaps, viscosity, mm(6.0), speed(30.0)).unwrap();
    // The velocity of points spread over a satellite, by differences of its motion.
    let (h, r) = (1e-6, 5e-3);
    let mut sum = 0.0;
    let rotations = 200;
    for i in 0..rotations {
        let rotation = TAU / 12.0 * (f64::from(i) + 0.5) / f64::from(rotations);
        let at = |rotation: f64| motor.satellites(Angle::from_si(rotation)).unwrap();
        for (back, front) in at(rotation - h).iter().zip(at(rotation + h)) {
            let rate = |a: f64, b: f64| (b - a) / (2.0 * h);
            let velocity = [
                rate(back.centre.x.value, front.centre.x.value),
                rate(back.centre.y.value, front.centre.y.value),
            ];
            let spin = rate(back.rotation.si(), front.rotation.si());
            for ring in 0..20 {
                let rho = r * ((f64::from(ring) + 0.5) / 20.0_f64).sqrt();
                for k in 0..12 {
                    let (sin, cos) = libm::sincos(TAU * f64::from(k) / 12.0);
                    let [u, v] = [velocity[0] - spin * rho * sin, velocity[1] + spin * rho * cos];
                    sum += (u * u + v * v) * PI * r * r / 240.0;
                }
            }
        }
    }
    let satellites = 2.0 * 0.03 / 8e-6 * sum / f64::from(rotations) * 30.0;
    // Twenty rings of equal area miss nothing of ρ², but for its place within a ring.
    assert!(
        (drag.satellites.value / satellites - 1.0).abs() < 1e-3,
        "{} {satellites}",
        drag.satellites.value
    );
    // The rotor's face by triangles from the axis: ∫ρ² dA = base·height³/4 + …, here by points.
    let curve = motor.centrode(crate::centrode::Wheel::Rotor);
    let mut face = 0.0;
    for i in 0..20_000 {
        let theta = TAU * (f64::from(i) + 0.5) / 20_000.0;
        let point = curve.at_polar_angle(Angle::from_si(theta)).unwrap();
        let rho = libm::hypot(point.x.value, point.y.value);
        face += TAU / 20_000.0 * (rho.powi(4) - 6e-3_f64.powi(4)) / 4.0;
    }
    let rotor = 2.0 * 0.03 / 12e-6 * face * 30.0;
    assert!((drag.rotor.value / rotor - 1.0).abs() < 1e-6, "{} {rotor}", drag.rotor.value);
    let ideal = EndGaps { satellite: um(0.0), rotor: um(0.0) };
    let none = motor.gap_drag(ideal, viscosity, mm(0.0), speed(30.0)).unwrap();
    assert_eq!((none.satellites.value, none.rotor.value), (0.0, 0.0));
    assert!(motor.gap_drag(gaps, viscosity, mm(60.0), speed(30.0)).is_err());
    assert!(motor.gap_drag(gaps, viscosity, mm(1.0), speed(-1.0)).is_err());
    assert!(motor.gap_drag(gaps, DynamicViscosity::from_si(0.0), mm(1.0), speed(1.0)).is_err());
    assert!(motor.gap_drag(EndGaps { rotor: um(-1.0), ..gaps }, viscosity, mm(1.0), speed(1.0)).is_err());
}

#[test]
fn bad_ranges_are_refused() {
    for (low, high) in [(-0.1, 0.1), (0.2, 0.1), (0.1, 1.5), (f64::NAN, 0.1), (0.1, f64::NAN)] {
        assert!(matches!(FrictionRange::new(low, high), Err(Error::OutOfRange { .. })), "{low} {high}");
    }
    let motor = motor(1.0);
    assert!(motor.mean_friction_torque(alpha(), mm(1.0), mpa(0.0), range(0.0, 0.1)).is_err());
    assert!(motor.mean_friction_torque(Angle::from_si(0.0), mm(1.0), mpa(1.0), range(0.0, 0.1)).is_err());
    assert!(
        motor.friction_torque(alpha(), Angle::from_si(f64::NAN), mm(1.0), mpa(1.0), range(0.0, 0.1)).is_err()
    );
}
