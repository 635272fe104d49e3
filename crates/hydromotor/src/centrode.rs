//! The exact centrodes of stator, rotor and satellite as curves of their arc length.
//!
//! Each curve has its own frame: counter-clockwise from the middle of a crest on the x axis. The rotor's
//! curve is exact, not the arcs that the source takes for it ([`crate::two_arc_fit`]): `ρ₁ = ρ₃ − 2·r·cos μ`,
//! `s₁ = s₃ + 2·r·μ`, `θ₁ = Φ − θ₃`. The curvature follows by Euler and Savary:
//!
//! ```text
//! κ₁ = cos μ/ρ₁ − g/(1 + 2·r·g)        g = cos μ/ρ₃ − κ₃
//! ```
//!
//! Curvature is positive where the curve bends round the axis, negative on the stator's arc 1.

use crate::quantity::Quantity;
use std::f64::consts::FRAC_PI_2;

use epicyclic_units::Physical;
use uom::si::f64::{Angle, Curvature, Length};

use crate::Error;
use crate::contact::{By, Conjugate};
use crate::modules::curvature;
use crate::motor::Motor;
use crate::ranges::{finite_angle, finite_modules};

/// A wheel of the motor.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "names", derive(serde::Serialize, schemars::JsonSchema))]
#[cfg_attr(feature = "names", serde(rename_all = "snake_case"), schemars(rename = "Wheel"))]
pub enum Wheel {
    /// The outer wheel 3.
    Stator,
    /// The inner wheel 1.
    Rotor,
    /// A satellite, about its own centre.
    Satellite,
}

impl Wheel {
    /// Name of the wheel in words.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::Stator => "stator",
            Self::Rotor => "rotor",
            Self::Satellite => "satellite",
        }
    }
}

/// A point of a centrode.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CurvePoint {
    /// Arc length from the crest.
    pub arc_length: Length,
    /// Coordinate along the axis through the crest.
    pub x: Length,
    /// Coordinate across.
    pub y: Length,
    /// Distance from the axis.
    pub polar_radius: Length,
    /// Polar angle, counted on beyond a turn.
    pub polar_angle: Angle,
    /// Direction of the tangent, counted on beyond a turn.
    pub tangent: Angle,
    /// Curvature, positive round the axis.
    pub curvature: Curvature,
}

/// A centrode of a motor.
#[derive(Debug, Clone, Copy)]
pub struct Centrode<'a> {
    motor: &'a Motor,
    wheel: Wheel,
}

impl Motor {
    /// The centrode of a wheel.
    ///
    /// ```
    /// use epicyclic_hydromotor::centrode::Wheel;
    /// use epicyclic_hydromotor::{Motor, MotorNumbers};
    /// use uom::si::{curvature::radian_per_meter, f64::Length, length::millimeter};
    ///
    /// let mm = Length::new::<millimeter>;
    /// let motor = Motor::of_two_arcs(MotorNumbers::new(5, 3, 55, 10)?, mm(1.0), mm(40.0))?;
    /// let rotor = motor.centrode(Wheel::Rotor);
    /// let crest = rotor.at(mm(0.0))?;
    /// assert!((crest.x.get::<millimeter>() - 18.247959950).abs() < 1e-9);
    /// let radius_mm = 1e3 / crest.curvature.get::<radian_per_meter>();
    /// assert!((radius_mm - 7.885).abs() < 5e-4);
    /// # Ok::<(), epicyclic_hydromotor::Error>(())
    /// ```
    #[must_use]
    pub fn centrode(&self, wheel: Wheel) -> Centrode<'_> {
        Centrode { motor: self, wheel }
    }
}

