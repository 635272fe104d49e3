//! The points at which given functions are within the bounds of their gears: contracted, covered by small ranges, and searched
//! for their outermost points.
//!
//! # Formula
//! With `c` the middle and `h` half the width of a gear's bounds, its ratio deviates by at most the part `t` of `h` where
//!
//! ```text
//! s·(P − (c − t·h)·Q) ≥ 0   and   s·((c + t·h)·Q − P) ≥ 0        s the sign of Q
//! ```
//!
//! Both are of the first degree in each `k` and in `t`. So over a range of them, with `x_j` from −1 to 1 across it, they are
//! `Σ_S w_S·Π_{j∈S} x_j`, and what exceeds the linear part, `|S| ≥ 2`, is itself of the first degree in each `x_j`: its
//! greatest value is at a corner. With that value added the linear parts are inequalities that every point keeps. They
//! are wrong by the square of the range's width; a linear programme over them bounds each `k`, and `t`.
//!
//! # Complete
//! A range is given up where the programme, or the signs at the corners, prove that it holds no point with more than was
//! found. One that is below 10⁻⁷ of each `k` is given up as well.

use crate::linear::{MOST, Optimum, Programme, Row};
use crate::parts::{Bounds, Cuboid, coefficients, corner_values};
use crate::ratio::Ratio;
use crate::tolerance::{LAST, NO_WIDTH, SMALLEST, WIDENING};

/// A range of each `k`, and after them of `t`.
type Range = [[f64; 2]; MOST];

/// What is left of a range's widths at most for contracting it once more.
const WORTH_MORE: f64 = 0.8;

/// The part of half the width of a gear's bounds by which the linear inequalities of a covering range may be wrong.
const STRAIGHT: f64 = 0.5;

/// A function and the gear that it has.
struct Form {
    coefficients: [Vec<f64>; 2],
    gear: Bounds,
}

/// A linear inequality over a range.
struct Edge {
    /// What stands in products with others, for each variable, in the units of its row.
    bends: [f64; MOST],
    /// The row's unit, over half the width of the gear's bounds.
    unit: f64,
}

/// The points where each gear is within its bounds by its function.
pub(crate) struct Region {
    sets: usize,
    forms: Vec<Form>,
    programme: Programme,
    rows: Vec<Row>,
    edges: Vec<Edge>,
    /// Whether an output may stand still in the range, so that its gear has no inequality.
    stands: bool,
    values: [Vec<f64>; 2],
    products: Vec<f64>,
}

/// An outermost point.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Outermost {
    /// The coordinate that was sought.
    pub(crate) value: f64,
    /// The ring-to-sun ratios.
    pub(crate) k: Vec<f64>,
}

impl Region {
    /// Of these functions and gears, in turn.
    pub(crate) fn new(ratios: &[Ratio], gears: &[Bounds], sets: usize) -> Self {
        let form = |(ratio, gear): (&Ratio, &Bounds)| Form {
            coefficients: [ratio.numerator, ratio.denominator].map(|part| coefficients(part, sets)),
            gear: *gear,
        };
        Self {
            sets,
            forms: ratios.iter().zip(gears).map(form).collect(),
            programme: Programme::default(),
            rows: Vec::new(),
            edges: Vec::new(),
            stands: false,
            values: [Vec::new(), Vec::new()],
            products: Vec::new(),
        }
    }

    /// The greatest deviation of a gear, by half the width of its bounds; infinite or not a number where an output stands still.
    pub(crate) fn deviation(&mut self, k: &[f64]) -> f64 {
        let [above, below] = &mut self.values;
        let mut most: f64 = 0.0;
        for form in &self.forms {
            let [middle, half] = form.gear.middle_and_half();
            let ratio = value(&form.coefficients[0], k, above) / value(&form.coefficients[1], k, below);
            let deviation = (ratio - middle).abs() / half;
            most = if deviation <= most { most } else { deviation };
        }
        most
    }

