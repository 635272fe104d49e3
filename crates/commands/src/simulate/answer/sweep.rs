//! Sweep of a scenario over values of one key.

use super::{Beside, ElementResult, LinkAtEnd, ShiftResult, Simulation, answer_watched, subject};
use crate::answer::{Answer, Warning};
use crate::error::Error;
use crate::shared::judgement::answer::Judgement;
use epicyclic_formats::Document;
use epicyclic_formats::scenario::{changed, path_of, read_changed};
use epicyclic_numerics::threads::map;
use epicyclic_units::visible::one_line;
use epicyclic_units::{self as quantity, Dimension, Measured};
use schemars::JsonSchema;
use serde::Serialize;
use std::ops::ControlFlow;
use std::str::FromStr;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Maximum number of values.
const MOST: u32 = 1000;

/// Values of a key, from one to another, both included: `shifts[0].overlap=0ms..300ms`.
#[derive(Debug, Clone)]
pub struct Range {
    /// Key to be changed, such as `shifts[0].overlap`, `elements[C].holding`.
    key: String,
    /// First value.
    from: Measured,
    /// Last value, in the unit of the first.
    to: Measured,
}

impl FromStr for Range {
    type Err = String;

    fn from_str(written: &str) -> Result<Self, String> {
        let form =
            || format!("{}: write a key and two values, as shifts[0].overlap=0ms..300ms", one_line(written));
        let (key, values) = written.split_once('=').ok_or_else(form)?;
        let (from, to) = values.split_once("..").ok_or_else(form)?;
        let value = |text: &str| quantity::parse(text.trim()).map_err(|error| error.to_string());
        let (from, to) = (value(from)?, value(to)?);
        if from.unit != to.unit {
            return Err(format!("{}: both values in one unit", one_line(written)));
        }
        Ok(Self { key: key.trim().to_owned(), from, to })
    }
}

impl Range {
    /// Unit as written; `None` for plain numbers.
    fn unit(&self) -> Option<&'static str> {
        let symbol = self.from.unit.symbol;
        (self.from.dimension() != Dimension::Dimensionless || symbol != "1").then_some(symbol)
    }
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
    /// Judgement of the gearbox by rules of practice.
    pub judgement: Judgement,
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

/// Simulates the scenario with each value; `goes_on` receives the finished part and may end the sweep.
///
/// # Errors
/// [`Error::Places`] for too few or too many steps, [`Error::Sweep`] for a key that cannot be swept, and
/// [`Error::Document`] for a value that the key does not accept. A refused motion is not an error: its run
/// gives the reason.
pub(crate) fn sweep(
    document: &Document,
    beside: &Beside,
    range: &Range,
    steps: u32,
    goes_on: impl Fn(f64) -> ControlFlow<()> + Sync + Send,
) -> Result<Sweep, Error> {
    if !(2..=MOST).contains(&steps) {
        return Err(Error::Places { places: steps, most: MOST });
    }
    let refuse = |why: String| Error::Sweep { why };
    let (key, unit) = (&range.key, range.unit());
    let path = path_of(document, key).map_err(refuse)?;
    if key.starts_with("gearbox") || key.starts_with("transmission") {
        return Err(refuse(format!("{key}: the gearbox stays as it is")));
    }
    let (from, to) = (range.from.value, range.to.value);
    let last = f64::from(steps - 1);
    let values: Vec<f64> = (0..steps).map(|step| from + (to - from) * (f64::from(step) / last)).collect();
    let files = values.iter().map(|&value| {
        let whole = changed(document, &path, value, unit);
        Ok((value, read_changed(document, &whole)?))
    });
    let files = files.collect::<Result<Vec<_>, epicyclic_formats::Error>>().map_err(|error| {
        // The file has another value at that place, so the message names the swept value.
        Error::Sweep { why: format!("{key}: {}", error.problem()) }
    })?;
    let scenario = files.first().map(|(_, file)| file.scenario.clone()).unwrap_or_default();
    let done = AtomicUsize::new(0);
    let runs = map(&files, |(value, file)| {
        let goes_on = || goes_on(done.load(Ordering::Relaxed) as f64 / files.len() as f64);
        let mut asked = goes_on();
        if asked.is_break() {
            return None;
        }
        let simulation = answer_watched(document, file, beside, |_| {
            asked = goes_on();
            asked
        });
        let run = SweptRun::of(*value, file, simulation);
        done.fetch_add(1, Ordering::Relaxed);
        asked.is_continue().then_some(run)
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
    // The gearbox is that of all runs; where it is refused, each of them says so.
    let gearbox = files.first().and_then(|(_, file)| subject(document, file, beside).ok());
    let judgement = gearbox.map(|gearbox| Judgement::added_to(&mut warnings, &gearbox)).unwrap_or_default();
    Ok(Sweep { scenario, key: key.clone(), unit: unit.map(str::to_owned), runs, judgement, warnings })
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
