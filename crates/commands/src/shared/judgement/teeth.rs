//! Rules for the gears and meshes of a set.

use super::judge::Judge;
use crate::shared::gearbox::Gearbox;
use crate::shared::toothed::{lacking, toothed};
use crate::strength::answer::materials::{floating, given_sharing};
use epicyclic_formats::gearbox::{GearboxFile, MaterialClass, SetData};
use epicyclic_gears::geometry::GearKind;
use epicyclic_gears::involute::practice::{
    of_gap, of_gear, of_mesh, of_total_contact, shift_rule, width_diameters,
};
use epicyclic_gears::teeth::gcd;
use epicyclic_judge::Rule;
use epicyclic_strength::load::{Floating, load_sharing};
use epicyclic_strength::material::{self, Class};
use epicyclic_train::PlanetSet;
use epicyclic_train::planet_set::GearOf;
use epicyclic_train::toothed::{ToothedMesh, ToothedSet};
use epicyclic_units::Physical;
use std::f64::consts::TAU;

/// Rules that need the teeth of a set in mesh.
const IN_MESH: [Rule; 8] = [
    Rule::SpecificSliding,
    Rule::SunShift,
    Rule::PlanetShift,
    Rule::RingShift,
    Rule::ExternalAngle,
    Rule::InternalAngle,
    Rule::SpurContact,
    Rule::RootClearance,
];

/// Judges the teeth of a set.
pub(super) fn judge(
    judge: &mut Judge,
    subject: &Gearbox,
    file: &GearboxFile,
    set: &PlanetSet,
    data: &SetData<'_>,
) {
    sharing(judge, set, data);
    // Tooth numbers alone describe a scheme, not gears that someone would cut.
    let is_described = set.tooth_shape().shifts.is_some() || data.modules.iter().any(Option::is_some);
    let toothed = match in_mesh(subject, data, set, is_described) {
        Ok(toothed) => toothed,
        Err(missing) => return judge.lacks(set.id(), &IN_MESH, missing),
    };
    let of = Of { set, data, file, toothed: &toothed };
    of.gears(judge);
    of.meshes(judge);
    of.widths(judge);
    of.rims(judge);
    of.neighbours(judge);
}

/// The gears of a set in mesh, or what is missing for them; besides teeth a module is, unless that is known.
pub(super) fn in_mesh(
    subject: &Gearbox,
    data: &SetData<'_>,
    set: &PlanetSet,
    has_module: bool,
) -> Result<ToothedSet, Vec<String>> {
    let module = || lacking(&[("module", has_module)]);
    match toothed(subject, data, set) {
        Ok(Ok(toothed)) if has_module => Ok(toothed),
        Ok(Ok(_)) => Err(module()),
        Ok(Err(Some(key))) => Err([vec![key.to_owned()], module()].concat()),
        Ok(Err(None)) => Err(vec!["bevel gears have no rules here".to_owned()]),
        Err(error) => Err(vec![error.to_string()]),
    }
}

/// A set with its gears in mesh.
struct Of<'a> {
    set: &'a PlanetSet,
    data: &'a SetData<'a>,
    file: &'a GearboxFile,
    toothed: &'a ToothedSet,
}

