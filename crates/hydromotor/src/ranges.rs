//! Checks of inputs, which refuse a value outside its range with [`Error::NotPositive`] or
//! [`Error::OutOfRange`]. The public ones are of quantities whose range no other value decides; they return
//! the value in SI units.

use epicyclic_units::Physical;
use uom::si::f64::{Angle, AngularVelocity, Area, DynamicViscosity, Length, MassDensity, Pressure};

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

/// Part of a family, between 0 and 1, both excluded.
///
/// # Errors
/// [`Error::OutOfRange`].
pub fn family_part(value: f64) -> Result<f64, Error> {
    if value > 0.0 && value < 1.0 {
        Ok(value)
    } else {
        Err(Error::OutOfRange { quantity: Quantity::FamilyPart, value, low: 0.0, high: 1.0, unit: "" })
    }
}

/// Viscosity of the oil `η`, above 0, in Pa·s.
///
/// # Errors
/// [`Error::NotPositive`].
pub fn viscosity(value: DynamicViscosity) -> Result<f64, Error> {
    positive(Quantity::Viscosity, value.si(), "Pa·s")
}

/// Density of the oil `ϱ`, above 0, in kg/m³.
///
/// # Errors
/// [`Error::NotPositive`].
pub fn density(value: MassDensity) -> Result<f64, Error> {
    positive(Quantity::Density, value.si(), "kg/m³")
}

/// Bulk modulus of the oil `K`, above 0, in Pa.
///
/// # Errors
/// [`Error::NotPositive`].
pub fn bulk_modulus(value: Pressure) -> Result<f64, Error> {
    positive_pressure(Quantity::BulkModulus, value).map(Physical::si)
}

/// Factor of the law of turbulent flow in a gap, above 0.
///
/// # Errors
/// [`Error::NotPositive`].
pub fn turbulent_factor(value: f64) -> Result<f64, Error> {
    positive(Quantity::TurbulentFactor, value, "")
}

/// Exponent of the law of turbulent flow in a gap, from 0 to 1.
///
/// # Errors
/// [`Error::OutOfRange`].
pub fn turbulent_exponent(value: f64) -> Result<f64, Error> {
    ranging(Quantity::TurbulentExponent, value, [0.0, 1.0], "")
}

/// Gap at a face of satellites or rotor, at least 0, in m.
///
/// # Errors
/// [`Error::OutOfRange`] with this quantity.
pub fn gap(quantity: Quantity, value: Length) -> Result<f64, Error> {
    ranging(quantity, value.um(), [0.0, f64::INFINITY], "µm").map(|_| value.si())
}

/// Dead volume of a chamber over the width, at least 0, in m².
///
/// # Errors
/// [`Error::OutOfRange`].
pub fn dead_area(value: Area) -> Result<f64, Error> {
    ranging(Quantity::DeadArea, value.mm2(), [0.0, f64::INFINITY], "mm²").map(|_| value.si())
}

/// Discharge coefficient of the openings of ports, above 0 and at most 1.
///
/// # Errors
/// [`Error::OutOfRange`].
pub fn discharge_coefficient(value: f64) -> Result<f64, Error> {
    ranging(Quantity::DischargeCoefficient, value, [f64::MIN_POSITIVE, 1.0], "")
}

/// Limit of a stress of the material, above 0, in Pa.
///
/// # Errors
/// [`Error::NotPositive`] with this quantity.
pub fn stress_limit(quantity: Quantity, value: Pressure) -> Result<f64, Error> {
    positive_pressure(quantity, value).map(Physical::si)
}
