//! Tolerances of this crate: differences that count as zero.
//!
//! - `NO_FILM`: the thinnest film that is looked for, over the gap; surfaces are rougher by far.
//! - `SAME`: the last step of an iteration, over the value. It is some units of rounding, and Newton's method
//!   makes no smaller step.
//! - `EDGE`: a centre distance beyond the reach of a search, over the step. The natural centre distance and
//!   its multiples are rounded.
//! - `RIM`: the shortfall of the rim of a planet from the least one, over it. A file states a rim with 14
//!   digits.
//! - `MASS`: the excess of a mass over its limit, over the limit. The masses of shafts and discs follow from torques
//!   in two ways.
//! - `WHOLE`: difference of the shares of a duty from 1. Shares written with nine digits add up to 1.

/// A film thinner than this part of the gap of a plain bearing is none.
pub(crate) const NO_FILM: f64 = 1e-9;

/// Newton's method has ended when its step is below this share of the value.
pub(crate) const SAME: f64 = 1e-13;

/// A rim that is smaller than the least one by this share of it is not.
pub(crate) const RIM: f64 = 1e-12;

/// A mass that exceeds its limit by this share of it does not.
pub(crate) const MASS: f64 = 1e-9;

/// Shares of time that sum to 1 within this are the whole time.
pub(crate) const WHOLE: f64 = 1e-9;

/// A centre distance within this share of a step beyond the reach of a search is within it.
pub(crate) const EDGE: f64 = 1e-6;
