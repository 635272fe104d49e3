//! Conversions between `uom` quantities and the `f64` of the kernels; no other file of the crate converts.
//!
//! The kernels work in units of the module: lengths over `m`, areas over `m²`.

use crate::quantity::Quantity;
use uom::si::angle::{degree, radian};
use uom::si::angular_velocity::radian_per_second;
use uom::si::area::{square_meter, square_millimeter};
use uom::si::curvature::radian_per_meter;
use uom::si::dynamic_viscosity::pascal_second;
use uom::si::f64::{
    Angle, AngularVelocity, Area, Curvature, DynamicViscosity, Force, Length, MassDensity, Power, Pressure,
    TemperatureCoefficient, TemperatureInterval, Torque, Volume, VolumeRate,
};
use uom::si::force::newton;
use uom::si::length::{meter, micrometer, millimeter};
use uom::si::mass_density::kilogram_per_cubic_meter;
use uom::si::power::watt;
use uom::si::pressure::{megapascal, pascal};
use uom::si::temperature_coefficient::per_kelvin;
use uom::si::temperature_interval::kelvin;
use uom::si::torque::newton_meter;
use uom::si::volume::{cubic_centimeter, cubic_meter};
use uom::si::volume_rate::cubic_meter_per_second;

use crate::Error;

pub(crate) fn angle(angle_rad: f64) -> Angle {
    Angle::new::<radian>(angle_rad)
}

pub(crate) fn radians(value: Angle) -> f64 {
    value.get::<radian>()
}

pub(crate) fn degrees(angle_rad: f64) -> f64 {
    angle(angle_rad).get::<degree>()
}

pub(crate) fn in_degrees(value: Angle) -> f64 {
    value.get::<degree>()
}

pub(crate) fn angle_of_degrees(value_deg: f64) -> Angle {
    Angle::new::<degree>(value_deg)
}

/// Millimetres of a length in modules.
pub(crate) fn millimetres(value: Length) -> f64 {
    value.get::<millimeter>()
}

/// A length of so many modules.
pub(crate) fn length(modules: f64, module: Length) -> Length {
    module * modules
}

/// How many modules a length is.
pub(crate) fn modules(value: Length, module: Length) -> f64 {
    value.get::<meter>() / module.get::<meter>()
}

/// An area of so many squared modules.
pub(crate) fn area(square_modules: f64, module: Length) -> Area {
    Area::new::<square_meter>(square_modules * module.get::<meter>() * module.get::<meter>())
}

/// A curvature of so much over the module.
pub(crate) fn curvature(per_module: f64, module: Length) -> Curvature {
    Curvature::new::<radian_per_meter>(per_module / module.get::<meter>())
}

pub(crate) fn volume(square_modules: f64, module: Length, width: Length) -> Volume {
    Volume::new::<cubic_meter>(area(square_modules, module).get::<square_meter>() * width.get::<meter>())
}

pub(crate) fn volume_rate(volume_per_radian: Volume, speed: AngularVelocity) -> VolumeRate {
    VolumeRate::new::<cubic_meter_per_second>(
        volume_per_radian.get::<cubic_meter>() * speed.get::<radian_per_second>(),
    )
}

pub(crate) fn torque(volume_per_radian: Volume, pressure: Pressure) -> Torque {
    Torque::new::<newton_meter>(volume_per_radian.get::<cubic_meter>() * pressure.get::<pascal>())
}

pub(crate) fn power(torque: Torque, speed: AngularVelocity) -> Power {
    Power::new::<watt>(torque.get::<newton_meter>() * speed.get::<radian_per_second>())
}

pub(crate) fn force(across: Length, width: Length, pressure: Pressure) -> Force {
    Force::new::<newton>(across.get::<meter>() * width.get::<meter>() * pressure.get::<pascal>())
}

/// A length that is finite and above 0.
pub(crate) fn positive_length(quantity: Quantity, value: Length) -> Result<Length, Error> {
    let value_mm = millimetres(value);
    if value_mm.is_finite() && value_mm > 0.0 {
        Ok(value)
    } else {
        Err(Error::NotPositive { quantity, value: value_mm, unit: "mm" })
    }
}

