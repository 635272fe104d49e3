//! Kinds of planet bearings to choose from.

use epicyclic_gears::life::Rolling;
use epicyclic_strength::sizing::bearing::{Bearing, listed, listed_plain, listed_rollers};
use epicyclic_strength::sizing::in_bore;

/// Kinds of planet bearings.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum BearingType {
    /// Deep groove ball bearings of the series 60, 62, 63.
    Balls,
    /// Cylindrical roller bearings of the series NJ 2, NJ 22, NJ 3, NJ 23.
    Rollers,
    /// Cylindrical rollers in a cage, in the bore of the planet, rated by their dimensions.
    RollersInBore,
    /// Needles in a cage, in the bore of the planet.
    Needles,
    /// Cylindrical rollers without a cage, in the bore of the planet.
    FullComplement,
    /// Plain bearings as wide as the planet, of 7 N/mm² at most; their oil film is judged.
    Plain,
}

impl BearingType {
    /// Kinds of bearings where none are asked for.
    pub(crate) const USUAL: [Self; 2] = [Self::Balls, Self::Rollers];

    pub(crate) fn listed(self) -> &'static [Bearing] {
        match self {
            Self::Balls => listed(),
            Self::Rollers => listed_rollers(),
            Self::RollersInBore => in_bore::listed(Rolling::Rollers),
            Self::Needles => in_bore::listed(Rolling::Needles),
            Self::FullComplement => in_bore::listed(Rolling::FullComplement),
            Self::Plain => listed_plain(),
        }
    }
}
