//! Load of a set in a gear.

use super::rated_set::RatedSet;
use super::records::Reason;
use crate::analyze::answer::Worked;
use crate::tolerance::{ROUNDED, rounded};
use epicyclic_strength::mesh::Load;
use epicyclic_train::mesh_loads::MeshLoad;
use epicyclic_units::Physical;
use uom::si::f64::{AngularVelocity, Time, Torque};

/// Torques on the central gears of a set without losses; each is 0 if only a rounding error is left.
fn torques<'w>(place: usize, worked: &'w Worked<'_>) -> Option<impl Iterator<Item = Torque> + use<'w>> {
    let (operation, case) = worked.operation.as_ref().zip(worked.analysis.ideal())?;
    let members = case.members[place].as_ref()?;
    Some(members.iter().map(move |of| operation.input * rounded(of / case.input)))
}

/// Torque on the sun of a set without losses; 0 if only a rounding error is left.
pub(super) fn torque(place: usize, worked: &Worked<'_>) -> Option<Torque> {
    torques(place, worked)?.next()
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

/// Load of a set without losses.
pub(super) struct SetLoad {
    /// Torques on the central gears, N·m; each is 0 if only a rounding error is left.
    torques: Vec<f64>,
    /// Speed of the first central gear relative to the carrier.
    pub(super) speed: AngularVelocity,
}

impl SetLoad {
    /// Load of a set in a gear at a speed of the input; without a speed that of a set that need not roll.
    pub(super) fn of(
        set: &RatedSet<'_>,
        worked: &Worked<'_>,
        speed: Option<AngularVelocity>,
    ) -> Result<Self, Reason> {
        let torques = torques(set.place, worked).ok_or(Reason::NoTorquesFollow)?;
        let torques: Vec<f64> = torques.map(Physical::si).collect();
        if torques.iter().all(|torque| *torque == 0.0) {
            return Err(Reason::NoTorque);
        }
        let Some(speed) = speed else { return Ok(Self { torques, speed: AngularVelocity::from_si(0.0) }) };
        let relative = worked.analysis.sets()[set.place].relative.ok_or(Reason::NoTorquesFollow)?;
        let turning = rounded(relative);
        if turning == 0.0 {
            return Err(Reason::NoRolling);
        }
        Ok(Self { torques, speed: speed * turning })
    }

    /// No load.
    pub(super) fn idle(set: &RatedSet<'_>) -> Self {
        Self { torques: vec![0.0; set.set.members().len()], speed: AngularVelocity::from_si(0.0) }
    }

    /// Loads of the meshes of the set, in its order.
    pub(super) fn meshes(&self, set: &RatedSet<'_>, life: Time) -> Vec<Load> {
        let loads = set.set.mesh_loads(&self.torques).unwrap_or_default();
        let largest = self.torques.iter().fold(0.0, |largest: f64, torque| largest.max(torque.abs()));
        let load = |load: MeshLoad| Load {
            // A mesh without load has what rounding leaves of torques that cancel.
            torque: Torque::from_si(if load.torques[0].abs() <= ROUNDED * largest {
                0.0
            } else {
                load.torques[0].abs()
            }),
            speed: AngularVelocity::from_si((self.speed.si() * load.speeds[0]).abs()),
            life,
            contacts: load.contacts,
        };
        loads.into_iter().map(load).collect()
    }
}
