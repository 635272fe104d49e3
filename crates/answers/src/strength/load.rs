//! The load of a set in a gear.

use super::prepared::RatedSet;
use super::records::Reason;
use crate::analyze::Worked;
use crate::tolerance::ROUNDED;
use epicyclic_formats::Physical;
use epicyclic_strength::mesh::Load;
use epicyclic_strength::planets::loads;
use uom::si::f64::{AngularVelocity, Time, Torque};

/// Torque on the sun without losses.
pub(super) fn sun_torque(set: &RatedSet<'_>, worked: &Worked<'_>) -> Result<Torque, Reason> {
    let ideal = worked.analysis.ideal();
    let (operation, case) = worked.operation.as_ref().zip(ideal).ok_or(Reason::NoTorquesFollow)?;
    let members = case.members[set.place].as_ref().ok_or(Reason::NoTorquesFollow)?;
    let torque = members[0] / case.input;
    // Balances leave their rounding.
    if torque.abs() < ROUNDED { Err(Reason::NoTorque) } else { Ok(operation.input * torque) }
}

/// Torque on the sun without losses, its speed relative to the carrier, and the carrier's speed; 0 where only their rounding is left.
pub(crate) fn felt(
    place: usize,
    worked: &Worked<'_>,
    speed: AngularVelocity,
) -> Option<(Torque, [AngularVelocity; 2])> {
    let analysis = &worked.analysis;
    let (operation, case) = worked.operation.as_ref().zip(analysis.ideal())?;
    let members = case.members[place].as_ref()?;
    let motion = &analysis.sets()[place];
    // Balances and differences of speeds leave their rounding.
    let [torque, turning] = [members[0] / case.input, motion.relative?]
        .map(|share| if share.abs() < ROUNDED { 0.0 } else { share });
    Some((operation.input * torque, [speed * turning, speed * motion.carrier().unwrap_or(0.0)]))
}

/// Torque on the sun without losses and its speed relative to the carrier.
pub(super) fn set_load(
    set: &RatedSet<'_>,
    worked: &Worked<'_>,
    speed: AngularVelocity,
) -> Result<(Torque, AngularVelocity), Reason> {
    let (torque, [turning, _]) = felt(set.place, worked, speed).ok_or(Reason::NoTorquesFollow)?;
    if torque.si() == 0.0 {
        Err(Reason::NoTorque)
    } else if turning.si() == 0.0 {
        Err(Reason::NoRolling)
    } else {
        Ok((torque, turning))
    }
}

/// Loads of both meshes of a set.
pub(super) fn both_loads(
    set: &RatedSet<'_>,
    torque: Torque,
    speed: AngularVelocity,
    life: Time,
) -> Result<[Load; 2], epicyclic_strength::Error> {
    loads(torque, speed, set.planets, set.teeth, life)
}
