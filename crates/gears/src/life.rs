//! Basic rating life of a rolling bearing: what nine of ten reach.
//!
//! ```text
//! L = (C/P)^p · 10⁶ revolutions     t = L·2π/|ω|     p = 3 of balls, 10/3 of rollers
//! ```
//!
//! | symbol | argument | meaning | unit |
//! |---|---|---|---|
//! | `C` | `load_rating` | basic dynamic load rating, of the bearings together | kN |
//! | `P` | `load` | equivalent load; of a radial one alone the load itself | N |
//! | `ω` | `speed` | speed of one race relative to the other | rpm |
//!
//! Left out: lubrication, dirt, the fatigue limit (`a_ISO` = 1), and loads that change. The formula holds for
//! loads up to about half of `C`.
//!
//! # Source
//! ISO 281:2007, basic rating life.

use std::f64::consts::TAU;

use epicyclic_units::Physical;
use uom::si::f64::{AngularVelocity, Force, Time};

use crate::checks::{not_negative, positive};
use crate::{Error, Quantity};

/// Rolling elements of a bearing, or the film of oil that a plain one turns on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Rolling {
    /// Balls, `p = 3`.
    #[default]
    Balls,
    /// Rollers in a cage, `p = 10/3`.
    Rollers,
    /// Needles in a cage, which bear a faster orbit.
    Needles,
    /// Rollers or needles without a cage, which bear less speed.
    FullComplement,
    /// Oil between pin and bore: a plain bearing, which has no rating life.
    Plain,
}

impl Rolling {
    /// Every kind of rolling elements.
    pub const ALL: [Self; 4] = [Self::Balls, Self::Rollers, Self::Needles, Self::FullComplement];

    /// The exponent `p`; `None` of plain bearings.
    #[must_use]
    pub const fn exponent(self) -> Option<f64> {
        match self {
            Self::Balls => Some(3.0),
            Self::Rollers | Self::Needles | Self::FullComplement => Some(10.0 / 3.0),
            Self::Plain => None,
        }
    }

    /// Name in files and tables of bearings.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Balls => "balls",
            Self::Rollers => "rollers",
            Self::Needles => "needles",
            Self::FullComplement => "full_complement",
            Self::Plain => "plain",
        }
    }
}

/// Basic rating life at one load and speed; `None` of a bearing that does not turn, carries nothing, or for
/// which it is longer than a number holds, and of plain bearings.
///
/// # Errors
/// [`Error::NotPositive`] for the load rating, [`Error::Negative`] for a load below 0 or a speed that is not
/// finite.
///
/// # Example
/// ```
/// use epicyclic_gears::life::{Rolling, basic_rating_life};
/// use uom::si::angular_velocity::revolution_per_minute;
/// use uom::si::f64::{AngularVelocity, Force};
/// use uom::si::{force::newton, time::hour};
///
/// // (10)³ million revolutions at 1000 a minute.
/// let (load_rating, load) = (Force::new::<newton>(30e3), Force::new::<newton>(3e3));
/// let speed = AngularVelocity::new::<revolution_per_minute>(1000.0);
/// let life = basic_rating_life(Rolling::Balls, load_rating, load, speed)?.unwrap();
/// assert!((life.get::<hour>() - 1e9 / 60e3).abs() < 1e-6);
/// # Ok::<(), epicyclic_gears::Error>(())
/// ```
pub fn basic_rating_life(
    rolling: Rolling,
    load_rating: Force,
    load: Force,
    speed: AngularVelocity,
) -> Result<Option<Time>, Error> {
    let load_rating_n = positive(Quantity::LoadRating, load_rating.si(), "N")?;
    let load_n = not_negative(Quantity::BearingLoad, load.si(), "N")?;
    let omega_rad_s = not_negative(Quantity::BearingSpeed, speed.si().abs(), "rad/s")?;
    let Some(exponent) = rolling.exponent() else { return Ok(None) };
    let life_s = libm::pow(load_rating_n / load_n, exponent) * 1e6 * TAU / omega_rad_s;
    Ok(life_s.is_finite().then(|| Time::from_si(life_s)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn twice_the_load_an_eighth_of_the_life_and_less_on_rollers() {
        let life = |rolling, load_n| {
            basic_rating_life(
                rolling,
                Force::from_si(40e3),
                Force::from_si(load_n),
                AngularVelocity::from_si(100.0),
            )
            .unwrap()
            .unwrap()
        };
        let ratio = |rolling| (life(rolling, 2e3) / life(rolling, 4e3)).value;
        assert!((ratio(Rolling::Balls) - 8.0).abs() < 1e-12);
        assert!((ratio(Rolling::Rollers) - libm::pow(2_f64, 10.0 / 3.0)).abs() < 1e-12);
        // At P = C one million revolutions, whatever rolls.
        for rolling in [Rolling::Balls, Rolling::Rollers] {
            assert!((life(rolling, 40e3).value * 100.0 / TAU / 1e6 - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn what_does_not_turn_or_carry_has_no_life() {
        let of = |load_rating_n, load_n, omega_rad_s| {
            basic_rating_life(
                Rolling::Balls,
                Force::from_si(load_rating_n),
                Force::from_si(load_n),
                AngularVelocity::from_si(omega_rad_s),
            )
        };
        assert_eq!(of(1e3, 1e2, 0.0), Ok(None));
        assert_eq!(of(1e3, 0.0, 10.0), Ok(None));
        let plain = basic_rating_life(
            Rolling::Plain,
            Force::from_si(1e3),
            Force::from_si(1e2),
            AngularVelocity::from_si(10.0),
        );
        assert_eq!(plain, Ok(None));
        assert!(of(1e3, 1e2, -10.0).unwrap().is_some());
        assert!(matches!(of(0.0, 1e2, 10.0), Err(Error::NotPositive { .. })));
        assert!(matches!(of(1e3, -1.0, 10.0), Err(Error::Negative { .. })));
        assert!(matches!(of(1e3, 1e2, f64::NAN), Err(Error::Negative { .. })));
    }
}
