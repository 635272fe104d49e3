//! Selection of the three members of a set that are drawn side by side.

use crate::LinkId;
use crate::compound::CentralKind;
use crate::planet_set::{GearOf, PlanetSet};
use crate::set_kind::SetKind;

/// Three members of a set.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct DrawnSet {
    /// Place of the set in [`Gearbox::sets`](crate::Gearbox::sets).
    pub set: usize,
    /// Kind of the set: the arrangement of the planets between the two central gears.
    pub kind: SetKind,
    /// Places among the set's members: sun or first central gear, ring or second, carrier.
    pub members: [usize; 3],
    /// Links of these members.
    pub links: [LinkId; 3],
    /// Whether the gear of reference is the second of them.
    pub(crate) is_turned: bool,
}

impl DrawnSet {
    /// Drawn set for the equation of a central gear; `place` is the place of the set in the gearbox.
    pub(crate) fn of(set: &PlanetSet, place: usize, central: usize) -> Self {
        let carrier = set.centrals().len();
        if let Some(kind) = set.kind() {
            return Self {
                set: place,
                kind,
                members: [0, 1, carrier],
                links: [set.members()[0], set.members()[1], set.carrier()],
                is_turned: false,
            };
        }
        let root = set.tree.root;
        let ends = [root, central].map(|central| set.centrals()[central].kind);
        let path = set.path(root, central);
        let gears = path.iter().flat_map(|&mesh| set.meshes()[mesh].gears);
        let mut planets: Vec<usize> = vec![];
        let mut steps: Vec<(usize, usize)> = vec![];
        for gear in gears {
            if let GearOf::Planet(planet, step) = gear {
                if !planets.contains(&planet) {
                    planets.push(planet);
                }
                if !steps.contains(&(planet, step)) {
                    steps.push((planet, step));
                }
            }
        }
        let is_ring = |kind| kind == CentralKind::Ring;
        let kind = match (ends.map(is_ring), planets.len(), steps.len()) {
            _ if matches!(ends[0], CentralKind::BevelLeft | CentralKind::BevelRight) => SetKind::Bevel,
            ([true, true], ..) => SetKind::SteppedRings,
            ([false, false], 1, _) => SetKind::SteppedSuns,
            ([false, false], ..) => SetKind::MeshingSuns,
            (_, 1, 1) => SetKind::Simple,
            (_, 1, _) => SetKind::SteppedSunRing,
            _ => SetKind::DoublePlanet,
        };
        let is_turned = is_ring(ends[0]) && !is_ring(ends[1]);
        let members = if is_turned { [central, root, carrier] } else { [root, central, carrier] };
        Self { set: place, kind, members, links: members.map(|member| set.members()[member]), is_turned }
    }
}
