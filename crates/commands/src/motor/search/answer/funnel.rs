//! Numbers of motors computed by a search, and reasons why motors were refused.

use epicyclic_hydromotor::checks::Subject;
use epicyclic_hydromotor::profile::limits::LimitKind;
use epicyclic_hydromotor::search::forms::FormRefusal;
use epicyclic_hydromotor::search::{self, Found};
use schemars::JsonSchema;
use serde::Serialize;
use std::fmt;

/// Number of motors computed, and the reasons why others were refused.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Funnel {
    /// Number of sets of lobes and teeth within the bounds.
    pub sets: usize,
    /// Number of these sets outside the limits of the rotor.
    pub outside_limits: usize,
    /// Number of the remaining sets with which no motor closes.
    pub without_family: usize,
    /// Number of motors at even places.
    pub places: usize,
    /// Number of motors added by refinement.
    pub refined: usize,
    /// Refused motors, counted by the first failed check.
    pub refused: Vec<Refused>,
    /// Number of accepted motors; teeth and ports are checked only for those on the front.
    pub accepted: usize,
    /// Number of accepted motors that are non-dominated.
    pub front: usize,
    /// Number of designs: similar non-dominated motors count as one.
    pub apart: usize,
}

/// Number of motors refused for a reason.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Refused {
    /// Reason of the refusal.
    pub reason: Reason,
    /// Number of motors refused.
    pub motors: usize,
}

/// Reasons why a motor, with or without its teeth, is refused.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Reason {
    /// The motor does not close, at an end of its family.
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
    /// No ideal ports can be made.
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
    const fn of(reason: search::Reason) -> Self {
        match reason {
            search::Reason::NotClosed => Self::NotClosed,
            search::Reason::Check(subject) => Self::of_check(subject),
            search::Reason::RotorInStator => Self::RotorInStator,
            search::Reason::NoChamber => Self::NoChamber,
            search::Reason::LeastRadius => Self::LeastRadius,
            search::Reason::Size => Self::Size,
            search::Reason::Ripple => Self::Ripple,
            search::Reason::Made(refusal) => Self::of_form(refusal),
            search::Reason::FlankRipple => Self::FlankRipple,
            search::Reason::LeastTorque => Self::LeastTorque,
        }
    }

    const fn of_check(subject: Subject) -> Self {
        match subject {
            Subject::StatorBulge => Self::StatorBulge,
            Subject::StatorHollow => Self::StatorHollow,
            Subject::RotorBulge => Self::RotorBulge,
            Subject::RotorHollow => Self::RotorHollow,
            Subject::RotorLeastRadius => Self::RotorLeastRadius,
            Subject::Neighbours => Self::Neighbours,
        }
    }

    pub(crate) const fn of_form(refusal: FormRefusal) -> Self {
        match refusal {
            FormRefusal::NoTeeth => Self::NoTeeth,
            FormRefusal::Check(subject) => Self::of_check(subject),
            FormRefusal::Limit(LimitKind::Undercut) => Self::Undercut,
            FormRefusal::Limit(LimitKind::TipCusp) => Self::TipCusp,
            FormRefusal::Limit(LimitKind::SatelliteRoot) => Self::SatelliteRoot,
            FormRefusal::Limit(LimitKind::WheelRoot) => Self::WheelRoot,
            FormRefusal::Limit(LimitKind::TipThickness) => Self::TipThickness,
            FormRefusal::Limit(LimitKind::ContactPath) => Self::ContactPath,
            FormRefusal::Limit(LimitKind::RootCurve) => Self::RootCurve,
            FormRefusal::Limit(LimitKind::TipCurve) => Self::TipCurve,
            FormRefusal::Limit(LimitKind::Neighbours) => Self::TipCircles,
            FormRefusal::Limit(LimitKind::Wheels) => Self::Wheels,
            FormRefusal::Ports => Self::Ports,
            FormRefusal::CannotHold => Self::CannotHold,
            FormRefusal::ContactStress => Self::ContactStress,
            FormRefusal::RootStress => Self::RootStress,
            FormRefusal::AllowedPressure => Self::AllowedPressure,
            FormRefusal::FlankRipple => Self::FlankRipple,
            FormRefusal::LeastTorque => Self::LeastTorque,
        }
    }

    /// Name of the reason, as in JSON.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::NotClosed => "not_closed",
            Self::StatorBulge => "stator_bulge",
            Self::StatorHollow => "stator_hollow",
            Self::RotorBulge => "rotor_bulge",
            Self::RotorHollow => "rotor_hollow",
            Self::RotorLeastRadius => "rotor_least_radius",
            Self::Neighbours => "neighbours",
            Self::RotorInStator => "rotor_in_stator",
            Self::NoChamber => "no_chamber",
            Self::LeastRadius => "least_radius",
            Self::Size => "size",
            Self::Ripple => "ripple",
            Self::NoTeeth => "no_teeth",
            Self::Undercut => "undercut",
            Self::TipCusp => "tip_cusp",
            Self::SatelliteRoot => "satellite_root",
            Self::WheelRoot => "wheel_root",
            Self::TipThickness => "tip_thickness",
            Self::ContactPath => "contact_path",
            Self::RootCurve => "root_curve",
            Self::TipCurve => "tip_curve",
            Self::TipCircles => "tip_circles",
            Self::Wheels => "wheels",
            Self::Ports => "ports",
            Self::CannotHold => "cannot_hold",
            Self::ContactStress => "contact_stress",
            Self::RootStress => "root_stress",
            Self::AllowedPressure => "allowed_pressure",
            Self::FlankRipple => "flank_ripple",
            Self::LeastTorque => "least_torque",
        }
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

impl Funnel {
    pub(crate) fn of(found: &Found) -> Self {
        let funnel = &found.funnel;
        // A check of the centrodes counts as one reason with the same check by the heights of the teeth.
        let mut refused: Vec<Refused> = vec![];
        for &of in &search::Reason::ALL {
            let (reason, motors) = (Reason::of(of), funnel.refused(of));
            match refused.iter_mut().find(|one| one.reason == reason) {
                Some(one) => one.motors += motors,
                None => refused.push(Refused { reason, motors }),
            }
        }
        Self {
            sets: funnel.sets,
            outside_limits: funnel.outside_limits,
            without_family: funnel.without_family,
            places: funnel.points,
            refined: funnel.refined,
            refused,
            accepted: funnel.accepted,
            front: funnel.front,
            apart: found.designs.len(),
        }
    }
}

impl fmt::Display for Funnel {
    /// Lists the reasons why every motor was refused, the most frequent first.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{} sets of lobes and teeth, {} outside limits, {} close no motor, {} motors tried",
            self.sets,
            self.outside_limits,
            self.without_family,
            self.places + self.refined
        )?;
        let mut refused: Vec<&Refused> = self.refused.iter().filter(|refused| refused.motors > 0).collect();
        refused.sort_by_key(|refused| std::cmp::Reverse(refused.motors));
        let mut mark = "; refused: ";
        for Refused { reason, motors } in refused {
            write!(f, "{mark}{} {motors}", reason.words())?;
            mark = ", ";
        }
        Ok(())
    }
}
