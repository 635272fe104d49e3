//! Non-dominated designs: the Pareto front.
//!
//! A design is described by its costs; smaller is better. It *dominates* another if no cost is higher and at
//! least one is lower. The front holds all designs that no other dominates. Designs of equal costs do not
//! dominate each other, so either all or none are on the front.
//!
//! # Method
//! Comparisons use ranks first: small whole numbers that never fall where a cost rises. Sixteen of them are
//! compared at once. A tree over the designs answers whether any design dominates a given one. It divides
//! them by the median of one rank after another into groups of sixteen, these into groups of sixteen groups,
//! and so on. Every group stores the least and the greatest of every rank.
//!
//! The search compares each group with the groups that may hold a dominator of some of its designs:
//!
//! - a group whose least ranks are not all at or below the greatest ranks of the group in question holds
//!   none;
//! - a design whose ranks are all below the least ranks of a group dominates all of that group;
//! - any other group stays a candidate. The search goes on with the groups within both, down to single
//!   designs, where costs are compared if ranks do not decide.
//!
//! The answer is exact and does not depend on the order of the designs or on the number of threads.
//!
//! A design that another dominates is also dominated by one of the front, so dominated designs may be removed
//! at any time. Before the tree is built, those that a few [designs found before](thinned) dominate are
//! removed, and a run of equal designs is represented by one.
//!
//! A cost that is NaN compares with nothing: its design neither dominates nor is dominated, and is always on
//! the front.
//!
//! ```
//! use epicyclic_numerics::front::{front, non_dominated};
//! let costs = [[1.0, 3.0], [2.0, 2.0], [2.0, 3.0], [1.0, 3.0]];
//! assert_eq!(non_dominated(&costs), [0, 1, 3]);
//! assert_eq!(front(&costs, [1, 0]), [vec![1], vec![0, 3]]);
//! ```

mod ranks;
mod tree;

#[cfg(feature = "parallel")]
use rayon::prelude::*;
use std::ops::Range;
use tree::Tree;

