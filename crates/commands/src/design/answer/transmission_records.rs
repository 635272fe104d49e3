//! Records of gearboxes for lists of gears.

use super::ways_out::RelaxedLimit;
use crate::synthesize::answer::ShiftElement;
use crate::synthesize::answer::teeth::TeethOfSet;
use schemars::JsonSchema;
use serde::Serialize;

/// Gear, required and reached.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct GearReached {
    /// Name of the gear.
    pub gear: String,
    /// Required ratio, input speed over output speed.
    pub asked_ratio: f64,
    /// Reached ratio; null if no structure was found.
    pub ratio: Option<f64>,
    /// Required speed of the output in rad/s.
    pub asked_output_speed_rad_s: f64,
    /// Reached speed of the output in rad/s; null if no structure was found.
    pub output_speed_rad_s: Option<f64>,
    /// Engaged shift elements.
    pub engaged: Vec<String>,
    /// Efficiency with usual losses of the meshes; null without a structure, or if losses hold the gear.
    pub efficiency: Option<f64>,
}

/// Gearbox with tooth numbers.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct GearboxWithTeeth {
    /// Links of sun, ring and carrier of each set: 0 the housing, 1 the input, 2 the output, letters the
    /// others. A star marks a double-planet set.
    pub structure: String,
    /// Brakes and clutches.
    pub shift_elements: Vec<ShiftElement>,
    /// Shifts between neighbouring forward gears that exchange more than one shift element.
    pub multiple_shifts: usize,
    /// Least efficiency of a forward gear.
    pub forward_efficiency: f64,
    /// Tooth numbers of the sets.
    pub sets: Vec<TeethOfSet>,
    /// Largest relative deviation of a ratio.
    pub greatest_deviation: f64,
    /// Errors and warnings of the judge.
    pub warnings: usize,
    /// Mass of all gears in kg; null if a set has no size.
    pub mass_kg: Option<f64>,
    /// Outside diameter of the largest ring in m; null if a set has no size.
    pub ring_diameter_m: Option<f64>,
}

/// Gearbox for a list of gears under a limit of its rings.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct GearboxOfRing {
    /// Limit of the rings.
    pub limits: Vec<RelaxedLimit>,
    /// Links of sun, ring and carrier of each set, as of the gearboxes that were sized.
    pub structure: String,
    /// Tooth numbers of each set: sun, planet, ring; of a double-planet set both planets.
    pub teeth: Vec<Vec<u32>>,
    /// Largest relative deviation of a ratio.
    pub greatest_deviation: f64,
    /// Greatest outside diameter of a ring, in m.
    pub ring_diameter_m: f64,
    /// Mass of the whole in kg.
    pub whole_kg: Option<f64>,
    /// Errors and warnings of the judge.
    pub warnings: usize,
}
