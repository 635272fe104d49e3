//! Errors of selection and search.

use crate::objective::Objective;
use crate::quantity::{KRange, Limited, Rated};

/// Invalid requirements, or a search too large.
#[derive(Debug, Clone, PartialEq, thiserror::Error, strum::IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum Error {
    /// Too few or too many speeds.
    #[error("{}: gearboxes of one set have 2, of two sets 3", counted(*count, "speed"))]
    SpeedCount {
        /// How many were given.
        count: usize,
    },
    /// Too few or too many ratios for a search of two sets.
    #[error("{}: a search over the teeth of two sets wants 2", counted(*count, "ratio"))]
    RatioCount {
        /// How many there are.
        count: usize,
    },
    /// Too many ratios for a search of one set.
    #[error("{}: a search over the teeth of one set wants 1", counted(*count, "ratio"))]
    OneRatio {
        /// How many there are.
        count: usize,
    },
    /// An invalid tolerance.
    #[error("tolerance {tolerance}: at least 0 and below 1; 0.1 means ten per cent")]
    Tolerance {
        /// The value given.
        tolerance: f64,
    },
    /// Ring-to-sun ratios that do not match the sets.
    #[error("{}, of {}: one a set", counted(*given, "ring-to-sun ratio"), counted(*sets, "set"))]
    RingToSunCount {
        /// How many were given.
        given: usize,
        /// How many sets there are.
        sets: usize,
    },
    /// An invalid range of ring-to-sun ratios.
    #[error("{what} ring-to-sun ratios from {from} to {to}: above 1, finite, the smaller first")]
    RingToSunRange {
        /// Allowed or preferred.
        what: KRange,
        /// Lower end.
        from: f64,
        /// Upper end.
        to: f64,
    },
    /// An invalid limit.
    #[error("limit of {what} {value}: a number, not below 0")]
    Limit {
        /// The limited quantity.
        what: Limited,
        /// The value given.
        value: f64,
    },
    /// An invalid datum of the size.
    #[error("{what} {value}{}{unit}: finite and above 0", if unit.is_empty() { "" } else { " " })]
    Rating {
        /// The quantity of the rating.
        what: Rated,
        /// The value given.
        value: f64,
        /// Unit of the value; empty of a plain number.
        unit: &'static str,
    },
    /// A number of planets whose mesh load factor is not stated.
    #[error("{}: from 2 to {most}", counted(*planets as usize, "planet"))]
    PlanetNumber {
        /// The number given.
        planets: u32,
        /// The greatest allowed.
        most: u32,
    },
    /// An objective named twice in an order.
    #[error("the order names `{objective}` twice")]
    RepeatedObjective {
        /// The objective.
        objective: Objective,
    },
    /// An objective that a search over teeth does not compare by.
    #[error("`{objective}` is no objective of a search over teeth: it can have a limit there")]
    NoObjectiveOfTeeth {
        /// The objective.
        objective: Objective,
    },
    /// A name that no objective bears.
    #[error("no objective `{name}`: there are {}", known.join(", "))]
    UnknownObjective {
        /// The name given.
        name: String,
        /// The names there are.
        known: Vec<&'static str>,
    },
    /// Limits in millimetres without what settles millimetres.
    #[error("limits of module or ring diameter need an input torque and a load factor K")]
    SizeWithoutTorque,
    /// More combinations of tooth numbers than a search takes.
    #[error(
        "{tooth_sets} combinations of tooth numbers a set, {} pairs of them a structure: a search takes at most {most} a set; narrow the \
         ranges of teeth or of the ring-to-sun ratio",
        pairs_of(*tooth_sets)
    )]
    TooManyToothSets {
        /// Combinations of tooth numbers of a set within the bounds.
        tooth_sets: u64,
        /// The most that a search takes.
        most: u64,
    },
    /// More combinations of tooth numbers near the ratio than a search of one set takes.
    #[error(
        "{tooth_sets} combinations of tooth numbers come near the ratio: a search takes at most {most}; narrow the ranges of teeth, of \
         the ring-to-sun ratio, or the tolerance"
    )]
    TooManyNear {
        /// Combinations of tooth numbers within the bounds and near the ratio.
        tooth_sets: u64,
        /// The most that a search takes.
        most: u64,
    },
    /// More structures and ring-to-sun ratios than a search goes through.
    #[error(
        "{tooth_sets} combinations of tooth numbers a set, with {ring_to_sun_ratios} ring-to-sun ratios, in {structures} structures with their ratios: \
         ring-to-sun ratios times structures are at most {most}; narrow the ranges of teeth or of the ring-to-sun ratio, or \
         search fewer structures"
    )]
    TooManyWindows {
        /// Combinations of tooth numbers of a set within the bounds.
        tooth_sets: u64,
        /// Distinct ring-to-sun ratios among them.
        ring_to_sun_ratios: usize,
        /// Structures with an assignment of ratios.
        structures: usize,
        /// The most that a search takes.
        most: u64,
    },
    /// More pairs of ring-to-sun ratios within the windows than are tried.
    #[error(
        "{tooth_sets} combinations of tooth numbers a set, with {ring_to_sun_ratios} ring-to-sun ratios: {pairs} pairs of these come near the ratios; a \
         search tries at most {most}; narrow the ranges of teeth, of the ring-to-sun ratio, or the tolerance"
    )]
    TooManyPairs {
        /// Combinations of tooth numbers of a set within the bounds.
        tooth_sets: u64,
        /// Distinct ring-to-sun ratios among them.
        ring_to_sun_ratios: usize,
        /// Pairs to be tried.
        pairs: u64,
        /// The most that a search tries.
        most: u64,
    },
    /// A front that memory does not hold.
    #[error(
        "a front of {designs} designs: at most {most} are held; narrow the ranges of teeth or the tolerance"
    )]
    FrontTooLarge {
        /// Designs on the front, or designs required.
        designs: usize,
        /// The most held, or found among what is held.
        most: usize,
    },
    /// Stopped by the caller.
    #[error("the search was cancelled")]
    Cancelled,
    /// An error of a gear set.
    #[error(transparent)]
    GearSet(#[from] epicyclic_gears::Error),
    /// An error of the catalogue.
    #[error(transparent)]
    Scheme(#[from] epicyclic_schemes::Error),
    /// An error of the solver.
    #[error(transparent)]
    Gearbox(#[from] epicyclic_train::Error),
}

impl Error {
    /// Name of the fault, which does not change with the message: `speed-count`.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::GearSet(error) => error.name(),
            Self::Scheme(error) => error.name(),
            Self::Gearbox(error) => error.name(),
            named => named.into(),
        }
    }
}

/// Number of pairs of `count` items, `6.4e7`.
fn pairs_of(count: u64) -> String {
    // Rounded, since the exact number of pairs has up to a dozen digits that say no more.
    let count = count as f64;
    format!("{:.1e}", count * count)
}

/// `1 speed`, `4 speeds`.
fn counted(count: usize, what: &str) -> String {
    format!("{count} {what}{}", if count == 1 { "" } else { "s" })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn messages_count_and_measure() {
        let message = |error: Error| error.to_string();
        assert!(message(Error::SpeedCount { count: 1 }).starts_with("1 speed: "));
        assert!(message(Error::RatioCount { count: 1 }).starts_with("1 ratio: "));
        assert_eq!(message(Error::PlanetNumber { planets: 1, most: 8 }), "1 planet: from 2 to 8");
        let rating = Error::Rating { what: Rated::InputTorque, value: -1.0, unit: "N·m" };
        assert_eq!(message(rating), "input torque -1 N·m: finite and above 0");
        let rating = Error::Rating { what: Rated::FaceWidthRatio, value: 0.0, unit: "" };
        assert_eq!(message(rating), "face-width ratio 0: finite and above 0");
    }
}
