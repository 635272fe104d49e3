//! Gears with two inputs over a map of their speeds. Places are computed one by one, because a map may have a
//! million.

use super::{Given, Origin, Task};
use crate::analyze::answer::warnings;
use crate::answer::{Answer, Warning};
use crate::error::Error;
use crate::finite;
use crate::shared::gearbox::Gearbox;
use crate::shared::judgement::answer::Judgement;
use crate::shared::places::Places;
use epicyclic_train::inputs::MultiState;
use epicyclic_train::{InputsFault, LinkId};
use epicyclic_units::Physical;
use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::ser::{Error as _, SerializeSeq as _};
use serde::{Serialize, Serializer};
use std::borrow::Cow;
use uom::si::f64::{AngularVelocity, Torque};

/// Range of speeds of a link, in a direction of a map.
pub type MapPlaces = Places<AngularVelocity, 1000>;

/// Gear with two inputs over a map of their speeds.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields, rename = "Map")]
pub struct Map<Entries = Vec<MapEntry>> {
    /// Name of the gearbox.
    pub gearbox: String,
    /// Name of the gear.
    pub gear: String,
    /// Link whose speed changes from one row of the map to the next.
    pub first_link: String,
    /// Link whose speed changes within a row.
    pub second_link: String,
    /// Given torques.
    pub torques: Vec<GivenTorque>,
    /// Entries for every link at every place of the map, row by row.
    pub map: Entries,
    /// Judgement of the gearbox by rules of practice.
    pub judgement: Judgement,
    /// Warnings about the gear.
    pub warnings: Vec<Warning>,
}

/// Given torque on a link.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct GivenTorque {
    /// Name of the link.
    pub link: String,
    /// Torque on the link from outside in N·m.
    pub torque_n_m: f64,
}

/// Link at a place of a map.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct MapEntry {
    /// Speed of the first link of the map in rad/s.
    pub first_speed_rad_s: f64,
    /// Speed of the second link of the map in rad/s.
    pub second_speed_rad_s: f64,
    /// Name of the link that this entry describes.
    pub link: String,
    /// Speed of the link in rad/s; null if it does not follow from the given speeds.
    pub speed_rad_s: Option<f64>,
    /// Torque on the link from outside in N·m; null unless power enters or leaves there, or if the losses
    /// hold the gear.
    pub torque_n_m: Option<f64>,
    /// Power through the link in W; null if the losses hold the gear.
    pub power_w: Option<f64>,
    /// Efficiency of the whole gearbox at this place; null if the losses hold the gear.
    pub efficiency: Option<f64>,
}

impl<Entries: Serialize + JsonSchema> Answer for Map<Entries> {
    const NAME: &'static str = "analyze-map";
}

/// Analyzes a gear with two inputs over ranges of their speeds, with the given torques, otherwise those of
/// the file.
///
/// The corners of the map are computed at once, so that invalid input is refused before anything is written.
///
/// # Errors
/// Errors of [`answer`](super::answer).
pub fn map<'a>(
    subject: &'a Gearbox,
    gear: &str,
    ranges: [(String, MapPlaces); 2],
    torques: Option<&[(String, Torque)]>,
) -> Result<SpeedMap<'a>, Error> {
    let task = Task::new(subject, gear)?;
    let own_torques = torques.is_some();
    let torques = task.torques(torques, true)?;
    let at = Origin::Question(Given::Map);
    let links = [task.link(&ranges[0].0, at)?, task.link(&ranges[1].0, at)?];
    let places = SpeedMap { task, ranges, links, torques, own_torques };
    let [(_, first), (_, second)] = &places.ranges;
    for one in first.ends() {
        for other in second.ends() {
            places.state([one, other])?;
        }
    }
    Ok(places)
}

/// Map whose entries are computed when they are requested.
#[derive(Debug)]
pub struct SpeedMap<'a> {
    task: Task<'a>,
    ranges: [(String, MapPlaces); 2],
    links: [LinkId; 2],
    torques: Vec<(LinkId, Torque)>,
    /// Whether the torques come from the question and not from the file.
    own_torques: bool,
}

