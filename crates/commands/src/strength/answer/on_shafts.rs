//! Duty of a file on the shafts of the gearbox: what it asks for, before any set is rated.

use super::duty::{WorkedStep, steps};
use super::overload::peaks;
use crate::error::Error;
use crate::shared::gearbox::Gearbox;
use epicyclic_formats::gearbox::{GearboxFile, StrengthEntry};
use epicyclic_strength::factor::Symbol;
use epicyclic_units::Physical;
use schemars::JsonSchema;
use serde::Serialize;

/// Duty that a file asks for, with its life.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct AskedDuty {
    /// Steps of the duty.
    pub steps: Vec<StepOnShafts>,
    /// Greatest torques on the input in the life; empty without an overload.
    pub overload: Vec<OverloadOnInput>,
    /// Application factors `K_A` that the sets state, each once.
    pub application_factors: Vec<f64>,
    /// Required life in s; null if the file does not state it.
    pub life_s: Option<f64>,
}

/// Step of a duty on input and output.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct StepOnShafts {
    /// Name of the gear.
    pub gear: String,
    /// Share of the time.
    pub share: f64,
    /// Speed of the input in rad/s.
    pub input_speed_rad_s: f64,
    /// Torque on the input in N·m.
    pub input_torque_n_m: f64,
    /// Power into the input in W; below 0 where the output drives.
    pub input_power_w: f64,
    /// Speed of the output in rad/s; null in a step without load.
    pub output_speed_rad_s: Option<f64>,
    /// Torque that the output gives, with the losses of the meshes, in N·m; null in a step without load.
    pub output_torque_n_m: Option<f64>,
    /// Efficiency of the meshes; null in a step without load, or if the losses hold the gear.
    pub efficiency: Option<f64>,
}

/// Greatest torque of the life in a gear.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct OverloadOnInput {
    /// Name of the gear.
    pub gear: String,
    /// Torque on the input in N·m.
    pub input_torque_n_m: f64,
}

impl AskedDuty {
    /// Reads the duty of a file; `None` of a list of transmissions, and without a duty.
    ///
    /// # Errors
    /// [`Error::Document`] for invalid data in the file, with the place.
    pub(crate) fn of(subject: &Gearbox) -> Result<Option<Self>, Error> {
        if subject.document.value().get("transmissions").is_some() {
            return Ok(None);
        }
        let file: GearboxFile = subject.document.read()?;
        if file.duty.is_empty() {
            return Ok(None);
        }
        // Overloads of gears that do not exist are refused as by `strength`.
        peaks(subject, &file.overload, None)?;
        let overload = file
            .overload
            .iter()
            .map(|entry| OverloadOnInput { gear: entry.gear.clone(), input_torque_n_m: entry.torque.0.si() });
        Ok(Some(Self {
            steps: steps(subject, &file.duty)?.iter().map(StepOnShafts::of).collect(),
            overload: overload.collect(),
            application_factors: application_factors(&file),
            life_s: file.life.map(|life| life.0.si()),
        }))
    }
}

impl StepOnShafts {
    fn of(WorkedStep(entry, worked): &WorkedStep<'_>) -> Self {
        let (speed, torque) = (entry.speed.0, entry.torque.0);
        let at_load = worked.as_ref().and_then(|worked| Some((worked, worked.operation.as_ref()?)));
        let output_speed = at_load.and_then(|(worked, operation)| {
            let output = worked.analysis.gear().output();
            operation.speeds[output.index()]
        });
        let efficiency = at_load.and_then(|(_, operation)| {
            let entering = operation.entering.si().abs();
            Some(1.0 - operation.loss.si() / entering).filter(|of| entering > 0.0 && *of > 0.0)
        });
        Self {
            gear: entry.gear.clone(),
            share: entry.share.0.si(),
            input_speed_rad_s: speed.si(),
            input_torque_n_m: torque.si(),
            input_power_w: (torque * speed).si(),
            output_speed_rad_s: output_speed.map(Physical::si),
            // The torque of the operation is that on the output from outside.
            output_torque_n_m: at_load.map(|(_, operation)| -operation.output.si()),
            efficiency,
        }
    }
}

/// Application factors of all sets, each once.
fn application_factors(file: &GearboxFile) -> Vec<f64> {
    let simple = file.sets.iter().filter_map(|set| set.strength.as_ref());
    let compound = file.compound_sets.iter().filter_map(|set| set.strength.as_ref());
    let own = |strength: &StrengthEntry| {
        let mut all = strength.factors.iter();
        all.find(|(name, _)| Symbol::named(name) == Some(Symbol::Application)).map(|(_, value)| value.get())
    };
    let mut all: Vec<f64> = simple.chain(compound).filter_map(own).collect();
    all.sort_by(f64::total_cmp);
    all.dedup();
    all
}