/// A length that is finite and above 0, in modules.
pub(crate) fn positive_modules(quantity: Quantity, value: Length, module: Length) -> Result<f64, Error> {
    positive_length(quantity, value).map(|value| modules(value, module))
}

/// An angle that is finite, in radians.
pub(crate) fn finite_angle(quantity: Quantity, value: Angle) -> Result<f64, Error> {
    let value_rad = radians(value);
    if value_rad.is_finite() {
        Ok(value_rad)
    } else {
        Err(Error::NotFinite { quantity, value: value.get::<degree>(), unit: "°" })
    }
}

/// A length that is finite, in modules.
pub(crate) fn finite_modules(quantity: Quantity, value: Length, module: Length) -> Result<f64, Error> {
    let value_modules = modules(value, module);
    if value_modules.is_finite() {
        Ok(value_modules)
    } else {
        Err(Error::NotFinite { quantity, value: millimetres(value), unit: "mm" })
    }
}

/// A pressure that is finite.
pub(crate) fn finite_pressure(quantity: Quantity, value: Pressure) -> Result<Pressure, Error> {
    let value_mpa = value.get::<megapascal>();
    if value_mpa.is_finite() {
        Ok(value)
    } else {
        Err(Error::NotFinite { quantity, value: value_mpa, unit: "MPa" })
    }
}

/// A pressure that is finite and above 0.
pub(crate) fn positive_pressure(quantity: Quantity, value: Pressure) -> Result<Pressure, Error> {
    let value_mpa = megapascals(value);
    if value_mpa.is_finite() && value_mpa > 0.0 {
        Ok(value)
    } else {
        Err(Error::NotPositive { quantity, value: value_mpa, unit: "MPa" })
    }
}

pub(crate) fn pascals(value: Pressure) -> f64 {
    value.get::<pascal>()
}

pub(crate) fn pressure_of_pascals(value: f64) -> Pressure {
    Pressure::new::<pascal>(value)
}

/// A speed that is finite.
pub(crate) fn finite_speed(value: AngularVelocity) -> Result<AngularVelocity, Error> {
    let value_rad_s = value.get::<radian_per_second>();
    if value_rad_s.is_finite() {
        Ok(value)
    } else {
        Err(Error::NotFinite { quantity: Quantity::Speed, value: value_rad_s, unit: "rad/s" })
    }
}

/// A pressure over another.
pub(crate) fn over(one: Pressure, other: Pressure) -> f64 {
    one.get::<pascal>() / other.get::<pascal>()
}

pub(crate) fn metres(value: Length) -> f64 {
    value.get::<meter>()
}

pub(crate) fn length_of_metres(value: f64) -> Length {
    Length::new::<meter>(value)
}

pub(crate) fn cubic_metres(value: Volume) -> f64 {
    value.get::<cubic_meter>()
}

pub(crate) fn cubic_centimetres(value: Volume) -> f64 {
    value.get::<cubic_centimeter>()
}

pub(crate) fn newton_metres(value: Torque) -> f64 {
    value.get::<newton_meter>()
}

pub(crate) fn megapascals(value: Pressure) -> f64 {
    value.get::<megapascal>()
}

/// `q = 2π·M/Δp`.
pub(crate) fn displacement_of_torque(torque: Torque, pressure: Pressure) -> Volume {
    Volume::new::<cubic_meter>(
        std::f64::consts::TAU * (torque.get::<newton_meter>() / pressure.get::<pascal>()),
    )
}

/// A number that is finite and above 0, of a quantity whose value is named in a unit.
pub(crate) fn positive(quantity: Quantity, value: f64, unit: &'static str) -> Result<f64, Error> {
    if value.is_finite() && value > 0.0 {
        Ok(value)
    } else {
        Err(Error::NotPositive { quantity, value, unit })
    }
}

/// A number that is finite and within a range, both ends allowed.
pub(crate) fn ranging(
    quantity: Quantity,
    value: f64,
    [low, high]: [f64; 2],
    unit: &'static str,
) -> Result<f64, Error> {
    if value.is_finite() && value >= low && value <= high {
        Ok(value)
    } else {
        Err(Error::OutOfRange { quantity, value, low, high, unit })
    }
}

/// A pressure that is finite and above 0, in pascals.
pub(crate) fn positive_pascals(quantity: Quantity, value: Pressure) -> Result<f64, Error> {
    positive(quantity, value.get::<megapascal>(), "MPa")?;
    Ok(value.get::<pascal>())
}

