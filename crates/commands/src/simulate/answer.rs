//! Simulation of a gearbox by a scenario: shifts, starts, heat of the shift elements.
//!
//! Speeds and torques are positive along the axis; torques act on links from outside.
//!
//! # Peaks
//! Peaks of powers and torques are searched at the start, at the end, and immediately before and after every
//! event. They are also searched at equally spaced instants, at least two thousand. A larger value between
//! two instants is not detected.
//!
//! # Temperature
//! The heat of an element goes into one body with heat capacity `C` and conductance `G` to the oil. Its
//! temperature `θ` is that above the oil:
//!
//! ```text
//! C·dθ/dt = P − G·θ       θ(t + Δt) = θ·e + (ΔQ/Δt)/G·(1 − e)     e = exp(−G·Δt/C)     G = 0: θ + ΔQ/C
//! ```
//!
//! over the same instants. The heat `ΔQ` between two of them is integrated with the motion. The body starts
//! at the temperature of the oil.
//!
//! # Shifts
//! A shift ends (*locked*) when all elements that it applies hold, and continue to hold up to the next shift
//! or the end. Its torque phase begins when the first applied element carries torque. Its inertia phase
//! begins when the first released element, or a one-way clutch, lets go, and lasts up to the lock.
//!
//! The output torque is the one that sets and shift elements exert on the output. `J` and `T_applied` include
//! all links that are one piece with the output:
//!
//! ```text
//! T = J·ω̇ − Σ T_applied
//! ```
//!
//! Drags of the gearbox count as applied, except those of shift elements.

mod build;
mod drags;
mod elements;
mod joints;
mod parts;
mod place;
mod program;
mod samples;
mod shifts;
pub mod sweep;
#[cfg(test)]
mod tests;

use crate::answer::{Answer, Warning};
use crate::error::Error;
use crate::shared::fault::{Fault, Named};
use crate::shared::gearbox::{self, Choice, Gearbox};
use crate::shared::judgement::answer::Judgement;
use crate::tolerance::RESIDUAL;
pub use drags::{DragKind, DragResult, DragSamples};
pub use elements::ElementResult;
use epicyclic_formats::scenario::{ScenarioFile, Texts};
use epicyclic_formats::{Document, Path};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_motion::{self as motion, Change, Contact, Run};
use epicyclic_units::{Physical, Quantity};
pub use joints::{ConverterResult, ConverterSamples, ShaftResult, ShaftSamples};
use parts::Built;
pub use parts::ElementKind;
pub use samples::{ElementSamples, LinkSamples, Samples, TorqueSamples};
use schemars::JsonSchema;
use serde::Serialize;
pub use shifts::ShiftResult;
use std::ops::ControlFlow;
use uom::si::f64::{Energy, Time};

/// Minimum number of equally spaced instants at which peaks are searched.
const INSTANTS: f64 = 2000.0;
/// Maximum number of samples of an answer.
const MOST_SAMPLES: f64 = 20_000.0;

/// Files that are read in addition to a scenario.
#[derive(Debug, Default)]
pub struct Beside {
    /// Document of `gearbox_file`.
    pub gearbox: Option<Document>,
    /// CSV files by their names in the scenario.
    pub texts: Texts,
}

