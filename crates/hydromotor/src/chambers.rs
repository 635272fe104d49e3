//! The working chambers between neighbouring satellites, and the displacement.
//!
//! As the rotor turns on, a satellite at the phase `Φ` sweeps the area `f = ½·ρ₁·ρ₃` per radian. This is the
//! area swept by the rotor's side of the chord `PP₁` less that by the stator's side. The chamber in front of
//! a satellite at `Φ` has the area:
//!
//! ```text
//! A(Φ) = G(Φ + 2π/n) − G(Φ) − A₁ − π·r²        G = ∫ f dΦ        dA/dφ = f(front) − f(back)
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | `A₁` | area of the rotor's centrode over a lobe | m² |
//! | `φ` | rotation of the rotor | rad |
//!
//! `f` is even about crests and troughs and falls from crest to trough. So a chamber is greatest with a
//! stator crest in its middle and least with a trough. Their difference and the displacement are:
//!
//! ```text
//! A_max − A_min = 2·[G(π/N) + G(π/n) − G(π/N + π/n)]        q = N·n·b·(A_max − A_min)
//! ```
//!
//! The displacement follows since each of the `N + n` chambers breathes `N·n/(N + n)` times a revolution.
//!
//! # Source
//! rotary-hydromotor gives none of this; its restored vectors list `A_max − A_min` and `q/b`.

use crate::quantity::Quantity;
use crate::tolerance::EXTREME;
use uom::si::f64::{Angle, Area, Length, Volume};

use crate::Error;
use crate::contact::{By, Conjugate};
use crate::modules::{area, volume};
use crate::motor::Motor;
use crate::ranges::finite_angle;
use crate::satellites::Point;
use std::f64::consts::PI;

/// A chamber at an instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Chamber {
    /// Number of the chamber, which is in front of the satellite of that number, counter-clockwise.
    pub index: u32,
    /// Area of the chamber.
    pub area: Area,
    /// Growth of the area with the rotation, `dA/dφ`, per radian; negative while the chamber shrinks.
    pub growth: Area,
}

/// Phase of a chamber as the rotor runs counter-clockwise.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "names", derive(serde::Serialize, schemars::JsonSchema))]
#[cfg_attr(feature = "names", serde(rename_all = "snake_case"), schemars(rename = "ChamberState"))]
pub enum Phase {
    /// The chamber grows and fills from the high pressure.
    Filling,
    /// The chamber shrinks and empties into the low pressure.
    Emptying,
    /// The chamber changes over at its greatest or least area, closed to both.
    #[cfg_attr(feature = "names", serde(rename = "changing_over"))]
    AtExtreme,
}

impl Phase {
    /// Phase of a chamber among all at the same angle.
    #[must_use]
    pub fn of(chamber: &Chamber, all: &[Chamber]) -> Self {
        let most = all.iter().map(|chamber| chamber.growth.value.abs()).fold(0.0, f64::max);
        let growth = chamber.growth.value;
        if growth.abs() <= EXTREME * most {
            Self::AtExtreme
        } else if growth > 0.0 {
            Self::Filling
        } else {
            Self::Emptying
        }
    }
}

impl Motor {
    /// Chambers after a rotation of the rotor.
    ///
    /// # Errors
    /// [`Error::NotFinite`].
    ///
    /// # Example
    /// ```
    /// use epicyclic_hydromotor::{Motor, MotorNumbers};
    /// use uom::si::{angle::radian, area::square_millimeter, f64::{Angle, Length}, length::millimeter};
    ///
    /// let mm = Length::new::<millimeter>;
    /// let motor = Motor::of_two_arcs(MotorNumbers::new(5, 3, 55, 10)?, mm(1.0), mm(40.0))?;
    /// let chambers = motor.chambers(Angle::new::<radian>(0.1))?;
    /// let growth: f64 = chambers.iter().map(|c| c.growth.get::<square_millimeter>()).sum();
    /// assert!(growth.abs() < 1e-9); // what some gain the others lose
    /// # Ok::<(), epicyclic_hydromotor::Error>(())
    /// ```
    pub fn chambers(&self, rotation: Angle) -> Result<Vec<Chamber>, Error> {
        let rotation = finite_angle(Quantity::Rotation, rotation)?;
        let chamber = |index: u32| {
            let phase = self.phase(rotation, index);
            let [back, front] =
                [phase, phase + self.chamber_phase()].map(|phase| self.shape.at(By::Phase, phase));
            Chamber {
                index,
                area: area(front.swept - back.swept - self.filled(), self.module()),
                growth: area(front.flow() - back.flow(), self.module()),
            }
        };
        Ok((0..self.numbers().satellites()).map(chamber).collect())
    }

