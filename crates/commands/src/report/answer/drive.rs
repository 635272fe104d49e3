//! Chapters of a planetary drive.

use crate::drive::answer::Drive;
use schemars::JsonSchema;
use serde::Serialize;

/// Number of places of the curve over the ratio, minus one.
const STEPS: u32 = 100;
/// Start of the curve: at most this ratio, and at most this multiple of the drive's own ratio minus 1.
const LEAST_RATIO: [f64; 2] = [2.2, 0.8];
/// End of the curve: at least this ratio, and at least this multiple of the drive's own ratio.
const GREATEST_RATIO: [f64; 2] = [10.0, 1.5];

/// Planetary drive, and its efficiency at other ratios.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct DriveReport {
    /// Design of the drive.
    pub drive: Drive,
    /// Efficiency of the drive at other ratios, with equal mesh efficiencies.
    pub efficiency_over_ratio: EfficiencyOverRatio,
}

/// Efficiencies of drives over their ratios.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct EfficiencyOverRatio {
    /// Ratios in increasing order, sun speed over carrier speed with the ring fixed; the drive's own ratio is
    /// included.
    pub ratios: Vec<f64>,
    /// Efficiency at each ratio.
    pub efficiencies: Vec<f64>,
}

impl DriveReport {
    /// Chapters of a drive.
    #[must_use]
    pub fn of(drive: Drive) -> Self {
        let efficiency_over_ratio = EfficiencyOverRatio::of(&drive);
        Self { drive, efficiency_over_ratio }
    }
}

impl EfficiencyOverRatio {
    /// Efficiency `η = (1 + k·η₀)/(1 + k)` over `U = 1 + k`.
    fn of(drive: &Drive) -> Self {
        let basic = drive.efficiencies.basic;
        let [greatest, over_own] = GREATEST_RATIO;
        let own = drive.tooth_numbers.ratio;
        let greatest = (over_own * own).max(greatest);
        let [least, over_own] = LEAST_RATIO;
        let least = (1.0 + over_own * (own - 1.0)).min(least);
        let ratio = |i| least + (greatest - least) * f64::from(i) / f64::from(STEPS);
        let mut ratios: Vec<f64> = (0..=STEPS).map(ratio).collect();
        // The drive's own ratio is inserted, so that the drive lies on its curve.
        let place = ratios.partition_point(|ratio| *ratio < own);
        if ratios.get(place) != Some(&own) {
            ratios.insert(place, own);
        }
        let efficiencies = ratios.iter().map(|ratio| (1.0 + (ratio - 1.0) * basic) / ratio).collect();
        Self { ratios, efficiencies }
    }
}