/// Simulated motion of a gearbox.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Simulation {
    /// Name of the scenario.
    pub scenario: String,
    /// Name of the gearbox.
    pub gearbox: String,
    /// Link of the gearbox's input.
    pub input: String,
    /// Link of the gearbox's output.
    pub output: String,
    /// Gear at the start; null if none is given.
    pub gear: Option<String>,
    /// Simulated time in s from time 0; less than in the scenario if the simulation was stopped.
    pub duration_s: f64,
    /// Events in order of time.
    pub events: Vec<EventRecord>,
    /// Shifts with their phases, output torque and heat.
    pub shifts: Vec<ShiftResult>,
    /// Loads of the shift elements and resistances.
    pub elements: Vec<ElementResult>,
    /// Losses of the gearbox's drags, in the order of its file, without drags between links that are one
    /// piece.
    pub drags: Vec<DragResult>,
    /// Loads of the elastic shafts.
    pub shafts: Vec<ShaftResult>,
    /// Loads of the torque converters.
    pub converters: Vec<ConverterResult>,
    /// Speeds and accelerations of links and bodies at the end.
    pub end: Vec<LinkAtEnd>,
    /// Work of each torque.
    pub works: Vec<Work>,
    /// Energy balance.
    pub energies: Energies,
    /// Speeds and torques over time.
    pub samples: Samples,
    /// Judgement of the gearbox by rules of practice.
    pub judgement: Judgement,
    /// Warnings about the simulation.
    pub warnings: Vec<Warning>,
}

/// Event during the motion.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct EventRecord {
    /// Time of the event in s.
    pub time_s: f64,
    /// Changes that occur together at this event.
    pub changes: Vec<ChangeRecord>,
    /// Speed of each link immediately after the event in rad/s, in the order of `end`.
    pub speeds_rad_s: Vec<f64>,
    /// Acceleration of each link immediately after the event in rad/s², in the order of `end`.
    pub accelerations_rad_s2: Vec<f64>,
    /// Torque of each element on its first link immediately after the event in N·m, in the order of
    /// `elements`.
    pub element_torques_n_m: Vec<f64>,
    /// Torque of each element on its first link immediately before the event in N·m, in the order of
    /// `elements`.
    pub element_torques_before_n_m: Vec<f64>,
    /// Torque of sets and shift elements on the output immediately before the event, in N·m.
    pub output_torque_before_n_m: f64,
    /// Torque of sets and shift elements on the output immediately after the event, in N·m.
    pub output_torque_n_m: f64,
    /// Heat of each element up to the event in J, in the order of `elements`.
    pub element_heats_j: Vec<f64>,
}

/// Change of a part's state.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ChangeRecord {
    /// Kind of the part.
    pub kind: ChangeKind,
    /// Name of the part.
    pub id: String,
    /// State before the change; null for a threshold.
    pub from: Option<State>,
    /// State after the change; null for a threshold.
    pub to: Option<State>,
    /// Whether the speed rises through a threshold; null for other parts.
    pub is_rising: Option<bool>,
}

/// Kinds of parts whose state changes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ChangeKind {
    /// Shift element or resistance.
    Element,
    /// Set with losses, whose rolling motion changes direction, starts or stops.
    Set,
    /// Shaft whose ends come into contact, or separate.
    Shaft,
    /// Drag between links that start to turn relative to each other, or stop.
    Drag,
    /// Threshold that a speed passes.
    Threshold,
}

/// States of an element, set or shaft.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum State {
    /// No torque; for a set: turns as a block; for a shaft: within its backlash.
    Open,
    /// Slips with the first link faster than the second; for a one-way clutch: overruns; for a set: the first
    /// gear is faster than its carrier.
    SlipsForward,
    /// Slips with the first link slower than the second; for a set: the first gear is slower than its
    /// carrier.
    SlipsBackward,
    /// Holds the links together; for a set: turns as a block.
    Holds,
    /// Shaft in contact: the first link drives the second forward.
    DrivesForward,
    /// Shaft in contact: the first link drives the second backward.
    DrivesBackward,
}

impl State {
    fn of(state: motion::State) -> Self {
        match state {
            motion::State::Open => Self::Open,
            motion::State::Forward => Self::SlipsForward,
            motion::State::Backward => Self::SlipsBackward,
            motion::State::Stuck => Self::Holds,
        }
    }

    fn of_shaft(contact: Contact) -> Self {
        match contact {
            Contact::Free => Self::Open,
            Contact::Forward => Self::DrivesForward,
            Contact::Backward => Self::DrivesBackward,
        }
    }
}