/// A pressure that is finite, in pascals.
pub(crate) fn finite_pascals(quantity: Quantity, value: Pressure) -> Result<f64, Error> {
    Ok(finite_pressure(quantity, value)?.get::<pascal>())
}

/// An area that is finite and not below 0, in square metres.
pub(crate) fn area_from_zero(quantity: Quantity, value: Area) -> Result<f64, Error> {
    ranging(quantity, value.get::<square_millimeter>(), [0.0, f64::INFINITY], "mm²")?;
    Ok(value.get::<square_meter>())
}

/// An area that is finite and above 0, in square metres.
pub(crate) fn positive_area(quantity: Quantity, value: Area) -> Result<f64, Error> {
    positive(quantity, value.get::<square_millimeter>(), "mm²")?;
    Ok(value.get::<square_meter>())
}

pub(crate) fn square_millimetres(value: Area) -> f64 {
    value.get::<square_millimeter>()
}

pub(crate) fn square_metres(value: Area) -> f64 {
    value.get::<square_meter>()
}

pub(crate) fn volume_of_cubic_metres(value: f64) -> Volume {
    Volume::new::<cubic_meter>(value)
}

/// A length that is finite and above 0, in metres.
pub(crate) fn positive_metres(quantity: Quantity, value: Length) -> Result<f64, Error> {
    positive_length(quantity, value).map(metres)
}

/// A density that is finite and above 0, in kilograms a cubic metre.
pub(crate) fn positive_density(value: MassDensity) -> Result<f64, Error> {
    positive(Quantity::Density, value.get::<kilogram_per_cubic_meter>(), "kg/m³")
}

/// A dynamic viscosity that is finite and above 0, in pascal seconds.
pub(crate) fn positive_viscosity(value: DynamicViscosity) -> Result<f64, Error> {
    positive(Quantity::Viscosity, value.get::<pascal_second>(), "Pa·s")
}

/// A speed that is finite and above 0, in radians a second.
pub(crate) fn positive_speed(value: AngularVelocity) -> Result<f64, Error> {
    positive(Quantity::Speed, value.get::<radian_per_second>(), "rad/s")
}

pub(crate) fn flow_of_cubic_metres(value: f64) -> VolumeRate {
    VolumeRate::new::<cubic_meter_per_second>(value)
}

pub(crate) fn torque_of_newton_metres(value: f64) -> Torque {
    Torque::new::<newton_meter>(value)
}

pub(crate) fn power_of_watts(value: f64) -> Power {
    Power::new::<watt>(value)
}

/// A coefficient of thermal expansion that is finite, a kelvin.
pub(crate) fn finite_expansion(value: TemperatureCoefficient) -> Result<f64, Error> {
    let value = value.get::<per_kelvin>();
    if value.is_finite() {
        Ok(value)
    } else {
        Err(Error::NotFinite { quantity: Quantity::Expansion, value, unit: "1/K" })
    }
}

/// A difference of temperatures that is finite, in kelvins.
pub(crate) fn finite_kelvins(value: TemperatureInterval) -> Result<f64, Error> {
    let value = value.get::<kelvin>();
    if value.is_finite() {
        Ok(value)
    } else {
        Err(Error::NotFinite { quantity: Quantity::TemperatureDifference, value, unit: "K" })
    }
}

pub(crate) fn micrometres(value: Length) -> f64 {
    value.get::<micrometer>()
}

pub(crate) fn newtons(value: Force) -> f64 {
    value.get::<newton>()
}

/// A speed that is finite and not below 0, in radians a second.
pub(crate) fn speed_from_zero(value: AngularVelocity) -> Result<f64, Error> {
    ranging(Quantity::Speed, value.get::<radian_per_second>(), [0.0, f64::INFINITY], "rad/s")
}

/// A radian a second.
pub(crate) fn speed_of_one() -> AngularVelocity {
    AngularVelocity::new::<radian_per_second>(1.0)
}

pub(crate) fn watts(value: Power) -> f64 {
    value.get::<watt>()
}

/// Cubic metres a second.
pub(crate) fn volume_flow(value: VolumeRate) -> f64 {
    value.get::<cubic_meter_per_second>()
}
