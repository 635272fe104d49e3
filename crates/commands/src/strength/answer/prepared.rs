//! Meshes of a file's sets, for sets with all data that their strength needs.

use super::factors;
use super::place::refused;
use super::records::{NotRated, Reason};
use crate::error::Error;
use crate::shared::fault::{Fault as Refusal, Named};
use crate::shared::gearbox::Gearbox;
use crate::shared::toothed;
use epicyclic_formats::gearbox::{
    AccuracyEntry, FloatingEntry, GearboxFile, MaterialClass, MaterialEntry, SetEntry, StrengthEntry,
};
use epicyclic_formats::{Document, Path};
use epicyclic_gears::ToothCount;
use epicyclic_gears::involute::profile::Profiles;
use epicyclic_gears::involute::{InvoluteGear, PlanetSet};
use epicyclic_gears::mesh::coaxial_planet;
use epicyclic_strength::factor::{Given, Side, Symbol};
use epicyclic_strength::load::{Arrangement, Dynamics, Floating};
use epicyclic_strength::material::{self, Class, Material};
use epicyclic_strength::mesh::{Gear, Mesh, Method};
use epicyclic_strength::root::factors::Bending;
use epicyclic_strength::root::section::Shaper;
use epicyclic_train::set::{Gearing, SetSpec, Shifts};
use epicyclic_units::Number;
use std::collections::BTreeMap;
use uom::si::f64::{Angle, KinematicViscosity, Length};

/// Simple set with all data that its strength needs.
pub(crate) struct RatedSet<'g> {
    /// Index of the set in the gearbox.
    pub(crate) place: usize,
    /// Name of the set.
    pub(crate) id: &'g str,
    /// Path of the set in the file.
    pub(crate) path: Path,
    /// Materials of sun, planets and ring by name.
    pub(crate) materials: &'g [String; 3],
    /// Tooth numbers of sun and planets.
    pub(crate) teeth: [ToothCount; 2],
    pub(crate) planets: u32,
    /// Meshes of sun and planets, of planets and ring.
    pub(crate) meshes: [Mesh; 2],
    pub(crate) methods: [Method; 2],
}

impl RatedSet<'_> {
    /// Whether the teeth are helical.
    pub(crate) fn is_helical(&self) -> bool {
        self.meshes[0].pair.gears()[0].profile().is_helical()
    }

    /// Whether `K_γ` of both meshes is given.
    pub(crate) fn has_load_sharing(&self) -> bool {
        self.methods.iter().all(|method| method.given.of(Side::First, Symbol::LoadSharing).is_some())
    }
}

/// Simple set with all data that its strength needs except its size.
pub(crate) struct SetToSize<'g> {
    /// Index of the set in the gearbox.
    pub(crate) place: usize,
    /// Name of the set.
    pub(crate) id: &'g str,
    /// Path of the set in the file.
    pub(crate) path: Path,
    /// Entry of the set in the file.
    pub(crate) entry: &'g SetEntry,
    /// Materials of sun, planets and ring by name.
    pub(crate) materials: &'g [String; 3],
    /// Tooth numbers of sun, planets and ring.
    pub(crate) teeth: [ToothCount; 3],
    /// Number of planets that the file gives.
    pub(crate) planets: Option<u32>,
    /// Least angle between neighbouring planets; `None` unless the file gives their spacing.
    pub(crate) least_planet_angle: Option<Angle>,
    /// Profile shifts that the file gives.
    pub(crate) shifts: Option<Shifts>,
    pub(crate) profiles: Profiles,
    pub(crate) gears: [Gear; 3],
    pub(crate) methods: [Method; 2],
    pub(crate) viscosity: KinematicViscosity,
}

/// Sets that can be rated, and reasons why others cannot.
pub(crate) fn sets<'g>(
    subject: &'g Gearbox,
    file: &'g GearboxFile,
) -> Result<(Vec<RatedSet<'g>>, Vec<NotRated>), Error> {
    each(subject, file, |of, place, id| match of.known()? {
        Ok(known) => Ok(Ok(of.set(place, id, &known)?)),
        Err(missing) => Ok(Err(missing)),
    })
}

