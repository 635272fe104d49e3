//! Non-dominated designs: the Pareto front.
//!
//! A design is its costs, each to be made small. It *dominates* another if it is nowhere worse and somewhere better;
//! the front holds what nothing dominates. Designs of equal costs do not dominate each other: they stand on the front
//! together or not at all.
//!
//! A tree over the designs answers "which of them does any design dominate?": it splits them by the median of
//! one cost after another and keeps the least and the greatest of every cost in every part. Each part is asked about with
//! the parts that may hold a dominator of some of its designs. A part whose least costs are not all at or below the
//! greatest of the part asked about holds none; a part whose greatest costs are at or below its least, and differ
//! somewhere, dominates all of it. What is neither stays a candidate, and the halves of the part are asked about with
//! the halves of its candidates, down to leaves of some designs, which are compared. There costs rounded to singles come
//! first: rounding keeps the order, so what they rule out is so, and what is left is compared in full. Nothing is left out by
//! approximation, and the answer does not depend on order or threads.
//!
//! The tree is grown over what is left after the same question was asked within parts of consecutive designs: a design
//! dominated by another is dominated by one of the front too, so those that are may be left out at any time.
//!
//! A cost that is not a number compares with nothing: its design neither dominates nor is dominated, and stands on the
//! front without being asked about.
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
    let all: Vec<u32> = (0..costs.len() as u32).collect();
    // Neighbours dominate most of what is dominated at all, and small trees are quick.
    let parts: Vec<&[u32]> = all.chunks(PART).collect();
    let ask = |part: &&[u32]| left_of(costs, part);
    #[cfg(feature = "parallel")]
    let left: Vec<Vec<u32>> = parts.par_iter().map(ask).collect();
    #[cfg(not(feature = "parallel"))]
    let left: Vec<Vec<u32>> = parts.iter().map(ask).collect();
    if left.len() == 1 { left.concat() } else { left_of(costs, &left.concat()) }
}

/// Those of some places, ascending, whose designs are not dominated by one at these places.
fn left_of<const N: usize>(costs: &[[f64; N]], places: &[u32]) -> Vec<u32> {
    let tree = Tree::new(costs, places);
    let mut dominated = vec![false; tree.designs.len()];
    if !tree.nodes.is_empty() {
        tree.ask(0, &[0], &mut dominated);
    }
    let dominated = std::iter::zip(&tree.places, dominated).filter(|(_, is_dominated)| *is_dominated);
    let mut out: Vec<u32> = dominated.map(|(&place, _)| place).collect();
    out.sort_unstable();
    let mut out = out.into_iter().peekable();
    places.iter().copied().filter(|place| out.next_if_eq(place).is_none()).collect()
}

/// The same by comparing each with each: slow, and the oracle of the tree.
#[must_use]
pub fn non_dominated_by_trial<const N: usize>(costs: &[[f64; N]]) -> Vec<u32> {
    let free = |place: &u32| !costs.iter().any(|other| dominates(other, &costs[*place as usize]));
    (0..costs.len() as u32).filter(free).collect()
}

/// Designs in a part that is not split further.
const LEAF: usize = 16;

/// Designs among which dominated ones are looked for before all.
const PART: usize = 1 << 10;

/// Designs of which the widest spread is taken.
const SAMPLE: usize = 32;

/// Designs from which on the halves of a part are asked about at the same time.
#[cfg(feature = "parallel")]
const JOINT: usize = 1 << 10;

#[derive(Clone, Copy)]
struct Node<const N: usize> {
    least: [f64; N],
    greatest: [f64; N],
    /// First and end of its designs in `Tree::designs`.
    designs: [u32; 2],
    /// Where the second child is; the first is the next node. 0 of a leaf.
    second: u32,
    /// Of a leaf, its place in `Tree::leaves`.
    leaf: u32,
}

impl<const N: usize> Node<N> {
    fn count(&self) -> usize {
        (self.designs[1] - self.designs[0]) as usize
    }
}

/// Of designs whose costs are all numbers.
struct Tree<const N: usize> {
    designs: Vec<[f64; N]>,
    places: Vec<u32>,
    nodes: Vec<Node<N>>,
    leaves: Vec<Leaf<N>>,
}

