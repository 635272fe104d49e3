//! Columns in, columns out: many basic ratios of the sets, or many operating points of a gear.

use crate::work;
use epicyclic_commands::answer::to_json;
use epicyclic_commands::error::Error;
use epicyclic_commands::failure::WRONG;
use epicyclic_commands::refused::Refused;
use epicyclic_commands::shared::gearbox::{Choice, one};
use epicyclic_commands::sweep::points::{Columns as PointColumns, Request as Points};
use epicyclic_commands::sweep::{Columns, Request as Variants};
use epicyclic_formats::Document;
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_train::Gearbox;
use epicyclic_units::{Physical, Quantity};
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicUsize, Ordering};
use uom::si::f64::Ratio;

type Numbers<'py> = Bound<'py, PyArray1<f64>>;
type Flags<'py> = Bound<'py, PyArray1<bool>>;
type Given<'py> = Vec<(String, PyReadonlyArray1<'py, f64>)>;

/// States, ratios, whether there is one, efficiencies, whether there is one: by variant, then gear.
type RatioArrays<'py> = (Bound<'py, PyArray1<u8>>, Numbers<'py>, Flags<'py>, Numbers<'py>, Flags<'py>);

/// Speeds and whether they follow, torques, powers, whether any keeps it moving, losses, efficiencies and
/// whether there is one.
type PointArrays<'py> = (
    Numbers<'py>,
    Flags<'py>,
    Numbers<'py>,
    Numbers<'py>,
    Flags<'py>,
    Numbers<'py>,
    Numbers<'py>,
    Flags<'py>,
);

/// The gears, and the columns.
type Ratios<'py> = (Vec<String>, RatioArrays<'py>);

/// The links, the terminals, and the columns.
type AtPoints<'py> = (Vec<String>, Vec<String>, PointArrays<'py>);

/// Result, or an error as JSON; neither after a signal.
type Answered<Found> = (Option<Found>, Option<String>);

