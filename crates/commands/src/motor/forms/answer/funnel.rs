//! Search space with free tooth forms, and the results for its points.

use crate::motor::search::answer::funnel as motor_search;
use epicyclic_hydromotor::search::Reason;
use epicyclic_hydromotor::search::forms::FormFound;
use schemars::JsonSchema;
use serde::Serialize;
use std::fmt;

/// Search space of motors and tooth forms, and the results for its points. The points of refused motors, the
/// refused points, those left out and the admissible ones add up to the whole.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Funnel {
    /// Number of sets of lobes and teeth within the bounds.
    pub sets: usize,
    /// Number of these sets outside the limits of the rotor.
    pub outside_limits: usize,
    /// Number of the remaining sets with which no motor of the families closes.
    pub without_motors: usize,
    /// Number of motors at the places of their families.
    pub motors: usize,
    /// Number of tooth forms within the steps.
    pub forms: usize,
    /// Number of points: motors times forms.
    pub points: u64,
    /// Motors refused with any tooth form, counted by the first failed check.
    pub motors_refused: Vec<motor_search::Refused>,
    /// Number of points of these motors.
    pub points_of_refused_motors: u64,
    /// Refused points, counted by the first check found to fail.
    pub refused: Vec<Refused>,
    /// Number of points left out because a design is at least as good as they can be, or their contact ratio
    /// is too low.
    pub as_good: u64,
    /// Number of fully computed points that are admissible.
    pub admissible: u64,
    /// Number of admissible points that are designs.
    pub front: usize,
}

/// Number of points refused for a reason.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Refused {
    /// Reason of the refusal.
    pub reason: Reason,
    /// Number of points refused.
    pub points: u64,
}

impl Funnel {
    pub(crate) fn of(found: &FormFound) -> Self {
        let funnel = &found.funnel;
        let motors_refused = Reason::OF_SHAPES
            .map(|reason| motor_search::Refused { reason, motors: funnel.motors_refused(reason) });
        let refused = Reason::OF_POINTS.map(|reason| Refused { reason, points: funnel.refused(reason) });
        let motors: u64 = motors_refused.iter().map(|refused| refused.motors).sum();
        Self {
            sets: funnel.sets,
            outside_limits: funnel.outside_limits,
            without_motors: funnel.without_motors,
            motors: funnel.motors,
            forms: funnel.forms,
            points: funnel.points(),
            motors_refused: motors_refused.into(),
            points_of_refused_motors: motors * funnel.forms as u64,
            refused: refused.into(),
            as_good: funnel.as_good,
            admissible: funnel.admissible,
            front: found.designs.len(),
        }
    }
}

impl fmt::Display for Funnel {
    /// Lists the reasons why every point was refused, the most frequent first.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{} sets of lobes and teeth, {} outside limits, {} close no motor; {} motors in {} tooth forms are {} points",
            self.sets, self.outside_limits, self.without_motors, self.motors, self.forms, self.points
        )?;
        let forms = self.forms as u64;
        let of_motors =
            self.motors_refused.iter().map(|refused| (refused.reason.words(), refused.motors * forms));
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
