//! Torques on links, as a scenario states them.

use super::tables::{Column, Points, TableFault};
use epicyclic_units::{Number, Quantity};
use schemars::JsonSchema;
use serde::Deserialize;
use uom::si::f64::{Angle, AngularVelocity, Frequency, Power, Time, Torque};

/// A torque on a link, positive along the axis, by one of its laws.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TorqueEntry {
    /// Name of the torque.
    pub id: String,
    /// The link.
    pub link: String,
    /// Always the same.
    #[serde(default)]
    pub constant: Option<Quantity<Torque>>,
    /// A table over time.
    #[serde(default)]
    pub over_time: Option<OverTimeEntry>,
    /// A table over the speed of the link.
    #[serde(default)]
    pub over_speed: Option<OverSpeedEntry>,
    /// `M_0·(1 − ω/ω_0)`.
    #[serde(default)]
    pub linear: Option<LinearEntry>,
    /// Against the speed and proportional to it.
    #[serde(default)]
    pub viscous: Option<ResistingEntry>,
    /// Against the speed and proportional to its square.
    #[serde(default)]
    pub quadratic: Option<ResistingEntry>,
    /// An induction motor by Kloss' formula.
    #[serde(default)]
    pub kloss: Option<KlossEntry>,
    /// `mean + amplitude·sin(2π·f·t + φ)`.
    #[serde(default)]
    pub harmonic: Option<HarmonicEntry>,
    /// Constant power at every speed, up to a torque.
    #[serde(default)]
    pub constant_power: Option<ConstantPowerEntry>,
    /// An engine by its throttle over time.
    #[serde(default)]
    pub throttle: Option<ThrottleEntry>,
    /// Of this size against the motion; it holds the link at rest while it can: rolling resistance, a tool in
    /// the ground.
    #[serde(default)]
    pub resistance: Option<Quantity<Torque>>,
}

/// A torque over time, linear between its points, level beyond them. Two points at one time are a jump.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct OverTimeEntry {
    /// Times, in order.
    #[serde(default)]
    pub times: Vec<Quantity<Time>>,
    /// The torque at each.
    #[serde(default)]
    pub torques: Vec<Quantity<Torque>>,
    /// In place of both: a CSV file, by its path from the folder of this file.
    #[serde(default)]
    pub csv: Option<String>,
}

/// A torque over the speed of its link, linear between its points, level beyond them.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct OverSpeedEntry {
    /// Speeds, ascending.
    #[serde(default)]
    pub speeds: Vec<Quantity<AngularVelocity>>,
    /// The torque at each.
    #[serde(default)]
    pub torques: Vec<Quantity<Torque>>,
    /// In place of both: a CSV file, by its path from the folder of this file.
    #[serde(default)]
    pub csv: Option<String>,
}

/// A torque that falls linearly with the speed, as of a shunt motor.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LinearEntry {
    /// The torque at rest, `M_0`.
    pub at_rest: Quantity<Torque>,
    /// The speed without torque, `ω_0`.
    pub no_load: Quantity<AngularVelocity>,
}

/// A torque against the motion by one of its points.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ResistingEntry {
    /// The torque, at least 0.
    pub torque: Quantity<Torque>,
    /// At this speed, above 0.
    pub at: Quantity<AngularVelocity>,
}

/// An induction motor.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct KlossEntry {
    /// Peak torque.
    pub peak: Quantity<Torque>,
    /// The slip at the peak torque, above 0.
    pub peak_slip: Number,
    /// The synchronous speed.
    pub synchronous: Quantity<AngularVelocity>,
}

/// A torque that swings.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HarmonicEntry {
    /// Mean. Default 0.
    #[serde(default)]
    pub mean: Option<Quantity<Torque>>,
    /// Amplitude.
    pub amplitude: Quantity<Torque>,
    /// Frequency, above 0.
    pub frequency: Quantity<Frequency>,
    /// Phase at time 0. Default 0.
    #[serde(default)]
    pub phase: Option<Quantity<Angle>>,
}

/// A torque `P/ω`, at most a limit; backwards the limit.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ConstantPowerEntry {
    /// The power; below 0 of a brake that recovers it.
    pub power: Quantity<Power>,
    /// The torque below the speed `P/M`, of the power's sign.
    pub limit: Quantity<Torque>,
}

/// `(1 − α)·M_closed(ω) + α·M_full(ω)` with the throttle `α` over time, linear between its points.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ThrottleEntry {
    /// Torque over speed with the throttle closed.
    pub closed: OverSpeedEntry,
    /// Torque with the throttle full open.
    pub full: OverSpeedEntry,
    /// Times, in order.
    pub times: Vec<Quantity<Time>>,
    /// The throttle at each, from 0 to 1.
    pub openings: Vec<Number>,
}

impl TorqueEntry {
    /// Keys of the laws, and whether each is given.
    #[must_use]
    pub fn laws(&self) -> [(&'static str, bool); 11] {
        [
            ("constant", self.constant.is_some()),
            ("over_time", self.over_time.is_some()),
            ("over_speed", self.over_speed.is_some()),
            ("linear", self.linear.is_some()),
            ("viscous", self.viscous.is_some()),
            ("quadratic", self.quadratic.is_some()),
            ("kloss", self.kloss.is_some()),
            ("harmonic", self.harmonic.is_some()),
            ("constant_power", self.constant_power.is_some()),
            ("throttle", self.throttle.is_some()),
            ("resistance", self.resistance.is_some()),
        ]
    }
}

impl OverTimeEntry {
    /// Points of the table.
    ///
    /// # Errors
    /// [`TableFault`]; a fault of the CSV file.
    pub fn points(&self, texts: &super::tables::Texts) -> Result<Points<Time, Torque>, TableFault> {
        Column::pair(("times", &self.times), ("torques", &self.torques), self.csv.as_deref(), texts)
    }
}

impl OverSpeedEntry {
    /// Points of the table.
    ///
    /// # Errors
    /// [`TableFault`]; a fault of the CSV file.
    pub fn points(
        &self,
        texts: &super::tables::Texts,
    ) -> Result<Points<AngularVelocity, Torque>, TableFault> {
        Column::pair(("speeds", &self.speeds), ("torques", &self.torques), self.csv.as_deref(), texts)
    }
}
