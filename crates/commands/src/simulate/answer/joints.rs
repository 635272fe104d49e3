//! Shafts and converters: their place in the model, and their loads.

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

/// Loads of an elastic shaft.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ShaftResult {
    /// Name of the shaft.
    pub id: String,
    /// Names of the two links that the shaft joins.
    pub links: [String; 2],
    /// Greatest absolute torque in N·m.
    pub peak_torque_n_m: f64,
    /// Greatest absolute twist from the middle of the backlash, in rad.
    pub peak_twist_rad: f64,
    /// Torque at the end in N·m, positive if the first link drives the second forward.
    pub end_torque_n_m: f64,
    /// Twist at the end in rad.
    pub end_twist_rad: f64,
    /// Heat of the shaft's damper in J.
    pub heat_j: f64,
}

/// Loads of a torque converter.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ConverterResult {
    /// Name of the converter.
    pub id: String,
    /// Names of the links of impeller and turbine.
    pub links: [String; 2],
    /// Greatest absolute torque on the turbine in N·m.
    pub peak_torque_n_m: f64,
    /// Greatest heat flow into the oil in W.
    pub peak_heat_flow_w: f64,
    /// Torque on the turbine at the end, in N·m.
    pub end_torque_n_m: f64,
    /// Speed ratio at the end, turbine over impeller; null if the impeller is at rest.
    pub end_speed_ratio: Option<f64>,
    /// Heat of the oil in J.
    pub heat_j: f64,
}

/// Shaft over time.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ShaftSamples {
    /// Name of the shaft.
    pub id: String,
    /// Torques in N·m transmitted from the first link to the second.
    pub torques_n_m: Vec<f64>,
    /// Twists in rad.
    pub twists_rad: Vec<f64>,
}

/// Converter over time.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ConverterSamples {
    /// Name of the converter.
    pub id: String,
    /// Torques absorbed by the impeller, in N·m.
    pub impeller_torques_n_m: Vec<f64>,
    /// Torques delivered by the turbine, in N·m.
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
        // The torques of the converter take this power from the links.
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
