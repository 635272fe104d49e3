//! Speeds in a gear: links, planets, the slip of open controls.

use crate::row::Row;
use crate::state::Verdict;
use crate::topology::Topology;
use crate::{Gear, Gearbox};

/// How a row moves; speeds are multiples of the input's.
#[derive(Debug, Clone, PartialEq)]
pub struct RowMotion {
    /// Speeds of sun (wheel 1), ring (wheel 2) and carrier, `None` where they do not follow.
    pub members: [Option<f64>; 3],
    /// Speed of wheel 1 relative to the carrier, `ω_a − ω_H`.
    pub relative: Option<f64>,
    /// The planets: one of a simple or stepped row, two of a double planet or meshing suns, as far
    /// as their teeth are known. A pair has none.
    pub planets: Vec<PlanetMotion>,
}

/// How a planet turns, as multiples of the input's speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlanetMotion {
    /// Relative to the carrier, `ω_g − ω_H`: what its bearing sees.
    pub relative: f64,
    /// Seen from the housing, `ω_g`. Of a bevel planet, whose axis is not the row's, `None`.
    pub absolute: Option<f64>,
}

/// Speeds of all links by [`LinkId::index`](crate::LinkId::index), the housing at 0.
pub(crate) fn link_speeds(topology: &Topology, verdict: &Verdict) -> Vec<Option<f64>> {
    topology.node.iter().map(|node| node.map_or(Some(0.0), |node| verdict.speeds[node])).collect()
}

/// Slip of every control, speed of its first link less that of its second: 0 when engaged.
pub(crate) fn slips(gearbox: &Gearbox, gear: &Gear, speeds: &[Option<f64>]) -> Vec<Option<f64>> {
    let slip = |(place, control): (usize, &crate::Control)| {
        if gear.engaged.contains(&place) {
            return Some(0.0);
        }
        Some(speeds[control.links[0].0]? - speeds[control.links[1].0]?)
    };
    gearbox.controls.iter().enumerate().map(slip).collect()
}

/// Motion of a row between links of known speeds.
///
/// ```text
/// ω_g − ω_H = ∓(ω_wheel − ω_H)·z_wheel/z_g      − outside a sun, + inside a ring
/// ```
///
/// # Source
/// multispeed-gearboxes (2.25), table 2.3.
pub(crate) fn row_motion(row: &Row, speeds: &[Option<f64>]) -> RowMotion {
    let members = row.members.map(|link| speeds[link.0]);
    let [a, _, h] = members;
    let planet = |ratio: &crate::row::PlanetRatio| {
        let (wheel, carrier) = (members[ratio.wheel]?, h?);
        let relative = (wheel - carrier) * ratio.factor;
        let parallel = row.spec.kind != crate::row::RowKind::Bevel;
        Some(PlanetMotion { relative, absolute: parallel.then_some(relative + carrier) })
    };
    RowMotion {
        members,
        relative: a.zip(h).map(|(a, h)| a - h),
        planets: row.planets().iter().filter_map(planet).collect(),
    }
}
