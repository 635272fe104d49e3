//! What counts as nothing when figures are shown.

/// A multiple below this is the zero that rounding leaves.
pub(crate) const NOTHING: f64 = 1e-12;

/// A curve whose values differ by less, over the largest, is a level line.
pub(crate) const LEVEL: f64 = 1e-9;

/// Less circulating power, over what enters, is not objected to.
pub(crate) const CIRCULATES: f64 = 1e-6;

/// A planet that turns slower on its pin, over the input's speed, does not turn.
pub(crate) const RESTS: f64 = 1e-12;

/// Ratios that differ by less, over their size, are one.
pub(crate) const SAME_RATIO: f64 = 1e-9;
