//! Conditions for a machine: bounds of a motor's size, a rotor that turns within the stator, chambers that
//! never vanish.
//!
//! | bound | value | why |
//! |---|---|---|
//! | module `m` | [`MODULE_MM`], 0.001 to 1000 mm | no gear is cut beyond |
//! | width `b` | [`WIDTH_MM`], 0.001 to 10 000 mm | the same |
//! | distance `l` of arc 1 | [`GREATEST_RADIUS`], 100 times `m·Z₃/2` | beyond, arc 1 is nearly straight |
//!
//! # Rotor and stator
//! Both centrodes are single-valued about the common axis, `ρ₁(θ − φ)` and `ρ₃(θ)`. The rotor passes every
//! angle `φ`, so that each of its radii comes to face each of the stator's. They overlap at no angle of the
//! rotor if and only if
//!
//! ```text
//! max ρ₁ = ρ₁(crest) < ρ₃(trough) = min ρ₃
//! ```
//!
//! which two numbers decide, without sampling. The least chamber is known in closed form
//! ([`crate::chambers`]).

use epicyclic_units::Physical;
use uom::si::f64::Length;

use crate::Error;
use crate::quantity::Quantity;
use crate::ranges::{positive_length, ranging};
use crate::tolerance::SLACK;

/// Least and greatest module of a motor, mm.
pub const MODULE_MM: [f64; 2] = [1e-3, 1e3];

/// Least and greatest width of a motor, mm.
pub const WIDTH_MM: [f64; 2] = [1e-3, 1e4];

/// The greatest distance `l` of the centre of arc 1 from the axis, over the stator's nominal radius `m·Z₃/2`.
pub const GREATEST_RADIUS: f64 = 100.0;

/// Greatest `l` in modules with this number of teeth of the stator.
pub(crate) fn greatest_distance(stator_teeth: u32) -> f64 {
    GREATEST_RADIUS * 0.5 * f64::from(stator_teeth)
}

/// Width of a machine.
///
/// # Errors
/// [`Error::NotPositive`]; [`Error::OutOfRange`] outside [`WIDTH_MM`].
pub fn width(value: Length) -> Result<Length, Error> {
    bounded(Quantity::Width, value, WIDTH_MM)
}

/// Module of a machine.
///
/// # Errors
/// [`Error::NotPositive`]; [`Error::OutOfRange`] outside [`MODULE_MM`].
pub fn module(value: Length) -> Result<Length, Error> {
    bounded(Quantity::Module, value, MODULE_MM)
}