/// Whether costs are at or below others, each.
#[inline]
#[must_use]
pub fn nowhere_worse<const N: usize>(one: &[f64; N], other: &[f64; N]) -> bool {
    // No branches, since a single cost seldom decides.
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

/// The front in the order of costs: the cost at the first place of `order` decides, then that at the next.
/// Each entry has the places of the designs that share its costs, ascending.
#[must_use]
pub fn front<const N: usize>(costs: &[[f64; N]], order: [usize; N]) -> Vec<Vec<usize>> {
    let first = order.first().copied();
    let key = |run: &Range<u32>| first.map_or(0, |first| in_order(costs[run.start as usize][first]));
    let mut runs: Vec<(i64, Range<u32>)> =
        front_runs(costs).into_iter().map(|run| (key(&run), run)).collect();
    let at = |run: &Range<u32>| &costs[run.start as usize];
    let rest = |one: &[f64; N], other: &[f64; N]| {
        let by = |place: &usize| one[*place].total_cmp(&other[*place]);
        order.iter().map(by).find(|found| found.is_ne()).unwrap_or(std::cmp::Ordering::Equal)
    };
    runs.sort_unstable_by(|(key, one), (other_key, other)| {
        key.cmp(other_key).then_with(|| rest(at(one), at(other)).then(one.start.cmp(&other.start)))
    });
    let alike = runs.chunk_by(|(key, one), (other_key, other)| key == other_key && at(one) == at(other));
    let places = |(_, run): &(i64, Range<u32>)| run.start as usize..run.end as usize;
    alike.map(|alike| alike.iter().flat_map(places).collect()).collect()
}

/// Whole number that orders floating-point numbers as [`f64::total_cmp`] does.
#[inline]
fn in_order(value: f64) -> i64 {
    let bits = value.to_bits().cast_signed();
    if bits < 0 { bits ^ i64::MAX } else { bits }
}

/// Places of the designs that no other dominates, ascending.
#[must_use]
pub fn non_dominated<const N: usize>(costs: &[[f64; N]]) -> Vec<u32> {
    front_runs(costs).into_iter().flatten().collect()
}

/// Places of the designs that no other dominates, as runs whose designs are equal.
fn front_runs<const N: usize>(costs: &[[f64; N]]) -> Vec<Range<u32>> {
    let thin = |(part, costs): (usize, &[[f64; N]])| {
        let mut places = thinned(costs);
        places.iter_mut().for_each(|place| *place += (part * PART) as u32);
        places
    };
    #[cfg(feature = "parallel")]
    let left: Vec<Vec<u32>> = costs.par_chunks(PART).enumerate().map(thin).collect();
    #[cfg(not(feature = "parallel"))]
    let left: Vec<Vec<u32>> = costs.chunks(PART).enumerate().map(thin).collect();
    let mut runs: Vec<Range<u32>> = vec![];
    for place in left.into_iter().flatten() {
        match runs.last_mut() {
            Some(run) if run.end == place && costs[run.start as usize] == costs[place as usize] => {
                run.end += 1;
            }
            _ => runs.push(place..place + 1),
        }
    }
    let is_number = |place: &u32| !costs[*place as usize].iter().any(|value| value.is_nan());
    let places: Vec<u32> = runs.iter().map(|run| run.start).filter(is_number).collect();
    let mut dominated = vec![false; costs.len()];
    for place in Tree::new(costs, &places).dominated() {
        dominated[place as usize] = true;
    }
    runs.retain(|run| !dominated[run.start as usize]);
    runs
}

/// Designs without most of those that others near them dominate, as ascending indices. Each is compared with
/// a few earlier designs, in both directions. A design that dominates one is likely to dominate the next.
#[must_use]
pub fn thinned<const N: usize>(costs: &[[f64; N]]) -> Vec<u32> {
    let mut places: Vec<u32> = (0..costs.len() as u32).collect();
    for _ in 0..2 {
        let mut rivals: Vec<&[f64; N]> = Vec::with_capacity(RIVALS);
        let mut last: Option<&[f64; N]> = None;
        places.retain(|&place| {
            let cost = &costs[place as usize];
            if last == Some(cost) {
                return true;
            }
            if let Some(rival) = rivals.iter().position(|rival| dominates(rival, cost)) {
                rivals[..=rival].rotate_right(1);
                return false;
            }
            rivals.truncate(RIVALS - 1);
            rivals.insert(rivals.len() / 2, cost);
            last = Some(cost);
            true
        });
        places.reverse();
    }
    places
}

/// Designs in a part that is thinned on its own.
const PART: usize = 1 << 10;

/// Earlier designs with which each design is compared.
const RIVALS: usize = 3;

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

    /// Compares each with each: slow, and the oracle of the tree.
    fn non_dominated_by_trial<const N: usize>(costs: &[[f64; N]]) -> Vec<u32> {
        let free = |place: &u32| !costs.iter().any(|other| dominates(other, &costs[*place as usize]));
        (0..costs.len() as u32).filter(free).collect()
    }

    #[test]
    fn what_is_not_a_number_compares_with_nothing() {
        let costs: Vec<[f64; 2]> =
            (0..100).map(|n| [f64::from(n), if n % 7 == 0 { f64::NAN } else { 1.0 }]).collect();
        assert_eq!(non_dominated(&costs), non_dominated_by_trial(&costs));
        assert!(non_dominated::<3>(&[]).is_empty());
    }

    /// Designs for more than one part; costs of few levels and some infinite.
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
            let order = [2, 0, 3, 1];
            let front = front(&costs, order);
            let by = |entry: &[usize]| order.map(|place| costs[entry[0]][place]);
            prop_assert!(front.windows(2).all(|pair| by(&pair[0]) < by(&pair[1])));
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
