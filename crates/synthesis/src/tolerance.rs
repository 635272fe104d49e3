//! Every number below which something counts as nothing, in one place.
//!
//! | constant | of | why this size |
//! |---|---|---|
//! | `WIDENING` | the bounds of a gear and of a range that is shrunk, over them | a million times the rounding of a ratio of six sets: nothing is lost by it |
//! | `ACCEPTED` | the bounds of a gear for a point that is found, over them | a box that several gears together shrink to one point at their bounds has its middle there but for a few `WIDENING` |
//! | `WITHIN` | the bounds of a gear for a solution that is judged, over them | ten times `ACCEPTED`: whatever a search finds is within |
//! | `SMALLEST` | the width of a range of `k` that is halved no more, over `k` | far above rounding, far below what teeth can realise |
//! | `DAMPING` | what least squares add for a `k` that moves nothing | it stays where it is, the others hardly move |
//! | `NO_WIDTH` | half the width of bounds, over the ratio | bounds without width still measure deviations |
//! | `NEAR` | what a deviation, by the half width of the bounds, and the end of a range, over it, lack to the outermost | below what is shown |
//! | `LAST` | the part of a line from a point within all bounds to one without, in which the last within is not sought | the ends of ranges are known to `NEAR` |
//! | `SLACK` | by how much a point may miss an inequality of a linear programme, scaled to slopes of 1 | far above the rounding of a few sums; bounds do not depend on it |
//! | `ALIKE` | the difference of two objectives | the best `k` are found to 10⁻⁴ of the deviation: below it they say nothing |
//! | `CONFIRMED` | the difference of a formula and the solver, over the ratio | both round to 1e-12 |

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
