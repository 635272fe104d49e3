//! Conversions between `uom` quantities and the `f64` of the kernels; no other file of the crate converts.
//!
//! The kernels work in units of the module: lengths over `m`, areas over `m²`.

use uom::si::angle::{degree, radian};
use uom::si::f64::{Angle, Length};
use uom::si::length::{meter, millimeter};

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

/// A length that is finite and above 0.
pub(crate) fn positive_length(quantity: &'static str, value: Length) -> Result<Length, Error> {
    let value_mm = millimetres(value);
    if value_mm.is_finite() && value_mm > 0.0 {
        Ok(value)
    } else {
        Err(Error::NotPositive { quantity, value: value_mm, unit: "mm" })
    }
}

/// A length that is finite and above 0, in modules.
pub(crate) fn positive_modules(quantity: &'static str, value: Length, module: Length) -> Result<f64, Error> {
    positive_length(quantity, value).map(|value| modules(value, module))
}

/// An angle that is finite, in radians.
pub(crate) fn finite_angle(quantity: &'static str, value: Angle) -> Result<f64, Error> {
    let value_rad = radians(value);
    if value_rad.is_finite() {
        Ok(value_rad)
    } else {
        Err(Error::NotFinite { quantity, value: value.get::<degree>(), unit: "°" })
    }
}
