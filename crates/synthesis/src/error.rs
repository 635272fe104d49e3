//! What may be wrong with a question.

use crate::kind::Kind;

/// Why there is no answer.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// Too few or too many sets.
    #[error("{sets} planet sets: there may be 1 to {most}")]
    Sets {
        /// How many were asked for.
        sets: usize,
        /// The most.
        most: usize,
    },
    /// Too few or too many links.
    #[error("{links} moving links for {sets} planet sets: {} structures have {least} to {most}", kind.name())]
    Links {
        /// What the class keeps.
        kind: Kind,
        /// How many sets.
        sets: usize,
        /// How many links were asked for.
        links: usize,
        /// The fewest with which a gear engages a shift element.
        least: usize,
        /// The most.
        most: usize,
    },
    /// Sets that are no structure.
    #[error("{name:?} is no structure: {why}")]
    NotAStructure {
        /// The sets as given.
        name: String,
        /// What is wrong.
        why: &'static str,
    },
    /// A wish that no gearbox of the class can have.
    #[error("{why}")]
    Wish {
        /// What is wrong with it.
        why: String,
    },
    /// Bounds of tooth numbers that nothing can keep.
    #[error(transparent)]
    Teeth(#[from] epicyclic_gears::Error),
}
