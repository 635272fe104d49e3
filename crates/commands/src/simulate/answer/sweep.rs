//! Sweep of a scenario over values of one key.

use super::{Beside, ElementResult, LinkAtEnd, ShiftResult, Simulation, answer_watched, threads};
use crate::answer::{Answer, Warning};
use crate::error::Error;
use epicyclic_formats::Document;
use epicyclic_formats::scenario::{changed, path_of, read_changed};
use schemars::JsonSchema;
use serde::Serialize;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Maximum number of values.
pub const MOST: u32 = 1000;

/// Values of a key, from one to another, both included.
#[derive(Debug, Clone, PartialEq)]
pub struct Wanted {
    /// Key to be changed, such as `shifts[0].overlap`, `elements[C].holding`.
    pub key: String,
    /// First value in the unit.
    pub from: f64,
    /// Last value in the unit.
    pub to: f64,
    /// Unit as written; `None` for a plain number.
    pub unit: Option<String>,
    /// Number of values.
    pub steps: u32,
}

/// Scenario with several values of a key.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Sweep {
    /// Name of the scenario.
    pub scenario: String,
    /// Key that is changed.
    pub key: String,
    /// Unit of the values; null for plain numbers.
    pub unit: Option<String>,
    /// Runs in order of their values, without those that were not computed after an interruption.
    pub runs: Vec<SweptRun>,
    /// Warnings about the sweep.
    pub warnings: Vec<Warning>,
}

/// Run with one value of the key.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct SweptRun {
    /// Value of the key in the unit.
    pub value: f64,
    /// Shifts with their phases, output torque and heat.
    pub shifts: Vec<ShiftResult>,
    /// Loads of the shift elements and resistances.
    pub elements: Vec<ElementResult>,
    /// First time at which each threshold is passed.
    pub thresholds: Vec<Passing>,
    /// Speeds and accelerations of the links at the end.
    pub end: Vec<LinkAtEnd>,
    /// Reason why the motion is refused; null if there are results.
    pub refused: Option<String>,
}

/// Passing of a threshold.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Passing {
    /// Name of the threshold.
    pub id: String,
    /// First time at which the threshold is passed, in s; null if never.
    pub time_s: Option<f64>,
}

impl Answer for Sweep {
    const NAME: &'static str = "simulate-sweep";
}

/// Simulates the scenario with each value; `goes_on` receives the finished part and returns whether to
/// continue.
///
/// # Errors
/// [`Error::Places`] for too few or too many steps, [`Error::Sweep`] for a key that cannot be swept, and
/// [`Error::Document`] for a value that the key does not accept. A refused motion is not an error: its run
/// gives the reason.
pub fn sweep(
    document: &Document,
    beside: &Beside,
    wanted: &Wanted,
    goes_on: impl Fn(f64) -> bool + Sync + Send,
) -> Result<Sweep, Error> {
    if !(2..=MOST).contains(&wanted.steps) {
        return Err(Error::Places { places: wanted.steps, most: MOST });
    }
    let refuse = |why: String| Error::Sweep { why };
    let path = path_of(document, &wanted.key).map_err(refuse)?;
    if wanted.key.starts_with("gearbox") || wanted.key.starts_with("transmission") {
        return Err(refuse(format!("{}: the gearbox stays as it is", wanted.key)));
    }
    let last = f64::from(wanted.steps - 1);
    let values: Vec<f64> = (0..wanted.steps)
        .map(|step| wanted.from + (wanted.to - wanted.from) * (f64::from(step) / last))
        .collect();
    let files = values.iter().map(|&value| {
        let whole = changed(document, &path, value, wanted.unit.as_deref());
        Ok((value, read_changed(document, &whole)?))
    });
    let files = files.collect::<Result<Vec<_>, epicyclic_formats::Error>>().map_err(|error| {
        // The file has another value at that place, so the message names the swept value.
        Error::Sweep { why: format!("{}: {}", wanted.key, error.problem()) }
    })?;
    let scenario = files.first().map(|(_, file)| file.scenario.clone()).unwrap_or_default();
    let done = AtomicUsize::new(0);
    let runs = threads::map(&files, |(value, file)| {
        let goes_on = || goes_on(done.load(Ordering::Relaxed) as f64 / files.len() as f64);
        let mut is_whole = goes_on();
        if !is_whole {
            return None;
        }
        let simulation = answer_watched(document, file, beside, |_| {
            is_whole = goes_on();
            is_whole
        });
        let run = SweptRun::of(*value, file, simulation);
        done.fetch_add(1, Ordering::Relaxed);
        is_whole.then_some(run)
    });
    let runs: Vec<SweptRun> = runs.into_iter().flatten().collect();
    let mut warnings = vec![];
    if runs.len() < files.len() {
        let message = format!("interrupted: {} of {} runs are done", runs.len(), files.len());
        warnings.push(Warning { name: "interrupted", message });
    }
    let refused = runs.iter().filter(|run| run.refused.is_some()).count();
    if refused > 0 {
        let message = format!("{refused} of {} runs are refused", files.len());
        warnings.push(Warning { name: "refused", message });
    }
    Ok(Sweep { scenario, key: wanted.key.clone(), unit: wanted.unit.clone(), runs, warnings })
}

impl SweptRun {
    fn of(
        value: f64,
        file: &epicyclic_formats::scenario::ScenarioFile,
        simulation: Result<Simulation, Error>,
    ) -> Self {
        match simulation {
            Ok(simulation) => {
                let first = |id: &String| {
                    let passes = |event: &&super::EventRecord| event.changes.iter().any(|one| one.id == *id);
                    simulation.events.iter().find(passes).map(|event| event.time_s)
                };
                let of = |id: &String| Passing { id: id.clone(), time_s: first(id) };
                Self {
                    value,
                    thresholds: file.thresholds.iter().map(|one| of(&one.id)).collect(),
                    shifts: simulation.shifts,
                    elements: simulation.elements,
                    end: simulation.end,
                    refused: None,
                }
            }
            Err(error) => Self {
                value,
                shifts: vec![],
                elements: vec![],
                thresholds: vec![],
                end: vec![],
                refused: Some(error.to_string()),
            },
        }
    }
}