    /// Area that lobe and satellite fill between two satellites.
    fn filled(&self) -> f64 {
        let r = self.shape.satellite_radius();
        2.0 * self.shape.rotor_area() + PI * r * r
    }

    /// The least and the greatest area of a chamber.
    #[must_use]
    pub fn chamber_extremes(&self) -> [Area; 2] {
        let [least, greatest] = self.extremes();
        [area(least, self.module()), area(greatest, self.module())]
    }

    /// Least and greatest area of a chamber, in units of the module.
    pub(crate) fn extremes(&self) -> [f64; 2] {
        // The greatest has its satellites at ±π/n, the least at the trough's phase ± π/n, π/N before the next
        // crest's.
        let half = 0.5 * self.chamber_phase();
        let end = self.shape.trough();
        let swept = |phase: f64| self.shape.within(By::Phase, phase).swept;
        let greatest = 2.0 * swept(half) - self.filled();
        let least = 2.0 * (end.swept - swept(end.phase - half)) - self.filled();
        [least, greatest]
    }

    /// Displacement over width, `q/b = N·n·(A_max − A_min)`, in closed form.
    #[must_use]
    pub fn displacement_per_width(&self) -> Area {
        area(self.displacement_kernel(), self.module())
    }

    /// Displacement over width, in units of the module.
    pub(crate) fn displacement_kernel(&self) -> f64 {
        let [least, greatest] = self.extremes();
        f64::from(self.numbers().stator_lobes() * self.numbers().rotor_lobes()) * (greatest - least)
    }

    /// Displacement a revolution, `q`, at a width `b`.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for the width.
    pub fn displacement(&self, width: Length) -> Result<Volume, Error> {
        let width = crate::machine::width(width)?;
        Ok(volume(self.displacement_kernel(), self.module(), width))
    }

    /// The outline of a chamber, counter-clockwise: stator, the satellite in front, rotor, the satellite
    /// behind; each in `steps` equal pieces. The chamber's index counts on beyond the last.
    ///
    /// # Errors
    /// [`Error::NotFinite`]; [`Error::OutOfRange`] unless there are 1 to 100 000 steps.
    pub fn chamber_outline(&self, rotation: Angle, index: u32, steps: u32) -> Result<Vec<Point>, Error> {
        let points = self.outline(finite_angle(Quantity::Rotation, rotation)?, index, steps)?;
        Ok(points.into_iter().map(|[x, y]| Point { x: self.length(x), y: self.length(y) }).collect())
    }

    fn outline(&self, rotation: f64, index: u32, steps: u32) -> Result<Vec<[f64; 2]>, Error> {
        if !(1..=100_000).contains(&steps) {
            let (quantity, value) = (Quantity::Steps, f64::from(steps));
            return Err(Error::OutOfRange { quantity, value, low: 1.0, high: 1e5, unit: "" });
        }
        let index = index % self.numbers().satellites();
        let (back, front) = (self.place(rotation, index), self.place(rotation, index + 1));
        let r = self.shape.satellite_radius();
        let polar = |rho: f64, theta: f64| [rho * libm::cos(theta), rho * libm::sin(theta)];
        let part = |i: u32| f64::from(i) / f64::from(steps);
        let between = |from: f64, to: f64, i: u32| from + (to - from) * part(i);
        let mut points = Vec::with_capacity(4 * steps as usize);
        for i in 0..steps {
            let stator = self.shape.at(By::StatorArc, between(back.contact.s3, front.contact.s3, i));
            points.push(polar(stator.rho3, stator.theta3));
        }
        let on_satellite = |place: &crate::satellites::Place, from: f64, to: f64, i: u32| {
            let [x, y] = polar(r, between(from, to, i));
            [place.centre[0] + x, place.centre[1] + y]
        };
        // Clockwise about the satellites: behind the front one from stator to rotor, before the back one back
        // again.
        let (theta, mu) = (front.contact.theta3, front.contact.mu);
        points.extend((0..steps).map(|i| on_satellite(&front, theta - mu, theta + mu - PI, i)));
        // Along the rotor in its frame, lobe by lobe, and back again into the stator's.
        let lobe = 2.0 * self.shape.trough().s1;
        let (from, to) =
            (f64::from(index + 1) * lobe - front.contact.s1, f64::from(index) * lobe - back.contact.s1);
        for i in 0..steps {
            let rotor = self.shape.at(By::RotorArc, between(from, to, i));
            points.push(polar(rotor.rho1, rotor.theta1 + rotation));
        }
        let (theta, mu) = (back.contact.theta3, back.contact.mu);
        points.extend((0..steps).map(|i| on_satellite(&back, theta + mu + PI, theta - mu, i)));
        Ok(points)
    }
}

