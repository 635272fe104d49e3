//! Calculations of motion.

use super::{Calculation, Refusal, Results};
use epicyclic_dynamics::energy::{MovingBody, kinetic_energy};
use epicyclic_dynamics::planetary::{GearSet, PlanetaryDrive, Turning};
use epicyclic_dynamics::{lagrange, loads};
use epicyclic_gears::ToothCount;
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::synthesis::ToothNumbers;
use epicyclic_units::{Number, Quantity};
use schemars::JsonSchema;
use serde::Deserialize;
use uom::si::f64::{AngularAcceleration, AngularVelocity, Length, Mass, MomentOfInertia, Power, Torque};

pub(super) fn calculations() -> Vec<Calculation> {
    vec![
        Calculation::new("dynamics.shaft_loads", "torques and powers on the shafts of a drive", shaft_loads),
        Calculation::new("dynamics.planetary", "energy, equivalent inertia and motion of a drive", planetary),
        Calculation::new(
            "dynamics.link_accelerations",
            "accelerations of planet and carrier for one of the sun",
            link_accelerations,
        ),
        Calculation::new(
            "dynamics.reduced",
            "energy and acceleration of a drive known by its equivalent inertia",
            reduced,
        ),
    ]
}

/// A drive's power and how its gear passes it on.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct ShaftLoadsGiven {
    /// Power at the sun.
    power: Quantity<Power>,
    /// Speed of the sun.
    sun_speed: Quantity<AngularVelocity>,
    /// Speed of the carrier.
    carrier_speed: Quantity<AngularVelocity>,
    /// Torque of the sun where the source rounds it; `P/ω` unless given.
    #[serde(default)]
    sun_torque: Option<Quantity<Torque>>,
    /// Torque of the carrier where the source rounds it; computed unless given.
    #[serde(default)]
    carrier_torque: Option<Quantity<Torque>>,
    /// Ratio from the sun to the carrier.
    ratio: Number,
    /// Efficiency from the sun to the carrier.
    efficiency: Number,
    /// Efficiency of the mesh sun–planet.
    sun_planet: Number,
    /// Efficiency of a planet's bearing.
    bearing: Number,
    /// Planet to sun, `z_2/z_1`.
    planet_to_sun: Number,
}

fn shaft_loads(given: &ShaftLoadsGiven) -> Result<Results, Refusal> {
    let sun = loads::shaft_torque(given.power.0, given.sun_speed.0)?;
    // A rounded torque of the source replaces the exact one only in what the source calculates from it.
    let taken = given.sun_torque.map_or(sun, |torque| torque.0);
    let mesh = MeshEfficiency::new(given.sun_planet.get())?;
    let bearing = MeshEfficiency::new(given.bearing.get())?;
    let carrier = loads::carrier_torque(taken, given.ratio.get(), given.efficiency.get());
    let carried = given.carrier_torque.map_or(carrier, |torque| torque.0);
    let mut results = Results::default();
    results
        .quantity("sun_torque", sun)
        .quantity("planet_torque", loads::planet_torque(taken, mesh, given.planet_to_sun.get()))
        .quantity("carrier_torque", carrier)
        .quantity("planet_power", loads::planet_power(given.power.0, mesh, bearing))
        .quantity("carrier_power", loads::shaft_power(carried, given.carrier_speed.0));
    Ok(results)
}

/// A simple planetary drive with its masses, and what acts on it.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct PlanetaryGiven {
    /// Teeth of the sun.
    sun: u32,
    /// Teeth of a planet.
    planet: u32,
    /// Teeth of the ring.
    ring: u32,
    /// Number of planets.
    planets: u32,
    /// Inertia of the driving shaft with the sun.
    sun_inertia: Quantity<MomentOfInertia>,
    /// Inertia of one planet about its own axis.
    planet_inertia: Quantity<MomentOfInertia>,
    /// Mass of one planet.
    planet_mass: Quantity<Mass>,
    /// Radius of the planets' centres.
    planet_radius: Quantity<Length>,
    /// Inertia of the carrier without planets.
    carrier_inertia: Quantity<MomentOfInertia>,
    /// Speed of the sun.
    speed: Quantity<AngularVelocity>,
    /// Torque on the sun.
    driving_torque: Quantity<Torque>,
    /// Load on the carrier.
    load_torque: Quantity<Torque>,
    /// Efficiency of the mesh sun–planet.
    sun_planet: Number,
    /// Efficiency of the mesh planet–ring.
    planet_ring: Number,
}

fn tooth_set(sun: u32, planet: u32, ring: u32, planets: u32) -> Result<ToothNumbers, Refusal> {
    let (sun, planet, ring) = (ToothCount::new(sun)?, ToothCount::new(planet)?, ToothCount::new(ring)?);
    Ok(ToothNumbers { sun, planet, ring, planets })
}

