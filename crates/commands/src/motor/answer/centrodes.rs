//! Points of the centrodes.

use crate::error::Error;
use crate::shared::number::si;
use epicyclic_hydromotor::Motor;
use epicyclic_hydromotor::centrode::Wheel;
use schemars::JsonSchema;
use serde::Serialize;

/// Maximum number of points of a half-lobe.
pub const MOST_POINTS: u32 = 100_000;

/// Points of both centrodes, evenly spaced along each half-lobe, counter-clockwise from a crest on the x
/// axis.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Centrodes {
    /// Points of the stator, then those of the rotor.
    pub points: Vec<CentrodePoint>,
}

/// Point of a centrode.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct CentrodePoint {
    /// Wheel to which the centrode belongs.
    pub wheel: Wheel,
    /// Arc length from the crest, in m.
    pub arc_length_m: f64,
    /// Coordinate x of the point, in m.
    pub x_m: f64,
    /// Coordinate y of the point, in m.
    pub y_m: f64,
    /// Distance from the axis, in m.
    pub polar_radius_m: f64,
    /// Angle about the axis, in rad.
    pub polar_angle_rad: f64,
    /// Direction of the tangent, in rad.
    pub tangent_rad: f64,
    /// Curvature in 1/m, the reciprocal of the radius.
    pub curvature_per_m: f64,
}

/// Computes so many points of each half-lobe.
///
/// # Errors
/// [`Error::CentrodePoints`] unless the number is from 1 to [`MOST_POINTS`].
pub fn centrodes(motor: &Motor, points: u32) -> Result<Centrodes, Error> {
    if !(1..=MOST_POINTS).contains(&points) {
        return Err(Error::CentrodePoints { points, most: MOST_POINTS });
    }
    let numbers = motor.numbers();
    let wheels = [(Wheel::Stator, numbers.stator_lobes()), (Wheel::Rotor, numbers.rotor_lobes())];
    let mut found = vec![];
    for (wheel, lobes) in wheels {
        let curve = motor.centrode(wheel);
        let count = 2 * u64::from(lobes) * u64::from(points);
        for i in 0..count {
            #[allow(clippy::cast_precision_loss, reason = "far below 2⁵³")]
            let point = curve.at(curve.length() * (i as f64 / count as f64))?;
            found.push(CentrodePoint {
                wheel,
                arc_length_m: si(point.arc_length),
                x_m: si(point.x),
                y_m: si(point.y),
                polar_radius_m: si(point.polar_radius),
                polar_angle_rad: si(point.polar_angle),
                tangent_rad: si(point.tangent),
                curvature_per_m: point.curvature.value + 0.0,
            });
        }
    }
    Ok(Centrodes { points: found })
}