/// Area within a polygon, positive counter-clockwise.
#[cfg(test)]
pub(crate) fn polygon_area(points: &[[f64; 2]]) -> f64 {
    let next = points.iter().cycle().skip(1);
    0.5 * points.iter().zip(next).map(|(a, b)| a[0] * b[1] - a[1] * b[0]).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::centrode::tests::any_motor;
    use epicyclic_units::Physical;
    use proptest::prelude::*;

    fn get(area: Area) -> f64 {
        area.si()
    }

    #[test]
    fn the_vectors_of_the_source_are_met() {
        let m = Length::from_si;
        for (numbers, l, difference, displacement) in [
            ((5, 3, 55, 10), 40.0, 94.194_34, 1412.9151),
            ((5, 3, 55, 10), 30.0, 92.008_47, 1380.1271),
            ((6, 4, 66, 10), 40.0, 95.749_39, 2297.9853),
        ] {
            let numbers = crate::MotorNumbers::new(numbers.0, numbers.1, numbers.2, numbers.3).unwrap();
            let motor = Motor::of_two_arcs(numbers, m(1.0), m(l)).unwrap();
            let [least, greatest] = motor.chamber_extremes().map(get);
            assert!((greatest - least - difference).abs() < 5e-6, "{}", greatest - least);
            assert!((get(motor.displacement_per_width()) - displacement).abs() < 5e-5);
            let volume = motor.displacement(m(2.0)).unwrap();
            assert!((volume.value / 2.0 - displacement).abs() < 5e-5);
            assert!(motor.displacement(m(0.0)).is_err());
            assert!(motor.chamber_outline(Angle::from_si(0.0), 0, 0).is_err());
        }
    }

    proptest! {
            #![proptest_config(ProptestConfig::with_cases(64))]

            #[test]
            fn areas_sum_to_what_lies_between_the_wheels(motor in any_motor(), rotation in -9.0..9.0, other in -9.0..9.0) {
                let sum = |rotation: f64| motor.chambers(Angle::from_si(rotation)).unwrap().iter().map(|c| get(c.area)).sum::<f64>();
                let scale = get(motor.chamber_extremes()[1]) * f64::from(motor.numbers().satellites());
                prop_assert!((sum(rotation) - sum(other)).abs() < 1e-11 * scale.max(1.0) * 10.0);
            }

            #[test]
            fn an_outline_has_the_area_of_its_chamber(motor in any_motor(), rotation in -9.0..9.0, index in 0..30_u32) {
                let polygon = |steps| polygon_area(&motor.outline(rotation, index, steps).unwrap());
                // The error of a polygon falls with the square of the steps; extrapolated.
                let (coarse, fine) = (polygon(400), polygon(800));
                let area = fine + (fine - coarse) / 3.0;
                let chambers = motor.chambers(Angle::from_si(rotation)).unwrap();
                let known = get(chambers[(index % motor.numbers().satellites()) as usize].area);
                let scale = motor.satellite_radius().si().powi(2);
    // The junction of the arcs falls between two points and reduces the gain of the extrapolation.
                prop_assert!((area - known).abs() < 1e-4 * scale, "{area} {known}");
                prop_assert!((fine - known).abs() < 1e-3 * scale);
            }

            #[test]
            fn displacement_is_that_of_polygons(motor in any_motor()) {
                let polygon = |phase: f64, steps| polygon_area(&motor.outline(phase, 0, steps).unwrap());
                let half = 0.5 * motor.chamber_phase();
                let change = |steps| polygon(-half, steps) - polygon(motor.shape.trough().phase - half, steps);
                let (coarse, fine) = (change(1000), change(2000));
                let lobes = f64::from(motor.numbers().stator_lobes() * motor.numbers().rotor_lobes());
                let displacement = lobes * (fine + (fine - coarse) / 3.0);
                let closed = get(motor.displacement_per_width());
                prop_assert!((displacement - closed).abs() < 1e-6 * closed, "{displacement} {closed}");
            }

            #[test]
            fn a_chamber_stays_between_its_extremes_and_grows_by_its_rate(motor in any_motor(), rotation in -9.0..9.0) {
                let [least, greatest] = motor.chamber_extremes().map(get);
                let h = 1e-5;
                let at = |rotation: f64| motor.chambers(Angle::from_si(rotation)).unwrap();
                for ((back, here), front) in at(rotation - h).iter().zip(at(rotation)).zip(at(rotation + h)) {
                    prop_assert!(get(here.area) > least - 1e-9 && get(here.area) < greatest + 1e-9);
                    let growth = get(front.area - back.area) / (2.0 * h);
                    prop_assert!((growth - get(here.growth)).abs() < 1e-5 * greatest.max(100.0));
                }
            }
        }
}
