//! Which designs nothing dominates.
//!
//! A tree over the designs answers "does any design dominate this one?": it splits them by the median of
//! one cost after another and keeps the least and the greatest of every cost in every part. A part whose
//! least costs are not all at or below the design's holds no dominator; a part whose greatest costs are,
//! and differ somewhere, consists of nothing else. Only what is neither is opened. Every design is asked
//! about once, independently of all others, so the answer does not depend on order or threads, and
//! nothing is left out by approximation.

use super::objectives::{Costs, Objectives, Order, dominates, nowhere_worse};
use super::threads::map_light;

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
    let mut places: Vec<u32> = non_dominated(costs);
    places.sort_by(|&a, &b| order.compare(&costs[a as usize], &costs[b as usize]).then(a.cmp(&b)));
    places
        .chunk_by(|&a, &b| costs[a as usize] == costs[b as usize])
        .map(|equal| Entry {
            objectives: Objectives::of_costs(costs[equal[0] as usize]),
            members: equal.iter().map(|&place| place as usize).collect(),
        })
        .collect()
}

/// Places of the designs that no other dominates, ascending.
pub(crate) fn non_dominated(costs: &[Costs]) -> Vec<u32> {
    let mut left: Vec<u32> = (0..costs.len() as u32).collect();
    let tree = Tree::new(costs, &left);
    let dominated = map_light(&left, |&place| tree.holds_dominator_of(&costs[place as usize]));
    let mut verdict = dominated.into_iter();
    left.retain(|_| !verdict.next().unwrap_or(false));
    left
}

const LEAF: usize = 16;

struct Node {
    least: Costs,
    greatest: Costs,
    /// First and end of its designs in `Tree::designs`.
    designs: [u32; 2],
    /// Where the second child is; the first is the next node. 0 of a leaf.
    second: u32,
}

struct Tree {
    designs: Vec<Costs>,
    nodes: Vec<Node>,
}

impl Tree {
    fn new(costs: &[Costs], places: &[u32]) -> Self {
        let mut tree =
            Self { designs: places.iter().map(|&place| costs[place as usize]).collect(), nodes: vec![] };
        if !tree.designs.is_empty() {
            tree.grow(0, tree.designs.len());
        }
        tree
    }

    fn grow(&mut self, from: usize, to: usize) {
        let (mut least, mut greatest) = ([f64::INFINITY; 5], [f64::NEG_INFINITY; 5]);
        for cost in &self.designs[from..to] {
            for (place, value) in cost.iter().enumerate() {
                least[place] = least[place].min(*value);
                greatest[place] = greatest[place].max(*value);
            }
        }
        let node = self.nodes.len();
        self.nodes.push(Node { least, greatest, designs: [from as u32, to as u32], second: 0 });
        if to - from <= LEAF {
            return;
        }
        // Relative spread, so that the unit of an objective does not matter.
        let scale = |place: usize| greatest[place].abs().max(least[place].abs()).max(1e-300);
        let spread = |place: usize| (greatest[place] - least[place]) / scale(place);
        let widest = (0..5).max_by(|a, b| spread(*a).total_cmp(&spread(*b))).unwrap_or(0);
        let middle = (to - from) / 2;
        self.designs[from..to].select_nth_unstable_by(middle, |a, b| a[widest].total_cmp(&b[widest]));
        self.grow(from, from + middle);
        self.nodes[node].second = self.nodes.len() as u32;
        self.grow(from + middle, to);
    }

    fn holds_dominator_of(&self, cost: &Costs) -> bool {
        let mut waiting = [0_u32; 64];
        let mut count = usize::from(!self.nodes.is_empty());
        while count > 0 {
            count -= 1;
            let place = waiting[count] as usize;
            let node = &self.nodes[place];
            if !nowhere_worse(&node.least, cost) {
                continue;
            }
            if dominates(&node.greatest, cost) {
                return true;
            }
            if node.second == 0 {
                let [from, to] = node.designs;
                if self.designs[from as usize..to as usize].iter().any(|other| dominates(other, cost)) {
                    return true;
                }
            } else {
                // The first child has the lower costs: look there first.
                waiting[count] = node.second;
                waiting[count + 1] = place as u32 + 1;
                count += 2;
            }
        }
        false
    }
}

/// Places of the designs that no other dominates, by comparing each with each: slow, and the oracle of
/// the tree.
#[cfg(test)]
pub(crate) fn non_dominated_by_trial(costs: &[Costs]) -> Vec<u32> {
    let free = |place: &u32| !costs.iter().any(|other| dominates(other, &costs[*place as usize]));
    (0..costs.len() as u32).filter(free).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_tree_finds_what_trial_finds(raw in proptest::collection::vec(proptest::array::uniform5(0..12_u8), 0..600)) {
            let costs: Vec<Costs> = raw.into_iter().map(|cost| cost.map(f64::from)).collect();
            prop_assert_eq!(non_dominated(&costs), non_dominated_by_trial(&costs));
        }

        #[test]
        fn a_front_is_complete_and_lists_equal_designs_together(
            raw in proptest::collection::vec(proptest::array::uniform5(0..4_u8), 1..80)
        ) {
            let costs: Vec<Costs> = raw.into_iter().map(|cost| cost.map(f64::from)).collect();
            let front = front(&costs, Order::default());
            for entry in &front {
                let cost = costs[entry.members[0]];
                prop_assert!(entry.members.iter().all(|&member| costs[member] == cost));
                let alike = costs.iter().filter(|other| **other == cost).count();
                prop_assert_eq!(alike, entry.members.len());
            }
            for cost in &costs {
                let held = front.iter().any(|entry| nowhere_worse(&costs[entry.members[0]], cost));
                prop_assert!(held);
            }
        }
    }
}
