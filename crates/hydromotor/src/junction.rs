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
//! rotary-hydromotor (2)–(8). In (2) it prints `O₁P₁`, which is the distance from the *rotor's* centre; in
//! (4) the copy lost the root. (6)–(8) are restored by integrating the rolling; (5) is the primitive of that
//! integral.

use epicyclic_units::Physical;
use uom::si::f64::{Angle, Length};

use crate::Error;
use crate::arcs::{Arcs, StatorArcs};
use crate::closure::rolling_radius;
use crate::contact::{By, Conjugate as _};
use crate::modules::length;
use crate::motor::SatelliteContact;
use crate::numbers::MotorNumbers;
use crate::two_arcs::TwoArcs;

/// The junction of the rotor's arcs, and the intermediate values of formulas (2)–(8).
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
/// [`Error::OutOfRange`] if the arcs leave the rotor no least radius, `l − R₁ ≤ 2r`, and then `b ≤ 1`; also
/// if the satellite is no smaller than arc 2, `R₂ ≤ r`.
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
    let r = rolling_radius(numbers, arcs)?;
    let Arcs { l, r1, gamma, least, .. } = arcs.arcs;
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
        stator_angle: Angle::from_si(t),
        rotor_radius: length(twice * (below + 2.0 * half_sine * half_sine) / op, arcs.module),
        rotor_angle: Angle::from_si(2.0 * k * libm::atan(h * arcs.arcs.tan_gamma) - gamma - t),
    })
}

