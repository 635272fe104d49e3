//! Load of a set in a gear.

use super::prepared::RatedSet;
use super::records::Reason;
use crate::analyze::answer::Worked;
use crate::tolerance::rounded;
use epicyclic_strength::mesh::Load;
use epicyclic_strength::planets::loads;
use epicyclic_units::Physical;
use uom::si::f64::{AngularVelocity, Time, Torque};

/// Torque on the sun of a set without losses; 0 if only a rounding error is left.
pub(super) fn torque(place: usize, worked: &Worked<'_>) -> Option<Torque> {
    let (operation, case) = worked.operation.as_ref().zip(worked.analysis.ideal())?;
    Some(operation.input * rounded(case.members[place].as_ref()?[0] / case.input))
}

/// Torque on the sun without losses.
pub(super) fn sun_torque(set: &RatedSet<'_>, worked: &Worked<'_>) -> Result<Torque, Reason> {
    let torque = torque(set.place, worked).ok_or(Reason::NoTorquesFollow)?;
    if torque.si() == 0.0 { Err(Reason::NoTorque) } else { Ok(torque) }
}

/// Torque on the sun without losses, its speed relative to the carrier, and the carrier speed. Each is 0 if
/// only a rounding error is left.
pub(crate) fn felt(
    place: usize,
    worked: &Worked<'_>,
    speed: AngularVelocity,
) -> Option<(Torque, [AngularVelocity; 2])> {
    let motion = &worked.analysis.sets()[place];
    let turning = rounded(motion.relative?);
    Some((torque(place, worked)?, [speed * turning, speed * motion.carrier().unwrap_or(0.0)]))
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