    /// Ranges that together hold every point, each so small that its inequalities are nearly straight.
    pub(crate) fn cover(&mut self, range_of_k: &Cuboid) -> Vec<Range> {
        let mut whole = [[0.0; 2]; MOST];
        whole[..self.sets].copy_from_slice(range_of_k);
        whole[self.sets] = [1.0; 2];
        let (mut left, mut cover) = (vec![whole], Vec::new());
        while let Some(mut range) = left.pop() {
            if !self.contract(&mut range) {
                continue;
            }
            let mut bends = [0.0f64; MOST];
            for edge in &self.edges {
                bends.iter_mut().zip(edge.bends).for_each(|(most, bend)| *most = most.max(bend * edge.unit));
            }
            let (bent, most) = largest(&bends);
            let (widest, width) = self.widest(&range);
            if !self.stands && most < STRAIGHT {
                cover.push(range);
            } else if width > SMALLEST {
                left.extend(halves(&range, if self.stands { widest } else { bent }));
            }
        }
        cover
    }

    /// The point with the least greatest deviation, up to `close`, and this deviation, if it is below that of a point that is known.
    pub(crate) fn least_deviation(&mut self, cover: &[Range], known: &[f64], close: f64) -> Outermost {
        let known = Outermost { value: self.deviation(known), k: known.to_vec() };
        let mut cover = cover.to_vec();
        cover.iter_mut().for_each(|range| range[self.sets] = [0.0, known.value]);
        self.outermost(&cover, self.sets, -1.0, known, close, &mut |region, k| {
            Some(Outermost { value: region.deviation(&k), k })
        })
    }

    /// The greatest or least value of a `k`, up to `close`, seen from a point within: what lies beyond is found along the line to it.
    pub(crate) fn outermost_k(
        &mut self,
        cover: &[Range],
        set: usize,
        upper: bool,
        within: &[f64],
        close: f64,
    ) -> f64 {
        let known = Outermost { value: within[set], k: within.to_vec() };
        let side = if upper { 1.0 } else { -1.0 };
        let found = self.outermost(cover, set, side, known, close, &mut |region, k| {
            let mut part = [0.0, 1.0];
            let at = |part: f64| -> Vec<f64> {
                within.iter().zip(&k).map(|(from, to)| from + part * (to - from)).collect()
            };
            if region.deviation(&k) <= 1.0 {
                part = [1.0; 2];
            }
            while part[1] - part[0] > LAST {
                let middle = 0.5 * (part[0] + part[1]);
                let holds = region.deviation(&at(middle)) <= 1.0;
                part[usize::from(!holds)] = middle;
            }
            let k = at(part[0]);
            Some(Outermost { value: k[set], k })
        });
        found.value
    }

    /// The outermost point of some ranges along a coordinate. `reached` makes a point of those that the linear programmes give.
    fn outermost(
        &mut self,
        ranges: &[Range],
        coordinate: usize,
        side: f64,
        mut best: Outermost,
        close: f64,
        reached: &mut dyn FnMut(&mut Self, Vec<f64>) -> Option<Outermost>,
    ) -> Outermost {
        let end = usize::from(side > 0.0);
        let mut left: Vec<Range> = ranges.to_vec();
        // Those that promise the most first: with their points many of the others are given up at once.
        while let Some(place) = (0..left.len()).max_by(|one, other| {
            (side * left[*one][coordinate][end]).total_cmp(&(side * left[*other][coordinate][end]))
        }) {
            let mut range = left.swap_remove(place);
            let beyond = best.value + side * close;
            if side * range[coordinate][end] <= side * beyond {
                break;
            }
            range[coordinate][1 - end] =
                if side > 0.0 { range[coordinate][0].max(beyond) } else { range[coordinate][1].min(beyond) };
            if !self.contract(&mut range) {
                continue;
            }
            let mut objective = [0.0; MOST];
            objective[coordinate] = side;
            let (bound, point) = match self.programme.most(&self.rows, &objective, self.sets + 1) {
                Optimum::None => continue,
                Optimum::Most { bound, point } => (bound, point),
            };
            let mut bends = [0.0; MOST];
            for (edge, weight) in self.edges.iter().zip(self.programme.weights()) {
                bends.iter_mut().zip(edge.bends).for_each(|(sum, bend)| *sum += weight * bend);
            }
            let k = range[..self.sets].iter().zip(point).map(|(range, x)| across(*range, x)).collect();
            if let Some(found) = reached(self, k)
                && side * found.value > side * best.value
            {
                best = found;
            }
            let limit = across(range[coordinate], (side * bound).clamp(-1.0, 1.0));
            range[coordinate][end] = limit + side * WIDENING * limit.abs();
            if side * range[coordinate][end] <= side * (best.value + side * close) {
                continue;
            }
            let (bent, most) = largest(&bends);
            let (widest, width) = self.widest(&range);
            if width > SMALLEST {
                let place = if self.stands || most == 0.0 { widest } else { bent };
                left.extend(halves(&range, place));
            }
        }
        best
    }

