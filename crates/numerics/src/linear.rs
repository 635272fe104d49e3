//! Dense linear equations: elimination with row pivoting, triangles that are kept, independent rows.
//!
//! ```text
//! A·x = b      one elimination: rows of [A | b], or of A alone with its factors kept below the diagonal
//! ```
//!
//! In each column the row with the largest entry comes to the top.
//!
//! ```
//! use epicyclic_numerics::linear::{Matrix, Triangles, solution};
//! let mut equations = Matrix::zeros(2, 3);
//! equations.row_mut(0).copy_from_slice(&[2.0, 1.0, 4.0]);
//! equations.row_mut(1).copy_from_slice(&[1.0, -1.0, -1.0]);
//! assert_eq!(solution(equations, 0.0), Some(vec![1.0, 2.0]));
//! ```

use crate::values::{dot, largest_absolute};

/// A matrix by rows.
#[derive(Debug, Clone, PartialEq)]
pub struct Matrix {
    rows: usize,
    columns: usize,
    entries: Vec<f64>,
}

impl Matrix {
    /// A matrix of zeros.
    #[must_use]
    pub fn zeros(rows: usize, columns: usize) -> Self {
        Self { rows, columns, entries: vec![0.0; rows * columns] }
    }

    /// Number of rows.
    #[inline]
    #[must_use]
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// The entries of a row.
    #[inline]
    #[must_use]
    pub fn row(&self, row: usize) -> &[f64] {
        &self.entries[row * self.columns..(row + 1) * self.columns]
    }

    /// The entries of a row, to be written.
    #[inline]
    pub fn row_mut(&mut self, row: usize) -> &mut [f64] {
        &mut self.entries[row * self.columns..(row + 1) * self.columns]
    }

    /// `A·x`, written over `out`.
    #[inline]
    pub fn times_into(&self, x: &[f64], out: &mut [f64]) {
        for (row, out) in out.iter_mut().enumerate().take(self.rows) {
            *out = dot(self.row(row), x);
        }
    }
}

/// The solution of square equations `[A | b]`, the right side in the last column.
///
/// `None` unless there is one column more than rows, and where a pivot is not a number or at most
/// `least_pivot`, which has the scale of the entries.
#[must_use]
pub fn solution(mut equations: Matrix, least_pivot: f64) -> Option<Vec<f64>> {
    let Matrix { rows, columns, .. } = equations;
    if columns != rows + 1 {
        return None;
    }
    let mut x = vec![0.0; rows];
    solve(&mut equations.entries, &mut x, least_pivot)?;
    Some(x)
}

/// Scaled [`solution`]: each equation is first divided by its largest coefficient, so that `least_pivot` is a
/// share of that coefficient.
#[must_use]
pub fn scaled_solution(mut equations: Matrix, least_pivot: f64) -> Option<Vec<f64>> {
    for row in 0..equations.rows {
        let row = equations.row_mut(row);
        let coefficients = row.len().saturating_sub(1);
        divide(row, largest_absolute(&row[..coefficients]));
    }
    solution(equations, least_pivot)
}

/// The solution of `N` equations, each with its right side last; on the stack, otherwise as [`solution`].
#[inline]
#[must_use]
pub fn fixed_solution<const N: usize, const COLUMNS: usize>(
    mut equations: [[f64; COLUMNS]; N],
    least_pivot: f64,
) -> Option<[f64; N]> {
    const { assert!(COLUMNS == N + 1, "one column more than rows, for the right side") };
    let mut x = [0.0; N];
    solve(equations.as_flattened_mut(), &mut x, least_pivot)?;
    Some(x)
}

/// Solves the rows of `[A | b]` and writes the solution to `x`.
#[inline]
fn solve(entries: &mut [f64], x: &mut [f64], least_pivot: f64) -> Option<()> {
    let columns = x.len() + 1;
    eliminate(entries, [x.len(), columns], least_pivot, |_, _| {})?;
    for (x, row) in x.iter_mut().zip(entries.chunks_exact(columns)) {
        *x = row[columns - 1];
    }
    substitute_back(entries, columns, x);
    Some(())
}

