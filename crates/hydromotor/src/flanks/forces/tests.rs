//! Tests of the flank forces.

use super::*;
use crate::MotorNumbers;
use crate::centrode::Wheel;
use crate::centrode::tests::any_motor;
use epicyclic_units::Physical;
use proptest::prelude::*;
use std::f64::consts::PI;
use uom::si::f64::{Angle, Length, Pressure};
use uom::si::force::kilonewton;

pub(in crate::flanks) fn mm(value: f64) -> Length {
    Length::from_mm(value)
}

pub(in crate::flanks) fn mpa(value: f64) -> Pressure {
    Pressure::from_mpa(value)
}

pub(in crate::flanks) fn motor(numbers: (u32, u32, u32, u32), module: f64, l: f64) -> Motor {
    let numbers = MotorNumbers::new(numbers.0, numbers.1, numbers.2, numbers.3).unwrap();
    Motor::of_two_arcs(numbers, mm(module), mm(l)).unwrap()
}

pub(in crate::flanks) fn alpha() -> Angle {
    Angle::from_degrees(25.0)
}

/// Values of the derivation, for a motor of 6×4 lobes with 1 MPa on 1 mm: newtons are `N/(Δp·b·m)`.
#[test]
fn the_forces_of_the_derivation_are_met() {
    let motor = motor((6, 4, 66, 10), 1.0, 40.0);
    for (phase, expected) in [(0.0, 5.516890), (0.3, 5.011278), (-0.3, 6.135978)] {
        let forces = motor.flank_forces(alpha(), Angle::from_si(phase), mm(1.0), mpa(1.0)).unwrap();
        let first = forces[0];
        assert_eq!(first.push, Some(Push::Forward));
        assert!((first.force.si() - expected).abs() < 5e-7, "{}", first.force.si());
    }
    // The derivation prints −12.208865°, one more in the last digit than the closed form has.
    let mu = motor.contact(Angle::from_si(0.3)).unwrap().slope_angle;
    assert!((mu.degrees() + 12.208865).abs() < 1.5e-6, "{}", mu.degrees());
    let [crest, trough] = motor.greatest_flank_forces(alpha(), mm(1.0), mpa(1.0)).unwrap();
    assert!((crest.force.si() - 6.7580).abs() < 5e-5, "{}", crest.force.si());
    assert!((trough.force.si() - 7.1357).abs() < 5e-5, "{}", trough.force.si());
    assert_eq!((crest.push, trough.push), (Push::Forward, Push::Back));
}

#[test]
fn the_bearing_of_five_by_three_carries_34_8_kilonewtons() {
    let motor = motor((5, 3, 55, 10), 2.0, 80.0);
    let load = motor.greatest_bearing_load(alpha(), mm(50.0), mpa(20.0)).unwrap();
    assert!((load.force.get::<kilonewton>() - 34.8).abs() < 0.05, "{}", load.force.get::<kilonewton>());
    // Over a period it is nowhere greater, and reversed pressures give the same.
    for i in 0..200 {
        let rotation = Angle::from_si(motor.period() * f64::from(i) / 200.0);
        let at = motor.bearing_load(alpha(), rotation, mm(50.0), mpa(20.0)).unwrap();
        assert!(at.force <= load.force * (1.0 + 1e-12));
        assert!((libm::hypot(at.x.value, at.y.value) - at.force.value).abs() < 1e-9 * at.force.value);
        let reversed = motor.bearing_load(alpha(), -rotation, mm(50.0), mpa(-20.0)).unwrap();
        assert!((reversed.x - at.x).value.abs() < 1e-6 && (reversed.y + at.y).value.abs() < 1e-6);
    }
}

/// A motor whose flanks hold its satellites at a pressure angle.
fn held() -> impl Strategy<Value = (Motor, f64)> {
    (any_motor(), 10.0..40.0).prop_filter("held", |(motor, alpha)| {
        motor.greatest_flank_forces(Angle::from_degrees(*alpha), m(1.0), mpa(1.0)).is_ok()
    })
}

