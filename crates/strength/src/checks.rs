//! Checks of inputs, which refuse a value outside its range.

use crate::{Error, Quantity, tolerance};

/// A finite number above 0.
pub(crate) fn positive(quantity: Quantity, value: f64, unit: &'static str) -> Result<f64, Error> {
    if value.is_finite() && value > 0.0 {
        Ok(value)
    } else {
        Err(Error::NotPositive { quantity, value, unit })
    }
}

/// A finite number of at least 0.
pub(crate) fn not_negative(quantity: Quantity, value: f64, unit: &'static str) -> Result<f64, Error> {
    if value.is_finite() && value >= 0.0 { Ok(value) } else { Err(Error::Negative { quantity, value, unit }) }
}

/// A number from `low` to `high`.
pub(crate) fn within(
    quantity: Quantity,
    value: f64,
    [low, high]: [f64; 2],
    unit: &'static str,
) -> Result<f64, Error> {
    if (low..=high).contains(&value) {
        Ok(value)
    } else {
        Err(Error::OutOfRange { quantity, value, low, high, unit })
    }
}

/// Refuses shares of time whose sum is not 1.
pub(crate) fn whole(sum: f64) -> Result<(), Error> {
    if (sum - 1.0).abs() <= tolerance::WHOLE { Ok(()) } else { Err(Error::Shares { sum }) }
}
