//! Forces of the pressure on the satellites, and the ports that distribute it.
//!
//! # Forces
//! A satellite parts two chambers along the chord `PP₁ = 2r·cos μ`, which lies on a ray from the axis. The
//! pressures on its rim add up to those on the chord: a force across the ray, through the satellite's centre,
//!
//! ```text
//! F = (p_back − p_front)·b·2·r·cos μ
//! ```
//!
//! positive in the direction in which angles are counted. With equal pressures on both sides it is 0.
//!
//! # Ports
//! Ports are in the cover, at rest with the stator. Ideal ports give a chamber high pressure while it grows:
//! counter-clockwise, from a stator trough in its middle to the next crest. A port needs no more than a hole
//! that a satellite just covers. It covers the hole while it has a chamber at its greatest in front, at the
//! phase `−π/n`, and until it has one at its least behind, at `−π/N`. The hole is within the lens that the
//! two discs share. The high ports are behind the crests, the low ones before; the other way round the motor
//! turns back.
//!
//! Left out: inertia, friction. The contact forces of the teeth, which share `F` between stator and rotor,
//! are in [`crate::flanks`].

use crate::quantity::Quantity;
use epicyclic_units::Physical;
use uom::si::f64::{Angle, Force, Length, Pressure};

use crate::Error;
use crate::contact::{By, Conjugate};
use crate::motor::Motor;
use crate::ranges::{finite_angle, finite_pressure};

/// The force of the pressures on a satellite.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SatelliteForce {
    /// Number of the satellite.
    pub index: u32,
    /// Pressure in the chamber behind it.
    pub pressure_behind: Pressure,
    /// Pressure in the chamber in front of it.
    pub pressure_in_front: Pressure,
    /// Polar angle of its contacts; the force is at right angles to that ray.
    pub ray: Angle,
    /// The chord on which the pressures act.
    pub chord: Length,
    /// The force, positive the way that angles are counted.
    pub force: Force,
}

/// An ideal port in the cover.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Port {
    /// Distance of the lens' centre from the axis.
    pub centre_radius: Length,
    /// Polar angle of the lens' centre, from the stator's crest at 0.
    pub angle: Angle,
    /// The greatest round hole within the lens, its diameter; none at or below 0.
    pub greatest_diameter: Length,
}

/// The ports of a motor that turns counter-clockwise.
#[derive(Debug, Clone, PartialEq)]
pub struct Ports {
    /// Ports with high pressure, one behind every crest.
    pub high: Vec<Port>,
    /// Ports with low pressure, one before every crest.
    pub low: Vec<Port>,
    /// Rotation of the rotor for which a satellite keeps a port covered: `π/n − π/N`.
    pub covered: Angle,
    /// Rotation of the rotor for which the port is open to one chamber: the rest of `2π/n`.
    pub open: Angle,
}

impl Motor {
    /// The forces of the pressures on all satellites after a rotation, with ideal ports; chambers that just
    /// change over have the low pressure.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for the width, [`Error::NotFinite`] for the others.
    ///
    /// # Example
    /// ```
    /// use epicyclic_hydromotor::{Motor, MotorNumbers};
    /// use uom::si::f64::{Angle, Length, Pressure};
    /// use uom::si::{angle::radian, force::newton, length::millimeter, pressure::megapascal};
    ///
    /// let mm = Length::new::<millimeter>;
    /// let motor = Motor::of_two_arcs(MotorNumbers::new(5, 3, 55, 10)?, mm(2.0), mm(80.0))?;
    /// let mpa = Pressure::new::<megapascal>;
    /// let forces = motor.satellite_forces(Angle::new::<radian>(0.1), mm(50.0), mpa(20.0), mpa(0.0))?;
    /// // At most 20 MPa on a chord of 20 mm over 50 mm.
    /// assert!(forces.iter().all(|f| f.force.get::<newton>().abs() <= 20_000.0));
    /// # Ok::<(), epicyclic_hydromotor::Error>(())
    /// ```
    pub fn satellite_forces(
        &self,
        rotation: Angle,
        width: Length,
        high: Pressure,
        low: Pressure,
    ) -> Result<Vec<SatelliteForce>, Error> {
        let rotation = finite_angle(Quantity::Rotation, rotation)?;
        let width = crate::machine::width(width)?;
        let (high, low) =
            (finite_pressure(Quantity::HighPressure, high)?, finite_pressure(Quantity::LowPressure, low)?);
        let count = self.numbers().satellites();
        let contacts: Vec<_> =
            (0..count).map(|j| self.shape.at(By::Phase, self.phase(rotation, j))).collect();
        let flow = |j: u32| contacts[(j % count) as usize].flow();
        let pressure = |chamber: u32| if flow(chamber + 1) > flow(chamber) { high } else { low };
        let on_satellite = |index: u32| {
            let contact = &contacts[index as usize];
            let (pressure_behind, pressure_in_front) =
                (pressure((index + count - 1) % count), pressure(index));
            let chord = self.length(contact.rho3 - contact.rho1);
            SatelliteForce {
                index,
                pressure_behind,
                pressure_in_front,
                ray: Angle::from_si(contact.theta3),
                chord,
                force: chord * width * (pressure_behind - pressure_in_front),
            }
        };
        Ok((0..count).map(on_satellite).collect())
    }

