//! Tolerances and limits of this crate.
//!
//! Entries give the constant, the value it limits, and the reason for its size:
//! - `PIVOT`: a pivot of a matrix scaled to 1; far above its rounding, far below the ratio of any two
//!   inertias in a gearbox.
//! - `RANK`: the rest of a row that depends on others, over its largest entry; the rounding of a few products
//!   of gear ratios.
//! - `SLIP`: a relative speed, over the largest speed; the error of a step is `1e-11` of it, and slips that
//!   vanish together vanish within it.
//! - `HOLD`: the distance of a speed beyond the end of a segment, over the largest speed; the drift by
//!   rounding of a speed that is held there. The table is continued this far, so that nothing jumps.
//! - `ACCELERATION`: a relative acceleration, over the largest; the rounding of a solution of the equations
//!   of motion.
//! - `TORQUE`: a torque beyond its bound, over the largest torque; as `ACCELERATION`.
//! - `PATTERN`: the violation of an assumption about holding and slipping, if no other has less; a hundred
//!   times the rounding. At the moment of a transition two assumptions are equally right.
//! - `STEP_ERROR`: the error of a step, over the largest speed and energy; energies shall balance to `1e-9`
//!   over hundreds of steps.
//! - `ROOT`: an interval that holds an event, over the step; the place of an event within its step.
//! - `TOGETHER`: the distance of two events, over the step; events nearer than the error of a step are one.
//! - `SHORTEST`: a step, over the time that is calculated; a shorter step is not time but rounding.
//! - `AHEAD`: the time to look ahead for torques that decide a transition, over the time that is calculated.
//!   A ramp over a hundredth of the time has then changed by a hundred times `PATTERN`.
//! - `RESTARTS`: the time in which sets held by mesh friction started and stopped repeatedly, over the time
//!   that is calculated. This is no motion but a choice between two: as a block and rolling.
//! - `ACCUMULATION`: the time of the last events, over the time that is calculated. A shift has events
//!   microseconds apart; this many this near accumulate.

/// A pivot of a scaled matrix up to this has vanished.
pub(crate) const PIVOT: f64 = 1e-13;

/// Rest of a row, over its largest entry, below which the row depends on others.
pub(crate) const RANK: f64 = 1e-11;

/// A slip up to this part of the largest speed is none.
pub(crate) const SLIP: f64 = 1e-11;

/// A segment of a table over speed goes this part of the largest speed beyond its end.
pub(crate) const HOLD: f64 = 1e-13;

/// An acceleration up to this part of the largest is none.
pub(crate) const ACCELERATION: f64 = 1e-9;

/// A torque may be beyond its bound by this part of the largest.
pub(crate) const TORQUE: f64 = 1e-11;

/// Violation of an assumption, over the largest torque or acceleration, up to which the assumption may be
/// kept.
pub(crate) const PATTERN: f64 = 1e-7;

/// Error of a step over the largest speed and energy.
pub(crate) const STEP_ERROR: f64 = 1e-11;

/// Width of the bracket of an event, over the step.
pub(crate) const ROOT: f64 = 1e-13;

/// Events nearer to each other than this part of the step are one.
pub(crate) const TOGETHER: f64 = 1e-10;

/// The shortest step over the time that is calculated.
pub(crate) const SHORTEST: f64 = 1e-14;

/// Time to look ahead, over the time that is calculated.
pub(crate) const AHEAD: f64 = 1e-7;

/// Events accumulate where the last [`MOST_TOGETHER`] took less than this part of the time that is
/// calculated.
pub(crate) const ACCUMULATION: f64 = 1e-9;

/// Limit as `ACCUMULATION`, used if at least a quarter of the events are starts of sets that mesh friction
/// held.
pub(crate) const RESTARTS: f64 = 1e-2;

/// Number of events in so short a time that count as accumulating.
pub(crate) const MOST_TOGETHER: usize = 64;

/// Largest number of shift elements without slip at once: each has three ways on.
pub(crate) const MOST_AT_REST: usize = 9;

/// Largest number of lossy meshes of moving sets: each carries power in one of two directions.
pub(crate) const MOST_LOSSY_MESHES: usize = 14;

/// Most steps of one run.
pub(crate) const MOST_STEPS: usize = 5_000_000;
