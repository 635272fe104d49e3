//! Checks of inputs, which refuse a value outside its range.

use crate::Error;

/// A finite number above 0.
pub(crate) fn positive(field: impl FnOnce() -> String, value: f64, unit: &'static str) -> Result<f64, Error> {
    if value.is_finite() && value > 0.0 {
        Ok(value)
    } else {
        Err(Error::NotPositive { field: field(), value, unit })
    }
}

/// A finite number of at least 0.
pub(crate) fn not_negative(
    field: impl FnOnce() -> String,
    value: f64,
    unit: &'static str,
) -> Result<f64, Error> {
    if value.is_finite() && value >= 0.0 {
        Ok(value)
    } else {
        Err(Error::Negative { field: field(), value, unit })
    }
}

/// A number from `low` to `high`.
pub(crate) fn within(
    field: impl FnOnce() -> String,
    value: f64,
    [low, high]: [f64; 2],
    unit: &'static str,
) -> Result<f64, Error> {
    if (low..=high).contains(&value) {
        Ok(value)
    } else {
        Err(Error::OutOfRange { field: field(), value, low, high, unit })
    }
}
