//! Speeds of a bucket wheel: how fast it may turn and still empty its buckets, and how slowly.
//!
//! Angles are measured about the wheel's axis from the horizontal, in the direction of rotation.
//!
//! # Source
//! multispeed-gearboxes (2.5)–(2.9).

use crate::Error;
use crate::cutting::positive;
use crate::quantity::{FlightFault, Quantity};
use epicyclic_units::Physical;
use std::f64::consts::{FRAC_PI_2, TAU};
use uom::si::f64::{Acceleration, Angle, AngularVelocity, Length, Time, Velocity};

/// Standard acceleration of fall.
#[must_use]
pub fn standard_gravity() -> Acceleration {
    Velocity::from_si(9.806_65) / Time::from_si(1.0)
}

/// Optimal speed of the wheel: a bucket passes while the boom advances by the width of a chip.
///
/// ```text
/// ω_po = 2π·R_c·ω_no/(b·z_k·cos φ)
/// ```
///
/// | symbol | argument | meaning |
/// |---|---|---|
/// | `R_c` | `boom_radius` | cutting radius of the boom |
/// | `ω_no` | `slewing` | slewing speed with the boom in the machine's axis, the least |
/// | `b` | `chip_width` | present width of the chip |
/// | `z_k` | `buckets` | number of buckets |
/// | `φ` | `boom_angle` | slewing angle of the boom |
///
/// # Where this departs from the print
/// The copy shows `2π`, `R_c`, `ω_no`, `b·z_k` and `φ` scattered; "cos" is inferred: slewing speeds up as
/// `1/cos φ` to keep the chip's volume.
///
/// # Errors
/// [`Error::NotPositive`]; `cos φ` is above 0.
///
/// # Source
/// (2.6), restored.
pub fn optimal_speed(
    boom_radius: Length,
    slewing: AngularVelocity,
    chip_width: Length,
    buckets: u32,
    boom_angle: Angle,
) -> Result<AngularVelocity, Error> {
    positive(Quantity::BoomRadius, boom_radius.si(), "m")?;
    positive(Quantity::SlewingSpeed, slewing.si(), "rad/s")?;
    positive(Quantity::ChipWidth, chip_width.si(), "m")?;
    positive(Quantity::Buckets, f64::from(buckets), "")?;
    let cos = libm::cos(boom_angle.si());
    let is_acute = boom_angle.si().abs() < FRAC_PI_2;
    if !is_acute {
        return Err(Error::BoomAngle { degrees: boom_angle.si().to_degrees() });
    }
    Ok(slewing * (TAU * (boom_radius / chip_width).value / (f64::from(buckets) * cos)))
}

/// Greatest speed of the wheel at which its buckets empty.
///
/// ```text
/// ω_max = 0.5·(ω_po + √(ω_po² + 1.48))      1.48 in rad²/s²
/// ```
///
/// That is the positive root of `ω² − ω_po·ω − 0.37 = 0`. The copy lost the radical; it is inferred.
///
/// # Errors
/// [`Error::NotPositive`].
///
/// # Source
/// (2.5), restored.
pub fn greatest_speed(optimal: AngularVelocity) -> Result<AngularVelocity, Error> {
    let omega_rad_s = optimal.si();
    positive(Quantity::OptimalSpeed, omega_rad_s, "rad/s")?;
    Ok(AngularVelocity::from_si(0.5 * (omega_rad_s + (omega_rad_s * omega_rad_s + 1.48).sqrt())))
}

/// Least speed of the wheel in light and medium rock: `ω_min = √(Ω·g/R_p)`.
///
/// | symbol | argument | meaning |
/// |---|---|---|
/// | `Ω` | `discharge` | dimensionless, from [`discharge`], or with the boom level from a lost graph |
/// | `g` | `gravity` | acceleration of fall |
/// | `R_p` | `wheel_radius` | radius of the wheel |
///
/// # Errors
/// [`Error::NotPositive`].
///
/// # Source
/// (2.7).
pub fn least_speed(
    discharge: f64,
    gravity: Acceleration,
    wheel_radius: Length,
) -> Result<AngularVelocity, Error> {
    positive(Quantity::Discharge, discharge, "")?;
    positive(Quantity::FallAcceleration, gravity.value, "m/s²")?;
    positive(Quantity::WheelRadius, wheel_radius.si(), "m")?;
    let squared = discharge * gravity.value / wheel_radius.si();
    Ok(AngularVelocity::from_si(squared.sqrt()))
}

/// Discharge parameter `Ω = ω²·R_p/g` at which what leaves a bucket just clears the chute's edge.
///
/// ```text
/// Ω = (cos τ₁ − ε_p·cos τ*)²/{2·sin τ₁·[1 − ε_p·cos(τ* − τ₁)]}
/// ```
///
/// | symbol | argument | meaning |
/// |---|---|---|
/// | `τ₁` | `release` | angle at which a particle leaves its bucket, between 0 and 180° |
/// | `τ*` | `chute` | angle of the chute's edge: that of the level boom plus the boom's own elevation |
/// | `ε_p` | `radius_ratio` | radius of the chute's edge over `R_p` |
///
/// It is free flight: a particle leaves radius `R_p` at `τ₁` with the wheel's speed `ω·R_p` along the tangent
/// and falls to radius `ε_p·R_p` at `τ*` (a property test flies it).
///
/// Of the raised and the lowered boom the smaller Ω counts, says the source.
///
/// # Errors
/// [`Error::NoFlight`] where no particle can come from one point to the other.
///
/// # Source
/// (2.8).
pub fn discharge(release: Angle, chute: Angle, radius_ratio: f64) -> Result<f64, Error> {
    let (tau1, tau) = (release.si(), chute.si());
    let refuse = |why| Error::NoFlight {
        release_deg: release.degrees(),
        chute_deg: chute.degrees(),
        radius_ratio,
        why,
    };
    if !(radius_ratio > 0.0 && radius_ratio.is_finite() && tau1.is_finite() && tau.is_finite()) {
        return Err(refuse(FlightFault::OutOfRange));
    }
    if libm::sin(tau1) <= 0.0 {
        return Err(refuse(FlightFault::ReleaseBelowAxis));
    }
    // Time of flight times ω·sin τ₁, from the horizontal way.
    let across = libm::cos(tau1) - radius_ratio * libm::cos(tau);
    let fall = 1.0 - radius_ratio * libm::cos(tau - tau1);
    if across <= 0.0 {
        return Err(refuse(FlightFault::ChuteBehind));
    }
    if fall <= 0.0 {
        return Err(refuse(FlightFault::ChuteAbove));
    }
    Ok(across * across / (2.0 * libm::sin(tau1) * fall))
}

