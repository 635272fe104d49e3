//! Tolerances of this crate: differences that count as zero.
//!
//! - `STRAIGHT`: a bulge, `tan(sweep/4)`. The centre lies `c/(4·b)` off the chord `c`: below this bulge it
//!   has no exact place.

/// Bulge below which a side is a straight line: the arc is `b·c/2` high, and the centre too far to be exact.
pub(crate) const STRAIGHT: f64 = 1e-10;
