//! Linear programmes of a few variables, each between −1 and 1, with bounds that hold whatever the rounding.
//!
//! The dual simplex method finds the greatest `c·x` with `x` in the cube and `b_i + a_i·x ≥ 0`. It starts at
//! the cube's corner with the greatest `c·x`. Any weights `λ_i ≥ 0` bound it:
//!
//! ```text
//! c·x ≤ Σ λ_i·b_i + Σ_j |c_j + Σ_i λ_i·a_ij|
//! ```
//!
//! The method gives the weights with which this is least. The bound is calculated from them and the rows as
//! given, so an error of the method can only make it wider. A bound below every `c·x` of the cube proves that
//! no point exists.

use crate::tolerance::SLACK;

/// The most variables: the ring-to-sun ratios of six sets, and one more.
pub(crate) const MOST: usize = 7;

/// Largest number of steps of the method. It needs a step or two for each variable; a bound follows wherever
/// it stops.
const STEPS: usize = 48;

/// An inequality `b + a·x ≥ 0`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Row {
    /// `a`.
    pub(crate) slopes: [f64; MOST],
    /// `b`.
    pub(crate) constant: f64,
}

impl Row {
    fn at(&self, point: &[f64; MOST]) -> f64 {
        self.slopes.iter().zip(point).fold(self.constant, |sum, (slope, x)| sum + slope * x)
    }
}

/// Result of a linear programme.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Optimum {
    /// Proved: no point of the cube keeps all inequalities.
    None,
    /// No point has more.
    Most {
        /// The bound.
        bound: f64,
        /// Point of the bound, up to rounding.
        point: [f64; MOST],
    },
}

/// A variable or the slack of a row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Quantity {
    Variable(usize),
    Slack(usize),
}

/// Room for the calculations, used again.
#[derive(Debug, Default)]
pub(crate) struct Programme {
    /// The quantities of the rows as sums over the others.
    table: Vec<Row>,
    of_row: Vec<Quantity>,
    weights: Vec<f64>,
}

impl Programme {
    /// Finds the greatest `objective·x` over the first `variables` variables; the others are 0.
    pub(crate) fn most(&mut self, rows: &[Row], objective: &[f64; MOST], variables: usize) -> Optimum {
        self.table.clear();
        self.table.extend_from_slice(rows);
        self.of_row.clear();
        self.of_row.extend((0..rows.len()).map(Quantity::Slack));
        let mut of_column: [Quantity; MOST] = std::array::from_fn(Quantity::Variable);
        // The sum to be made great, over the columns' quantities, and where these stand.
        let mut sum = Row { slopes: *objective, constant: 0.0 };
        let mut stand: [f64; MOST] = std::array::from_fn(|column| {
            if column >= variables {
                0.0
            } else if objective[column] < 0.0 {
                -1.0
            } else {
                1.0
            }
        });
        for _ in 0..STEPS {
            let Some((row, rises)) = self.most_violated(&stand) else { break };
            let Some(column) = leaving(&self.table[row], &sum, &of_column[..variables], &stand, rises) else {
                return if self.proves_none(rows, row, rises, &of_column[..variables]) {
                    Optimum::None
                } else {
                    self.bounded(rows, objective, &sum, &of_column[..variables], &stand)
                };
            };
            let turned = self.turned(row, column);
            for other in (0..self.table.len()).filter(|other| *other != row) {
                replace(&mut self.table[other], column, &turned);
            }
            replace(&mut sum, column, &turned);
            self.table[row] = turned;
            std::mem::swap(&mut self.of_row[row], &mut of_column[column]);
            stand[column] = match of_column[column] {
                Quantity::Slack(_) => 0.0,
                Quantity::Variable(_) if rises => -1.0,
                Quantity::Variable(_) => 1.0,
            };
        }
        self.bounded(rows, objective, &sum, &of_column[..variables], &stand)
    }

