//! Equivalent inertia and start of a drive.

use super::bodies::Ends;
use super::finite;
use super::loads::Meshes;
use super::part::Computed;
use super::result::{EquivalentInertia, Masses, Motion, Start};
use crate::Error;
use crate::energy::kinetic_energy;
use crate::equivalent_inertia::{Link, LinkName, Orbit};
use crate::lagrange::starting_time;
use crate::planetary::{Accelerations, FromRest, LossyMotion, PlanetaryDrive, Turning};
use crate::tolerance::BALANCE;
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_units::Physical;
use uom::si::f64::{AngularAcceleration, AngularVelocity, MomentOfInertia, Time, Torque};

/// The start: to which speed of the sun, and the torques.
#[derive(Clone, Copy)]
pub(super) struct Starting {
    pub(super) speed: AngularVelocity,
    pub(super) driving: Torque,
    pub(super) load: Torque,
}

/// Shares of the parts in the equivalent inertia, and the kinetic energy at a speed of the sun.
pub(super) fn equivalent_inertia(
    drive: &PlanetaryDrive,
    masses: &Masses,
    ends: Ends,
    speed: AngularVelocity,
) -> Result<EquivalentInertia, Error> {
    let ratios = drive.set.ratios();
    let central = |name, j: MomentOfInertia, ratio| Link::central(name, j, ratio).equivalent_inertia();
    let orbit = Orbit { mass: drive.planet_mass, radius: drive.planet_radius, speed_ratio: ratios.carrier };
    let planets = Link {
        count: drive.set.teeth().planets,
        ..Link::central(LinkName::Planets, MomentOfInertia::from_si(0.0), ratios.planet)
    };
    let found = EquivalentInertia {
        sun: central(LinkName::Sun, masses.sun.inertia, 1.0)?,
        motor: central(LinkName::Motor, ends.motor, 1.0)?,
        planets_orbiting: Link { orbit: Some(orbit), ..planets.clone() }.equivalent_inertia()?,
        planets_turning: Link { inertia: drive.planet_inertia, ..planets }.equivalent_inertia()?,
        carrier: central(LinkName::Carrier, masses.carrier_inertia, ratios.carrier)?,
        machine: central(LinkName::Machine, ends.machine, ratios.carrier)?,
        total: drive.equivalent_inertia()?,
        kinetic_energy: kinetic_energy(&drive.bodies(speed)?),
    };
    finite(Computed::EquivalentInertia, found.total.si())?;
    finite(Computed::KineticEnergy, found.kinetic_energy.si())?;
    Ok(found)
}

pub(super) fn without_losses(drive: &PlanetaryDrive, start: Starting) -> Result<Motion, Error> {
    let Starting { speed, driving, load } = start;
    let accelerations = drive.motion(driving, load)?;
    finite(Computed::Acceleration, accelerations.sun.si())?;
    let force = drive.generalized_force(driving, load);
    let inertia = drive.equivalent_inertia()?;
    let held = drive.held_loads(driving, MeshEfficiency::IDEAL, MeshEfficiency::IDEAL);
    let balance = BALANCE * driving.si();
    let start = match force.si() {
        surplus if surplus.abs() <= balance => Start::InBalance,
        surplus if surplus < 0.0 => Start::Backward(-force),
        _ => Start::After(time(speed, force, inertia)?),
    };
    Ok(settled(Motion { inertia, generalized_force: force, accelerations, held, start }))
}

pub(super) fn with_losses(drive: &PlanetaryDrive, start: Starting, meshes: Meshes) -> Result<Motion, Error> {
    let Starting { speed, driving, load } = start;
    let [eta_12, eta_23] = meshes.two();
    let held = drive.held_loads(driving, eta_12, eta_23);
    let moving = |motion: LossyMotion, start| {
        finite(Computed::Acceleration, motion.accelerations.sun.si())?;
        let LossyMotion { inertia, force: generalized_force, accelerations, .. } = motion;
        Ok(settled(Motion { inertia, generalized_force, accelerations, held, start }))
    };
    let balance = BALANCE * driving.si();
    match drive.from_rest(driving, load, eta_12, eta_23)? {
        FromRest::Forward(motion) if motion.force.si() > balance => {
            moving(motion, Start::After(time(speed, motion.force, motion.inertia)?))
        }
        FromRest::Backward(motion) if motion.force.si() < -balance => {
            moving(motion, Start::Backward(-motion.force))
        }
        // At its least load the drive is in balance, whichever way the last digit fell.
        FromRest::Forward(_) | FromRest::Held | FromRest::Backward(_) => {
            let forward = drive.motion_with_losses(driving, load, eta_12, eta_23, Turning::Forward)?;
            let in_balance = forward.force.si().abs() <= balance;
            moving(forward, if in_balance { Start::InBalance } else { Start::Held })
        }
    }
}

/// Sets accelerations and force to 0 for a drive that stays at rest.
fn settled(motion: Motion) -> Motion {
    if !matches!(motion.start, Start::InBalance | Start::Held) {
        return motion;
    }
    let rest = AngularAcceleration::from_si(0.0);
    let accelerations = Accelerations { sun: rest, planet: rest, carrier: rest };
    Motion { generalized_force: Torque::from_si(0.0), accelerations, ..motion }
}

fn time(speed: AngularVelocity, force: Torque, inertia: MomentOfInertia) -> Result<Time, Error> {
    let time = starting_time(speed, force, inertia)?;
    finite(Computed::StartingTime, time.si())?;
    Ok(time)
}
