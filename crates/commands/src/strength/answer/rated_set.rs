//! Meshes of the sets of a file, with all data that their strength needs.

use super::factors;
use super::materials::{check_materials, floating, material};
use super::names::MeshName;
use super::records::{NotRated, Reason};
use super::spans::check_spans;
use crate::error::Error;
use crate::shared::gearbox::Gearbox;
use crate::shared::toothed::{lacking, toothed};
use epicyclic_formats::gearbox::{GearboxFile, PerGear, SetData, StrengthEntry};
use epicyclic_formats::{Faults, Path};
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
    /// The gears with their teeth, in mesh; modules in metres.
    pub(crate) toothed: ToothedSet,
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
    check_factors(subject, file)?;
    check_spans(&subject.document, file)?;
    let (mut all, mut not_rated) = (vec![], vec![]);
    for (place, set) in subject.train.sets().iter().enumerate() {
        let Some(data) = file.set_data(set) else { continue };
        let of = Of { subject, file, set, data };
        match of.meshes()? {
            Ok((toothed, meshes)) => {
                let path = of.data.path.clone();
                all.push(RatedSet { place, set, id: set.id(), path, toothed, meshes });
            }
            Err(row) => not_rated.push(row),
        }
    }
    Ok((all, not_rated))
}

/// Refuses wrong names and values under the keys of factors, of all sets at once.
pub(super) fn check_factors(subject: &Gearbox, file: &GearboxFile) -> Result<(), Error> {
    let mut faults = Faults::default();
    for set in subject.train.sets() {
        let Some(data) = file.set_data(set) else { continue };
        let meshes: Vec<[String; 2]> = (0..set.meshes().len())
            .map(|mesh| set.gears_of_mesh(mesh).map(|gear| data.gears.names[data.place(gear)].clone()))
            .collect();
        let kind = |gear: &GearOf| match (gear, set.gear_kind(*gear)) {
            (GearOf::Planet(..), _) => Some("planet"),
            (_, Some(GearKind::Internal)) => Some("ring"),
            // A gear of a pair is no sun.
            (_, Some(GearKind::External)) if !set.is_pair() => Some("sun"),
            _ => None,
        };
        let kinds: Vec<&str> = data.of.iter().filter_map(kind).collect();
        let named =
            factors::Named { set: set.id(), gears: &data.gears.names, meshes: &meshes, kinds: &kinds };
        named.check(&subject.document, &data.path.clone().key("strength"), &mut faults);
    }
    if faults.is_empty() { Ok(()) } else { Err(faults.placed(&subject.document, &Path::root()).into()) }
}

/// Prepared part, or why the set is not rated.
type Made<T> = Result<Result<T, NotRated>, Error>;

