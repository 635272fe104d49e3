//! Rules for the gears and meshes of a set.

use super::judge::Judge;
use crate::shared::gearbox::Gearbox;
use crate::shared::toothed::{lacking, toothed};
use crate::strength::answer::materials::{floating, given_sharing};
use epicyclic_formats::gearbox::{GearboxFile, MaterialClass, SetData};
use epicyclic_gears::geometry::GearKind;
use epicyclic_gears::involute::practice::{of_mesh, of_shift, shift_rule};
use epicyclic_gears::mesh::TipCircle;
use epicyclic_judge::Rule;
use epicyclic_strength::load::{Floating, load_sharing};
use epicyclic_strength::material::{self, Class};
use epicyclic_train::PlanetSet;
use epicyclic_train::planet_set::GearOf;
use epicyclic_train::toothed::{ToothedMesh, ToothedSet};
use epicyclic_units::Physical;
use std::f64::consts::TAU;
use uom::si::f64::Length;

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
    if !is_described {
        return judge.lacks(set.id(), &IN_MESH, vec!["module".to_owned()]);
    }
    let toothed = match toothed(subject, data, set) {
        Ok(Ok(toothed)) => toothed,
        Ok(Err(missing)) => {
            let missing = missing.map_or_else(|| "bevel gears have no rules here".to_owned(), str::to_owned);
            return judge.lacks(set.id(), &IN_MESH, vec![missing]);
        }
        Err(error) => return judge.lacks(set.id(), &IN_MESH, vec![error.to_string()]),
    };
    let of = Of { set, data, file, toothed: &toothed };
    of.gears(judge);
    of.meshes(judge);
    of.widths(judge);
    of.rims(judge);
    of.neighbours(judge);
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

    fn is_internal(&self, mesh: &ToothedMesh) -> bool {
        mesh.pair.is_internal()
    }

    fn gears(&self, judge: &mut Judge) {
        let materials = self.data.strength.map(|strength| self.data.of_gears(&strength.materials));
        for (place, of) in self.data.of.iter().enumerate() {
            let Some(gear) = self.toothed.gear(*of) else { continue };
            let name = self.name(*of);
            let own = [self.set.id(), name.as_str()];
            let rule = shift_rule(gear, matches!(of, GearOf::Planet(..)), self.set.is_pair());
            let own_meshes = self.toothed.meshes.iter().filter(|mesh| mesh.gears.contains(of));
            judge.take(&own, of_shift(&judge.limits, rule, gear, own_meshes.map(|mesh| &mesh.pair)));
            let material = materials.as_ref().and_then(|all| all[place]);
            if material.is_some_and(|material| self.is_case_hardened(material)) {
                judge.see(Rule::HardenedTips, &own, gear.tip_thickness());
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
            if let Some(width) = self.data.common_width(mesh.gears).filter(|_| one.profile().is_helical()) {
                let total = pair.transverse_contact_ratio() + pair.overlap_ratio(width.si() / mesh.module);
                judge.see(Rule::HelicalContact, &of, total);
            }
            let divisor = gcd(one.teeth().get(), other.teeth().get());
            judge.see(Rule::HuntingTooth, &of, f64::from(divisor));
        }
    }

    fn widths(&self, judge: &mut Judge) {
        let external = self.toothed.meshes.iter().filter(|mesh| !self.is_internal(mesh));
        let mut is_lacking = false;
        for mesh in external {
            let name = self.mesh_name(mesh);
            let Some(width) = self.data.common_width(mesh.gears).filter(|_| self.has_module()) else {
                is_lacking = true;
                continue;
            };
            judge.see(Rule::FaceWidth, &[self.set.id(), &name], width_ratio(mesh, width));
        }
        if is_lacking {
            let known = [
                ("module", self.has_module()),
                ("face_width", self.data.face_widths.iter().all(Option::is_some)),
            ];
            judge.lacks(self.set.id(), &[Rule::FaceWidth], lacking(&known));
        }
    }

    fn has_module(&self) -> bool {
        self.data.modules.iter().any(Option::is_some)
    }

    fn rims(&self, judge: &mut Judge) {
        let Some(strength) = self.data.strength.filter(|_| self.has_module()) else { return };
        for (name, of) in self.data.gears.names.iter().zip(&self.data.of) {
            let Some(gear) = self.toothed.gear(*of) else { continue };
            let is_ring = gear.kind() == GearKind::Internal;
            let own = strength.rims.get(name);
            let rim = own.or(match of {
                GearOf::Planet(..) => strength.planet_rim.as_ref(),
                GearOf::Central(_) if is_ring => strength.ring_rim.as_ref(),
                GearOf::Central(_) => None,
            });
            let module =
                self.toothed.meshes.iter().find(|mesh| mesh.gears.contains(of)).map(|mesh| mesh.module);
            if let (Some(rim), Some(module)) = (rim, module) {
                let rule = if is_ring { Rule::RingRim } else { Rule::PlanetRim };
                judge.see(rule, &[self.set.id(), &self.name(*of)], rim.0.si() / module);
            }
        }
    }

    /// Gaps between neighbouring planets of one kind.
    fn neighbours(&self, judge: &mut Judge) {
        let Some(planets) = self.set.planet_count().filter(|planets| *planets > 1 && !self.set.is_pair())
        else {
            return;
        };
        let equal = TAU / f64::from(planets);
        let angle = self.set.least_planet_angle().map_or(equal, Physical::si);
        for (gear, radius) in self.data.of.iter().filter_map(|of| match of {
            GearOf::Planet(planet, _) => Some((*of, self.toothed.radii[*planet]?)),
            GearOf::Central(_) => None,
        }) {
            let mesh = self.toothed.meshes.iter().find(|mesh| mesh.gears.contains(&gear));
            let (Some(mesh), Some(own)) = (mesh, self.toothed.gear(gear)) else { continue };
            let circle =
                TipCircle { centre_radius: radius / mesh.module, tip_radius: own.tip_diameter() / 2.0 };
            let gap = circle.gap(circle, angle);
            let name = self.name(gear);
            let of = [self.set.id(), name.as_str()];
            judge.see(Rule::NeighbourGap, &of, gap);
            if self.has_module() {
                judge.see(Rule::NeighbourGapLength, &of, 1e3 * gap * mesh.module);
            }
        }
    }
}

/// Face width over the reference diameter of the smaller gear of a mesh.
pub(super) fn width_ratio(mesh: &ToothedMesh, width: Length) -> f64 {
    let [one, other] = mesh.pair.gears().map(|gear| gear.reference_diameter());
    width.si() / (one.min(other) * mesh.module)
}

/// Judges a load sharing factor that is given.
fn sharing(judge: &mut Judge, set: &PlanetSet, data: &SetData<'_>) {
    let (Some(strength), Some(planets)) = (data.strength, set.planet_count()) else { return };
    let floating = data.floating.map_or(Floating::Assumed, floating);
    let given = given_sharing(strength);
    if let (Some(given), Ok(usual)) = (given, load_sharing(planets, floating))
        && planets > 1
    {
        judge.see(Rule::LoadSharing, &[set.id()], given / usual);
    }
}

/// Greatest common divisor.
const fn gcd(mut one: u32, mut other: u32) -> u32 {
    while other != 0 {
        (one, other) = (other, one % other);
    }
    one
}