/// Splits the leading square of rows into triangles: the upper one on and above the diagonal, the
/// factors of elimination below.
///
/// `exchanged` hears of every exchange of rows; `None` where a pivot is not a number or at most
/// `least_pivot`.
#[inline]
fn eliminate(
    entries: &mut [f64],
    [rows, columns]: [usize; 2],
    least_pivot: f64,
    mut exchanged: impl FnMut(usize, usize),
) -> Option<()> {
    for k in 0..rows {
        let size = |row: usize| entries[row * columns + k].abs();
        let pivot = (k..rows).max_by(|&one, &other| size(one).total_cmp(&size(other)))?;
        if pivot != k {
            for column in 0..columns {
                entries.swap(k * columns + column, pivot * columns + column);
            }
            exchanged(k, pivot);
        }
        let (above, below) = entries.split_at_mut((k + 1) * columns);
        let above = &above[k * columns..];
        let top = above[k];
        if top.is_nan() || top.abs() <= least_pivot {
            return None;
        }
        for row in below.chunks_exact_mut(columns) {
            if row[k] != 0.0 {
                let factor = row[k] / top;
                row[k] = factor;
                for (entry, known) in row[k + 1..].iter_mut().zip(&above[k + 1..]) {
                    *entry -= factor * known;
                }
            }
        }
    }
    Some(())
}

/// Solves for a right side in `x` with the triangle above the diagonal.
#[inline]
fn substitute_back(entries: &[f64], columns: usize, x: &mut [f64]) {
    let n = x.len();
    for k in (0..n).rev() {
        let row = &entries[k * columns..][..n];
        x[k] = (x[k] - dot(&row[k + 1..], &x[k + 1..])) / row[k];
    }
}

/// A square matrix as triangles, for any number of right sides; first columns, then rows are scaled
/// to their largest entries.
#[derive(Debug, Clone)]
pub struct Triangles {
    triangles: Matrix,
    order: Vec<usize>,
    row_scale: Vec<f64>,
    column_scale: Vec<f64>,
    determinant: f64,
}

impl Triangles {
    /// Elimination with row pivoting.
    ///
    /// `None` where the matrix is not square, or a pivot of the scaled matrix is not a number or at
    /// most `least_pivot`.
    #[must_use]
    pub fn new(mut a: Matrix, least_pivot: f64) -> Option<Self> {
        let n = a.rows;
        if a.columns != n {
            return None;
        }
        let mut column_scale = vec![0.0_f64; n];
        for row in 0..n {
            for (scale, entry) in column_scale.iter_mut().zip(a.row(row)) {
                *scale = scale.max(entry.abs());
            }
        }
        let mut row_scale = vec![0.0; n];
        for (row, scale) in row_scale.iter_mut().enumerate() {
            for (entry, by) in a.row_mut(row).iter_mut().zip(&column_scale) {
                *entry /= by;
            }
            *scale = largest_absolute(a.row(row));
            divide(a.row_mut(row), *scale);
        }
        let mut order: Vec<usize> = (0..n).collect();
        let mut determinant = 1.0;
        eliminate(&mut a.entries, [n, n], least_pivot, |one, other| {
            order.swap(one, other);
            determinant = -determinant;
        })?;
        for k in 0..n {
            determinant *= a.row(k)[k] * column_scale[k] * row_scale[k];
        }
        Some(Self { triangles: a, order, row_scale, column_scale, determinant })
    }

    /// Determinant of the matrix as given.
    #[must_use]
    pub fn determinant(&self) -> f64 {
        self.determinant
    }

    /// The solution for a right side.
    #[must_use]
    pub fn solution(&self, right: &[f64]) -> Vec<f64> {
        let n = self.order.len();
        let mut x: Vec<f64> = self.order.iter().map(|&row| right[row] / self.row_scale[row]).collect();
        for k in 0..n {
            x[k] -= dot(&self.triangles.row(k)[..k], &x[..k]);
        }
        substitute_back(&self.triangles.entries, n, &mut x);
        for (x, scale) in x.iter_mut().zip(&self.column_scale) {
            *x /= scale;
        }
        x
    }
}

/// Divides a row; by 0 its entries become no numbers, and so does a pivot.
fn divide(row: &mut [f64], by: f64) {
    row.iter_mut().for_each(|entry| *entry /= by);
}

/// Rows that are independent of those before them, and how each other row is made of these.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Independent {
    /// Places of the rows kept.
    pub kept: Vec<usize>,
    /// Place of each other row, and its factors over the rows kept before it.
    pub others: Vec<(usize, Vec<f64>)>,
}

