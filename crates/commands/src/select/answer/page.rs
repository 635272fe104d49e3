//! Drawing for the page of a choice.

use super::candidate::Candidate;
use crate::error::Error;
use crate::synthesize::answer::page::Drawn;
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_layout::{Options, Verdict, draw};
use epicyclic_schemes::structures::{Role, SetRoles, gearbox};

/// Layout of a candidate with its chosen direct-drive clutch; `eta0` is the efficiency of the sets with their
/// carriers fixed.
///
/// # Errors
/// [`Error::Design`] for a candidate with other than simple sets, which an answer never contains.
pub fn drawn(candidate: &Candidate, eta0: MeshEfficiency) -> Result<Drawn, Error> {
    let sets: Vec<(SetRoles, f64)> = candidate
        .sets
        .iter()
        .map(|set| ([set.links.sun, set.links.ring, set.links.carrier], set.k))
        .collect();
    let clutch = candidate.direct_drive_clutches.iter().find(|clutch| clutch.chosen);
    let clutch: Option<[Role; 2]> = clutch.map(|clutch| clutch.links);
    let name = candidate.scheme.unwrap_or(&candidate.structure);
    let gearbox = gearbox(name, &sets, eta0, clutch)?;
    let layout = match draw(&gearbox, Options::default()) {
        Verdict::Drawable(layout) => Some(layout),
        Verdict::SelfCrossing(_) => None,
    };
    Ok(Drawn { gearbox, layout })
}
