//! What leaves out solutions that have all gears.

use epicyclic_synthesis::limits::Limit;
use epicyclic_synthesis::usable::Fault;
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;

/// Solutions that something left out.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct LeftOut {
    /// What left them out; each is counted at the first.
    pub by: Reason,
    /// How many.
    pub solutions: u64,
}

/// What leaves out solutions that have all gears.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Reason {
    /// No choice of functions has a direct gear.
    Direct,
    /// No choice of functions and engaged elements has the single shifts.
    Shifts,
    /// A link would cross another, whichever of the elements that lock the same are taken.
    Drawable,
    /// Ratios of free gears side by side do not fall.
    Order,
    /// A ratio step is out of its range.
    Steps,
    /// A ratio step is larger than the one before it.
    FallingSteps,
    /// An open element slips faster.
    Slip,
    /// A link turns faster.
    LinkSpeed,
    /// A planet turns faster on its carrier.
    PlanetSpeed,
    /// The search was ended before they were judged.
    Unjudged,
    /// A forward gear has an efficiency below the limit.
    Efficiency,
    /// A reverse gear has an efficiency below the limit.
    ReverseEfficiency,
    /// More power circulates in a forward gear than the limit.
    Circulation,
}

/// Counts of what was left out.
#[derive(Default)]
pub(super) struct LeftOuts(BTreeMap<Reason, u64>);

impl LeftOuts {
    pub(super) fn add(&mut self, by: Reason, solutions: u64) {
        if solutions > 0 {
            *self.0.entry(by).or_default() += solutions;
        }
    }

    pub(super) fn has(&self, by: Reason) -> bool {
        self.0.contains_key(&by)
    }

    pub(super) fn are_none(&self) -> bool {
        self.0.is_empty()
    }

    pub(super) fn told(&self) -> Vec<LeftOut> {
        self.0.iter().map(|(by, solutions)| LeftOut { by: *by, solutions: *solutions }).collect()
    }
}

impl Reason {
    pub(super) const fn of_fault(fault: Fault) -> Self {
        match fault {
            Fault::NotDrawable => Self::Drawable,
            Fault::Forward => Self::Efficiency,
            Fault::Reverse => Self::ReverseEfficiency,
            Fault::Circulation => Self::Circulation,
        }
    }

    pub(super) fn of(limit: Limit) -> Self {
        match limit {
            Limit::Steps => Self::Steps,
            Limit::FallingSteps => Self::FallingSteps,
            Limit::Slip => Self::Slip,
            Limit::LinkSpeed => Self::LinkSpeed,
            Limit::PlanetSpeed => Self::PlanetSpeed,
        }
    }
}
