//! Reasons for which a search refuses motors and points, and their counts.

use crate::checks::Subject;
use crate::profile::limits::LimitKind;

/// Reason why a motor, with or without its teeth, is refused.
#[derive(Debug, Clone, Copy, PartialEq, Eq, strum::IntoStaticStr)]
#[strum(serialize_all = "snake_case")]
#[cfg_attr(feature = "names", derive(serde::Serialize, schemars::JsonSchema))]
#[cfg_attr(feature = "names", serde(rename_all = "snake_case"), schemars(rename = "Reason"))]
pub enum Reason {
    /// The motor does not close, by rounding at an end of its family, or a result for it is not a number.
    NotClosed,
    /// The roots do not fit into the stator's bulges.
    StatorBulge,
    /// The satellite does not fit into the stator's hollows.
    StatorHollow,
    /// The roots do not fit into the rotor's bulges.
    RotorBulge,
    /// The satellite does not fit into the rotor's hollows.
    RotorHollow,
    /// The rotor has no body within its roots.
    RotorLeastRadius,
    /// The tips of neighbouring satellites meet.
    Neighbours,
    /// The rotor reaches into the stator.
    RotorInStator,
    /// The least chamber has no area.
    NoChamber,
    /// The least curvature radius is below the required one.
    LeastRadius,
    /// No size is within the limits.
    Size,
    /// The ripple if satellites seal at the pitch points is above the required one.
    Ripple,
    /// The form yields no teeth.
    NoTeeth,
    /// The cutter's tip removes a part of the flank.
    Undercut,
    /// The flank has a cusp before the tip.
    TipCusp,
    /// The wheel's tip reaches below the satellite's involute.
    SatelliteRoot,
    /// The satellite's tip reaches below the wheel's flank.
    WheelRoot,
    /// The tip is too thin.
    TipThickness,
    /// A pair of flanks separates before the next one meets.
    ContactPath,
    /// The root curve, a parallel of the centrode, has cusps.
    RootCurve,
    /// The tip curve, a parallel of the centrode, has cusps.
    TipCurve,
    /// Tip circles of neighbouring satellites meet.
    TipCircles,
    /// The rotor's tips meet those of the stator.
    Wheels,
    /// No ideal ports can be made: the rays through the contacts do not part the chambers, or a satellite
    /// covers no hole.
    Ports,
    /// The flanks cannot hold a loaded satellite.
    CannotHold,
    /// The contact stress is above the required one.
    ContactStress,
    /// The bending stress at a root is above the required one.
    RootStress,
    /// The material allows less than the required pressure.
    AllowedPressure,
    /// The ripple if satellites seal at the flanks is above the required one.
    FlankRipple,
    /// Least over mean torque, if satellites seal at the flanks, is below the required value or 0.
    LeastTorque,
}

impl Reason {
    /// Reasons of [`MotorSearch`](crate::search::MotorSearch) in their order: checks and limits of the motor,
    /// then its flanks, last of all whether it can be made.
    pub const OF_MOTORS: [Self; 25] = [
        Self::NotClosed,
        Self::StatorBulge,
        Self::StatorHollow,
        Self::RotorBulge,
        Self::RotorHollow,
        Self::RotorLeastRadius,
        Self::Neighbours,
        Self::RotorInStator,
        Self::NoChamber,
        Self::LeastRadius,
        Self::Size,
        Self::Ripple,
        Self::FlankRipple,
        Self::LeastTorque,
        Self::NoTeeth,
        Self::Undercut,
        Self::TipCusp,
        Self::SatelliteRoot,
        Self::WheelRoot,
        Self::TipThickness,
        Self::ContactPath,
        Self::RootCurve,
        Self::TipCurve,
        Self::Wheels,
        Self::Ports,
    ];

    /// Reasons for which [`FormSearch`](crate::search::forms::FormSearch) refuses a motor whatever its teeth,
    /// in their order.
    pub const OF_SHAPES: [Self; 6] =
        [Self::NotClosed, Self::RotorInStator, Self::NoChamber, Self::LeastRadius, Self::Size, Self::Ripple];

