//! What is refused instead of answered.

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
    /// A refusal at the place in a file that it is about.
    #[error("{at}")]
    Placed {
        /// The refusal with file, line and column.
        at: Box<epicyclic_formats::Error>,
        /// The refusal itself.
        why: Box<Error>,
    },
    /// What the design of a drive refuses.
    #[error(transparent)]
    Drive(Box<epicyclic_dynamics::Error>),
    /// What a gear or a simple set refuses.
    #[error(transparent)]
    Gear(#[from] epicyclic_gears::Error),
}

impl Error {
    /// Whether the question is sound and only has no answer within its bounds.
    #[must_use]
    pub fn is_nothing_found(&self) -> bool {
        use epicyclic_gears::Error as Gear;
        match self {
            Self::Placed { why, .. } => why.is_nothing_found(),
            Self::Gear(Gear::NoToothNumbers { .. }) => true,
            Self::Drive(why) => {
                matches!(**why, epicyclic_dynamics::Error::Gear(Gear::NoToothNumbers { .. }))
            }
            _ => false,
        }
    }
}
