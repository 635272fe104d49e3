//! What is kept of the designs while they are tried.
//!
//! # The first of the front without the rest
//! In the order of objectives no design dominates an earlier one. So a design is among the first of the
//! front if no *earlier* one dominates it and few enough on the front come before it. [`Leaders`] keeps
//! the first so many, by the order, of the designs met that no other one kept dominates:
//!
//! - A design that one kept dominates is not on the front.
//! - A design kept that a newcomer dominates is not on the front.
//! - A design that a *rival* dominates, a design of a sample tried before, is not on the front.
//! - A design after the last of as many rivals as there is room for is *lost* at once, without a look.
//! - A design with no room left is lost too, and the earliest of the lost is remembered: before it nothing
//!   is missing. If in the end enough leaders come before all lost, they are the first of the front.
//!   Otherwise the search runs again with more room; when all fits nothing is lost, so that ends.
//!
//! # The whole front
//! [`Contenders`] leaves out what a few designs met before dominate, which never errs; what remains is
//! compared in full afterwards.

use super::Point;
use crate::selection::objectives::{Costs, Order, dominates};
use std::cmp::Ordering;

/// Takes designs one by one.
pub(super) trait Gather {
    fn gather(&mut self, costs: Costs, point: Point);
}

/// Designs not dominated by a few others.
#[derive(Debug, Default)]
pub(super) struct Contenders {
    rivals: Vec<Costs>,
    pub(super) costs: Vec<Costs>,
    pub(super) points: Vec<Point>,
}

const RIVALS: usize = 24;

impl Gather for Contenders {
    #[inline]
    fn gather(&mut self, costs: Costs, point: Point) {
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

/// The first designs by an order that none of them dominates.
#[derive(Debug)]
pub(super) struct Leaders<'a> {
    order: Order,
    /// By the order; none dominates another.
    rivals: &'a [Costs],
    /// What comes after this is lost.
    cut: Option<Costs>,
    room: usize,
    kept: Vec<(Costs, Vec<Point>)>,
    lost: Option<Costs>,
}

impl<'a> Leaders<'a> {
    pub(super) fn new(order: Order, room: usize, rivals: &'a [Costs]) -> Self {
        let cut = if rivals.len() < room { None } else { rivals.last().copied() };
        Self { order, rivals, cut, room, kept: Vec::with_capacity(room.min(1024) + 1), lost: None }
    }

    /// The first rivals from the leaders of a sample.
    pub(super) fn rivals(sample: Vec<Self>, order: Order, room: usize) -> Vec<Costs> {
        let mut together = Leaders::new(order, usize::MAX - 1, &[]);
        for (costs, points) in sample.into_iter().flat_map(|leaders| leaders.kept) {
            together.take(costs, points);
        }
        together.kept.into_iter().map(|(costs, _)| costs).take(room).collect()
    }

    fn is_dominated(&self, costs: &Costs) -> bool {
        self.kept.iter().any(|(kept, _)| dominates(kept, costs))
            || self.rivals.iter().any(|rival| dominates(rival, costs))
    }

    fn lose(&mut self, costs: Costs) {
        if self.lost.as_ref().is_none_or(|lost| self.order.compare(&costs, lost).is_lt()) {
            self.lost = Some(costs);
        }
    }

    fn take(&mut self, costs: Costs, points: Vec<Point>) {
        if self.is_dominated(&costs) {
            return;
        }
        let place = self.kept.partition_point(|(kept, _)| self.order.compare(kept, &costs).is_lt());
        if let Some((kept, members)) = self.kept.get_mut(place)
            && *kept == costs
        {
            members.extend(points);
            return;
        }
        self.kept.retain(|(kept, _)| !dominates(&costs, kept));
        // What it dominates comes after it.
        self.kept.insert(place, (costs, points));
        if self.kept.len() > self.room
            && let Some((costs, _)) = self.kept.pop()
        {
            self.lose(costs);
        }
    }

    /// The first so many of the front from the leaders of all pieces; `None` where what was lost might
    /// be among them.
    pub(super) fn merge(all: Vec<Self>, order: Order, count: usize) -> Option<Vec<(Costs, Vec<Point>)>> {
        let mut together = Leaders::new(order, usize::MAX - 1, &[]);
        for leaders in all {
            if let Some(lost) = leaders.lost {
                together.lose(lost);
            }
            for (costs, points) in leaders.kept {
                together.take(costs, points);
            }
        }
        let mut leading = together.kept;
        let lost = together.lost;
        let safe = |costs: &Costs| lost.as_ref().is_none_or(|lost| order.compare(costs, lost).is_lt());
        let enough =
            lost.is_none() || leading.get(count.wrapping_sub(1)).is_some_and(|(costs, _)| safe(costs));
        if !enough && count > 0 {
            return None;
        }
        leading.truncate(count);
        for (_, points) in &mut leading {
            points.sort_unstable();
        }
        Some(leading)
    }
}

impl Gather for Leaders<'_> {
    #[inline]
    fn gather(&mut self, costs: Costs, point: Point) {
        if let Some(cut) = &self.cut
            && self.order.compare(&costs, cut) == Ordering::Greater
        {
            // Lost once is lost: the cut itself stands for all behind it.
            if self.lost.is_none() {
                self.lost = self.cut;
            }
            return;
        }
        if self.kept.len() == self.room
            && let Some((last, _)) = self.kept.last()
            && self.order.compare(&costs, last) == Ordering::Greater
        {
            // Dominated or not, it cannot be told from the lost: that only errs towards more room.
            if self.lost.as_ref().is_none_or(|lost| self.order.compare(&costs, lost).is_lt())
                && !self.is_dominated(&costs)
            {
                self.lost = Some(costs);
            }
            return;
        }
        self.take(costs, vec![point]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::selection::front::front;
    use crate::selection::objectives::Objectives;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn leaders_are_the_first_of_the_front_or_unsure(
            raw in proptest::collection::vec(proptest::array::uniform5(0..9_u8), 1..200),
            pieces in 1..5_usize,
            count in 1..6_usize,
            room in 1..40_usize,
        ) {
            let costs: Vec<Costs> = raw.into_iter().map(|cost| cost.map(f64::from)).collect();
            let order = Order::default();
            let mut sample = Leaders::new(order, room, &[]);
            for &cost in costs.iter().step_by(3) {
                sample.gather(cost, Point { patch: 0, levels: [0, 0] });
            }
            let rivals = Leaders::rivals(vec![sample], order, room);
            let leaders = costs.chunks(costs.len().div_ceil(pieces)).map(|chunk| {
                let mut leaders = Leaders::new(order, room, &rivals);
                for &cost in chunk {
                    leaders.gather(cost, Point { patch: 0, levels: [0, 0] });
                }
                leaders
            });
            let exact = front(&costs, order);
            match Leaders::merge(leaders.collect(), order, count) {
                Some(found) => {
                    prop_assert_eq!(found.len(), exact.len().min(count));
                    for ((cost, points), entry) in found.iter().zip(&exact) {
                        prop_assert_eq!(Objectives::of_costs(*cost), entry.objectives);
                        prop_assert_eq!(points.len(), entry.members.len());
                    }
                }
                None => prop_assert!(room < 200),
            }
        }
    }
}
