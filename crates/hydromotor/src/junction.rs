//! Formulas (2)–(8): the point `P₁` of the rotor where the images of the stator's two arcs meet.
//!
//! ```text
//! O P₁ = 2·l·(R₁ + r)·(b − cos Γ)/OP                   (2)
//! b = (l² + R₁² + 2·R₁·r)/(2·l·(R₁ + r))               (3)
//! OP² = l² + R₁² − 2·l·R₁·cos Γ                        (4)
//! Π = 2·k·arctan(h·tan(Γ/2)) − Γ − T                   (5)
//! h = ((b + 1)/(b − 1))^½                              (6)
//! k = (b − R₁/l)·(b² − 1)^−½                           (7)
//! T = arccos((l − R₁·cos Γ)/OP)                        (8)
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | `OP`, `OP₁` | distances of the junctions of stator and rotor from the axis | m |
//! | `T`, `Π` | their polar angles on stator and rotor, from the trough | rad |
//! | `r` | pitch radius of the satellite, `m·Z_s/2` | m |
//! | `b`, `h`, `k` | helpers | 1 |
//!
//! Here `l − R₁` is taken as one number, so that a large `l` costs no digits.
//!
//! # Source
//! rotary-hydromotor (2)–(8). In (2) it prints `O₁P₁`, which is the distance from the *rotor's* centre; in (4) the copy lost
//! the root; (6)–(8) are restored by integrating the rolling, of which (5) is the primitive.

use crate::quantity::Quantity;
use uom::si::f64::{Angle, Length};

use crate::Error;
use crate::arcs::{Arcs, StatorArcs};
use crate::numbers::MotorNumbers;
use crate::units::{angle, length, millimetres};

/// The junction of the rotor's arcs, and what formulas (2)–(8) pass on the way.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Junction {
    /// `b` of (3).
    pub b: f64,
    /// `h` of (6).
    pub h: f64,
    /// `k` of (7).
    pub k: f64,
    /// `OP` of (4): distance of the stator's junction from the axis.
    pub stator_radius: Length,
    /// `T` of (8): its polar angle from the stator's trough.
    pub stator_angle: Angle,
    /// `OP₁` of (2): distance of the rotor's junction from the axis.
    pub rotor_radius: Length,
    /// `Π` of (5): its polar angle from the rotor's trough.
    pub rotor_angle: Angle,
}

