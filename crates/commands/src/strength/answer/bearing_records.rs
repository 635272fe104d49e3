//! Records of planet bearings over a duty.

use crate::answer::Warning;
use epicyclic_units::Physical;
use epicyclic_units::format::trimmed;
use schemars::JsonSchema;
use serde::Serialize;
use uom::si::f64::Time;

/// Significant digits of a life in a warning.
const LIFE_DIGITS: usize = 4;

/// Bearing of a planet over the duty.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct BearingOverDuty {
    /// Name of the set.
    pub set: String,
    /// Name of the planet, or its number in the set.
    pub planet: String,
    /// Kind of the bearing: balls, rollers, needles, `full_complement`, plain.
    pub rolling: &'static str,
    /// Basic dynamic load rating in N; of a plain bearing the load that it may bear.
    pub load_rating_n: f64,
    /// Mean diameter of the bearing in m; null if not given.
    pub mean_diameter_m: Option<f64>,
    /// Mesh load factor `K_γ`, by which the mesh forces are multiplied; null if it is not given and its table
    /// does not contain the number of planets.
    pub load_sharing: Option<f64>,
    /// Whether the file gives `K_γ`; otherwise it follows from the number of planets and whether a member
    /// floats.
    pub load_sharing_is_given: bool,
    /// Distance of both rows in m; null if not given: then forces and lives leave the tilting moment out.
    pub span_m: Option<f64>,
    /// Greatest force of the duty and the overloads, in N; null if no forces can be computed.
    pub greatest_force_n: Option<f64>,
    /// Greatest force of the duty and the overloads on one row, in N; null without a span.
    pub greatest_row_force_n: Option<f64>,
    /// Static safety: static load rating over the greatest force, with a span over twice that of a row; null
    /// without that rating.
    pub static_safety: Option<f64>,
    /// Basic rating life over the duty in s, which 90 % of the bearings reach; null of a plain bearing and if the
    /// bearing never turns under load.
    pub basic_life_s: Option<f64>,
    /// Greatest load of the duty over diameter and width of a plain bearing, in Pa; null of other bearings, and without
    /// `bearing_diameter` and `face_width`.
    pub pressure_pa: Option<f64>,
    /// Oil film of a plain bearing over the least one that keeps mixed friction away, in the step with the
    /// thinnest; null of other bearings, without `bearing_diameter` and `face_width`, and if it never turns under
    /// load.
    pub film_ratio: Option<f64>,
    /// Modified rating life over the duty; null if it is not asked for or cannot be computed.
    pub modified: Option<ModifiedLife>,
    /// Forces and speeds in the steps of the duty.
    pub steps: Vec<BearingStepFigures>,
    /// Data missing for the forces or the modified life, or reasons why it cannot be computed.
    pub missing: Vec<String>,
}

/// Modified rating life of a bearing over the duty.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ModifiedLife {
    /// Part of the bearings that reach the life.
    pub reliability: f64,
    /// Reliability factor `a_1`.
    pub reliability_factor: f64,
    /// Modified rating life in s; null if the bearing never turns under load.
    pub life_s: Option<f64>,
}

/// Bearing in a step of the duty.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct BearingStepFigures {
    /// Name of the gear.
    pub gear: String,
    /// Radial force on the bearing in N.
    pub force_n: f64,
    /// Axial forces of all meshes on the planet together, in N; null without a span. No life contains it.
    pub axial_force_n: Option<f64>,
    /// Moment of the axial forces that tilts the planet, in N·m; null without a span.
    pub tilting_moment_n_m: Option<f64>,
    /// Radial forces on both rows in N, that at the end of the positive direction first; null without a
    /// span.
    pub row_forces_n: Option<[f64; 2]>,
    /// Equivalent load of both rows in N, from which the life follows; without a span the radial force.
    pub equivalent_load_n: f64,
    /// Absolute planet speed relative to the carrier, in rad/s.
    pub speed_rad_s: f64,
    /// Viscosity ratio `κ`; null without a modified life, or if the bearing does not turn under load.
    pub viscosity_ratio: Option<f64>,
    /// Life modification factor `a_ISO`; null without a modified life, or if the bearing does not turn under
    /// load.
    pub modification: Option<f64>,
}

impl BearingOverDuty {
    /// Modified life in s if it is known, otherwise the basic one.
    #[must_use]
    pub fn life_s(&self) -> Option<f64> {
        self.modified.map_or(self.basic_life_s, |modified| modified.life_s)
    }

    /// Warning that the bearing does not reach the required life.
    pub(super) fn warning(&self, required: Time) -> Option<Warning> {
        let life = Time::from_si(self.life_s()?);
        if life >= required {
            return None;
        }
        let [life, required] = [life, required].map(|time| trimmed(time.hours(), LIFE_DIGITS));
        let which = if self.modified.is_some() { "modified " } else { "" };
        let message = format!(
            "the planet bearings of set {} ({}) have a {which}life of {life} h over the duty, below the {required} h required",
            self.set, self.planet
        );
        Some(Warning { name: "bearing-life", message })
    }
}
