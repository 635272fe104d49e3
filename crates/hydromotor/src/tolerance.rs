//! Tolerances of this crate. Lengths are in modules, angles in radians.
//!
//! Entries give the constant, the value it limits, and the reason for its size:
//! - `CLOSES`: the angle that a half-lobe of given `l` and `a` leaves open, rad; five digits of both leave as
//!   much. At a radius of 30 mm it is 0.3 µm.
//! - `WITHIN`: a distance from the end of an interval, over it; at the end itself a curve has a cusp or a
//!   jump and rounding decides.
//! - `EDGE_ANGLE`: the distance of the angle `B` from its end, over `θ₃`; the residual is smooth there, so
//!   some steps of rounding suffice.
//! - `BESIDE_JUMP`: a distance from a jump of a slope, over the piece; the slope's own error stays below the
//!   jump.
//! - `EDGE`: the part of a family's interval that is left out at either end; its ends are no motors.
//! - `BESIDE_ROOT`: the step of a secant's first two places, over the root; its error and that of rounding
//!   are both far below what the step corrects.
//! - `LAST_STEP`: the last step of Newton's method within a panel, over the half-lobe; its square is below
//!   rounding.
//! - `STEP_SLACK`: a value beyond the last of some steps, over the step; the last is met though rounding puts
//!   it beyond.
//! - `SERIES`: `√z` of the integral `A(z)`; the next term of the series is below rounding.
//! - `SLACK`: a size beyond a limit, over the limit; a size requested to the last digit is not refused by
//!   rounding.
//! - `ALONGSIDE`: the determinant of two tangents; curves along each other have no crossing.
//! - `STEP`: the last step of Newton's method, over the place; rounding makes no smaller one.
//! - `MET`: the distance of two curves at their crossing; Newton's method that has stopped elsewhere misses
//!   by more.
//! - `LEAST_ADDENDUM`: the addendum from which on a pointed tooth is searched for; no tooth is lower.
//! - `DIFFERENCE`: the step of a difference quotient, over the first parameter; about the cube root of
//!   rounding.
//! - `REACH`: the reach of a step of the fit, over the first parameter; the deviation is flat there to
//!   rounding.
//! - `BETTER`: the least fall of a deviation, over it; more than rounding.
//! - `FINER`: the least fall of a deviation in the last search round about, over it; a smaller gain is of no
//!   use in practice.
//! - `LEVEL`: a deviation above the level one, over it; above this it is the greatest.
//! - `NOISE`: a share in the exchange; the difference quotients' own noise.
//! - `EXTREME`: the growth of a chamber, over the greatest among the chambers; rounding leaves as much at an
//!   extreme.
//! - `OPEN`: the area that a port and a chamber share, over the port's; the sums of both outlines leave less.
//! - `LOWEST`: a radius; next to the axis a wall has no meaning.
//! - `INSTANT`: a stretch of rotation; a satellite that just covers a port touches its edge, so it opens and
//!   closes at once.
//! - `SINGULAR`: a pivot; equations with it have no solution.

/// Ends of intervals are left by this part of them.
pub(crate) const WITHIN: f64 = 1e-9;

/// Part of `θ₃` by which `B` lies above it at least.
pub(crate) const EDGE_ANGLE: f64 = 1e-12;

/// A slope is taken so far from its jump.
pub(crate) const BESIDE_JUMP: f64 = 1e-7;

/// Distance of the secant's start from its root, over the root.
pub(crate) const BESIDE_ROOT: f64 = 1e-5;

/// The outer points of a search lie this part of the interval within it.
pub(crate) const EDGE: f64 = 1e-6;

/// Below, `A(z)` is the start of its series.
pub(crate) const SERIES: f64 = 1e-8;

/// After a smaller step within a panel nothing is left.
pub(crate) const LAST_STEP: f64 = 1e-9;

/// The last of some steps is met that is missed by less.
pub(crate) const STEP_SLACK: f64 = 1e-9;

/// A size keeps a limit that it exceeds by less.
pub(crate) const SLACK: f64 = 1e-12;

/// Tangents with a smaller determinant are parallel.
pub(crate) const ALONGSIDE: f64 = 1e-12;

/// A smaller step ends Newton's method.
pub(crate) const STEP: f64 = 1e-13;

/// Curves that are nearer meet.
pub(crate) const MET: f64 = 1e-9;

/// The least addendum that is tried.
pub(crate) const LEAST_ADDENDUM: f64 = 1e-6;

/// The step of a difference quotient.
pub(crate) const DIFFERENCE: f64 = 1e-6;

/// A shorter reach ends the fit.
pub(crate) const REACH: f64 = 1e-10;

/// A deviation that falls by less is as before.
pub(crate) const BETTER: f64 = 1e-13;

/// A deviation that falls by less ends the search round about.
pub(crate) const FINER: f64 = 1e-6;

/// Deviations that differ by less are level.
pub(crate) const LEVEL: f64 = 1e-10;

/// A smaller share is none.
pub(crate) const NOISE: f64 = 1e-7;

/// A smaller pivot is none.
pub(crate) const SINGULAR: f64 = 1e-12;

/// A chamber that grows less is at an extreme.
pub(crate) const EXTREME: f64 = 1e-6;

/// A port that shares less with a chamber is closed to it.
pub(crate) const OPEN: f64 = 1e-10;

/// A shorter stretch of rotation is an instant.
pub(crate) const INSTANT: f64 = 1e-5;

/// A smaller radius is none.
pub(crate) const LOWEST: f64 = 1e-9;

/// A half-lobe that is open by no more, rad, closes.
pub(crate) const CLOSES: f64 = 1e-5;
