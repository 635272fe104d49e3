//! Products, largest sizes, the larger and the smaller of two numbers.

use std::borrow::Borrow;

/// `Σ aᵢ·bᵢ`.
#[inline]
#[must_use]
pub fn dot(one: &[f64], other: &[f64]) -> f64 {
    one.iter().zip(other).map(|(a, b)| a * b).sum()
}

/// The largest absolute value; 0 of none, and what is no number does not count.
#[inline]
#[must_use]
pub fn largest_absolute(values: impl IntoIterator<Item = impl Borrow<f64>>) -> f64 {
    values.into_iter().fold(0.0, |most: f64, value| most.max(value.borrow().abs()))
}

/// The larger of two numbers, in one instruction; the second where either is no number.
#[inline]
#[must_use]
pub fn larger(one: f64, other: f64) -> f64 {
    if one > other { one } else { other }
}

/// The smaller of two numbers, in one instruction; the second where either is no number.
#[inline]
#[must_use]
pub fn smaller(one: f64, other: f64) -> f64 {
    if one < other { one } else { other }
}