/// Sets that can be sized, and reasons why others cannot.
pub(crate) fn sets_to_size<'g>(
    subject: &'g Gearbox,
    file: &'g GearboxFile,
) -> Result<(Vec<SetToSize<'g>>, Vec<NotRated>), Error> {
    each(subject, file, Of::to_size)
}

/// Prepared set, or the keys that it lacks.
type Made<T> = Result<Result<T, Vec<String>>, Error>;

/// Prepares each simple set of the file with a function, and gives reasons why others are left out.
fn each<'g, T>(
    subject: &'g Gearbox,
    file: &'g GearboxFile,
    made: impl Fn(&Of<'g>, usize, &'g str) -> Made<T>,
) -> Result<(Vec<T>, Vec<NotRated>), Error> {
    check_materials(&subject.document, file)?;
    let (mut all, mut not_rated) = (vec![], vec![]);
    for (place, (set, simple)) in toothed::simple_sets(subject, file).enumerate() {
        let Some((path, entry, spec)) = simple else {
            not_rated.push(NotRated::new(set.id(), Reason::NotSimple));
            continue;
        };
        factors::check(&subject.document, &path.clone().key("strength"))?;
        let of = Of { subject, file, entry, spec, path };
        match made(&of, place, set.id())? {
            Ok(one) => all.push(one),
            Err(missing) => {
                not_rated.push(NotRated { missing, ..NotRated::new(set.id(), Reason::KeysMissing) });
            }
        }
    }
    Ok((all, not_rated))
}

/// Set of the file.
struct Of<'a> {
    subject: &'a Gearbox,
    file: &'a GearboxFile,
    entry: &'a SetEntry,
    spec: &'a SetSpec,
    path: Path,
}

/// Factors given for a mesh or a gear, and their key.
type Factors<'f> = (&'f str, &'f BTreeMap<String, Number>);

/// Data of a set that every rating needs.
struct Known<'a> {
    gears: PlanetSet,
    planets: u32,
    module: Length,
    face_width: Length,
    strength: &'a StrengthEntry,
    shaper: Shaper,
    viscosity: KinematicViscosity,
}

