//! Numbers below which something counts as nothing.

/// Part of the width of a range, or of its only end, by which a value may pass an end: rounding alone.
pub(crate) const ROUNDING: f64 = 1e-9;
