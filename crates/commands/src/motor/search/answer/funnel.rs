//! Numbers of motors computed by a search, and reasons why motors were refused.

use epicyclic_hydromotor::search::{Found, Reason};
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
    pub motors: u64,
}

impl Funnel {
    pub(crate) fn of(found: &Found) -> Self {
        let funnel = &found.funnel;
        let refused =
            Reason::OF_MOTORS.map(|reason| Refused { reason, motors: funnel.refused(reason) }).into();
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
