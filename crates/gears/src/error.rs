//! What this crate refuses.

use crate::row::Member;

/// An input that describes no gear, or a demand that no gear meets.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A wheel without teeth.
    #[error("a tooth count of 0: a wheel has at least 1 tooth")]
    NoTeeth,
    /// A row parameter that no simple row has.
    #[error("row parameter k = {k}: k = z_b/z_a of a simple row is finite and greater than 1")]
    RowParameter {
        /// The value given.
        k: f64,
    },
    /// A stationary ratio that no row has.
    #[error("stationary ratio {i0}: it is finite and not 0")]
    StationaryRatio {
        /// The value given.
        i0: f64,
    },
    /// Input and output on one member.
    #[error("the {0} cannot be both input and output: name two different members")]
    SameMember(Member),
    /// A carrier speed or torque asked of a row whose central wheels turn alike.
    #[error("stationary ratio 1: the central wheels always turn alike and say nothing of the carrier")]
    CarrierUndetermined,
    /// A number of known speeds other than two.
    #[error("{known} of the three speeds of a row are known: exactly 2 determine the third")]
    KnownSpeeds {
        /// How many were given.
        known: usize,
    },
    /// An efficiency outside its range.
    #[error("mesh efficiency {eta}: it lies above 0 and at or below 1")]
    Efficiency {
        /// The value given.
        eta: f64,
    },
}
