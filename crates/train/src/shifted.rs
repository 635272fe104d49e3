//! Sets with profile shift: the short description of one with the shifts of its gears, and what their friction takes.

use crate::set::{Gearing, MeshLoss, SetKind, SetSpec, Shifts};
use epicyclic_gears::geometry::GearKind;
use epicyclic_gears::involute::sliding::mesh_efficiency;
use epicyclic_gears::involute::{InvoluteGear, Pair, PlanetSet, Profile};
use epicyclic_gears::rack::BasicRack;
use epicyclic_gears::{Error, ToothCount, mesh};

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
        self.with_shifts(self.shifts?, self.planet?, rack)
    }

    /// The gears of a simple set as they are drawn: with their shifts, or without any where equal centre distances need none.
    ///
    /// `None` of a set that is not simple, whose teeth are not known, or that needs shifts and has none.
    ///
    /// # Errors
    /// As [`involute_set`](Self::involute_set).
    #[must_use]
    pub fn toothed_set(&self, rack: &BasicRack) -> Option<Result<PlanetSet, Error>> {
        let Gearing::Teeth(sun, ring) = self.gearing else { return None };
        let coaxial = mesh::coaxial_planet(sun, ring);
        let planet = match self.planet {
            Some(planet) if self.shifts.is_some() || planet.as_f64() == coaxial => planet,
            None if coaxial >= 1.0 && coaxial.fract() == 0.0 => ToothCount::new(coaxial as u32).ok()?,
            _ => return None,
        };
        self.with_shifts(self.shifts.unwrap_or_default(), planet, rack)
    }

    /// Losses of a simple set by the sliding of its teeth, at coefficients of friction of the meshes sun–planet and planet–ring.
    ///
    /// ```text
    /// η_j = 1 − H_V,j·μ_m,j
    /// ```
    ///
    /// `None` where [`toothed_set`](Self::toothed_set) gives none.
    ///
    /// # Errors
    /// As [`toothed_set`](Self::toothed_set) and [`mesh_efficiency`].
    #[must_use]
    pub fn friction_losses(&self, rack: &BasicRack, friction: [f64; 2]) -> Option<Result<MeshLoss, Error>> {
        let losses = |set: PlanetSet| {
            let [sun, ring] = [(set.sun_mesh(), friction[0]), (set.ring_mesh(), friction[1])];
            Ok(MeshLoss::sun_and_ring(mesh_efficiency(sun.0, sun.1)?, mesh_efficiency(ring.0, ring.1)?))
        };
        Some(self.toothed_set(rack)?.and_then(losses))
    }

    fn with_shifts(
        &self,
        shifts: Shifts,
        planet: ToothCount,
        rack: &BasicRack,
    ) -> Option<Result<PlanetSet, Error>> {
        let (Gearing::Teeth(sun, ring), SetKind::Simple) = (self.gearing, self.kind) else { return None };
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
