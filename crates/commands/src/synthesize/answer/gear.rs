//! A gear that is wanted.

use epicyclic_synthesis::parts::Bounds;
use schemars::JsonSchema;
use serde::Serialize;

/// A gear that is wanted.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct WantedGear {
    /// Its ratio, input speed over output speed; none where any ratio within the bounds will do.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub wanted_ratio: Option<f64>,
    /// The lower bound of its ratio.
    pub least_ratio: f64,
    /// The upper bound of its ratio.
    pub greatest_ratio: f64,
    /// Whether it may be missing.
    pub may_be_missing: bool,
}

impl WantedGear {
    /// Its bounds.
    #[must_use]
    pub fn bounds(&self) -> Bounds {
        Bounds { least: self.least_ratio, most: self.greatest_ratio }
    }

    /// Whether a ratio is within its bounds, up to the rounding of a quotient.
    pub(super) fn holds(&self, ratio: f64) -> bool {
        let rounding = 4.0 * f64::EPSILON * ratio.abs();
        (self.least_ratio - rounding..=self.greatest_ratio + rounding).contains(&ratio)
    }
}