    /// The row whose quantity is farthest outside its bounds, and whether it has to rise.
    fn most_violated(&self, stand: &[f64; MOST]) -> Option<(usize, bool)> {
        let mut most = (SLACK, None);
        for (place, (row, quantity)) in self.table.iter().zip(&self.of_row).enumerate() {
            let value = row.at(stand);
            let (by, rises) = match quantity {
                Quantity::Slack(_) => (-value, true),
                Quantity::Variable(_) => (value.abs() - 1.0, value < 0.0),
            };
            if by > most.0 {
                most = (by, Some((place, rises)));
            }
        }
        most.1
    }

    /// A row solved for the quantity of a column.
    fn turned(&self, row: usize, column: usize) -> Row {
        let Row { mut slopes, mut constant } = self.table[row];
        let pivot = slopes[column];
        slopes[column] = -1.0;
        slopes.iter_mut().for_each(|slope| *slope /= -pivot);
        constant /= -pivot;
        Row { slopes, constant }
    }

    /// Whether the quantity of a row cannot come within its bounds, by weights on the rows as given.
    fn proves_none(&mut self, rows: &[Row], row: usize, rises: bool, of_column: &[Quantity]) -> bool {
        let side = if rises { 1.0 } else { -1.0 };
        self.weights.clear();
        self.weights.resize(rows.len(), 0.0);
        for (quantity, slope) in of_column.iter().zip(self.table[row].slopes) {
            if let Quantity::Slack(slack) = quantity {
                self.weights[*slack] = (-side * slope).max(0.0);
            }
        }
        let mut objective = [0.0; MOST];
        let least = match self.of_row[row] {
            Quantity::Slack(slack) => {
                self.weights[slack] = 1.0;
                0.0
            }
            Quantity::Variable(variable) => {
                objective[variable] = side;
                -1.0
            }
        };
        self.bound(rows, &objective) < least - SLACK
    }

    /// The bound by the weights that the method came to, and the point.
    fn bounded(
        &mut self,
        rows: &[Row],
        objective: &[f64; MOST],
        sum: &Row,
        of_column: &[Quantity],
        stand: &[f64; MOST],
    ) -> Optimum {
        self.weights.clear();
        self.weights.resize(rows.len(), 0.0);
        let mut point = [0.0; MOST];
        for ((quantity, slope), stand) in of_column.iter().zip(sum.slopes).zip(stand) {
            match quantity {
                Quantity::Slack(slack) => self.weights[*slack] = (-slope).max(0.0),
                Quantity::Variable(variable) => point[*variable] = *stand,
            }
        }
        for (row, quantity) in self.table.iter().zip(&self.of_row) {
            if let Quantity::Variable(variable) = quantity {
                point[*variable] = row.at(stand).clamp(-1.0, 1.0);
            }
        }
        Optimum::Most { bound: self.bound(rows, objective), point }
    }

    /// Upper bound of `objective·x`, from the weights.
    fn bound(&self, rows: &[Row], objective: &[f64; MOST]) -> f64 {
        let mut slopes = *objective;
        let mut bound = 0.0;
        for (row, weight) in rows.iter().zip(&self.weights).filter(|(_, weight)| **weight > 0.0) {
            bound += weight * row.constant;
            slopes.iter_mut().zip(row.slopes).for_each(|(sum, slope)| *sum += weight * slope);
        }
        slopes.iter().fold(bound, |bound, slope| bound + slope.abs())
    }

    /// The weights of the rows in the last bound.
    pub(crate) fn weights(&self) -> &[f64] {
        &self.weights
    }
}

/// The column whose quantity takes the row's place among the sums: the first whose worth changes its sign.
fn leaving(row: &Row, sum: &Row, of_column: &[Quantity], stand: &[f64; MOST], rises: bool) -> Option<usize> {
    let mut least = (f64::INFINITY, None);
    for (column, quantity) in of_column.iter().enumerate() {
        let slope = if rises { row.slopes[column] } else { -row.slopes[column] };
        let can_rise = matches!(quantity, Quantity::Slack(_)) || stand[column] < 0.0;
        if slope.abs() > SLACK && (slope > 0.0) == can_rise {
            let ratio = (sum.slopes[column] / slope).abs();
            if ratio < least.0 {
                least = (ratio, Some(column));
            }
        }
    }
    least.1
}

