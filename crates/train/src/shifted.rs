//! Sets with profile shift: the short description of one with the shifts of its gears.

use crate::set::{Gearing, SetKind, SetSpec};
use epicyclic_gears::Error;
use epicyclic_gears::geometry::GearKind;
use epicyclic_gears::involute::{InvoluteGear, Pair, PlanetSet, Profile};
use epicyclic_gears::rack::BasicRack;

/// Profile shifts of sun, planets and ring, with the sign of [`involute`](epicyclic_gears::involute): one above 0 moves the tips of a ring
/// inwards.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Shifts {
    /// Profile shift coefficients `x`, modules.
    pub profile: [f64; 3],
    /// Tip alterations `k`, below 0 shorter, modules.
    pub tips: [f64; 3],
}

impl SetSpec {
    /// The same set with shifts of sun, planets and ring; they are of simple sets known by their teeth, of spur gears.
    #[must_use]
    pub fn shifted(self, shifts: Shifts) -> Self {
        Self { shifts: Some(shifts), ..self }
    }

    /// The gears with their shifts on the centre distance at which sun and planets have no backlash; planets of an unknown number are taken
    /// as one.
    ///
    /// `None` of a set without shifts, and of one that is not simple or whose teeth are not all known.
    ///
    /// # Errors
    /// Those of [`InvoluteGear::new`] and [`Pair::without_backlash`] for shifts that leave no teeth or no mesh.
    #[must_use]
    pub fn involute_set(&self, rack: &BasicRack) -> Option<Result<PlanetSet, Error>> {
        let (Some(shifts), Gearing::Teeth(sun, ring), Some(planet), SetKind::Simple) =
            (self.shifts, self.gearing, self.planet, self.kind)
        else {
            return None;
        };
        let profile = Profile::of_rack(*rack);
        let gear = |kind, teeth, place: usize| {
            InvoluteGear::new(kind, teeth, profile, shifts.profile[place])?
                .with_tip_alteration(shifts.tips[place])
        };
        let set = || {
            let sun = gear(GearKind::External, sun, 0)?;
            let planet = gear(GearKind::External, planet, 1)?;
            let ring = gear(GearKind::Internal, ring, 2)?;
            let centre_distance = Pair::without_backlash(sun, planet)?.centre_distance();
            PlanetSet::new([sun, planet, ring], self.planet_count.unwrap_or(1), centre_distance)
        };
        Some(set())
    }
}
