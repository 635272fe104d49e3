//! Required gear.

use epicyclic_synthesis::parts::Bounds;
use schemars::JsonSchema;
use serde::Serialize;

/// Required gear.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct WantedGear {
    /// Required ratio, input speed over output speed; absent if any ratio within the bounds is accepted.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub wanted_ratio: Option<f64>,
    /// Lower bound of the ratio.
    pub least_ratio: f64,
    /// Upper bound of the ratio.
    pub greatest_ratio: f64,
    /// Whether the gear is optional.
    pub may_be_missing: bool,
}

impl WantedGear {
    /// Bounds of the ratio.
    #[must_use]
    pub fn bounds(&self) -> Bounds {
        Bounds { least: self.least_ratio, most: self.greatest_ratio }
    }

    /// Whether a ratio is within the bounds, up to the rounding error of a quotient.
    pub(super) fn holds(&self, ratio: f64) -> bool {
        let rounding = 4.0 * f64::EPSILON * ratio.abs();
        (self.least_ratio - rounding..=self.greatest_ratio + rounding).contains(&ratio)
    }
}
