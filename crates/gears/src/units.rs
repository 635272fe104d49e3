//! Conversions between `uom` quantities and the SI `f64` of the kernels; no other file of the crate converts.
//!
//! The checked readers refuse a value outside its range and report it in the unit an engineer writes.

use std::f64::consts::FRAC_PI_2;

use uom::si::angle::{degree, radian};
use uom::si::angular_velocity::radian_per_second;
use uom::si::area::square_meter;
use uom::si::f64::{
    Angle, AngularVelocity, Area, Force, Length, Mass, MassDensity, MomentOfInertia, Pressure, Time, Torque,
    Volume,
};
use uom::si::force::newton;
use uom::si::length::{meter, millimeter};
use uom::si::mass::kilogram;
use uom::si::mass_density::kilogram_per_cubic_meter;
use uom::si::moment_of_inertia::kilogram_square_meter;
use uom::si::pressure::{megapascal, pascal};
use uom::si::time::second;
use uom::si::torque::newton_meter;
use uom::si::volume::cubic_meter;

use crate::message::shown;
use crate::{Error, Quantity};

pub(crate) fn rad_per_s(speed: AngularVelocity) -> f64 {
    speed.get::<radian_per_second>()
}

pub(crate) fn angular_velocity(omega_rad_s: f64) -> AngularVelocity {
    AngularVelocity::new::<radian_per_second>(omega_rad_s)
}

pub(crate) fn n_m(torque: Torque) -> f64 {
    torque.get::<newton_meter>()
}

pub(crate) fn torque(torque_n_m: f64) -> Torque {
    Torque::new::<newton_meter>(torque_n_m)
}

pub(crate) fn force(force_n: f64) -> Force {
    Force::new::<newton>(force_n)
}

pub(crate) fn seconds(time_s: f64) -> Time {
    Time::new::<second>(time_s)
}

pub(crate) fn newtons(force: Force) -> f64 {
    force.get::<newton>()
}

pub(crate) fn angle(angle_rad: f64) -> Angle {
    Angle::new::<radian>(angle_rad)
}

pub(crate) fn length(value_m: f64) -> Length {
    Length::new::<meter>(value_m)
}

/// An area in square metres.
pub(crate) fn area(value_m2: f64) -> Area {
    Area::new::<square_meter>(value_m2)
}

pub(crate) fn length_from_mm(value_mm: f64) -> Length {
    Length::new::<millimeter>(value_mm)
}

pub(crate) fn metres(value: Length) -> f64 {
    value.get::<meter>()
}

pub(crate) fn millimetres(value: Length) -> f64 {
    value.get::<millimeter>()
}

pub(crate) fn stress(value_pa: f64) -> Pressure {
    Pressure::new::<pascal>(value_pa)
}

pub(crate) fn volume(value_m3: f64) -> Volume {
    Volume::new::<cubic_meter>(value_m3)
}

pub(crate) fn mass(value_kg: f64) -> Mass {
    Mass::new::<kilogram>(value_kg)
}

pub(crate) fn kilograms(value: Mass) -> f64 {
    value.get::<kilogram>()
}

pub(crate) fn inertia(value_kg_m2: f64) -> MomentOfInertia {
    MomentOfInertia::new::<kilogram_square_meter>(value_kg_m2)
}

pub(crate) fn angle_from_degrees(value_deg: f64) -> Angle {
    Angle::new::<degree>(value_deg)
}

pub(crate) fn radians(value: Angle) -> f64 {
    value.get::<radian>()
}

pub(crate) fn degrees(value: Angle) -> f64 {
    value.get::<degree>()
}

/// Millimetres for a message.
pub(crate) fn shown_mm(value: Length) -> f64 {
    shown(millimetres(value))
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

/// A length above 0, in metres.
pub(crate) fn positive_length(quantity: Quantity, value: Length) -> Result<f64, Error> {
    positive(quantity, millimetres(value), "mm")?;
    Ok(metres(value))
}

/// A length of at least `low_m` and below `high_m`, in metres.
pub(crate) fn length_from_to(
    quantity: Quantity,
    value: Length,
    low_m: f64,
    high_m: f64,
) -> Result<f64, Error> {
    let value_m = metres(value);
    if value_m >= low_m && value_m < high_m {
        return Ok(value_m);
    }
    let [value, low, high] = [value, length(low_m), length(high_m)].map(shown_mm);
    Err(Error::OutOfRange { quantity, value, low, high, unit: "mm" })
}

/// A length above `low_m`, in metres.
pub(crate) fn length_above(quantity: Quantity, value: Length, low_m: f64) -> Result<f64, Error> {
    let value_m = positive_length(quantity, value)?;
    if value_m > low_m {
        return Ok(value_m);
    }
    let [value, low] = [value, length(low_m)].map(shown_mm);
    Err(Error::NotAbove { quantity, value, low, unit: "mm" })
}

/// A torque above 0, in N·m.
pub(crate) fn positive_torque(value: Torque) -> Result<f64, Error> {
    positive(Quantity::Torque, value.get::<newton_meter>(), "N·m")
}

/// A stress above 0, in Pa.
pub(crate) fn positive_stress(quantity: Quantity, value: Pressure) -> Result<f64, Error> {
    positive(quantity, value.get::<megapascal>(), "MPa")?;
    Ok(value.get::<pascal>())
}

/// A density above 0, in kg/m³.
pub(crate) fn positive_density(value: MassDensity) -> Result<f64, Error> {
    positive(Quantity::Density, value.get::<kilogram_per_cubic_meter>(), "kg/m³")
}

/// A mass above 0, in kg.
pub(crate) fn positive_mass(value: Mass) -> Result<f64, Error> {
    positive(Quantity::Mass, kilograms(value), "kg")
}

/// An angle strictly between 0 and 90°, in radians.
pub(crate) fn acute_angle(quantity: Quantity, value: Angle) -> Result<f64, Error> {
    let value_rad = radians(value);
    if value_rad > 0.0 && value_rad < FRAC_PI_2 {
        return Ok(value_rad);
    }
    Err(Error::OutOfRange { quantity, value: degrees(value), low: 0.0, high: 90.0, unit: "°" })
}
