//! Keys of a gearbox file for the data sheets of its gears.

use super::PerGear;
use epicyclic_units::Quantity;
use schemars::JsonSchema;
use serde::Deserialize;
use uom::si::f64::Length;

/// How the gears of a set are measured, and what may be off. Values of gears are lists in their order (sun,
/// planets, ring), or by the names of gears.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DataSheetEntry {
    /// Diameters of the balls or pins over which gears are measured. Default: those that
    /// touch the flanks at `d + 2·x·m`, rounded up to two digits.
    #[serde(default)]
    pub ball_diameters: Option<PerGear<Quantity<Length>>>,
    /// Lower and upper allowance of the normal tooth thickness at the reference circle, below 0 of thinner
    /// teeth.
    #[serde(default)]
    pub thickness_allowances: Option<PerGear<[Quantity<Length>; 2]>>,
    /// Lower and upper deviation of the centre distance. Default 0.
    #[serde(default)]
    pub centre_distance_deviations: Option<[Quantity<Length>; 2]>,
}
