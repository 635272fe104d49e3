//! Conversions between `uom` quantities and the SI numbers of the kernels: all of this crate's.

use crate::Error;
use uom::si::angle::radian;
use uom::si::angular_velocity::radian_per_second;
use uom::si::f64::{Angle, AngularVelocity, Force, Frequency, Length, Mass, MomentOfInertia, Torque};
use uom::si::force::newton;
use uom::si::frequency::hertz;
use uom::si::length::meter;
use uom::si::mass::kilogram;
use uom::si::moment_of_inertia::kilogram_square_meter;
use uom::si::torque::newton_meter;
use uom::si::{ISQ, Quantity, SI};
use uom::typenum::{N2, P1, Z0};

/// Stiffness of a spring, N/m: what a [`Force`] over a [`Length`] is.
///
/// ```
/// use epicyclic_vibration::{Stiffness, newtons_per_meter};
/// use uom::si::f64::{Force, Length};
/// use uom::si::{force::newton, length::micrometer};
///
/// let stiffness: Stiffness = Force::new::<newton>(500.0) / Length::new::<micrometer>(1.0);
/// assert!((stiffness / newtons_per_meter(5e8)).value - 1.0 < 1e-12);
/// ```
pub type Stiffness = Quantity<ISQ<Z0, P1, N2, Z0, Z0, Z0, Z0>, SI<f64>, f64>;

/// A stiffness from its number in N/m.
#[must_use]
pub fn newtons_per_meter(value: f64) -> Stiffness {
    Force::new::<newton>(value) / Length::new::<meter>(1.0)
}

/// Stiffness against rotation, N·m/rad: a torque per radian, as angles have no dimension.
pub type TorsionalStiffness = Torque;

macro_rules! conversions {
    ($($quantity:ty, $unit:ty: $get:ident $(, $new:ident)?;)*) => {$(
        #[allow(dead_code, reason = "some are used by the tests alone")]
        pub(crate) fn $get(quantity: $quantity) -> f64 {
            quantity.get::<$unit>()
        }

        $(pub(crate) fn $new(value: f64) -> $quantity {
            <$quantity>::new::<$unit>(value)
        })?
    )*};
}

conversions! {
    Angle, radian: radians, angle;
    AngularVelocity, radian_per_second: rad_per_s, angular_velocity;
    Length, meter: meters, length;
    Mass, kilogram: kilograms, mass;
    MomentOfInertia, kilogram_square_meter: kg_m2, moment_of_inertia;
    Torque, newton_meter: n_m;
}

pub(crate) fn n_per_m(stiffness: Stiffness) -> f64 {
    (stiffness * Length::new::<meter>(1.0)).get::<newton>()
}

pub(crate) fn force(newtons: f64) -> Force {
    Force::new::<newton>(newtons)
}

/// The frequency of a circular frequency, Hz for rad/s.
pub(crate) fn frequency(omega_rad_s: f64) -> Frequency {
    Frequency::new::<hertz>(omega_rad_s / std::f64::consts::TAU)
}

/// A finite number above 0.
pub(crate) fn positive(field: impl FnOnce() -> String, value: f64, unit: &'static str) -> Result<f64, Error> {
    if value.is_finite() && value > 0.0 {
        Ok(value)
    } else {
        Err(Error::NotPositive { field: field(), value, unit })
    }
}

/// A finite number of at least 0.
pub(crate) fn not_negative(
    field: impl FnOnce() -> String,
    value: f64,
    unit: &'static str,
) -> Result<f64, Error> {
    if value.is_finite() && value >= 0.0 {
        Ok(value)
    } else {
        Err(Error::Negative { field: field(), value, unit })
    }
}

/// A number from `low` to `high`.
pub(crate) fn within(
    field: impl FnOnce() -> String,
    value: f64,
    [low, high]: [f64; 2],
    unit: &'static str,
) -> Result<f64, Error> {
    if (low..=high).contains(&value) {
        Ok(value)
    } else {
        Err(Error::OutOfRange { field: field(), value, low, high, unit })
    }
}