/// Contacts of a satellite with both wheels on its way over the two arcs, from crest to trough: the given
/// number on each arc, its ends among them. The arcs need not close; the rotor's image of them spans `π/n`
/// only if they do ([`crate::closure`]).
///
/// # Errors
/// Errors of [`junction`].
///
/// # Example
/// ```
/// use epicyclic_hydromotor::arcs::{Known, StatorArcs};
/// use epicyclic_hydromotor::{MotorNumbers, junction};
/// use uom::si::{f64::Length, length::millimeter};
///
/// let mm = Length::new::<millimeter>;
/// let numbers = MotorNumbers::new(5, 3, 55, 10)?;
/// let known = [Known::TroughDistance(mm(40.0)), Known::CrestDistance(mm(15.55))];
/// let arcs = StatorArcs::with(numbers, mm(1.0), known)?[0];
/// let contacts = junction::rolled(numbers, &arcs, 20)?;
/// // Contact 20 is the junction, on the end of arc 2 and the beginning of arc 1.
/// let rotor_radius = contacts[20].rotor_radius;
/// assert!((rotor_radius - junction::junction(numbers, &arcs)?.rotor_radius).abs() < mm(1e-12));
/// # Ok::<(), epicyclic_hydromotor::Error>(())
/// ```
pub fn rolled(
    numbers: MotorNumbers,
    arcs: &StatorArcs,
    per_arc: u32,
) -> Result<Vec<SatelliteContact>, Error> {
    let lobe = TwoArcs::new(&arcs.arcs, rolling_radius(numbers, arcs)?);
    let Arcs { half_length, r2, beta, .. } = arcs.arcs;
    let crest_arc = r2 * beta;
    let place = |place: u32| match f64::from(place) / f64::from(per_arc.max(1)) {
        part if part <= 1.0 => part * crest_arc,
        part => crest_arc + (part - 1.0) * (half_length - crest_arc),
    };
    let contact = |i: u32| SatelliteContact::of(&lobe.within(By::StatorArc, place(i)), arcs.module);
    Ok((0..=2 * per_arc.max(1)).map(contact).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arcs::Known;
    use crate::closure::tests::any_motor;
    use crate::closure::{Family, closure, is_smooth};
    use crate::quantity::Quantity;
    use epicyclic_numerics::quadrature::quadrature;
    use proptest::prelude::*;

    fn mm(value: f64) -> Length {
        Length::from_mm(value)
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
            // The rotor turns by 2·cos μ·(1 + r/R₁)/ρ₁·ds₃, less the way of the point on the stator.
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
            prop_assert!((found.stator_radius.mm() - end3).abs() < 1e-13 * scale);
            prop_assert!((found.rotor_radius.mm() - end1).abs() < 1e-12 * scale);
            prop_assert!((found.stator_angle.si() - on_stator).abs() < 1e-11);
            prop_assert!((found.rotor_angle.si() - angle).abs() < 1e-11);
        }
    }

    proptest! {
        /// By coordinates alone, without a formula of the phase: the satellite turns about `P` in small
        /// steps, and the rotor follows `P₁`.
        #[test]
        fn what_open_arcs_roll_is_the_sum_of_small_steps(motor in any_motor(), off in -0.03..0.03_f64) {
            const STEPS: u32 = 4000;
            let (numbers, part) = motor;
            let closed = Family::new(numbers, mm(1.0)).unwrap().at_part(part).unwrap();
            let known = [
                Known::TroughDistance(closed.trough_distance()),
                Known::CrestDistance(closed.crest_distance() * (1.0 + off)),
            ];
            let arcs = StatorArcs::with(numbers, mm(1.0), known);
            prop_assume!(arcs.is_ok());
            let arcs = arcs.unwrap()[0];
            prop_assume!(is_smooth(numbers, &arcs));
            let r = f64::from(numbers.satellite_teeth()) / 2.0;
            let Arcs { theta3, l, a, r1, r2, gamma, beta, .. } = arcs.arcs;
            // The satellite's centre on an arc, and the direction from there to P.
            let satellite = |is_crest: bool, x: f64| {
                let (from_axis, at, radius, to_p) = if is_crest {
                    (a, 0.0, r2 - r, x)
                } else {
                    (l, theta3, -(r1 + r), beta - x)
                };
                let ((sin, cos), (sin_p, cos_p)) = (libm::sincos(at), libm::sincos(to_p));
                ([from_axis * cos + radius * cos_p, from_axis * sin + radius * sin_p], [cos_p, sin_p])
            };
            // Radius and angle of P, and the radius of P₁ by the power of the axis.
            let contact = |is_crest: bool, x: f64| {
                let ([cx, cy], [nx, ny]) = satellite(is_crest, x);
                let (px, py) = (cx + r * nx, cy + r * ny);
                let rho3 = libm::hypot(px, py);
                (rho3, libm::atan2(py, px), (cx * cx + cy * cy - r * r) / rho3)
            };
            let mut span = 0.0;
            for (is_crest, end) in [(true, beta), (false, gamma)] {
                for i in 0..STEPS {
                    let [from, to] = [i, i + 1].map(|i| end * f64::from(i) / f64::from(STEPS));
                    let [(one, _), (next, _)] = [from, to].map(|x| satellite(is_crest, x));
                    let (rho3, _, rho1) = contact(is_crest, 0.5 * (from + to));
                    // The satellite turns about P, at r from its centre, and takes P₁, at ρ₃ − ρ₁ from P,
                    // along with the rotor.
                    let turn = libm::hypot(next[0] - one[0], next[1] - one[1]) / r;
                    span += (rho3 - rho1) * turn / rho1 - (contact(is_crest, to).1 - contact(is_crest, from).1);
                }
            }
            let rolled = rolled(numbers, &arcs, 7).unwrap();
            let found = rolled[14].rotor_angle.si();
            prop_assert!((found - span).abs() < 1e-5 * found, "{found} {span}");
            let open = closure(numbers, &arcs).unwrap().open().si();
            let by_closure = std::f64::consts::PI / f64::from(numbers.rotor_lobes()) - open;
            prop_assert!((found - by_closure).abs() < 1e-11 * found, "{found} {by_closure}");
        }
    }

    #[test]
    fn the_system_holds_for_any_distances() {
        let numbers = MotorNumbers::new(5, 3, 55, 10).unwrap();
        let known = [Known::TroughDistance(mm(40.0)), Known::CrestDistance(mm(15.5))];
        for missed in StatorArcs::with(numbers, mm(1.0), known).unwrap()[0].system_misses() {
            assert!(missed.abs() < 1e-14, "{missed}");
        }
    }
}
