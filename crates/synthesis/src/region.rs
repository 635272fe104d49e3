//! Region of the points at which given functions are within the bounds of their gears: contracted, covered by
//! small ranges, and searched for its outermost points.
//!
//! # Formula
//! With `c` the middle and `h` half the width of a gear's bounds, its ratio deviates by at most `t·h` if:
//!
//! ```text
//! s·(P − (c − t·h)·Q) ≥ 0   and   s·((c + t·h)·Q − P) ≥ 0        s the sign of Q
//! ```
//!
//! Both are of the first degree in each `k` and in `t`. So over a range of them, with `x_j` from −1 to 1
//! across it, they are `Σ_S w_S·Π_{j∈S} x_j`. The part beyond the linear one, `|S| ≥ 2`, is itself of the
//! first degree in each `x_j`: its greatest value is at a corner. With that value added the linear parts are
//! inequalities that every point keeps. They are wrong by the square of the range's width; a linear programme
//! over them bounds each `k`, and `t`.
//!
//! If some `k` are equal, polynomials are their [polar forms](crate::equal). An inequality then has the sum
//! of the slopes of these `k` at the first of them.
//!
//! # Complete
//! A range is given up if the programme, or the signs at the corners, prove that it holds no better point
//! than the one found. A range below 10⁻⁷ of each `k` is given up as well. If the outermost points fill a
//! surface, ranges along all of it promise hardly more; then the search for them ends sooner
//! ([`Region::least_deviation`]).

use crate::equal::Equal;
use crate::linear::{MOST, Optimum, Programme, Row};
use crate::parts::{Bounds, Cuboid, corner_values};
use crate::ratio::Ratio;
use crate::solve::Function;
use crate::tolerance::{LAST, NEAR, NO_WIDTH, SMALLEST, WIDENING};
use epicyclic_numerics::roots::bisected_while;
use epicyclic_numerics::values::largest_absolute;
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// A range of each `k`, and after them of `t`.
type Range = [[f64; 2]; MOST];

/// Largest remaining part of a range's widths for which contracting is repeated.
const WORTH_MORE: f64 = 0.8;

/// The part of half the width of a gear's bounds by which the linear inequalities of a covering range may be
/// wrong.
const STRAIGHT: f64 = 0.5;

/// Largest number of ranges of a cover, as long as no function's output is at rest in them.
const COVER: usize = 512;

/// Number of ranges after which the tolerance of an outermost point is doubled.
const MANY: usize = 1024;

/// Distance about a point, as a part of each `k`, within which to look for gears that keep others from being
/// nearer.
const ABOUT: f64 = 0.003;

/// The most steps of one width towards an outermost point.
const STEPS: usize = 4;

/// A function and the gear that it has.
struct Form {
    coefficients: [Vec<f64>; 2],
    gear: Bounds,
    /// Upper bound of a deviation that is settled: not to be made less, but not to exceed this.
    settled: Option<f64>,
    /// Any ratio within the bounds is as good.
    free: bool,
}

/// A linear inequality over a range.
struct Edge {
    /// Sum of the products with others, for each variable, in the units of its row.
    bends: [f64; MOST],
    /// The row's unit, over half the width of the gear's bounds.
    unit: f64,
    /// The place of its gear.
    form: usize,
}

/// The points where each gear is within its bounds by its function.
pub(crate) struct Region {
    sets: usize,
    /// Sets with equal `k`: their ranges are one, and in the inequalities the first represents all.
    equal: Equal,
    forms: Vec<Form>,
    programme: Programme,
    rows: Vec<Row>,
    edges: Vec<Edge>,
    /// Whether an output may be at rest in the range, so that its gear has no inequality.
    stands: bool,
    /// Whether the inequalities are those of the planes that touch in the middle of the range: they prove
    /// nothing, but lead on.
    tangent: bool,
    values: [Vec<f64>; 2],
    products: Vec<f64>,
}

/// An outermost point.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Outermost {
    /// Value of the coordinate, greatest or least.
    pub(crate) value: f64,
    /// The ring-to-sun ratios.
    pub(crate) k: Vec<f64>,
}

/// Coordinate to be made greatest or least; `t` comes after the `k`.
struct Sought<'a> {
    coordinate: usize,
    /// 1 for the greatest, −1 for the least.
    side: f64,
    /// Point within the bounds, if the coordinate is a `k`.
    within: Option<&'a [f64]>,
}

