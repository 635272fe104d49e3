//! Axial forces of sets with helical teeth.

use super::load::SetLoad;
use super::rated_set::RatedSet;
use super::records::AxialForce;
use epicyclic_strength::planets::axial_forces;
use epicyclic_train::set::SetKind;
use epicyclic_units::Physical;
use uom::si::f64::Time;

/// Axial forces of a simple set at a load; `None` for spur teeth.
pub(super) fn of(
    set: &RatedSet<'_>,
    gear: &str,
    step: Option<u32>,
    load: &SetLoad,
    life: Time,
) -> Option<AxialForce> {
    let is_asked = set.is_helical() && set.set.kind() == Some(SetKind::Simple);
    let [sun_mesh, ring_mesh] = set.meshes.as_slice() else { return None };
    let loads = Some(load.meshes(set, life)).filter(|loads| is_asked && loads.len() == 2)?;
    let both = [sun_mesh, ring_mesh].map(|mesh| &mesh.mesh);
    let tangential = [0, 1].map(|mesh: usize| both[mesh].tangential_force(loads[mesh].torque));
    let found = axial_forces(both.map(|mesh| &mesh.pair), both[0].module, tangential);
    Some(AxialForce {
        set: set.id.to_owned(),
        gear: gear.to_owned(),
        step,
        axial_force_n: found.forces[0].si(),
        tilting_moment_n_m: found.tilting_moment.si(),
    })
}