impl<'a> Of<'a> {
    /// Data of the set, or the keys that are missing.
    fn known(&self) -> Made<Known<'a>> {
        let entry = self.entry;
        let gears = toothed::gears(self.subject, &self.path, self.spec)?;
        let strength = entry.strength.as_ref();
        let shaper = self.shaper();
        let viscosity = self.file.oil.as_ref().map(|oil| oil.viscosity.0);
        if let (
            Some(gears),
            Some(planets),
            Some(module),
            Some(face_width),
            Some(strength),
            Some(shaper),
            Some(viscosity),
        ) = (gears, self.spec.planet_count, entry.module, entry.face_width, strength, shaper, viscosity)
        {
            let (module, face_width) = (module.0, face_width.0);
            return Ok(Ok(Known { gears, planets, module, face_width, strength, shaper, viscosity }));
        }
        let known = [
            (toothed::missing_teeth(entry), gears.is_some()),
            ("planets", self.spec.planet_count.is_some()),
            ("module", entry.module.is_some()),
            ("face_width", entry.face_width.is_some()),
            ("strength", strength.is_some()),
            ("strength.shaper", strength.is_none() || shaper.is_some()),
            ("oil", viscosity.is_some()),
        ];
        Ok(Err(toothed::lacking(&known)))
    }

    fn set(&self, place: usize, id: &'a str, known: &Known<'a>) -> Result<RatedSet<'a>, Error> {
        let Known { strength, module, face_width, viscosity, .. } = *known;
        let [sun, planet, ring] = self.gears(strength, known.shaper)?;
        let mesh = |pair, gears| Mesh { pair, module, face_width, gears, viscosity };
        let mut methods = self.methods(strength)?;
        if let Some(accuracy) = &strength.accuracy {
            let dynamics = self.dynamics(accuracy, known.planets);
            methods = [0, 1].map(|mesh| Method { dynamics: Some(dynamics[mesh]), ..methods[mesh] });
        }
        let [sun_teeth, planet_teeth, _] = known.gears.gears().map(InvoluteGear::teeth);
        Ok(RatedSet {
            place,
            id,
            path: self.path.clone(),
            materials: &strength.materials,
            teeth: [sun_teeth, planet_teeth],
            planets: known.planets,
            meshes: [
                mesh(*known.gears.sun_mesh(), [sun, planet]),
                mesh(*known.gears.ring_mesh(), [planet, ring]),
            ],
            methods: methods.map(|method| Method { planets: Some(known.planets), ..method }),
        })
    }

    /// Shaper for the standard's formulas of the ring: from the set's strength, otherwise from its tools.
    fn shaper(&self) -> Option<Shaper> {
        let ring = self.entry.tools.as_ref().and_then(|tools| tools.ring.as_ref());
        let of_tools = ring.and_then(|ring| ring.shaper.as_ref()).map(|one| (one.teeth, one.shift));
        let of_strength = self.entry.strength.as_ref().and_then(|strength| strength.shaper.as_ref());
        let (teeth, shift) = of_strength.map(|one| (one.teeth, one.shift)).or(of_tools)?;
        Some(Shaper { teeth, shift: shift.map_or(0.0, Number::get) })
    }

    /// Data of sun, planets and ring beyond their geometry.
    fn gears(&self, strength: &StrengthEntry, shaper: Shaper) -> Result<[Gear; 3], Error> {
        let material = |of| self.material(of, &strength.materials[of]);
        let materials = [material(0)?, material(1)?, material(2)?];
        let gear = |of: usize, bending, rim: Option<Length>, shaper| Gear {
            material: materials[of],
            flank_roughness: strength.flank_roughness[of].0,
            root_roughness: strength.root_roughness[of].0,
            rim,
            shaper,
            bending,
        };
        Ok([
            gear(0, Bending::OneWay, None, None),
            gear(1, Bending::Reversed, strength.planet_rim.map(|rim| rim.0), None),
            gear(2, Bending::OneWay, strength.ring_rim.map(|rim| rim.0), Some(shaper)),
        ])
    }

    /// Methods of calculation of both meshes, without the number of planets and values that follow from the
    /// size.
    fn methods(&self, strength: &StrengthEntry) -> Result<[Method; 2], Error> {
        let usual = Method::default();
        let method = Method {
            pitting_allowed: strength.pitting_allowed.unwrap_or(usual.pitting_allowed),
            long_life_factor: strength.long_life_factor.map_or(usual.long_life_factor, Number::get),
            accuracy_grade: strength.accuracy_grade.unwrap_or(usual.accuracy_grade),
            floating: floating(self.entry),
            ..usual
        };
        let common = ("factors", &strength.factors);
        let sun = ("sun_factors", &strength.sun_factors);
        let planet = ("planet_factors", &strength.planet_factors);
        let ring = ("ring_factors", &strength.ring_factors);
        let sun_mesh = [common, ("sun_mesh_factors", &strength.sun_mesh_factors)];
        let ring_mesh = [common, ("ring_mesh_factors", &strength.ring_mesh_factors)];
        Ok([
            Method { given: self.given(sun_mesh, [sun, planet])?, ..method },
            Method { given: self.given(ring_mesh, [planet, ring])?, ..method },
        ])
    }

    /// Data from which `K_v`, `K_Hα` and `K_Fα` of both meshes follow by method B.
    fn dynamics(&self, accuracy: &AccuracyEntry, planets: u32) -> [Dynamics; 2] {
        let pitch = accuracy.pitch_deviations.map(|deviation| deviation.0);
        let profile = accuracy.profile_deviations.map(|deviation| deviation.0);
        let sun_bore = accuracy.sun_bore.map(|bore| bore.0);
        let planet_bore = self.entry.planet_bore.map(|bore| bore.0);
        let mesh = |first: usize, arrangement, rims| Dynamics {
            arrangement,
            pitch_deviations: [pitch[first], pitch[first + 1]],
            profile_deviations: [profile[first], profile[first + 1]],
            tip_relief: accuracy.tip_relief.map(|relief| relief.0),
            rims,
            blank_factor: accuracy.blank_factor.map_or(1.0, Number::get),
        };
        [
            mesh(0, Arrangement::SunAndPlanets(planets), [sun_bore, planet_bore]),
            mesh(1, Arrangement::PlanetInRing, [planet_bore, None]),
        ]
    }

    /// Data of the set without its size.
    fn to_size(&self, place: usize, id: &'a str) -> Made<SetToSize<'a>> {
        let strength = self.entry.strength.as_ref();
        let shaper = self.shaper();
        let viscosity = self.file.oil.as_ref().map(|oil| oil.viscosity.0);
        let planet = self.spec.planet.or_else(|| self.coaxial_planet());
        let methods = strength.map(|strength| self.methods(strength)).transpose()?;
        // Allowed tooth deviations hold for one size, so they cannot replace given factors here.
        let is_given = |symbol| {
            strength.is_none_or(|strength| strength.accuracy.is_none())
                || methods.iter().flatten().all(|method| method.given.of(Side::First, symbol).is_some())
        };
        let factors = [
            ("strength.factors.K_v", Symbol::Dynamic),
            ("strength.factors.K_H_alpha", Symbol::TransverseContact),
            ("strength.factors.K_F_alpha", Symbol::TransverseRoot),
        ]
        .map(|(key, symbol)| (key, is_given(symbol)));
        if let (
            Gearing::Teeth(sun, ring),
            Some(planet),
            Some(strength),
            Some(shaper),
            Some(viscosity),
            Some(methods),
            true,
        ) = (
            self.spec.gearing,
            planet,
            strength,
            shaper,
            viscosity,
            methods,
            factors.iter().all(|(_, is_given)| *is_given),
        ) {
            return Ok(Ok(SetToSize {
                place,
                id,
                path: self.path.clone(),
                entry: self.entry,
                teeth: [sun, planet, ring],
                planets: self.spec.planet_count,
                least_planet_angle: self.subject.train.sets()[place].least_planet_angle(),
                shifts: self.spec.shifts,
                profiles: self.spec.profiles(&self.subject.rack),
                materials: &strength.materials,
                gears: self.gears(strength, shaper)?,
                methods,
                viscosity,
            }));
        }
        let known = [
            ("teeth", matches!(self.spec.gearing, Gearing::Teeth(..))),
            ("planet_teeth", planet.is_some()),
            ("strength", strength.is_some()),
            ("strength.shaper", strength.is_none() || shaper.is_some()),
            ("oil", viscosity.is_some()),
        ];
        Ok(Err(toothed::lacking(&[&known[..], &factors].concat())))
    }

    /// Planet that satisfies equal centre distances without profile shift; `None` if it has no whole tooth
    /// number.
    fn coaxial_planet(&self) -> Option<ToothCount> {
        let Gearing::Teeth(sun, ring) = self.spec.gearing else { return None };
        let planet = coaxial_planet(sun, ring);
        (planet >= 1.0 && planet.fract() == 0.0).then(|| ToothCount::new(planet as u32).ok())?
    }

    /// Factors given for a mesh: those of both meshes, of this mesh, and of its gears alone.
    fn given(&self, of_mesh: [Factors<'_>; 2], of_gears: [Factors<'_>; 2]) -> Result<Given, Error> {
        let mut given = Given::default();
        for (key, factors) in of_mesh {
            for (name, value) in factors {
                let symbol = self.symbol(key, name)?;
                given = given.with(symbol, self.checked(key, name, symbol, *value)?);
            }
        }
        for (side, (key, factors)) in Side::BOTH.into_iter().zip(of_gears) {
            for (name, value) in factors {
                let symbol = self.symbol(key, name)?;
                if symbol.is_of_mesh() {
                    let message = format!(
                        "{symbol} is of a mesh: it stands in `factors`, `sun_mesh_factors` or `ring_mesh_factors`"
                    );
                    return Err(self.refused(&["strength", key, name], &Named("factor-of-a-mesh", message)));
                }
                given = given.with_of(side, symbol, self.checked(key, name, symbol, *value)?);
            }
        }
        Ok(given)
    }

    fn checked(&self, key: &str, name: &str, symbol: Symbol, value: Number) -> Result<f64, Error> {
        symbol.checked(value.get()).map_err(|error| self.refused(&["strength", key, name], &error))
    }

    fn symbol(&self, key: &str, name: &str) -> Result<Symbol, Error> {
        factors::symbol(&self.subject.document, &self.path.clone().key("strength").key(key), name)
    }

    fn material(&self, of: usize, name: &str) -> Result<Material, Error> {
        if let Some(own) = self.file.materials.iter().find(|own| own.name == name) {
            return Ok(of_entry(own));
        }
        material::listed(name).map(|listed| listed.material).ok_or_else(|| {
            let listed = material::all().into_iter().map(|listed| listed.designation);
            let all: Vec<&str> = self.file.materials.iter().map(|own| own.name.as_str()).chain(listed).collect();
            let message = format!(
                "no material is called `{name}`; there are {}, and those that `materials` of the gearbox states",
                all.join(", ")
            );
            let place = self.path.clone().key("strength").key("materials").index(of);
            refused(&self.subject.document, &place, &[], &Named("no-material", message))
        })
    }

    fn refused(&self, keys: &[&str], why: &dyn Refusal) -> Error {
        refused(&self.subject.document, &self.path, keys, why)
    }
}

