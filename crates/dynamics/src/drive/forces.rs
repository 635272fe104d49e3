//! Forces in the meshes and on the planet bearings of a drive.

use super::finite;
use super::result::{Forces, GearSetGeometry, Masses, Speeds, Torques};
use super::spec::DriveSpec;
use crate::Error;
use crate::units::{force, meters, n_m, newtons};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::geometry::{GearKind, ToothedGear};
use epicyclic_gears::planet_bearing::{self, Push};
use epicyclic_gears::synthesis::ToothNumbers;
use uom::si::f64::Torque;

pub(super) fn forces(
    spec: &DriveSpec,
    teeth: ToothNumbers,
    gear_set: &GearSetGeometry,
    torques: &Torques,
    speeds: &Speeds,
    masses: &Masses,
) -> Result<Forces, Error> {
    let (planets, radius) = (teeth.planets, gear_set.centre_distance);
    let nominal = |t: Torque, gear: &ToothedGear| {
        force(2.0 * n_m(t) / (f64::from(planets) * meters(gear.pitch_diameter())))
    };
    let push =
        |torque, gear: &ToothedGear, kind| Push { kind, pitch_radius: gear.pitch_diameter() / 2.0, torque };
    let pushes = [
        push(torques.sun, &gear_set.sun, GearKind::External),
        push(torques.ring_reaction, &gear_set.ring, GearKind::Internal),
    ];
    let share = MeshEfficiency::share_of_loss(spec.sun_planet_efficiency, spec.planet_ring_efficiency);
    let [sun_mesh, ring_mesh] = planet_bearing::two_mesh_forces(&pushes, share, planets, radius)?;
    let kinds_and_forces = [(GearKind::External, sun_mesh), (GearKind::Internal, ring_mesh)];
    let planet_bearing_tangential = planet_bearing::tangential_force(torques.carrier, planets, radius)?;
    let planet_bearing_meshes =
        planet_bearing::radial_force_of(&kinds_and_forces, spec.gear_set.rack.pressure_angle)?;
    let planet_bearing_centrifugal =
        planet_bearing::centrifugal_force(masses.planet.body.total().mass, radius, speeds.carrier)?;
    let resultant = planet_bearing::resultant(
        planet_bearing_tangential,
        planet_bearing_meshes + planet_bearing_centrifugal,
    );
    finite("force on a planet bearing", newtons(resultant))?;
    finite("force at a mesh", newtons(sun_mesh))?;
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
