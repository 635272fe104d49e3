//! The motion of the satellites through a revolution: centre, rotation and contacts of each.
//!
//! Satellite `j` is where satellite 0 will be after `j/n` of a turn of the rotor, so that all `N + n` run one
//! behind the other. Its rotation follows equally from rolling on either wheel:
//!
//! ```text
//! α = (θ₃ − μ) − s₃/r = Φ − (θ₁ − μ) − s₁/r
//! ```

use crate::quantity::Quantity;
use epicyclic_units::Physical;
use uom::si::f64::{Angle, Length};

use crate::Error;
use crate::contact::{By, Conjugate, Contact};
use crate::motor::Motor;
use crate::ranges::finite_angle;
use epicyclic_numerics::extremes::golden;

/// A point of the stator's frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    /// Coordinate along the axis through a stator crest.
    pub x: Length,
    /// Coordinate across.
    pub y: Length,
}

/// A satellite at an instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Satellite {
    /// Number of the satellite, from 0 to `N + n − 1`, counter-clockwise.
    pub index: u32,
    /// Centre of the satellite.
    pub centre: Point,
    /// Rotation of the satellite about itself, counter-clockwise, from its place at the stator crest on the x
    /// axis.
    pub rotation: Angle,
    /// Contact with the stator.
    pub on_stator: Point,
    /// Contact with the rotor.
    pub on_rotor: Point,
}

/// A satellite's place in units of the module.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Place {
    pub(crate) contact: Contact,
    pub(crate) centre: [f64; 2],
    pub(crate) on_stator: [f64; 2],
    pub(crate) on_rotor: [f64; 2],
}

impl Motor {
    /// Satellites after a rotation of the rotor.
    ///
    /// # Errors
    /// [`Error::NotFinite`].
    ///
    /// # Example
    /// ```
    /// use epicyclic_hydromotor::{Motor, MotorNumbers};
    /// use uom::si::{angle::radian, f64::{Angle, Length}, length::millimeter};
    ///
    /// let mm = Length::new::<millimeter>;
    /// let motor = Motor::of_two_arcs(MotorNumbers::new(5, 3, 55, 10)?, mm(1.0), mm(40.0))?;
    /// let satellites = motor.satellites(Angle::new::<radian>(0.0))?;
    /// assert_eq!(satellites.len(), 8);
    /// // The first sits between two crests: 28.248 mm less its radius of 5 mm.
    /// assert!((satellites[0].centre.x.get::<millimeter>() - 23.247959950).abs() < 1e-8);
    /// # Ok::<(), epicyclic_hydromotor::Error>(())
    /// ```
    pub fn satellites(&self, rotation: Angle) -> Result<Vec<Satellite>, Error> {
        let rotation = finite_angle(Quantity::Rotation, rotation)?;
        let r = self.shape.satellite_radius();
        let point = |[x, y]: [f64; 2]| Point { x: self.length(x), y: self.length(y) };
        let satellite = |index: u32| {
            let Place { contact, centre, on_stator, on_rotor } = self.place(rotation, index);
            Satellite {
                index,
                centre: point(centre),
                rotation: Angle::from_si(contact.theta3 - contact.mu - contact.s3 / r),
                on_stator: point(on_stator),
                on_rotor: point(on_rotor),
            }
        };
        Ok((0..self.numbers().satellites()).map(satellite).collect())
    }

    pub(crate) fn place(&self, rotation_rad: f64, index: u32) -> Place {
        self.place_at(self.phase(rotation_rad, index))
    }

    pub(crate) fn place_at(&self, phase: f64) -> Place {
        let contact = self.shape.at(By::Phase, phase);
        let r = self.shape.satellite_radius();
        let (sin, cos) = libm::sincos(contact.theta3);
        let (normal_sin, normal_cos) = libm::sincos(contact.theta3 - contact.mu);
        let on_stator = [contact.rho3 * cos, contact.rho3 * sin];
        Place {
            contact,
            centre: [on_stator[0] - r * normal_cos, on_stator[1] - r * normal_sin],
            on_stator,
            on_rotor: [contact.rho1 * cos, contact.rho1 * sin],
        }
    }

