//! The space of a search with free tooth forms, and what became of its points.

use crate::motor_search::funnel as motor_search;
use epicyclic_hydromotor::checks::Subject;
use epicyclic_hydromotor::profile::limits::LimitKind;
use epicyclic_hydromotor::search::forms::{FormFound, FormRefusal, ShapeReason};
use schemars::JsonSchema;
use serde::Serialize;
use std::fmt;

/// The space of motors and tooth forms, and what became of its points: those of refused motors, those refused, those left out and the
/// admissible ones add up to it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Funnel {
    /// Sets of lobes and teeth within the bounds.
    pub sets: usize,
    /// Of these, outside the limits of the rotor.
    pub outside_limits: usize,
    /// Of the rest, those with which no motor of the families closes.
    pub without_motors: usize,
    /// Motors at the places of their families.
    pub motors: usize,
    /// Tooth forms within the steps.
    pub forms: usize,
    /// Points: motors times forms.
    pub points: u64,
    /// Motors refused, whatever their form, each by what fails first.
    pub motors_refused: Vec<motor_search::Refused>,
    /// The points of these motors.
    pub points_of_refused_motors: u64,
    /// Points refused, each by what is found to fail first.
    pub refused: Vec<Refused>,
    /// Points left out because a design is as good as they can be, or their contact ratio is below the least.
    pub as_good: u64,
    /// Points tried to the end that are admissible.
    pub admissible: u64,
    /// Of these, the designs.
    pub front: usize,
}

/// How many points were refused for a reason.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Refused {
    /// Why.
    pub reason: Reason,
    /// How many.
    pub points: u64,
}

/// Why a motor with a tooth form is refused.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Reason {
    /// The form gives no teeth.
    NoTeeth,
    /// The roots do not fit into the stator's bulges.
    StatorBulge,
    /// The roots do not fit into the rotor's bulges.
    RotorBulge,
    /// The rotor has no body within its roots.
    RotorLeastRadius,
    /// The centrodes leave neighbouring satellites no room.
    Neighbours,
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
    /// A pair of flanks parts before the next one meets.
    ContactPath,
    /// The root's parallel of the centrode has cusps.
    RootCurve,
    /// The tip's parallel of the centrode has cusps.
    TipCurve,
    /// Tip circles of neighbouring satellites meet.
    TipCircles,
    /// The rotor's crest does not pass the stator's trough.
    Wheels,
    /// The flanks cannot hold a loaded satellite.
    CannotHold,
    /// The contact stress is above the wanted one.
    ContactStress,
    /// The bending stress at a root is above the wanted one.
    RootStress,
    /// The material allows less than the wanted pressure.
    AllowedPressure,
    /// The ripple at the flanks is above the wanted one.
    FlankRipple,
    /// The least torque is below the wanted one.
    LeastTorque,
}

impl Reason {
    /// `None` of what a search does not refuse for: satellites in hollows have room where a limit of the teeth holds.
    const fn of(refusal: FormRefusal) -> Option<Self> {
        Some(match refusal {
            FormRefusal::NoTeeth => Self::NoTeeth,
            FormRefusal::Check(Subject::StatorBulge) => Self::StatorBulge,
            FormRefusal::Check(Subject::RotorBulge) => Self::RotorBulge,
            FormRefusal::Check(Subject::RotorLeastRadius) => Self::RotorLeastRadius,
            FormRefusal::Check(Subject::Neighbours) => Self::Neighbours,
            FormRefusal::Check(Subject::StatorHollow | Subject::RotorHollow) => return None,
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
            FormRefusal::CannotHold => Self::CannotHold,
            FormRefusal::ContactStress => Self::ContactStress,
            FormRefusal::RootStress => Self::RootStress,
            FormRefusal::AllowedPressure => Self::AllowedPressure,
            FormRefusal::FlankRipple => Self::FlankRipple,
            FormRefusal::LeastTorque => Self::LeastTorque,
        })
    }

