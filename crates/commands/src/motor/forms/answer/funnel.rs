//! The space of a search with free tooth forms, and what became of its points.

use crate::motor::search::answer::funnel::{self as motor_search, Reason};
use epicyclic_hydromotor::search::forms::{FormFound, FormRefusal, ShapeReason};
use schemars::JsonSchema;
use serde::Serialize;
use std::fmt;

/// The space of motors and tooth forms, and what became of its points: those of refused motors, those
/// refused, those left out and the admissible ones add up to it.
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

impl Funnel {
    pub(crate) fn of(found: &FormFound) -> Self {
        let funnel = &found.funnel;
        let motors_refused: Vec<motor_search::Refused> = ShapeReason::ALL
            .iter()
            .map(|&reason| motor_search::Refused {
                reason: match reason {
                    ShapeReason::NotClosed => Reason::NotClosed,
                    ShapeReason::RotorInStator => Reason::RotorInStator,
                    ShapeReason::NoChamber => Reason::NoChamber,
                    ShapeReason::LeastRadius => Reason::LeastRadius,
                    ShapeReason::Size => Reason::Size,
                    ShapeReason::Ripple => Reason::Ripple,
                },
                motors: funnel.motors_refused(reason),
            })
            .collect();
        let refused = FormRefusal::ALL
            .iter()
            .map(|&refusal| Refused { reason: Reason::of_form(refusal), points: funnel.refused(refusal) });
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
