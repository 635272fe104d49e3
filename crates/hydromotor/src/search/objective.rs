//! Objectives by which motors are compared, and the teeth that some of them need.

use crate::Error;
use crate::flanks::SealingContact;
use crate::motor::Motor;
use crate::profile::{Profile, ToothForm};
use crate::quantity::Quantity;
use crate::ranges::positive;

/// Objective of a design.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Objective {
    /// The most displacement over the volume of the cylinder about the stator's centrode.
    DisplacementByVolume,
    /// The least ripple of flow and torque, satellites sealing at the pitch points.
    Ripple,
    /// The greatest least curvature radius of the centrodes over the module.
    LeastRadius,
    /// The least ripple, satellites sealing at the flanks of the [form](FlankTerms::form).
    FlankRipple,
    /// The greatest least torque over the mean, satellites sealing at these flanks.
    LeastTorque,
}

impl Objective {
    /// Objectives in their order.
    pub const ALL: [Self; 5] =
        [Self::DisplacementByVolume, Self::Ripple, Self::LeastRadius, Self::FlankRipple, Self::LeastTorque];

    /// Objectives by default: those that do not depend on the teeth.
    pub const USUAL: [Self; 3] = [Self::DisplacementByVolume, Self::Ripple, Self::LeastRadius];

    /// Whether it needs teeth.
    #[must_use]
    pub const fn is_of_flanks(self) -> bool {
        matches!(self, Self::FlankRipple | Self::LeastTorque)
    }
}

/// The tooth form with which figures at the flanks are calculated, and the limits of these.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct FlankTerms {
    /// The form of the teeth. Its limits are those of [`MotorSearch::made`](super::MotorSearch::made).
    pub form: ToothForm,
    /// Greatest ripple with satellites that seal at the flanks.
    pub ripple: Option<f64>,
    /// Least torque over the mean, likewise.
    pub least_torque: Option<f64>,
}

/// Bounds of the flow with satellites that seal at the flanks: a ripple above 0, a least torque that is a
/// part of the mean.
pub(super) fn of_flow(ripple: Option<f64>, least_torque: Option<f64>) -> Result<(), Error> {
    if let Some(ripple) = ripple {
        positive(Quantity::FlankRipple, ripple, "")?;
    }
    match least_torque {
        Some(value) if !(value > 0.0 && value <= 1.0) => {
            Err(Error::OutOfRange { quantity: Quantity::LeastTorque, value, low: 0.0, high: 1.0, unit: "" })
        }
        _ => Ok(()),
    }
}

impl FlankTerms {
    pub(super) fn checked(&self) -> Result<(), Error> {
        of_flow(self.ripple, self.least_torque)
    }

    /// Whether every motor is evaluated with its teeth: with these objectives, or for a bound.
    pub(super) fn are_needed(&self, objectives: &[Objective]) -> bool {
        let is_bound = self.ripple.is_some() || self.least_torque.is_some();
        is_bound || objectives.iter().any(|objective| objective.is_of_flanks())
    }
}

/// Flow and torque of a motor whose satellites seal at the flanks, [`Profile::flank_ripple`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AtFlanks {
    /// Ripple.
    pub ripple: f64,
    /// Least over mean.
    pub least_over_mean: f64,
}

impl AtFlanks {
    /// Flow at the flanks of a motor in a form; `None` if the form gives no teeth, or no number.
    #[must_use]
    pub fn of(motor: &Motor, form: ToothForm) -> Option<Self> {
        Self::of_profile(&Profile::new(motor, form).ok()?)
    }

    /// Flow at the flanks of given teeth; `None` if they give no number.
    #[must_use]
    pub fn of_profile(profile: &Profile) -> Option<Self> {
        let ripple = profile.flank_ripple(SealingContact::default());
        let at = Self { ripple: ripple.at_flanks.delta, least_over_mean: ripple.least_over_mean };
        (at.ripple > 0.0 && at.ripple.is_finite() && at.least_over_mean.is_finite()).then_some(at)
    }
}
