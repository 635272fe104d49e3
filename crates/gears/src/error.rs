//! What this crate refuses.

use crate::row::{Member, Mode};

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
    /// A range of teeth that holds no wheel.
    #[error("{wheel} teeth from {from} to {to}: write the smaller first, and at most {most}")]
    ToothRange {
        /// The wheel concerned.
        wheel: &'static str,
        /// Lower end.
        from: u32,
        /// Upper end.
        to: u32,
        /// The greatest count allowed.
        most: u32,
    },
    /// A number of planets that the synthesis does not place.
    #[error("{from} to {to} planets: from 2 to {most}, the smaller first")]
    PlanetNumber {
        /// Lower end.
        from: u32,
        /// Upper end.
        to: u32,
        /// The greatest number allowed.
        most: u32,
    },
    /// A range of row parameters that holds no simple row.
    #[error("row parameter from {from} to {to}: above 1, finite, the smaller first")]
    RowParameterRange {
        /// Lower end.
        from: f64,
        /// Upper end.
        to: f64,
    },
    /// A quantity that may not be negative.
    #[error("{name} {value}: it is finite and not negative")]
    Negative {
        /// What it is.
        name: &'static str,
        /// The value given.
        value: f64,
    },
    /// A tolerance that is none.
    #[error("tolerance {tolerance}: it is finite and not negative; 0.01 means one per cent")]
    Tolerance {
        /// The value given.
        tolerance: f64,
    },
    /// A ratio of speeds that is none.
    #[error("ratio {ratio}: it is finite and not 0")]
    Ratio {
        /// The value given.
        ratio: f64,
    },
    /// A ratio that no tooth set within the bounds reaches.
    #[error(
        "no tooth set within the bounds has the ratio {wanted} ({mode}) within {}%{}",
        tolerance * 100.0,
        nearest.map_or(String::from("; none assembles at all: widen the bounds"),
            |ratio| format!("; the nearest is {ratio:.4}: widen the bounds or the tolerance"))
    )]
    NoToothSet {
        /// The ratio wanted.
        wanted: f64,
        /// The mode of the row.
        mode: Mode,
        /// The relative tolerance.
        tolerance: f64,
        /// The nearest ratio within the bounds, where there is any tooth set.
        nearest: Option<f64>,
    },
}
