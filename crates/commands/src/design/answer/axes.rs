//! Axes of the shafts of stages in series: one axis, or the fast one parallel to the slow one.

use crate::shared::application::Application;
use epicyclic_strength::series::FirstPair;
use epicyclic_strength::sizing::Sizing;
use std::ops::RangeInclusive;

/// Axes of input and output.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum Axes {
    /// One axis: planetary stages alone
    Coaxial,
    /// Parallel axes: the fast stage is a pair of external gears, after which the output turns against the input
    Parallel,
    /// Either, whichever is lighter
    Either,
}

/// Teeth of the smaller and of the larger gear of a pair.
const PINIONS: RangeInclusive<u32> = 17..=30;
const WHEELS: RangeInclusive<u32> = 20..=150;

/// Larger over smaller gear.
const RATIOS: RangeInclusive<f64> = 1.1..=5.0;

/// Part of a set's loss that its outer mesh has, which is as that of a pair.
const OF_OUTER_MESH: f64 = 2.0 / 3.0;

impl Axes {
    /// Usual axes: one; of wind turbines either, since generators are beside the axis of the rotor as well.
    pub(crate) fn usual(application: Option<Application>) -> Self {
        if application == Some(Application::Wind) { Self::Either } else { Self::Coaxial }
    }
}

/// Pairs to choose from.
pub(super) const fn first_pair(of_pair: Sizing) -> FirstPair {
    FirstPair { pinions: PINIONS, wheels: WHEELS, ratio: RATIOS, of_pair }
}

/// Least and greatest ratio of pairs.
pub(super) const fn ratios() -> [f64; 2] {
    [*RATIOS.start(), *RATIOS.end()]
}

/// Efficiency of a pair, by that of a set with its carrier held.
pub(super) fn efficiency_of_pair(of_set: f64) -> f64 {
    1.0 - OF_OUTER_MESH * (1.0 - of_set)
}
