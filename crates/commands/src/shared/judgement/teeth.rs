//! Rules for the gears and meshes of a set.

use super::judge::Judge;
use crate::error::Error;
use crate::shared::gearbox::Gearbox;
use crate::shared::toothed::{lacking, toothed};
use crate::strength::answer::materials::{floating, given_sharing};
use epicyclic_formats::gearbox::{GearboxFile, MaterialClass, SetData};
use epicyclic_gears::geometry::GearKind;
use epicyclic_gears::mesh::TipCircle;
use epicyclic_judge::{Rule, Severity};
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

/// Teeth by which a ring may exceed its planet at most for shifts beyond 1, which such pairs need.
const CLOSE_TEETH: u32 = 6;

/// Judges the teeth of a set.
///
/// # Errors
/// [`Error::Document`] for gears that cannot mesh, with the place.
pub(super) fn judge(
    judge: &mut Judge,
    subject: &Gearbox,
    file: &GearboxFile,
    set: &PlanetSet,
    data: &SetData<'_>,
) -> Result<(), Error> {
    sharing(judge, set, data);
    let toothed = match toothed(subject, data, set)? {
        Ok(toothed) => toothed,
        Err(missing) => {
            let missing = missing.map_or_else(|| "bevel gears have no rules here".to_owned(), str::to_owned);
            judge.lacks(set.id(), &IN_MESH, vec![missing]);
            return Ok(());
        }
    };
    let of = Of { set, data, file, toothed: &toothed };
    of.gears(judge);
    of.meshes(judge);
    of.widths(judge);
    of.rims(judge);
    of.neighbours(judge);
    Ok(())
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
            let rule = match (of, gear.kind()) {
                _ if self.set.is_pair() => Rule::GearShift,
                (GearOf::Planet(..), _) => Rule::PlanetShift,
                (GearOf::Central(_), GearKind::Internal) => Rule::RingShift,
                (GearOf::Central(_), _) => Rule::SunShift,
            };
            let verdict = judge.limits.judge(rule, gear.shift());
            // Rings hardly larger than their planets close only so.
            let is_close = self.toothed.meshes.iter().any(|mesh| {
                let [one, other] = mesh.pair.gears().map(|gear| gear.teeth().get());
                self.is_internal(mesh) && mesh.gears.contains(of) && other.abs_diff(one) <= CLOSE_TEETH
            });
            judge.take(&own, if is_close { verdict.no_worse_than(Severity::Warning) } else { verdict });
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
            let most = pair.specific_sliding().into_iter().flatten().map(f64::abs).fold(0.0, f64::max);
            judge.see(Rule::SpecificSliding, &of, most);
            let transverse = one.profile().transverse_angle_rad().to_degrees();
            let working = pair.working_angle_rad().to_degrees();
            let rule = if self.is_internal(mesh) { Rule::InternalAngle } else { Rule::ExternalAngle };
            // The usual angles are those of teeth of 20°.
            let bounds = rule.bounds().moved(transverse - 20.0);
            judge.see_by(rule, bounds, &of, working);
            if !self.is_internal(mesh) {
                judge.see(Rule::ShiftSum, &of, one.shift() + other.shift());
            }
            let contact = pair.transverse_contact_ratio();
            if one.profile().helix_angle.si() == 0.0 {
                judge.see(Rule::SpurContact, &of, contact);
            } else if let Some(width) = self.data.common_width(mesh.gears) {
                let total = contact + pair.overlap_ratio(width.si() / mesh.module);
                judge.see(Rule::HelicalContact, &of, total);
            }
            for (gear, clearance) in mesh.gears.iter().zip(pair.tip_clearances()) {
                let name = format!("tips of the {}", self.name(*gear));
                judge.see(Rule::RootClearance, &[self.set.id(), &name], clearance);
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
