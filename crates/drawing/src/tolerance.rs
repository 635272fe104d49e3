//! What counts as nothing in a drawing.
//!
//! | constant | of | why this size |
//! |---|---|---|
//! | `STRAIGHT` | a bulge, `tan(sweep/4)` | the centre lies `c/(4·b)` off the chord `c`: beyond, it has no exact place |

/// A bulge below it is a straight line: the arc is `b·c/2` high, and the centre would be too far to be exact.
pub(crate) const STRAIGHT: f64 = 1e-10;