impl Of<'_> {
    fn name(&self, gear: GearOf) -> String {
        self.set.gear_name(gear)
    }

    fn mesh_name(&self, mesh: &ToothedMesh) -> String {
        mesh.gears.map(|gear| self.name(gear)).join("–")
    }

    fn gears(&self, judge: &mut Judge) {
        let materials = self.data.strength.map(|strength| self.data.of_gears(&strength.materials));
        for (place, of) in self.data.of.iter().enumerate() {
            let Some(gear) = self.toothed.gear(*of) else { continue };
            let name = self.name(*of);
            let own = [self.set.id(), name.as_str()];
            let rule = shift_rule(gear, matches!(of, GearOf::Planet(..)), self.set.is_pair());
            let own_meshes = self.toothed.meshes.iter().filter(|mesh| mesh.gears.contains(of));
            let material = materials.as_ref().and_then(|all| all[place]);
            let is_hardened = material.is_some_and(|material| self.is_case_hardened(material));
            let meshes = own_meshes.map(|mesh| &mesh.pair);
            for verdict in of_gear(&judge.limits, rule, gear, meshes, is_hardened) {
                judge.take(&own, verdict);
            }
        }
    }

    fn is_case_hardened(&self, name: &str) -> bool {
        let own = self.file.materials.iter().find(|own| own.name == name);
        match own {
            Some(own) => own.class == MaterialClass::CaseHardened,
            None => material::listed(name).is_some_and(|listed| listed.material.class == Class::CaseHardened),
        }
    }

    fn meshes(&self, judge: &mut Judge) {
        for mesh in &self.toothed.meshes {
            let name = self.mesh_name(mesh);
            let of = [self.set.id(), name.as_str()];
            let pair = &mesh.pair;
            let [one, other] = pair.gears();
            for (gear, verdict) in of_mesh(&judge.limits, pair) {
                let name = gear.map_or_else(
                    || name.clone(),
                    |gear| format!("tips of the {}", self.name(mesh.gears[gear])),
                );
                judge.take(&[self.set.id(), &name], verdict);
            }
            let width = self.data.common_width(mesh.gears).map(|width| width.si() / mesh.module);
            if let Some(total) = width.and_then(|width| of_total_contact(&judge.limits, pair, width)) {
                judge.take(&of, total);
            }
            let divisor = gcd(one.teeth().get().into(), other.teeth().get().into());
            judge.see(Rule::HuntingTooth, &of, divisor as f64);
        }
    }

    fn widths(&self, judge: &mut Judge) {
        let known = [
            ("module", self.has_module()),
            ("face_width", self.data.face_widths.iter().all(Option::is_some)),
        ];
        for (mesh, diameter) in judged_by_width(self.toothed) {
            match self.data.common_width(mesh.gears).filter(|_| self.has_module()) {
                Some(width) => {
                    let name = self.mesh_name(mesh);
                    judge.see(Rule::FaceWidth, &[self.set.id(), &name], width.si() / diameter);
                }
                None => judge.lacks(self.set.id(), &[Rule::FaceWidth], lacking(&known)),
            }
        }
    }

    fn has_module(&self) -> bool {
        self.data.modules.iter().any(Option::is_some)
    }

    /// Rims that are stated; under a planet's teeth otherwise what its bore leaves of them.
    fn rims(&self, judge: &mut Judge) {
        if !self.has_module() {
            return;
        }
        for (name, of) in self.data.gears.names.iter().zip(&self.data.of) {
            let Some((gear, module)) = self.toothed.gear(*of).zip(self.module(*of)) else { continue };
            let is_ring = gear.kind() == GearKind::Internal;
            let rule = if is_ring { Rule::RingRim } else { Rule::PlanetRim };
            let stated = self.data.strength.and_then(|strength| {
                let of_kind = match of {
                    GearOf::Planet(..) => strength.planet_rim.as_ref(),
                    GearOf::Central(_) if is_ring => strength.ring_rim.as_ref(),
                    GearOf::Central(_) => None,
                };
                strength.rims.get(name).or(of_kind)
            });
            match (stated, of) {
                (Some(rim), _) => judge.see(rule, &[self.set.id(), &self.name(*of)], rim.0.si() / module),
                (None, GearOf::Planet(planet, _)) => {
                    self.bored(judge, *of, *planet, gear.root_diameter() * module);
                }
                (None, GearOf::Central(_)) => {}
            }
        }
    }

    /// Judges the rim of a planet's gear over its bore. The outside of a bearing is larger than its mean
    /// diameter, which alone shows only that a rim is too thin.
    fn bored(&self, judge: &mut Judge, gear: GearOf, planet: usize, root_m: f64) {
        let Some((of, module)) = self.data.planets.get(planet).zip(self.module(gear)) else { return };
        let diameters = [of.bore, of.bearing_diameter].into_iter().flatten().map(Physical::si);
        let Some(largest) = diameters.reduce(f64::max) else { return };
        let verdict = judge.limits.judge(Rule::PlanetRim, (root_m - largest) / 2.0 / module);
        if of.bore.is_none() && verdict.holds() {
            let key = if self.set.short().is_some() { "planet_bore" } else { "bore" };
            return judge.lacks(self.set.id(), &[Rule::PlanetRim], vec![key.to_owned()]);
        }
        judge.take(&[self.set.id(), &self.name(gear)], verdict);
    }

    /// Module of a gear, that of its first mesh.
    fn module(&self, gear: GearOf) -> Option<f64> {
        self.toothed.meshes.iter().find(|mesh| mesh.gears.contains(&gear)).map(|mesh| mesh.module)
    }

    /// Gaps between neighbouring planets of one kind.
    fn neighbours(&self, judge: &mut Judge) {
        let Some(planets) = self.set.planet_count().filter(|planets| *planets > 1 && !self.set.is_pair())
        else {
            return;
        };
        let equal = TAU / f64::from(planets);
        let angle = self.set.least_planet_angle().map_or(equal, Physical::si);
        for gear in &self.data.of {
            let GearOf::Planet(planet, _) = gear else { continue };
            let own = self.toothed.radii[*planet].zip(self.module(*gear)).zip(self.toothed.gear(*gear));
            let Some(((radius, module), own)) = own else { continue };
            let stated = Some(module).filter(|_| self.has_module());
            for verdict in of_gap(&judge.limits, own, radius / module, angle, stated) {
                judge.take(&[self.set.id(), &self.name(*gear)], verdict);
            }
        }
    }
}

/// Meshes whose face width is judged, each with the reference diameter of its smaller gear, in m.
pub(super) fn judged_by_width(toothed: &ToothedSet) -> impl Iterator<Item = (&ToothedMesh, f64)> {
    let meshes: Vec<_> = toothed.meshes.iter().map(|mesh| (mesh.gears, &mesh.pair)).collect();
    let diameters = width_diameters(&meshes);
    let of = |(mesh, diameter): (_, Option<f64>)| Some((mesh, diameter?));
    let all = toothed.meshes.iter().zip(diameters).filter_map(of);
    all.map(|(mesh, diameter): (&ToothedMesh, f64)| (mesh, diameter * mesh.module))
}

/// Judges a load sharing factor that is given.
fn sharing(judge: &mut Judge, set: &PlanetSet, data: &SetData<'_>) {
    let (Some(strength), Some(planets)) = (data.strength, set.planet_count()) else { return };
    let floating = data.floating.map_or(Floating::Assumed, floating);
    let given = given_sharing(strength);
    if let (Some(given), Ok(usual)) = (given, load_sharing(planets, floating))
        && planets > 1
    {
        judge.see_least(Rule::LoadSharing, &[set.id()], usual, given);
    }
}