/// Costs of the designs of a leaf, by cost, rounded to singles. Rounding keeps the order, so what is not at or below another
/// as a single is not so as a double.
struct Leaf<const N: usize>([[f32; LEAF]; N]);

impl<const N: usize> Leaf<N> {
    fn new(designs: &[[f64; N]]) -> Self {
        let mut columns = [[f32::INFINITY; LEAF]; N];
        for (lane, cost) in designs.iter().enumerate() {
            for place in 0..N {
                columns[place][lane] = cost[place] as f32;
            }
        }
        Self(columns)
    }

    /// The same by design.
    fn designs(&self) -> [[f32; N]; LEAF] {
        std::array::from_fn(|lane| std::array::from_fn(|place| self.0[place][lane]))
    }

    /// Which may be nowhere worse than a design, by bit.
    #[inline]
    fn at_or_below(&self, cost: &[f32; N]) -> u32 {
        self.lanes(|place, value| value - cost[place])
    }

    /// Which may be nowhere better than a design, by bit.
    #[inline]
    fn at_or_above(&self, cost: &[f32; N]) -> u32 {
        self.lanes(|place, value| cost[place] - value)
    }

    /// Of which designs no cost is above, by bit.
    #[inline]
    fn lanes(&self, above: impl Fn(usize, f32) -> f32) -> u32 {
        // The largest, lane by lane: for instructions that take several at once. What is not a number leaves it.
        let mut largest = [f32::NEG_INFINITY; LEAF];
        for (place, column) in self.0.iter().enumerate() {
            for (largest, value) in largest.iter_mut().zip(column) {
                let above = above(place, *value);
                *largest = if above > *largest { above } else { *largest };
            }
        }
        largest.iter().rev().fold(0, |found, largest| 2 * found + u32::from(*largest <= 0.0))
    }
}

type Design<const N: usize> = ([f64; N], u32);

impl<const N: usize> Tree<N> {
    fn new(costs: &[[f64; N]], places: &[u32]) -> Self {
        let mut designs: Vec<Design<N>> = places
            .iter()
            .map(|&place| (costs[place as usize], place))
            .filter(|(cost, _)| !cost.iter().any(|value| value.is_nan()))
            .collect();
        let mut nodes = Vec::with_capacity(4 * designs.len() / LEAF + 1);
        if !designs.is_empty() {
            Self::grow(&mut nodes, &mut designs, 0);
        }
        let (designs, places): (Vec<[f64; N]>, Vec<u32>) = designs.into_iter().unzip();
        let mut leaves = vec![];
        for node in nodes.iter_mut().filter(|node| node.second == 0) {
            node.leaf = leaves.len() as u32;
            leaves.push(Leaf::new(&designs[node.designs[0] as usize..node.designs[1] as usize]));
        }
        Self { designs, places, nodes, leaves }
    }

    fn grow(nodes: &mut Vec<Node<N>>, designs: &mut [Design<N>], from: u32) {
        let place = nodes.len();
        let count = designs.len();
        nodes.push(Node {
            least: [0.0; N],
            greatest: [0.0; N],
            designs: [from, from + count as u32],
            second: 0,
            leaf: 0,
        });
        if count <= LEAF {
            [nodes[place].least, nodes[place].greatest] = ends(designs.iter());
            return;
        }
        // Relative spread, so that the unit of a cost does not matter.
        let [least, greatest] = ends(designs.iter().step_by(count / SAMPLE + 1));
        let scale = |place: usize| greatest[place].abs().max(least[place].abs()).max(LEAST_SCALE);
        let spread = |place: usize| (greatest[place] - least[place]) / scale(place);
        let widest = (0..N).max_by(|a, b| spread(*a).total_cmp(&spread(*b))).unwrap_or(0);
        let middle = count / 2;
        designs.select_nth_unstable_by(middle, |a, b| a.0[widest].total_cmp(&b.0[widest]));
        let (low, high) = designs.split_at_mut(middle);
        Self::grow(nodes, low, from);
        let second = nodes.len();
        Self::grow(nodes, high, from + middle as u32);
        let (one, other) = (nodes[place + 1], nodes[second]);
        let node = &mut nodes[place];
        node.second = second as u32;
        for n in 0..N {
            node.least[n] = smaller(one.least[n], other.least[n]);
            node.greatest[n] = larger(one.greatest[n], other.greatest[n]);
        }
    }

