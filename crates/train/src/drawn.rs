//! Sets as drawings take them: three members side by side.
//!
//! A set with two central gears is drawn as it is. One with more is drawn as several, from its gear of
//! reference to each other central gear: they share that gear's link, the carrier's, and planets.

pub use crate::drawn_set::DrawnSet;

use crate::planet_set::GearOf;
use crate::{Analysis, Gearbox, LoadCase};
use epicyclic_gears::teeth::ToothCount;

/// Powers of a drawn set, as multiples of the power that enters the gear.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DrawnPower {
    /// Power that enters at each member.
    pub members: [f64; 3],
    /// The part of it that circulates.
    pub circulating: [f64; 3],
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
