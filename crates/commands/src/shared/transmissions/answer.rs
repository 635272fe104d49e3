//! The transmissions of a file, of which none was chosen.

use crate::answer::Answer;
use epicyclic_formats::gearbox;
use schemars::JsonSchema;
use serde::Serialize;

/// Published transmissions to choose from.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Transmissions {
    /// In the order of the file.
    pub transmissions: Vec<Transmission>,
}

/// A transmission, and how many parts it has.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Transmission {
    /// Its name.
    pub name: String,
    /// Planet sets.
    pub sets: usize,
    /// Brakes and clutches, one-way clutches among them.
    pub shift_elements: usize,
    /// Gears.
    pub gears: usize,
}

impl Answer for Transmissions {
    const NAME: &'static str = "transmissions";
}

/// What there is to choose from.
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
