//! The file of a scenario: `epicyclic simulate scenario.yaml`.
//!
//! ```yaml
//! scenario: start of a conveyor
//! gearbox:
//!   gearbox: conveyor
//!   input: D
//!   output: B
//!   sets: [{ id: P, sun: D, ring: ground, carrier: B, k: 3 }]
//! inertias: { D: 0.2 kg·m², B: 8 kg·m² }
//! torques:
//!   - { id: motor, link: D, constant: 20 N·m }
//!   - { id: belt, link: B, resistance: 40 N·m }
//! duration: 2 s
//! ```
//!
//! is enough. Torques on links are positive along the axis, as speeds are, so that a load has a minus. A
//! [`ScenarioFile`] says what was written; what is meant by it is made where it is simulated.

mod change;
mod elements;
mod joints;
mod tables;
mod torques;

pub use change::{changed, path_of};
pub use elements::{CapacityEntry, ElementEntry, OverSlipEntry, PressureEntry, ShiftEntry};
pub use joints::{ConverterEntry, DogEntry, ShaftEntry};
pub use tables::{Points, TableFault, Texts, pairs, read_csv};
pub use torques::{
    ConstantPowerEntry, HarmonicEntry, KlossEntry, LinearEntry, OverSpeedEntry, OverTimeEntry,
    ResistingEntry, ThrottleEntry, TorqueEntry,
};

use crate::gearbox::GearboxFile;
use crate::{Document, Error, FileKind, Path, Problem};
use epicyclic_units::Quantity;
use schemars::JsonSchema;
use serde::Deserialize;
use std::collections::BTreeMap;
use uom::si::f64::{AngularVelocity, Length, Mass, MomentOfInertia, Ratio, Time};

/// A gearbox with masses, what drives, loads and shifts it, and how long.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ScenarioFile {
    /// Name of the scenario.
    pub scenario: String,
    /// The gearbox, with the keys of a gearbox file.
    #[serde(default)]
    pub gearbox: Option<Box<GearboxFile>>,
    /// In place of `gearbox`: a gearbox file, or a list of transmissions, by its path from the folder of this
    /// file.
    #[serde(default)]
    pub gearbox_file: Option<String>,
    /// One transmission of the list in `gearbox_file`: its name, or a part that no other name has.
    #[serde(default)]
    pub transmission: Option<String>,
    /// Efficiency with the carrier fixed of each set for which the gearbox states no losses, 0.97 or 97 %.
    /// Default: no losses.
    #[serde(default)]
    pub efficiency: Option<Quantity<Ratio>>,
    /// Whether the drags that the gearbox states act. Default: they do.
    #[serde(default)]
    pub drags: Option<bool>,
    /// Inertia of each link about the main axis, without planets. Default 0.
    #[serde(default)]
    pub inertias: BTreeMap<String, Quantity<MomentOfInertia>>,
    /// Bodies beside the gearbox, which shafts and converters join to it, and their inertias.
    #[serde(default)]
    pub bodies: BTreeMap<String, Quantity<MomentOfInertia>>,
    /// Planets that have inertia. Default: none has, whatever the gearbox says of their masses.
    #[serde(default)]
    pub planets: Vec<PlanetsEntry>,
    /// Shift elements that are engaged all the time, and never slip.
    #[serde(default)]
    pub engaged: Vec<String>,
    /// Gear at the start: its elements with `holding` hold until a shift releases them.
    #[serde(default)]
    pub gear: Option<String>,
    /// Speeds at the start. Default: everything at rest.
    #[serde(default)]
    pub start: Option<StartEntry>,
    /// How long, from time 0.
    pub duration: Quantity<Time>,
    /// Interval of the samples in the answer. Default: a two-hundredth of the duration.
    #[serde(default)]
    pub sample_every: Option<Quantity<Time>>,
    /// Torques on links.
    #[serde(default)]
    pub torques: Vec<TorqueEntry>,
    /// Shift elements of the gearbox that carry by friction.
    #[serde(default)]
    pub elements: Vec<ElementEntry>,
    /// Elastic shafts. Default: all is rigid.
    #[serde(default)]
    pub shafts: Vec<ShaftEntry>,
    /// Torque converters.
    #[serde(default)]
    pub converters: Vec<ConverterEntry>,
    /// Shifts, in order of time.
    #[serde(default)]
    pub shifts: Vec<ShiftEntry>,
    /// Speeds whose passing is an event.
    #[serde(default)]
    pub thresholds: Vec<ThresholdEntry>,
}