    /// Marks the designs of a part that others dominate. What dominates any of them is in one of the candidates.
    fn ask(&self, part: usize, candidates: &[u32], dominated: &mut [bool]) {
        let asked = &self.nodes[part];
        let mut left: Vec<u32> = Vec::with_capacity(2 * candidates.len());
        let mut waiting: Vec<u32> = Vec::with_capacity(32);
        for &candidate in candidates {
            waiting.push(candidate);
            while let Some(place) = waiting.pop() {
                let node = &self.nodes[place as usize];
                if !nowhere_worse(&node.least, &asked.greatest) {
                    continue;
                }
                if dominates(&node.greatest, &asked.least) {
                    dominated.fill(true);
                    return;
                }
                if node.second != 0 && node.count() > asked.count() {
                    // The first child has the lower costs: look there first.
                    waiting.extend([node.second, place + 1]);
                } else {
                    left.push(place);
                }
            }
        }
        if asked.second == 0 {
            self.ask_leaf(asked, &left, dominated);
            return;
        }
        let children = [part + 1, asked.second as usize];
        let (first, second) = dominated.split_at_mut(self.nodes[children[0]].count());
        #[cfg(feature = "parallel")]
        if asked.count() >= JOINT {
            rayon::join(|| self.ask(children[0], &left, first), || self.ask(children[1], &left, second));
            return;
        }
        self.ask(children[0], &left, first);
        self.ask(children[1], &left, second);
    }

    /// The same of a leaf; the candidates are leaves.
    fn ask_leaf(&self, asked: &Node<N>, candidates: &[u32], dominated: &mut [bool]) {
        let of = |node: &Node<N>| &self.designs[node.designs[0] as usize..node.designs[1] as usize];
        let (designs, columns) = (of(asked), &self.leaves[asked.leaf as usize]);
        let singles = columns.designs();
        let all = |designs: &[[f64; N]]| (1 << designs.len()) - 1;
        let mut open: u32 = all(designs);
        for &candidate in candidates {
            let node = &self.nodes[candidate as usize];
            let (others, columns_of) = (of(node), &self.leaves[node.leaf as usize]);
            for lane in bits(columns.at_or_above(&node.least.map(|value| value as f32)) & open) {
                let below = columns_of.at_or_below(&singles[lane]) & all(others);
                if bits(below).any(|other| dominates(&others[other], &designs[lane])) {
                    dominated[lane] = true;
                    open &= !(1 << lane);
                }
            }
            if open == 0 {
                return;
            }
        }
    }
}

/// Places of the bits that are set, ascending.
#[inline]
fn bits(mut of: u32) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let place = of.trailing_zeros();
        of &= of.wrapping_sub(1);
        (place < u32::BITS).then_some(place as usize)
    })
}

/// The least and the greatest of every cost of some designs.
fn ends<'a, const N: usize>(designs: impl Iterator<Item = &'a Design<N>>) -> [[f64; N]; 2] {
    let (mut least, mut greatest) = ([f64::INFINITY; N], [f64::NEG_INFINITY; N]);
    for (cost, _) in designs {
        for place in 0..N {
            least[place] = smaller(cost[place], least[place]);
            greatest[place] = larger(cost[place], greatest[place]);
        }
    }
    [least, greatest]
}

/// The larger of two numbers, in one instruction.
#[inline]
#[must_use]
pub fn larger(one: f64, other: f64) -> f64 {
    if one > other { one } else { other }
}

/// The smaller of two numbers, in one instruction.
#[inline]
#[must_use]
pub fn smaller(one: f64, other: f64) -> f64 {
    if one < other { one } else { other }
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

    /// More than are asked about in one part; costs of few levels and some without end.
    #[test]
    fn many_designs_are_asked_about_in_parts() {
        let mut state = 1_u64;
        let mut next = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            state >> 40
        };
        let mut costs: Vec<[f64; 5]> = vec![];
        for _ in 0..8 * PART + 77 {
            let cost = [next(), next(), next(), next(), next()].map(|value| (value % 97) as f64);
            costs.push(cost.map(|value| match value {
                95.0 => f64::INFINITY,
                96.0 => f64::MAX,
                value => 1.0 + value * 1e-9,
            }));
        }
        let found = non_dominated(&costs);
        assert!(found.len() > 100);
        assert_eq!(found, non_dominated_by_trial(&costs));
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
