//! Shafts and converters: into the model, and what they carried.

use super::parts::Scenario;
use super::{ABOVE_0, placed, refused, root};
use crate::error::Error;
use crate::shared::fault::Named;
use epicyclic_formats::Path;
use epicyclic_formats::scenario::{ConverterEntry, ShaftEntry};
use epicyclic_motion::{self as motion, Converter, Model, Run, Sample, Shaft};
use epicyclic_units::{Number, Physical};
use schemars::JsonSchema;
use serde::Serialize;
use uom::si::f64::Angle;

/// What an elastic shaft carried.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ShaftResult {
    /// Its name.
    pub id: String,
    /// What it joins.
    pub links: [String; 2],
    /// Greatest torque, in size.
    pub peak_torque_n_m: f64,
    /// Greatest twist from the middle of its backlash, in size.
    pub peak_twist_rad: f64,
    /// Torque at the end, positive where the first link drives the second forward.
    pub end_torque_n_m: f64,
    /// Twist at the end.
    pub end_twist_rad: f64,
    /// Heat of its damper.
    pub heat_j: f64,
}

/// What a converter carried.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ConverterResult {
    /// Its name.
    pub id: String,
    /// Impeller and turbine.
    pub links: [String; 2],
    /// Greatest torque on the turbine, in size.
    pub peak_torque_n_m: f64,
    /// Greatest power that its oil takes.
    pub peak_heat_flow_w: f64,
    /// Torque on the turbine at the end.
    pub end_torque_n_m: f64,
    /// Speed of the turbine over that of the impeller at the end; `null` with the impeller at rest.
    pub end_speed_ratio: Option<f64>,
    /// Heat of its oil.
    pub heat_j: f64,
}

/// A shaft over time.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ShaftSamples {
    /// Its name.
    pub id: String,
    /// Torque that it passes on from its first link to its second.
    pub torques_n_m: Vec<f64>,
    /// Its twist.
    pub twists_rad: Vec<f64>,
}

/// A converter over time.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ConverterSamples {
    /// Its name.
    pub id: String,
    /// Torque that the impeller takes.
    pub impeller_torques_n_m: Vec<f64>,
    /// Torque that the turbine gives.
    pub turbine_torques_n_m: Vec<f64>,
}

impl Scenario<'_> {
    pub(super) fn add_shaft(&self, model: &mut Model, place: usize, entry: &ShaftEntry) -> Result<(), Error> {
        let path = root("shafts").index(place);
        let at = |key: &str, why| placed(self.document, &path.clone().key(key), why);
        let shaft = Shaft::new(entry.stiffness.0.per_radian(), Angle::from_si(1.0));
        let mut shaft = shaft.map_err(|why| at("stiffness", why))?;
        if let Some(damping) = &entry.damping {
            shaft = shaft.damping(damping.torque.0, damping.at.0).map_err(|why| at("damping", why))?;
        }
        if let Some(play) = entry.backlash {
            shaft = shaft.backlash(play.0).map_err(|why| at("backlash", why))?;
        }
        let links = entry.links.each_ref().map(String::as_str);
        model.shaft(&entry.id, links, shaft).map_err(|why| self.of_joint(path, why))
    }

    pub(super) fn add_converter(
        &self,
        model: &mut Model,
        place: usize,
        entry: &ConverterEntry,
    ) -> Result<(), Error> {
        let path = root("converters").index(place);
        let points = entry.speed_ratios.len();
        for (key, found) in
            [("torque_ratios", entry.torque_ratios.len()), ("impeller_torques", entry.impeller_torques.len())]
        {
            if found != points {
                let message = format!("{found} values at {points} speed_ratios: each has one");
                return Err(refused(self.document, &path.key(key), &Named("table", message)));
            }
        }
        let speed = entry.impeller_speed.0.si();
        if speed <= 0.0 {
            return Err(refused(self.document, &path.key("impeller_speed"), &ABOVE_0));
        }
        let torques = entry.torque_ratios.iter().map(|ratio| Number::get(*ratio));
        let capacities = entry.impeller_torques.iter().map(|torque| torque.0.si() / (speed * speed));
        let ratios = entry.speed_ratios.iter().map(|ratio| Number::get(*ratio));
        let points: Vec<[f64; 3]> = ratios
            .zip(torques)
            .zip(capacities)
            .map(|((ratio, torque), capacity)| [ratio, torque, capacity])
            .collect();
        let converter = Converter::new(&points).map_err(|why| placed(self.document, &path, why))?;
        let links = entry.links.each_ref().map(String::as_str);
        model.converter(&entry.id, links, converter).map_err(|why| self.of_joint(path, why))
    }

    fn of_joint(&self, path: Path, why: motion::Error) -> Error {
        let key = if matches!(why, motion::Error::Duplicate { .. }) { "id" } else { "links" };
        placed(self.document, &path.key(key), why)
    }
}

fn most(instants: &[&Sample], of: impl Fn(&Sample) -> f64) -> f64 {
    instants.iter().map(|sample| of(sample).abs()).fold(0.0, f64::max)
}

pub(super) fn shafts(entries: &[ShaftEntry], run: &Run, instants: &[&Sample]) -> Vec<ShaftResult> {
    let end = run.end();
    let of = |(place, entry): (usize, &ShaftEntry)| ShaftResult {
        id: entry.id.clone(),
        links: entry.links.clone(),
        peak_torque_n_m: most(instants, |sample| sample.shafts[place].si()),
        peak_twist_rad: most(instants, |sample| sample.twists[place].si()),
        end_torque_n_m: end.shafts[place].si(),
        end_twist_rad: end.twists[place].si(),
        heat_j: run.audit.damping[place].si(),
    };
    entries.iter().enumerate().map(of).collect()
}

pub(super) fn converters(
    entries: &[ConverterEntry],
    run: &Run,
    instants: &[&Sample],
) -> Vec<ConverterResult> {
    let speeds = |entry: &ConverterEntry, sample: &Sample| {
        entry.links.each_ref().map(|link| run.link(link).map_or(0.0, |place| sample.speeds[place].si()))
    };
    let of = |(place, entry): (usize, &ConverterEntry)| {
        // What acts on the links takes this power from them.
        let heat_flow = |sample: &Sample| {
            let [impeller, turbine] = sample.converters[place].map(Physical::si);
            let [first, second] = speeds(entry, sample);
            -(impeller * first + turbine * second)
        };
        let [impeller, turbine] = speeds(entry, run.end());
        ConverterResult {
            id: entry.id.clone(),
            links: entry.links.clone(),
            peak_torque_n_m: most(instants, |sample| sample.converters[place][1].si()),
            peak_heat_flow_w: most(instants, heat_flow),
            end_torque_n_m: run.end().converters[place][1].si(),
            end_speed_ratio: (impeller != 0.0).then(|| turbine / impeller),
            heat_j: run.audit.converters[place].si(),
        }
    };
    entries.iter().enumerate().map(of).collect()
}
