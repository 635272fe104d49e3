//! Tolerances of pictures: differences that count as zero, far below the width of a line of 0.1 mm.
//!
//! - `RESTS`: a speed over the input's. Speeds are known to 1e-13 of the largest.
//! - `LEAST_SPEED`: the largest speed of a picture. The divisor must not be 0 if all links rest.
//! - `ONE_RAY`: a difference of speeds over the input's. Rays nearer to each other are one on paper.
//! - `IDLE`: a power over the one that enters, the rounding of 0.
//! - `SAME_RATIO`: a ratio over another, less 1. Ratios are printed with five digits.
//! - `CIRCULATES`: a circulating power over the one that enters. A line of its width could not be seen.
//! - `PLACE`: a difference of places on a lever, over its length. Places are ratios of a few tooth numbers.
//! - `LEVEL`: a rise of a tie, mm, or a difference of costs. Heights are steps of an iteration.
//! - `HAIR_MM`: growth of a box, mm. The box of a straight line has no width.
//! - `BALANCED`: a sum of forces over the greatest of them, the rounding of 0.
//! - `SHOWN`: a number in words, which has at most nine decimals.
//! - `EXTREME`: the growth of a chamber over the greatest. The angles of extremes are known to about its
//!   root.
//! - `CURVE`: the deviation of arcs from a curve, over its length. The points of the curve are not known
//!   better.
//! - `MARK`: a difference of numbers on an axis, over them or a step; the rounding of a power of ten and some
//!   products.
//! - `LEAST_SPAN`: the span of an axis. The divisor must not be 0.

/// Forces whose sum is less, over the greatest, balance.
pub(crate) const BALANCED: f64 = 1e-9;

/// A slower link rests.
pub(crate) const RESTS: f64 = 1e-9;

/// The scale of speeds is that of this one at least.
pub(crate) const LEAST_SPEED: f64 = 1e-9;

/// Speeds that differ by less have one ray.
pub(crate) const ONE_RAY: f64 = 1e-6;

/// Power below which a part is idle.
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