    /// The ideal ports.
    #[must_use]
    pub fn ports(&self) -> Ports {
        let (to_crest, to_trough) = (0.5 * self.chamber_phase(), self.shape.trough().theta3);
        let [one, other] = [-to_crest, -to_trough].map(|phase| self.place_at(phase).centre);
        let (x, y) = (0.5 * (one[0] + other[0]), 0.5 * (one[1] + other[1]));
        let apart = libm::hypot(one[0] - other[0], one[1] - other[1]);
        let port = |behind: f64, crest: u32| Port {
            centre_radius: self.length(libm::hypot(x, y)),
            angle: Angle::from_si(behind * libm::atan2(y, x) + 2.0 * to_trough * f64::from(crest)),
            greatest_diameter: self.length(2.0 * self.shape.satellite_radius() - apart),
        };
        let crests = 0..self.numbers().stator_lobes();
        let covered = to_crest - to_trough;
        Ports {
            high: crests.clone().map(|crest| port(1.0, crest)).collect(),
            low: crests.map(|crest| port(-1.0, crest)).collect(),
            covered: Angle::from_si(covered),
            open: Angle::from_si(2.0 * to_crest - covered),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::centrode::tests::any_motor;
    use proptest::prelude::*;

    fn m(value: f64) -> Length {
        Length::from_si(value)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(48))]

        #[test]
        fn the_forces_do_the_work_of_the_torque(motor in any_motor(), rotation in -9.0..9.0, drop in 1.0..3e7) {
            // Each satellite sweeps f·dφ and so does the work (p_back − p_front)·b·f·dφ.
            let pressure = Pressure::from_si;
            let forces = motor.satellite_forces(Angle::from_si(rotation), m(0.5), pressure(drop), pressure(0.0)).unwrap();
            let work: f64 = forces.iter().map(|force| {
                let (back, front) = (force.pressure_behind.si(), force.pressure_in_front.si());
                (back - front) * 0.5 * motor.shape.at(By::Phase, motor.phase(rotation, force.index)).flow()
            }).sum();
            let torque = motor.torque(Angle::from_si(rotation), m(0.5), pressure(drop)).unwrap().value;
            prop_assert!((work - torque).abs() < 1e-9 * torque.abs(), "{work} {torque}");
            for force in &forces {
                let chord = force.chord.si();
                prop_assert!(chord > 0.0 && chord <= 2.0 * motor.satellite_radius().si() + 1e-12);
                let step = (force.pressure_behind - force.pressure_in_front).si();
                prop_assert!((force.force.si() - step * chord * 0.5).abs() <= 1e-9 * drop * chord);
            }
        }

        #[test]
        fn a_port_sees_one_growing_chamber_and_no_other(motor in any_motor(), part in 0.0..1.0) {
            // While no satellite covers the centre of a high port, the chamber about it grows.
            let ports = motor.ports();
            let r = motor.satellite_radius().si();
            let port = &ports.high[0];
            let radius = port.greatest_diameter.si() / 2.0;
            prop_assume!(radius > 0.0);
            let (sin, cos) = libm::sincos(port.angle.si());
            let centre = [port.centre_radius.si() * cos, port.centre_radius.si() * sin];
            let rotation = part * motor.chamber_phase();
            let places: Vec<_> = (0..motor.numbers().satellites()).map(|j| motor.place(rotation, j)).collect();
            let covered = places.iter().any(|place| {
                libm::hypot(place.centre[0] - centre[0], place.centre[1] - centre[1]) <= r - radius + 1e-9
            });
            // The satellite behind the port is the last whose phase is below that of the cover's end.
            let (early, late) = (-0.5 * motor.chamber_phase(), -motor.shape.trough().theta3);
            let lobe = motor.chamber_phase();
            let behind = early - lobe + (rotation - early).rem_euclid(lobe);
            let front = behind + motor.chamber_phase();
            let between = front >= early && front <= late;
            prop_assert!(!between || covered || (front - early).min(late - front) < 1e-9);
            if !between {
                let growth = motor.shape.flow(front).0 - motor.shape.flow(behind).0;
                prop_assert!(growth >= -1e-9 * motor.shape.flow(0.0).0);
            }
        }
    }

    #[test]
    fn bad_inputs_are_refused() {
        let numbers = crate::MotorNumbers::new(5, 3, 55, 10).unwrap();
        let motor = Motor::of_two_arcs(numbers, m(1.0), m(40.0)).unwrap();
        let pressure = Pressure::from_si;
        assert!(motor.satellite_forces(Angle::from_si(0.0), m(0.0), pressure(1.0), pressure(0.0)).is_err());
        assert!(
            motor.satellite_forces(Angle::from_si(0.0), m(1.0), pressure(f64::NAN), pressure(0.0)).is_err()
        );
        assert!(
            motor.satellite_forces(Angle::from_si(f64::NAN), m(1.0), pressure(1.0), pressure(0.0)).is_err()
        );
    }
}
