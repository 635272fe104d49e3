//! Whether a set of elements has all wanted gears at common ring-to-sun ratios.
//!
//! # Method
//! A box of `k` and the functions that its elements can engage. A gear can be had from a function only if the box
//! reaches its bounds ([`parts`](crate::parts)). Where a gear has one function left, the box shrinks to what this function
//! allows: each inequality `P − g·Q ≥ 0` is of the first degree in each `k`, so along an edge of the box it begins or
//! ends at one point, and the hull of these points over all parallel edges holds every solution. Where several functions
//! are left, each is tried. When all gears have theirs, a point is sought from the middle of the box; if none is
//! found, the box is halved.
//!
//! # Complete
//! A box is given up when it provably has no solution. A box that shrinks below [`SMALLEST`] with neither a solution nor a proof is
//! *undecided*, and counted.

use crate::parts::{Bounds, Cuboid, WIDENING, coefficients, corner_values};
use crate::ratio::Ratio;

/// The relative width below which a box is not halved any more.
pub const SMALLEST: f64 = 1e-7;

/// The relative width below which functions are tried one by one. In wider boxes most gears reach several functions, and their
/// combinations are more than the boxes: with 0.1 a search for ten gears took a tenth of the time that it took with no
/// bound, with 0.005 thirty times as long as with 0.1.
const NARROW: f64 = 0.1;

/// A function that some of the elements engage.
#[derive(Debug, Clone)]
pub struct Function {
    /// Its formula.
    pub ratio: Ratio,
    /// Coefficients of `P` and `Q`.
    pub(crate) coefficients: [Vec<f64>; 2],
}

impl Function {
    /// With its coefficients for so many sets.
    #[must_use]
    pub fn new(ratio: Ratio, sets: usize) -> Self {
        Self { ratio, coefficients: [ratio.numerator, ratio.denominator].map(|part| coefficients(part, sets)) }
    }
}

/// What a search in a box came to.
#[derive(Debug, Clone, PartialEq)]
pub enum Outcome {
    /// A point with all gears.
    Found {
        /// The ring-to-sun ratios.
        k: Vec<f64>,
        /// For each gear its function.
        functions: Vec<usize>,
    },
    /// Proved: there is none.
    None,
    /// No point was found, and some boxes were too small to go on.
    Undecided,
}

/// A search over boxes for functions and gears.
pub struct Solver<'a> {
    functions: &'a [&'a Function],
    gears: &'a [Bounds],
    /// Which functions together are an answer.
    accept: &'a mut dyn FnMut(&[usize]) -> bool,
    values: Vec<[Vec<f64>; 2]>,
    undecided: bool,
}

