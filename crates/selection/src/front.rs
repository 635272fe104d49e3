//! The Pareto front of designs by their objectives.

use super::objectives::{Costs, Objectives, Order};

/// One point of a Pareto front.
#[derive(Debug, Clone, PartialEq)]
pub struct Entry {
    /// The objectives, equal for all members.
    pub objectives: Objectives,
    /// Places of the designs that have them, ascending.
    pub members: Vec<usize>,
}

/// The Pareto front of some designs, the best first by an order.
pub(crate) fn front(costs: &[Costs], order: Order) -> Vec<Entry> {
    let entries = epicyclic_pareto::front(costs, |one, other| order.compare(one, other));
    entries
        .into_iter()
        .map(|members| Entry { objectives: Objectives::of_costs(costs[members[0]]), members })
        .collect()
}
