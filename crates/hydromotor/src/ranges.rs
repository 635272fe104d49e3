//! Checks of inputs, which refuse a value outside its range.

use epicyclic_units::Physical;
use uom::si::f64::{Angle, AngularVelocity, Area, Length, Pressure};

use crate::Error;
use crate::modules::modules;
use crate::quantity::Quantity;

/// A number that is finite, of a quantity whose value is named in a unit.
pub(crate) fn finite(quantity: Quantity, value: f64, unit: &'static str) -> Result<f64, Error> {
    if value.is_finite() { Ok(value) } else { Err(Error::NotFinite { quantity, value, unit }) }
}

/// A number that is finite and above 0.
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

/// A length that is finite and above 0.
pub(crate) fn positive_length(quantity: Quantity, value: Length) -> Result<Length, Error> {
    positive(quantity, value.mm(), "mm").map(|_| value)
}

/// A length that is finite and above 0, in modules.
pub(crate) fn positive_modules(quantity: Quantity, value: Length, module: Length) -> Result<f64, Error> {
    positive_length(quantity, value).map(|value| modules(value, module))
}

/// A length that is finite, in modules.
pub(crate) fn finite_modules(quantity: Quantity, value: Length, module: Length) -> Result<f64, Error> {
    let value_modules = modules(value, module);
    if value_modules.is_finite() {
        Ok(value_modules)
    } else {
        Err(Error::NotFinite { quantity, value: value.mm(), unit: "mm" })
    }
}

/// An angle that is finite, in radians.
pub(crate) fn finite_angle(quantity: Quantity, value: Angle) -> Result<f64, Error> {
    let value_rad = value.si();
    if value_rad.is_finite() {
        Ok(value_rad)
    } else {
        Err(Error::NotFinite { quantity, value: value.degrees(), unit: "°" })
    }
}

/// A pressure that is finite.
pub(crate) fn finite_pressure(quantity: Quantity, value: Pressure) -> Result<Pressure, Error> {
    finite(quantity, value.mpa(), "MPa").map(|_| value)
}

/// A pressure that is finite and above 0.
pub(crate) fn positive_pressure(quantity: Quantity, value: Pressure) -> Result<Pressure, Error> {
    positive(quantity, value.mpa(), "MPa").map(|_| value)
}

/// A speed that is finite.
pub(crate) fn finite_speed(value: AngularVelocity) -> Result<AngularVelocity, Error> {
    finite(Quantity::Speed, value.si(), "rad/s").map(|_| value)
}

/// An area that is finite and not below 0, in square metres.
pub(crate) fn area_from_zero(quantity: Quantity, value: Area) -> Result<f64, Error> {
    ranging(quantity, value.mm2(), [0.0, f64::INFINITY], "mm²").map(|_| value.si())
}
