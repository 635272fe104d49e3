//! Shafts, converters and dog clutches, as a scenario states them.

use super::torques::ResistingEntry;
use epicyclic_units::TorsionalStiffness;
use epicyclic_units::{Number, Quantity};
use schemars::JsonSchema;
use serde::Deserialize;
use uom::si::f64::{Angle, AngularVelocity, Time, Torque};

/// An elastic shaft between two links, bodies or the housing.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ShaftEntry {
    /// Name of the shaft.
    pub id: String,
    /// Links that the shaft joins; its torque is positive where the first drives the second forward.
    pub links: [String; 2],
    /// Torsional stiffness, above 0.
    pub stiffness: Quantity<TorsionalStiffness>,
    /// Torque of its damper at a speed of the first end relative to the second. Default 0.
    #[serde(default)]
    pub damping: Option<ResistingEntry>,
    /// Twist from contact on one side to contact on the other. Default 0.
    #[serde(default)]
    pub backlash: Option<Quantity<Angle>>,
    /// Twist at the start, 0 in the middle of the backlash. Default 0.
    #[serde(default)]
    pub twist: Option<Quantity<Angle>>,
}

/// A torque converter between two links or bodies; its reactor stands on the housing.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ConverterEntry {
    /// Name of the converter.
    pub id: String,
    /// Impeller and turbine.
    pub links: [String; 2],
    /// Speeds of the turbine over that of the impeller, ascending.
    pub speed_ratios: Vec<Number>,
    /// The torque of the turbine over that of the impeller at each.
    pub torque_ratios: Vec<Number>,
    /// The torque that the impeller takes at each, at `impeller_speed`; it goes with the square of the speed.
    pub impeller_torques: Vec<Quantity<Torque>>,
    /// The speed at which these torques were measured, above 0.
    pub impeller_speed: Quantity<AngularVelocity>,
}

/// When a dog clutch engages and is released; open before.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DogEntry {
    /// Times from which it shall be engaged.
    pub engage: Vec<Quantity<Time>>,
    /// Times from which it shall be open. Default none.
    #[serde(default)]
    pub release: Vec<Quantity<Time>>,
    /// Greatest difference of the speeds of its links at which it engages. Default: at any difference.
    #[serde(default)]
    pub largest_slip: Option<Quantity<AngularVelocity>>,
}