/// Puts a quantity's sum in its place in another.
fn replace(row: &mut Row, column: usize, by: &Row) {
    let factor = row.slopes[column];
    if factor != 0.0 {
        row.slopes[column] = 0.0;
        row.slopes.iter_mut().zip(by.slopes).for_each(|(slope, by)| *slope += factor * by);
        row.constant += factor * by.constant;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(slopes: &[f64], constant: f64) -> Row {
        let mut row = Row { constant, ..Row::default() };
        row.slopes[..slopes.len()].copy_from_slice(slopes);
        row
    }

    fn most(rows: &[Row], objective: &[f64]) -> Optimum {
        let objective_row = row(objective, 0.0);
        Programme::default().most(rows, &objective_row.slopes, objective.len())
    }

    #[test]
    fn a_corner_cut_off_is_not_reached() {
        // x + y ≤ 1
        let Optimum::Most { bound, point } = most(&[row(&[-1.0, -1.0], 1.0)], &[2.0, 1.0]) else {
            unreachable!("the middle is a point")
        };
        assert!((bound - 2.0).abs() < 1e-12, "{bound}");
        assert!((2.0 * point[0] + point[1] - 2.0).abs() < 1e-12, "{point:?}");
    }

    #[test]
    fn what_contradicts_itself_has_no_point() {
        // x + y ≥ 1.5 and x ≤ 0.25 within the square.
        let rows = [row(&[1.0, 1.0], -1.5), row(&[-1.0, 0.0], 0.25)];
        assert_eq!(most(&rows, &[0.0, 1.0]), Optimum::None);
    }

    /// Greatest value by trial of all intersections of as many planes as variables, independent of the
    /// method.
    fn by_trial(rows: &[Row], objective: &[f64; 3]) -> Option<f64> {
        let mut planes = rows.to_vec();
        for variable in 0..3 {
            for side in [-1.0, 1.0] {
                let mut slopes = [0.0; 3];
                slopes[variable] = side;
                planes.push(row(&slopes, 1.0));
            }
        }
        let mut most: Option<f64> = None;
        for one in 0..planes.len() {
            for two in 0..one {
                for three in 0..two {
                    let [a, b, c] = [one, two, three].map(|place| planes[place].slopes);
                    let right = [one, two, three].map(|place| -planes[place].constant);
                    let cross = |a: [f64; MOST], b: [f64; MOST]| {
                        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
                    };
                    let (bc, ca, ab) = (cross(b, c), cross(c, a), cross(a, b));
                    let determinant = a[0] * bc[0] + a[1] * bc[1] + a[2] * bc[2];
                    if determinant.abs() < 1e-9 {
                        continue;
                    }
                    let mut point = [0.0; MOST];
                    for axis in 0..3 {
                        point[axis] =
                            (right[0] * bc[axis] + right[1] * ca[axis] + right[2] * ab[axis]) / determinant;
                    }
                    if planes.iter().all(|plane| plane.at(&point) > -1e-9) {
                        let value = (0..3).map(|axis| objective[axis] * point[axis]).sum::<f64>();
                        most = Some(most.map_or(value, |most| most.max(value)));
                    }
                }
            }
        }
        most
    }

    #[test]
    fn bounds_are_the_greatest_of_all_corners() {
        let mut state = 0x2545_f491_4f6c_dd1du64;
        let mut random = || {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            (state >> 11) as f64 / (1u64 << 52) as f64 - 1.0
        };
        let mut none = 0;
        for _ in 0..2000 {
            let rows: Vec<Row> =
                (0..7).map(|_| row(&[random(), random(), random()], 0.5 * random() + 0.3)).collect();
            let objective = [random(), random(), random()];
            match (most(&rows, &objective), by_trial(&rows, &objective)) {
                (Optimum::None, None) => none += 1,
                (Optimum::Most { bound, point }, Some(most)) => {
                    assert!((bound - most).abs() < 1e-9, "{bound} for {most}");
                    let value: f64 = objective.iter().zip(point).map(|(one, other)| one * other).sum();
                    assert!((value - most).abs() < 1e-9, "{value} for {most}");
                }
                (one, other) => unreachable!("{one:?} for {other:?}"),
            }
        }
        assert!((100..1900).contains(&none), "{none}");
    }
}
