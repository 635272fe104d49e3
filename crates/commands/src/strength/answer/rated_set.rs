//! Meshes of the sets of a file, with all data that their strength needs.

use super::factors;
use super::materials::{check_materials, floating, material};
use super::names::MeshName;
use super::records::{NotRated, Reason};
use crate::error::Error;
use crate::shared::fault::{Fault, Named, refused};
use crate::shared::gearbox::Gearbox;
use crate::shared::toothed::{lacking, toothed};
use epicyclic_formats::Path;
use epicyclic_formats::gearbox::{GearboxFile, PerGear, SetData, StrengthEntry};
use epicyclic_gears::geometry::GearKind;
use epicyclic_strength::factor::{Given, Side, Symbol};
use epicyclic_strength::load::{Arrangement, Dynamics, Floating};
use epicyclic_strength::mesh::{Gear, Mesh, Method};
use epicyclic_strength::root::factors::Bending;
use epicyclic_strength::root::section::Shaper;
use epicyclic_train::PlanetSet;
use epicyclic_train::planet_set::GearOf;
use epicyclic_train::toothed::{ToothedMesh, ToothedSet};
use epicyclic_units::{Number, Physical, Quantity};
use std::collections::BTreeMap;
use uom::si::f64::{KinematicViscosity, Length};

/// Set with all data that its strength needs.
pub(crate) struct RatedSet<'g> {
    /// Index of the set in the gearbox.
    pub(crate) place: usize,
    /// The set.
    pub(crate) set: &'g PlanetSet,
    /// Name of the set.
    pub(crate) id: &'g str,
    /// Path of the set in the file.
    pub(crate) path: Path,
    /// The meshes, in the order of the set.
    pub(crate) meshes: Vec<RatedMesh>,
}

/// Mesh with all data that its strength needs.
pub(crate) struct RatedMesh {
    pub(crate) name: MeshName,
    /// Materials of both gears by name.
    pub(crate) materials: [String; 2],
    pub(crate) mesh: Mesh,
    pub(crate) method: Method,
}

impl RatedSet<'_> {
    /// Whether any teeth are helical.
    pub(crate) fn is_helical(&self) -> bool {
        self.set.tooth_shape().is_helical()
    }

    /// Whether `K_γ` of all meshes is given.
    pub(crate) fn has_load_sharing(&self) -> bool {
        let given = |mesh: &RatedMesh| mesh.method.given.of(Side::First, Symbol::LoadSharing);
        self.meshes.iter().all(|mesh| given(mesh).is_some())
    }
}

/// Sets that can be rated, and reasons why others cannot.
pub(crate) fn sets<'g>(
    subject: &'g Gearbox,
    file: &'g GearboxFile,
) -> Result<(Vec<RatedSet<'g>>, Vec<NotRated>), Error> {
    check_materials(&subject.document, file)?;
    let (mut all, mut not_rated) = (vec![], vec![]);
    for (place, set) in subject.train.sets().iter().enumerate() {
        let Some(data) = file.set_data(set) else { continue };
        let of = Of { subject, file, set, data };
        of.check_factors()?;
        match of.meshes()? {
            Ok(meshes) => {
                let path = of.data.path.clone();
                all.push(RatedSet { place, set, id: set.id(), path, meshes });
            }
            Err(row) => not_rated.push(row),
        }
    }
    Ok((all, not_rated))
}

/// Prepared part, or why the set is not rated.
type Made<T> = Result<Result<T, NotRated>, Error>;

/// Factors by their symbols, and the keys that lead to them.
type Factors<'f> = (Vec<&'f str>, &'f BTreeMap<String, Number>);

/// Set of the file.
pub(super) struct Of<'a> {
    pub(super) subject: &'a Gearbox,
    pub(super) file: &'a GearboxFile,
    pub(super) set: &'a PlanetSet,
    pub(super) data: SetData<'a>,
}

/// Materials and roughness of the gears of a set, in their order, as far as they are given.
pub(super) struct PerGearData<'a> {
    materials: Vec<Option<&'a String>>,
    flank_roughness: Vec<Option<&'a Quantity<Length>>>,
    root_roughness: Vec<Option<&'a Quantity<Length>>>,
}

impl PerGearData<'_> {
    /// Name of a gear's material.
    pub(super) fn material(&self, gear: usize) -> &str {
        self.materials[gear].map_or("", String::as_str)
    }
}

