//! Non-dominated designs: the Pareto front.
//!
//! A design is its costs, each to be made small. It *dominates* another if it is nowhere worse and somewhere better;
//! the front holds what nothing dominates. Designs of equal costs do not dominate each other: they stand on the front
//! together or not at all.
//!
//! A tree over the designs answers "does any design dominate this one?": it splits them by the median of
//! one cost after another and keeps the least and the greatest of every cost in every part. A part whose
//! least costs are not all at or below the design's holds no dominator; a part whose greatest costs are,
//! and differ somewhere, consists of nothing else. Only what is neither is opened. Every design is asked
//! about once, independently of all others, so the answer does not depend on order or threads, and
//! nothing is left out by approximation.
//!
//! A cost that is not a number compares with nothing: its design neither dominates nor is dominated.
//!
//! ```
//! use epicyclic_pareto::{front, non_dominated};
//! let costs = [[1.0, 3.0], [2.0, 2.0], [2.0, 3.0], [1.0, 3.0]];
//! assert_eq!(non_dominated(&costs), [0, 1, 3]);
//! let by_second = |one: &[f64; 2], other: &[f64; 2]| one[1].total_cmp(&other[1]);
//! assert_eq!(front(&costs, by_second), [vec![1], vec![0, 3]]);
//! ```

mod tolerance;

#[cfg(feature = "parallel")]
use rayon::prelude::*;
use std::cmp::Ordering;
use tolerance::LEAST_SCALE;

/// Whether costs are at or below others, each.
#[inline]
#[must_use]
pub fn nowhere_worse<const N: usize>(one: &[f64; N], other: &[f64; N]) -> bool {
    // All without a branch: mostly none decides alone.
    let mut holds = true;
    for place in 0..N {
        holds &= one[place] <= other[place];
    }
    holds
}

/// Whether costs are nowhere worse than others and somewhere better.
#[inline]
#[must_use]
pub fn dominates<const N: usize>(one: &[f64; N], other: &[f64; N]) -> bool {
    nowhere_worse(one, other) && one != other
}

/// The front in an order that sorts equal costs together, each entry with the places of the designs that share its
/// costs, ascending.
#[must_use]
pub fn front<const N: usize>(
    costs: &[[f64; N]],
    compare: impl Fn(&[f64; N], &[f64; N]) -> Ordering,
) -> Vec<Vec<usize>> {
    let at = |place: u32| &costs[place as usize];
    let mut places = non_dominated(costs);
    places.sort_by(|&a, &b| compare(at(a), at(b)).then(a.cmp(&b)));
    let alike = places.chunk_by(|&a, &b| at(a) == at(b));
    alike.map(|alike| alike.iter().map(|&place| place as usize).collect()).collect()
}

/// Places of the designs that no other dominates, ascending.
#[must_use]
pub fn non_dominated<const N: usize>(costs: &[[f64; N]]) -> Vec<u32> {
    let mut left: Vec<u32> = (0..costs.len() as u32).collect();
    let tree = Tree::new(costs);
    let ask = |place: &u32| tree.holds_dominator_of(&costs[*place as usize]);
    #[cfg(feature = "parallel")]
    let dominated: Vec<bool> = left.par_iter().with_min_len(256).map(ask).collect();
    #[cfg(not(feature = "parallel"))]
    let dominated: Vec<bool> = left.iter().map(ask).collect();
    left.retain(|place| !dominated[*place as usize]);
    left
}

/// The same by comparing each with each: slow, and the oracle of the tree.
#[must_use]
pub fn non_dominated_by_trial<const N: usize>(costs: &[[f64; N]]) -> Vec<u32> {
    let free = |place: &u32| !costs.iter().any(|other| dominates(other, &costs[*place as usize]));
    (0..costs.len() as u32).filter(free).collect()
}

/// Designs in a part that is not split further.
const LEAF: usize = 16;

struct Node<const N: usize> {
    least: [f64; N],
    greatest: [f64; N],
    /// First and end of its designs in `Tree::designs`.
    designs: [u32; 2],
    /// Where the second child is; the first is the next node. 0 of a leaf.
    second: u32,
}

struct Tree<const N: usize> {
    designs: Vec<[f64; N]>,
    nodes: Vec<Node<N>>,
}

