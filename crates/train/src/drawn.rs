//! Sets as drawings take them: three members side by side.
//!
//! A set with two central gears is drawn as it is. One with more is drawn as several, from its gear of reference to
//! each other central gear: they share that gear's link, the carrier's, and planets.

use crate::compound::CentralKind;
use crate::planet_set::GearOf;
use crate::set::SetKind;
use crate::{Analysis, Gearbox, LinkId, LoadCase};
use epicyclic_gears::teeth::ToothCount;

/// Three members of a set.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct DrawnSet {
    /// Place of the set in [`Gearbox::sets`].
    pub set: usize,
    /// How the planets join the two central gears.
    pub kind: SetKind,
    /// Places among the set's members: sun or first central gear, ring or second, carrier.
    pub members: [usize; 3],
    /// Their links.
    pub links: [LinkId; 3],
    /// Whether the gear of reference is the second of them.
    is_turned: bool,
}

/// Powers of a drawn set, as multiples of what enters the gear.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DrawnPower {
    /// What enters at each member.
    pub members: [f64; 3],
    /// The part of it that circulates.
    pub circulating: [f64; 3],
}

impl DrawnSet {
    /// That of an equation.
    pub(crate) fn of(gearbox: &Gearbox, equation: usize) -> Self {
        let one = &gearbox.equations[equation];
        let set = &gearbox.sets[one.set];
        let carrier = set.centrals().len();
        if let Some(kind) = set.kind() {
            return Self {
                set: one.set,
                kind,
                members: [0, 1, carrier],
                links: [set.members()[0], set.members()[1], set.carrier()],
                is_turned: false,
            };
        }
        let root = set.tree.root;
        let ends = [root, one.central].map(|central| set.centrals()[central].kind);
        let path = set.path(root, one.central);
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
        let members = if is_turned { [one.central, root, carrier] } else { [root, one.central, carrier] };
        Self { set: one.set, kind, members, links: members.map(|member| set.members()[member]), is_turned }
    }
}

impl DrawnSet {
    /// Basic ratio of its first central gear to its second.
    #[must_use]
    pub fn basic_ratio(&self, gearbox: &Gearbox) -> f64 {
        let set = &gearbox.sets[self.set];
        if set.short().is_some() {
            return set.basic_ratio().get();
        }
        set.ratio_between(self.members[0], self.members[1])
    }

    /// Teeth of its central gears, where known.
    #[must_use]
    pub fn teeth(&self, gearbox: &Gearbox) -> Option<[ToothCount; 2]> {
        let of = |member: usize| gearbox.sets[self.set].centrals()[member].teeth;
        Some([of(self.members[0])?, of(self.members[1])?])
    }

    /// Teeth of the planets' gears in mesh with each of them, where known.
    #[must_use]
    pub fn planet_teeth(&self, gearbox: &Gearbox) -> [Option<ToothCount>; 2] {
        let set = &gearbox.sets[self.set];
        let path = set.path(self.members[0], self.members[1]);
        [0, 1].map(|end| {
            let central = GearOf::Central(self.members[end]);
            let mesh =
                path.iter().map(|&mesh| set.meshes()[mesh].gears).find(|gears| gears.contains(&central))?;
            mesh.into_iter().find(|gear| *gear != central).and_then(|gear| set.teeth(gear))
        })
    }
}

impl Gearbox {
    /// Its sets as drawings take them.
    #[must_use]
    pub fn drawn_sets(&self) -> &[DrawnSet] {
        &self.drawn
    }
}

impl Analysis<'_> {
    /// Powers of a drawn set in a load case of this gear; `None` where a torque or speed does not follow.
    #[must_use]
    pub fn drawn_power(&self, case: &LoadCase, place: usize) -> Option<DrawnPower> {
        let drawn = self.gearbox.drawn.get(place)?;
        let whole = case.power.sets[drawn.set].as_ref()?;
        let [root, central, carrier] = case.equations[place];
        let torques = if drawn.is_turned { [central, root, carrier] } else { [root, central, carrier] };
        let mut power = DrawnPower { members: [0.0; 3], circulating: [0.0; 3] };
        for (at, (&member, torque)) in drawn.members.iter().zip(torques).enumerate() {
            let own = if torque == 0.0 { 0.0 } else { torque * self.speed(drawn.links[at])? };
            power.members[at] = own;
            let circulating = case.power.circulating_member(drawn.set, member);
            if circulating != 0.0 {
                power.circulating[at] = own * circulating / whole.members[member];
            }
        }
        Some(power)
    }
}