/// A range, and the most that it can have. Of those with equal promises the one that was halved more often is
/// the greater: it leads to a point sooner.
struct Promise {
    most: f64,
    halved: u32,
    range: Range,
}

impl Ord for Promise {
    fn cmp(&self, other: &Self) -> Ordering {
        self.most.total_cmp(&other.most).then(self.halved.cmp(&other.halved))
    }
}

impl PartialOrd for Promise {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Promise {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Promise {}

impl Region {
    /// Region of these functions and gears, in turn, with these `k` equal. For the gears in `free` any ratio
    /// within the bounds is as good.
    pub(crate) fn new(ratios: &[Ratio], gears: &[Bounds], free: &[usize], sets: usize, equal: Equal) -> Self {
        let form = |(place, (ratio, gear)): (usize, (&Ratio, &Bounds))| Form {
            coefficients: Function::with_equal(*ratio, sets, equal).coefficients,
            gear: *gear,
            settled: free.contains(&place).then_some(1.0),
            free: free.contains(&place),
        };
        Self {
            sets,
            equal,
            forms: ratios.iter().zip(gears).enumerate().map(form).collect(),
            programme: Programme::default(),
            rows: Vec::new(),
            edges: Vec::new(),
            stands: false,
            tangent: false,
            values: [Vec::new(), Vec::new()],
            products: Vec::new(),
        }
    }

    /// Greatest deviation of a gear that is not settled, over half the width of its bounds. Infinite or not a
    /// number if an output is at rest, infinite if a settled deviation exceeds its bound.
    pub(crate) fn deviation(&mut self, k: &[f64]) -> f64 {
        let [above, below] = &mut self.values;
        let mut most: f64 = 0.0;
        for form in &self.forms {
            let [middle, half] = form.gear.middle_and_half();
            let ratio = value(&form.coefficients[0], k, above) / value(&form.coefficients[1], k, below);
            let deviation = match ((ratio - middle).abs() / half, form.settled) {
                (deviation, None) => deviation,
                (deviation, Some(settled)) if deviation <= settled => 0.0,
                _ => f64::INFINITY,
            };
            most = if deviation <= most { most } else { deviation };
        }
        most
    }

    /// Covers the region by ranges, which are so small that their inequalities are nearly straight, as long
    /// as their number is not too large.
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
            if !self.stands && (most < STRAIGHT || cover.len() + left.len() >= COVER) {
                cover.push(range);
            } else if width > SMALLEST {
                left.extend(self.halves(&range, if self.stands { widest } else { bent }));
            }
        }
        cover
    }

    /// The point with the least greatest deviation and this deviation, up to `close`, from a point that is
    /// known.
    pub(crate) fn least_deviation(&mut self, cover: &[Range], known: &[f64], close: f64) -> Outermost {
        let known = Outermost { value: self.deviation(known), k: known.to_vec() };
        let mut cover = cover.to_vec();
        cover.iter_mut().for_each(|range| range[self.sets] = [0.0, known.value]);
        let sought = Sought { coordinate: self.sets, side: -1.0, within: None };
        self.outermost(&cover, &sought, known, close)
    }

    /// Point, of those near one with the least greatest deviation, with the least deviations of the other
    /// gears too. The gears that keep the greatest deviation from being less are settled. The greatest of the
    /// others is then made least, until none is left.
    pub(crate) fn least_of_others(&mut self, range_of_k: &Cuboid, best: &Outermost) -> Vec<f64> {
        let mut whole = [[0.0; 2]; MOST];
        whole[..self.sets].copy_from_slice(range_of_k);
        let sought = Sought { coordinate: self.sets, side: -1.0, within: None };
        let mut best = best.clone();
        while self.forms.iter().any(|form| form.settled.is_none()) {
            whole[self.sets] = [0.0, best.value];
            let about = about(&whole, &best.k, ABOUT);
            if !self.straighten(&about) || self.promised(&about, &sought).is_none() {
                break;
            }
            let least = best.value + NEAR;
            let mut settles = false;
            for (edge, weight) in self.edges.iter().zip(self.programme.weights()) {
                if *weight > NEAR && self.forms[edge.form].settled.is_none() {
                    self.forms[edge.form].settled = Some(least);
                    settles = true;
                }
            }
            if !settles {
                break;
            }
            best.value = self.deviation(&best.k);
            whole[self.sets] = [0.0, best.value];
            self.polish(&whole, &sought, &mut best);
        }
        self.forms.iter_mut().for_each(|form| form.settled = form.free.then_some(1.0));
        best.k
    }

