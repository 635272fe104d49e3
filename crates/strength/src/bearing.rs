//! Modified rating life of rolling bearings: lubrication, dirt, fatigue limit, reliability.
//!
//! ```text
//! L_nm = a_1·a_ISO·L_10
//! a_ISO = 0.1·(1 − (2.5671 − C/κ^p)^0.83·(e_C·C_u/P)^⅓)^−9.3         balls
//! a_ISO = 0.1·(1 − (1.5859 − C'/κ^p)·(e_C·C_u/P)^0.4)^−9.185         rollers
//! κ = ν/ν_1,   ν_1 = 45000·n^−0.83/√D_pw below 1000 rpm, 4500/√(n·D_pw) above
//! ```
//!
//! | κ | C | C' | p |
//! |---|---|---|---|
//! | 0.1 to 0.4 | 2.2649 | 1.3993 | 0.054381 |
//! | to 1 | 1.9987 | 1.2348 | 0.19087 |
//! | to 4 | 1.9987 | 1.2348 | 0.071739 |
//!
//! | symbol | argument | meaning | unit |
//! |---|---|---|---|
//! | `κ` | `viscosity_ratio` | viscosity of the oil over that which the bearing needs, at most 4 | 1 |
//! | `e_C` | `contamination` | contamination factor, 0 to 1 | 1 |
//! | `C_u`, `P` | `fatigue_limit`, `load` | fatigue load limit, equivalent load | N |
//! | `a_1` | [`Reliability`] | 1, 0.64, 0.55, 0.47, 0.37, 0.25 at 90, 95, 96, 97, 98, 99 % | 1 |
//!
//! `κ` is taken at the temperature of the oil; above 4 it counts as 4. `a_ISO` is at most 50. The basic life
//! `L_10` is that of [`epicyclic_gears::life`].
//!
//! # Source
//! ISO 281:2007, formulas (31) to (36) for radial bearings.

use crate::checks::{not_negative, positive, whole, within};
use crate::{Error, Quantity};
use epicyclic_gears::life::{Rolling, basic_rating_life};
use epicyclic_units::Physical;
use uom::si::f64::{AngularVelocity, Force, KinematicViscosity, Length, Time};

/// Part of bearings that reach the life.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Reliability {
    /// 90 %: `a_1` = 1.
    #[default]
    Percent90,
    /// 95 %: 0.64.
    Percent95,
    /// 96 %: 0.55.
    Percent96,
    /// 97 %: 0.47.
    Percent97,
    /// 98 %: 0.37.
    Percent98,
    /// 99 %: 0.25.
    Percent99,
}

impl Reliability {
    /// Listed reliabilities, the lowest first.
    pub const ALL: [Self; 6] = [
        Self::Percent90,
        Self::Percent95,
        Self::Percent96,
        Self::Percent97,
        Self::Percent98,
        Self::Percent99,
    ];

    /// The part of bearings: 0.9.
    #[must_use]
    pub const fn part(self) -> f64 {
        match self {
            Self::Percent90 => 0.9,
            Self::Percent95 => 0.95,
            Self::Percent96 => 0.96,
            Self::Percent97 => 0.97,
            Self::Percent98 => 0.98,
            Self::Percent99 => 0.99,
        }
    }

    /// `a_1`.
    #[must_use]
    pub const fn factor(self) -> f64 {
        match self {
            Self::Percent90 => 1.0,
            Self::Percent95 => 0.64,
            Self::Percent96 => 0.55,
            Self::Percent97 => 0.47,
            Self::Percent98 => 0.37,
            Self::Percent99 => 0.25,
        }
    }
}

/// The greatest `a_ISO`.
const MOST: f64 = 50.0;

/// `a_ISO` of a radial bearing.
///
/// # Errors
/// [`Error::OutOfRange`] for `κ` below 0.1 or `e_C` outside 0 to 1; [`Error::NotPositive`] for a load,
/// [`Error::Negative`] for a fatigue limit.
///
/// # Example
/// ```
/// use epicyclic_gears::life::Rolling;
/// use epicyclic_strength::bearing::life_modification;
/// use uom::si::f64::Force;
/// use uom::si::force::kilonewton;
///
/// let kn = Force::new::<kilonewton>;
/// let clean = life_modification(Rolling::Balls, 2.0, 0.8, kn(1.3), kn(10.0))?;
/// let dirty = life_modification(Rolling::Balls, 2.0, 0.2, kn(1.3), kn(10.0))?;
/// assert!(clean > dirty && dirty > 0.1);
/// # Ok::<(), epicyclic_strength::Error>(())
/// ```
pub fn life_modification(
    rolling: Rolling,
    viscosity_ratio: f64,
    contamination: f64,
    fatigue_limit: Force,
    load: Force,
) -> Result<f64, Error> {
    let kappa = within(Quantity::ViscosityRatio, viscosity_ratio, [0.1, f64::MAX], "")?.min(4.0);
    let contamination = within(Quantity::Contamination, contamination, [0.0, 1.0], "")?;
    let limit = not_negative(Quantity::FatigueLoadLimit, fatigue_limit.si(), "N")?;
    let load = positive(Quantity::BearingLoad, load.si(), "N")?;
    let ratio = contamination * limit / load;
    let (balls, rollers, exponent) = if kappa < 0.4 {
        (2.2649, 1.3993, 0.054_381)
    } else if kappa < 1.0 {
        (1.9987, 1.2348, 0.190_87)
    } else {
        (1.9987, 1.2348, 0.071_739)
    };
    let film = libm::pow(kappa, exponent);
    let (rest, power) = match rolling {
        Rolling::Balls => (1.0 - libm::pow(2.5671 - balls / film, 0.83) * libm::cbrt(ratio), -9.3),
        _ => (1.0 - (1.5859 - rollers / film) * libm::pow(ratio, 0.4), -9.185),
    };
    Ok(if rest > 0.0 { (0.1 * libm::pow(rest, power)).min(MOST) } else { MOST })
}