fn m(value: f64) -> Length {
    Length::from_si(value)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn torque_by_forces_is_torque_by_volumes(
        held in held(), rotation in -9.0..9.0, drop in -3e7..3e7, width in 0.01..2.0,
    ) {
        let (motor, alpha) = held;
        let (rotation, drop) = (Angle::from_si(rotation), Pressure::from_si(drop));
        let by_forces = motor.torque_by_forces(Angle::from_degrees(alpha), rotation, m(width), drop).unwrap();
        let by_volumes = motor.torque(rotation, m(width), drop).unwrap();
        let [by_forces, by_volumes] = [by_forces, by_volumes].map(Physical::si);
        prop_assert!((by_forces - by_volumes).abs() <= 1e-9 * by_volumes.abs(), "{by_forces} {by_volumes}");
    }

    /// The pressures summed over points of the drawn centrode, and the flank forces in the contacts, by cross
    /// products alone.
    #[test]
    fn forces_on_the_drawn_rotor_give_its_bearing_and_torque(held in held(), rotation in -9.0..9.0) {
        let (motor, alpha_deg) = held;
        let rotation_angle = Angle::from_si(rotation);
        let alpha = Angle::from_degrees(alpha_deg);
        let forces = motor.satellite_forces(rotation_angle, m(1.0), Pressure::from_si(1.0), Pressure::default()).unwrap();
        let flanks = motor.flank_forces(alpha, rotation_angle, m(1.0), Pressure::from_si(1.0)).unwrap();
        let (centrode, lobe) = (motor.centrode(Wheel::Rotor), 2.0 * motor.shape.trough().s1);
        let (mut sum, mut torque) = ([0.0; 2], 0.0);
        let mut add = |[x, y]: [f64; 2], [fx, fy]: [f64; 2]| {
            sum = [sum[0] + fx, sum[1] + fy];
            torque += x * fy - y * fx;
        };
        let count = forces.len();
        for j in 0..count {
            let pressure = forces[j].pressure_in_front.si();
            let s1 = |j: usize| j as f64 * lobe - motor.shape.at(By::Phase, motor.phase(rotation, j as u32)).s1;
            let point = |i: u32| {
                let s = s1(j) + (s1(j + 1) - s1(j)) * f64::from(i) / 40.0;
                let place = centrode.at(m(s)).unwrap();
                turned([place.x.si(), place.y.si()], rotation)
            };
            for i in 0..40 {
                let ([ax, ay], [bx, by]) = (point(i), point(i + 1));
                add([0.5 * (ax + bx), 0.5 * (ay + by)], [-pressure * (by - ay), pressure * (bx - ax)]);
            }
            // On the rotor the flank acts at α to its tangent, against the push: outwards of the satellite.
            let place = motor.place(rotation, j as u32);
            if let Some(push) = flanks[j].push {
                let [cx, cy] = [place.on_rotor[0] - place.centre[0], place.on_rotor[1] - place.centre[1]];
                let r = libm::hypot(cx, cy);
                let turn = if push == Push::Forward { 1.0 } else { -1.0 } * (PI / 2.0 - alpha.si());
                let n = flanks[j].force.si() / r;
                add(place.on_rotor, turned([n * cx, n * cy], -turn));
            }
        }
        let load = motor.bearing_load(alpha, rotation_angle, m(1.0), Pressure::from_si(1.0)).unwrap();
        let scale = motor.shape.trough().rho3;
        prop_assert!((load.x.si() - sum[0]).abs() < 1e-8 * scale, "{load:?} {sum:?}");
        prop_assert!((load.y.si() - sum[1]).abs() < 1e-8 * scale, "{load:?} {sum:?}");
        let volumes = motor.torque(rotation_angle, m(1.0), Pressure::from_si(1.0)).unwrap().si();
        prop_assert!((torque - volumes).abs() < 1e-9 * volumes, "{torque} {volumes}");
    }

    #[test]
    fn two_n_satellites_carry_and_each_is_near_a_crest_or_a_trough(held in held(), rotation in -9.0..9.0) {
        let (motor, alpha) = held;
        let forces = motor.flank_forces(Angle::from_degrees(alpha), Angle::from_si(rotation), m(1.0), mpa(1.0)).unwrap();
        let numbers = motor.numbers();
        let idle = forces.iter().filter(|force| force.push.is_none()).count() as u32;
        prop_assert_eq!(idle, numbers.stator_lobes() - numbers.rotor_lobes());
        let (end, half) = (motor.shape.trough().phase, PI / f64::from(numbers.stator_lobes()));
        for force in &forces {
            let phase = motor.phase(rotation, force.index).rem_euclid(2.0 * end);
            let (by_crest, by_trough) = (phase.min(2.0 * end - phase) < half, (phase - end).abs() < half);
            let push = if by_crest { Some(Push::Forward) } else { by_trough.then_some(Push::Back) };
            prop_assert_eq!(force.push, push, "{}", phase);
            prop_assert_eq!(force.force.value == 0.0, push.is_none());
        }
    }

    #[test]
    fn pressure_and_flanks_leave_a_satellite_at_rest(held in held(), rotation in -9.0..9.0, sign in prop::bool::ANY) {
        let (motor, alpha_deg) = held;
        let (high, low) = if sign { (1.0, 0.0) } else { (0.0, 1.0) };
        let drop = Pressure::from_si(high - low);
        let pressure = Pressure::from_si;
        let pushed = motor.satellite_forces(Angle::from_si(rotation), m(1.0), pressure(high), pressure(low)).unwrap();
        let flanks = motor.flank_forces(Angle::from_degrees(alpha_deg), Angle::from_si(rotation), m(1.0), drop).unwrap();
        for (force, flank) in pushed.iter().zip(&flanks) {
            let contact = motor.shape.at(By::Phase, motor.phase(rotation, force.index));
            let sigma = match flank.push { Some(Push::Forward) => 1.0, Some(Push::Back) => -1.0, None => continue };
            let n = flank.force.si();
            let [stator, rotor] = [Side::Stator, Side::Rotor].map(|side| direction(side, sigma, alpha_deg.to_radians(), contact.mu));
            prop_assert!((n * (stator[0] + rotor[0])).abs() < 1e-12 * n);
            let left = n * (stator[1] + rotor[1]) + force.force.si();
            prop_assert!(left.abs() < 1e-10 * n, "{left}");
        }
    }

    #[test]
    fn no_flank_force_of_a_revolution_exceeds_the_greatest(held in held(), drop in prop::bool::ANY) {
        let (motor, alpha) = held;
        let (alpha, drop) = (Angle::from_degrees(alpha), if drop { mpa(1.0) } else { mpa(-1.0) });
        let greatest = motor.greatest_flank_forces(alpha, m(1.0), drop).unwrap();
        let end = motor.shape.trough().phase;
        for i in 0..400 {
            for force in motor.flank_forces(alpha, Angle::from_si(motor.chamber_phase() * f64::from(i) / 400.0), m(1.0), drop).unwrap() {
                let Some(push) = force.push else { continue };
                let at = greatest.iter().position(|one| one.push == push).unwrap();
                prop_assert!(force.force <= greatest[at].force * (1.0 + 1e-12), "{force:?}");
            }
        }
        // At its rotation satellite 0 has it.
        for (one, crest) in greatest.iter().zip([true, false]) {
            let [from, to] = motor.loaded(crest);
            let inside = one.rotation.si().clamp(from + 1e-9 * end, to - 1e-9 * end);
            let first = motor.flank_forces(alpha, Angle::from_si(inside), m(1.0), drop).unwrap()[0];
            prop_assert_eq!(first.push, Some(one.push));
            // Slightly off this place a nearly radial flank may already carry much less, so the force is
            // compared with that of its own contact, exactly there.
            let sigma = if one.push == Push::Forward { 1.0 } else { -1.0 };
            let contact = motor.shape.at(By::Phase, one.rotation.si());
            let number = flank_number(motor.shape.satellite_radius(), alpha.si(), &contact, sigma).unwrap();
            prop_assert!((one.force.si() / (number * 1e6) - 1.0).abs() < 1e-12, "{one:?} {number}");
        }
    }

    #[test]
    fn the_bearing_is_free_where_the_pressures_repeat_about_the_axis(held in held(), rotation in -9.0..9.0) {
        let (motor, alpha) = held;
        let load = motor.bearing_load(Angle::from_degrees(alpha), Angle::from_si(rotation), m(1.0), Pressure::from_si(1.0)).unwrap();
        let scale = motor.shape.trough().rho3;
        let free = motor.numbers().common_divisor() > 1;
        prop_assert!(!free || load.force.si() < 1e-10 * scale, "{load:?}");
        prop_assert!(free || load.force.si() > 1e-6 * scale, "{load:?}");
    }
}