impl<const N: usize> Tree<N> {
    fn new(costs: &[[f64; N]]) -> Self {
        let mut tree = Self { designs: costs.to_vec(), nodes: vec![] };
        if !tree.designs.is_empty() {
            tree.grow(0, tree.designs.len());
        }
        tree
    }

    fn grow(&mut self, from: usize, to: usize) {
        let (mut least, mut greatest) = ([f64::INFINITY; N], [f64::NEG_INFINITY; N]);
        let mut is_ordered = true;
        for cost in &self.designs[from..to] {
            for (place, value) in cost.iter().enumerate() {
                is_ordered &= !value.is_nan();
                least[place] = least[place].min(*value);
                greatest[place] = greatest[place].max(*value);
            }
        }
        if !is_ordered {
            // The greatest of what does not compare says nothing of the part.
            greatest = [f64::NAN; N];
        }
        let node = self.nodes.len();
        self.nodes.push(Node { least, greatest, designs: [from as u32, to as u32], second: 0 });
        if to - from <= LEAF {
            return;
        }
        // Relative spread, so that the unit of a cost does not matter.
        let scale = |place: usize| greatest[place].abs().max(least[place].abs()).max(LEAST_SCALE);
        let spread = |place: usize| (greatest[place] - least[place]) / scale(place);
        let widest = (0..N).max_by(|a, b| spread(*a).total_cmp(&spread(*b))).unwrap_or(0);
        let middle = (to - from) / 2;
        self.designs[from..to].select_nth_unstable_by(middle, |a, b| a[widest].total_cmp(&b[widest]));
        self.grow(from, from + middle);
        self.nodes[node].second = self.nodes.len() as u32;
        self.grow(from + middle, to);
    }

    fn holds_dominator_of(&self, cost: &[f64; N]) -> bool {
        // Halved 2³² designs are 28 levels above their leaves, and a level leaves one node waiting.
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

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Few levels, for many ties.
    fn levels<const N: usize>(most: usize) -> impl Strategy<Value = Vec<[f64; N]>> {
        let costs = proptest::collection::vec(0..12_u8, N);
        proptest::collection::vec(costs, 0..most).prop_map(|all| {
            all.iter().map(|cost| std::array::from_fn(|place| f64::from(cost[place]))).collect()
        })
    }

    #[test]
    fn what_is_not_a_number_compares_with_nothing() {
        let costs: Vec<[f64; 2]> =
            (0..100).map(|n| [f64::from(n), if n % 7 == 0 { f64::NAN } else { 1.0 }]).collect();
        assert_eq!(non_dominated(&costs), non_dominated_by_trial(&costs));
        assert!(non_dominated::<3>(&[]).is_empty());
    }

    proptest! {
        #[test]
        fn the_tree_finds_what_trial_finds(five in levels::<5>(600), three in levels::<3>(300), one in levels::<1>(60)) {
            prop_assert_eq!(non_dominated(&five), non_dominated_by_trial(&five));
            prop_assert_eq!(non_dominated(&three), non_dominated_by_trial(&three));
            prop_assert_eq!(non_dominated(&one), non_dominated_by_trial(&one));
        }

        #[test]
        fn so_it_does_where_nothing_is_equal(
            costs in proptest::collection::vec(proptest::array::uniform3(-1.0..1.0_f64), 0..300)
        ) {
            prop_assert_eq!(non_dominated(&costs), non_dominated_by_trial(&costs));
        }

        #[test]
        fn a_front_is_complete_and_lists_equal_designs_together(costs in levels::<4>(80)) {
            let compare = |one: &[f64; 4], other: &[f64; 4]| {
                one.iter().zip(other).fold(Ordering::Equal, |order, (a, b)| order.then(a.total_cmp(b)))
            };
            let front = front(&costs, compare);
            prop_assert!(front.windows(2).all(|pair| compare(&costs[pair[0][0]], &costs[pair[1][0]]).is_lt()));
            for members in &front {
                let cost = costs[members[0]];
                prop_assert!(members.iter().all(|&member| costs[member] == cost));
                prop_assert_eq!(costs.iter().filter(|other| **other == cost).count(), members.len());
            }
            for cost in &costs {
                prop_assert!(front.iter().any(|members| nowhere_worse(&costs[members[0]], cost)));
            }
        }
    }
}
