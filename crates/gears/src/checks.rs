//! Checks of inputs, which refuse a value outside its range in the unit an engineer writes.

use std::f64::consts::FRAC_PI_2;

use epicyclic_units::Physical;
use uom::si::f64::{Angle, Length, Mass, MassDensity, Pressure, Torque};

use crate::message::shown;
use crate::{Error, Quantity};

/// Millimetres for a message.
pub(crate) fn shown_mm(value: Length) -> f64 {
    shown(value.mm())
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
    positive(quantity, value.mm(), "mm")?;
    Ok(value.si())
}

/// A length of at least `low_m` and below `high_m`, in metres.
pub(crate) fn length_from_to(
    quantity: Quantity,
    value: Length,
    low_m: f64,
    high_m: f64,
) -> Result<f64, Error> {
    let value_m = value.si();
    if value_m >= low_m && value_m < high_m {
        return Ok(value_m);
    }
    let [value, low, high] = [value, Length::from_si(low_m), Length::from_si(high_m)].map(shown_mm);
    Err(Error::OutOfRange { quantity, value, low, high, unit: "mm" })
}

/// A torque above 0, in N·m.
pub(crate) fn positive_torque(value: Torque) -> Result<f64, Error> {
    positive(Quantity::Torque, value.si(), "N·m")
}

/// A stress above 0, in Pa.
pub(crate) fn positive_stress(quantity: Quantity, value: Pressure) -> Result<f64, Error> {
    positive(quantity, value.mpa(), "MPa")?;
    Ok(value.si())
}

/// A density above 0, in kg/m³.
pub(crate) fn positive_density(value: MassDensity) -> Result<f64, Error> {
    positive(Quantity::Density, value.si(), "kg/m³")
}

/// A mass above 0, in kg.
pub(crate) fn positive_mass(value: Mass) -> Result<f64, Error> {
    positive(Quantity::Mass, value.si(), "kg")
}

/// An angle strictly between 0 and 90°, in radians.
pub(crate) fn acute_angle(quantity: Quantity, value: Angle) -> Result<f64, Error> {
    let value_rad = value.si();
    if value_rad > 0.0 && value_rad < FRAC_PI_2 {
        return Ok(value_rad);
    }
    Err(Error::OutOfRange { quantity, value: value.degrees(), low: 0.0, high: 90.0, unit: "°" })
}
