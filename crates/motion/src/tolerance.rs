//! What counts as nothing in this crate.
//!
//! | constant | of | why this size |
//! |---|---|---|
//! | `PIVOT` | a pivot of a matrix scaled to 1 | far above its rounding, far below the ratio of any two inertias that a gearbox has |
//! | `RANK` | what is left of a row that depends on others, over its largest entry | the rounding of a few products of gear ratios |
//! | `SLIP` | a relative speed, over the largest speed | the error of a step is `1e-11` of it; slips that vanish together vanish within it |
//! | `HOLD` | how far a speed is beyond the end of a segment, over the largest speed | the drift by rounding of a speed that is held there; the table is continued this far, so that nothing jumps |
//! | `ACCELERATION` | a relative acceleration, over the largest | the rounding of a solution of the equations of motion |
//! | `TORQUE` | a torque beyond its bound, over the largest torque | as `ACCELERATION` |
//! | `PATTERN` | how far an assumption about what holds and slips may be contradicted, if no other is contradicted less | a hundred times the rounding: at the moment of a transition two assumptions are equally right |
//! | `STEP_ERROR` | the error of a step, over the largest speed and energy | energies shall balance to `1e-9` over hundreds of steps |
//! | `ROOT` | an interval that holds an event, over the step | the place of an event within its step |
//! | `TOGETHER` | the distance of two events, over the step | events nearer than the error of a step are one |
//! | `SHORTEST` | a step, over the time that is calculated | what is shorter is not time but rounding |
//! | `AHEAD` | how far torques are looked at ahead of a transition that they do not tell yet, over the time that is calculated | a ramp over a hundredth of the time has changed by a hundred times `PATTERN` |
//! | `RESTARTS` | the time in which sets that mesh friction held started and stopped again and again, over the time that is calculated | it is no motion but a choice between two: as a block and rolling |
//! | `ACCUMULATION` | the time that the last events took, over the time that is calculated | a shift has events microseconds apart; so many so near accumulate |

/// A pivot of a scaled matrix up to this has vanished.
pub(crate) const PIVOT: f64 = 1e-13;

/// A row of which less than this part is left depends on others.
pub(crate) const RANK: f64 = 1e-11;

/// A slip up to this part of the largest speed is none.
pub(crate) const SLIP: f64 = 1e-11;

/// A segment of a table over speed goes this part of the largest speed beyond its end.
pub(crate) const HOLD: f64 = 1e-13;

/// An acceleration up to this part of the largest is none.
pub(crate) const ACCELERATION: f64 = 1e-9;

/// A torque may be beyond its bound by this part of the largest.
pub(crate) const TORQUE: f64 = 1e-11;

/// An assumption contradicted by no more than this part of the largest torque or acceleration may stand.
pub(crate) const PATTERN: f64 = 1e-7;

/// Error of a step over the largest speed and energy.
pub(crate) const STEP_ERROR: f64 = 1e-11;

/// Width of the bracket of an event, over the step.
pub(crate) const ROOT: f64 = 1e-13;

/// Events nearer to each other than this part of the step are one.
pub(crate) const TOGETHER: f64 = 1e-10;

/// The shortest step over the time that is calculated.
pub(crate) const SHORTEST: f64 = 1e-14;

/// It is looked ahead by this part of the time that is calculated.
pub(crate) const AHEAD: f64 = 1e-7;

/// Events accumulate where the last [`MOST_TOGETHER`] took less than this part of the time that is
/// calculated.
pub(crate) const ACCUMULATION: f64 = 1e-9;

/// The same where at least a quarter of them are starts of sets that mesh friction held.
pub(crate) const RESTARTS: f64 = 1e-2;

/// How many events in so short a time accumulate.
pub(crate) const MOST_TOGETHER: usize = 64;

/// How many shift elements may be without slip at once: each has three ways on.
pub(crate) const MOST_AT_REST: usize = 9;

/// How many lossy meshes of moving sets there may be: each carries power in one of two directions.
pub(crate) const MOST_LOSSY_MESHES: usize = 14;

/// Most steps of one run.
pub(crate) const MOST_STEPS: usize = 5_000_000;
