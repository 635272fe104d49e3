//! Chambers and satellites of a motor at an angle of its rotor.

use super::Designed;
use crate::error::Error;
use crate::shared::number::si;
use epicyclic_hydromotor as hydromotor;
use epicyclic_hydromotor::chambers::Phase;
use epicyclic_hydromotor::flanks::Push;
use schemars::JsonSchema;
use serde::Serialize;
use uom::si::f64::Pressure;

/// Chamber at an angle of the rotor.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Chamber {
    /// Number of the chamber, equal to that of the satellite behind it; counter-clockwise from 0.
    pub chamber: u32,
    /// Area of the chamber in m².
    pub area_m2: f64,
    /// Derivative of the area with respect to the rotor angle, in m² per rad.
    pub growth_per_radian_m2: f64,
    /// State of the chamber while the rotor runs counter-clockwise.
    pub state: Phase,
}

/// Satellite at an angle of the rotor.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Satellite {
    /// Number of the satellite, counter-clockwise from 0.
    pub satellite: u32,
    /// Coordinate x of the satellite's centre, in m.
    pub x_m: f64,
    /// Coordinate y of the satellite's centre, in m.
    pub y_m: f64,
    /// Rotation of the satellite in rad.
    pub rotation_rad: f64,
    /// Pressure in the chamber behind the satellite, in Pa; null without width and pressure.
    pub pressure_behind_pa: Option<f64>,
    /// Pressure in the chamber in front of the satellite, in Pa, with the low pressure as 0; null without
    /// width and pressure.
    pub pressure_in_front_pa: Option<f64>,
    /// Pressure force on the satellite in N, positive counter-clockwise, across the ray from the axis; null
    /// without width and pressure.
    pub force_n: Option<f64>,
    /// Direction in which the pressure pushes the satellite; null while it is idle.
    pub push: Option<Push>,
    /// Force on each of the two loaded flanks in N, with contacts at the pitch points; null without width and
    /// pressure.
    pub flank_force_n: Option<f64>,
}

pub(crate) fn chambers(designed: &Designed) -> Result<Vec<Chamber>, Error> {
    let chambers = designed.motor.chambers(designed.angle)?;
    let record = |chamber: &hydromotor::chambers::Chamber| {
        let state = Phase::of(chamber, &chambers);
        let growth = if state == Phase::AtExtreme { 0.0 } else { si(chamber.growth) };
        Chamber { chamber: chamber.index, area_m2: si(chamber.area), growth_per_radian_m2: growth, state }
    };
    Ok(chambers.iter().map(record).collect())
}

pub(crate) fn satellites(designed: &Designed) -> Result<Vec<Satellite>, Error> {
    let motor = &designed.motor;
    let satellites = motor.satellites(designed.angle)?;
    let forces = match (designed.width, designed.pressure) {
        (Some(width), Some(pressure)) => {
            Some(motor.satellite_forces(designed.angle, width, pressure, Pressure::default())?)
        }
        _ => None,
    };
    let alpha = designed.form.pressure_angle;
    let on_flanks = match (designed.width, designed.pressure, &designed.profile) {
        // The motor itself carries the warning about a force that the flanks cannot hold.
        (Some(width), Some(pressure), Ok(_)) => {
            motor.flank_forces(alpha, designed.angle, width, pressure).unwrap_or_default()
        }
        _ => vec![],
    };
    let record = |(i, satellite): (usize, &hydromotor::satellites::Satellite)| {
        let force = forces.as_ref().and_then(|forces| forces.get(i));
        let on_flank = on_flanks.get(i);
        Satellite {
            satellite: satellite.index,
            x_m: si(satellite.centre.x),
            y_m: si(satellite.centre.y),
            rotation_rad: si(satellite.rotation),
            pressure_behind_pa: force.map(|force| si(force.pressure_behind)),
            pressure_in_front_pa: force.map(|force| si(force.pressure_in_front)),
            force_n: force.map(|force| si(force.force)),
            push: on_flank.and_then(|one| one.push),
            flank_force_n: on_flank.map(|one| si(one.force)),
        }
    };
    Ok(satellites.iter().enumerate().map(record).collect())
}