/// Range of the wheel's speeds: `d_p = ω_max/ω_min = ω_max·√(R_p/(Ω·g))`.
///
/// # Errors
/// [`Error::NotPositive`].
///
/// # Source
/// (2.9).
pub fn speed_range(greatest: AngularVelocity, least: AngularVelocity) -> Result<f64, Error> {
    positive(Quantity::GreatestSpeed, greatest.si(), "rad/s")?;
    positive(Quantity::LeastSpeed, least.si(), "rad/s")?;
    Ok((greatest / least).value)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use proptest::test_runner::TestRunner;
    use std::cell::Cell;

    fn omega(value: f64) -> AngularVelocity {
        AngularVelocity::from_si(value)
    }

    #[test]
    fn a_wheel_by_hand() {
        // 2π·20·0.02/(0.3·8·cos 60°) = 2.0944 rad/s
        let (radius, width) = (Length::from_si(20.0), Length::from_si(0.3));
        let optimal = optimal_speed(radius, omega(0.02), width, 8, Angle::from_degrees(60.0)).unwrap();
        assert!((optimal.si() - TAU * 20.0 * 0.02 / 1.2).abs() < 1e-12);
        let greatest = greatest_speed(omega(0.6)).unwrap().si();
        assert!((greatest * greatest - 0.6 * greatest - 0.37).abs() < 1e-14);
        let least = least_speed(0.3, standard_gravity(), Length::from_si(3.0)).unwrap();
        assert!((least.si() - 0.980_665_f64.sqrt()).abs() < 1e-14);
        assert!((speed_range(omega(2.0), omega(0.5)).unwrap() - 4.0).abs() < 1e-15);
    }

    #[test]
    fn what_no_wheel_can_do_is_refused() {
        let degrees = Angle::from_degrees;
        assert!(discharge(degrees(-10.0), degrees(120.0), 0.5).is_err());
        assert!(discharge(degrees(60.0), degrees(0.0), 0.9).is_err());
        assert!(discharge(degrees(60.0), degrees(60.0), 1.5).is_err());
        assert!(discharge(degrees(60.0), degrees(90.0), 2.0).is_err());
        assert!(greatest_speed(omega(0.0)).is_err());
        let radius = Length::from_si(20.0);
        assert!(optimal_speed(radius, omega(0.02), radius, 8, degrees(90.0)).is_err());
        assert!(optimal_speed(radius, omega(0.02), radius, 0, degrees(0.0)).is_err());
        assert!(least_speed(f64::INFINITY, standard_gravity(), radius).is_err());
    }

    /// Where no particle can fly it must be for the stated reason; that is counted, and not most.
    #[test]
    fn the_particle_flies_to_the_chute() {
        let (flown, refused) = (Cell::new(0_u32), Cell::new(0_u32));
        let strategy = (0.2..2.5_f64, -1.0..3.5_f64, 0.1..0.95_f64, 0.5..10.0_f64);
        let fly = |(tau1, tau, epsilon, radius): (f64, f64, f64, f64)| {
            let angle = Angle::from_si;
            let Ok(found) = discharge(angle(tau1), angle(tau), epsilon) else {
                refused.set(refused.get() + 1);
                // The chute lies behind the release, or above its tangent.
                let (behind, above) =
                    (libm::cos(tau1) <= epsilon * libm::cos(tau), epsilon * libm::cos(tau - tau1) >= 1.0);
                prop_assert!(behind || above, "{tau1} {tau} {epsilon}");
                return Ok(());
            };
            flown.set(flown.get() + 1);
            let gravity = 9.81_f64;
            let speed = (found * gravity * radius).sqrt();
            // From (R·cos τ₁, R·sin τ₁) along the tangent (−sin τ₁, cos τ₁).
            let goal = [epsilon * radius * libm::cos(tau), epsilon * radius * libm::sin(tau)];
            let time = (radius * libm::cos(tau1) - goal[0]) / (speed * libm::sin(tau1));
            let height =
                radius * libm::sin(tau1) + speed * libm::cos(tau1) * time - gravity * time * time / 2.0;
            prop_assert!(time > 0.0);
            // The way across is a difference of cosines: what it cancels, the time of flight has lost.
            let lost = radius * (libm::cos(tau1).abs() + epsilon * libm::cos(tau).abs())
                / (radius * libm::cos(tau1) - goal[0]);
            let scale = (radius + (speed * time).abs() + gravity * time * time) * (1.0 + lost);
            prop_assert!((height - goal[1]).abs() < 1e-13 * scale, "{} {}", height, goal[1]);
            Ok(())
        };
        TestRunner::new(ProptestConfig::with_cases(512)).run(&strategy, fly).unwrap();
        assert!(flown.get() > refused.get() / 2, "{} flown, {} refused", flown.get(), refused.get());
    }
}