impl<'a> Of<'a> {
    /// Refuses wrong names under the keys of factors.
    pub(super) fn check_factors(&self) -> Result<(), Error> {
        let name = |mesh: usize| {
            let gears = self.set.gears_of_mesh(mesh).map(|gear| self.data.place(gear));
            gears.map(|place| self.data.gears.names[place].as_str()).join("-")
        };
        let meshes: Vec<String> = (0..self.set.meshes().len()).map(name).collect();
        factors::check(&self.subject.document, &self.strength_path(&[]), &self.data.gears.names, &meshes)
    }

    fn meshes(&self) -> Made<Vec<RatedMesh>> {
        let missing = |keys: Vec<String>| NotRated {
            missing: keys,
            ..NotRated::new(self.set.id(), Reason::KeysMissing)
        };
        let toothed = match toothed(self.subject, &self.data, self.set)? {
            Ok(toothed) => Ok(toothed),
            Err(None) => return Ok(Err(NotRated::new(self.set.id(), Reason::Bevel))),
            Err(Some(key)) => Err(key),
        };
        let data = &self.data;
        let strength = data.strength;
        let viscosity = self.file.oil.as_ref().map(|oil| oil.viscosity.0);
        let has_planets = self.set.is_pair() || self.set.planet_count().is_some();
        let has_ring = data.of.iter().any(|gear| self.set.gear_kind(*gear) == Some(GearKind::Internal));
        let shaper = self.shaper();
        let has_widths = data.face_widths.iter().all(Option::is_some);
        if let (Ok(toothed), Some(strength), Some(viscosity), true) =
            (&toothed, strength, viscosity, has_planets && has_widths && !(has_ring && shaper.is_none()))
            && data.modules.iter().any(Option::is_some)
        {
            let per_gear = self.per_gear(strength)?;
            let lacks = self.lacks(&per_gear);
            if !lacks.is_empty() {
                return Ok(Err(missing(lacks)));
            }
            let meshes = (0..toothed.meshes.len())
                .map(|mesh| self.mesh(toothed, mesh, strength, &per_gear, shaper, viscosity));
            return Ok(Ok(meshes.collect::<Result<_, _>>()?));
        }
        let key = toothed.as_ref().err().copied().unwrap_or_default();
        let known = [
            (key, toothed.is_ok()),
            ("planets", has_planets),
            ("module", data.modules.iter().any(Option::is_some)),
            ("face_width", has_widths),
            ("strength", strength.is_some()),
            ("strength.shaper", !has_ring || strength.is_none() || shaper.is_some()),
            ("oil", viscosity.is_some()),
        ];
        Ok(Err(missing(lacking(&known))))
    }

    pub(super) fn per_gear(&self, strength: &'a StrengthEntry) -> Result<PerGearData<'a>, Error> {
        Ok(PerGearData {
            materials: self.given("materials", &strength.materials)?,
            flank_roughness: self.given("flank_roughness", &strength.flank_roughness)?,
            root_roughness: self.given("root_roughness", &strength.root_roughness)?,
        })
    }

    fn given<T>(&self, key: &'static str, values: &'a PerGear<T>) -> Result<Vec<Option<&'a T>>, Error> {
        self.given_at(&["strength", key], key, values)
    }

