//! Modes of `M·q̈ + K·q = 0` by Cholesky reduction.
//!
//! With `M = L·Lᵀ` and `q = L⁻ᵀ·y` the problem `K·φ = ω²·M·φ` is `A·y = ω²·y` of the symmetric matrix
//! `A = L⁻¹·K·L⁻ᵀ`. Its orthonormal eigenvectors give mass-normalised modes: `φᵀ·M·φ = 1` and `φᵀ·K·φ = ω²`.
//!
//! The residual of a mode is `|A·y − ω²·y|/ω²_max`. Eigenvalues below `1e-12·ω²_max` in size are zero modes;
//! further below zero the stiffness is no stiffness and is refused.

use crate::{Error, tolerance};
use nalgebra::{Cholesky, ComplexField, DMatrix, DVector, SymmetricEigen};
use std::ops::Range;

/// Iterations of an eigenvalue problem for each row of its matrix; two to three are usual.
const ITERATIONS_PER_ROW: usize = 200;

/// Modes in ascending order of `ω²`.
#[derive(Debug, Clone)]
pub(crate) struct Eigen {
    /// `ω²`, rad²/s²; exactly 0 of zero modes.
    pub(crate) omega2: Vec<f64>,
    /// Mass-normalised modes as columns.
    pub(crate) vectors: DMatrix<f64>,
    /// Residual of each.
    pub(crate) residuals: Vec<f64>,
}

/// Eigenvalues in ascending order and the orthonormal eigenvectors of a Hermitian matrix.
pub(crate) fn hermitian<T: ComplexField<RealField = f64>>(
    matrix: DMatrix<T>,
) -> Result<(Vec<f64>, DMatrix<T>), Error> {
    let size = matrix.nrows();
    let iterations = ITERATIONS_PER_ROW * size;
    let eigen = SymmetricEigen::try_new(matrix, tolerance::ROUNDING, iterations)
        .ok_or(Error::NotConverged { size, iterations })?;
    let mut order: Vec<usize> = (0..size).collect();
    order.sort_by(|a, b| eigen.eigenvalues[*a].total_cmp(&eigen.eigenvalues[*b]));
    let values = order.iter().map(|&index| eigen.eigenvalues[index]).collect();
    Ok((values, eigen.eigenvectors.select_columns(&order)))
}

/// Modes of a stiffness and a mass matrix.
pub(crate) fn solve(stiffness: &DMatrix<f64>, mass: &DMatrix<f64>) -> Result<Eigen, Error> {
    let (stiffness_size, mass_size) = (stiffness.shape(), mass.shape());
    if stiffness_size != mass_size || stiffness.nrows() != stiffness.ncols() {
        return Err(Error::Sizes { stiffness: stiffness_size.into(), mass: mass_size.into() });
    }
    if stiffness.is_empty() {
        return Err(Error::NothingMoves);
    }
    symmetric("stiffness", stiffness)?;
    symmetric("mass", mass)?;
    let lower = Cholesky::new(mass.clone()).ok_or(Error::MassNotPositive)?.unpack();
    let reduced = reduced(stiffness, &lower).ok_or(Error::MassNotPositive)?;
    let (mut omega2, y) = hermitian(reduced.clone())?;
    let largest = omega2.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    let mut defect = reduced * &y;
    for ((mut column, vector), value) in defect.column_iter_mut().zip(y.column_iter()).zip(&omega2) {
        column.axpy(-value, &vector, 1.0);
    }
    let scale = if largest > 0.0 { largest } else { 1.0 };
    let residuals = defect.column_iter().map(|column| column.norm() / scale).collect();
    if omega2[0] < -tolerance::ZERO_MODE * largest {
        return Err(Error::StiffnessNegative { least: omega2[0] / largest });
    }
    for value in &mut omega2 {
        if *value <= tolerance::ZERO_MODE * largest {
            *value = 0.0;
        }
    }
    let vectors = lower.tr_solve_lower_triangular(&y).ok_or(Error::MassNotPositive)?;
    Ok(Eigen { omega2, vectors, residuals })
}

/// `L⁻¹·K·L⁻ᵀ`; none where `L` is singular.
fn reduced(stiffness: &DMatrix<f64>, lower: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    let half = lower.solve_lower_triangular(stiffness)?;
    let whole = lower.solve_lower_triangular(&half.transpose())?;
    // Rounding alone makes the two triangles differ.
    Some((&whole + whole.transpose()) * 0.5)
}

/// Refuses a matrix that is not finite and symmetric.
pub(crate) fn symmetric(name: &'static str, matrix: &DMatrix<f64>) -> Result<(), Error> {
    let allowed = tolerance::ASYMMETRY * matrix.amax();
    for row in 0..matrix.nrows() {
        for column in 0..=row {
            let [value, across] = [matrix[(row, column)], matrix[(column, row)]];
            if !value.is_finite() || !across.is_finite() || (value - across).abs() > allowed {
                return Err(Error::NotSymmetric { matrix: name, row, column, value, across });
            }
        }
    }
    Ok(())
}

/// Ranges of equal values among ascending ones: of `ω²`, within rounding.
pub(crate) fn groups(omega2: &[f64]) -> Vec<Range<usize>> {
    let largest = omega2.last().copied().unwrap_or(0.0);
    let mut groups: Vec<Range<usize>> = Vec::new();
    for (index, value) in omega2.iter().enumerate() {
        match groups.last_mut() {
            Some(last) if equal(omega2[index - 1], *value, largest) => last.end = index + 1,
            _ => groups.push(index..index + 1),
        }
    }
    groups
}

fn equal(below: f64, above: f64, largest: f64) -> bool {
    above - below <= (tolerance::EQUAL * above).max(tolerance::EQUAL_FLOOR * largest)
}

/// Matrix `Σ w_i·d_i·d_iᵀ` of the `rows`, pairs of a weight `w_i` and a vector `d_i`.
pub(crate) fn gram(dimension: usize, rows: impl Iterator<Item = (f64, Vec<f64>)>) -> DMatrix<f64> {
    let mut sum = DMatrix::zeros(dimension, dimension);
    for (weight, row) in rows {
        let row = DVector::from_vec(row);
        sum.ger(weight, &row, &row, 1.0);
    }
    sum
}
