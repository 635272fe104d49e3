//! Chambers and satellites of a motor at an angle of its rotor.

use super::Designed;
use crate::error::Error;
use crate::shared::number::si;
use epicyclic_hydromotor as hydromotor;
use epicyclic_hydromotor::chambers::Phase;
use schemars::JsonSchema;
use serde::Serialize;
use uom::si::f64::Pressure;

/// A chamber at an angle of the rotor.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Chamber {
    /// Its number, that of the satellite behind it, counter-clockwise from 0.
    pub chamber: u32,
    /// Its area.
    pub area_m2: f64,
    /// How its area grows with the rotor's angle, a radian.
    pub growth_per_radian_m2: f64,
    /// What it does as the rotor runs counter-clockwise.
    pub state: ChamberState,
}

/// What a chamber does.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ChamberState {
    /// It grows, and fills from the high pressure.
    Filling,
    /// It shrinks, and empties into the low pressure.
    Emptying,
    /// It changes over at its greatest or least area.
    ChangingOver,
}

/// A satellite at an angle of the rotor.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Satellite {
    /// Its number, counter-clockwise from 0.
    pub satellite: u32,
    /// Its centre.
    pub x_m: f64,
    /// Its centre.
    pub y_m: f64,
    /// How far it has turned.
    pub rotation_rad: f64,
    /// Pressure in the chamber behind it; null, as the force, without width and pressure.
    pub pressure_behind_pa: Option<f64>,
    /// Pressure in the chamber in front of it; the low pressure counts as 0.
    pub pressure_in_front_pa: Option<f64>,
    /// Force of the pressures on it, positive counter-clockwise across the ray from the axis.
    pub force_n: Option<f64>,
    /// Which way the pressure pushes it; null while it is idle.
    pub push: Option<Push>,
    /// Force on each of its two flanks that carry, with contacts at the pitch points.
    pub flank_force_n: Option<f64>,
}

/// Which way the pressure pushes a satellite.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Push {
    /// Counter-clockwise: it is by a crest.
    Crest,
    /// Clockwise: it is by a trough.
    Trough,
}

impl Push {
    pub(crate) const fn of(push: hydromotor::flanks::Push) -> Self {
        match push {
            hydromotor::flanks::Push::Forward => Self::Crest,
            hydromotor::flanks::Push::Back => Self::Trough,
        }
    }
}

pub(crate) fn state_of(
    chamber: &hydromotor::chambers::Chamber,
    all: &[hydromotor::chambers::Chamber],
) -> ChamberState {
    match Phase::of(chamber, all) {
        Phase::Filling => ChamberState::Filling,
        Phase::Emptying => ChamberState::Emptying,
        Phase::AtExtreme => ChamberState::ChangingOver,
    }
}

pub(crate) fn chambers(designed: &Designed) -> Result<Vec<Chamber>, Error> {
    let chambers = designed.motor.chambers(designed.angle)?;
    let record = |chamber: &hydromotor::chambers::Chamber| {
        let state = state_of(chamber, &chambers);
        let growth = if state == ChamberState::ChangingOver { 0.0 } else { si(chamber.growth) };
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
        // What the flanks cannot hold is told of the motor.
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
            push: on_flank.and_then(|one| one.push).map(Push::of),
            flank_force_n: on_flank.map(|one| si(one.force)),
        }
    };
    Ok(satellites.iter().enumerate().map(record).collect())
}