    /// The greatest or least value of a `k`, up to `close`, from a point within the bounds.
    pub(crate) fn outermost_k(
        &mut self,
        cover: &[Range],
        set: usize,
        upper: bool,
        within: &[f64],
        close: f64,
    ) -> f64 {
        let set = self.equal.first_of(set);
        let known = Outermost { value: within[set], k: within.to_vec() };
        let side = if upper { 1.0 } else { -1.0 };
        let sought = Sought { coordinate: set, side, within: Some(within) };
        self.outermost(cover, &sought, known, close).value
    }

    /// Outermost point of some ranges, up to `close`; the tolerance is doubled after every `MANY` ranges.
    fn outermost(
        &mut self,
        ranges: &[Range],
        sought: &Sought<'_>,
        mut best: Outermost,
        mut close: f64,
    ) -> Outermost {
        let Sought { coordinate, side, .. } = *sought;
        let end = usize::from(side > 0.0);
        let mut whole: Range = [[f64::INFINITY, f64::NEG_INFINITY]; MOST];
        for range in ranges {
            for (whole, range) in whole.iter_mut().zip(range) {
                *whole = [whole[0].min(range[0]), whole[1].max(range[1])];
            }
        }
        // Those that promise the most first: with their points many of the others are given up at once.
        let promise = |range: Range, halved| Promise { most: side * range[coordinate][end], halved, range };
        let mut left: BinaryHeap<Promise> = ranges.iter().map(|range| promise(*range, 0)).collect();
        let mut searched = 0;
        while let Some(Promise { most, halved, mut range }) = left.pop() {
            searched += 1;
            if searched % MANY == 0 {
                close *= 2.0;
            }
            let beyond = best.value + side * close;
            if most <= side * beyond {
                break;
            }
            range[coordinate][1 - end] =
                if side > 0.0 { range[coordinate][0].max(beyond) } else { range[coordinate][1].min(beyond) };
            self.equal.spread(&mut range);
            if !self.contract(&mut range) {
                continue;
            }
            let Some((bound, k)) = self.promised(&range, sought) else { continue };
            let mut bends = [0.0; MOST];
            for (edge, weight) in self.edges.iter().zip(self.programme.weights()) {
                bends.iter_mut().zip(edge.bends).for_each(|(sum, bend)| *sum += weight * bend);
            }
            let stands = self.stands;
            if self.improve(sought, k, &mut best) {
                self.polish(&whole, sought, &mut best);
            }
            range[coordinate][end] = side * (side * range[coordinate][end]).min(bound);
            self.equal.spread(&mut range);
            let (bent, most) = largest(&bends);
            let (widest, width) = self.widest(&range);
            if width > SMALLEST && side * (range[coordinate][end] - best.value) > close {
                let place = if stands || most == 0.0 { widest } else { bent };
                left.extend(self.halves(&range, place).map(|half| promise(half, halved + 1)));
            }
        }
        best
    }

    /// Upper bound of the coordinate in a range, by its inequalities, and the point at which they reach it.
    fn promised(&mut self, range: &Range, sought: &Sought<'_>) -> Option<(f64, Vec<f64>)> {
        let mut objective = [0.0; MOST];
        objective[sought.coordinate] = sought.side;
        let Optimum::Most { bound, point } = self.programme.most(&self.rows, &objective, self.sets + 1)
        else {
            return None;
        };
        let limit = sought.side * across(range[sought.coordinate], (sought.side * bound).clamp(-1.0, 1.0));
        let mut k: Vec<f64> =
            range[..self.sets].iter().zip(point).map(|(range, x)| across(*range, x)).collect();
        self.equal.spread(&mut k);
        Some((limit + WIDENING * limit.abs(), k))
    }

