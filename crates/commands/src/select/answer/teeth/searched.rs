//! Extent of a search over tooth numbers.

use crate::shared::tooth_checks::answer::TeethLeftOut;
use epicyclic_gears::involute::left_out::LeftOut;
use epicyclic_selection::search::Counts;
use schemars::JsonSchema;
use serde::Serialize;

/// Numbers of combinations, structures and designs that were searched.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Searched {
    /// Number of combinations of tooth numbers of a set.
    pub tooth_numbers: usize,
    /// Combinations left out because a tooth check fails, for one set only those near the required ratio;
    /// null if none is left out.
    pub left_out: Option<TeethLeftOut>,
    /// Number of structures, each counted once for every assignment of the ratios.
    pub structures: usize,
    /// Number of designs: combinations of tooth numbers (for two sets pairs of them) in all structures.
    pub designs: u128,
    /// Number of ring-to-sun ratios (for two sets pairs of them) that were fully computed.
    pub tried: u64,
    /// Number of these that meet every required criterion.
    pub accepted: u64,
}

impl Searched {
    pub(super) fn of(counts: Counts, left_out: Option<&LeftOut>) -> Self {
        Self {
            left_out: left_out.map(TeethLeftOut::of),
            tooth_numbers: counts.tooth_sets,
            structures: counts.patches,
            designs: counts.designs,
            tried: counts.tried,
            accepted: counts.feasible,
        }
    }
}
