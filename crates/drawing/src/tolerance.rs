//! Tolerances of this crate: differences that count as zero.
//!
//! - `STRAIGHT`: a bulge, `tan(sweep/4)`. The centre lies `c/(4·b)` off the chord `c`: below this bulge it
//!   has no exact place.
//! - `SMOOTH`: the tangent of the angle between two curves that are one. A spline over both leaves their
//!   common point by less than half of it, times the length of a control arm.

/// Bulge below which a side is a straight line: the arc is `b·c/2` high, and the centre too far to be exact.
pub(crate) const STRAIGHT: f64 = 1e-10;

/// Tangent of the angle at which two curves still go over into each other. Arms of control points are shorter
/// than a tooth is high, so a spline is off by nanometres.
pub(crate) const SMOOTH: f64 = 1e-6;