/// The planets of a set.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PlanetsEntry {
    /// The set.
    pub set: String,
    /// How many of each kind stand around the axis. Default: what the gearbox says.
    #[serde(default)]
    pub count: Option<u32>,
    /// The planet, or the planets of different kinds in the order in which the set names them.
    pub each: Vec<PlanetEntry>,
}

/// One planet.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PlanetEntry {
    /// Inertia about its own axis.
    pub inertia: Quantity<MomentOfInertia>,
    /// Mass. Default: as the gearbox says, by `planet_mass` or by the planet's shape.
    #[serde(default)]
    pub mass: Option<Quantity<Mass>>,
    /// Radius of its centre. Default: as the gearbox says, by `carrier_radius` or by module and teeth.
    #[serde(default)]
    pub radius: Option<Quantity<Length>>,
}

/// Speeds at the start.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StartEntry {
    /// Speed of the input in the gear at the start; the other links then turn as in this gear.
    #[serde(default)]
    pub input_speed: Option<Quantity<AngularVelocity>>,
    /// Speeds of links, from which those of all others follow.
    #[serde(default)]
    pub speeds: BTreeMap<String, Quantity<AngularVelocity>>,
}

/// A speed whose passing is an event.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ThresholdEntry {
    /// Name of the threshold.
    pub id: String,
    /// The link.
    pub link: String,
    /// The speed.
    pub speed: Quantity<AngularVelocity>,
}

impl ScenarioFile {
    /// The files of tables that it names, each with the place where.
    #[must_use]
    pub fn csv_files(&self) -> Vec<(&str, Path)> {
        let torques = (0..).zip(&self.torques).map(|(place, torque)| {
            let entry = Path::root().key("torques").index(place);
            let over_time = torque.over_time.as_ref().and_then(|table| table.csv.as_deref());
            let over_speed = torque.over_speed.as_ref().and_then(|table| table.csv.as_deref());
            let of_throttle = |of: fn(&ThrottleEntry) -> &OverSpeedEntry| {
                torque.throttle.as_ref().and_then(|throttle| of(throttle).csv.as_deref())
            };
            let throttle = entry.clone().key("throttle");
            [
                (over_time, entry.clone().key("over_time")),
                (over_speed, entry.key("over_speed")),
                (of_throttle(|one| &one.closed), throttle.clone().key("closed")),
                (of_throttle(|one| &one.full), throttle.key("full")),
            ]
            .map(|(file, path)| file.map(|file| (file, path.key("csv"))))
        });
        let elements = (0..).zip(&self.elements).map(|(place, element)| {
            let entry = Path::root().key("elements").index(place);
            let capacity = element.capacity.as_ref().and_then(|table| table.csv.as_deref());
            let pressure = element.pressure.as_ref().and_then(|table| table.csv.as_deref());
            [("capacity", capacity), ("pressure", pressure)]
                .map(|(key, file)| file.map(|file| (file, entry.clone().key(key).key("csv"))))
        });
        torques.flatten().chain(elements.flatten()).flatten().collect()
    }
}

/// The file in a document, whose gearbox is given in one way.
///
/// # Errors
/// The first thing wrong, with its place.
pub fn read(document: &Document) -> Result<ScenarioFile, Error> {
    document.must_be(FileKind::Scenario)?;
    read_changed(document, document.value())
}

/// The scenario of a changed value in place of the document's own.
///
/// # Errors
/// As [`read`].
pub fn read_changed(document: &Document, value: &crate::yaml::Value) -> Result<ScenarioFile, Error> {
    let file: ScenarioFile = document.read_value(value, &Path::root())?;
    let refuse =
        |name, path: Path, message: &str| Err(document.error(&path, Problem::refused(name, message)));
    match (&file.gearbox, &file.gearbox_file) {
        (Some(_), None) | (None, Some(_)) => {}
        (Some(_), Some(_)) => {
            return refuse(
                "two-gearboxes",
                Path::root().key("gearbox_file"),
                "give either gearbox or gearbox_file",
            );
        }
        (None, None) => {
            return refuse("no-gearbox", Path::root(), "a gearbox is due: gearbox or gearbox_file");
        }
    }
    if file.transmission.is_some() && file.gearbox_file.is_none() {
        return refuse(
            "transmission-without-file",
            Path::root().key("transmission"),
            "it chooses from the list in gearbox_file",
        );
    }
    Ok(file)
}
