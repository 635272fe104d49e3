//! Simple sets of a file with all data that their strength needs but their size.

use super::materials::check_materials;
use super::rated_set::{Of, check_factors};
use super::records::{NotRated, Reason};
use crate::error::Error;
use crate::shared::gearbox::Gearbox;
use crate::shared::toothed::lacking;
use epicyclic_formats::Path;
use epicyclic_formats::gearbox::{GearboxFile, SetEntry};
use epicyclic_gears::ToothCount;
use epicyclic_gears::involute::profile::Profiles;
use epicyclic_gears::mesh::coaxial_planet;
use epicyclic_strength::factor::{Side, Symbol};
use epicyclic_strength::mesh::{Gear, Method};
use epicyclic_train::planet_set::GearOf;
use epicyclic_train::set::{Gearing, SetKind, SetSpec, Shifts};
use uom::si::f64::{Angle, KinematicViscosity};

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
    pub(crate) materials: [String; 3],
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

/// Sun, planets and ring.
const GEARS: [GearOf; 3] = [GearOf::Central(0), GearOf::Planet(0, 0), GearOf::Central(1)];

/// Sets that can be sized, and reasons why others cannot.
pub(crate) fn sets_to_size<'g>(
    subject: &'g Gearbox,
    file: &'g GearboxFile,
) -> Result<(Vec<SetToSize<'g>>, Vec<NotRated>), Error> {
    check_materials(&subject.document, file)?;
    check_factors(subject, file)?;
    let (mut all, mut not_rated) = (vec![], vec![]);
    for (place, set) in subject.train.sets().iter().enumerate() {
        let entry = file.sets.iter().find(|entry| entry.id == set.id());
        let spec = set.short().filter(|spec| spec.kind == SetKind::Simple);
        let (Some(entry), Some(spec), Some(data)) = (entry, spec, file.set_data(set)) else {
            not_rated.push(NotRated::new(set.id(), Reason::NotSimple));
            continue;
        };
        let of = Of { subject, file, set, data };
        match of.to_size(place, entry, spec)? {
            Ok(one) => all.push(one),
            Err(missing) => {
                not_rated.push(NotRated { missing, ..NotRated::new(set.id(), Reason::KeysMissing) });
            }
        }
    }
    Ok((all, not_rated))
}

impl<'a> Of<'a> {
    /// Data of the set without its size, or the keys that are missing.
    fn to_size(
        &self,
        place: usize,
        entry: &'a SetEntry,
        spec: &'a SetSpec,
    ) -> Result<Result<SetToSize<'a>, Vec<String>>, Error> {
        let strength = self.data.strength;
        let shaper = self.shaper();
        let viscosity = self.file.oil.as_ref().map(|oil| oil.viscosity.0);
        let planet = spec.planet.or_else(|| coaxial(spec));
        let methods = strength.map(|strength| {
            [0, 1].map(|first: usize| self.method(strength, [GEARS[first], GEARS[first + 1]]))
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
        if let (
            Gearing::Teeth(sun, ring),
            Some(planet),
            Some(strength),
            Some(shaper),
            Some(viscosity),
            Some(methods),
            true,
        ) = (
            spec.gearing,
            planet,
            strength,
            shaper,
            viscosity,
            methods,
            factors.iter().all(|(_, is_given)| *is_given),
        ) {
            let per_gear = self.per_gear(strength);
            let lacks = self.lacks(&per_gear);
            if !lacks.is_empty() {
                return Ok(Err(lacks));
            }
            let gear = |place: usize| self.gear(GEARS[place], strength, &per_gear, Some(shaper));
            return Ok(Ok(SetToSize {
                place,
                id: self.set.id(),
                path: self.data.path.clone(),
                entry,
                teeth: [sun, planet, ring],
                planets: spec.planet_count,
                least_planet_angle: self.set.least_planet_angle(),
                shifts: spec.tooth_shape.shifts.clone(),
                profiles: spec.profiles(&self.subject.rack),
                materials: [0, 1, 2].map(|gear| per_gear.material(gear).to_owned()),
                gears: [gear(0)?, gear(1)?, gear(2)?],
                methods,
                viscosity,
            }));
        }
        let known = [
            ("teeth", matches!(spec.gearing, Gearing::Teeth(..))),
            ("planet_teeth", planet.is_some()),
            ("strength", strength.is_some()),
            ("strength.shaper", strength.is_none() || shaper.is_some()),
            ("oil", viscosity.is_some()),
        ];
        Ok(Err(lacking(&[&known[..], &factors].concat())))
    }
}

/// Planet that satisfies equal centre distances without profile shift; `None` if it has no whole tooth
/// number.
fn coaxial(spec: &SetSpec) -> Option<ToothCount> {
    let Gearing::Teeth(sun, ring) = spec.gearing else { return None };
    let planet = coaxial_planet(sun, ring);
    (planet >= 1.0 && planet.fract() == 0.0).then(|| ToothCount::new(planet as u32).ok())?
}