/// Splits rows into independent ones and sums of these, in the order given.
///
/// Each row is reduced by the rows kept before. A row that depends on these leaves at most
/// `rounding` of its largest entry.
#[must_use]
pub fn independent(rows: &[&[f64]], rounding: f64) -> Independent {
    let mut found = Independent::default();
    // Remainder of each kept row, its pivot, and its factors over the kept rows.
    let mut reduced: Vec<(Vec<f64>, usize, Vec<f64>)> = vec![];
    for (place, &row) in rows.iter().enumerate() {
        let size = largest_absolute(row);
        let mut rest = row.to_vec();
        let mut made = vec![0.0; reduced.len()];
        for (left, pivot, of) in &reduced {
            let factor = rest[*pivot] / left[*pivot];
            if factor != 0.0 {
                rest.iter_mut().zip(left).for_each(|(entry, known)| *entry -= factor * known);
                made.iter_mut().zip(of).for_each(|(entry, known)| *entry += factor * known);
            }
        }
        let pivot = (0..rest.len()).max_by(|&a, &b| rest[a].abs().total_cmp(&rest[b].abs()));
        match pivot {
            Some(pivot) if rest[pivot].abs() > rounding * size => {
                let mut of: Vec<f64> = made.iter().map(|factor| -factor).collect();
                of.push(1.0);
                reduced.push((rest, pivot, of));
                found.kept.push(place);
            }
            _ => found.others.push((place, made)),
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    fn matrix(rows: &[&[f64]]) -> Matrix {
        let mut made = Matrix::zeros(rows.len(), rows[0].len());
        for (place, &row) in rows.iter().enumerate() {
            made.row_mut(place).copy_from_slice(row);
        }
        made
    }

    #[test]
    fn a_system_of_three_by_hand() {
        let a = matrix(&[&[0.0, 2.0, 1.0], &[1.0, -1.0, 0.0], &[3.0, 0.0, -2.0]]);
        let triangles = Triangles::new(a.clone(), 1e-13).unwrap();
        // 0·(2) − 2·(−2) + 1·(3)
        assert!((triangles.determinant() - 7.0).abs() < 1e-14);
        let x = triangles.solution(&[1.0, 2.0, 3.0]);
        let mut back = [0.0; 3];
        a.times_into(&x, &mut back);
        assert!(back.iter().zip([1.0, 2.0, 3.0]).all(|(one, due)| (one - due).abs() < 1e-14));
    }

    #[test]
    fn a_singular_matrix_has_no_triangles() {
        assert!(Triangles::new(matrix(&[&[1.0, 2.0], &[2.0, 4.0]]), 1e-13).is_none());
        assert!(Triangles::new(matrix(&[&[1.0, 0.0], &[2.0, 0.0]]), 1e-13).is_none());
    }

    #[test]
    fn all_ways_to_the_solution_agree() {
        let rows = [[0.0, 2.0, 1.0, 1.0], [1.0, -1.0, 0.0, 2.0], [3.0, 0.0, -2.0, 3.0]];
        let equations = matrix(&rows.each_ref().map(|row| &row[..]));
        // By hand: x = y + 2, z = 1 − 2·y, 3·x − 2·z = 3.
        let due = [13.0 / 7.0, -1.0 / 7.0, 9.0 / 7.0];
        let fixed = fixed_solution(rows, 0.0).unwrap();
        assert_eq!(solution(equations.clone(), 0.0).unwrap(), fixed);
        for found in [fixed.to_vec(), scaled_solution(equations, 1e-9).unwrap()] {
            assert!(found.iter().zip(due).all(|(one, due)| (one - due).abs() < 1e-15), "{found:?}");
        }
    }

    #[test]
    fn equations_without_one_solution_have_none() {
        let twice = matrix(&[&[1.0, 2.0, 1.0], &[2.0, 4.0, 2.0]]);
        assert!(solution(twice, 0.0).is_none());
        assert!(solution(matrix(&[&[1.0, 2.0], &[3.0, 4.0]]), 0.0).is_none());
        assert!(solution(matrix(&[&[f64::NAN, 2.0]]), 0.0).is_none());
        assert!(scaled_solution(matrix(&[&[0.0, 2.0]]), 0.0).is_none());
        let small = matrix(&[&[1e-9, 1e-9]]);
        assert!(solution(small.clone(), 1e-8).is_none());
        assert_eq!(scaled_solution(small, 1e-8), Some(vec![1.0]));
        assert!(fixed_solution([[1e-9, 1e-9]], 1e-8).is_none());
    }

    #[test]
    fn a_dependent_row_is_a_sum_of_those_kept() {
        let rows: [&[f64]; 4] = [&[1.0, -1.0, 0.0], &[0.0, 1.0, -1.0], &[2.0, 1.0, -3.0], &[1.0, 0.0, 0.0]];
        let found = independent(&rows, 1e-11);
        assert_eq!(found.kept, [0, 1, 3]);
        let (place, made) = &found.others[0];
        assert_eq!(*place, 2);
        for (column, due) in rows[2].iter().enumerate() {
            let sum: f64 =
                made.iter().zip(&found.kept).map(|(factor, &row)| factor * rows[row][column]).sum();
            assert!((sum - due).abs() < 1e-15);
        }
    }
}
