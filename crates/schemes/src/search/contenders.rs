//! Designs kept while they are tried: those that a few met before do not dominate.
//!
//! What is left out is dominated by a design that was met, so nothing is left out in error; what
//! remains is compared in full afterwards. This only keeps the many neighbours with fewer planets, which
//! something near by dominates, out of memory.

use super::Point;
use crate::selection::objectives::{Costs, dominates};

/// Designs of a piece of work, with their costs.
#[derive(Debug, Default)]
pub(super) struct Contenders {
    rivals: Vec<Costs>,
    pub(super) costs: Vec<Costs>,
    pub(super) points: Vec<Point>,
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
