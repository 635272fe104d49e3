//! Checks that limit a motor: distances and curvatures against the satellite and the height of its teeth; and
//! its size.
//!
//! Checks, with the least value and the reason:
//! - Trough arc: the stator's curvature radius where it bulges inward is at least the dedendum `h_f`. The
//!   roots are `h_f` outside, towards that centre.
//! - Crest arc: the stator's curvature radius where it bends round is at least `r`, the satellite's.
//!   Otherwise the satellite does not fit.
//! - Rotor, convex: the rotor's curvature radius where it bends round is at least the dedendum `h_f`. The
//!   roots are `h_f` inside.
//! - Rotor, hollow: the rotor's curvature radius where it is hollow is at least `r`. Otherwise the satellite
//!   does not fit.
//! - Rotor, least: the rotor's least radius is at least the dedendum `h_f`. It leaves a body within the
//!   roots.
//! - Neighbours: the distance of satellites is at least `2·(r + h_a)`. Their tips must pass.
//!
//! The checks are necessary for teeth, not sufficient: undercut and interference are those of the profiles.

use crate::quantity::Quantity;
use uom::si::f64::Length;

use crate::Error;
use crate::contact::{By, Conjugate};
use crate::motor::Motor;

/// Heights of the teeth in modules.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ToothHeights {
    /// Addendum `h_a` over the module.
    pub addendum: f64,
    /// Dedendum `h_f` over the module.
    pub dedendum: f64,
}

impl Default for ToothHeights {
    /// 1 and 1.25.
    fn default() -> Self {
        Self { addendum: 1.0, dedendum: 1.25 }
    }
}

/// Object of a check.
#[derive(Debug, Clone, Copy, PartialEq, Eq, strum::IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
#[cfg_attr(feature = "names", derive(serde::Serialize, schemars::JsonSchema))]
#[cfg_attr(feature = "names", serde(rename_all = "snake_case"), schemars(rename = "Subject"))]
pub enum Subject {
    /// The stator's least curvature radius where it bulges inward.
    StatorBulge,
    /// The stator's least curvature radius where it bends round the axis.
    StatorHollow,
    /// The rotor's least curvature radius where it bends round the axis.
    RotorBulge,
    /// The rotor's least curvature radius where it is hollow.
    RotorHollow,
    /// The rotor's least radius.
    RotorLeastRadius,
    /// The least distance of neighbouring satellites' centres.
    Neighbours,
}

impl Subject {
    /// Name of the quantity in words.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::StatorBulge => "stator, radius of inward bulges",
            Self::StatorHollow => "stator, radius of hollows",
            Self::RotorBulge => "rotor, radius of bulges",
            Self::RotorHollow => "rotor, radius of hollows",
            Self::RotorLeastRadius => "rotor, least distance from the axis",
            Self::Neighbours => "satellites' centres, distance",
        }
    }

    /// Name of the check, which is also that of its warning.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.into()
    }
}

/// A check.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Check {
    /// Object of the check.
    pub subject: Subject,
    /// Value checked.
    pub value: Length,
    /// Limit that the value must exceed.
    pub limit: Length,
}

impl Check {
    /// Whether the value exceeds the limit.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.value > self.limit
    }
}

/// The size of a motor's centrodes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Envelope {
    /// Twice the stator's greatest radius: the diameter that encloses the centrodes.
    pub stator_outer: Length,
    /// Twice the stator's least radius.
    pub stator_inner: Length,
    /// Twice the rotor's greatest radius.
    pub rotor_outer: Length,
    /// Twice the rotor's least radius.
    pub rotor_inner: Length,
    /// Displacement over the volume of the enclosing cylinder.
    pub displacement_by_volume: f64,
}

/// Heights that are finite and not below 0.
pub(crate) fn finite_heights(heights: ToothHeights) -> Result<(), Error> {
    for (quantity, value) in [(Quantity::Addendum, heights.addendum), (Quantity::Dedendum, heights.dedendum)]
    {
        if !(value.is_finite() && value >= 0.0) {
            return Err(Error::OutOfRange {
                quantity,
                value,
                low: 0.0,
                high: f64::INFINITY,
                unit: "modules",
            });
        }
    }
    Ok(())
}