impl<'a> Solver<'a> {
    /// A search for a point where each gear is within its bounds by a function of its own, and `accept` takes the functions.
    pub fn new(functions: &'a [&'a Function], gears: &'a [Bounds], accept: &'a mut dyn FnMut(&[usize]) -> bool) -> Self {
        let values = vec![[Vec::new(), Vec::new()]; functions.len()];
        Self { functions, gears, accept, values, undecided: false }
    }

    /// Searches a box.
    pub fn search(&mut self, cuboid: Cuboid) -> Outcome {
        self.undecided = false;
        let unknown = vec![None; self.gears.len()];
        match self.go(cuboid, unknown) {
            Some((k, functions)) => Outcome::Found { k, functions },
            None if self.undecided => Outcome::Undecided,
            None => Outcome::None,
        }
    }

    fn go(&mut self, mut cuboid: Cuboid, mut assigned: Vec<Option<usize>>) -> Option<(Vec<f64>, Vec<usize>)> {
        loop {
            let open = self.candidates(&cuboid, &mut assigned)?;
            let before: f64 = cuboid.iter().map(|[least, most]| (most / least).ln()).sum();
            for (gear, function) in assigned.iter().enumerate() {
                if let Some(function) = function {
                    self.shrink(&mut cuboid, *function, self.gears[gear].widened())?;
                }
            }
            let after: f64 = cuboid.iter().map(|[least, most]| (most / least).ln()).sum();
            if after < 0.8 * before {
                continue;
            }
            let (widest, width) = widest(&cuboid)?;
            let settled = open.is_none();
            if let Some((gear, functions)) = open.filter(|_| width < NARROW) {
                for function in functions {
                    let mut assigned = assigned.clone();
                    assigned[gear] = Some(function);
                    if let Some(found) = self.go(cuboid.clone(), assigned) {
                        return Some(found);
                    }
                }
                return None;
            }
            if settled {
                let functions: Vec<usize> = assigned.iter().flatten().copied().collect();
                if !(self.accept)(&functions) {
                    return None;
                }
                if let Some(k) = self.point(&cuboid, &functions) {
                    return Some((k, functions));
                }
                if width < SMALLEST {
                    self.undecided = true;
                    return None;
                }
            }
            let [least, most] = cuboid[widest];
            let middle = (least * most).sqrt();
            let mut lower = cuboid.clone();
            lower[widest] = [least, middle];
            if let Some(found) = self.go(lower, assigned.clone()) {
                return Some(found);
            }
            cuboid[widest] = [middle, most];
        }
    }

    /// Gives gears with one function left this function; nothing where a gear has none. Of gears with several, the one with the
    /// fewest and these.
    fn candidates(&mut self, cuboid: &[[f64; 2]], assigned: &mut [Option<usize>]) -> Option<Option<(usize, Vec<usize>)>> {
        for (function, [above, below]) in self.functions.iter().zip(&mut self.values) {
            corner_values(&function.coefficients[0], cuboid, above);
            corner_values(&function.coefficients[1], cuboid, below);
        }
        for (gear, function) in assigned.iter().enumerate() {
            if function.is_some_and(|function| !self.reaches(function, gear)) {
                return None;
            }
        }
        loop {
            let mut fewest: Option<(usize, Vec<usize>)> = None;
            let mut settled = false;
            for gear in 0..self.gears.len() {
                if assigned[gear].is_some() {
                    continue;
                }
                let left: Vec<usize> = (0..self.functions.len())
                    .filter(|function| !assigned.contains(&Some(*function)) && self.reaches(*function, gear))
                    .collect();
                match left.as_slice() {
                    [] => return None,
                    [function] => {
                        assigned[gear] = Some(*function);
                        settled = true;
                    }
                    _ if fewest.as_ref().is_none_or(|(_, functions)| left.len() < functions.len()) => {
                        fewest = Some((gear, left));
                    }
                    _ => {}
                }
            }
            if !settled {
                return Some(fewest);
            }
        }
    }

    /// Whether the box may hold a point where the function is within the gear's bounds.
    fn reaches(&self, function: usize, gear: usize) -> bool {
        let gear = self.gears[gear].widened();
        let [above, below] = &self.values[function];
        above.iter().zip(below).fold(3, |all, (above, below)| all & gear.side(*above, *below)) == 0
    }

    /// Shrinks the box to the hull of the points that a function may have within the bounds; nothing where there are none.
    fn shrink(&mut self, cuboid: &mut [[f64; 2]], function: usize, gear: Bounds) -> Option<()> {
        let [above, below] = &mut self.values[function];
        corner_values(&self.functions[function].coefficients[0], cuboid, above);
        corner_values(&self.functions[function].coefficients[1], cuboid, below);
        let sign = if below.iter().all(|value| *value > 0.0) {
            1.0
        } else if below.iter().all(|value| *value < 0.0) {
            -1.0
        } else {
            return Some(());
        };
        for set in 0..cuboid.len() {
            for (bound, side) in [(gear.least, sign), (gear.most, -sign)] {
                let value = |corner: usize| side * (above[corner] - bound * below[corner]);
                // Where along the edges, from 0 to 1, the inequality holds.
                let (mut first, mut last) = (f64::INFINITY, f64::NEG_INFINITY);
                for corner in (0..above.len()).filter(|corner| corner >> set & 1 == 0) {
                    let (begin, end) = (value(corner), value(corner | 1 << set));
                    if begin < 0.0 && end < 0.0 {
                        continue;
                    }
                    let root = begin / (begin - end);
                    first = first.min(if begin >= 0.0 { 0.0 } else { root });
                    last = last.max(if end >= 0.0 { 1.0 } else { root });
                }
                if first > last {
                    return None;
                }
                let [least, most] = cuboid[set];
                let (lower, upper) = (
                    (least + first * (most - least)) * (1.0 - WIDENING),
                    (least + last * (most - least)) * (1.0 + WIDENING),
                );
                // The values at the corners belong to the box before: a later set may only be shrunk with new ones.
                if lower > least + 0.01 * (most - least) || upper < most - 0.01 * (most - least) {
                    cuboid[set] = [lower.max(least), upper.min(most)];
                    corner_values(&self.functions[function].coefficients[0], cuboid, above);
                    corner_values(&self.functions[function].coefficients[1], cuboid, below);
                }
            }
        }
        Some(())
    }

    /// A point of the box where each gear is within its bounds, if a few Gauss-Newton steps from the middle lead there.
    fn point(&self, cuboid: &[[f64; 2]], functions: &[usize]) -> Option<Vec<f64>> {
        let mut k: Vec<f64> = cuboid.iter().map(|[least, most]| 0.5 * (least + most)).collect();
        for _ in 0..6 {
            let ratios: Vec<f64> = functions.iter().map(|function| self.functions[*function].ratio.value(&k)).collect();
            if ratios.iter().zip(self.gears).all(|(ratio, gear)| gear.contain(*ratio)) {
                return Some(k);
            }
            let step = self.step(&k, functions, &ratios)?;
            for ((k, step), [least, most]) in k.iter_mut().zip(step).zip(cuboid) {
                *k = (*k + step).clamp(*least, *most);
            }
        }
        None
    }

    /// The step that least squares of the deviations, each by its tolerance, ask for.
    fn step(&self, k: &[f64], functions: &[usize], ratios: &[f64]) -> Option<Vec<f64>> {
        let sets = k.len();
        let mut normal = vec![vec![0.0; sets + 1]; sets];
        for ((function, ratio), gear) in functions.iter().zip(ratios).zip(self.gears) {
            let half = 0.5 * (gear.most - gear.least);
            let deviation = (ratio - 0.5 * (gear.most + gear.least)) / half;
            let slopes: Vec<f64> = (0..sets).map(|set| self.slope(*function, k, set) / half).collect();
            for row in 0..sets {
                for column in 0..sets {
                    normal[row][column] += slopes[row] * slopes[column];
                }
                normal[row][sets] -= slopes[row] * deviation;
            }
        }
        // A little damping: a `k` that moves nothing stays.
        for (set, row) in normal.iter_mut().enumerate() {
            row[set] = row[set] * (1.0 + 1e-9) + 1e-9;
        }
        solve_linear(normal)
    }

    /// The slope of a ratio along one `k`, by the quotient rule on its two polynomials.
    fn slope(&self, function: usize, k: &[f64], set: usize) -> f64 {
        let ratio = self.functions[function].ratio;
        // Of the first degree in `k_set`: the difference over a step of 1 is the slope.
        let mut next = k.to_vec();
        next[set] += 1.0;
        let (above, below) = (ratio.numerator.value(k), ratio.denominator.value(k));
        let (up, down) = (ratio.numerator.value(&next) - above, ratio.denominator.value(&next) - below);
        (up * below - above * down) / (below * below)
    }
}

