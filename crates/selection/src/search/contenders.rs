//! Designs kept while they are tried: those that a few met before do not dominate.
//!
//! What is left out is dominated by a design that was met, so nothing is left out in error; what
//! remains is compared in full afterwards. This only keeps the many neighbours with fewer planets, which
//! something near by dominates, out of memory.

use super::found::Point;
use crate::front::Entry;
use crate::objectives::{Costs, Objectives, Order};
use epicyclic_numerics::front::{dominates, nowhere_worse, thinned};
use std::sync::{Mutex, PoisonError};

/// Costs from which on designs are left out if only the first entries in an order are required. The bound
/// comes forward while designs are tried.
///
/// The bound is always the costs of some design. More entries of the front so far than are required come
/// before it. Designs tried later may dominate these and leave fewer than required; the bound has then come
/// too far.
#[derive(Debug)]
pub(super) struct Bound {
    pub(super) order: Order,
    kept: usize,
    costs: Mutex<Option<Costs>>,
}

impl Bound {
    /// Bound behind `kept` entries of the front of the designs tried.
    pub(super) fn new(order: Order, kept: usize) -> Self {
        Self { order, kept, costs: Mutex::new(None) }
    }

    /// Costs of the bound.
    pub(super) fn costs(&self) -> Option<Costs> {
        *self.costs.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Whether the bound comes after these costs.
    pub(super) fn is_after(&self, costs: &Costs) -> bool {
        self.costs().is_none_or(|bound| self.order.compare(costs, &bound).is_lt())
    }

    fn bring_to(&self, costs: Costs) {
        let mut bound = self.costs.lock().unwrap_or_else(PoisonError::into_inner);
        if bound.is_none_or(|bound| self.order.compare(&costs, &bound).is_lt()) {
            *bound = Some(costs);
        }
    }
}

/// Designs of a piece of work, with their costs.
#[derive(Debug, Default)]
pub(super) struct Contenders {
    rivals: Vec<Costs>,
    pub(super) costs: Vec<Costs>,
    pub(super) points: Vec<Point>,
    /// Number of designs from which on they are narrowed.
    enough: usize,
}

/// Designs that are not worth narrowing.
const ENOUGH: usize = 2048;

impl Contenders {
    /// Keeps the designs at these places, ascending.
    pub(super) fn keep(&mut self, places: &[u32]) {
        for (to, &from) in places.iter().enumerate() {
            self.costs[to] = self.costs[from as usize];
            self.points[to] = self.points[from as usize];
        }
        self.costs.truncate(places.len());
        self.points.truncate(places.len());
    }

    /// Takes a design.
    #[inline]
    pub(super) fn take(&mut self, costs: Costs, point: Point) {
        self.costs.push(costs);
        self.points.push(point);
    }

    /// Leaves out most designs from a place on that others from there on dominate.
    pub(super) fn thin(&mut self, from: usize) {
        let places = thinned(&self.costs[from..]);
        for (to, place) in (from..).zip(&places) {
            self.costs[to] = self.costs[from + *place as usize];
            self.points[to] = self.points[from + *place as usize];
        }
        self.costs.truncate(from + places.len());
        self.points.truncate(from + places.len());
    }

    /// [Narrows](Self::narrow) the designs once they have become many.
    pub(super) fn narrow_many(&mut self, bound: &Bound) {
        if self.costs.len() >= self.enough.max(ENOUGH) {
            self.narrow(bound);
            self.enough = 2 * self.costs.len();
        }
    }

    /// Keeps those of the first entries in the bound's order, and brings the bound to the next entry.
    pub(super) fn narrow(&mut self, bound: &Bound) {
        if let Some(costs) = bound.costs() {
            let is_before = |place: &u32| bound.order.compare(&self.costs[*place as usize], &costs).is_lt();
            let places: Vec<u32> = (0..self.costs.len() as u32).filter(is_before).collect();
            self.keep(&places);
        }
        let mut entries = first_of_front(&self.costs, bound.order, bound.kept);
        if entries.len() == bound.kept
            && let Some(last) = entries.pop()
        {
            bound.bring_to(self.costs[last.members[0]]);
        }
        let mut places: Vec<u32> =
            entries.iter().flat_map(|entry| &entry.members).map(|&place| place as u32).collect();
        places.sort_unstable();
        self.keep(&places);
    }

    /// Keeps the first designs in an order, at most `count`, in their present order.
    ///
    /// All designs whose costs come before the returned costs are kept; the returned costs are the first left
    /// out. There must be more than `count` designs.
    pub(super) fn first(&mut self, count: usize, order: Order) -> Costs {
        let mut places: Vec<u32> = (0..self.costs.len() as u32).collect();
        let compare = |a: &u32, b: &u32| order.compare(&self.costs[*a as usize], &self.costs[*b as usize]);
        let (_, first_out, _) = places.select_nth_unstable_by(count, compare);
        let first_out = self.costs[*first_out as usize];
        let before = |place: &u32| order.compare(&self.costs[*place as usize], &first_out).is_lt();
        let kept: Vec<u32> = (0..self.costs.len() as u32).filter(before).collect();
        self.keep(&kept);
        first_out
    }
}

const RIVALS: usize = 24;

impl Contenders {
    #[inline]
    pub(super) fn gather(&mut self, costs: Costs, point: Point) {
        if let Some(rival) = self.rivals.iter().position(|rival| dominates(rival, &costs)) {
            // A rival that dominated one design is likely to dominate the next.
            self.rivals[..=rival].rotate_right(1);
            return;
        }
        self.rivals.truncate(RIVALS - 1);
        self.rivals.insert(self.rivals.len() / 2, costs);
        self.costs.push(costs);
        self.points.push(point);
    }
}

/// The first entries of the front of some designs.
pub(super) fn first_of_front(costs: &[Costs], order: Order, count: usize) -> Vec<Entry> {
    let compare = |a: &u32, b: &u32| order.compare(&costs[*a as usize], &costs[*b as usize]).then(a.cmp(b));
    let mut taken = count.saturating_mul(64).max(1024);
    loop {
        let mut places: Vec<u32> = (0..costs.len() as u32).collect();
        if taken < places.len() {
            places.select_nth_unstable_by(taken, compare);
            places.truncate(taken);
        }
        places.sort_unstable_by(compare);
        let mut entries: Vec<Entry> = vec![];
        let mut kept: Vec<Costs> = vec![];
        for &place in &places {
            let cost = costs[place as usize];
            if kept.last() == Some(&cost) {
                if let Some(entry) = entries.last_mut() {
                    entry.members.push(place as usize);
                }
            } else if !kept.iter().any(|earlier| nowhere_worse(earlier, &cost)) {
                if entries.len() == count {
                    return entries;
                }
                kept.push(cost);
                entries.push(Entry {
                    objectives: Objectives::of_costs(cost, None),
                    members: vec![place as usize],
                });
            }
        }
        if taken >= costs.len() {
            return entries;
        }
        taken = taken.saturating_mul(8);
    }
}
