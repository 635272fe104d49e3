//! Tolerances of this crate: differences that count as zero.
//!
//! - `GAP`: a shortfall of a gap between planets, over the required gap; the rounding of a sine and a
//!   difference of lengths.
//! - `BALANCE`: a surplus of torque, over the driving torque. The load referred to the driving shaft is a
//!   product of ratios, which is rounded.
//! - `DIAMETER`: a shortfall of a diameter, over the diameter; the rounding of a cube root.

/// Fraction by which a gap between planets may fall short of the required one through rounding.
pub(crate) const GAP: f64 = 1e-9;

/// A surplus below this part of the driving torque is none.
pub(crate) const BALANCE: f64 = 1e-9;

/// A diameter is thick enough where it falls short by less than this fraction.
pub(crate) const DIAMETER: f64 = 1e-12;
