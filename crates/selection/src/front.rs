//! The Pareto front of designs by their objectives.

use super::objectives::{Objectives, Order};

/// One point of a Pareto front.
#[derive(Debug, Clone, PartialEq)]
pub struct Entry {
    /// The objectives, equal for all members.
    pub objectives: Objectives,
    /// Places of the designs that have them, ascending.
    pub members: Vec<usize>,
}

/// The Pareto front of some designs by their costs, the best first by an order; `objectives` are those of a
/// design.
pub(crate) fn front<const N: usize>(
    costs: &[[f64; N]],
    order: Order,
    objectives: impl Fn(usize) -> Objectives,
) -> Vec<Entry> {
    let entries = epicyclic_numerics::front::front(costs, order.of_costs());
    entries.into_iter().map(|members| Entry { objectives: objectives(members[0]), members }).collect()
}