impl SpeedMap<'_> {
    /// Number of entries: one for each link at each place.
    #[must_use]
    pub fn count(&self) -> usize {
        let [(_, first), (_, second)] = &self.ranges;
        first.count() * second.count() * self.link_count()
    }

    /// Entries for every link at every place of the map, row by row.
    pub fn entries(&self) -> impl Iterator<Item = Result<MapEntry, Error>> + '_ {
        let [(_, first), (_, second)] = &self.ranges;
        let places = first.values().flat_map(move |one| second.values().map(move |other| [one, other]));
        places.flat_map(move |speeds| {
            let (entries, fault): (Vec<MapEntry>, Option<Error>) = match self.state(speeds) {
                Ok(state) => {
                    ((1..=self.link_count()).map(|link| self.entry(speeds, link, &state)).collect(), None)
                }
                Err(why) => (vec![], Some(why)),
            };
            entries.into_iter().map(Ok).chain(fault.map(Err))
        })
    }

    /// Computes the map with all of its entries.
    ///
    /// # Errors
    /// The error of the first place that is refused.
    pub fn answer(&self) -> Result<Map, Error> {
        Ok(self.with(self.entries().collect::<Result<_, _>>()?))
    }

    /// Map with entries that are computed, and checked to be finite, while they are written.
    #[must_use]
    pub fn streamed(&self) -> Map<Streamed<'_>> {
        self.with(Streamed(self))
    }

    fn with<Entries>(&self, map: Entries) -> Map<Entries> {
        let Task { gearbox, gear, subject } = &self.task;
        let given = |(link, torque): &(LinkId, Torque)| GivenTorque {
            link: gearbox.link_name(*link).to_owned(),
            torque_n_m: torque.si(),
        };
        let mut warnings = warnings::of_gearbox(subject);
        Map {
            judgement: Judgement::added_to(&mut warnings, subject),
            gearbox: gearbox.name().to_owned(),
            gear: gear.name().to_owned(),
            first_link: self.ranges[0].0.clone(),
            second_link: self.ranges[1].0.clone(),
            torques: self.torques.iter().map(given).collect(),
            map,
            warnings,
        }
    }

    fn link_count(&self) -> usize {
        self.task.gearbox.links().len() - 1
    }

    fn state(&self, speeds: [AngularVelocity; 2]) -> Result<MultiState, Error> {
        let at = Origin::Question(Given::Map);
        let given = [(self.links[0], speeds[0]), (self.links[1], speeds[1])];
        match self.task.state(&given, &self.torques, at, self.own_torques) {
            // If the losses hold the gear, there are speeds only.
            Err(Error::Inputs { fault: InputsFault::SelfLocking, .. }) => {
                self.task.state(&given, &[], at, self.own_torques)
            }
            found => found,
        }
    }

    fn entry(&self, speeds: [AngularVelocity; 2], link: usize, state: &MultiState) -> MapEntry {
        let load = state.load.as_ref();
        let end = load.and_then(|load| load.terminals.iter().find(|end| end.link.index() == link));
        MapEntry {
            first_speed_rad_s: speeds[0].si(),
            second_speed_rad_s: speeds[1].si(),
            link: self.task.gearbox.links()[link].clone(),
            speed_rad_s: state.speeds[link].map(Physical::si),
            torque_n_m: end.map(|end| end.torque.si()),
            power_w: load.and_then(|load| load.power.links[link]),
            efficiency: load.and_then(|load| load.efficiency),
        }
    }
}

/// Entries of a map, computed while they are written.
pub struct Streamed<'a>(&'a SpeedMap<'a>);

impl Serialize for Streamed<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut list = serializer.serialize_seq(Some(self.0.count()))?;
        for entry in self.0.entries() {
            let entry = entry.map_err(S::Error::custom)?;
            finite::check(&entry).map_err(S::Error::custom)?;
            list.serialize_element(&entry)?;
        }
        list.end()
    }
}

impl JsonSchema for Streamed<'_> {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        Vec::<MapEntry>::schema_name()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        Vec::<MapEntry>::json_schema(generator)
    }
}