#[test]
fn bad_loads_are_refused() {
    let motor = motor((5, 3, 55, 10), 1.0, 40.0);
    let ask = |alpha, rotation, width, drop| {
        motor.flank_forces(Angle::from_degrees(alpha), Angle::from_si(rotation), mm(width), mpa(drop))
    };
    assert!(ask(25.0, 0.0, 1.0, 1.0).is_ok());
    assert!(matches!(
        ask(9.0, 0.0, 1.0, 1.0),
        Err(Error::OutOfRange { quantity: Quantity::PressureAngle, .. })
    ));
    assert!(matches!(
        ask(25.0, f64::NAN, 1.0, 1.0),
        Err(Error::NotFinite { quantity: Quantity::Rotation, .. })
    ));
    assert!(matches!(ask(25.0, 0.0, 0.0, 1.0), Err(Error::NotPositive { quantity: Quantity::Width, .. })));
    let refused = ask(25.0, 0.0, 1.0, f64::INFINITY);
    assert!(matches!(refused, Err(Error::NotFinite { quantity: Quantity::PressureDrop, .. })));
}

/// The flank of a centrode can be steeper than any teeth can hold.
#[test]
fn slopes_that_no_flank_holds_are_refused() {
    let numbers = MotorNumbers::new(7, 5, 84, 8).unwrap();
    let arcs = crate::closure::Family::new(numbers, mm(1.0)).unwrap().at_part(0.01).unwrap();
    let steep = Motor::of_closed_arcs(numbers, arcs);
    let refused = steep.greatest_flank_forces(Angle::from_degrees(40.0), mm(1.0), mpa(1.0)).unwrap_err();
    assert_eq!(refused.name(), "cannot-hold");
    assert!(refused.to_string().contains("slopes by 61.1584° against its push"), "{refused}");
    assert!(steep.greatest_flank_forces(Angle::from_degrees(20.0), mm(1.0), mpa(1.0)).is_ok());
}
