//! Speeds in a gear: links, planets, the slip of open shift elements.

use crate::planet_set::{MeshKind, PlanetSet};
use crate::state::Verdict;
use crate::topology::Topology;
use crate::{Gear, Gearbox};

/// Motion of a set; speeds are multiples of the input's.
#[derive(Debug, Clone, PartialEq)]
pub struct SetMotion {
    /// Speeds of the members, in the order of [`PlanetSet::members`]: the carrier last. `None` where they do
    /// not follow.
    pub members: Vec<Option<f64>>,
    /// Speed of the first central gear relative to the carrier, `ω_1 − ω_H`.
    pub relative: Option<f64>,
    /// The planets, in the order of [`PlanetSet::planets`]; `None` where teeth or speeds are missing.
    pub planets: Vec<Option<PlanetMotion>>,
}

impl SetMotion {
    /// Speed of the carrier.
    #[must_use]
    pub fn carrier(&self) -> Option<f64> {
        self.members.last().copied().flatten()
    }
}

/// Motion of a planet, as multiples of the input's speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlanetMotion {
    /// Speed relative to the carrier, `ω_g − ω_H`, which is that of the planet's bearing.
    pub relative: f64,
    /// Seen from the housing, `ω_g`. Of a bevel planet, whose axis is not the set's, `None`.
    pub speed: Option<f64>,
}

/// Speeds of all links by [`LinkId::index`](crate::LinkId::index), the housing at 0.
pub(crate) fn link_speeds(topology: &Topology, verdict: &Verdict) -> Vec<Option<f64>> {
    topology.node.iter().map(|node| node.map_or(Some(0.0), |node| verdict.speeds[node])).collect()
}

/// Slip of every shift element, speed of its first link less that of its second: 0 when engaged.
pub(crate) fn slips(gearbox: &Gearbox, gear: &Gear, speeds: &[Option<f64>]) -> Vec<Option<f64>> {
    let slip = |(place, shift_element): (usize, &crate::ShiftElement)| {
        if gear.engaged.contains(&place) {
            return Some(0.0);
        }
        Some(speeds[shift_element.links[0].0]? - speeds[shift_element.links[1].0]?)
    };
    gearbox.shift_elements.iter().enumerate().map(slip).collect()
}

/// Motion of a set between links of known speeds.
///
/// ```text
/// ω_g − ω_H = ∓(ω_c − ω_H)·z_c/z_g      − outside a sun, + inside a ring
/// ```
///
/// # Source
/// multispeed-gearboxes (2.25), table 2.3.
pub(crate) fn set_motion(set: &PlanetSet, speeds: &[Option<f64>]) -> SetMotion {
    let members: Vec<Option<f64>> = set.members().iter().map(|link| speeds[link.0]).collect();
    let carrier = members[set.centrals().len()];
    // Of a central gear whose speed is known; the first in most sets.
    let known = (0..set.centrals().len()).find(|&central| members[central].is_some());
    let is_parallel =
        !set.meshes().iter().any(|mesh| matches!(mesh.kind, MeshKind::BevelLeft | MeshKind::BevelRight));
    let planet = |place: usize| {
        let (central, carrier) = (known?, carrier?);
        let over_central = set.planet_factor(place)? / set.ratio_between(central, 0);
        let relative = (members[central]? - carrier) * over_central;
        Some(PlanetMotion { relative, speed: is_parallel.then_some(relative + carrier) })
    };
    let planets = (0..set.planets().len()).map(planet).collect();
    SetMotion { relative: members[0].zip(carrier).map(|(a, h)| a - h), members, planets }
}
