//! A point of a box with all gears, when each has its function, or a proof that there is none.
//!
//! # Proof
//! A point with all gears keeps, of each, `c = g_most·Q − P ≥ 0` and `c = P − g_least·Q ≥ 0`, where `Q > 0`. Steps that make the sum of
//! the squares of what exceeds the bounds least end where that sum has no slope, so that with the excesses as weights the slopes of the
//! missed inequalities cancel each other. Their weighted sum `Σ λ·c` with `λ > 0` is of the first degree in each `k` as they are, so it is greatest at a
//! corner of the box: where it is negative at all corners, some inequality is missed at every point. This holds for any weights; good
//! ones prove boxes of a width about the root of what is missed, where each gear alone is ruled out in boxes as narrow as that.

use super::Solver;
use crate::class::MOST_SETS;
use crate::tolerance::DAMPING;

/// The most Gauss-Newton steps towards a point, of each kind.
const STEPS: usize = 6;

/// The greatest number of corners of a box.
const MOST_CORNERS: usize = 1 << MOST_SETS;

/// What the search for a point came to.
pub(super) enum Sought {
    /// A point with all gears.
    Found(Vec<f64>),
    /// There is none in the box.
    Proof,
    /// Neither.
    Open,
}

impl Solver<'_> {
    /// A point of the box where each gear is within its bounds, but for what is accepted, if a few Gauss-Newton steps from the middle lead
    /// there: first towards the middles of all bounds, then towards those that are missed.
    pub(super) fn point(&mut self, cuboid: &[[f64; 2]], functions: &[usize]) -> Sought {
        let mut k: Vec<f64> = cuboid.iter().map(|[least, most]| 0.5 * (least + most)).collect();
        for to_bounds in [false, true] {
            for _ in 0..STEPS {
                let ratios: Vec<f64> =
                    functions.iter().map(|function| self.functions[*function].ratio.value(&k)).collect();
                let within = ratios.iter().zip(&self.accepted).all(|(ratio, gear)| gear.contain(*ratio));
                if within && self.falling.iter().all(|[higher, lower]| ratios[*higher] > ratios[*lower]) {
                    return Sought::Found(k);
                }
                let misses: Vec<f64> =
                    ratios.iter().zip(&self.gears).map(|(ratio, gear)| gear.deviation(*ratio)).collect();
                let Some(step) = self.step(&k, functions, &misses, to_bounds) else { return Sought::Open };
                for ((k, step), [least, most]) in k.iter_mut().zip(step).zip(cuboid) {
                    *k = (*k + step).clamp(*least, *most);
                }
                self.equal.spread(&mut k);
            }
        }
        if self.is_ruled_out(cuboid, functions, &k) { Sought::Proof } else { Sought::Open }
    }

    /// Whether the inequalities that are missed at a point, weighted by how far, exclude each other in the whole box.
    fn is_ruled_out(&mut self, cuboid: &[[f64; 2]], functions: &[usize], k: &[f64]) -> bool {
        let mut sums = [0.0; MOST_CORNERS];
        let sums = &mut sums[..1 << cuboid.len()];
        for (gear, function) in functions.iter().enumerate() {
            let ratio = self.functions[*function].ratio;
            let below = ratio.denominator.value(k).abs();
            let deviation = self.gears[gear].deviation(ratio.numerator.value(k) / ratio.denominator.value(k));
            let excess = deviation.abs() - 1.0;
            let half = 0.5 * (self.gears[gear].most - self.gears[gear].least);
            let weight = excess / (half * below);
            if excess.is_nan() || excess <= 0.0 || !weight.is_finite() {
                continue;
            }
            self.evaluate(cuboid, *function);
            let [above, below] = &self.values;
            let sign = if below.iter().all(|value| *value > 0.0) {
                1.0
            } else if below.iter().all(|value| *value < 0.0) {
                -1.0
            } else {
                continue;
            };
            let widened = self.widened[gear];
            let (bound, side) = if deviation > 0.0 { (widened.most, sign) } else { (widened.least, -sign) };
            for (sum, (above, below)) in sums.iter_mut().zip(above.iter().zip(below)) {
                *sum += weight * side * (bound * below - above);
            }
        }
        sums.iter().all(|sum| *sum < 0.0)
    }

    /// The step that least squares of the deviations, each by half the width of its bounds, ask for; `to_bounds` of what exceeds the bounds
    /// alone.
    fn step(&self, k: &[f64], functions: &[usize], deviations: &[f64], to_bounds: bool) -> Option<Vec<f64>> {
        let sets = k.len();
        let mut normal = vec![vec![0.0; sets + 1]; sets];
        for ((function, deviation), gear) in functions.iter().zip(deviations).zip(&self.gears) {
            let to_go = if to_bounds { deviation - deviation.clamp(-1.0, 1.0) } else { *deviation };
            if to_bounds && to_go == 0.0 {
                continue;
            }
            let half = 0.5 * (gear.most - gear.least);
            let mut slopes: Vec<f64> = (0..sets).map(|set| self.slope(*function, k, set) / half).collect();
            self.equal.gather(&mut slopes);
            for row in 0..sets {
                for column in 0..sets {
                    normal[row][column] += slopes[row] * slopes[column];
                }
                normal[row][sets] -= slopes[row] * to_go;
            }
        }
        // A little damping: a `k` that moves nothing stays.
        for (set, row) in normal.iter_mut().enumerate() {
            row[set] = row[set] * (1.0 + DAMPING) + DAMPING;
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

/// Solves rows of coefficients and right side by elimination with pivots.
fn solve_linear(mut rows: Vec<Vec<f64>>) -> Option<Vec<f64>> {
    let size = rows.len();
    for column in 0..size {
        let pivot = (column..size)
            .max_by(|one, other| rows[*one][column].abs().total_cmp(&rows[*other][column].abs()))?;
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
