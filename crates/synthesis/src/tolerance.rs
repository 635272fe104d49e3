//! Tolerances below which a value counts as zero, in one place.
//!
//! Entries give the constant, the value it limits, and the reason for its size:
//! - `WIDENING`: the bounds of a gear and of a range that is shrunk, over them; a million times the rounding
//!   of a ratio of six sets, so nothing is lost by it.
//! - `ACCEPTED`: the bounds of a gear for a point that is found, over them. Several gears together may shrink
//!   a box to one point at their bounds; its middle is there but for a few `WIDENING`.
//! - `WITHIN`: the bounds of a gear for a solution that is judged, over them; ten times `ACCEPTED`, so
//!   whatever a search finds is within.
//! - `SMALLEST`: the width of a range of `k` that is halved no more, over `k`; far above rounding, far below
//!   what teeth can realise.
//! - `DAMPING`: the term that least squares add for a `k` that moves nothing; that `k` stays, the others
//!   hardly move.
//! - `NO_WIDTH`: half the width of bounds, over the ratio; bounds without width still measure deviations.
//! - `NEAR`: the distance to the outermost of a deviation, over the half width of the bounds, and of the end
//!   of a range, over it; below what is shown.
//! - `LAST`: the part of a line, from a point within all bounds to one without, in which the last point
//!   within is not searched for; the ends of ranges are known to `NEAR`.
//! - `SLACK`: the amount by which a point may miss an inequality of a linear programme, scaled to slopes of
//!   1; far above the rounding of a few sums; bounds do not depend on it.
//! - `ALIKE`: the difference of two objectives; the best `k` are found to 10⁻⁴ of the deviation, so a smaller
//!   difference has no meaning.
//! - `CONFIRMED`: the difference of a formula and the solver, over the ratio; both round to 1e-12.

/// See the table.
pub(crate) const WIDENING: f64 = 1e-9;
/// See the table.
pub(crate) const ACCEPTED: f64 = 1e-8;
/// See the table.
pub(crate) const WITHIN: f64 = 1e-7;
/// See the table.
pub(crate) const SMALLEST: f64 = 1e-7;
/// See the table.
pub(crate) const DAMPING: f64 = 1e-9;
/// See the table.
pub(crate) const NO_WIDTH: f64 = 1e-12;
/// See the table.
pub(crate) const CONFIRMED: f64 = 1e-9;
/// See the table.
pub(crate) const SLACK: f64 = 1e-12;
/// See the table.
pub(crate) const NEAR: f64 = 1e-6;
/// See the table.
pub(crate) const LAST: f64 = 1e-9;
/// See the table.
pub(crate) const ALIKE: f64 = 1e-5;
