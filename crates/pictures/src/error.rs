//! Errors of pictures.

/// A picture that cannot be drawn.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A gear whose speeds do not all follow from the input's.
    #[error("gear {gear} is {state}: the speeds of {links} do not follow, and a picture of it needs all")]
    SpeedsUnknown {
        /// The gear.
        gear: String,
        /// State of the gear.
        state: String,
        /// The links.
        links: String,
    },
    /// A gear whose powers do not follow.
    #[error("gear {gear} is {state}: no power flow follows")]
    NoPower {
        /// The gear.
        gear: String,
        /// State of the gear.
        state: String,
    },
    /// No gear with a ratio.
    #[error("none of the {gears} gears of {gearbox} has a ratio; at least one must")]
    NoRatio {
        /// The gearbox.
        gearbox: String,
        /// Number of its gears.
        gears: usize,
    },
    /// No set has pitch radii: bevel gears, say.
    #[error(
        "no set of {gearbox} has pitch radii in the half-plane: heights to scale need a set of gears on parallel axes"
    )]
    NoRadii {
        /// The gearbox.
        gearbox: String,
    },
    /// A set above another one that is larger.
    #[error(
        "heights cannot be to scale: {upper} stands above {lower} in this scheme, and its gears are smaller"
    )]
    NotToScale {
        /// The lower set.
        lower: String,
        /// The upper set.
        upper: String,
    },
    /// A drawing that no file can hold: a motor of a hundred metres, say.
    #[error(transparent)]
    Drawing(#[from] epicyclic_drawing::Error),
    /// Teeth that no tool cuts.
    #[error(transparent)]
    Gear(#[from] epicyclic_gears::Error),
    /// An angle at which a motor is nowhere.
    #[error(transparent)]
    Motor(#[from] epicyclic_hydromotor::Error),
}
