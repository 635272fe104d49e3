//! The extent of a search over tooth numbers.

use crate::shared::tooth_checks::answer::TeethLeftOut;
use epicyclic_gears::involute::left_out::LeftOut;
use epicyclic_selection::search::Counts;
use schemars::JsonSchema;
use serde::Serialize;

/// Numbers of combinations, structures and designs that were searched.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Searched {
    /// Combinations of tooth numbers of a set.
    pub tooth_numbers: usize,
    /// Combinations that are left out since a check of their teeth does not hold, of one set only those near
    /// the wanted ratio; `null` if no combination is left out.
    pub left_out: Option<TeethLeftOut>,
    /// Structures, each counted once for every assignment of the ratios.
    pub structures: usize,
    /// Designs in all: combinations of tooth numbers, of two sets pairs of them, in all structures.
    pub designs: u128,
    /// Ring-to-sun ratios, of two sets pairs of them, tried in full.
    pub tried: u64,
    /// Of these, how many meet every required criterion.
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
