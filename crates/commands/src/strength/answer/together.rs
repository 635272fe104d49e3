//! Damage and safety of several meshes on one flank of a gear, over the duty.
//!
//! Each mesh is rated alone. Where several load one flank, in the same step or in others, its damage is the
//! sum by Miner's rule, and its safety the factor on all their stresses at which the sum is 1. The roots have
//! a sum too: these meshes bend them the same way.

use super::duty::WorkedStep;
use super::load::SetLoad;
use super::names::MeshName;
use super::rated_set::RatedSet;
use super::records::Required;
use crate::answer::Warning;
use epicyclic_strength::factor::{Side, Symbol};
use epicyclic_strength::root::factors::Bending;
use epicyclic_strength::spectrum::{Step, Stresses, Worn, on_flank};
use epicyclic_train::mesh_loads::MeshLoad;
use epicyclic_units::Physical;
use epicyclic_units::format::trimmed;
use schemars::JsonSchema;
use serde::Serialize;
use uom::si::f64::{AngularVelocity, Time, Torque};

/// Flank of a gear that several meshes load over the duty; of both flanks that with more damage.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct SharedFlank {
    /// Name of the set.
    pub set: String,
    /// The gear.
    pub toothed_gear: String,
    /// Meshes that load the flank.
    pub meshes: Vec<MeshName>,
    /// Damage of the flank in the required life by all of them, 1 at the end of the life; null if a stress
    /// is above the static limit.
    pub flank_damage: Option<f64>,
    /// Damage of the roots in the required life by all of them; null if a stress is above the static limit.
    pub root_damage: Option<f64>,
    /// Safety of the flank against all of them: the factor on all stresses at which the damage is 1.
    pub flank_safety: f64,
    /// Safety of the roots against all of them: the factor on all stresses at which the damage is 1.
    pub root_safety: f64,
}

/// Shared flanks of a set over the duty, as far as all meshes on them are rated.
pub(super) fn of_set(set: &RatedSet<'_>, duty: &[WorkedStep<'_>], life: Time) -> Vec<SharedFlank> {
    let load = |WorkedStep(entry, worked): &WorkedStep<'_>| {
        let load = worked.as_ref().map(|worked| SetLoad::of(set.place, worked, Some(entry.speed.0)));
        let load = load.and_then(Result::ok).unwrap_or_else(|| SetLoad::idle(set));
        (load.of_meshes(set.set), load.speed)
    };
    let loads: Vec<_> = duty.iter().map(load).collect();
    let of_gear = |gear| {
        let ends = (0..set.meshes.len()).filter_map(|mesh| {
            let end = set.set.gears_of_mesh(mesh).iter().position(|one| *one == gear)?;
            Some((mesh, end))
        });
        let ends: Vec<(usize, usize)> = ends.collect();
        let of_flank = |flank: f64| {
            let is_on = |load: &MeshLoad, end: usize| load.torques[end] * flank > 0.0;
            let on =
                ends.iter().filter(|(mesh, end)| loads.iter().any(|(load, _)| is_on(&load[*mesh], *end)));
            let on: Vec<&(usize, usize)> = on.collect();
            let [mut at_flank, mut at_root] = [Stresses::default(), Stresses::default()];
            for (mesh, end) in on.iter().copied().filter(|_| on.len() > 1) {
                let step = |(WorkedStep(entry, _), (load, speed)): (
                    &WorkedStep<'_>,
                    &(Vec<MeshLoad>, AngularVelocity),
                )| {
                    let own = &load[*mesh];
                    let step = Step {
                        share: entry.share.0.si(),
                        torque: Torque::from_si(own.torques[0].abs()),
                        speed: AngularVelocity::from_si((speed.si() * own.speeds[0]).abs()),
                    };
                    (step, is_on(own, *end))
                };
                let steps = duty.iter().zip(&loads).map(step);
                let (rated, contacts) = (&set.meshes[*mesh], loads.first()?.0[*mesh].contacts);
                let of = on_flank((&rated.mesh, &rated.method), steps, life, contacts, *end).ok()?;
                if let Some(of) = of {
                    at_flank.join(of.contact);
                    at_root.join(of.root);
                }
            }
            let meshes = on.iter().map(|(mesh, _)| set.meshes[*mesh].name.clone()).collect::<Vec<_>>();
            (meshes.len() > 1).then(|| (meshes, at_flank.worn(life), at_root.worn(life)))
        };
        let both = [1.0, -1.0].into_iter().filter_map(of_flank);
        // Two flanks without damage differ in their safeties alone.
        let worse = |one: &Worn, other: &Worn| {
            one.damage.total_cmp(&other.damage).then(other.safety.total_cmp(&one.safety))
        };
        let (meshes, flank, root) = both.max_by(|one, other| worse(&one.1, &other.1))?;
        let finite = |worn: &Worn| Some(worn.damage).filter(|damage| damage.is_finite());
        Some(SharedFlank {
            set: set.id.to_owned(),
            toothed_gear: set.set.gear_name(gear),
            meshes,
            flank_damage: finite(&flank),
            root_damage: finite(&root),
            flank_safety: flank.safety,
            root_safety: root.safety,
        })
    };
    set.set.gears().into_iter().filter_map(of_gear).collect()
}