    /// Takes a point in the place of the best known, if it has more within the bounds.
    fn improve(&mut self, sought: &Sought<'_>, mut k: Vec<f64>, best: &mut Outermost) -> bool {
        let value = match sought.within {
            None => self.deviation(&k),
            Some(within) => {
                // The last point within the bounds on the line to it.
                let at = |part: f64| -> Vec<f64> {
                    within.iter().zip(&k).map(|(from, to)| from + part * (to - from)).collect()
                };
                let inner = if self.deviation(&k) <= 1.0 { 1.0 } else { 0.0 };
                let is_wide = |_, [inner, outer]: [f64; 2]| outer - inner > LAST;
                let [inner, _] =
                    bisected_while([inner, 1.0], is_wide, |part| self.deviation(&at(part)) <= 1.0);
                k = at(inner);
                k[sought.coordinate]
            }
        };
        let improves = sought.side * value > sought.side * best.value;
        if improves {
            *best = Outermost { value, k };
        }
        improves
    }

    /// Improves the best point step by step, by the planes that touch in it, over ever smaller ranges.
    fn polish(&mut self, whole: &Range, sought: &Sought<'_>, best: &mut Outermost) {
        self.tangent = true;
        for width in [0.03, 0.003, 0.0003, 0.00003] {
            for _ in 0..STEPS {
                let about = about(whole, &best.k, width);
                let improved = self.straighten(&about)
                    && self.promised(&about, sought).is_some_and(|(_, k)| self.improve(sought, k, best));
                if !improved {
                    break;
                }
            }
        }
        self.tangent = false;
    }

    /// Contracts a range by its inequalities, and sets up those of the rest. False if it holds no point.
    fn contract(&mut self, range: &mut Range) -> bool {
        loop {
            if !self.straighten(range) {
                return false;
            }
            let before = *range;
            let mut ratio = 1.0;
            let equal = self.equal;
            let open =
                |variable: &usize| before[*variable][1] > before[*variable][0] && !equal.follows(*variable);
            for variable in (0..=self.sets).filter(open) {
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
                let contracted = range[variable];
                equal.put(range, variable, contracted);
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
            // The bounds of `t` leave some room for the nonlinear part.
            let t = match form.settled {
                Some(settled) if !form.free => [settled - 0.5 * NEAR; 2],
                Some(settled) => [settled; 2],
                None => t,
            };
            for side in [-1.0, 1.0] {
                self.products.clear();
                for t in t {
                    let bound = middle + side * t * half;
                    let corners = self.values[0].iter().zip(&self.values[1]);
                    self.products.extend(corners.map(|(above, below)| sign * side * (bound * below - above)));
                }
                if !self.add_row(place, unit, widening) {
                    return false;
                }
            }
        }
        true
    }

    /// Adds the linear inequality of one whose values at the corners are given, unless it always holds;
    /// whether it can be kept.
    fn add_row(&mut self, form: usize, unit: f64, widening: f64) -> bool {
        let corners = self.products.len();
        let values = self.products.as_mut_slice();
        if values.iter().all(|value| *value < -widening) {
            return false;
        }
        if values.iter().all(|value| *value >= 0.0) {
            return true;
        }
        // Values at the corners become the coefficients of the products of the x.
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
        if !self.tangent {
            constant += values.iter().copied().fold(0.0, f64::max);
        }
        self.equal.gather(&mut slopes);
        self.equal.gather(&mut bends);
        let steepest = largest_absolute(slopes);
        if steepest == 0.0 {
            return constant >= 0.0;
        }
        slopes.iter_mut().chain(&mut bends).for_each(|value| *value /= steepest);
        constant /= steepest;
        self.rows.push(Row { slopes, constant });
        self.edges.push(Edge { bends, unit: steepest / unit, form });
        true
    }

    /// The `k` whose bounds differ most, and by which part of the lower.
    fn widest(&self, range: &Range) -> (usize, f64) {
        let widths = range[..self.sets].iter().map(|[least, most]| most / least - 1.0).enumerate();
        widths.fold((0, 0.0), |most, other| if other.1 > most.1 { other } else { most })
    }

    /// The halves of a range along a variable, and along those that are equal to it.
    fn halves(&self, range: &Range, variable: usize) -> [Range; 2] {
        let [least, most] = range[variable];
        [[least, 0.5 * (least + most)], [0.5 * (least + most), most]].map(|half| {
            let mut part = *range;
            self.equal.put(&mut part, variable, half);
            part
        })
    }
}

/// Range about a point by the part `width` of each `k`, within a whole.
fn about(whole: &Range, k: &[f64], width: f64) -> Range {
    let mut about = *whole;
    for (about, k) in about.iter_mut().zip(k) {
        *about = [about[0].max(k * (1.0 - width)), about[1].min(k * (1.0 + width))];
    }
    about
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
