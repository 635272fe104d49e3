//! The number below which a cost counts as nothing.

/// Least scale of a cost by which its spread is taken: of costs that are all 0 the spread is 0 and not 0/0. Far below every
/// cost, and above the least normal number.
pub(crate) const LEAST_SCALE: f64 = 1e-300;
