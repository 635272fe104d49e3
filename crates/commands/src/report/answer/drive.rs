//! The chapters of a planetary drive.

use crate::drive::answer::Drive;
use schemars::JsonSchema;
use serde::Serialize;

/// Places of the curve over the ratio, less one.
const STEPS: u32 = 100;
/// Where that curve begins at the latest, and over the drive's own ratio less 1.
const LEAST_RATIO: [f64; 2] = [2.2, 0.8];
/// Where it ends at the earliest, and over the drive's own ratio.
const GREATEST_RATIO: [f64; 2] = [10.0, 1.5];

/// A planetary drive, and what another ratio would change.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct DriveReport {
    /// The drive.
    pub drive: Drive,
    /// Its efficiency if its ratio were another, the efficiencies of its meshes the same.
    pub efficiency_over_ratio: EfficiencyOverRatio,
}

/// Efficiencies of drives over their ratios.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct EfficiencyOverRatio {
    /// Ratios, sun to carrier with the ring fixed, the drive's own among them, from the least.
    pub ratios: Vec<f64>,
    /// The efficiency at each.
    pub efficiencies: Vec<f64>,
}

impl DriveReport {
    /// The chapters of a drive.
    #[must_use]
    pub fn of(drive: Drive) -> Self {
        let efficiency_over_ratio = EfficiencyOverRatio::of(&drive);
        Self { drive, efficiency_over_ratio }
    }
}

impl EfficiencyOverRatio {
    /// `η = (1 + k·η₀)/(1 + k)` over `U = 1 + k`.
    fn of(drive: &Drive) -> Self {
        let basic = drive.efficiencies.basic;
        let [greatest, over_own] = GREATEST_RATIO;
        let own = drive.tooth_numbers.ratio;
        let greatest = (over_own * own).max(greatest);
        let [least, over_own] = LEAST_RATIO;
        let least = (1.0 + over_own * (own - 1.0)).min(least);
        let ratio = |i| least + (greatest - least) * f64::from(i) / f64::from(STEPS);
        let mut ratios: Vec<f64> = (0..=STEPS).map(ratio).collect();
        // The drive itself is on its curve.
        let place = ratios.partition_point(|ratio| *ratio < own);
        if ratios.get(place) != Some(&own) {
            ratios.insert(place, own);
        }
        let efficiencies = ratios.iter().map(|ratio| (1.0 + (ratio - 1.0) * basic) / ratio).collect();
        Self { ratios, efficiencies }
    }
}
