//! Numbers in messages.

/// A number for a message: without the rounding of binary fractions, 210 for 209.99999999999997.
#[must_use]
pub fn shown(value: f64) -> f64 {
    format!("{value:.11e}").parse().unwrap_or(value)
}
