//! Sets with profile shift or helical teeth: the short description of one as toothed gears, and their
//! friction losses.

use crate::set::{Gearing, MeshLoss, SetKind, SetSpec, Shifts};
use epicyclic_gears::geometry::GearKind;
use epicyclic_gears::involute::profile::{Cutting, Profiles};
use epicyclic_gears::involute::sliding::mesh_efficiency;
use epicyclic_gears::involute::{InvoluteGear, Pair, PlanetSet, Profile};
use epicyclic_gears::rack::BasicRack;
use epicyclic_gears::{Error, ToothCount, mesh};
use epicyclic_units::Physical;
use uom::si::f64::{Angle, Length};

impl SetSpec {
    /// Returns the set with shifts of sun, planets and ring, for simple sets known by their teeth.
    #[must_use]
    pub fn shifted(self, shifts: Shifts) -> Self {
        Self { shifts: Some(shifts), ..self }
    }

    /// Returns the set with helical teeth, of this helix angle at the reference cylinders, for simple sets
    /// only. The module is then the normal module, as in ISO 21771.
    #[must_use]
    pub fn helical(self, helix_angle: Angle) -> Self {
        Self { helix_angle, ..self }
    }

    /// Returns the set with this cutting of sun, planets and ring, for simple sets only.
    #[must_use]
    pub fn cut(self, cutting: [Cutting; 3]) -> Self {
        Self { cutting: Box::new(cutting), ..self }
    }

    /// The transverse module of a normal one, `m_t = m_n/cos β`.
    #[must_use]
    pub fn transverse_module(&self, normal: Length) -> Length {
        normal / libm::cos(self.helix_angle.si())
    }

    /// Whether its teeth are helical.
    #[must_use]
    pub fn is_helical(&self) -> bool {
        self.helix_angle.si() != 0.0
    }

    /// The gears with their shifts on the centre distance at which sun and planets have no backlash; planets
    /// of an unknown number are taken as one.
    ///
    /// `None` of a set with neither shifts nor helical teeth, and of one that is not simple or whose teeth
    /// are not all known.
    ///
    /// # Errors
    /// Those of [`InvoluteGear::new`] and [`Pair::without_backlash`] for shifts that leave no teeth or no
    /// mesh.
    #[must_use]
    pub fn involute_set(&self, rack: &BasicRack) -> Option<Result<PlanetSet, Error>> {
        match self.shifts {
            Some(shifts) => self.with_shifts(shifts, self.planet?, rack),
            None if self.is_helical() => self.toothed_set(rack),
            None => None,
        }
    }

    /// The gears of a simple set as they are drawn: with their shifts, or without any where equal centre
    /// distances need none.
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

    /// Losses of a simple set by the sliding of its teeth, at coefficients of friction of the meshes
    /// sun–planet and planet–ring.
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

    /// Basic racks and tools of sun, planets and ring.
    #[must_use]
    pub fn profiles(&self, rack: &BasicRack) -> Profiles {
        let profile = Profile { helix_angle: self.helix_angle, ..Profile::of_rack(*rack) };
        Profiles::cut(profile, *self.cutting)
    }

    fn with_shifts(
        &self,
        shifts: Shifts,
        planet: ToothCount,
        rack: &BasicRack,
    ) -> Option<Result<PlanetSet, Error>> {
        let (Gearing::Teeth(sun, ring), SetKind::Simple) = (self.gearing, self.kind) else { return None };
        let Profiles(profiles) = self.profiles(rack);
        let tips = shifts.tips.unwrap_or_default();
        let gear = |kind, teeth, place: usize| {
            InvoluteGear::new(kind, teeth, profiles[place], shifts.profile[place])?
                .with_tip_alteration(tips[place])
        };
        let set = || {
            let sun = gear(GearKind::External, sun, 0)?;
            let planet = gear(GearKind::External, planet, 1)?;
            let ring = gear(GearKind::Internal, ring, 2)?;
            let centre_distance = Pair::without_backlash(sun, planet)?.centre_distance();
            let set = PlanetSet::new([sun, planet, ring], self.planet_count.unwrap_or(1), centre_distance)?;
            if shifts.tips.is_some() { Ok(set) } else { set.with_clear_ring_tips() }
        };
        Some(set())
    }
}
