//! Reasons for which points of a search are refused, and their counts.

use crate::checks::Subject;
use crate::profile::kept::Failure;
use crate::profile::limits::LimitKind;

/// Reason why a point is refused.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FormRefusal {
    /// The form gives no teeth.
    NoTeeth,
    /// A check of the centrodes against the heights of the form.
    Check(Subject),
    /// A limit of the teeth.
    Limit(LimitKind),
    /// No ideal ports can be made: the rays through the contacts do not part the chambers, or a satellite
    /// covers no hole.
    Ports,
    /// The flanks cannot hold a loaded satellite.
    CannotHold,
    /// The pressure of Hertz is above the wanted one.
    ContactStress,
    /// The bending stress at a root is above the wanted one.
    RootStress,
    /// The materials allow less than the wanted pressure drop.
    AllowedPressure,
    /// The ripple at the flanks is above the wanted one.
    FlankRipple,
    /// The least torque over the mean is below the wanted one.
    LeastTorque,
}

impl FormRefusal {
    /// Reasons in their order.
    pub const ALL: [Self; 22] = [
        Self::NoTeeth,
        Self::Check(Subject::StatorBulge),
        Self::Check(Subject::RotorBulge),
        Self::Check(Subject::RotorLeastRadius),
        Self::Check(Subject::Neighbours),
        Self::Limit(LimitKind::Undercut),
        Self::Limit(LimitKind::TipCusp),
        Self::Limit(LimitKind::SatelliteRoot),
        Self::Limit(LimitKind::WheelRoot),
        Self::Limit(LimitKind::TipThickness),
        Self::Limit(LimitKind::ContactPath),
        Self::Limit(LimitKind::RootCurve),
        Self::Limit(LimitKind::TipCurve),
        Self::Limit(LimitKind::Neighbours),
        Self::Limit(LimitKind::Wheels),
        Self::Ports,
        Self::CannotHold,
        Self::ContactStress,
        Self::RootStress,
        Self::AllowedPressure,
        Self::FlankRipple,
        Self::LeastTorque,
    ];

    pub(crate) fn of(failure: Failure) -> Self {
        match failure {
            Failure::NoTeeth => Self::NoTeeth,
            Failure::Check(subject) => Self::Check(subject),
            Failure::Limit(kind) => Self::Limit(kind),
        }
    }
}

/// Counts of some points by their results.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(super) struct Counts {
    pub(super) refused: [u64; FormRefusal::ALL.len()],
    pub(super) as_good: u64,
    pub(super) admissible: u64,
}

impl Counts {
    pub(super) fn fail(&mut self, failure: Failure) {
        self.refuse(FormRefusal::of(failure));
    }

    pub(super) fn refuse(&mut self, refusal: FormRefusal) {
        if let Some(place) = FormRefusal::ALL.iter().position(|other| *other == refusal) {
            self.refused[place] += 1;
        }
    }
}
