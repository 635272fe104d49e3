//! Chapters of a hydromotor.

use crate::error::Error;
use crate::motor::answer::{self as motor, Designed, Motor, OverAngle, OverCycle};
use schemars::JsonSchema;
use serde::Serialize;

/// Hydromotor, and its flow and chambers over the rotor angle.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct MotorReport {
    /// Title in the file; null if it has none.
    pub title: Option<String>,
    /// Results for the motor.
    pub motor: Motor,
    /// Flow and chambers over one lobe of the rotor.
    pub over_angle: OverAngle,
    /// Chamber and satellite over their cycle.
    pub over_cycle: OverCycle,
}

/// Computes the chapters of a motor.
///
/// # Errors
/// Errors of [`motor::answer`] and [`motor::over_angle`].
pub fn answer(title: Option<String>, designed: &Designed) -> Result<MotorReport, Error> {
    let motor = motor::answer(designed)?;
    let (over_angle, over_cycle) = (motor::over_angle(designed)?, motor::over_cycle(designed)?);
    Ok(MotorReport { title, motor, over_angle, over_cycle })
}