/// Link at the end of the motion.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct LinkAtEnd {
    /// Name of the link.
    pub link: String,
    /// Speed of the link in rad/s.
    pub speed_rad_s: f64,
    /// Acceleration of the link in rad/s².
    pub acceleration_rad_s2: f64,
}

/// Work of a torque.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Work {
    /// Name of the torque.
    pub id: String,
    /// Link on which the torque acts.
    pub link: String,
    /// Work in J; negative for a load.
    pub work_j: f64,
    /// Heat within the source in addition to its work, in J: that of the rotor of a Kloss motor.
    pub inner_loss_j: f64,
}

/// Energy balance.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Energies {
    /// Kinetic energy at the start in J.
    pub kinetic_before_j: f64,
    /// Kinetic energy at the end in J.
    pub kinetic_after_j: f64,
    /// Work of all torques in J.
    pub work_j: f64,
    /// Heat of all shift elements and resistances in J.
    pub element_heat_j: f64,
    /// Loss of all drags in J.
    pub drag_loss_j: f64,
    /// Loss of all meshes in J.
    pub mesh_loss_j: f64,
    /// Heat of the dampers of shafts in J.
    pub damping_heat_j: f64,
    /// Heat of the oil of converters in J.
    pub converter_heat_j: f64,
    /// Elastic energy of shafts at the start in J.
    pub elastic_before_j: f64,
    /// Elastic energy of shafts at the end in J.
    pub elastic_after_j: f64,
    /// Energy lost in impacts of dog clutches in J; friction elements lock without impact.
    pub impact_j: f64,
    /// Residual of the balance over the largest of these energies.
    pub residual: f64,
}

impl Answer for Simulation {
    const NAME: &'static str = "simulate";
}

/// Simulates a scenario; `file` is the content of `document`.
///
/// # Errors
/// [`Error::Document`] and [`Error::Placed`] with the place of the fault; errors of [`gearbox::read`] for the
/// gearbox.
pub fn answer(document: &Document, file: &ScenarioFile, beside: &Beside) -> Result<Simulation, Error> {
    answer_watched(document, file, beside, |_| ControlFlow::Continue(()))
}

/// Simulates a scenario and reports the finished part, from 0 to 1, to `goes_on`, which may end it. A
/// simulation that is ended in this way has all results up to then, and a warning.
///
/// # Errors
/// Errors of [`answer`].
pub fn answer_watched(
    document: &Document,
    file: &ScenarioFile,
    beside: &Beside,
    mut goes_on: impl FnMut(f64) -> ControlFlow<()>,
) -> Result<Simulation, Error> {
    let subject = subject(document, file, beside)?;
    let scenario = parts::Scenario { document, file, subject: &subject, texts: &beside.texts };
    let built = scenario.built()?;
    // The run is sampled more finely than the answer, because peaks are searched among its samples.
    let every = scenario.sampling()?;
    let whole = file.duration.0.si();
    let run = built.model.run_watched(&built.start, file.duration.0, Some(every.inner), &mut |time| {
        goes_on(time.si() / whole)
    });
    let run = run.map_err(|why| scenario.of_drag(&built.drags, why))?;
    Ok(told(&scenario, &built, &run, every.kept))
}

/// Gearbox of a scenario.
fn subject(document: &Document, file: &ScenarioFile, beside: &Beside) -> Result<Gearbox, Error> {
    let efficiency = file.efficiency.map(|eta| MeshEfficiency::new(eta.0.si())).transpose();
    let efficiency = efficiency.map_err(|why| refused(document, &root("efficiency"), &why))?;
    match &beside.gearbox {
        Some(other) => {
            let choice = Choice { transmission: file.transmission.clone(), efficiency };
            gearbox::one(other, &choice).map_err(|why| of_choice(document, file, why))
        }
        None => Ok(*gearbox::gearbox(document, root("gearbox"), efficiency)?),
    }
}