/// The `k` whose bounds differ most, and by which part of the lower.
fn widest(cuboid: &[[f64; 2]]) -> Option<(usize, f64)> {
    let widths = cuboid.iter().map(|[least, most]| most / least - 1.0).enumerate();
    widths.max_by(|one, other| one.1.total_cmp(&other.1))
}

/// Solves rows of coefficients and right side by elimination with pivots.
fn solve_linear(mut rows: Vec<Vec<f64>>) -> Option<Vec<f64>> {
    let size = rows.len();
    for column in 0..size {
        let pivot = (column..size).max_by(|one, other| rows[*one][column].abs().total_cmp(&rows[*other][column].abs()))?;
        rows.swap(column, pivot);
        if rows[column][column].is_nan() || rows[column][column] == 0.0 {
            return None;
        }
        let (above, below) = rows.split_at_mut(column + 1);
        let pivot = &above[column];
        for row in below {
            let factor = row[column] / pivot[column];
            for (entry, pivot) in row.iter_mut().zip(pivot).skip(column) {
                *entry -= factor * pivot;
            }
        }
    }
    let mut solution = vec![0.0; size];
    for row in (0..size).rev() {
        let known: f64 = (row + 1..size).map(|column| rows[row][column] * solution[column]).sum();
        solution[row] = (rows[row][size] - known) / rows[row][row];
    }
    solution.iter().all(|value| value.is_finite()).then_some(solution)
}
