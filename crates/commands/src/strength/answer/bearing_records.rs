//! Records of planet bearings over a duty.

use crate::answer::Warning;
use epicyclic_units::Physical;
use epicyclic_units::format::trimmed;
use schemars::JsonSchema;
use serde::Serialize;
use uom::si::f64::Time;

/// Digits of a life in a warning.
const LIFE_DIGITS: usize = 4;

/// The bearing of a planet over the duty.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct BearingOverDuty {
    /// The set.
    pub set: String,
    /// The planet: its name, or its number in the set.
    pub planet: String,
    /// Whether rollers roll in it, or balls.
    pub rollers: bool,
    /// Basic dynamic load rating.
    pub load_rating_n: f64,
    /// `K_γ`, with which the forces of the meshes are multiplied; `null` where it is not given and its table
    /// has not so many planets.
    pub load_sharing: Option<f64>,
    /// Whether the file gives it; else it follows from the number of planets and whether a member floats.
    pub load_sharing_is_given: bool,
    /// The greatest force of the duty and the overloads; `null` where no forces follow.
    pub greatest_force_n: Option<f64>,
    /// Static safety: static load rating over the greatest force; `null` without that rating.
    pub static_safety: Option<f64>,
    /// Basic rating life over the duty, which 90 % of the bearings reach; `null` where it never turns under
    /// load.
    pub basic_life_s: Option<f64>,
    /// Modified rating life over the duty; `null` where it is not asked or does not follow.
    pub modified: Option<ModifiedLife>,
    /// Forces and speeds in the steps of the duty.
    pub steps: Vec<BearingStepFigures>,
    /// What is missing for the forces or the modified life, or why it does not follow.
    pub missing: Vec<String>,
}

/// The modified rating life of a bearing over the duty.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ModifiedLife {
    /// Part of the bearings that reach it.
    pub reliability: f64,
    /// `a_1`.
    pub reliability_factor: f64,
    /// The life; `null` where the bearing never turns under load.
    pub life_s: Option<f64>,
}

/// A bearing in a step of the duty.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct BearingStepFigures {
    /// The gear.
    pub gear: String,
    /// Force on the bearing.
    pub force_n: f64,
    /// Speed of the planet relative to the carrier, without its sign.
    pub speed_rad_s: f64,
    /// `κ`; `null` without a modified life, and where it does not turn under load.
    pub viscosity_ratio: Option<f64>,
    /// `a_ISO`; `null` as `κ`.
    pub modification: Option<f64>,
}

impl BearingOverDuty {
    /// The modified life where it follows, else the basic one.
    #[must_use]
    pub fn life_s(&self) -> Option<f64> {
        self.modified.map_or(self.basic_life_s, |modified| modified.life_s)
    }

    /// That it does not last.
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
