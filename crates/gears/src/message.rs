//! Numbers in messages.

/// A number for a message: without the rounding of binary fractions, 210 for 209.99999999999997.
#[must_use]
pub fn shown(value: f64) -> f64 {
    format!("{value:.11e}").parse().unwrap_or(value)
}

/// A number for a message with its unit, if it has one.
#[must_use]
pub fn with_unit(value: f64, unit: &str) -> String {
    let value = shown(value);
    if unit.is_empty() { value.to_string() } else { format!("{value} {unit}") }
}
