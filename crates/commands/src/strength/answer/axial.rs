//! Axial forces of sets with helical teeth.

use super::duty::WorkedStep;
use super::load::{both_loads, set_load};
use super::prepared::RatedSet;
use super::records::AxialForce;
use epicyclic_strength::planets::axial_forces;
use epicyclic_units::Physical;
use uom::si::f64::{AngularVelocity, Time, Torque};

/// Axial forces of a set at a torque and speed of its sun; `None` for spur teeth.
pub(super) fn of(
    set: &RatedSet<'_>,
    gear: &str,
    step: Option<u32>,
    (torque, speed): (Torque, AngularVelocity),
    life: Time,
) -> Option<AxialForce> {
    let loads = both_loads(set, torque, speed, life).ok().filter(|_| set.is_helical())?;
    let tangential = [0, 1].map(|mesh| set.meshes[mesh].tangential_force(loads[mesh].torque));
    let pairs = set.meshes.each_ref().map(|mesh| &mesh.pair);
    let found = axial_forces(pairs, set.meshes[0].module, tangential);
    Some(AxialForce {
        set: set.id.to_owned(),
        gear: gear.to_owned(),
        step,
        axial_force_n: found.forces[0].si(),
        tilting_moment_n_m: found.tilting_moment.si(),
    })
}

/// Axial forces of all sets in the loaded steps of a duty.
pub(super) fn over_duty(sets: &[RatedSet<'_>], steps: &[WorkedStep<'_>], life: Time) -> Vec<AxialForce> {
    let of_step = |set: &RatedSet<'_>, number: u32, WorkedStep(entry, worked): &WorkedStep<'_>| {
        let load = set_load(set, worked.as_ref()?, entry.speed.0).ok()?;
        of(set, &entry.gear, Some(number), load, life)
    };
    sets.iter()
        .flat_map(|set| (1..).zip(steps).filter_map(move |(number, step)| of_step(set, number, step)))
        .collect()
}