/// Formulas (2)–(8).
///
/// # Errors
/// [`Error::OutOfRange`] where the arcs leave the rotor no least radius, `l − R₁ ≤ 2r`: `b ≤ 1` then.
///
/// # Example
/// ```
/// use epicyclic_hydromotor::closure::Family;
/// use epicyclic_hydromotor::{MotorNumbers, junction};
/// use uom::si::{angle::radian, f64::Length, length::millimeter};
///
/// let mm = Length::new::<millimeter>;
/// let numbers = MotorNumbers::new(5, 3, 55, 10)?;
/// let arcs = Family::new(numbers, mm(1.0))?.at(mm(40.0))?;
/// let junction = junction::junction(numbers, &arcs)?;
/// assert!((junction.rotor_radius.get::<millimeter>() - 16.480682926).abs() < 1e-8);
/// // The rotor's half-lobe spans π/3; from the crest it is 0.3827566959.
/// let from_crest = std::f64::consts::FRAC_PI_3 - junction.rotor_angle.get::<radian>();
/// assert!((from_crest - 0.3827566959).abs() < 1e-9);
/// # Ok::<(), epicyclic_hydromotor::Error>(())
/// ```
pub fn junction(numbers: MotorNumbers, arcs: &StatorArcs) -> Result<Junction, Error> {
    let r = f64::from(numbers.satellite_teeth()) / 2.0;
    let Arcs { l, r1, gamma, least, .. } = arcs.arcs;
    if least <= 2.0 * r {
        let [value, low] = [least, 2.0 * r].map(|modules| millimetres(length(modules, arcs.module)));
        return Err(Error::OutOfRange {
            quantity: Quantity::TroughDistanceLessRadius,
            value,
            low,
            high: f64::INFINITY,
            unit: "mm",
        });
    }
    // b ∓ 1 as products: (l − R₁)·(l − R₁ − 2r) and (l + R₁)·(l + R₁ + 2r) over 2·l·(R₁ + r).
    let twice = 2.0 * l * (r1 + r);
    let (below, above) = (least * (least - 2.0 * r) / twice, (l + r1) * (l + r1 + 2.0 * r) / twice);
    let (half_sine, sine) = (libm::sin(gamma / 2.0), libm::sin(gamma));
    let op = (least * least + 4.0 * l * r1 * half_sine * half_sine).sqrt();
    let h = (above / below).sqrt();
    // b − R₁/l = (l² − R₁²)/(2·l·(R₁ + r))
    let k = least * (l + r1) / twice / (below * above).sqrt();
    // The angle whose cosine is (l − R₁·cos Γ)/OP has the sine R₁·sin Γ/OP: no digits lost near 0.
    let t = libm::atan2(r1 * sine, least + 2.0 * r1 * half_sine * half_sine);
    Ok(Junction {
        b: (l * l + r1 * r1 + 2.0 * r1 * r) / twice,
        h,
        k,
        stator_radius: length(op, arcs.module),
        stator_angle: angle(t),
        rotor_radius: length(twice * (below + 2.0 * half_sine * half_sine) / op, arcs.module),
        rotor_angle: angle(2.0 * k * libm::atan(h * arcs.arcs.tan_gamma) - gamma - t),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::closure::Family;
    use crate::closure::tests::any_motor;
    use crate::roots::quadrature;
    use crate::units::radians;
    use proptest::prelude::*;
    use uom::si::length::millimeter;

    fn mm(value: f64) -> Length {
        Length::new::<millimeter>(value)
    }

    #[test]
    fn a_rotor_without_a_least_radius_has_no_junction() {
        let numbers = MotorNumbers::new(5, 3, 55, 10).unwrap();
        let family = Family::new(numbers, mm(2.0)).unwrap();
        let arcs = family.at(mm(80.0)).unwrap();
        let huge = MotorNumbers::new(9, 6, 270, 44).unwrap();
        assert!(matches!(
            junction(huge, &arcs),
            Err(Error::OutOfRange { quantity: Quantity::TroughDistanceLessRadius, .. })
        ));
    }

    proptest! {
        #[test]
        fn the_formulas_equal_the_quadrature_of_the_rolling(motor in any_motor()) {
            let (numbers, part) = motor;
            let arcs = Family::new(numbers, mm(1.0)).unwrap().at_part(part).unwrap();
            let found = junction(numbers, &arcs).unwrap();
            let Arcs { r1, gamma, least, .. } = arcs.arcs;
            let r = f64::from(numbers.satellite_teeth()) / 2.0;
            // P, and cos μ with the normal towards O₁.
            let place = |x: f64| {
                let p = (least + 2.0 * r1 * libm::sin(x / 2.0).powi(2), r1 * libm::sin(x));
                let rho3 = libm::hypot(p.0, p.1);
                let cos_mu = (p.0 * libm::cos(x) - p.1 * libm::sin(x)) / rho3;
                (rho3, cos_mu, rho3 - 2.0 * r * cos_mu)
            };
            let (end3, _, end1) = place(gamma);
            // The rotor turns by 2·cos μ·(1 + r/R₁)/ρ₁·ds₃, less what the point goes on the stator.
            let rate = |x: f64| {
                let (rho3, cos_mu, rho1) = place(x);
                (2.0 * cos_mu * (1.0 + r / r1) / rho1 - cos_mu / rho3) * r1
            };
            let angle = quadrature(0.0, gamma, 128, rate);
            let on_stator = quadrature(0.0, gamma, 128, |x| {
                let (rho3, cos_mu, _) = place(x);
                cos_mu / rho3 * r1
            });
            let scale = end3;
            prop_assert!((found.stator_radius.get::<millimeter>() - end3).abs() < 1e-13 * scale);
            prop_assert!((found.rotor_radius.get::<millimeter>() - end1).abs() < 1e-12 * scale);
            prop_assert!((radians(found.stator_angle) - on_stator).abs() < 1e-11);
            prop_assert!((radians(found.rotor_angle) - angle).abs() < 1e-11);
        }
    }
}
