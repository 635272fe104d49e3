//! Sizes of the sets of a gearbox file: planets and their bearings, the basic rack, the density.

use super::place::{keys_of, of_set};
use super::{DescriptionError, GearboxFile, SetEntry};
use crate::Path;
use crate::faults::Faults;
use epicyclic_gears::rack::BasicRack;
use epicyclic_train::planet_bearings::{MeshSize, PlanetBearing, PlanetSize, SetSize};
use epicyclic_train::planet_set::GearOf;
use epicyclic_train::{Gearbox, PlanetSet};
use epicyclic_units::{Number, Physical};
use uom::si::f64::{Length, MassDensity};

/// Part of a radius by which a stated one is not that of the teeth.
const OTHER_RADIUS: f64 = 1e-3;

impl GearboxFile {
    /// The planet bearings of each set that has any, as far as their size is known.
    ///
    /// # Errors
    /// [`DescriptionError::Set`] for each set with an invalid size.
    pub fn planet_bearings(&self, gearbox: &Gearbox) -> Result<Vec<PlanetBearing>, Faults> {
        planet_bearings(gearbox, |set| self.moved(set, self.size(set)), |set| of_set(self.sets.len(), set))
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
            return entry.stated_modules(
                set.meshes().len(),
                set.planets().iter().all(|planet| planet.gears.len() == 1),
            );
        }
        if let Some(entry) = self.compound_sets.iter().find(|entry| entry.id == set.id()) {
            return entry.stated_modules();
        }
        vec![None; set.meshes().len()]
    }

    /// Stated radii of planets that differ from those of the teeth by more than a thousandth: set, stated
    /// radius, radius by the teeth.
    #[must_use]
    pub fn other_radii(&self, gearbox: &Gearbox) -> Vec<(String, Length, Length)> {
        let Ok(rack) = self.rack() else { return vec![] };
        let mut all = vec![];
        for set in gearbox.sets() {
            let (modules, size) = (self.stated_modules(set), self.size(set));
            let own = size.planets.iter().map(|planet| planet.carrier_radius);
            let is_stated = own.chain([size.carrier_radius]).any(|radius| radius.is_some());
            // Every command reads this, so teeth are laid out only where a radius is stated; without modules
            // their radii have no length.
            if !is_stated || modules.iter().any(Option::is_none) {
                continue;
            }
            let Ok(toothed) = set.toothed(&rack, &modules) else { continue };
            for (place, own) in toothed.radii.iter().enumerate() {
                let stated = size.planets.get(place).and_then(|planet| planet.carrier_radius);
                let Some((stated, own)) = stated.or(size.carrier_radius).zip(*own) else { continue };
                if (stated.si() / own - 1.0).abs() > OTHER_RADIUS {
                    all.push((set.id().to_owned(), stated, Length::from_si(own)));
                }
            }
        }
        all
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
            return SetSize {
                module: entry.module.map(|module| set.tooth_shape().transverse_module(0, module.0)),
                carrier_radius: entry.carrier_radius.map(|radius| radius.0),
                face_width: entry.face_width.map(|width| width.0),
                planet_bore: entry.planet_bore.map(|bore| bore.0),
                planet_mass: entry.planet_mass.map(|mass| mass.0),
                bearing: entry.load_rating.map(|rating| (rating.0, entry.bearing_rolling.into())),
                ..usual
            };
        }
        let entry = self.compound_sets.iter().find(|entry| entry.id == set.id());
        entry.map_or_else(|| usual.clone(), |entry| entry.size(set, &usual))
    }

    /// Size of a set with the face widths of its gears; shifts or helical teeth move its planets from where
    /// spur teeth alone would have them.
    fn moved(&self, set: &PlanetSet, size: SetSize) -> SetSize {
        let modules = self.stated_modules(set);
        let mut size = size;
        size.planets.resize_with(set.planets().len(), PlanetSize::default);
        if let Some(data) = self.set_data(set) {
            for (gear, width) in data.of.iter().zip(&data.face_widths) {
                if let GearOf::Planet(planet, place) = *gear {
                    let own = &mut size.planets[planet].face_widths;
                    own.resize(own.len().max(place + 1), None);
                    own[place] = own[place].or(*width);
                }
            }
        }
        let toothed = self.rack().ok().filter(|_| set.tooth_shape().has_shape());
        let Some(Ok(toothed)) = toothed.map(|rack| set.toothed(&rack, &modules)) else { return size };
        let has_modules = modules.iter().any(Option::is_some);
        for planet in 0..size.planets.len() {
            let own = &size.planets[planet];
            let is_open = has_modules && own.mass.is_none() && size.planet_mass.is_none();
            let mass = is_open.then(|| set.mass_of_planet(planet, &toothed, &size)).flatten();
            size.planets[planet].mass = own.mass.or(mass);
        }
        size.meshes.resize_with(set.meshes().len(), MeshSize::default);
        for (planet, radius) in size.planets.iter_mut().zip(&toothed.radii).filter(|_| has_modules) {
            let radius = radius.map(Length::from_si).filter(|_| size.carrier_radius.is_none());
            planet.carrier_radius = planet.carrier_radius.or(radius);
        }
        for (own, mesh) in size.meshes.iter_mut().zip(set.mesh_sizes(&toothed, has_modules)) {
            *own = MeshSize { is_behind: own.is_behind, ..mesh };
        }
        size
    }
}

impl SetEntry {
    /// Modules of the meshes in metres; `is_alone` where each planet has one gear and so one module.
    pub(super) fn stated_modules(&self, meshes: usize, is_alone: bool) -> Vec<Option<f64>> {
        // The module is that of the mesh with the sun.
        let of_first = self.module.map(|module| module.0.si());
        let own = |mesh: usize| match &self.modules {
            Some(modules) => modules.get(mesh).map(|module| module.0.si()),
            None => of_first.filter(|_| mesh == 0 || is_alone),
        };
        (0..meshes).map(own).collect()
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
