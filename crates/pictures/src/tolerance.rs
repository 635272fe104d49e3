//! What counts as nothing in a picture: far below what a line of 0.1 mm shows.
//!
//! | constant | of | why this size |
//! |---|---|---|
//! | `RESTS` | a speed over the input's | speeds are known to 1e-13 of the largest |
//! | `LEAST_SPEED` | the largest speed of a picture | what divides is not 0 where all rests |
//! | `ONE_RAY` | a difference of speeds over the input's | rays nearer to each other are one on paper |
//! | `IDLE` | a power over the one that enters | what is left of 0 by rounding |
//! | `SAME_RATIO` | a ratio over another, less 1 | ratios are printed with five digits |
//! | `CIRCULATES` | a circulating power over the one that enters | a line of its width could not be seen |
//! | `PLACE` | a difference of places on a lever, over its length | places are ratios of a few tooth numbers |
//! | `LEVEL` | a rise of a tie, mm, or a difference of costs | heights are steps of an iteration |
//! | `HAIR_MM` | what a box grows by, mm | of a straight line the box has no width |
//! | `BALANCED` | a sum of forces over the greatest of them | what is left of 0 by rounding |
//! | `SHOWN` | a number in words | it has at most nine decimals |
//! | `EXTREME` | the growth of a chamber over the greatest | the angles of extremes are known to about its root |
//! | `CURVE` | the deviation of arcs from a curve, over its length | its points are not known better |
//! | `MARK` | a difference of numbers on an axis, over them or a step | the rounding of a power of ten and some products |
//! | `LEAST_SPAN` | the span of an axis | what divides is not 0 |

/// Forces whose sum is less, over the greatest, balance.
pub(crate) const BALANCED: f64 = 1e-9;

/// A slower link rests.
pub(crate) const RESTS: f64 = 1e-9;

/// The scale of speeds is that of this one at least.
pub(crate) const LEAST_SPEED: f64 = 1e-9;

/// Speeds that differ by less have one ray.
pub(crate) const ONE_RAY: f64 = 1e-6;

/// What passes less power is idle.
pub(crate) const IDLE: f64 = 1e-9;

/// Ratios that differ by less are one.
pub(crate) const SAME_RATIO: f64 = 1e-9;

/// Less circulating power is not mentioned.
pub(crate) const CIRCULATES: f64 = 1e-6;

/// Places on a lever that differ by less are one.
pub(crate) const PLACE: f64 = 1e-9;

/// Ties that rise less are level, and costs that differ by less are equal.
pub(crate) const LEVEL: f64 = 1e-6;

/// Half the width of the box around a straight line.
pub(crate) const HAIR_MM: f64 = 1e-9;

/// A smaller number is written as 0.
pub(crate) const SHOWN: f64 = 1e-6;

/// Arcs are laid no closer to a curve.
pub(crate) const CURVE: f64 = 1e-10;

/// Numbers on an axis that differ by less are one.
pub(crate) const MARK: f64 = 1e-9;

/// An axis is at least so long, in its own unit.
pub(crate) const LEAST_SPAN: f64 = 1e-9;
