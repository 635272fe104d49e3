//! Speeds and torques over time, as lists.

use super::drags::{self, DragSamples};
use super::elements::{slip, temperature_rises};
use super::joints::{ConverterSamples, ShaftSamples};
use super::parts::Built;
use epicyclic_motion::{Run, Sample};
use epicyclic_units::Physical;
use schemars::JsonSchema;
use serde::Serialize;
use uom::si::f64::AngularVelocity;

/// Speeds and torques over time; all lists have the length of `times_s`.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Samples {
    /// Times in s: the start, equally spaced ones, the end.
    pub times_s: Vec<f64>,
    /// Samples of the links.
    pub links: Vec<LinkSamples>,
    /// Samples of the torques.
    pub torques: Vec<TorqueSamples>,
    /// Samples of the shift elements and resistances.
    pub elements: Vec<ElementSamples>,
    /// Samples of the shafts.
    pub shafts: Vec<ShaftSamples>,
    /// Samples of the converters.
    pub converters: Vec<ConverterSamples>,
    /// Samples of the drags.
    pub drags: Vec<DragSamples>,
    /// Torques that sets and shift elements exert on the output, in N·m.
    pub output_torques_n_m: Vec<f64>,
}

/// Link over time.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct LinkSamples {
    /// Name of the link.
    pub link: String,
    /// Speeds of the link in rad/s.
    pub speeds_rad_s: Vec<f64>,
}

/// Torque over time.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct TorqueSamples {
    /// Name of the torque.
    pub id: String,
    /// Torques in N·m.
    pub torques_n_m: Vec<f64>,
}

/// Element over time.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ElementSamples {
    /// Name of the element.
    pub id: String,
    /// Slips in rad/s: speed of the first link minus speed of the second.
    pub slips_rad_s: Vec<f64>,
    /// Torques on the first link in N·m, without drags.
    pub torques_n_m: Vec<f64>,
    /// Torque capacities while slipping, in N·m; null for one-way and dog clutches.
    pub capacities_n_m: Option<Vec<f64>>,
    /// Heat since the start in J.
    pub heats_j: Vec<f64>,
    /// Temperatures above the oil in K; null without a heat capacity.
    pub temperature_rises_k: Option<Vec<f64>>,
}

/// Selects one of every `kept` samples of a run, and the last one.
pub(super) fn of(built: &Built, run: &Run, instants: &[&Sample], kept: usize) -> Samples {
    let last = run.samples.len() - 1;
    let places: Vec<usize> = (0..last).step_by(kept).chain([last]).collect();
    let samples: Vec<&Sample> = places.iter().map(|&place| &run.samples[place]).collect();
    let list = |of: &dyn Fn(&Sample) -> f64| samples.iter().map(|sample| of(sample)).collect::<Vec<f64>>();
    let links = run.links.iter().enumerate().skip(1).map(|(place, link)| LinkSamples {
        link: link.clone(),
        speeds_rad_s: list(&|sample| sample.speeds[place].si()),
    });
    let torques = run.torques.iter().enumerate().map(|(place, id)| TorqueSamples {
        id: id.clone(),
        torques_n_m: list(&|sample| sample.torques[place].si()),
    });
    let elements = run.elements.iter().enumerate().filter_map(|(place, id)| {
        let element = built.elements.iter().find(|one| one.id == *id)?;
        let rises = temperature_rises(element, place, instants);
        // The list of temperatures has one value per instant, so samples are matched by their place among the
        // instants.
        let at = |rises: &[f64]| {
            let mut rises = instants.iter().zip(rises);
            let mut found = vec![];
            for &sample in &samples {
                found.extend(rises.find(|(one, _)| std::ptr::eq(**one, sample)).map(|(_, rise)| *rise));
            }
            found
        };
        Some(ElementSamples {
            id: id.clone(),
            slips_rad_s: list(&|sample| slip(run, element, sample)),
            torques_n_m: list(&|sample| sample.elements[place].si()),
            capacities_n_m: element.capacity.as_ref().map(|course| {
                let factor = |sample: &Sample| {
                    built.model.friction_factor(id, AngularVelocity::from_si(slip(run, element, sample)))
                };
                list(&|sample| factor(sample) * course.at(sample.time).si())
            }),
            heats_j: list(&|sample| sample.heats[place].si()),
            temperature_rises_k: rises.as_deref().map(at),
        })
    });
    let shafts = run.shafts.iter().enumerate().map(|(place, id)| ShaftSamples {
        id: id.clone(),
        torques_n_m: list(&|sample| sample.shafts[place].si()),
        twists_rad: list(&|sample| sample.twists[place].si()),
    });
    let converters = run.converters.iter().enumerate().map(|(place, id)| ConverterSamples {
        id: id.clone(),
        impeller_torques_n_m: list(&|sample| -sample.converters[place][0].si()),
        turbine_torques_n_m: list(&|sample| sample.converters[place][1].si()),
    });
    Samples {
        drags: drags::samples(&built.drags, run, &samples),
        shafts: shafts.collect(),
        converters: converters.collect(),
        times_s: list(&|sample| sample.time.si()),
        links: links.collect(),
        torques: torques.collect(),
        elements: elements.collect(),
        output_torques_n_m: list(&|sample| built.output.torque(sample)),
    }
}