    /// The least distance of neighbouring satellites' centres over a revolution, and the rotation at which
    /// one pair has it.
    ///
    /// The distance must exceed the satellite's diameter. It is evaluated for 16 rotations of half a
    /// chamber's period and where a satellite passes a jump of the curvature; every minimum that may be the
    /// least is refined by golden section.
    #[must_use]
    pub fn least_neighbour_distance(&self) -> (Length, Angle) {
        let (distance, phase) = self.least_neighbour_kernel();
        (self.length(distance), Angle::from_si(phase))
    }

    /// The distance of two neighbours, the one behind at a phase, in units of the module.
    pub(crate) fn neighbour_distance(&self, phase: f64) -> f64 {
        let [one, other] = [phase, phase + self.chamber_phase()].map(|phase| self.shape.centre(phase));
        libm::hypot(one[0] - other[0], one[1] - other[1])
    }

    /// Least distance of neighbouring satellites in units of the module, and the phase of the one behind.
    pub(crate) fn least_neighbour_kernel(&self) -> (f64, f64) {
        let distance = |phase: f64| self.neighbour_distance(phase);
        // A pair's distance is even about the middle of a crest and of a trough: phases −π/n and −π/n + half
        // a period.
        let (chamber, half) = (self.chamber_phase(), self.shape.trough().phase);
        let start = -0.5 * chamber;
        let even = (0..=ROTATIONS).map(|i| start + half * f64::from(i) / f64::from(ROTATIONS));
        let mut phases: Vec<f64> = even.collect();
        // Where one of the two passes a jump of the curvature the distance turns sharply, however narrow an
        // arc is.
        for at in
            self.shape.kink().into_iter().flat_map(|kink| [kink, -kink, kink - chamber, -kink - chamber])
        {
            let within = start + (at - start).rem_euclid(2.0 * half);
            phases.extend([within].into_iter().filter(|within| *within < start + half));
        }
        phases.sort_by(f64::total_cmp);
        let distances: Vec<f64> = phases.iter().map(|&phase| distance(phase)).collect();
        let mut best = (f64::INFINITY, start);
        for (&at, &phase) in distances.iter().zip(&phases) {
            best = if at < best.0 { (at, phase) } else { best };
        }
        let last = phases.len() - 1;
        for i in 0..=last {
            let (here, before, after) = (distances[i], i.saturating_sub(1), (i + 1).min(last));
            let [one, other] = [distances[before], distances[after]];
            // No minimum, or one far from the least: between three of its points a smooth curve falls by less
            // than it rises.
            if here > one.min(other) || here - (one.max(other) - here) > best.0 {
                continue;
            }
            // Most pairs are nearest at an end, where the distance is flat: it then rises at once.
            let inward = |part: f64| phases[i] + part * (phases[before] + phases[after] - 2.0 * phases[i]);
            let is_end = i == 0 || i == last;
            if is_end && [0.1, 0.3, 0.6].into_iter().all(|part| distance(inward(part)) >= here) {
                continue;
            }
            let (phase, least) = golden(phases[before], phases[after], 36, distance);
            best = if least < best.0 { (least, phase) } else { best };
        }
        best
    }
}

