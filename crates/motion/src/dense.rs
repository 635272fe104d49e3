//! Small dense matrices: elimination, determinants, independent rows.

use crate::tolerance::{PIVOT, RANK};

/// A matrix by rows.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Matrix {
    pub(crate) rows: usize,
    pub(crate) columns: usize,
    entries: Vec<f64>,
}

impl Matrix {
    pub(crate) fn zeros(rows: usize, columns: usize) -> Self {
        Self { rows, columns, entries: vec![0.0; rows * columns] }
    }

    pub(crate) fn row(&self, row: usize) -> &[f64] {
        &self.entries[row * self.columns..(row + 1) * self.columns]
    }

    pub(crate) fn row_mut(&mut self, row: usize) -> &mut [f64] {
        &mut self.entries[row * self.columns..(row + 1) * self.columns]
    }

    /// `A·x`, written over `out`.
    pub(crate) fn times_into(&self, x: &[f64], out: &mut [f64]) {
        for (row, out) in out.iter_mut().enumerate().take(self.rows) {
            *out = dot(self.row(row), x);
        }
    }

    fn swap_rows(&mut self, one: usize, other: usize) {
        if one != other {
            for column in 0..self.columns {
                self.entries.swap(one * self.columns + column, other * self.columns + column);
            }
        }
    }
}

pub(crate) fn dot(one: &[f64], other: &[f64]) -> f64 {
    one.iter().zip(other).map(|(a, b)| a * b).sum()
}

pub(crate) fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, value| most.max(value.abs()))
}

/// A square matrix split into triangles, its columns and rows scaled to their largest entries.
#[derive(Debug, Clone)]
pub(crate) struct Split {
    triangles: Matrix,
    order: Vec<usize>,
    row_scale: Vec<f64>,
    column_scale: Vec<f64>,
    /// Determinant of the matrix before scaling.
    pub(crate) determinant: f64,
}

impl Split {
    /// By elimination with row pivoting; `None` where it is not square or a pivot of the scaled matrix vanishes.
    pub(crate) fn new(mut a: Matrix) -> Option<Self> {
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
        let mut determinant = 1.0;
        for (row, scale) in row_scale.iter_mut().enumerate() {
            for (entry, by) in a.row_mut(row).iter_mut().zip(&column_scale) {
                *entry /= by;
            }
            *scale = largest(a.row(row));
            let by = *scale;
            a.row_mut(row).iter_mut().for_each(|entry| *entry /= by);
        }
        let mut order: Vec<usize> = (0..n).collect();
        for k in 0..n {
            let pivot =
                (k..n).max_by(|&one, &other| a.row(one)[k].abs().total_cmp(&a.row(other)[k].abs()))?;
            if pivot != k {
                a.swap_rows(k, pivot);
                order.swap(k, pivot);
                determinant = -determinant;
            }
            let top = a.row(k)[k];
            // Also where a scale was 0 and entries are not numbers.
            if top.is_nan() || top.abs() <= PIVOT {
                return None;
            }
            determinant *= top * column_scale[k] * row_scale[k];
            let (above, below) = a.entries.split_at_mut((k + 1) * n);
            let above = &above[k * n..];
            for row in below.chunks_exact_mut(n) {
                if row[k] != 0.0 {
                    let factor = row[k] / top;
                    row[k] = factor;
                    for (entry, known) in row[k + 1..].iter_mut().zip(&above[k + 1..]) {
                        *entry -= factor * known;
                    }
                }
            }
        }
        Some(Self { triangles: a, order, row_scale, column_scale, determinant })
    }

    /// The solution for a right side.
    pub(crate) fn solve(&self, right: &[f64]) -> Vec<f64> {
        let n = self.order.len();
        let mut x: Vec<f64> = self.order.iter().map(|&row| right[row] / self.row_scale[row]).collect();
        for k in 0..n {
            x[k] -= dot(&self.triangles.row(k)[..k], &x[..k]);
        }
        for k in (0..n).rev() {
            let row = self.triangles.row(k);
            x[k] = (x[k] - dot(&row[k + 1..], &x[k + 1..])) / row[k];
        }
        for (x, scale) in x.iter_mut().zip(&self.column_scale) {
            *x /= scale;
        }
        x
    }
}

/// Rows that are independent of those before them, and how each other row is made of these.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Independent {
    /// Places of the rows kept.
    pub(crate) kept: Vec<usize>,
    /// Of each other row its place and its factors over the rows kept before it.
    pub(crate) others: Vec<(usize, Vec<f64>)>,
}

/// Splits rows into independent ones and sums of these, in the order given.
///
/// Each row is reduced by those kept, which are held with a pivot each; what is left of one that depends on them is
/// rounding.
pub(crate) fn independent(rows: &[&[f64]]) -> Independent {
    let mut found = Independent::default();
    // What is left of each kept row, its pivot, and how it is made of the kept rows themselves.
    let mut reduced: Vec<(Vec<f64>, usize, Vec<f64>)> = vec![];
    for (place, row) in rows.iter().enumerate() {
        let size = largest(row);
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
            Some(pivot) if rest[pivot].abs() > RANK * size => {
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
        for (place, row) in rows.iter().enumerate() {
            made.row_mut(place).copy_from_slice(row);
        }
        made
    }

    #[test]
    fn a_system_of_three_by_hand() {
        let a = matrix(&[&[0.0, 2.0, 1.0], &[1.0, -1.0, 0.0], &[3.0, 0.0, -2.0]]);
        let split = Split::new(a.clone()).unwrap();
        // 0·(2) − 2·(−2) + 1·(3)
        assert!((split.determinant - 7.0).abs() < 1e-14);
        let x = split.solve(&[1.0, 2.0, 3.0]);
        let mut back = [0.0; 3];
        a.times_into(&x, &mut back);
        assert!(back.iter().zip([1.0, 2.0, 3.0]).all(|(one, due)| (one - due).abs() < 1e-14));
    }

    #[test]
    fn a_singular_matrix_has_no_split() {
        assert!(Split::new(matrix(&[&[1.0, 2.0], &[2.0, 4.0]])).is_none());
        assert!(Split::new(matrix(&[&[1.0, 0.0], &[2.0, 0.0]])).is_none());
    }

    #[test]
    fn a_dependent_row_is_a_sum_of_those_kept() {
        let rows: [&[f64]; 4] = [&[1.0, -1.0, 0.0], &[0.0, 1.0, -1.0], &[2.0, 1.0, -3.0], &[1.0, 0.0, 0.0]];
        let found = independent(&rows);
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
