//! Reduction and start of a drive.

use super::finite;
use super::result::{Masses, Motion, Reduction, Start};
use super::spec::DriveSpec;
use crate::Error;
use crate::energy::kinetic_energy;
use crate::lagrange::starting_time;
use crate::planetary::{Accelerations, PlanetaryDrive};
use crate::reduction::{Link, Orbit};
use crate::units::{angular_acceleration, inertia, joules, kg_m2, n_m, rad_per_s2, seconds, torque};
use uom::si::f64::{MomentOfInertia, Torque};

/// Part of the driving torque below which a surplus is the rounding of the calculation.
const BALANCE: f64 = 1e-9;

/// Each part's share of the reduced inertia, and the kinetic energy.
pub(super) fn reduction(
    spec: &DriveSpec,
    drive: &PlanetaryDrive,
    masses: &Masses,
) -> Result<Reduction, Error> {
    let ratios = drive.speed_ratios()?;
    let central = |name: &str, j: MomentOfInertia, ratio| Link::central(name, j, ratio).reduced_inertia();
    let orbit = Orbit { mass: drive.planet_mass, radius: drive.planet_radius, speed_ratio: ratios.carrier };
    let planets =
        Link { count: drive.teeth.planets, ..Link::central("planets", inertia(0.0), ratios.planet) };
    let reduced = Reduction {
        sun: central("sun", masses.sun.body.total().polar_inertia, 1.0)?,
        motor: central("motor", spec.motor_inertia, 1.0)?,
        planets_orbiting: Link { orbit: Some(orbit), ..planets.clone() }.reduced_inertia()?,
        planets_turning: Link { inertia: drive.planet_inertia, ..planets }.reduced_inertia()?,
        carrier: central("carrier", masses.carrier_inertia, ratios.carrier)?,
        machine: central("driven machine", spec.machine_inertia, ratios.carrier)?,
        reduced_inertia: drive.reduced_inertia()?,
        kinetic_energy: kinetic_energy(&drive.bodies(spec.speed)?),
    };
    finite("reduced inertia", kg_m2(reduced.reduced_inertia))?;
    finite("kinetic energy", joules(reduced.kinetic_energy))?;
    Ok(reduced)
}

pub(super) fn without_losses(
    spec: &DriveSpec,
    drive: &PlanetaryDrive,
    driving: Torque,
    load: Torque,
) -> Result<Motion, Error> {
    let accelerations = drive.motion(driving, load)?;
    finite("acceleration", rad_per_s2(accelerations.sun))?;
    let force = drive.generalized_force(driving, load)?;
    let inertia = drive.reduced_inertia()?;
    Ok(settled(Motion {
        inertia,
        generalized_force: force,
        accelerations,
        start: start(spec, driving, force, inertia)?,
    }))
}

pub(super) fn with_losses(
    spec: &DriveSpec,
    drive: &PlanetaryDrive,
    driving: Torque,
    load: Torque,
) -> Result<Motion, Error> {
    let (eta_12, eta_23) = (spec.sun_planet_efficiency, spec.planet_ring_efficiency);
    let motion = drive.motion_with_losses(driving, load, eta_12, eta_23)?;
    finite("acceleration", rad_per_s2(motion.accelerations.sun))?;
    Ok(settled(Motion {
        inertia: motion.inertia,
        generalized_force: motion.force,
        accelerations: motion.accelerations,
        start: start(spec, driving, motion.force, motion.inertia)?,
    }))
}

/// In balance nothing accelerates: what rounding left of the force is dropped.
fn settled(motion: Motion) -> Motion {
    if motion.start != Start::InBalance {
        return motion;
    }
    let rest = angular_acceleration(0.0);
    let accelerations = Accelerations { sun: rest, planet: rest, carrier: rest };
    Motion { generalized_force: torque(0.0), accelerations, ..motion }
}

fn start(spec: &DriveSpec, driving: Torque, force: Torque, inertia: MomentOfInertia) -> Result<Start, Error> {
    let surplus = n_m(force);
    if surplus.abs() <= BALANCE * n_m(driving) {
        return Ok(Start::InBalance);
    }
    if surplus < 0.0 {
        return Ok(Start::Overloaded(torque(-surplus)));
    }
    let time = starting_time(spec.speed, force, inertia)?;
    finite("starting time", seconds(time))?;
    Ok(Start::After(time))
}