    /// Its name, as in JSON.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::NoTeeth => "no_teeth",
            Self::StatorBulge => "stator_bulge",
            Self::RotorBulge => "rotor_bulge",
            Self::RotorLeastRadius => "rotor_least_radius",
            Self::Neighbours => "neighbours",
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
            Self::CannotHold => "cannot_hold",
            Self::ContactStress => "contact_stress",
            Self::RootStress => "root_stress",
            Self::AllowedPressure => "allowed_pressure",
            Self::FlankRipple => "flank_ripple",
            Self::LeastTorque => "least_torque",
        }
    }

    /// In words.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::NoTeeth => "the form gives no teeth",
            Self::StatorBulge => "roots in the stator's bulges",
            Self::RotorBulge => "roots in the rotor's bulges",
            Self::RotorLeastRadius => "rotor without a body",
            Self::Neighbours => "satellites without room",
            Self::Undercut => "undercut",
            Self::TipCusp => "cusp before the tip",
            Self::SatelliteRoot => "tips below the satellite's flank",
            Self::WheelRoot => "tips below the wheel's flank",
            Self::TipThickness => "tip too thin",
            Self::ContactPath => "path of contact too short",
            Self::RootCurve => "cusps of the root curve",
            Self::TipCurve => "cusps of the tip curve",
            Self::TipCircles => "satellites' tips meet",
            Self::Wheels => "rotor's crests meet the stator",
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
    pub(super) fn of(found: &FormFound) -> Self {
        let funnel = &found.funnel;
        let motors_refused: Vec<motor_search::Refused> = ShapeReason::ALL
            .iter()
            .map(|&reason| motor_search::Refused {
                reason: match reason {
                    ShapeReason::NotClosed => motor_search::Reason::NotClosed,
                    ShapeReason::LeastRadius => motor_search::Reason::LeastRadius,
                    ShapeReason::Size => motor_search::Reason::Size,
                    ShapeReason::Ripple => motor_search::Reason::Ripple,
                },
                motors: funnel.motors_refused(reason),
            })
            .collect();
        let refused = FormRefusal::ALL.iter().filter_map(|&refusal| {
            Reason::of(refusal).map(|reason| Refused { reason, points: funnel.refused(refusal) })
        });
        let motors: usize = motors_refused.iter().map(|refused| refused.motors).sum();
        Self {
            sets: funnel.sets,
            outside_limits: funnel.outside_limits,
            without_motors: funnel.without_motors,
            motors: funnel.motors,
            forms: funnel.forms,
            points: funnel.points(),
            motors_refused,
            points_of_refused_motors: motors as u64 * funnel.forms as u64,
            refused: refused.collect(),
            as_good: funnel.as_good,
            admissible: funnel.admissible,
            front: found.designs.len(),
        }
    }
}

impl fmt::Display for Funnel {
    /// What refused every point, the most frequent reason first.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{} sets of lobes and teeth, {} outside limits, {} close no motor; {} motors in {} tooth forms are {} points",
            self.sets, self.outside_limits, self.without_motors, self.motors, self.forms, self.points
        )?;
        let forms = self.forms as u64;
        let of_motors =
            self.motors_refused.iter().map(|refused| (refused.reason.words(), refused.motors as u64 * forms));
        let of_points = self.refused.iter().map(|refused| (refused.reason.words(), refused.points));
        let left_out = ("contact ratio wanted", self.as_good);
        let mut refused: Vec<(&str, u64)> =
            of_motors.chain(of_points).chain([left_out]).filter(|(_, points)| *points > 0).collect();
        refused.sort_by_key(|(_, points)| std::cmp::Reverse(*points));
        let mut mark = "; refused: ";
        for (words, points) in refused {
            write!(f, "{mark}{words} {points}")?;
            mark = ", ";
        }
        Ok(())
    }
}