/// `κ` of the oil's viscosity at its temperature.
///
/// # Errors
/// [`Error::NotPositive`] for a viscosity, a speed or a mean diameter.
pub fn viscosity_ratio(
    viscosity: KinematicViscosity,
    speed: AngularVelocity,
    mean_diameter: Length,
) -> Result<f64, Error> {
    let viscosity = positive(Quantity::Viscosity, viscosity.mm2_s(), "mm²/s")?;
    let turns = positive(Quantity::Speed, speed.rpm().abs(), "rpm")?;
    let diameter = positive(Quantity::MeanDiameter, mean_diameter.mm(), "mm")?;
    let needed = if turns < 1000.0 {
        45_000.0 * libm::pow(turns, -0.83) / diameter.sqrt()
    } else {
        4500.0 / (turns * diameter).sqrt()
    };
    Ok(viscosity / needed)
}

/// A step of a bearing's duty.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BearingStep {
    /// Share of the time.
    pub share: f64,
    /// Equivalent load.
    pub load: Force,
    /// Speed of one race relative to the other.
    pub speed: AngularVelocity,
    /// `a_ISO` of the step; 1 for the basic life.
    pub modification: f64,
}

/// Life over a duty, with `a_1`; `None` of a bearing that never turns under load.
///
/// ```text
/// 1/L = Σ share_i/L_i        L_i = a_1·a_ISO,i·L_10,i
/// ```
///
/// # Errors
/// [`Error::Shares`]; [`Error::NotPositive`] for an `a_ISO`, [`Error::Negative`] for a share; those of
/// [`basic_rating_life`].
pub fn life_over_duty(
    rolling: Rolling,
    load_rating: Force,
    duty: &[BearingStep],
    reliability: Reliability,
) -> Result<Option<Time>, Error> {
    positive(Quantity::LoadRating, load_rating.si(), "N")?;
    let (mut sum, mut wear) = (0.0, 0.0);
    for step in duty {
        sum += not_negative(Quantity::Share, step.share, "")?;
        let modification = positive(Quantity::LifeModification, step.modification, "")?;
        if let Some(life) = basic_rating_life(rolling, load_rating, step.load, step.speed)? {
            wear += step.share / (life.hours() * modification * reliability.factor());
        }
    }
    whole(sum)?;
    Ok((wear > 0.0).then(|| Time::from_hours(1.0 / wear)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use uom::si::force::kilonewton;

    fn kn(value: f64) -> Force {
        Force::new::<kilonewton>(value)
    }

    #[test]
    fn the_pieces_of_the_film_join() {
        for rolling in [Rolling::Balls, Rolling::Rollers] {
            let of = |kappa| life_modification(rolling, kappa, 0.5, kn(1.0), kn(8.0)).unwrap();
            for kappa in [0.4, 1.0] {
                assert!((of(kappa - 1e-9) / of(kappa) - 1.0).abs() < 2e-3, "{kappa}");
            }
            assert_eq!(of(4.0), of(40.0));
            assert!(of(0.1) < of(0.5) && of(0.5) < of(3.0));
        }
        let error = life_modification(Rolling::Balls, 0.05, 0.5, kn(1.0), kn(8.0)).unwrap_err();
        assert_eq!(error.name(), "out-of-range");
        // Clean, well lubricated, lightly loaded: as long as the standard allows.
        assert_eq!(life_modification(Rolling::Balls, 4.0, 1.0, kn(5.0), kn(1.0)), Ok(50.0));
    }

    /// 6309: C = 55.3 kN, 10 kN, 3000 rpm: 169 million revolutions, 940 h.
    #[test]
    fn a_constant_duty_has_the_basic_life() {
        let step = BearingStep {
            share: 1.0,
            load: kn(10.0),
            speed: AngularVelocity::from_rpm(3000.0),
            modification: 1.0,
        };
        let of = |duty: &[BearingStep], reliability| {
            life_over_duty(Rolling::Balls, kn(55.3), duty, reliability).unwrap().unwrap().hours()
        };
        let life = of(&[step], Reliability::Percent90);
        assert!((life - 940.0).abs() < 0.5, "{life}");
        assert!((life * 3000.0 * 60.0 / 1e6 - 169.0).abs() < 0.5);
        let half = BearingStep { share: 0.5, ..step };
        assert!((of(&[half, half], Reliability::Percent90) - life).abs() < 1e-9);
        assert!((of(&[step], Reliability::Percent99) - life / 4.0).abs() < 1e-9);
        let error = life_over_duty(Rolling::Balls, kn(55.3), &[half], Reliability::Percent90).unwrap_err();
        assert_eq!(error.to_string(), "the shares of the duty sum to 0.5; they must sum to 1");
    }

    #[test]
    fn needed_viscosity_joins_at_1000_rpm() {
        let of = |rpm| {
            let viscosity = KinematicViscosity::from_mm2_s(20.0);
            let speed = AngularVelocity::from_rpm(rpm);
            viscosity_ratio(viscosity, speed, Length::from_mm(70.0)).unwrap()
        };
        assert!((of(999.999) / of(1000.0) - 1.0).abs() < 0.03);
        assert!(of(500.0) < of(2000.0));
    }
}