fn told(scenario: &parts::Scenario<'_>, built: &Built, run: &Run, kept: usize) -> Simulation {
    let (file, gearbox) = (scenario.file, &scenario.subject.train);
    let instants = elements::instants(run);
    let shifts = shifts::results(built, run, &instants);
    let elements = elements::results(built, run, &instants);
    let energies = Energies::of(run);
    let mut warnings = warnings(scenario, run, &shifts, &energies);
    let judgement = Judgement::added_to(&mut warnings, scenario.subject);
    Simulation {
        judgement,
        scenario: file.scenario.clone(),
        gearbox: gearbox.name().to_owned(),
        input: gearbox.link_name(gearbox.input()).to_owned(),
        output: gearbox.link_name(gearbox.output()).to_owned(),
        gear: file.gear.clone(),
        duration_s: run.end().time.si(),
        events: run.events.iter().map(|event| EventRecord::of(built, event)).collect(),
        shifts,
        elements,
        drags: drags::results(&built.drags, run, &instants),
        shafts: joints::shafts(&file.shafts, run, &instants),
        converters: joints::converters(&file.converters, run, &instants),
        end: at_end(run),
        works: works(file, run),
        energies,
        samples: samples::of(built, run, &instants, kept),
        warnings,
    }
}

/// Links at the end, without the housing, which is the first.
fn at_end(run: &Run) -> Vec<LinkAtEnd> {
    let end = run.end();
    let of = |(place, link): (usize, &String)| LinkAtEnd {
        link: link.clone(),
        speed_rad_s: end.speeds[place].si(),
        acceleration_rad_s2: end.accelerations[place].si(),
    };
    run.links.iter().enumerate().skip(1).map(of).collect()
}

fn works(file: &ScenarioFile, run: &Run) -> Vec<Work> {
    let of = |(place, id): (usize, &String)| Work {
        id: id.clone(),
        link: file.torques.iter().find(|one| one.id == *id).map(|one| one.link.clone()).unwrap_or_default(),
        work_j: run.audit.work[place].si(),
        inner_loss_j: run.audit.inner_losses[place].si(),
    };
    run.torques.iter().enumerate().map(of).collect()
}

impl Energies {
    fn of(run: &Run) -> Self {
        let sum = |all: &[Energy]| all.iter().map(|one| one.si()).sum();
        let audit = &run.audit;
        Self {
            kinetic_before_j: audit.before.si(),
            kinetic_after_j: audit.after.si(),
            work_j: sum(&audit.work),
            element_heat_j: sum(&audit.heat),
            drag_loss_j: sum(&audit.drags),
            mesh_loss_j: sum(&audit.mesh_losses),
            damping_heat_j: sum(&audit.damping),
            converter_heat_j: sum(&audit.converters),
            elastic_before_j: audit.elastic_before.si(),
            elastic_after_j: audit.elastic_after.si(),
            impact_j: audit.impacts.si(),
            residual: audit.residual(),
        }
    }
}

impl EventRecord {
    fn of(built: &Built, event: &motion::Event) -> Self {
        let motion::Event { before, after, .. } = event;
        let torques = |sample: &motion::Sample| sample.elements.iter().map(|one| one.si()).collect();
        Self {
            time_s: after.time.si(),
            changes: event.changes.iter().filter_map(ChangeRecord::of).collect(),
            speeds_rad_s: after.speeds.iter().skip(1).map(|one| one.si()).collect(),
            accelerations_rad_s2: after.accelerations.iter().skip(1).map(|one| one.si()).collect(),
            element_torques_n_m: torques(after),
            element_torques_before_n_m: torques(before),
            output_torque_before_n_m: built.output.torque(before),
            output_torque_n_m: built.output.torque(after),
            element_heats_j: after.heats.iter().map(|one| one.si()).collect(),
        }
    }
}

