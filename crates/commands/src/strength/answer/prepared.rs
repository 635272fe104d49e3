//! Sets of a file with all data that their strength needs but their size.

use super::materials::check_materials;
use super::rated_set::{Of, check_factors};
use super::records::{NotRated, Reason};
use super::spans::check_spans;
use crate::error::Error;
use crate::shared::gearbox::Gearbox;
use crate::shared::toothed::lacking;
use epicyclic_formats::gearbox::{GearboxFile, SetData};
use epicyclic_gears::ToothCount;
use epicyclic_gears::geometry::GearKind;
use epicyclic_strength::factor::{Side, Symbol};
use epicyclic_strength::mesh::{Gear, Method};
use epicyclic_train::PlanetSet;
use epicyclic_train::planet_set::GearOf;
use uom::si::f64::KinematicViscosity;

/// Set with all data that its strength needs except its size.
pub(crate) struct SetToSize<'g> {
    /// Index of the set in the gearbox.
    pub(crate) place: usize,
    /// The set.
    pub(crate) set: &'g PlanetSet,
    /// Data of the file for it.
    pub(crate) data: SetData<'g>,
    /// Tooth numbers of its gears, in the order of the data.
    pub(crate) teeth: Vec<ToothCount>,
    /// Materials of its gears by name.
    pub(crate) materials: Vec<String>,
    /// Materials, roughness and tools of the gears.
    pub(crate) gears: Vec<Gear>,
    /// Methods of its meshes.
    pub(crate) methods: Vec<Method>,
    pub(crate) viscosity: KinematicViscosity,
}

/// Sets that can be sized, and reasons why others cannot.
pub(crate) fn sets_to_size<'g>(
    subject: &'g Gearbox,
    file: &'g GearboxFile,
) -> Result<(Vec<SetToSize<'g>>, Vec<NotRated>), Error> {
    check_materials(&subject.document, file)?;
    check_factors(subject, file)?;
    check_spans(&subject.document, file)?;
    let (mut all, mut not_rated) = (vec![], vec![]);
    for (place, set) in subject.train.sets().iter().enumerate() {
        let Some(data) = file.set_data(set) else { continue };
        let with_central = |planet: usize| {
            set.meshes().iter().any(|mesh| {
                let is_own = |gear: &GearOf| matches!(gear, GearOf::Planet(of, _) if *of == planet);
                mesh.gears.iter().any(is_own)
                    && mesh.gears.iter().any(|gear| matches!(gear, GearOf::Central(_)))
            })
        };
        if data.of.iter().any(|gear| set.gear_kind(*gear).is_none()) {
            not_rated.push(NotRated::new(set.id(), Reason::Bevel));
        } else if !(0..set.planets().len()).all(with_central) {
            not_rated.push(NotRated::new(set.id(), Reason::PlanetAlone));
        } else {
            let of = Of { subject, file, set, data };
            match of.into_sized(place)? {
                Ok(one) => all.push(one),
                Err(missing) => {
                    not_rated.push(NotRated { missing, ..NotRated::new(set.id(), Reason::KeysMissing) });
                }
            }
        }
    }
    Ok((all, not_rated))
}

impl<'a> Of<'a> {
    /// Data of the set without its size, or the keys that are missing.
    fn into_sized(self, place: usize) -> Result<Result<SetToSize<'a>, Vec<String>>, Error> {
        let (set, strength) = (self.set, self.data.strength);
        let shaper = self.shaper();
        let viscosity = self.file.oil.as_ref().map(|oil| oil.viscosity.0);
        let methods: Option<Vec<Method>> = strength.map(|strength| {
            (0..set.meshes().len()).map(|mesh| self.method(strength, set.gears_of_mesh(mesh))).collect()
        });
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
        let whole = |gear: &GearOf| {
            let teeth = set.teeth_or_coaxial(*gear).filter(|teeth| teeth.fract() == 0.0 && *teeth >= 1.0)?;
            ToothCount::new(teeth as u32).ok()
        };
        let teeth: Vec<Option<ToothCount>> = self.data.of.iter().map(whole).collect();
        let is_planet = |gear: &GearOf| matches!(gear, GearOf::Planet(..));
        let has_teeth = |planets: bool| {
            let own = self.data.of.iter().zip(&teeth).filter(|(gear, _)| is_planet(gear) == planets);
            own.into_iter().all(|(_, teeth)| teeth.is_some())
        };
        let has_ring = self.data.of.iter().any(|gear| set.gear_kind(*gear) == Some(GearKind::Internal));
        let of_planets = if set.short().is_some() { "planet_teeth" } else { "planet_gears" };
        let known = [
            ("teeth", has_teeth(false)),
            (of_planets, has_teeth(true)),
            ("strength", strength.is_some()),
            ("strength.shaper", strength.is_none() || !has_ring || shaper.is_some()),
            ("oil", viscosity.is_some()),
        ];
        let missing = lacking(&[&known[..], &factors].concat());
        let (Some(strength), Some(methods), Some(viscosity), true) =
            (strength, methods, viscosity, missing.is_empty())
        else {
            return Ok(Err(missing));
        };
        let per_gear = self.per_gear(strength);
        let lacks = self.lacks(&per_gear);
        if !lacks.is_empty() {
            return Ok(Err(lacks));
        }
        let gear = |gear: &GearOf| self.gear(*gear, strength, &per_gear, shaper);
        let gears = self.data.of.iter().map(gear).collect::<Result<_, _>>()?;
        let materials = (0..self.data.of.len()).map(|gear| per_gear.material(gear).to_owned()).collect();
        Ok(Ok(SetToSize {
            place,
            set,
            data: self.data,
            teeth: teeth.into_iter().flatten().collect(),
            materials,
            gears,
            methods,
            viscosity,
        }))
    }
}
