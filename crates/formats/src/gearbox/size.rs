//! Sizes of the sets of a gearbox file: planets and their bearings, the basic rack, the density.

use super::place::{keys_of, of_set};
use super::{DescriptionError, GearboxFile};
use crate::Path;
use crate::faults::Faults;
use epicyclic_gears::rack::BasicRack;
use epicyclic_train::planet_bearings::{MeshSize, PlanetBearing, SetSize};
use epicyclic_train::planet_set::{Mesh, MeshKind};
use epicyclic_train::{Gearbox, PlanetSet};
use epicyclic_units::{Number, Physical};
use uom::si::f64::{Angle, Length, MassDensity};

impl GearboxFile {
    /// The planet bearings of each set that has any, as far as their size is known.
    ///
    /// # Errors
    /// [`DescriptionError::Set`] for each set with an invalid size.
    pub fn planet_bearings(&self, gearbox: &Gearbox) -> Result<Vec<PlanetBearing>, Faults> {
        planet_bearings(gearbox, |set| self.size(set), |set| of_set(self.sets.len(), set))
    }

    /// The basic rack that the teeth are checked by.
    ///
    /// # Errors
    /// That of [`BasicRack::check`].
    pub fn rack(&self) -> Result<BasicRack, epicyclic_gears::Error> {
        let usual = BasicRack::default();
        let rack = BasicRack {
            pressure_angle: self.pressure_angle.map_or(usual.pressure_angle, |angle| angle.0),
            addendum: self.addendum.map_or(usual.addendum, Number::get),
            ..usual
        };
        rack.check()?;
        Ok(rack)
    }

    /// Density of the gears, that of steel unless given.
    #[must_use]
    pub fn gear_density(&self) -> MassDensity {
        self.density.map_or(SetSize::default().density, |density| density.0)
    }

    /// Modules that the file states of the meshes of a set, in metres.
    #[must_use]
    pub fn stated_modules(&self, set: &PlanetSet) -> Vec<Option<f64>> {
        if let Some(entry) = self.sets.iter().find(|entry| entry.id == set.id()) {
            // The module is that of the mesh with the sun; a planet of one gear has one module.
            let of_first = entry.module.map(|module| module.0.si());
            let all = set.meshes().iter().enumerate();
            let is_alone = set.planets().iter().all(|planet| planet.gears.len() == 1);
            return all.map(|(mesh, _)| of_first.filter(|_| mesh == 0 || is_alone)).collect();
        }
        let size = self.size(set);
        let own = |mesh: usize| size.meshes.get(mesh).and_then(|own| own.module).or(size.module);
        (0..set.meshes().len()).map(|mesh| own(mesh).map(Physical::si)).collect()
    }

    /// Size of a set, as far as the file states it.
    fn size(&self, set: &PlanetSet) -> SetSize {
        let usual = SetSize::default();
        let usual = SetSize {
            density: self.gear_density(),
            pressure_angle: self.pressure_angle.map_or(usual.pressure_angle, |angle| angle.0),
            ..usual
        };
        if let Some(entry) = self.sets.iter().find(|entry| entry.id == set.id()) {
            // Shifts and helical teeth move the planets from where spur teeth alone would have them.
            let rack = self.rack().ok();
            let shifted = set.short().zip(rack).and_then(|(spec, rack)| spec.involute_set(&rack)?.ok());
            let by_shifts =
                shifted.as_ref().zip(entry.module).map(|(set, module)| module.0 * set.centre_distance());
            let working_angle = |mesh: &Mesh| {
                let pairs = shifted.as_ref().map(|set| [set.sun_mesh(), set.ring_mesh()])?;
                let pair = pairs[usize::from(mesh.kind == MeshKind::Internal)];
                Some(Angle::from_si(pair.working_angle_rad()))
            };
            let mesh = |mesh: &Mesh| MeshSize { pressure_angle: working_angle(mesh), ..MeshSize::default() };
            // Centre distances, and diameters but for addenda, are as with spur teeth of the transverse
            // module.
            let transverse =
                |module: Length| set.short().map_or(module, |spec| spec.transverse_module(module));
            return SetSize {
                module: entry.module.map(|module| transverse(module.0)),
                carrier_radius: entry.carrier_radius.map(|radius| radius.0).or(by_shifts),
                face_width: entry.face_width.map(|width| width.0),
                planet_bore: entry.planet_bore.map(|bore| bore.0),
                planet_mass: entry.planet_mass.map(|mass| mass.0),
                bearing: entry.load_rating.map(|rating| (rating.0, entry.bearing_rolling.into())),
                meshes: set.meshes().iter().map(mesh).collect(),
                ..usual
            };
        }
        let entry = self.compound_sets.iter().find(|entry| entry.id == set.id());
        entry.map_or_else(|| usual.clone(), |entry| entry.size(set, &usual))
    }
}

/// The planets of each set that has any, with what is known of its size; `at` is the path of a set by its
/// index.
pub(super) fn planet_bearings(
    gearbox: &Gearbox,
    size: impl Fn(&PlanetSet) -> SetSize,
    at: impl Fn(usize) -> Path,
) -> Result<Vec<PlanetBearing>, Faults> {
    let (mut all, mut faults) = (vec![], Faults::default());
    for (place, set) in gearbox.sets().iter().enumerate() {
        match gearbox.planet_bearings(place, &size(set)) {
            Some(Ok(bearings)) => all.extend(bearings),
            Some(Err(source)) => {
                let keys = at(place).first_of(keys_of(&source));
                faults.push(keys, DescriptionError::of_set(set.id(), source));
            }
            None => {}
        }
    }
    faults.or(all)
}