    fn given_at<T>(
        &self,
        keys: &[&str],
        key: &'static str,
        values: &'a PerGear<T>,
    ) -> Result<Vec<Option<&'a T>>, Error> {
        let given = values.given(self.set.id(), key, &self.data.gears);
        given.map_err(|error| self.refused(keys, &error))
    }

    /// Keys of gears for which nothing is given.
    pub(super) fn lacks(&self, data: &PerGearData<'_>) -> Vec<String> {
        let lacks = |key: &str, is_given: Vec<bool>| -> Vec<String> {
            let names = self.data.gears.names.iter().zip(is_given);
            names.filter(|one| !one.1).map(|(gear, _)| format!("strength.{key}.{gear}")).collect()
        };
        let is_given = |values: &[Option<&Quantity<Length>>]| values.iter().map(Option::is_some).collect();
        [
            lacks("materials", data.materials.iter().map(Option::is_some).collect()),
            lacks("flank_roughness", is_given(&data.flank_roughness)),
            lacks("root_roughness", is_given(&data.root_roughness)),
        ]
        .concat()
    }

    /// Shaper for the standard's formulas of internal gears: from the set's strength, otherwise from the
    /// tools of the first.
    pub(super) fn shaper(&self) -> Option<Shaper> {
        let of_strength = self.data.strength.and_then(|strength| strength.shaper.as_ref());
        let of_strength = of_strength.map(|one| (one.teeth, one.shift));
        let of_tools = || {
            let rings = self.data.gears.names.iter().zip(&self.data.gears.kinds);
            let mut rings = rings.filter(|(_, kind)| **kind == Some(GearKind::Internal));
            rings
                .find_map(|(name, _)| self.data.tools.get(name)?.shaper.as_ref())
                .map(|one| (one.teeth, one.shift))
        };
        let (teeth, shift) = of_strength.or_else(of_tools)?;
        Some(Shaper { teeth, shift: shift.map_or(0.0, Number::get) })
    }

    fn mesh(
        &self,
        toothed: &ToothedSet,
        mesh: usize,
        strength: &'a StrengthEntry,
        data: &PerGearData<'a>,
        shaper: Option<Shaper>,
        viscosity: KinematicViscosity,
    ) -> Result<RatedMesh, Error> {
        let ToothedMesh { gears, pair, module } = toothed.meshes[mesh];
        let places = gears.map(|gear| self.data.place(gear));
        let made = |end: usize| self.gear(gears[end], strength, data, shaper);
        Ok(RatedMesh {
            name: MeshName::of(self.set, gears),
            materials: places.map(|place| data.material(place).to_owned()),
            mesh: Mesh {
                pair,
                module: Length::from_si(module),
                face_width: self.data.common_width(gears).unwrap_or_default(),
                gears: [made(0)?, made(1)?],
                viscosity,
            },
            method: Method {
                planets: if self.set.is_pair() { Some(1) } else { self.set.planet_count() },
                dynamics: self.dynamics(strength, gears)?,
                ..self.method(strength, gears)?
            },
        })
    }

    /// Method of calculation of a mesh, without the number of planets and what follows from the size.
    pub(super) fn method(&self, strength: &'a StrengthEntry, gears: [GearOf; 2]) -> Result<Method, Error> {
        let names = gears.map(|gear| self.data.gears.names[self.data.place(gear)].clone());
        let of_mesh = self.factors_of_mesh(strength, gears, &names);
        let usual = Method::default();
        Ok(Method {
            given: self.all_given(of_mesh, gears.map(|gear| self.factors_of(strength, gear)))?,
            floating: self.data.floating.map_or(Floating::Assumed, floating),
            pitting_allowed: strength.pitting_allowed.unwrap_or(usual.pitting_allowed),
            long_life_factor: strength.long_life_factor.map_or(usual.long_life_factor, Number::get),
            accuracy_grade: strength.accuracy_grade.unwrap_or(usual.accuracy_grade),
            ..usual
        })
    }

    /// Data of a gear beyond its geometry.
    pub(super) fn gear(
        &self,
        gear: GearOf,
        strength: &StrengthEntry,
        data: &PerGearData<'_>,
        shaper: Option<Shaper>,
    ) -> Result<Gear, Error> {
        let place = self.data.place(gear);
        let name = &self.data.gears.names[place];
        let is_ring = self.set.gear_kind(gear) == Some(GearKind::Internal);
        let of_kind = match gear {
            GearOf::Planet(..) => strength.planet_rim,
            GearOf::Central(_) if is_ring => strength.ring_rim,
            GearOf::Central(_) => None,
        };
        let at = self.data.path.clone().key("strength").key("materials");
        let at = if self.data.gears.has_order { at.index(place) } else { at.key(name) };
        let length =
            |values: &[Option<&Quantity<Length>>]| values[place].map_or_else(Length::default, |of| of.0);
        Ok(Gear {
            material: material(self.subject, self.file, &at, data.material(place))?,
            flank_roughness: length(&data.flank_roughness),
            root_roughness: length(&data.root_roughness),
            rim: strength.rims.get(name).copied().or(of_kind).map(|rim| rim.0),
            shaper: shaper.filter(|_| is_ring),
            bending: if self.set.is_idler(gear) { Bending::Reversed } else { Bending::OneWay },
        })
    }

    /// Data from which `K_v`, `K_Hα` and `K_Fα` of a mesh follow by method B; `None` without accuracies.
    fn dynamics(&self, strength: &'a StrengthEntry, gears: [GearOf; 2]) -> Result<Option<Dynamics>, Error> {
        let Some(accuracy) = &strength.accuracy else { return Ok(None) };
        let pitch = self.deviations("pitch_deviations", &accuracy.pitch_deviations)?;
        let profile = self.deviations("profile_deviations", &accuracy.profile_deviations)?;
        let places = gears.map(|gear| self.data.place(gear));
        let planets = self.set.planet_count().unwrap_or(1);
        let arrangement = match gears {
            [_, last] if self.set.gear_kind(last) == Some(GearKind::Internal) => Arrangement::PlanetInRing,
            [GearOf::Central(_), GearOf::Planet(..)] => Arrangement::SunAndPlanets(planets),
            _ => Arrangement::Pair,
        };
        Ok(Some(Dynamics {
            arrangement,
            pitch_deviations: places.map(|place| pitch[place]),
            profile_deviations: places.map(|place| profile[place]),
            tip_relief: accuracy.tip_relief.map(|relief| relief.0),
            rims: places.map(|place| self.data.bores[place]),
            blank_factor: accuracy.blank_factor.map_or(1.0, Number::get),
        }))
    }

    fn deviations(
        &self,
        key: &'static str,
        values: &'a PerGear<Quantity<Length>>,
    ) -> Result<Vec<Length>, Error> {
        let keys = ["strength", "accuracy", key];
        let given = self.given_at(&keys, key, values)?;
        let names = given.iter().zip(&self.data.gears.names);
        if let Some((_, gear)) = names.into_iter().find(|(value, _)| value.is_none()) {
            return Err(self.refused(&keys, &Named("missing-key", format!("`{key}` of {gear} is missing"))));
        }
        Ok(given.into_iter().flatten().map(|value| value.0).collect())
    }

    /// Factors for a gear alone, those of its kind first.
    fn factors_of<'f>(&'f self, strength: &'f StrengthEntry, gear: GearOf) -> Vec<Factors<'f>> {
        let name = &self.data.gears.names[self.data.place(gear)];
        let of_kind = match (gear, self.set.gear_kind(gear)) {
            (GearOf::Planet(..), _) => ("planet_factors", &strength.planet_factors),
            (_, Some(GearKind::Internal)) => ("ring_factors", &strength.ring_factors),
            _ => ("sun_factors", &strength.sun_factors),
        };
        let own = strength.gear_factors.get(name).map(|own| (vec!["gear_factors", name.as_str()], own));
        [(vec![of_kind.0], of_kind.1)].into_iter().chain(own).collect()
    }

    /// Factors for a mesh: those of all meshes, of meshes of its kind, its own.
    fn factors_of_mesh<'f>(
        &'f self,
        strength: &'f StrengthEntry,
        gears: [GearOf; 2],
        names: &[String; 2],
    ) -> Vec<Factors<'f>> {
        let of_kind = match gears {
            [GearOf::Planet(..), GearOf::Planet(..)] => None,
            [_, last] if self.set.gear_kind(last) == Some(GearKind::Internal) => {
                Some(("ring_mesh_factors", &strength.ring_mesh_factors))
            }
            _ => Some(("sun_mesh_factors", &strength.sun_mesh_factors)),
        };
        let of_kind = of_kind.map(|(key, factors)| (vec![key], factors));
        let own = strength.mesh_factors.get_key_value(&names.join("-"));
        let own = own.map(|(name, own)| (vec!["mesh_factors", name.as_str()], own));
        [(vec!["factors"], &strength.factors)].into_iter().chain(of_kind).chain(own).collect()
    }

    fn all_given(&self, of_mesh: Vec<Factors<'_>>, of_gears: [Vec<Factors<'_>>; 2]) -> Result<Given, Error> {
        let mut given = Given::default();
        for (keys, factors) in of_mesh {
            for (name, value) in factors {
                let symbol = factors::symbol(&self.subject.document, &self.strength_path(&keys), name)?;
                given = given.with(symbol, self.checked(&keys, name, symbol, *value)?);
            }
        }
        for (side, of_gear) in Side::BOTH.into_iter().zip(of_gears) {
            for (keys, factors) in of_gear {
                for (name, value) in factors {
                    let symbol = factors::symbol(&self.subject.document, &self.strength_path(&keys), name)?;
                    if symbol.is_of_mesh() {
                        let message = format!(
                            "{symbol} is of a mesh: it stands in `factors`, `sun_mesh_factors`, `ring_mesh_factors` or `mesh_factors`"
                        );
                        let path = self.strength_path(&keys);
                        let why = Named("factor-of-a-mesh", message);
                        return Err(refused(&self.subject.document, &path, &[name], &why));
                    }
                    given = given.with_of(side, symbol, self.checked(&keys, name, symbol, *value)?);
                }
            }
        }
        Ok(given)
    }

    fn checked(&self, keys: &[&str], name: &str, symbol: Symbol, value: Number) -> Result<f64, Error> {
        symbol
            .checked(value.get())
            .map_err(|error| refused(&self.subject.document, &self.strength_path(keys), &[name], &error))
    }

    fn strength_path(&self, keys: &[&str]) -> Path {
        keys.iter().fold(self.data.path.clone().key("strength"), |path, key| path.key(*key))
    }

    fn refused(&self, keys: &[&str], why: &dyn Fault) -> Error {
        refused(&self.subject.document, &self.data.path, keys, why)
    }
}