impl ChangeRecord {
    fn of(change: &Change) -> Option<Self> {
        let states = |kind, name: &str, from: State, to: State| Self {
            kind,
            id: name.to_owned(),
            from: Some(from),
            to: Some(to),
            is_rising: None,
        };
        Some(match change {
            Change::Element { name, from, to } => {
                states(ChangeKind::Element, name, State::of(*from), State::of(*to))
            }
            Change::Set { name, from, to } => states(ChangeKind::Set, name, State::of(*from), State::of(*to)),
            Change::Shaft { name, from, to } => {
                states(ChangeKind::Shaft, name, State::of_shaft(*from), State::of_shaft(*to))
            }
            Change::Drag { name, from, to } => {
                states(ChangeKind::Drag, name, State::of(*from), State::of(*to))
            }
            Change::Threshold { name, is_rising } => Self {
                kind: ChangeKind::Threshold,
                id: name.clone(),
                from: None,
                to: None,
                is_rising: Some(*is_rising),
            },
            // The enum is non-exhaustive in its crate; a kind unknown here has no record.
            _ => return None,
        })
    }
}

fn warnings(
    scenario: &parts::Scenario<'_>,
    run: &Run,
    shifts: &[ShiftResult],
    energies: &Energies,
) -> Vec<Warning> {
    let mut all = vec![];
    let (end, wanted) = (run.end().time, scenario.file.duration.0);
    if end < wanted {
        let message =
            format!("ended at {} of {}; what would come after is not known", Quantity(end), Quantity(wanted));
        all.push(Warning { name: "ended-early", message });
    }
    for shift in shifts.iter().filter(|shift| shift.locked_s.is_none()) {
        let message = format!(
            "the shift from {} to {} at {} does not end: what it applies does not hold at the end, or when the next begins",
            shift.from,
            shift.to,
            Quantity(Time::from_si(shift.at_s))
        );
        all.push(Warning { name: "not-locked", message });
    }
    if energies.residual.abs() > RESIDUAL {
        let message = format!("the energies miss {:.1e} of the largest of them", energies.residual.abs());
        all.push(Warning { name: "residual", message });
    }
    // One warning suffices: the split lasts as long as the redundant elements hold.
    let samples = run.samples.iter().chain(run.events.iter().map(|event| &event.after));
    if let Some(sample) = samples.into_iter().find(|sample| !sample.is_split_unique) {
        let message = format!(
            "at {} more elements hold than the motion needs: their torques are then split evenly, and rigid bodies leave it open how",
            Quantity(sample.time)
        );
        all.push(Warning { name: "even-split", message });
    }
    if scenario.file.drags == Some(false) && !scenario.subject.drags.is_empty() {
        let message = "the drags that the gearbox states are left out, as drags: false asks".to_owned();
        all.push(Warning { name: "drags", message });
    }
    all
}

/// Error about the choice from a list, placed in the scenario; faults of the gearbox have their own places.
fn of_choice(document: &Document, file: &ScenarioFile, why: Error) -> Error {
    let key = match &why {
        Error::Document(_) | Error::Placed { .. } => return why,
        _ if file.transmission.is_some() => "transmission",
        _ => "gearbox_file",
    };
    let at = document.error(&root(key), why.problem());
    Error::Placed { at: Box::new(at), why: Box::new(why) }
}

/// Errors for numbers out of range.
const ABOVE_0: Named<&str> = Named("not-positive", "it must be above 0");
const AT_LEAST_0: Named<&str> = Named("negative", "it must be at least 0");

/// Path of a key at the root.
fn root(key: &str) -> Path {
    Path::root().key(key)
}

/// Error at a place, with its own message.
fn refused(document: &Document, path: &Path, why: &impl Fault) -> Error {
    document.error(path, why.problem()).into()
}

/// Error of the motion, at a place.
fn placed(document: &Document, path: &Path, why: motion::Error) -> Error {
    let at = document.error(path, why.problem());
    Error::Placed { at: Box::new(at), why: Box::new(why.into()) }
}
