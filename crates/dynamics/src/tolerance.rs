//! What counts as nothing in this crate.
//!
//! | constant | of | why this size |
//! |---|---|---|
//! | `GAP` | a shortfall of a gap between planets, over the gap wanted | the rounding of a sine and a difference of lengths |
//! | `BALANCE` | a surplus of torque, over the driving torque | the rounding of the reduced load, which is a product of ratios |
//! | `DIAMETER` | a shortfall of a diameter, over it | the rounding of a cube root |

/// A gap is as wide as wanted where it falls short by less than this fraction.
pub(crate) const GAP: f64 = 1e-9;

/// A surplus below this part of the driving torque is none.
pub(crate) const BALANCE: f64 = 1e-9;

/// A diameter is thick enough where it falls short by less than this fraction.
pub(crate) const DIAMETER: f64 = 1e-12;
