//! Families of gearboxes found whose gears have equal formulas.

use super::Kept;
use epicyclic_synthesis::family;
use epicyclic_synthesis::rank::{self, Objective};
use schemars::JsonSchema;
use serde::Serialize;

/// Gearboxes whose gears have equal formulas, up to an exchange of sets of one kind.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Family {
    /// Number of the family, from 1, in the order of the best gearboxes.
    pub number: usize,
    /// Number of gearboxes in the family.
    pub gearboxes: usize,
    /// Number of the best gearbox of the family.
    pub best: usize,
    /// Number of drawable gearboxes in the family.
    pub drawable: usize,
    /// Lowest and highest efficiency of the forward gears among the gearboxes: the least, or the mean
    /// weighted by the parts of the time.
    pub forward_efficiency_range: [f64; 2],
    /// Lowest and highest mean drag over the forward gears among the gearboxes, relative to the input speed.
    pub mean_drag_of_input_range: [f64; 2],
    /// Lowest and highest value among the gearboxes of the greatest torque of a shift element or member,
    /// relative to the input torque.
    pub greatest_torque_of_input_range: [f64; 2],
    /// Lowest and highest value among the gearboxes of the greatest link speed, or planet speed relative to
    /// its carrier, relative to the input speed.
    pub greatest_speed_of_input_range: [f64; 2],
}

/// Families of gearboxes in their order, and for each gearbox the index of its family.
pub(super) fn families(kept: &[Kept]) -> (Vec<Family>, Vec<usize>) {
    let (of_each, members) = family::number(kept.iter().map(|kept| &kept.family));
    let mut ratings: Vec<Vec<&rank::Rating>> = vec![Vec::new(); members.len()];
    let mut best = vec![0; members.len()];
    for (place, (kept, family)) in kept.iter().zip(&of_each).enumerate() {
        if ratings[*family].is_empty() {
            best[*family] = place + 1;
        }
        ratings[*family].push(&kept.rating);
    }
    let families = ratings.iter().zip(best).enumerate();
    let families = families.map(|(place, (ratings, best))| Family::of(place + 1, best, ratings));
    (families.collect(), of_each)
}

impl Family {
    fn of(number: usize, best: usize, ratings: &[&rank::Rating]) -> Self {
        let range = |objective: Objective| {
            let values = ratings.iter().map(|rating| rating.value(objective));
            values.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], value| {
                [least.min(value), most.max(value)]
            })
        };
        Self {
            number,
            gearboxes: ratings.len(),
            best,
            drawable: ratings.iter().filter(|rating| rating.is_drawable()).count(),
            forward_efficiency_range: range(Objective::Efficiency),
            mean_drag_of_input_range: range(Objective::Drag),
            greatest_torque_of_input_range: range(Objective::Torque),
            greatest_speed_of_input_range: range(Objective::Speed),
        }
    }
}