fn bounded(quantity: Quantity, value: Length, range_mm: [f64; 2]) -> Result<Length, Error> {
    let positive = positive_length(quantity, value)?;
    let [low, high] = range_mm;
    // A value given as an end of the range is not refused by rounding.
    let slack = [low * (1.0 - SLACK), high * (1.0 + SLACK)];
    let value_mm = positive.mm();
    if ranging(quantity, value_mm, slack, "mm").is_ok() {
        Ok(value)
    } else {
        Err(Error::OutOfRange { quantity, value: value_mm, low, high, unit: "mm" })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::MotorNumbers;
    use crate::centrode::Wheel;
    use crate::closure::Family;
    use crate::closure::tests::any_motor as any_numbers;
    use crate::motor::Motor;
    use crate::second_harmonic;
    use proptest::prelude::*;
    use std::f64::consts::TAU;
    use uom::si::f64::Angle;

    fn mm(value: f64) -> Length {
        Length::from_mm(value)
    }

    /// Any motor that closes, whether its rotor turns or not.
    fn any_closed() -> impl Strategy<Value = Motor> {
        (any_numbers(), 0..4_u8).prop_map(|((numbers, part), kind)| {
            let metre = Length::from_si(1.0);
            let laws = if kind == 0 { second_harmonic::laws(numbers, 9, 0.01) } else { vec![] };
            if let Some(law) = laws.get((9.0 * part) as usize) {
                return Motor::of_law(numbers, metre, *law);
            }
            let arcs = Family::new(numbers, metre).unwrap().at_part(part).unwrap();
            Motor::of_closed_arcs(numbers, arcs)
        })
    }

    /// A centrode as a polygon in polar coordinates, over a turn from the angle 0.
    fn polygon(motor: &Motor, wheel: Wheel) -> Vec<[f64; 2]> {
        let curve = motor.centrode(wheel);
        // Corners in the middle of every crest and trough of both.
        let [outer, inner] = [motor.numbers().stator_lobes(), motor.numbers().rotor_lobes()];
        let count = outer * inner * 2 * 48_u32.div_ceil(inner);
        let whole = TAU / f64::from(count);
        let point = |i: u32| {
            let at = curve.at_polar_angle(Angle::from_si(whole * f64::from(i))).unwrap();
            [whole * f64::from(i), libm::hypot(at.x.si(), at.y.si())]
        };
        (0..count).map(point).collect()
    }

    /// Radius at which the ray at an angle meets the polygon: on the straight side between its two corners.
    fn radius(polygon: &[[f64; 2]], theta: f64) -> f64 {
        let step = TAU / polygon.len() as f64;
        let place = theta.rem_euclid(TAU) / step;
        let corner = |i: usize| polygon[i % polygon.len()];
        let ([_, from], [_, to]) = (corner(place as usize), corner(place as usize + 1));
        let off = (place - place.floor()) * step;
        from * to * libm::sin(step) / (from * libm::sin(off) + to * libm::sin(step - off))
    }

    /// Greatest depth of the rotor in the stator, by polygons at this number of angles of the rotor.
    fn depth(motor: &Motor, angles: u32) -> f64 {
        let (stator, rotor) = (polygon(motor, Wheel::Stator), polygon(motor, Wheel::Rotor));
        let mut most = f64::NEG_INFINITY;
        for i in 0..angles {
            // From where a crest faces a trough on, which 0 need not be.
            let start = TAU / f64::from(2 * motor.numbers().stator_lobes());
            let turned = start + TAU * f64::from(i) / f64::from(angles);
            for &[theta, rho] in &rotor {
                most = most.max(rho - radius(&stator, theta + turned));
            }
        }
        most
    }

    proptest! {
        /// The decision by two radii agrees with polygons turned through a whole turn, both ways; and an
        /// accepted motor has chambers.
        #[test]
        fn a_rotor_that_is_accepted_never_reaches_into_the_stator(motor in any_closed()) {
            let found = depth(&motor, 120);
            let [rotor, stator] = motor.facing_radii();
            match motor.clone().turning() {
                Ok(motor) => {
                    prop_assert!(found < 1e-3 * stator, "{found} {rotor} {stator}");
                    for i in 0..60 {
                        let chambers = motor.chambers(Angle::from_si(0.1 * f64::from(i))).unwrap();
                        prop_assert!(chambers.iter().all(|chamber| chamber.area.si() > 0.0));
                    }
                }
                Err(Error::RotorInStator { .. }) => {
                    prop_assert!(found > (rotor - stator) * (1.0 - 1e-9) - 1e-9, "{found} {rotor} {stator}");
                }
                Err(error) => {
                    prop_assert!(matches!(error, Error::NoChamber { area_mm2 } if area_mm2 <= 0.0), "{error}");
                }
            }
        }
    }

    #[test]
    fn a_rotor_in_the_stator_is_refused_with_both_radii() {
        let numbers = MotorNumbers::new(4, 2, 40, 6).unwrap();
        let arcs = Family::new(numbers, mm(2.0)).unwrap().at_part(0.5).unwrap();
        let refusal = Motor::of_two_arcs(numbers, mm(2.0), arcs.trough_distance()).unwrap_err().to_string();
        assert!(refusal.starts_with("the rotor reaches 3.97"), "{refusal}");
        assert!(refusal.contains("26.7") && refusal.contains("22.7"), "{refusal}");
    }

    #[test]
    fn sizes_beyond_a_machine_are_refused() {
        let numbers = MotorNumbers::new(5, 3, 55, 10).unwrap();
        for (size, is_module) in [(0.0009, false), (0.001, true), (1000.0, true), (1001.0, false)] {
            let family = Family::new(numbers, mm(size));
            assert_eq!(family.is_ok(), is_module, "{size}");
            let of_law = Motor::of_cosine_law(MotorNumbers::new(7, 5, 84, 11).unwrap(), mm(size));
            assert_eq!(of_law.is_ok(), is_module, "{size}");
        }
        let refusal = Family::new(numbers, mm(2e3)).unwrap_err().to_string();
        assert_eq!(refusal, "module is 2000 mm; it must lie between 0.001 and 1000 mm");
        assert!(width(mm(1e4)).is_ok() && width(mm(1.1e4)).is_err() && width(mm(0.0)).is_err());
    }
}
