//! The chapters of a hydromotor.

use crate::error::Error;
use crate::motor::answer::{self as motor, Designed, Motor, OverAngle, OverCycle};
use schemars::JsonSchema;
use serde::Serialize;

/// A hydromotor, and its flow and chambers over the angle of the rotor.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct MotorReport {
    /// Title in the file.
    pub title: Option<String>,
    /// The motor.
    pub motor: Motor,
    /// Flow and chambers through one lobe of the rotor.
    pub over_angle: OverAngle,
    /// A chamber and a satellite over their cycle.
    pub over_cycle: OverCycle,
}

/// The chapters of a motor.
///
/// # Errors
/// Those of [`motor::answer`] and [`motor::over_angle`].
pub fn answer(title: Option<String>, designed: &Designed) -> Result<MotorReport, Error> {
    let motor = motor::answer(designed)?;
    let (over_angle, over_cycle) = (motor::over_angle(designed)?, motor::over_cycle(designed)?);
    Ok(MotorReport { title, motor, over_angle, over_cycle })
}
