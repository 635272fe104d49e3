//! Errors in the request of a search, or in its result.

use crate::kind::Kind;

/// Error of a search or of the judgement of a solution.
#[derive(Debug, Clone, PartialEq, thiserror::Error, strum::IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum Error {
    /// Too few or too many sets.
    #[error("{sets} planet sets: there may be 1 to {most}")]
    Sets {
        /// Number of sets requested.
        sets: usize,
        /// The most.
        most: usize,
    },
    /// Too few or too many links.
    #[error("{links} moving links for {sets} planet sets: {} structures have {least} to {most}", kind.name())]
    Links {
        /// Kind of structures in the class.
        kind: Kind,
        /// Number of sets.
        sets: usize,
        /// Number of links requested.
        links: usize,
        /// The fewest with which a gear engages a shift element.
        least: usize,
        /// The most.
        most: usize,
    },
    /// Sets that do not form a structure.
    #[error("{name:?} is no structure: {why}")]
    NotAStructure {
        /// The sets as given.
        name: String,
        /// Reason.
        why: &'static str,
    },
    /// A step between wanted ratios that none of them can keep.
    #[error(
        "a step between two of the ratios is {:.4} to {:.4} within their tolerances, and {} to {} is allowed",
        step[0], step[1], allowed[0], allowed[1]
    )]
    Steps {
        /// The least and the greatest that it can be.
        step: [f64; 2],
        /// The range asked for.
        allowed: [f64; 2],
    },
    /// Steps between wanted ratios that cannot fall.
    #[error(
        "a step between the ratios is at least {after:.4} and the one before it at most {before:.4}: these steps cannot fall"
    )]
    RisingSteps {
        /// The greatest that the earlier step can be.
        before: f64,
        /// The least that the later can be.
        after: f64,
    },
    /// A text that is not a share.
    #[error("{text:?} is no share: write 1/8 for the first of eight, up to 8/8")]
    Share {
        /// Text as given.
        text: String,
    },
    /// Work that was done on other structures.
    #[error("the work was done on a share of {given} structures, this one has {structures}")]
    OtherWork {
        /// Structures of the work.
        given: usize,
        /// Structures of the share.
        structures: usize,
    },
    /// A wish that no gearbox of the class can have.
    #[error("{why}")]
    Wish {
        /// Reason.
        why: String,
    },
    /// A solution that its own ratios or the solver contradict: a part of a search that was changed, or a
    /// fault of this library.
    #[error("{structure}: {why}")]
    Contradiction {
        /// The structure.
        structure: String,
        /// Contradiction in words.
        why: String,
    },
    /// Error of the solver.
    #[error(transparent)]
    Solver(#[from] epicyclic_train::Error),
    /// Bounds of tooth numbers that nothing can keep.
    #[error(transparent)]
    Teeth(#[from] epicyclic_gears::Error),
}

impl Error {
    /// The name of the fault, which does not change with its message: `rising-steps`.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Solver(error) => error.name(),
            Self::Teeth(error) => error.name(),
            error => error.into(),
        }
    }
}
