//! A design as a gearbox, to be written as a file that `analyze`, `draw` and `report` read.

use crate::Error;
use epicyclic_gears::synthesis::ToothNumbers;
use epicyclic_selection::{Candidate, Requirements};
use epicyclic_train::Gearbox;
use epicyclic_train::set::{Gearing, SetSpec};

/// A design as a gearbox.
#[derive(Debug, Clone, PartialEq)]
pub struct Saved {
    /// The scheme by the source's name, or the structure.
    pub scheme: String,
    /// The gearbox with its brakes K1 and K2, the direct-drive clutch that was chosen, and its gears.
    pub gearbox: Gearbox,
}

impl Saved {
    /// A candidate; of one with teeth the tooth numbers of each set.
    pub(super) fn of(
        candidate: &Candidate,
        requirements: &Requirements,
        teeth: &[ToothNumbers],
    ) -> Result<Self, Error> {
        let scheme = candidate
            .mechanism
            .scheme()
            .map_or_else(|| candidate.mechanism.to_string(), |scheme| scheme.name().to_owned());
        let mut of_sets = teeth.iter();
        let gearbox = candidate
            .gearbox(requirements)?
            .to_builder()
            .map_sets(|set| match of_sets.next() {
                None => set,
                Some(of) => SetSpec { gearing: Gearing::Teeth(of.sun, of.ring), ..set }
                    .planet_teeth(of.planet, None)
                    .planet_count(of.planets),
            })
            .build()?;
        Ok(Self { scheme, gearbox })
    }
}