/// Reason why there is no result.
enum Failure {
    Answer(Box<Error>),
    /// Invalid value of a Python option: its name and the message.
    Option(&'static str, String),
}

impl<E: Into<Error>> From<E> for Failure {
    fn from(error: E) -> Self {
        Self::Answer(Box::new(error.into()))
    }
}

impl Failure {
    /// Error as the program writes it with `--format json`.
    fn json(&self) -> String {
        let refused = match self {
            Self::Answer(error) => Refused::of_answer(error, WRONG),
            Self::Option(option, message) => {
                Refused::new("option", message.clone(), WRONG).of_option((*option).to_owned())
            }
        };
        to_json(&refused).unwrap_or_default()
    }
}

/// A gearbox's description, owned by the thread that reads it.
#[derive(FromPyObject)]
pub(crate) struct Description {
    file_name: String,
    file: Vec<u8>,
    transmission: Option<String>,
    efficiency: Option<String>,
}

impl Description {
    fn gearbox(&self) -> Result<Gearbox, Failure> {
        let of = |text: &String| {
            let refuse = |message: String| Failure::Option("--efficiency", message);
            let eta: Quantity<Ratio> = text.parse().map_err(|why: _| refuse(format!("{why}")))?;
            MeshEfficiency::new(eta.0.si()).map_err(|why| refuse(why.to_string()))
        };
        let efficiency = self.efficiency.as_ref().map(of).transpose()?;
        let document = Document::parse_one(&self.file_name, &self.file)?;
        Ok(one(&document, &Choice { transmission: self.transmission.clone(), efficiency })?.train)
    }
}

fn owned(given: Given<'_>) -> Vec<(String, Vec<f64>)> {
    given.into_iter().map(|(name, values)| (name, values.as_array().to_vec())).collect()
}

fn borrowed(owned: &[(String, Vec<f64>)]) -> Vec<(String, &[f64])> {
    owned.iter().map(|(name, values)| (name.clone(), values.as_slice())).collect()
}

/// Solves on another thread and reports progress as the number of finished points.
fn solved<T: Send + 'static>(
    py: Python<'_>,
    progress: Option<&Bound<'_, PyAny>>,
    count: usize,
    solve: impl FnOnce(&(dyn Fn(usize) -> ControlFlow<()> + Sync)) -> Result<Option<T>, Failure> + Send + 'static,
) -> PyResult<Result<T, String>> {
    let found = work::done(py, progress, move |shared| {
        let done = AtomicUsize::new(0);
        let goes_on = |more: usize| {
            let done = done.fetch_add(more, Ordering::Relaxed) + more;
            shared.tell(format!("{done} of {count}"));
            if shared.is_ended() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        solve(&goes_on)
    })?;
    // Only a signal ends it, and then nobody waits for what it found.
    Ok(found.map_err(|failure| failure.json()).and_then(|found| found.ok_or_else(String::new)))
}

/// Ratios of a gearbox for many `k`; see `epicyclic.Gearbox.sweep`.
#[pyfunction]
#[pyo3(signature = (description, gears, k, progress=None))]
pub(crate) fn sweep<'py>(
    py: Python<'py>,
    description: Description,
    gears: Vec<String>,
    k: Given<'py>,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<Answered<Ratios<'py>>> {
    let k = owned(k);
    let count = k.first().map_or(1, |(_, values)| values.len());
    let found = solved(py, progress, count, move |goes_on| {
        let request = Variants { gears, k: borrowed(&k) };
        Ok(request.answer(&description.gearbox()?, goes_on)?)
    })?;
    Ok(match found {
        Ok(columns) => (Some(of_ratios(py, columns)), None),
        Err(refusal) => (None, Some(refusal)),
    })
}

fn of_ratios(py: Python<'_>, columns: Columns) -> Ratios<'_> {
    let states: Vec<u8> = columns.states.iter().map(|state| *state as u8).collect();
    let arrays = (
        states.into_pyarray(py),
        columns.ratios.into_pyarray(py),
        columns.has_ratio.into_pyarray(py),
        columns.efficiencies.into_pyarray(py),
        columns.has_efficiency.into_pyarray(py),
    );
    (columns.gears, arrays)
}

/// A gear at many speeds and torques; see `epicyclic.Gearbox.points`.
#[pyfunction]
#[pyo3(signature = (description, gear, speeds_rad_s, torques_n_m, progress=None))]
pub(crate) fn points<'py>(
    py: Python<'py>,
    description: Description,
    gear: String,
    speeds_rad_s: Given<'py>,
    torques_n_m: Given<'py>,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<Answered<AtPoints<'py>>> {
    let (speeds, torques) = (owned(speeds_rad_s), owned(torques_n_m));
    let count = speeds.first().map_or(1, |(_, values)| values.len());
    let found = solved(py, progress, count, move |goes_on| {
        let (speeds_rad_s, torques_n_m) = (borrowed(&speeds), borrowed(&torques));
        let request = Points { gear, speeds_rad_s, torques_n_m };
        Ok(request.answer(&description.gearbox()?, goes_on)?)
    })?;
    Ok(match found {
        Ok(columns) => (Some(of_points(py, columns)), None),
        Err(refusal) => (None, Some(refusal)),
    })
}

fn of_points(py: Python<'_>, columns: PointColumns) -> AtPoints<'_> {
    let arrays = (
        columns.speeds_rad_s.into_pyarray(py),
        columns.has_speed.into_pyarray(py),
        columns.torques_n_m.into_pyarray(py),
        columns.powers_w.into_pyarray(py),
        columns.moves.into_pyarray(py),
        columns.losses_w.into_pyarray(py),
        columns.efficiencies.into_pyarray(py),
        columns.has_efficiency.into_pyarray(py),
    );
    (columns.links, columns.terminals, arrays)
}
