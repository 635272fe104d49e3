//! The loads of the two meshes of a simple set.
//!
//! ```text
//! sun–planet   T = T_s/p               n = |n_s − n_H|                contacts p and 1
//! planet–ring  T = T_s/p·z_p/z_s       n = |n_s − n_H|·z_s/z_p        contacts 1 and p
//! ```
//!
//! | symbol | argument | meaning | unit |
//! |---|---|---|---|
//! | `T_s` | `sun_torque` | torque on the sun, without the losses | N·m |
//! | `n_s − n_H` | `sun_speed` | speed of the sun relative to the carrier | rpm |
//! | `p` | `planets` | planets, all alike; what they do not share alike is `K_γ` | 1 |
//! | `z_s`, `z_p` | `sun`, `planet` | teeth | 1 |
//!
//! Without losses both meshes have the same tangential force at the reference circles.
//!
//! Each flank of a planet meets once in a revolution: one with the sun, the other with the ring.
//!
//! # Axial forces
//! Helical teeth also push along the axis. Sun and ring push on a planet in opposite directions at both ends
//! of a diameter, so the planet tilts.
//!
//! ```text
//! F_a = F_t·tan β        M = (F_a1·d_w1 + F_a2·d_w2)/2
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | `F_a` | axial force of one mesh | N |
//! | `F_t`, `β` | tangential force and helix angle at the reference cylinders | N, ° |
//! | `d_w1`, `d_w2` | working diameters of a planet in the mesh with the sun and with the ring | m |
//! | `M` | moment that tilts one planet, about the tangent of its orbit | N·m |
//!
//! Without losses `F_a` is the same in both meshes. The force on the sun and on the ring is `p·F_a`.

use crate::mesh::Load;
use crate::{Error, Quantity};
use epicyclic_gears::ToothCount;
use epicyclic_gears::involute::Pair;
use epicyclic_units::Physical;
use uom::si::f64::{AngularVelocity, Force, Length, Time, Torque};

/// Loads of the mesh of sun and planet, and of the mesh of planet and ring. The signs of torque and speed do
/// not matter.
///
/// # Errors
/// [`Error::NotPositive`] without planets.
///
/// # Example
/// ```
/// use epicyclic_gears::ToothCount;
/// use epicyclic_strength::planets::loads;
/// use uom::si::angular_velocity::revolution_per_minute;
/// use uom::si::f64::{AngularVelocity, Time, Torque};
/// use uom::si::{time::hour, torque::newton_meter};
///
/// # fn main() -> Result<(), epicyclic_strength::Error> {
/// let speed = AngularVelocity::new::<revolution_per_minute>(1200.0);
/// let [outer, inner] = loads(
///     Torque::new::<newton_meter>(-300.0), speed, 3, [ToothCount::new(20)?, ToothCount::new(40)?],
///     Time::new::<hour>(1e4),
/// )?;
/// assert!((outer.torque.get::<newton_meter>() - 100.0).abs() < 1e-9);
/// assert!((inner.torque.get::<newton_meter>() - 200.0).abs() < 1e-9);
/// assert!((inner.speed.get::<revolution_per_minute>() - 600.0).abs() < 1e-9);
/// # Ok(())
/// # }
/// ```
pub fn loads(
    sun_torque: Torque,
    sun_speed: AngularVelocity,
    planets: u32,
    [sun, planet]: [ToothCount; 2],
    life: Time,
) -> Result<[Load; 2], Error> {
    if planets == 0 {
        return Err(Error::NotPositive { quantity: Quantity::Planets, value: 0.0, unit: "planets" });
    }
    let each = f64::from(planets);
    let ratio = planet.as_f64() / sun.as_f64();
    let (torque, speed) = (sun_torque.abs() / each, sun_speed.abs());
    Ok([
        Load { torque, speed, life, contacts: [each, 1.0] },
        Load { torque: torque * ratio, speed: speed / ratio, life, contacts: [1.0, each] },
    ])
}

/// Axial load of a planet with helical teeth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AxialForces {
    /// `F_a` of the meshes with sun and ring.
    pub forces: [Force; 2],
    /// `M`, which tilts a planet.
    pub tilting_moment: Torque,
}

/// Axial forces of the meshes of a planet with sun and ring, and the moment of both; 0 of spur teeth.
/// `module` is the normal one, the tangential forces are those of each mesh at the reference cylinders.
#[must_use]
pub fn axial_forces(
    [sun_mesh, ring_mesh]: [&Pair; 2],
    module: Length,
    tangential: [Force; 2],
) -> AxialForces {
    let tan = libm::tan(sun_mesh.gears()[0].profile().helix_angle.si());
    let forces = tangential.map(|force| force * tan);
    let diameters = [sun_mesh.working_diameters()[1], ring_mesh.working_diameters()[0]];
    let moments = [0, 1].map(|mesh| forces[mesh].si() * diameters[mesh] / 2.0);
    AxialForces { forces, tilting_moment: Torque::from_si((moments[0] + moments[1]) * module.mm() / 1000.0) }
}
