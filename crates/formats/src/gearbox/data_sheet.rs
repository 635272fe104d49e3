//! Keys of a gearbox file for the data sheets of its gears.

use epicyclic_units::Quantity;
use schemars::JsonSchema;
use serde::Deserialize;
use uom::si::f64::Length;

/// How the gears of a simple set are measured, and what may be off.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DataSheetEntry {
    /// Diameters of the balls or pins over which sun, planets and ring are measured. Default: those that
    /// touch the flanks at `d + 2·x·m`, rounded up to two digits.
    #[serde(default)]
    pub ball_diameters: Option<[Quantity<Length>; 3]>,
    /// Lower and upper allowance of the normal tooth thickness at the reference circle of sun, planets and
    /// ring, below 0 of thinner teeth.
    #[serde(default)]
    pub thickness_allowances: Option<[[Quantity<Length>; 2]; 3]>,
    /// Lower and upper deviation of the centre distance. Default 0.
    #[serde(default)]
    pub centre_distance_deviations: Option<[Quantity<Length>; 2]>,
}
