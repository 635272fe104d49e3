//! What selection and search refuse.

use super::objectives::Objective;

/// A demand that is none.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SelectionError {
    /// Too few or too many speeds.
    #[error("{count} speeds: gearboxes of one row have 2, of two rows 3")]
    SpeedCount {
        /// How many were given.
        count: usize,
    },
    /// Speeds that do not rise, or not all above 0.
    #[error("speed {place} is {speed} m/s after {before} m/s: speeds are finite, above 0, and rise")]
    SpeedsOutOfOrder {
        /// Its place from 1.
        place: usize,
        /// The speed, m/s.
        speed: f64,
        /// The one before, or 0, m/s.
        before: f64,
    },
    /// A range of speeds that leaves nothing to shift.
    #[error("d = {d}: the range of speeds, fastest over slowest, is finite and above 1")]
    SpeedRange {
        /// Fastest over slowest.
        d: f64,
    },
    /// A middle speed outside the range.
    #[error("q = {q} with d = {d}: fastest over middle speed lies above 1 and below d")]
    MiddleSpeed {
        /// Fastest over middle.
        q: f64,
        /// Fastest over slowest.
        d: f64,
    },
    /// Too few or too many ratios.
    #[error("{count} ratios: beside direct drive one row gives 1, two rows give 2")]
    RatioCount {
        /// How many were given.
        count: usize,
    },
    /// A ratio that no braked gear has.
    #[error("ratio {ratio}: finite and not 0, and not 1, which is direct drive")]
    Ratio {
        /// The ratio given.
        ratio: f64,
    },
    /// Two gears of one ratio.
    #[error("two gears of ratio {ratio}: three speeds have three ratios")]
    EqualRatios {
        /// Their ratio.
        ratio: f64,
    },
    /// A tolerance that is none.
    #[error("tolerance {tolerance}: at least 0 and below 1; 0.1 means ten per cent")]
    Tolerance {
        /// The value given.
        tolerance: f64,
    },
    /// A range of row parameters that is none.
    #[error("{what} row parameters from {from} to {to}: above 1, finite, the smaller first")]
    ParameterRange {
        /// Allowed or preferred.
        what: &'static str,
        /// Lower end.
        from: f64,
        /// Upper end.
        to: f64,
    },
    /// A limit that is none.
    #[error("limit of {what} {value}: a number, not below 0")]
    Limit {
        /// Of what.
        what: &'static str,
        /// The value given.
        value: f64,
    },
    /// A datum of the size that is none.
    #[error("{what} {value}: finite and above 0")]
    Rating {
        /// Which.
        what: &'static str,
        /// The value given.
        value: f64,
    },
    /// An objective named twice in an order.
    #[error("the order names `{objective}` twice")]
    RepeatedObjective {
        /// Which.
        objective: Objective,
    },
    /// A name that no objective bears.
    #[error("no objective `{name}`: there are {known}")]
    UnknownObjective {
        /// The name given.
        name: String,
        /// The names there are.
        known: String,
    },
    /// Limits in millimetres without what settles millimetres.
    #[error("limits of module or ring diameter need an input torque and a load factor K")]
    SizeWithoutTorque,
    /// Stopped by the caller.
    #[error("the search was cancelled")]
    Cancelled,
    /// What a row refuses.
    #[error(transparent)]
    Row(#[from] epicyclic_gears::Error),
    /// What the engine refuses.
    #[error(transparent)]
    Gearbox(#[from] crate::Error),
}
