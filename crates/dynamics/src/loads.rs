//! Torques and powers on the shafts of a simple planetary drive.
//!
//! # Source
//! excavator-dynamics, torques and powers on the shafts.

use crate::Error;
use crate::equivalent_inertia::{LinkName, Property};
use crate::units::{n_m, power, rad_per_s, torque, watts};
use epicyclic_gears::efficiency::MeshEfficiency;
use uom::si::f64::{AngularVelocity, Power, Torque};

/// Torque that carries a power at a speed, `T = P/ω`.
///
/// # Errors
/// [`Error::NotFinite`] at rest, where no torque carries a power.
pub fn shaft_torque(carried: Power, speed: AngularVelocity) -> Result<Torque, Error> {
    let value = watts(carried) / rad_per_s(speed);
    if value.is_finite() {
        Ok(torque(value))
    } else {
        Err(Error::NotFinite { link: LinkName::Shaft, what: Property::Torque, value })
    }
}

/// Power of a torque at a speed, `P = T·ω`.
#[must_use]
pub fn shaft_power(carried: Torque, speed: AngularVelocity) -> Power {
    power(n_m(carried) * rad_per_s(speed))
}

/// Torque of the carrier from that of the sun, `T_H = T_1·U·η`.
#[must_use]
pub fn carrier_torque(sun: Torque, ratio: f64, efficiency: f64) -> Torque {
    sun * ratio * efficiency
}

/// Torque of all planets together about their own axes, `T_2 = T_1·η_12·z_2/z_1`.
///
/// The source takes it as the torque of one planet's shaft. There are `N` planets, and the pin of
/// a planet that meshes with sun and ring transmits no torque: it is bent by the carrier's force.
#[must_use]
pub fn planet_torque(sun: Torque, sun_planet: MeshEfficiency, planet_to_sun: f64) -> Torque {
    sun * sun_planet.get() * planet_to_sun
}

/// Power on the shafts of all planets as the source counts, `N_2 = N_1·η_12·η_b`: as if the carrier stood
/// still, so that all of the power passed through the planets. On a turning carrier the rolling power does.
#[must_use]
pub fn planet_power(input: Power, sun_planet: MeshEfficiency, bearings: MeshEfficiency) -> Power {
    input * MeshEfficiency::of_meshes(&[sun_planet, bearings]).get()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::angular_velocity;

    #[test]
    fn the_excavators_shafts() {
        let sun = shaft_torque(power(106.5e3), angular_velocity(204.1)).unwrap();
        assert!((n_m(sun) - 521.8).abs() < 0.01);
        assert!((watts(shaft_power(sun, angular_velocity(204.1))) - 106.5e3).abs() < 1e-9);
        assert!((n_m(carrier_torque(torque(521.8), 6.0, 0.95)) - 2974.26).abs() < 1e-9);
        let eta = MeshEfficiency::new(0.97).unwrap();
        assert!((n_m(planet_torque(torque(521.8), eta, 2.0)) - 1012.292).abs() < 1e-9);
        let bearings = MeshEfficiency::new(0.99).unwrap();
        assert!((watts(planet_power(power(106.5e3), eta, bearings)) - 102_271.95).abs() < 1e-6);
    }

    #[test]
    fn no_torque_carries_power_at_rest() {
        assert!(shaft_torque(power(1.0), angular_velocity(0.0)).is_err());
    }
}
