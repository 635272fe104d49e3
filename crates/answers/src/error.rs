//! What is refused instead of answered.

use crate::schemes::{SizeName, SizeProblem};
use crate::select::duty::DutyProblem;

/// A question without an answer.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A number of an answer that no double holds.
    #[error("not a finite number: {figure}; a given number is too small or too large for it")]
    NotFinite {
        /// Its key in the answer.
        figure: String,
    },
    /// An answer that cannot be put in its format.
    #[error("the answer cannot be written as text: {0}")]
    Json(String),
    /// More things than are written at once.
    #[error("{found} are found and at most {most} are written")]
    TooMany {
        /// How many there are.
        found: u64,
        /// How many can be written.
        most: usize,
    },
    /// A fault in a file, with its line and column.
    #[error(transparent)]
    Document(#[from] epicyclic_formats::Error),
    /// What a gear or a simple set refuses.
    #[error(transparent)]
    Gear(#[from] epicyclic_gears::Error),
    /// What a scheme or a machine refuses.
    #[error(transparent)]
    Design(#[from] epicyclic_schemes::DesignError),
    /// What the solver refuses.
    #[error(transparent)]
    Gearbox(#[from] epicyclic_train::Error),
    /// A size of a scheme.
    #[error("{size}: {problem}")]
    SchemeSize {
        /// Which.
        size: SizeName,
        /// What is wrong with it.
        problem: SizeProblem,
    },
    /// What a selection refuses.
    #[error(transparent)]
    Selection(#[from] epicyclic_selection::SelectionError),
    /// A speed or load of an input.
    #[error(transparent)]
    Duty(#[from] DutyProblem),
    /// A search for tooth numbers of two sets with one ratio.
    #[error("two sets are searched, so three speeds or two ratios are due")]
    OneSet,
    /// More designs than are told at once.
    #[error("{wanted} designs, each measured and written in full: at most {most}")]
    TooManyDesigns {
        /// How many are wanted.
        wanted: usize,
        /// How many can be told.
        most: usize,
    },
    /// Limits of a module that leave none.
    #[error("the least module, {least_mm} mm, is above the greatest, {greatest_mm} mm")]
    ModuleRange {
        /// The least.
        least_mm: f64,
        /// The greatest.
        greatest_mm: f64,
    },
    /// A throw of a bucket wheel without an angle of the chute.
    #[error("no angle of the chute: at least one is due")]
    NoChute,
}

impl Error {
    /// Whether the question is sound and only has no answer within its bounds.
    #[must_use]
    pub fn is_nothing_found(&self) -> bool {
        matches!(self, Self::Gear(epicyclic_gears::Error::NoToothNumbers { .. }))
    }
}