/// Whether a member of a set floats, according to its entry.
pub(crate) fn floating(entry: &SetEntry) -> Floating {
    match entry.floating {
        None => Floating::Assumed,
        Some(FloatingEntry::None) => Floating::No,
        Some(FloatingEntry::Sun | FloatingEntry::Ring | FloatingEntry::Carrier) => Floating::Yes,
    }
}

/// Value of `K_γ` in an entry: that of the mesh of sun and planets, then that of both meshes, in any spelling
/// of its symbol.
pub(crate) fn given_sharing(entry: &SetEntry) -> Option<f64> {
    let strength = entry.strength.as_ref()?;
    let all = strength.sun_mesh_factors.iter().chain(&strength.factors);
    let own = |(name, value): (&String, &Number)| {
        (Symbol::named(name) == Some(Symbol::LoadSharing)).then(|| value.get())
    };
    all.filter_map(own).next()
}

/// Refuses materials of equal name, and cast iron without its modulus.
fn check_materials(document: &Document, file: &GearboxFile) -> Result<(), Error> {
    for (place, own) in file.materials.iter().enumerate() {
        let path = Path::root().key("materials").index(place);
        let is_iron = matches!(
            own.class,
            MaterialClass::GreyIron
                | MaterialClass::NodularPearlitic
                | MaterialClass::NodularFerritic
                | MaterialClass::Malleable
        );
        let is_known = material::listed(&own.name).is_some();
        if is_known || file.materials[..place].iter().any(|other| other.name == own.name) {
            let message = format!("there is a material `{}`; this one needs another name", own.name);
            return Err(refused(document, &path, &["name"], &Named("duplicate", message)));
        }
        if is_iron && own.youngs_modulus.is_none() {
            let message = format!("material `{}`: cast iron needs its `youngs_modulus`", own.name);
            return Err(refused(document, &path, &["class"], &Named("no-youngs-modulus", message)));
        }
        of_entry(own).check().map_err(|error| refused(document, &path, &[], &error))?;
    }
    Ok(())
}

fn of_entry(own: &MaterialEntry) -> Material {
    let class = match own.class {
        MaterialClass::Structural => Class::Structural,
        MaterialClass::ThroughHardened => Class::ThroughHardened,
        MaterialClass::GreyIron => Class::GreyIron,
        MaterialClass::NodularPearlitic => Class::NodularPearlitic,
        MaterialClass::NodularFerritic => Class::NodularFerritic,
        MaterialClass::Malleable => Class::Malleable,
        MaterialClass::CaseHardened => Class::CaseHardened,
        MaterialClass::SurfaceHardened => Class::SurfaceHardened,
        MaterialClass::Nitrided => Class::Nitrided,
        MaterialClass::ThroughHardenedNitrided => Class::ThroughHardenedNitrided,
        MaterialClass::Nitrocarburized => Class::Nitrocarburized,
    };
    let steel = Material::steel(class, own.contact_limit.0, own.root_limit.0);
    Material {
        hardness: own.hardness.map(Number::get),
        strength: own.strength.map(|strength| strength.0),
        youngs_modulus: own.youngs_modulus.map_or(steel.youngs_modulus, |modulus| modulus.0),
        ..steel
    }
}
