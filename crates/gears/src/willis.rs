//! Willis' equation: the speeds of a gear set's members, and of its planets, from any two.
//!
//! ```text
//! ω_a − i₀·ω_b − (1 − i₀)·ω_H = 0        simple set, i₀ = −k: ω_a + k·ω_b − (1 + k)·ω_H = 0
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | `ω_a`, `ω_b`, `ω_H` | speed of sun, ring and carrier, positive along the axis | rad/s |
//! | `i₀` | basic ratio ([`BasicRatio`]) | 1 |
//!
//! # Source
//! multispeed-gearboxes (2.24), (2.25), table 2.3.

use crate::Error;
use crate::simple_set::BasicRatio;
use epicyclic_units::Physical;
use uom::si::f64::AngularVelocity;

/// Speeds of the three members of a gear set.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SetSpeeds {
    /// Speed of the sun, `ω_a`.
    pub sun: AngularVelocity,
    /// Speed of the ring, `ω_b`.
    pub ring: AngularVelocity,
    /// Speed of the carrier, `ω_H`.
    pub carrier: AngularVelocity,
}

/// Speed of the sun from ring and carrier: `ω_a = i₀·ω_b + (1 − i₀)·ω_H`.
#[must_use]
pub fn sun_speed(set: BasicRatio, ring: AngularVelocity, carrier: AngularVelocity) -> AngularVelocity {
    carrier + (ring - carrier) * set.get()
}

/// Speed of the ring from sun and carrier: `ω_b = ω_H + (ω_a − ω_H)/i₀`.
#[must_use]
pub fn ring_speed(set: BasicRatio, sun: AngularVelocity, carrier: AngularVelocity) -> AngularVelocity {
    carrier + (sun - carrier) / set.get()
}

/// Speed of the carrier from sun and ring: `ω_H = (ω_a − i₀·ω_b)/(1 − i₀)`.
///
/// # Errors
/// [`Error::CarrierUndetermined`] at `i₀ = 1`.
pub fn carrier_speed(
    set: BasicRatio,
    sun: AngularVelocity,
    ring: AngularVelocity,
) -> Result<AngularVelocity, Error> {
    let i0 = set.get();
    if i0 == 1.0 {
        return Err(Error::CarrierUndetermined);
    }
    // Written from the ring's speed so that equal speeds turn as one block to the last bit.
    Ok(ring + (sun - ring) / (1.0 - i0))
}

/// Speeds of all three members from any two of them.
///
/// ```
/// use epicyclic_gears::simple_set::BasicRatio;
/// use epicyclic_gears::willis;
/// use uom::si::angular_velocity::revolution_per_minute;
/// use uom::si::f64::AngularVelocity;
/// # fn main() -> Result<(), epicyclic_gears::Error> {
/// let rpm = AngularVelocity::new::<revolution_per_minute>;
/// let speeds = willis::speeds(BasicRatio::new(-5.0)?, Some(rpm(1950.0)), Some(rpm(0.0)), None)?;
/// assert!((speeds.carrier.get::<revolution_per_minute>() - 325.0).abs() < 1e-9);
/// # Ok(())
/// # }
/// ```
///
/// [`Error::KnownSpeeds`] unless exactly two are given; [`Error::CarrierUndetermined`] if the carrier speed
/// of a set with `i₀ = 1` is required.
pub fn speeds(
    set: BasicRatio,
    sun: Option<AngularVelocity>,
    ring: Option<AngularVelocity>,
    carrier: Option<AngularVelocity>,
) -> Result<SetSpeeds, Error> {
    match (sun, ring, carrier) {
        (Some(sun), Some(ring), None) => Ok(SetSpeeds { sun, ring, carrier: carrier_speed(set, sun, ring)? }),
        (Some(sun), None, Some(carrier)) => {
            Ok(SetSpeeds { sun, ring: ring_speed(set, sun, carrier), carrier })
        }
        (None, Some(ring), Some(carrier)) => {
            Ok(SetSpeeds { sun: sun_speed(set, ring, carrier), ring, carrier })
        }
        _ => {
            let known = [sun, ring, carrier].iter().flatten().count();
            Err(Error::KnownSpeeds { known })
        }
    }
}

/// Residual of Willis' equation, `ω_a − i₀·ω_b − (1 − i₀)·ω_H`: zero for consistent speeds.
#[must_use]
pub fn residual(set: BasicRatio, speeds: &SetSpeeds) -> AngularVelocity {
    (speeds.sun - speeds.carrier) - (speeds.ring - speeds.carrier) * set.get()
}

/// Speed of a planet about its own axis, seen from the housing and from the carrier.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlanetSpeed {
    /// Planet speed `ω_g`, seen from the housing.
    pub absolute: AngularVelocity,
    /// Planet speed relative to the carrier, `ω_g − ω_H`: the one its bearing sees.
    pub relative: AngularVelocity,
}

