//! What a search tried, and why motors were refused.

use epicyclic_hydromotor::checks::Subject;
use epicyclic_hydromotor::search::{self, Found};
use schemars::JsonSchema;
use serde::Serialize;
use std::fmt;

/// Motors tried, and why the others were refused.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Funnel {
    /// Sets of lobes and teeth within the bounds.
    pub sets: usize,
    /// Of these, outside the limits of the rotor.
    pub outside_limits: usize,
    /// Of the rest, those with which no motor closes.
    pub without_family: usize,
    /// Motors at even places.
    pub places: usize,
    /// Motors added by refinement.
    pub refined: usize,
    /// Motors refused, each by what fails first.
    pub refused: Vec<Refused>,
    /// Motors that pass.
    pub accepted: usize,
    /// Of these, those that no other surpasses.
    pub front: usize,
    /// Of these, designs, of motors that are alike one.
    pub apart: usize,
    /// Of these, those that remain with what is asked of the teeth.
    pub with_teeth: usize,
}

/// How many motors were refused for a reason.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Refused {
    /// Why.
    pub reason: Reason,
    /// How many.
    pub motors: usize,
}

/// Why a motor is refused.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Reason {
    /// It does not close, at an end of its family.
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
    /// The least curvature radius is below the wanted one.
    LeastRadius,
    /// No size is within the limits.
    Size,
    /// The ripple, satellites sealing at the pitch points, is above the wanted one.
    Ripple,
    /// The form gives no teeth.
    NoTeeth,
    /// The ripple, satellites sealing at the flanks, is above the wanted one.
    FlankRipple,
    /// The least torque over the mean, satellites sealing at the flanks, is below the wanted one, or vanishes.
    LeastTorque,
}

impl Reason {
    const fn of(reason: search::Reason) -> Self {
        match reason {
            search::Reason::NotClosed => Self::NotClosed,
            search::Reason::Check(Subject::StatorBulge) => Self::StatorBulge,
            search::Reason::Check(Subject::StatorHollow) => Self::StatorHollow,
            search::Reason::Check(Subject::RotorBulge) => Self::RotorBulge,
            search::Reason::Check(Subject::RotorHollow) => Self::RotorHollow,
            search::Reason::Check(Subject::RotorLeastRadius) => Self::RotorLeastRadius,
            search::Reason::Check(Subject::Neighbours) => Self::Neighbours,
            search::Reason::LeastRadius => Self::LeastRadius,
            search::Reason::Size => Self::Size,
            search::Reason::Ripple => Self::Ripple,
            search::Reason::NoTeeth => Self::NoTeeth,
            search::Reason::FlankRipple => Self::FlankRipple,
            search::Reason::LeastTorque => Self::LeastTorque,
        }
    }

    /// Its name, as in JSON.
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
            Self::LeastRadius => "least_radius",
            Self::Size => "size",
            Self::Ripple => "ripple",
            Self::NoTeeth => "no_teeth",
            Self::FlankRipple => "flank_ripple",
            Self::LeastTorque => "least_torque",
        }
    }

    /// In words.
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
            Self::LeastRadius => "curvature radius wanted",
            Self::Size => "no size within the limits",
            Self::Ripple => "ripple at the pitch points wanted",
            Self::NoTeeth => "the form gives no teeth",
            Self::FlankRipple => "ripple at the flanks wanted",
            Self::LeastTorque => "least torque wanted",
        }
    }
}

impl Funnel {
    pub(super) fn of(found: &Found, apart: usize) -> Self {
        let funnel = &found.funnel;
        let refused = search::Reason::ALL
            .iter()
            .map(|&reason| Refused { reason: Reason::of(reason), motors: funnel.refused(reason) });
        Self {
            sets: funnel.sets,
            outside_limits: funnel.outside_limits,
            without_family: funnel.without_family,
            places: funnel.points,
            refined: funnel.refined,
            refused: refused.collect(),
            accepted: funnel.accepted,
            front: funnel.front,
            apart,
            with_teeth: found.designs.len(),
        }
    }
}

impl fmt::Display for Funnel {
    /// What refused every motor, the most frequent reason first.
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
