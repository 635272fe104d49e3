//! Torques and powers on the shafts of a simple planetary drive.
//!
//! # Source
//! excavator-dynamics, torques and powers on the shafts.

use crate::Error;
use crate::equivalent_inertia::{LinkName, Property};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_units::Physical;
use uom::si::f64::{AngularVelocity, Power, Torque};

/// Torque that carries a power at a speed, `T = P/ω`.
///
/// # Errors
/// [`Error::NotFinite`] at rest, where no torque carries a power.
pub fn shaft_torque(carried: Power, speed: AngularVelocity) -> Result<Torque, Error> {
    let value = carried.si() / speed.si();
    if value.is_finite() {
        Ok(Torque::from_si(value))
    } else {
        Err(Error::NotFinite { link: LinkName::Shaft, what: Property::Torque, value })
    }
}

/// Power of a torque at a speed, `P = T·ω`.
#[must_use]
pub fn shaft_power(carried: Torque, speed: AngularVelocity) -> Power {
    Power::from_si(carried.si() * speed.si())
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

    #[test]
    fn the_excavators_shafts() {
        let sun = shaft_torque(Power::from_si(106.5e3), AngularVelocity::from_si(204.1)).unwrap();
        assert!((sun.si() - 521.8).abs() < 0.01);
        assert!((shaft_power(sun, AngularVelocity::from_si(204.1)).si() - 106.5e3).abs() < 1e-9);
        assert!((carrier_torque(Torque::from_si(521.8), 6.0, 0.95).si() - 2974.26).abs() < 1e-9);
        let eta = MeshEfficiency::new(0.97).unwrap();
        assert!((planet_torque(Torque::from_si(521.8), eta, 2.0).si() - 1012.292).abs() < 1e-9);
        let bearings = MeshEfficiency::new(0.99).unwrap();
        assert!((planet_power(Power::from_si(106.5e3), eta, bearings).si() - 102_271.95).abs() < 1e-6);
    }

    #[test]
    fn no_torque_carries_power_at_rest() {
        assert!(shaft_torque(Power::from_si(1.0), AngularVelocity::from_si(0.0)).is_err());
    }
}