/// Rotations at which the distance of neighbours is evaluated before it is refined.
const ROTATIONS: u32 = 16;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::centrode::Wheel;
    use crate::centrode::tests::any_motor;
    use proptest::prelude::*;

    fn xy(point: Point) -> [f64; 2] {
        [point.x.si(), point.y.si()]
    }

    fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
        libm::hypot(a[0] - b[0], a[1] - b[1])
    }

    fn turned([x, y]: [f64; 2], angle: f64) -> [f64; 2] {
        let (sin, cos) = libm::sincos(angle);
        [x * cos - y * sin, x * sin + y * cos]
    }

    proptest! {
        #[test]
        fn satellites_touch_both_wheels_at_every_angle(motor in any_motor(), rotation in -20.0..20.0) {
            let r = motor.satellite_radius().si();
            let contact_slack = 1e-9;
            for satellite in motor.satellites(Angle::from_si(rotation)).unwrap() {
                let centre = xy(satellite.centre);
                prop_assert!((distance(centre, xy(satellite.on_stator)) - r).abs() < contact_slack);
                prop_assert!((distance(centre, xy(satellite.on_rotor)) - r).abs() < contact_slack);
                // The points lie on the curves, the rotor's in its own frame, with the centre on the normal.
                for (wheel, point, turn) in
                    [(Wheel::Stator, satellite.on_stator, 0.0), (Wheel::Rotor, satellite.on_rotor, rotation)]
                {
                    let point = turned(xy(point), -turn);
                    let centre = turned(centre, -turn);
                    let polar = libm::atan2(point[1], point[0]);
                    let curve = motor.centrode(wheel).at_polar_angle(Angle::from_si(polar)).unwrap();
                    prop_assert!(distance(point, [curve.x.si(), curve.y.si()]) < contact_slack, "{wheel:?}");
                    let (sin, cos) = libm::sincos(curve.tangent.si());
                    let along = (centre[0] - point[0]) * cos + (centre[1] - point[1]) * sin;
                    prop_assert!(along.abs() < contact_slack * 10.0, "{wheel:?} {along:e}");
                }
            }
        }

        #[test]
        fn satellites_roll_without_slip_on_both_wheels(motor in any_motor(), rotation in -9.0..9.0) {
            let h = 1e-5;
            let at = |rotation: f64| motor.satellites(Angle::from_si(rotation)).unwrap();
            let (back, here, front) = (at(rotation - h), at(rotation), at(rotation + h));
            for ((back, here), front) in back.iter().zip(&here).zip(&front) {
                let rate = |get: &dyn Fn(&Satellite) -> f64| (get(front) - get(back)) / (2.0 * h);
                let velocity = [rate(&|s| xy(s.centre)[0]), rate(&|s| xy(s.centre)[1])];
                let spin = rate(&|s| s.rotation.si());
                let centre = xy(here.centre);
                let of_satellite = |at: [f64; 2]| {
                    [velocity[0] - spin * (at[1] - centre[1]), velocity[1] + spin * (at[0] - centre[0])]
                };
                // On the resting stator no velocity; on the rotor that of the rotor, which turns by 1.
                let (on_stator, on_rotor) = (xy(here.on_stator), xy(here.on_rotor));
                let scale = libm::hypot(velocity[0], velocity[1]) + spin.abs() * motor.satellite_radius().si();
                prop_assert!(distance(of_satellite(on_stator), [0.0, 0.0]) < 1e-4 * scale.max(1.0));
                prop_assert!(distance(of_satellite(on_rotor), [-on_rotor[1], on_rotor[0]]) < 1e-4 * scale.max(1.0));
            }
        }

        #[test]
        fn a_turn_of_a_lobe_brings_the_next_satellite(motor in any_motor(), rotation in -3.0..3.0) {
            let lobe = motor.chamber_phase();
            let (now, then) = (motor.satellites(Angle::from_si(rotation)).unwrap(), motor.satellites(Angle::from_si(rotation + lobe)).unwrap());
            for (next, moved) in now.iter().skip(1).chain(&now[..1]).zip(&then) {
                prop_assert!(distance(xy(next.centre), xy(moved.centre)) < 1e-10);
            }
        }

        #[test]
        fn no_pair_is_nearer_than_the_least_distance(motor in any_motor(), rotation in -9.0..9.0) {
            let least = motor.least_neighbour_distance().0.si();
            let satellites = motor.satellites(Angle::from_si(rotation)).unwrap();
            for (one, other) in satellites.iter().zip(satellites.iter().skip(1).chain(&satellites[..1])) {
                prop_assert!(distance(xy(one.centre), xy(other.centre)) >= least - 1e-9);
            }
        }

        /// The least distance also holds at ever closer places around every crest and jump.
        #[test]
        fn the_least_distance_is_that_of_a_close_look(motor in any_motor()) {
            let (least, at) = motor.least_neighbour_kernel();
            prop_assert_eq!(motor.neighbour_distance(at), least);
            let (chamber, half) = (motor.chamber_phase(), motor.shape.trough().phase);
            let kinks = motor.shape.kink().into_iter().flat_map(|kink| [kink, -kink]);
            let near = kinks.chain([0.0, half, 0.5 * chamber]).flat_map(|place| [place, place - chamber]);
            let near = near.flat_map(|place| {
                (2..40).flat_map(move |k| [-1.0, 1.0].map(|side| place + side * half * 0.5_f64.powi(k)))
            });
            let even = (0..4000).map(|i| half * f64::from(i) / 2000.0);
            for phase in even.chain(near) {
                let distance = motor.neighbour_distance(phase);
                prop_assert!(distance >= least - 1e-9, "{distance} at {phase} for {least} at {at}");
            }
        }
    }
}