/// Warning of gears that the duty loads on both flanks, while their roots are rated as bent one way and no
/// mean stress factor says otherwise.
pub(super) fn reversed(set: &RatedSet<'_>, duty: &[WorkedStep<'_>]) -> Option<Warning> {
    let mut gears: Vec<String> = vec![];
    for (place, rated) in set.meshes.iter().enumerate() {
        let loads = duty.iter().filter_map(|WorkedStep(entry, worked)| {
            let load = SetLoad::of(set.place, worked.as_ref()?, Some(entry.speed.0)).ok()?;
            load.of_meshes(set.set).get(place).map(|load| load.torques[0])
        });
        let signs: Vec<f64> = loads.filter(|torque| *torque != 0.0).map(f64::signum).collect();
        if !(signs.contains(&1.0) && signs.contains(&-1.0)) {
            continue;
        }
        for side in Side::BOTH {
            let is_one_way = rated.mesh.gears[side as usize].bending == Bending::OneWay;
            if is_one_way && rated.method.given.of(side, Symbol::MeanStress).is_none() {
                let name = rated.name.gears[side as usize].clone();
                if !gears.contains(&name) {
                    gears.push(name);
                }
            }
        }
    }
    (!gears.is_empty()).then(|| Warning {
        name: "reversed-bending",
        message: format!(
            "set {}: the duty loads both flanks of {}, whose roots are rated as bent one way: state Y_M of each in `gear_factors`, 0.7 where both ways bend alike",
            set.id,
            gears.join(", ")
        ),
    })
}

impl SharedFlank {
    /// Warning of a flank or root whose life is shorter than required, or whose safety is below that
    /// required.
    pub(super) fn warning(&self, required: Required) -> Option<Warning> {
        let Self { set, toothed_gear, meshes, .. } = self;
        let meshes: Vec<String> = meshes.iter().map(MeshName::to_string).collect();
        let worn = |damage: Option<f64>| damage.is_none_or(|damage| damage > 1.0);
        let place = match (worn(self.flank_damage), worn(self.root_damage)) {
            (false, false) => return self.low_safety(&meshes.join(", "), required),
            (true, false) => ("flank", self.flank_damage),
            (false, true) => ("root", self.root_damage),
            (true, true) => {
                ("flank and root", self.flank_damage.zip(self.root_damage).map(|(one, other)| one.max(other)))
            }
        };
        let (place, damage) =
            (place.0, place.1.map_or("above static".to_owned(), |damage| trimmed(damage, 4)));
        let message = format!(
            "set {set}: the meshes {} together wear the {place} of the {toothed_gear} out before the required life: damage {damage}, where each is rated alone",
            meshes.join(", ")
        );
        Some(Warning { name: "shared-flank", message })
    }

    fn low_safety(&self, meshes: &str, required: Required) -> Option<Warning> {
        let Self { set, toothed_gear, .. } = self;
        let both = [("flank", self.flank_safety, required.flank), ("root", self.root_safety, required.root)];
        let below = both.into_iter().filter(|(_, safety, required)| safety < required);
        let below: Vec<String> = below
            .map(|(place, safety, required)| {
                format!("{safety:.3} of the {place}, below the {required} required")
            })
            .collect();
        if below.is_empty() {
            return None;
        }
        let message = format!(
            "set {set}: the meshes {meshes} together leave the {toothed_gear} a safety of {}; each is rated alone",
            below.join(", and ")
        );
        Some(Warning { name: "shared-flank", message })
    }
}
