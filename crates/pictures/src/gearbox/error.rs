//! What of a gearbox cannot be drawn.

use thiserror::Error;

/// What of a gearbox cannot be drawn.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum Error {
    /// A gear whose speeds do not all follow from the input's.
    #[error("gear {gear} is {state}: the speeds of {links} do not follow, and a picture of it needs all")]
    SpeedsUnknown {
        /// The gear.
        gear: String,
        /// Its state.
        state: String,
        /// The links.
        links: String,
    },
    /// A gear whose powers do not follow.
    #[error("gear {gear} is {state}: no power flow follows")]
    NoPower {
        /// The gear.
        gear: String,
        /// Its state.
        state: String,
    },
    /// No gear with a ratio.
    #[error("none of the {gears} gears of {gearbox} has a ratio; at least one must")]
    NoRatio {
        /// The gearbox.
        gearbox: String,
        /// How many gears it has.
        gears: usize,
    },
    /// What no drawing takes.
    #[error(transparent)]
    Drawing(#[from] epicyclic_drawing::Error),
}
