//! The larger and the smaller of two numbers.

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