impl Motor {
    /// Makes every check that applies: a curve that is nowhere hollow has no check of its hollow.
    ///
    /// For a motor of two arcs the extremes of the curvatures are exact: they are monotone on either arc's
    /// image. For a cosine law, with a second harmonic or without, 257 places of the half-lobe are evaluated
    /// and the best is refined.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless the heights are finite and not below 0.
    ///
    /// # Example
    /// ```
    /// use epicyclic_hydromotor::checks::ToothHeights;
    /// use epicyclic_hydromotor::{Motor, MotorNumbers};
    /// use uom::si::{f64::Length, length::millimeter};
    ///
    /// let mm = Length::new::<millimeter>;
    /// let motor = Motor::of_two_arcs(MotorNumbers::new(5, 3, 55, 10)?, mm(1.0), mm(40.0))?;
    /// assert!(motor.checks(ToothHeights::default())?.iter().all(|check| check.holds()));
    /// # Ok::<(), epicyclic_hydromotor::Error>(())
    /// ```
    pub fn checks(&self, heights: ToothHeights) -> Result<Vec<Check>, Error> {
        finite_heights(heights)?;
        let r = self.shape.satellite_radius();
        let trough = self.shape.trough();
        let extremes = self.shape.curvature_extremes();
        let subjects =
            [Subject::StatorBulge, Subject::StatorHollow, Subject::RotorBulge, Subject::RotorHollow];
        let limits = [heights.dedendum, r, heights.dedendum, r];
        let check = |subject, value: f64, limit: f64| Check {
            subject,
            value: self.length(value),
            limit: self.length(limit),
        };
        let mut checks: Vec<Check> = subjects
            .into_iter()
            .zip(extremes)
            .zip(limits)
            .filter(|((_, curvature), _)| *curvature > 0.0)
            .map(|((subject, curvature), limit)| check(subject, curvature.recip(), limit))
            .collect();
        checks.push(check(Subject::RotorLeastRadius, trough.rho1, heights.dedendum));
        let limit = self.length(2.0 * (r + heights.addendum));
        let value = self.least_neighbour_distance().0;
        checks.push(Check { subject: Subject::Neighbours, value, limit });
        Ok(checks)
    }

    /// Size of the centrodes, and the displacement that they enclose.
    #[must_use]
    pub fn envelope(&self) -> Envelope {
        let (crest, trough) = (self.shape.at(By::Phase, 0.0), self.shape.trough());
        let disc = std::f64::consts::PI * crest.rho3 * crest.rho3;
        Envelope {
            stator_outer: self.length(2.0 * crest.rho3),
            stator_inner: self.length(2.0 * trough.rho3),
            rotor_outer: self.length(2.0 * crest.rho1),
            rotor_inner: self.length(2.0 * trough.rho1),
            displacement_by_volume: self.displacement_kernel() / disc,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::MotorNumbers;
    use crate::closure::Family;
    use epicyclic_units::Physical;

    fn mm(value: f64) -> Length {
        Length::from_mm(value)
    }

    fn motor(l: f64) -> Motor {
        Motor::of_two_arcs(MotorNumbers::new(5, 3, 55, 10).unwrap(), mm(1.0), mm(l)).unwrap()
    }

    #[test]
    fn the_radii_are_those_of_the_arcs() {
        let motor = motor(40.0);
        let checks = motor.checks(ToothHeights::default()).unwrap();
        let value = |subject| checks.iter().find(|check| check.subject == subject).map(|check| check.value);
        let arcs = motor.arcs().unwrap();
        assert!((value(Subject::StatorBulge).unwrap() - arcs.trough_radius()).abs() < mm(1e-9));
        assert!((value(Subject::StatorHollow).unwrap() - arcs.crest_radius()).abs() < mm(1e-9));
        assert!((value(Subject::RotorBulge).unwrap() - mm(7.852)).abs() < mm(1e-3));
        // The rotor is nowhere hollow.
        assert_eq!(value(Subject::RotorHollow), None);
        assert!((value(Subject::RotorLeastRadius).unwrap() - mm(13.896_203_924)).abs() < mm(1e-8));
        assert!((motor.envelope().stator_outer - mm(56.495_919_9)).abs() < mm(1e-6));
    }

    #[test]
    fn a_nearly_pointed_rotor_and_a_short_bulge_fail() {
        let family = Family::new(MotorNumbers::new(5, 3, 55, 10).unwrap(), mm(1.0)).unwrap();
        let failing = |part: f64| -> Vec<Subject> {
            let l = family.at_part(part).unwrap().trough_distance();
            let motor = Motor::of_two_arcs(family.numbers(), mm(1.0), l).unwrap();
            let checks = motor.checks(ToothHeights::default()).unwrap();
            checks.iter().filter(|check| !check.holds()).map(|check| check.subject).collect()
        };
        assert_eq!(failing(0.02), [Subject::StatorBulge]);
        assert!(failing(0.98).contains(&Subject::RotorBulge));
    }

    #[test]
    fn heights_below_nothing_are_refused() {
        let heights = ToothHeights { addendum: -1.0, ..ToothHeights::default() };
        assert!(matches!(
            motor(40.0).checks(heights),
            Err(Error::OutOfRange { quantity: Quantity::Addendum, .. })
        ));
        let heights = ToothHeights { dedendum: f64::NAN, ..ToothHeights::default() };
        assert!(motor(40.0).checks(heights).is_err());
    }
}
