//! Known dimensions of a set, as far as its planet bearings need them.

use crate::planet_set::PlanetSet;
use epicyclic_gears::life::{self, Rolling};
use epicyclic_gears::planet_bearing;
use epicyclic_gears::{Error, Quantity};
use epicyclic_units::Physical;
use uom::si::f64::{Angle, AngularVelocity, Force, Length, Mass, MassDensity};

/// Known dimensions of a set. A value for all planets or meshes applies to each that has none of its own.
#[derive(Debug, Clone, PartialEq)]
pub struct SetSize {
    /// Module `m` of the meshes, of helical teeth the transverse one.
    pub module: Option<Length>,
    /// Radius `R` of the planets' centres, for a set with one planet; takes precedence over that of module
    /// and teeth. If planets differ, each has its own: [`PlanetSize::carrier_radius`].
    pub carrier_radius: Option<Length>,
    /// Face width of a planet with one gear.
    pub face_width: Option<Length>,
    /// Bore of a planet; a solid planet where it is left out.
    pub planet_bore: Option<Length>,
    /// Mass of a planet with the parts that turn about its planet pin; takes precedence over that of its
    /// shape.
    pub planet_mass: Option<Mass>,
    /// Basic dynamic load rating of the bearings of one planet together, and the kind of their rolling
    /// elements.
    pub bearing: Option<(Force, Rolling)>,
    /// Density of the planets.
    pub density: MassDensity,
    /// Working pressure angle `α`.
    pub pressure_angle: Angle,
    /// Values of single planets, in the order of [`PlanetSet::planets`]; those at the end may be left out.
    pub planets: Vec<PlanetSize>,
    /// Values of single meshes, in the order of [`PlanetSet::meshes`]; those at the end may be left out.
    pub meshes: Vec<MeshSize>,
}

/// Known dimensions of one planet.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct PlanetSize {
    /// Radius `R` of the planet's centre; takes precedence over that of module and teeth.
    pub carrier_radius: Option<Length>,
    /// Face width of each of its gears, in the order of [`Planet::gears`](crate::planet_set::Planet::gears).
    pub face_widths: Vec<Option<Length>>,
    /// Bore of the planet.
    pub bore: Option<Length>,
    /// Mass of the planet with the parts that turn about its planet pin.
    pub mass: Option<Mass>,
    /// Basic dynamic load rating of its bearings together, and the kind of their rolling elements.
    pub bearing: Option<(Force, Rolling)>,
}

/// Known dimensions of one mesh.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct MeshSize {
    /// Module of the mesh; the other meshes of its two gears have the same.
    pub module: Option<Length>,
    /// Working pressure angle of a mesh with a central gear, if it differs from that of the set because
    /// profiles are shifted.
    pub pressure_angle: Option<Angle>,
    /// Centre distance of the mesh in its modules, if it differs from that of the teeth because profiles are
    /// shifted.
    pub centre_distance: Option<f64>,
    /// Whether, in a mesh of two planets, the one described later is behind the other. By default it is ahead
    /// in the positive direction of rotation.
    pub is_behind: bool,
}

impl Default for SetSize {
    /// Nothing but steel of 7850 kg/m³ and 20°.
    fn default() -> Self {
        Self {
            module: None,
            carrier_radius: None,
            face_width: None,
            planet_bore: None,
            planet_mass: None,
            bearing: None,
            density: MassDensity::from_si(7850.0),
            pressure_angle: Angle::from_degrees(20.0),
            planets: vec![],
            meshes: vec![],
        }
    }
}

impl SetSize {
    pub(super) fn check(&self, set: &PlanetSet) -> Result<(), Error> {
        let most = |quantity, given: usize, most: usize| {
            if given <= most {
                return Ok(());
            }
            Err(Error::OutOfRange { quantity, value: given as f64, low: 0.0, high: most as f64, unit: "" })
        };
        most(Quantity::SizedPlanets, self.planets.len(), set.planets().len())?;
        most(Quantity::SizedMeshes, self.meshes.len(), set.meshes().len())?;
        let mut lengths = vec![
            (Quantity::Module, self.module),
            (Quantity::CarrierRadius, self.carrier_radius),
            (Quantity::FaceWidth, self.face_width),
            (Quantity::PlanetBore, self.planet_bore),
        ];
        lengths.extend(self.meshes.iter().map(|mesh| (Quantity::Module, mesh.module)));
        for (own, planet) in self.planets.iter().zip(set.planets()) {
            most(Quantity::SizedFaceWidths, own.face_widths.len(), planet.gears.len())?;
            lengths.push((Quantity::CarrierRadius, own.carrier_radius));
            lengths.push((Quantity::PlanetBore, own.bore));
            lengths.extend(own.face_widths.iter().map(|width| (Quantity::FaceWidth, *width)));
        }
        for (quantity, length) in lengths {
            if let Some(value_m) = length.map(Physical::si)
                && !(value_m > 0.0 && value_m.is_finite())
            {
                return Err(Error::NotPositive { quantity, value: value_m * 1e3, unit: "mm" });
            }
        }
        for mass in self.planets.iter().map(|own| own.mass).chain([self.planet_mass]).flatten() {
            let value = mass.si();
            if !(value > 0.0 && value.is_finite()) {
                return Err(Error::NotPositive { quantity: Quantity::PlanetMass, value, unit: "kg" });
            }
        }
        for (load_rating, _) in self.planets.iter().map(|own| own.bearing).chain([self.bearing]).flatten() {
            // The load rating's own limits.
            life::basic_rating_life(Rolling::Balls, load_rating, load_rating, AngularVelocity::default())?;
        }
        // The angles' own limits.
        let own = self.meshes.iter().filter_map(|mesh| mesh.pressure_angle);
        for angle in own.chain([self.pressure_angle]) {
            planet_bearing::radial_force(&[], 1, angle)?;
        }
        Ok(())
    }
}
