//! Shift elements and shifts, as a scenario states them.

use super::joints::DogEntry;
use super::tables::{Column, Points, TableFault, Texts};
use epicyclic_units::{Number, Quantity};
use schemars::JsonSchema;
use serde::Deserialize;
use uom::si::f64::{AngularVelocity, Area, HeatCapacity, Length, Pressure, ThermalConductance, Time, Torque};

/// A shift element that carries by friction or by dogs, and what it is made of. Its capacity has one of four
/// sources.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ElementEntry {
    /// Name of the element in the gearbox.
    pub id: String,
    /// Capacity while the element is engaged: in the gear at the start and in those that `shifts` change to.
    #[serde(default)]
    pub holding: Option<Quantity<Torque>>,
    /// Capacity over time.
    #[serde(default)]
    pub capacity: Option<CapacityEntry>,
    /// Pressure over time, from which the capacity follows.
    #[serde(default)]
    pub pressure: Option<PressureEntry>,
    /// Dog clutch, which engages by an impact and then carries any torque.
    #[serde(default)]
    pub dog: Option<DogEntry>,
    /// Friction over the speed of slip. Default: the same at any speed.
    #[serde(default)]
    pub friction_over_slip: Option<OverSlipEntry>,
    /// Static over kinetic friction, at least 1. Default 1.
    #[serde(default)]
    pub static_ratio: Option<Number>,
    /// Area of all friction surfaces together, for power and energy per area.
    #[serde(default)]
    pub friction_area: Option<Quantity<Area>>,
    /// Heat capacity of what takes its heat, for the temperature.
    #[serde(default)]
    pub heat_capacity: Option<Quantity<HeatCapacity>>,
    /// With `heat_capacity`: conductance to the oil. Default 0, adiabatic.
    #[serde(default)]
    pub conductance: Option<Quantity<ThermalConductance>>,
}

/// A capacity over time, linear between its points, level beyond them. Two points at one time are a jump.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CapacityEntry {
    /// Times, in order.
    #[serde(default)]
    pub times: Vec<Quantity<Time>>,
    /// The capacity at each, at least 0.
    #[serde(default)]
    pub torques: Vec<Quantity<Torque>>,
    /// In place of both: a CSV file, by its path from the folder of this file.
    #[serde(default)]
    pub csv: Option<String>,
}

/// A factor of the capacity over the speed of slip, linear between its points, level beyond them.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct OverSlipEntry {
    /// Speeds of slip, ascending, at least 0.
    pub speeds: Vec<Quantity<AngularVelocity>>,
    /// The factor at each, at least 0; that at 0 holds while it sticks, too.
    pub factors: Vec<Number>,
}

/// A pressure over time, and how a capacity follows: `μ·z·r_m·A·(p − p_kiss)`, 0 below the kiss point and
/// while the piston fills.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PressureEntry {
    /// Times, in order.
    #[serde(default)]
    pub times: Vec<Quantity<Time>>,
    /// The pressure at each, at least 0.
    #[serde(default)]
    pub pressures: Vec<Quantity<Pressure>>,
    /// In place of both: a CSV file, by its path from the folder of this file.
    #[serde(default)]
    pub csv: Option<String>,
    /// From the first time on the piston moves for so long and carries nothing. Default 0.
    #[serde(default)]
    pub fill_time: Option<Quantity<Time>>,
    /// Pressure at which the element begins to carry, `p_kiss`. Default 0.
    #[serde(default)]
    pub kiss_point: Option<Quantity<Pressure>>,
    /// Area of the piston, `A`.
    pub piston_area: Quantity<Area>,
    /// Mean radius of friction, `r_m`.
    pub mean_radius: Quantity<Length>,
    /// Number of friction surfaces, `z`.
    pub surfaces: u32,
    /// Coefficient of kinetic friction, `μ`.
    pub coefficient: Number,
}

/// A shift from the gear before to another. What it releases falls from its `holding` to 0, what it applies
/// rises from 0 to its `holding`, both linearly; the ramp that is first begins at `at`.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ShiftEntry {
    /// When it begins.
    pub at: Quantity<Time>,
    /// The gear that it changes to.
    pub to: String,
    /// How long the ramp of the released elements takes, above 0.
    pub release: Quantity<Time>,
    /// How long the ramp of the applied elements takes, above 0.
    pub apply: Quantity<Time>,
    /// From the beginning of the applied ramp to the end of the released one; below 0 there is a gap. Default
    /// 0.
    #[serde(default)]
    pub overlap: Option<Quantity<Time>>,
}

impl CapacityEntry {
    /// Points of the table.
    ///
    /// # Errors
    /// [`TableFault`]; a fault of the CSV file.
    pub fn points(&self, texts: &Texts) -> Result<Points<Time, Torque>, TableFault> {
        Column::pair(("times", &self.times), ("torques", &self.torques), self.csv.as_deref(), texts)
    }
}

impl PressureEntry {
    /// Points of the table.
    ///
    /// # Errors
    /// [`TableFault`]; a fault of the CSV file.
    pub fn points(&self, texts: &Texts) -> Result<Points<Time, Pressure>, TableFault> {
        Column::pair(("times", &self.times), ("pressures", &self.pressures), self.csv.as_deref(), texts)
    }
}
