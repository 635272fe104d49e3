//! One interval of a family: points of rising `l`, and the cells between them, halved where a better motor
//! may lie.

use crate::closure::{Family, Interval};
use crate::tolerance::EDGE;

use super::front::{Cover, Value};
use super::objective::Objective;
use super::point::{Point, Yardstick};

/// Largest number of times that a cell is halved.
const MOST_HALVINGS: i32 = 10;

/// State of the stretch between two neighbouring points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Cell {
    /// Not evaluated, or halved just now.
    Open,
    /// By estimate no motor in it is admissible.
    Refused,
    /// By estimate no motor in it is better than the front by more than the slack, or it is too narrow to be
    /// halved.
    Closed,
}

#[derive(Debug, Clone)]
pub(super) struct Branch {
    pub(super) family: Family,
    interval: Interval,
    pub(super) points: Vec<Point>,
    cells: Vec<Cell>,
    least_width: f64,
}

impl Branch {
    /// Branch with this number of evenly spaced points.
    pub(super) fn new(yardstick: &Yardstick, family: Family, interval: Interval, points: u32) -> Self {
        let last = points - 1;
        let part = |i: u32| (f64::from(i) / f64::from(last)).clamp(EDGE, 1.0 - EDGE);
        let points: Vec<Point> =
            (0..points).map(|i| Point::at(yardstick, &family, &interval, part(i))).collect();
        let cells = vec![Cell::Open; points.len() - 1];
        let least_width = 1.5 / f64::from(last) / 2.0_f64.powi(MOST_HALVINGS);
        Self { family, interval, points, cells, least_width }
    }

    /// Sorts the open cells out: those without admissible motors, those that the front covers, and the rest,
    /// which are halved. Cells beside a halved one are open again, as their estimates see a nearer neighbour.
    /// The number of points added.
    pub(super) fn refine(&mut self, yardstick: &Yardstick, front: &Cover, slack: f64) -> usize {
        self.sort_out(yardstick, front, slack);
        let before = std::mem::take(&mut self.cells);
        let halved = |i: usize| before.get(i) == Some(&Cell::Open);
        let old = std::mem::take(&mut self.points);
        let count = old.len();
        for (i, point) in old.into_iter().enumerate() {
            if let Some(from) = self.points.last().map(|point| point.part) {
                let cell = i - 1;
                if halved(cell) {
                    let middle = 0.5 * (from + point.part);
                    self.points.push(Point::at(yardstick, &self.family, &self.interval, middle));
                    self.cells.extend([Cell::Open; 2]);
                } else if halved(cell + 1) || cell.checked_sub(1).is_some_and(halved) {
                    self.cells.push(Cell::Open);
                } else {
                    self.cells.push(before[cell]);
                }
            }
            self.points.push(point);
        }
        self.points.len() - count
    }

    fn sort_out(&mut self, yardstick: &Yardstick, front: &Cover, slack: f64) {
        for i in 0..self.cells.len() {
            if self.cells[i] != Cell::Open {
                continue;
            }
            self.cells[i] = match self.prospect(yardstick, i) {
                Prospect::Refused => Cell::Refused,
                Prospect::Values(best) if front.covers(best, slack) || self.is_narrow(i) => Cell::Closed,
                Prospect::Values(_) => Cell::Open,
            };
        }
    }

    /// Whether a cell has been halved as often as may be.
    fn is_narrow(&self, i: usize) -> bool {
        self.points[i + 1].part - self.points[i].part < self.least_width
    }

