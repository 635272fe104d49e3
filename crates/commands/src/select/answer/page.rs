//! What a page of a choice draws.

use super::candidate::Candidate;
use crate::error::Error;
use crate::shared::catalogue::Link;
use crate::synthesize::answer::page::Drawn;
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_layout::{Options, Verdict, draw};
use epicyclic_schemes::structures::{Role, SetRoles, gearbox};

/// A candidate as a gearbox with the direct-drive clutch chosen, laid out; `eta0` is the efficiency of its
/// sets with their carriers fixed.
///
/// # Errors
/// [`Error::Design`] of a candidate whose sets are no simple sets; there is none in an answer.
pub fn drawn(candidate: &Candidate, eta0: MeshEfficiency) -> Result<Drawn, Error> {
    let sets: Vec<(SetRoles, f64)> = candidate
        .sets
        .iter()
        .map(|set| ([set.links.sun, set.links.ring, set.links.carrier].map(Link::role), set.k))
        .collect();
    let clutch = candidate.direct_drive_clutches.iter().find(|clutch| clutch.chosen);
    let clutch: Option<[Role; 2]> = clutch.map(|clutch| clutch.links.map(Link::role));
    let name = candidate.scheme.unwrap_or(&candidate.structure);
    let gearbox = gearbox(name, &sets, eta0, clutch)?;
    let layout = match draw(&gearbox, Options::default()) {
        Verdict::Drawable(layout) => Some(layout),
        Verdict::SelfCrossing(_) => None,
    };
    Ok(Drawn { gearbox, layout })
}
