//! Forces in the meshes and on the planet bearings of a drive.

use super::finite;
use super::loads::Meshes;
use super::part::Computed;
use super::result::{Forces, GearMass, GearSetGeometry, Torques};
use crate::Error;
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::geometry::{GearKind, ToothedGear};
use epicyclic_gears::planet_bearing::{self, Push};
use epicyclic_units::Physical;
use uom::si::f64::{AngularVelocity, Force, Torque};

pub(super) fn forces(
    meshes: Meshes,
    planets: u32,
    gear_set: &GearSetGeometry,
    torques: &Torques,
    carrier_speed: AngularVelocity,
    planet: &GearMass,
) -> Result<Forces, Error> {
    let radius = gear_set.centre_distance;
    let nominal = |t: Torque, gear: &ToothedGear| {
        Force::from_si(2.0 * t.si() / (f64::from(planets) * gear.pitch_diameter().si()))
    };
    let push =
        |torque, gear: &ToothedGear, kind| Push { kind, pitch_radius: gear.pitch_diameter() / 2.0, torque };
    let pushes = [
        push(torques.sun, &gear_set.sun, GearKind::External),
        push(torques.ring_reaction, &gear_set.ring, GearKind::Internal),
    ];
    let share = {
        let [to_planet, to_ring] = meshes.two();
        MeshEfficiency::share_of_loss(to_planet, to_ring)
    };
    let [sun_mesh, ring_mesh] = planet_bearing::two_mesh_forces(&pushes, share, planets, radius)?;
    let angle = gear_set.planet.rack().pressure_angle;
    let meshes = [(GearKind::External, sun_mesh, angle), (GearKind::Internal, ring_mesh, angle)];
    let planet_bearing_tangential = planet_bearing::tangential_force(torques.carrier, planets, radius)?;
    let planet_bearing_meshes = planet_bearing::radial_force_of(&meshes)?;
    let planet_bearing_centrifugal = planet_bearing::centrifugal_force(planet.mass, radius, carrier_speed)?;
    let resultant = planet_bearing::resultant(
        planet_bearing_tangential,
        planet_bearing_meshes + planet_bearing_centrifugal,
    );
    finite(Computed::BearingForce, resultant.si())?;
    finite(Computed::MeshForce, sun_mesh.si())?;
    Ok(Forces {
        sun_mesh,
        ring_mesh,
        sun_nominal: nominal(torques.sun, &gear_set.sun),
        ring_nominal: nominal(torques.ring_reaction, &gear_set.ring),
        planet_bearing_tangential,
        planet_bearing_meshes,
        planet_bearing_centrifugal,
        planet_bearing: resultant,
    })
}