    /// The best that may lie in a cell, by estimate: see [`bound`].
    fn prospect(&mut self, yardstick: &Yardstick, i: usize) -> Prospect {
        let ends = [i, i + 1];
        if ends.iter().all(|&end| !self.points[end].accepted()) {
            let margin = self.bound(i, |point| Some(point.margin));
            if self.is_narrow(i) || !margin.is_some_and(|margin| margin >= 0.0) {
                return Prospect::Refused;
            }
        }
        let numbers = self.family.numbers();
        // The neighbours too, so that an estimate does not depend on the points evaluated before.
        let near = i.saturating_sub(1)..(i + 3).min(self.points.len());
        for point in &mut self.points[near] {
            point.work(yardstick, numbers);
        }
        let mut best = Value::default();
        for &objective in &yardstick.objectives {
            // Displacement, radius and torque are estimated directly, since a radius may vanish at an end; a
            // ripple by its logarithm.
            let bound = match objective {
                Objective::DisplacementByVolume => {
                    self.bound(i, |point| Some(point.working?.by_volume())).map(libm::log)
                }
                Objective::Ripple => self.bound(i, |point| Some(-libm::log(point.working?.ripple()))),
                Objective::LeastRadius => self.bound(i, |point| Some(point.radius)).map(libm::log),
                Objective::FlankRipple => {
                    self.bound_where_teeth(i, |point| Some(-libm::log(point.at_flanks?.ripple)))
                }
                // Nothing is above its mean.
                Objective::LeastTorque => self
                    .bound_where_teeth(i, |point| Some(point.at_flanks?.least_over_mean))
                    .map(|least| libm::log(least.min(1.0))),
            };
            // No bound if an end is not a motor, being a rounding off the interval's own end, or if neither
            // end has teeth.
            let Some(bound) = bound.filter(|bound| !bound.is_nan()) else { return Prospect::Refused };
            best[objective as usize] = bound;
        }
        Prospect::Values(best)
    }

    /// Estimate as by `bound`, if an end may have no teeth. It is then the line through the other end and its
    /// neighbour, extended to the end without teeth.
    fn bound_where_teeth(&self, i: usize, quantity: impl Fn(&Point) -> Option<f64>) -> Option<f64> {
        let at = |k: usize| self.points.get(k).and_then(|point| Some((point.part, quantity(point)?)));
        let (here, there, beyond) = match (at(i), at(i + 1)) {
            (Some(from), None) => (from, self.points[i + 1].part, i.checked_sub(1).and_then(at)),
            (None, Some(to)) => (to, self.points[i].part, at(i + 2)),
            _ => return self.bound(i, quantity),
        };
        let rise =
            beyond.map_or(0.0, |(part, value)| ((here.1 - value) / (here.0 - part) * (there - here.0)).abs());
        Some(here.1 + rise)
    }

    /// Estimate of the most that a quantity reaches in a cell: the greater end, and the difference at one end
    /// from the line through the values beyond the other.
    ///
    /// The estimate is no less than the maximum of a concave function, also one with a kink; for a smooth one
    /// it is eight times its rise above the chord. Without a neighbour on either side the difference of the
    /// ends is added.
    fn bound(&self, i: usize, quantity: impl Fn(&Point) -> Option<f64>) -> Option<f64> {
        let at = |k: usize| self.points.get(k).and_then(|point| Some((point.part, quantity(point)?)));
        let (from, to) = (at(i)?, at(i + 1)?);
        let missed = |beyond: Option<(f64, f64)>, here: (f64, f64), there: (f64, f64)| {
            let (part, value) = beyond?;
            let slope = (here.1 - value) / (here.0 - part);
            Some((here.1 + slope * (there.0 - here.0) - there.1).abs())
        };
        let before = missed(i.checked_sub(1).and_then(at), from, to);
        let after = missed(at(i + 2), to, from);
        let rise = match (before, after) {
            (Some(before), Some(after)) => before.max(after),
            (Some(one), None) | (None, Some(one)) => one,
            (None, None) => (to.1 - from.1).abs(),
        };
        Some(from.1.max(to.1) + rise)
    }

    /// The estimates of every cell that may have admissible motors.
    pub(super) fn prospects(&mut self, yardstick: &Yardstick) -> Vec<Value> {
        let mut found = Vec::new();
        for i in 0..self.cells.len() {
            if self.cells[i] != Cell::Refused
                && let Prospect::Values(best) = self.prospect(yardstick, i)
            {
                found.push(best);
            }
        }
        found
    }
}

enum Prospect {
    Refused,
    Values(Value),
}