/// Speed of a planet in external mesh with the sun.
///
/// ```text
/// ω_g − ω_H = −(ω_a − ω_H)·z_a/z_g
/// ```
///
/// `planet_to_sun` is `z_g/z_a`; of a simple set known by `k` alone it is
/// [`RingToSunRatio::planet_to_sun`](crate::simple_set::RingToSunRatio::planet_to_sun).
///
/// excavator-dynamics takes `n₂ = n₁·z_1/z_2` with the absolute speed of the sun, which holds only
/// for a fixed carrier; this is the planet of a turning one.
///
/// # Errors
/// [`Error::BasicRatio`] unless `planet_to_sun` is finite and not 0.
pub fn planet_speed(
    planet_to_sun: f64,
    sun: AngularVelocity,
    carrier: AngularVelocity,
) -> Result<PlanetSpeed, Error> {
    if planet_to_sun == 0.0 || !planet_to_sun.is_finite() {
        return Err(Error::BasicRatio { i0: planet_to_sun });
    }
    let carrier = carrier.si();
    let relative = -(sun.si() - carrier) / planet_to_sun;
    Ok(PlanetSpeed {
        absolute: AngularVelocity::from_si(carrier + relative),
        relative: AngularVelocity::from_si(relative),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn excavator() -> BasicRatio {
        BasicRatio::new(-5.0).unwrap()
    }

    fn omega(value: f64) -> AngularVelocity {
        AngularVelocity::from_si(value)
    }

    #[test]
    fn planet_of_the_excavator_turns_backwards() {
        let planet = planet_speed(2.0, omega(204.1), omega(204.1 / 6.0)).unwrap();
        assert!((planet.absolute.si() - -51.025).abs() < 1e-9);
        assert!((planet.relative.si() - -85.041_666_666_666_67).abs() < 1e-9);
    }

    #[test]
    fn two_speeds_are_needed_and_no_more() {
        let one = speeds(excavator(), Some(omega(1.0)), None, None);
        assert_eq!(one, Err(Error::KnownSpeeds { known: 1 }));
        let three = speeds(excavator(), Some(omega(1.0)), Some(omega(1.0)), Some(omega(1.0)));
        assert_eq!(three, Err(Error::KnownSpeeds { known: 3 }));
    }

    #[test]
    fn a_planet_needs_teeth() {
        assert!(planet_speed(0.0, omega(1.0), omega(0.0)).is_err());
    }

    #[test]
    fn gears_that_turn_alike_say_nothing_of_the_carrier() {
        let alike = BasicRatio::new(1.0).unwrap();
        assert_eq!(carrier_speed(alike, omega(1.0), omega(1.0)), Err(Error::CarrierUndetermined));
    }

    fn any_set() -> impl Strategy<Value = BasicRatio> {
        prop_oneof![-20.0..-0.05, 0.05..0.95, 1.05..20.0_f64].prop_map(|i0| BasicRatio::new(i0).unwrap())
    }

    proptest! {
        #[test]
        fn any_two_speeds_give_the_third(set in any_set(), sun in -500.0..500.0, carrier in -500.0..500.0) {
            let (sun, carrier) = (omega(sun), omega(carrier));
            let whole = speeds(set, Some(sun), None, Some(carrier)).unwrap();
            let scale = [sun, carrier, whole.ring].map(|s| s.si().abs()).into_iter().fold(1.0, f64::max)
                * (1.0 + set.get().abs()) / (1.0 - set.get()).abs().min(1.0);
            prop_assert!(residual(set, &whole).si().abs() <= 1e-13 * scale);
            let from_ring = speeds(set, None, Some(whole.ring), Some(carrier)).unwrap();
            prop_assert!((from_ring.sun - sun).si().abs() <= 1e-13 * scale);
            let from_gears = speeds(set, Some(sun), Some(whole.ring), None).unwrap();
            prop_assert!((from_gears.carrier - carrier).si().abs() <= 1e-13 * scale);
        }

        #[test]
        fn equal_speeds_turn_as_one_block(set in any_set(), speed in -500.0..500.0, planet in 0.1..10.0) {
            let speed = omega(speed);
            let block = SetSpeeds { sun: speed, ring: speed, carrier: speed };
            prop_assert_eq!(speeds(set, Some(speed), Some(speed), None).unwrap(), block);
            prop_assert_eq!(speeds(set, Some(speed), None, Some(speed)).unwrap(), block);
            prop_assert_eq!(speeds(set, None, Some(speed), Some(speed)).unwrap(), block);
            prop_assert_eq!(planet_speed(planet, speed, speed).unwrap().absolute, speed);
        }

        #[test]
        fn the_planet_rolls_on_sun_and_ring_alike(k in 1.1..12.0, sun in -9.0..9.0, carrier in -9.0..9.0) {
            // Table 2.3: (k − 1)·ω_g = (k + 1)·ω_H − 2·ω_a = 2·k·ω_b − (k + 1)·ω_H.
            let k = crate::simple_set::RingToSunRatio::new(k).unwrap();
            let planet = planet_speed(k.planet_to_sun(), omega(sun), omega(carrier)).unwrap();
            let ring = ring_speed(k.into(), omega(sun), omega(carrier)).si();
            let k = k.get();
            let left = (k - 1.0) * planet.absolute.si();
            prop_assert!((left - ((k + 1.0) * carrier - 2.0 * sun)).abs() < 1e-11);
            prop_assert!((left - (2.0 * k * ring - (k + 1.0) * carrier)).abs() < 1e-11);
        }
    }
}
