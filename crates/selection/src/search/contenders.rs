//! Designs kept while they are tried: those that a few met before do not dominate.
//!
//! What is left out is dominated by a design that was met, so nothing is left out in error; what
//! remains is compared in full afterwards. This only keeps the many neighbours with fewer planets, which
//! something near by dominates, out of memory.

use super::found::Point;
use crate::objectives::{Costs, Order};
use epicyclic_pareto::dominates;

/// Designs of a piece of work, with their costs.
#[derive(Debug, Default)]
pub(super) struct Contenders {
    rivals: Vec<Costs>,
    pub(super) costs: Vec<Costs>,
    pub(super) points: Vec<Point>,
}

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

    /// Keeps the first designs in an order, at most `count`, in the places that they had among each other: all whose
    /// costs stand before the costs returned, which are the first left out. There must be more than `count`.
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
            // What dominated one is likely to dominate the next.
            self.rivals[..=rival].rotate_right(1);
            return;
        }
        self.rivals.truncate(RIVALS - 1);
        self.rivals.insert(self.rivals.len() / 2, costs);
        self.costs.push(costs);
        self.points.push(point);
    }
}