impl Centrode<'_> {
    /// Length of the closed curve: `π·m` times the wheel's teeth.
    #[must_use]
    pub fn length(&self) -> Length {
        let numbers = self.motor.numbers();
        let teeth = match self.wheel {
            Wheel::Stator => numbers.stator_teeth(),
            Wheel::Rotor => numbers.rotor_teeth(),
            Wheel::Satellite => numbers.satellite_teeth(),
        };
        self.motor.length(std::f64::consts::PI * f64::from(teeth))
    }

    /// The point at an arc length; any finite one, the curve goes on and on.
    ///
    /// # Errors
    /// [`Error::NotFinite`].
    pub fn at(&self, arc_length: Length) -> Result<CurvePoint, Error> {
        let s = finite_modules(Quantity::ArcLength, arc_length, self.motor.module())?;
        Ok(match self.wheel {
            Wheel::Stator => self.point(By::StatorArc, s),
            Wheel::Rotor => self.point(By::RotorArc, s),
            Wheel::Satellite => self.round(s / self.motor.shape.satellite_radius()),
        })
    }

    /// The point at a polar angle.
    ///
    /// # Errors
    /// [`Error::NotFinite`].
    pub fn at_polar_angle(&self, polar_angle: Angle) -> Result<CurvePoint, Error> {
        let theta = finite_angle(Quantity::PolarAngle, polar_angle)?;
        Ok(match self.wheel {
            Wheel::Stator => self.point(By::StatorAngle, theta),
            Wheel::Rotor => self.point(By::RotorAngle, theta),
            Wheel::Satellite => self.round(theta),
        })
    }

    /// The point that a satellite touches after a rotation of the rotor since it stood between two crests; on
    /// the rotor, where contact goes clockwise, that of the opposite rotation.
    ///
    /// # Errors
    /// [`Error::NotFinite`].
    pub fn at_rotation(&self, rotation: Angle) -> Result<CurvePoint, Error> {
        let phase = finite_angle(Quantity::Rotation, rotation)?;
        Ok(match self.wheel {
            Wheel::Stator | Wheel::Rotor => self.point(By::Phase, phase),
            Wheel::Satellite => {
                let contact = self.motor.shape.at(By::Phase, phase);
                self.round(contact.s3 / self.motor.shape.satellite_radius())
            }
        })
    }

    fn point(&self, by: By, value: f64) -> CurvePoint {
        let contact = self.motor.shape.at(by, value);
        let (s, rho, theta, kappa) = if self.wheel == Wheel::Stator {
            (contact.s3, contact.rho3, contact.theta3, contact.kappa3)
        } else {
            (contact.s1, contact.rho1, contact.theta1, contact.kappa1)
        };
        self.curve_point(s, rho, theta, theta + FRAC_PI_2 - contact.mu, kappa)
    }

    fn round(&self, theta: f64) -> CurvePoint {
        let r = self.motor.shape.satellite_radius();
        self.curve_point(r * theta, r, theta, theta + FRAC_PI_2, r.recip())
    }

    fn curve_point(&self, s: f64, rho: f64, theta: f64, tangent: f64, kappa: f64) -> CurvePoint {
        let motor = self.motor;
        let (sin, cos) = libm::sincos(theta);
        CurvePoint {
            arc_length: motor.length(s),
            x: motor.length(rho * cos),
            y: motor.length(rho * sin),
            polar_radius: motor.length(rho),
            polar_angle: Angle::from_si(theta),
            tangent: Angle::from_si(tangent),
            curvature: curvature(kappa, motor.module()),
        }
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::closure::Family;
    use crate::closure::tests::any_motor as any_numbers;
    use crate::second_harmonic::{self, HarmonicRange};
    use proptest::prelude::*;
    use std::f64::consts::FRAC_PI_3;
    use uom::si::curvature::radian_per_meter;

    /// A random motor of two arcs, or of a cosine law, or with a second harmonic, if such a motor exists;
    /// module 1 m, so that lengths are modules.
    pub(crate) fn any_motor() -> impl Strategy<Value = Motor> {
        (any_numbers(), 0..4_u8).prop_filter_map("a rotor that turns", |((numbers, part), kind)| {
            let module = Length::from_si(1.0);
            if let (2, Ok(motor)) = (kind, Motor::of_cosine_law(numbers, module)) {
                return Some(motor);
            }
            if let (3, Ok(HarmonicRange { lower, upper })) = (kind, second_harmonic::range(numbers)) {
                let [low, high] = [lower, upper].map(|end| end.second_amplitude);
                return Motor::of_second_harmonic(numbers, module, low + part * (high - low)).ok();
            }
            let arcs = Family::new(numbers, module).unwrap().at_part(part).unwrap();
            Motor::of_two_arcs(numbers, module, arcs.trough_distance()).ok()
        })
    }

    fn m(value: f64) -> Length {
        Length::from_si(value)
    }

    fn get(value: Length) -> f64 {
        value.si()
    }

    const WHEELS: [Wheel; 3] = [Wheel::Stator, Wheel::Rotor, Wheel::Satellite];

    #[test]
    fn the_points_of_the_source_lie_on_the_curves() {
        let mm = Length::from_mm;
        let motor =
            Motor::of_two_arcs(crate::MotorNumbers::new(5, 3, 55, 10).unwrap(), mm(1.0), mm(40.0)).unwrap();
        let points = [
            (0.0, 0.0, 28.247_959_950, 18.247_959_950, 0.0),
            (0.409_418_108_7, 0.215_700_583_1, 27.471_751_115, 17.797_452_183, 0.193_717_525_6),
            (0.811_713_413_7, 0.428_956_717_8, 25.187_096_225, 16.480_682_926, 0.382_756_695_9),
            (1.210_099_069_2, 0.523_894_952_6, 24.227_411_619, 14.568_384_186, 0.686_204_116_5),
            (1.675_516_081_9, 0.628_318_530_7, 23.896_203_924, 13.896_203_924, FRAC_PI_3),
        ];
        for (phase, theta3, rho3, rho1, theta1) in points {
            let contact = motor.contact(Angle::from_si(phase)).unwrap();
            assert!((contact.stator_angle.si() - theta3).abs() < 1e-9);
            assert!((contact.rotor_angle.si() - theta1).abs() < 1e-9);
            assert!((contact.stator_radius.mm() - rho3).abs() < 1e-8);
            assert!((contact.rotor_radius.mm() - rho1).abs() < 1e-8);
        }
        // Curvature radii of the rotor: 7.885…7.852 on the image of arc 2, 272…47.6 on that of arc 1.
        let rotor = motor.centrode(Wheel::Rotor);
        let junction = motor.shape.kink().unwrap();
        let radius = |phase: f64| {
            1e3 / rotor.at_rotation(Angle::from_si(phase)).unwrap().curvature.get::<radian_per_meter>()
        };
        let radii = [radius(0.0), radius(junction - 1e-9), radius(junction + 1e-9), radius(1.675_516_081_9)];
        for (radius, printed, reach) in [(0, 7.885, 5e-4), (1, 7.852, 5e-4), (2, 272.0, 0.5), (3, 47.6, 0.05)]
        {
            assert!((radii[radius] - printed).abs() < reach, "{radii:?}");
        }
    }

    #[test]
    fn what_is_not_finite_is_refused() {
        let motor =
            Motor::of_two_arcs(crate::MotorNumbers::new(5, 3, 55, 10).unwrap(), m(1.0), m(40.0)).unwrap();
        for wheel in WHEELS {
            let curve = motor.centrode(wheel);
            assert!(
                curve.at(m(f64::NAN)).is_err() && curve.at_rotation(Angle::from_si(f64::INFINITY)).is_err()
            );
            assert!(curve.at_polar_angle(Angle::from_si(f64::NAN)).is_err());
        }
        assert!(motor.contact(Angle::from_si(f64::NAN)).is_err());
    }

    proptest! {
        #[test]
        fn half_lobes_are_equally_long_and_meet(motor in any_motor()) {
            let trough = motor.shape.trough();
            prop_assert!((trough.s1 - trough.s3).abs() <= 1e-12 * trough.s3, "{:e}", trough.s1 - trough.s3);
            for wheel in WHEELS {
                let curve = motor.centrode(wheel);
                let end = curve.at(curve.length()).unwrap();
                prop_assert!((end.polar_angle.si() - std::f64::consts::TAU).abs() < 1e-11);
                prop_assert!(get(end.y).abs() < 1e-9);
            }
        }

        #[test]
        fn arc_length_tangent_and_curvature_are_those_of_the_curve(motor in any_motor(), part in -1.3..1.7) {
            for wheel in WHEELS {
                let curve = motor.centrode(wheel);
                let s = part * get(curve.length());
                let h = 1e-4;
                let [back, here, front] = [s - h, s, s + h].map(|s| curve.at(m(s)).unwrap());
                let (dx, dy) = (get(front.x) - get(back.x), get(front.y) - get(back.y));
                prop_assert!((libm::hypot(dx, dy) / (2.0 * h) - 1.0).abs() < 1e-5);
                let (sin, cos) = libm::sincos(here.tangent.si());
                prop_assert!(((dy * cos - dx * sin) / (2.0 * h)).abs() < 1e-3);
                let kappa = here.curvature.get::<radian_per_meter>();
                let turned = (front.tangent.si() - back.tangent.si()) / (2.0 * h);
                // Not across the junction of the arcs, where it jumps.
                let jumps = (front.curvature - back.curvature).get::<radian_per_meter>().abs() > 1e-2 * kappa.abs().max(0.01);
                prop_assert!(jumps || (turned - kappa).abs() < 1e-3 * kappa.abs().max(0.01), "{wheel:?} {turned} {kappa}");
            }
        }

        #[test]
        fn the_inverse_functions_return(motor in any_motor(), rotation in -9.0..9.0) {
            for wheel in WHEELS {
                let curve = motor.centrode(wheel);
                let point = curve.at_rotation(Angle::from_si(rotation)).unwrap();
                let by_angle = curve.at_polar_angle(point.polar_angle).unwrap();
                let by_arc = curve.at(point.arc_length).unwrap();
                for other in [by_angle, by_arc] {
                    let scale = get(curve.length());
                    prop_assert!(libm::hypot(get(other.x) - get(point.x), get(other.y) - get(point.y)) < 1e-11 * scale);
                    prop_assert!((get(other.arc_length) - get(point.arc_length)).abs() < 1e-11 * scale * 5.0);
                }
            }
        }

        #[test]
        fn a_contact_is_monotone_in_the_rotation(motor in any_motor(), part in 0.0..1.0_f64) {
            let end = motor.shape.trough().phase;
            let contact = motor.shape.within(By::Phase, part * end);
            let r = motor.shape.satellite_radius();
            for by in [By::Phase, By::StatorArc, By::RotorArc, By::StatorAngle, By::RotorAngle] {
                prop_assert!(contact.slope(by, r) > 0.0);
            }
            prop_assert!((contact.phase - part * end).abs() < 1e-13);
        }
    }
}
