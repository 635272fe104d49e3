//! Transmissions of a file from which none was chosen.

use crate::answer::Answer;
use epicyclic_formats::gearbox;
use schemars::JsonSchema;
use serde::Serialize;

/// Published transmissions to choose from.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Transmissions {
    /// Transmissions in the order of the file.
    pub transmissions: Vec<Transmission>,
}

/// Transmission with the numbers of its parts.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Transmission {
    /// Name of the transmission.
    pub name: String,
    /// Number of planetary sets.
    pub sets: usize,
    /// Number of brakes and clutches, including one-way clutches.
    pub shift_elements: usize,
    /// Number of gears.
    pub gears: usize,
}

impl Answer for Transmissions {
    const NAME: &'static str = "transmissions";
}

/// Lists the transmissions to choose from.
#[must_use]
pub fn answer(transmissions: &[gearbox::Transmission]) -> Transmissions {
    let one = |one: &gearbox::Transmission| Transmission {
        name: one.name.clone(),
        sets: one.sets.len() + one.compound_sets.len(),
        shift_elements: one.shift_elements.len() + one.one_way.len(),
        gears: one.gears.len(),
    };
    Transmissions { transmissions: transmissions.iter().map(one).collect() }
}