/// Factors by their symbols.
type Factors<'f> = &'f BTreeMap<String, Number>;

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
    fn meshes(&self) -> Made<(ToothedSet, Vec<RatedMesh>)> {
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
            let per_gear = self.per_gear(strength);
            let lacks = self.lacks(&per_gear);
            if !lacks.is_empty() {
                return Ok(Err(missing(lacks)));
            }
            let meshes = (0..toothed.meshes.len())
                .map(|mesh| self.mesh(toothed, mesh, strength, &per_gear, shaper, viscosity));
            return Ok(Ok((toothed.clone(), meshes.collect::<Result<_, _>>()?)));
        }
        let key = toothed.as_ref().err().copied().unwrap_or_default();
        // Where some gears have a width of their own, those of the others are named.
        let is_any = data.face_widths.iter().any(Option::is_some);
        let widths =
            data.gears.names.iter().zip(&data.face_widths).filter(|(_, width)| is_any && width.is_none());
        let widths = widths.map(|(gear, _)| format!("face_widths.{gear}"));
        let known = [
            (key, toothed.is_ok()),
            ("planets", has_planets),
            ("module", data.modules.iter().any(Option::is_some)),
            ("face_width", has_widths || is_any),
            ("strength", strength.is_some()),
            ("strength.shaper", !has_ring || strength.is_none() || shaper.is_some()),
            ("oil", viscosity.is_some()),
        ];
        Ok(Err(missing(lacking(&known).into_iter().chain(widths).collect())))
    }

    pub(super) fn per_gear(&self, strength: &'a StrengthEntry) -> PerGearData<'a> {
        PerGearData {
            materials: self.data.of_gears(&strength.materials),
            flank_roughness: self.data.of_gears(&strength.flank_roughness),
            root_roughness: self.data.of_gears(&strength.root_roughness),
        }
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
                dynamics: self.dynamics(strength, gears),
                ..self.method(strength, gears)
            },
        })
    }

    /// Method of calculation of a mesh, without the number of planets and what follows from the size.
    pub(super) fn method(&self, strength: &'a StrengthEntry, gears: [GearOf; 2]) -> Method {
        let names = gears.map(|gear| self.data.gears.names[self.data.place(gear)].clone());
        let of_mesh = self.factors_of_mesh(strength, gears, &names);
        let usual = Method::default();
        Method {
            given: all_given(of_mesh, gears.map(|gear| self.factors_of(strength, gear))),
            floating: self.data.floating.map_or(Floating::Assumed, floating),
            pitting_allowed: strength.pitting_allowed.unwrap_or(usual.pitting_allowed),
            long_life_factor: strength.long_life_factor.map_or(usual.long_life_factor, Number::get),
            accuracy_grade: strength.accuracy_grade.unwrap_or(usual.accuracy_grade),
            ..usual
        }
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
    fn dynamics(&self, strength: &StrengthEntry, gears: [GearOf; 2]) -> Option<Dynamics> {
        let accuracy = strength.accuracy.as_ref()?;
        let deviations = |values: &PerGear<Quantity<Length>>| {
            let given = self.data.of_gears(values);
            gears.map(|gear| given[self.data.place(gear)].map_or_else(Length::default, |value| value.0))
        };
        let places = gears.map(|gear| self.data.place(gear));
        let planets = self.set.planet_count().unwrap_or(1);
        let arrangement = match gears {
            [_, last] if self.set.gear_kind(last) == Some(GearKind::Internal) => Arrangement::PlanetInRing,
            [GearOf::Central(_), GearOf::Planet(..)] => Arrangement::SunAndPlanets(planets),
            _ => Arrangement::Pair,
        };
        Some(Dynamics {
            arrangement,
            pitch_deviations: deviations(&accuracy.pitch_deviations),
            profile_deviations: deviations(&accuracy.profile_deviations),
            tip_relief: accuracy.tip_relief.map(|relief| relief.0),
            rims: places.map(|place| self.data.bores[place]),
            blank_factor: accuracy.blank_factor.map_or(1.0, Number::get),
        })
    }

    /// Factors for a gear alone, those of its kind first.
    fn factors_of<'f>(&'f self, strength: &'f StrengthEntry, gear: GearOf) -> Vec<Factors<'f>> {
        let name = &self.data.gears.names[self.data.place(gear)];
        let of_kind = match (gear, self.set.gear_kind(gear)) {
            (GearOf::Planet(..), _) => &strength.planet_factors,
            (_, Some(GearKind::Internal)) => &strength.ring_factors,
            _ => &strength.sun_factors,
        };
        [of_kind].into_iter().chain(strength.gear_factors.get(name)).collect()
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
                Some(&strength.ring_mesh_factors)
            }
            _ => Some(&strength.sun_mesh_factors),
        };
        let own = [names.join("-"), factors::reversed(names)];
        let own = own.iter().find_map(|name| strength.mesh_factors.get(name));
        [&strength.factors].into_iter().chain(of_kind).chain(own).collect()
    }
}

/// Factors of a mesh and of its gears; those of wrong names are refused before.
fn all_given(of_mesh: Vec<Factors<'_>>, of_gears: [Vec<Factors<'_>>; 2]) -> Given {
    let named = |factors: Vec<Factors<'_>>| {
        let factors = factors.into_iter().flatten();
        factors.filter_map(|(name, value)| Some((Symbol::named(name)?, value.get()))).collect::<Vec<_>>()
    };
    let given =
        named(of_mesh).into_iter().fold(Given::default(), |given, (symbol, value)| given.with(symbol, value));
    Side::BOTH.into_iter().zip(of_gears).fold(given, |given, (side, own)| {
        named(own).into_iter().fold(given, |given, (symbol, value)| given.with_of(side, symbol, value))
    })
}