    /// Reasons for which [`FormSearch`](crate::search::forms::FormSearch) refuses a motor with a form, in
    /// their order.
    pub const OF_POINTS: [Self; 22] = [
        Self::NoTeeth,
        Self::StatorBulge,
        Self::RotorBulge,
        Self::RotorLeastRadius,
        Self::Neighbours,
        Self::Undercut,
        Self::TipCusp,
        Self::SatelliteRoot,
        Self::WheelRoot,
        Self::TipThickness,
        Self::ContactPath,
        Self::RootCurve,
        Self::TipCurve,
        Self::TipCircles,
        Self::Wheels,
        Self::Ports,
        Self::CannotHold,
        Self::ContactStress,
        Self::RootStress,
        Self::AllowedPressure,
        Self::FlankRipple,
        Self::LeastTorque,
    ];

    /// Name of the reason, which does not change with its words.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.into()
    }

    /// Reason in words.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::NotClosed => "does not close, at an end",
            Self::StatorBulge => "roots in the stator's bulges",
            Self::StatorHollow => "satellite in the stator's hollows",
            Self::RotorBulge => "roots in the rotor's bulges",
            Self::RotorHollow => "satellite in the rotor's hollows",
            Self::RotorLeastRadius => "rotor without a body",
            Self::Neighbours => "satellites' tips meet",
            Self::RotorInStator => "rotor reaches into the stator",
            Self::NoChamber => "least chamber without area",
            Self::LeastRadius => "curvature radius wanted",
            Self::Size => "no size within the limits",
            Self::Ripple => "ripple at the pitch points wanted",
            Self::NoTeeth => "the form gives no teeth",
            Self::Undercut => "undercut",
            Self::TipCusp => "cusp before the tip",
            Self::SatelliteRoot => "tips below the satellite's flank",
            Self::WheelRoot => "tips below the wheel's flank",
            Self::TipThickness => "tip too thin",
            Self::ContactPath => "path of contact too short",
            Self::RootCurve => "cusps of the root curve",
            Self::TipCurve => "cusps of the tip curve",
            Self::TipCircles => "satellites' tip circles meet",
            Self::Wheels => "tips of rotor and stator meet",
            Self::Ports => "no ideal ports",
            Self::CannotHold => "flanks cannot hold a satellite",
            Self::ContactStress => "contact stress wanted",
            Self::RootStress => "root stress wanted",
            Self::AllowedPressure => "allowed pressure wanted",
            Self::FlankRipple => "ripple at the flanks wanted",
            Self::LeastTorque => "least torque wanted",
        }
    }
}

impl From<Subject> for Reason {
    fn from(check: Subject) -> Self {
        match check {
            Subject::StatorBulge => Self::StatorBulge,
            Subject::StatorHollow => Self::StatorHollow,
            Subject::RotorBulge => Self::RotorBulge,
            Subject::RotorHollow => Self::RotorHollow,
            Subject::RotorLeastRadius => Self::RotorLeastRadius,
            Subject::Neighbours => Self::Neighbours,
        }
    }
}

impl From<LimitKind> for Reason {
    fn from(limit: LimitKind) -> Self {
        match limit {
            LimitKind::Undercut => Self::Undercut,
            LimitKind::TipCusp => Self::TipCusp,
            LimitKind::SatelliteRoot => Self::SatelliteRoot,
            LimitKind::WheelRoot => Self::WheelRoot,
            LimitKind::TipThickness => Self::TipThickness,
            LimitKind::ContactPath => Self::ContactPath,
            LimitKind::RootCurve => Self::RootCurve,
            LimitKind::TipCurve => Self::TipCurve,
            LimitKind::Neighbours => Self::TipCircles,
            LimitKind::Wheels => Self::Wheels,
        }
    }
}

/// Numbers of refusals by their reasons.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(crate) struct Refusals([u64; Reason::LeastTorque as usize + 1]);

impl Refusals {
    /// Number of refusals for a reason.
    pub(crate) fn of(&self, reason: Reason) -> u64 {
        self.0[reason as usize]
    }

    pub(crate) fn count(&mut self, reason: Reason) {
        self.0[reason as usize] += 1;
    }

    pub(crate) fn add(&mut self, others: &Self) {
        for (sum, more) in self.0.iter_mut().zip(others.0) {
            *sum += more;
        }
    }
}