fn planetary(given: &PlanetaryGiven) -> Result<Results, Refusal> {
    let drive = PlanetaryDrive {
        set: GearSet::new(tooth_set(given.sun, given.planet, given.ring, given.planets)?)?,
        sun_inertia: given.sun_inertia.0,
        planet_inertia: given.planet_inertia.0,
        planet_mass: given.planet_mass.0,
        planet_radius: given.planet_radius.0,
        carrier_inertia: given.carrier_inertia.0,
    };
    let (driving, load) = (given.driving_torque.0, given.load_torque.0);
    let ratios = drive.set.ratios();
    let force = drive.generalized_force(driving, load);
    let motion = drive.motion(driving, load)?;
    let sun_planet = MeshEfficiency::new(given.sun_planet.get())?;
    let planet_ring = MeshEfficiency::new(given.planet_ring.get())?;
    // The direction of motion decides in which direction friction acts, even during the start.
    let turning = if given.speed.0.value < 0.0 { Turning::Backward } else { Turning::Forward };
    let lossy = drive.motion_with_losses(driving, load, sun_planet, planet_ring, turning)?;
    let [held_from, held_to] = drive.held_loads(driving, sun_planet, planet_ring);

    let mut results = Results::default();
    results
        .number("planet_speed_ratio", ratios.planet)
        .number("carrier_speed_ratio", ratios.carrier)
        .quantity("kinetic_energy", kinetic_energy(&drive.bodies(given.speed.0)?))
        .quantity("equivalent_inertia", drive.equivalent_inertia()?);
    for link in drive.links() {
        results.quantity(format!("share.{}", link.name), link.equivalent_inertia()?);
    }
    results
        .quantity("reduced_load", load * ratios.carrier)
        .quantity("generalized_force", force)
        .quantity("acceleration.sun", motion.sun)
        .quantity("acceleration.planet", motion.planet)
        .quantity("acceleration.carrier", motion.carrier)
        .answer("accelerates", motion.sun.value > 0.0)
        .answer("accelerations_have_the_signs_of_speeds", {
            let sun = given.speed.0.value;
            let speeds = [sun, sun * ratios.planet, sun * ratios.carrier];
            let accelerations = [motion.sun, motion.planet, motion.carrier];
            speeds.iter().zip(accelerations).all(|(speed, acceleration)| speed * acceleration.value > 0.0)
        })
        .quantity("with_losses.inertia", lossy.inertia)
        .quantity("with_losses.generalized_force", lossy.force)
        .quantity("with_losses.acceleration.sun", lossy.accelerations.sun)
        .quantity("with_losses.acceleration.planet", lossy.accelerations.planet)
        .quantity("with_losses.acceleration.carrier", lossy.accelerations.carrier)
        .quantity("with_losses.held.from", held_from)
        .quantity("with_losses.held.to", held_to)
        .quantity("with_losses.mesh_loss", drive.mesh_loss(&lossy, given.speed.0, sun_planet, planet_ring));
    if let Ok(time) = lagrange::starting_time(given.speed.0, force, drive.equivalent_inertia()?) {
        results.quantity("starting_time", time);
    }
    Ok(results)
}

/// A tooth set and the acceleration of its sun, the ring at rest.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct LinkAccelerationsGiven {
    /// Teeth of the sun.
    sun: u32,
    /// Teeth of a planet.
    planet: u32,
    /// Teeth of the ring.
    ring: u32,
    /// Acceleration of the sun.
    acceleration: Quantity<AngularAcceleration>,
}

fn link_accelerations(given: &LinkAccelerationsGiven) -> Result<Results, Refusal> {
    let ratios = GearSet::new(tooth_set(given.sun, given.planet, given.ring, 1)?)?.ratios();
    let mut results = Results::default();
    results
        .quantity("planet", lagrange::link_acceleration(given.acceleration.0, ratios.planet))
        .quantity("carrier", lagrange::link_acceleration(given.acceleration.0, ratios.carrier));
    Ok(results)
}

/// A drive known by its equivalent inertia alone.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct ReducedGiven {
    /// Equivalent inertia.
    inertia: Quantity<MomentOfInertia>,
    /// Speed of the driving shaft.
    speed: Quantity<AngularVelocity>,
    /// Generalized force.
    force: Quantity<Torque>,
}

fn reduced(given: &ReducedGiven) -> Result<Results, Refusal> {
    let body = MovingBody::turning(given.inertia.0, given.speed.0);
    let mut results = Results::default();
    results
        .quantity("kinetic_energy", kinetic_energy(&[body]))
        .quantity("acceleration", lagrange::acceleration(given.force.0, given.inertia.0)?);
    Ok(results)
}
