//! Conversions between `uom` quantities and the numbers of the kernels; no other file of the crate converts.
//!
//! The kernels take N, mm, N/mm², m/s, rpm and µm, as ISO 6336 does.

use crate::{Error, Quantity, tolerance};
use uom::si::angle::radian;
use uom::si::angular_velocity::{radian_per_second, revolution_per_minute};
use uom::si::f64::{
    Angle, AngularVelocity, Force, KinematicViscosity, Length, Mass, MassDensity, Power, Pressure,
    SurfaceTension, Time, Torque, Velocity,
};
use uom::si::force::newton;
use uom::si::kinematic_viscosity::square_millimeter_per_second;
use uom::si::length::{micrometer, millimeter};
use uom::si::mass::kilogram;
use uom::si::mass_density::kilogram_per_cubic_meter;
use uom::si::power::watt;
use uom::si::pressure::megapascal;
use uom::si::surface_tension::newton_per_meter;
use uom::si::time::hour;
use uom::si::torque::newton_meter;
use uom::si::velocity::meter_per_second;

pub(crate) fn mm(value: Length) -> f64 {
    value.get::<millimeter>()
}

pub(crate) fn length_mm(value_mm: f64) -> Length {
    Length::new::<millimeter>(value_mm)
}

pub(crate) fn um(value: Length) -> f64 {
    value.get::<micrometer>()
}

pub(crate) fn mpa(value: Pressure) -> f64 {
    value.get::<megapascal>()
}

pub(crate) fn pressure(value_mpa: f64) -> Pressure {
    Pressure::new::<megapascal>(value_mpa)
}

pub(crate) fn n_m(value: Torque) -> f64 {
    value.get::<newton_meter>()
}

pub(crate) fn torque(value_n_m: f64) -> Torque {
    Torque::new::<newton_meter>(value_n_m)
}

pub(crate) fn force(value_n: f64) -> Force {
    Force::new::<newton>(value_n)
}

/// A stiffness of so many N/µm.
pub(crate) fn n_per_um(value: f64) -> SurfaceTension {
    SurfaceTension::new::<newton_per_meter>(value * 1e6)
}

pub(crate) fn newtons(value: Force) -> f64 {
    value.get::<newton>()
}

pub(crate) fn rpm(value: AngularVelocity) -> f64 {
    value.get::<revolution_per_minute>()
}

pub(crate) fn rad_s(value: AngularVelocity) -> f64 {
    value.get::<radian_per_second>()
}

pub(crate) fn mass(value_kg: f64) -> Mass {
    Mass::new::<kilogram>(value_kg)
}

pub(crate) fn velocity(value_m_s: f64) -> Velocity {
    Velocity::new::<meter_per_second>(value_m_s)
}

pub(crate) fn hours(value: Time) -> f64 {
    value.get::<hour>()
}

pub(crate) fn time_from_hours(value_h: f64) -> Time {
    Time::new::<hour>(value_h)
}

pub(crate) fn watts(value: Power) -> f64 {
    value.get::<watt>()
}

pub(crate) fn power(value_w: f64) -> Power {
    Power::new::<watt>(value_w)
}

pub(crate) fn mm2_s(value: KinematicViscosity) -> f64 {
    value.get::<square_millimeter_per_second>()
}

pub(crate) fn kg_m3(value: MassDensity) -> f64 {
    value.get::<kilogram_per_cubic_meter>()
}

pub(crate) fn density(value_kg_m3: f64) -> MassDensity {
    MassDensity::new::<kilogram_per_cubic_meter>(value_kg_m3)
}

pub(crate) fn radians(value: Angle) -> f64 {
    value.get::<radian>()
}

/// A finite number above 0.
pub(crate) fn positive(quantity: Quantity, value: f64, unit: &'static str) -> Result<f64, Error> {
    if value.is_finite() && value > 0.0 {
        Ok(value)
    } else {
        Err(Error::NotPositive { quantity, value, unit })
    }
}

/// A finite number of at least 0.
pub(crate) fn not_negative(quantity: Quantity, value: f64, unit: &'static str) -> Result<f64, Error> {
    if value.is_finite() && value >= 0.0 { Ok(value) } else { Err(Error::Negative { quantity, value, unit }) }
}

/// A number from `low` to `high`.
pub(crate) fn within(
    quantity: Quantity,
    value: f64,
    [low, high]: [f64; 2],
    unit: &'static str,
) -> Result<f64, Error> {
    if (low..=high).contains(&value) {
        Ok(value)
    } else {
        Err(Error::OutOfRange { quantity, value, low, high, unit })
    }
}

/// Refuses shares of time whose sum is not 1.
pub(crate) fn whole(sum: f64) -> Result<(), Error> {
    if (sum - 1.0).abs() <= tolerance::WHOLE { Ok(()) } else { Err(Error::Shares { sum }) }
}