    /// Contracts a range to what its inequalities leave, and sets up those of what is left. Whether it may hold a point.
    fn contract(&mut self, range: &mut Range) -> bool {
        loop {
            if !self.straighten(range) {
                return false;
            }
            let before = *range;
            let mut ratio = 1.0;
            for variable in (0..=self.sets).filter(|variable| before[*variable][1] > before[*variable][0]) {
                for side in [-1.0, 1.0] {
                    let mut objective = [0.0; MOST];
                    objective[variable] = side;
                    match self.programme.most(&self.rows, &objective, self.sets + 1) {
                        Optimum::None => return false,
                        Optimum::Most { bound, .. } if bound < 1.0 => {
                            let limit = across(before[variable], side * bound);
                            let limit = limit + side * WIDENING * limit.abs();
                            let end = usize::from(side > 0.0);
                            if side * limit < side * range[variable][end] {
                                range[variable][end] = limit;
                            }
                        }
                        Optimum::Most { .. } => {}
                    }
                }
                let width = |range: [f64; 2]| range[1] - range[0];
                if width(range[variable]) <= 0.0 {
                    // Within the widening of one point.
                    let middle = 0.5 * (range[variable][0] + range[variable][1]);
                    range[variable] = [middle; 2];
                }
                ratio *= width(range[variable]) / width(before[variable]);
            }
            if ratio > WORTH_MORE {
                return self.straighten(range);
            }
        }
    }

    /// The linear inequalities over a range; whether each can be kept.
    fn straighten(&mut self, range: &Range) -> bool {
        self.rows.clear();
        self.edges.clear();
        self.stands = false;
        let t = range[self.sets];
        for place in 0..self.forms.len() {
            let form = &self.forms[place];
            let [above, below] = &mut self.values;
            corner_values(&form.coefficients[0], &range[..self.sets], above);
            corner_values(&form.coefficients[1], &range[..self.sets], below);
            let [middle, half] = form.gear.middle_and_half();
            let least = below.iter().copied().fold(f64::INFINITY, f64::min);
            let most = below.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            if least <= 0.0 && most >= 0.0 {
                if !form.gear.widened().is_reached(above, below) {
                    return false;
                }
                self.stands = true;
                continue;
            }
            let sign = if least > 0.0 { 1.0 } else { -1.0 };
            let unit = half * least.abs().min(most.abs());
            let widening = WIDENING * middle.abs() * least.abs().max(most.abs());
            for side in [-1.0, 1.0] {
                self.products.clear();
                for t in t {
                    let bound = middle + side * t * half;
                    let corners = self.values[0].iter().zip(&self.values[1]);
                    self.products.extend(corners.map(|(above, below)| sign * side * (bound * below - above)));
                }
                if !self.add_row(unit, widening) {
                    return false;
                }
            }
        }
        true
    }

