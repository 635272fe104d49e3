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
    /// What a hydromotor refuses.
    #[error(transparent)]
    Motor(#[from] epicyclic_hydromotor::Error),
    /// A search that no hydromotor passes.
    #[error("no motor within the limits: {0}")]
    NoMotor(Box<crate::motor_search::Funnel>),
    /// A search whose every design has default teeth that break their limits, or none.
    #[error(
        "no motor within the limits: on none of the {designs} designs that pass do the default teeth keep their limits"
    )]
    NoTeethHold {
        /// Designs that pass otherwise.
        designs: usize,
    },
    /// A number of a design that a search has not found.
    #[error("{design}: there are designs 1 to {designs}")]
    NoSuchDesign {
        /// The number.
        design: usize,
        /// How many there are.
        designs: usize,
    },
    /// A pressure drop of a hydromotor that is not above 0.
    #[error("it is high less low pressure, so above 0; the motor runs counter-clockwise")]
    PressureDrop,
    /// A speed of a hydromotor's rotor that is not above 0.
    #[error("it must be above 0; a motor that runs backwards is its mirror image")]
    RotorSpeed,
    /// Too few or too many points of a hydromotor's centrodes.
    #[error("{points} points of a half-lobe: from 1 to {most}")]
    CentrodePoints {
        /// How many were wanted.
        points: u32,
        /// The most there can be.
        most: u32,
    },
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
            Self::Gear(Gear::NoToothNumbers { .. }) | Self::NoMotor(_) | Self::NoTeethHold { .. } => true,
            Self::Drive(why) => {
                matches!(**why, epicyclic_dynamics::Error::Gear(Gear::NoToothNumbers { .. }))
            }
            _ => false,
        }
    }
}
