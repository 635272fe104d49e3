//! Axial forces of helical teeth on the bodies of a set of any kind.

use super::load::SetLoad;
use super::names::MeshName;
use super::rated_set::RatedSet;
use crate::shared::gearbox::Gearbox;
use crate::tolerance::ROUNDED;
use epicyclic_train::axial_forces::{AxialLoad, Body};
use epicyclic_train::planet_set::GearOf;
use schemars::JsonSchema;
use serde::Serialize;

/// Axial force on a central gear, a planet or a gear of a pair, from the nominal torque without losses and
/// load factors. A force above 0 points in the direction about which the positive rotation is that of a
/// right-handed screw.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct AxialForce {
    /// Name of the set.
    pub set: String,
    /// Name of the selected gear.
    pub gear: String,
    /// Number of the step of the duty, from 1; null at an operating point.
    pub step: Option<u32>,
    /// The central gear, planet or gear of a pair.
    pub body: String,
    /// Axial force `F_a` of one mesh of each kind on the body.
    pub meshes: Vec<AxialForceOfMesh>,
    /// Sum of the axial forces of all its meshes, in N.
    pub axial_force_n: f64,
    /// Whether the axial forces of its different meshes cancel or add; null for a body with one kind of mesh.
    pub thrusts: Option<Thrusts>,
    /// Moment of the axial forces that tilts a planet or a gear of a pair, in N·m; null for central gears, on
    /// which those of equally spaced planets cancel.
    pub tilting_moment_n_m: Option<f64>,
}

/// Axial force of a mesh.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct AxialForceOfMesh {
    /// Name of the mesh.
    pub mesh: MeshName,
    /// Axial force of one such mesh, in N.
    pub axial_force_n: f64,
}

/// How the axial forces of the meshes of a body go together.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Thrusts {
    /// The forces sum to 0.
    Cancel,
    /// Some act against others.
    PartlyCancel,
    /// The forces act in one direction.
    Add,
}

/// Axial forces of a set at a load; none for spur teeth.
pub(super) fn of(
    subject: &Gearbox,
    set: &RatedSet<'_>,
    gear: &str,
    step: Option<u32>,
    load: &SetLoad,
) -> Vec<AxialForce> {
    let is_behind = subject.is_behind(set.set);
    let loads = set.set.axial_forces(&set.toothed, is_behind, &load.of_meshes(set.set)).unwrap_or_default();
    let row = |load: AxialLoad| {
        let sizes: f64 = load.meshes.iter().map(|(_, force)| force.abs()).sum();
        // Forces that cancel leave a rounding error; adding 0 takes the sign off a 0.
        let clean = |force: f64| if force.abs() <= ROUNDED * sizes { 0.0 } else { force };
        let sum: f64 = load.meshes.iter().map(|(_, force)| force).sum();
        let thrusts = match clean(sum).abs() {
            _ if load.meshes.len() < 2 || sizes == 0.0 => None,
            0.0 => Some(Thrusts::Cancel),
            sum if sum >= sizes * (1.0 - ROUNDED) => Some(Thrusts::Add),
            _ => Some(Thrusts::PartlyCancel),
        };
        let has_moment = set.set.is_pair() || matches!(load.body, Body::Planet(_));
        AxialForce {
            set: set.id.to_owned(),
            gear: gear.to_owned(),
            step,
            body: match load.body {
                Body::Central(central) => set.set.gear_name(GearOf::Central(central)),
                Body::Planet(planet) => set.set.planet_name(planet),
            },
            meshes: load
                .meshes
                .iter()
                .map(|(mesh, force)| AxialForceOfMesh {
                    mesh: set.meshes[*mesh].name.clone(),
                    axial_force_n: clean(*force),
                })
                .collect(),
            axial_force_n: clean(load.force),
            thrusts,
            tilting_moment_n_m: has_moment.then(|| libm::hypot(load.moment[0], load.moment[1])),
        }
    };
    loads.into_iter().map(row).collect()
}