    /// Adds the linear inequality of one whose values at the corners are given, unless it always holds; whether it can be kept.
    fn add_row(&mut self, unit: f64, widening: f64) -> bool {
        let corners = self.products.len();
        let values = self.products.as_mut_slice();
        if values.iter().all(|value| *value < -widening) {
            return false;
        }
        if values.iter().all(|value| *value >= 0.0) {
            return true;
        }
        // From values at the corners to what stands in each product of the x.
        let mut step = 1;
        while step < corners {
            for block in values.chunks_exact_mut(2 * step) {
                let (lower, upper) = block.split_at_mut(step);
                for (lower, upper) in lower.iter_mut().zip(upper) {
                    (*lower, *upper) = (0.5 * (*lower + *upper), 0.5 * (*upper - *lower));
                }
            }
            step *= 2;
        }
        let mut slopes = [0.0; MOST];
        let mut bends = [0.0; MOST];
        let mut constant = values[0] + widening;
        for variable in 0..=self.sets {
            slopes[variable] = values[1 << variable];
        }
        values[0] = 0.0;
        for variable in 0..=self.sets {
            values[1 << variable] = 0.0;
        }
        for (product, value) in values.iter().enumerate() {
            for (variable, bend) in bends.iter_mut().enumerate() {
                if product >> variable & 1 == 1 {
                    *bend += value.abs();
                }
            }
        }
        // Back to the corners: the greatest value there.
        let mut step = 1;
        while step < corners {
            for block in values.chunks_exact_mut(2 * step) {
                let (lower, upper) = block.split_at_mut(step);
                for (lower, upper) in lower.iter_mut().zip(upper) {
                    (*lower, *upper) = (*lower - *upper, *lower + *upper);
                }
            }
            step *= 2;
        }
        constant += values.iter().copied().fold(0.0, f64::max);
        let steepest = slopes.iter().fold(0.0f64, |most, slope| most.max(slope.abs()));
        if steepest == 0.0 {
            return constant >= 0.0;
        }
        slopes.iter_mut().chain(&mut bends).for_each(|value| *value /= steepest);
        constant /= steepest;
        self.rows.push(Row { slopes, constant });
        self.edges.push(Edge { bends, unit: steepest / unit });
        true
    }

    /// The `k` whose bounds differ most, and by which part of the lower.
    fn widest(&self, range: &Range) -> (usize, f64) {
        let widths = range[..self.sets].iter().map(|[least, most]| most / least - 1.0).enumerate();
        widths.fold((0, 0.0), |most, other| if other.1 > most.1 { other } else { most })
    }
}

/// The place of the largest value, and this.
fn largest(values: &[f64; MOST]) -> (usize, f64) {
    values
        .iter()
        .copied()
        .enumerate()
        .fold((0, 0.0), |most, other| if other.1 > most.1 { other } else { most })
}

/// A value from the lower bound at −1 to the upper at 1.
fn across([least, most]: [f64; 2], x: f64) -> f64 {
    0.5 * ((1.0 - x) * least + (1.0 + x) * most)
}

/// The halves of a range along a variable.
fn halves(range: &Range, variable: usize) -> [Range; 2] {
    let [least, most] = range[variable];
    [[least, 0.5 * (least + most)], [0.5 * (least + most), most]].map(|half| {
        let mut part = *range;
        part[variable] = half;
        part
    })
}

/// The value of a polynomial, given by its coefficients.
fn value(coefficients: &[f64], k: &[f64], room: &mut Vec<f64>) -> f64 {
    room.clear();
    room.extend_from_slice(coefficients);
    // The last `k` first: its coefficients are the upper half.
    for k in k.iter().rev() {
        let half = room.len() / 2;
        let (constant, slope) = room.split_at_mut(half);
        constant.iter_mut().zip(&*slope).for_each(|(constant, slope)| *constant += slope * k);
        room.truncate(half);
    }
    room[0]
}

impl Bounds {
    /// The middle and half the width.
    pub(crate) fn middle_and_half(self) -> [f64; 2] {
        // Bounds without width still measure deviations.
        let half = (0.5 * (self.most - self.least)).max(NO_WIDTH * self.most.abs());
        [0.5 * (self.most + self.least), half]
    }
}
