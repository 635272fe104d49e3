//! Tolerances of this crate.
//!
//! Entries give the constant, the value it limits, and the reason for its size:
//! - `ZERO_MODE`: `ω²` of a mode, over the largest `ω²`; `ω²` is found to some units of rounding of the
//!   largest one, 1e-15, and real modes are above 1e-6.
//! - `EQUAL`: the distance of two `ω²`, over them; far below the accuracy of any datum, far above rounding.
//! - `EQUAL_FLOOR`: the distance of two `ω²`, over the largest `ω²`; rounding of a small `ω²` next to a large
//!   one.
//! - `KIND`: kinetic energy of central members in a mode, over the mode's; the square of the error of a
//!   vector next to a neighbouring frequency.
//! - `ASYMMETRY`: the difference of two elements across the diagonal, over the largest element; the rounding
//!   of sums in another order.
//! - `SAME_ANGLE`: the distance of two planets, rad; rounding of an angle, as real planets are a tooth apart
//!   at least.
//! - `BALANCE`: the resultant of planets' centrifugal forces, over their sum; angles in degrees with nine
//!   digits.
//! - `RESONANT`: `|ω_r² − ω² + 2·i·ζ·ω_r·ω|`, over `ω²`; the rounding of `ω_r²`. With less the response would
//!   be rounding alone.
//! - `ROUNDING`: a computation's convergence; one unit of rounding.

/// A mode is a zero mode where its `ω²` is below this part of the largest.
pub(crate) const ZERO_MODE: f64 = 1e-12;

/// Two `ω²` are equal where they differ by less than this part of them.
pub(crate) const EQUAL: f64 = 1e-9;

/// Two `ω²` are equal where they differ by less than this part of the largest of the system.
pub(crate) const EQUAL_FLOOR: f64 = 1e-13;

/// Central members are at rest where they have less than this part of a mode's kinetic energy.
pub(crate) const KIND: f64 = 1e-12;

/// A matrix is symmetric where no pair differs by more than this part of the largest element.
pub(crate) const ASYMMETRY: f64 = 1e-12;

/// Distance below which two planets are at the same angle, rad.
pub(crate) const SAME_ANGLE: f64 = 1e-9;

/// Centrifugal forces balance where their resultant is below this part of their sum.
pub(crate) const BALANCE: f64 = 1e-9;

/// A mode that is driven this near to its frequency, with no more damping, has no response that means
/// anything.
pub(crate) const RESONANT: f64 = 1e-12;

/// Convergence of eigenvalue iterations.
pub(crate) const ROUNDING: f64 = f64::EPSILON;
