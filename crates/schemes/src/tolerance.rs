//! Tolerances of this crate: differences that count as zero.
//!
//! - `IDLE`: the rolling power of a set, over the input power. An idle set has no torque at all, and rounding
//!   leaves 1e-15 of the input; the share of a working set does not vanish.
//! - `TORQUE_GRID`: torques of clutches, over the input torque. Rounding leaves 1e-15 of them, and is no
//!   reason to prefer an option.

/// A rolling power up to this share of the input power is none.
pub(crate) const IDLE: f64 = 1e-13;

/// Torques of clutches that round to the same multiple of this share of the input torque are equal.
pub(crate) const TORQUE_GRID: f64 = 1e-12;
