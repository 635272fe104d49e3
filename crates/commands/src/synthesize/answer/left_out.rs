//! Reasons that leave out solutions with all gears.

use epicyclic_synthesis::limits::Limit;
use epicyclic_synthesis::usable::Fault;
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;

/// Number of solutions left out for a reason.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct LeftOut {
    /// Reason; a solution counts for the first that applies.
    pub by: Reason,
    /// Number of solutions left out.
    pub solutions: u64,
}

/// Reasons that leave out solutions with all gears.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Reason {
    /// No choice of functions yields a direct gear.
    Direct,
    /// No choice of functions and engaged elements yields the single-transition shifts.
    Shifts,
    /// A link crosses another with any choice of equivalent elements.
    Drawable,
    /// Ratios of neighbouring free gears do not decrease.
    Order,
    /// A ratio step is out of its range.
    Steps,
    /// A ratio step is larger than the previous one.
    FallingSteps,
    /// The slip of an open element exceeds the limit.
    Slip,
    /// The speed of a link exceeds the limit.
    LinkSpeed,
    /// The speed of a planet relative to its carrier exceeds the limit.
    PlanetSpeed,
    /// The search was stopped before the solutions were evaluated.
    Unjudged,
    /// A forward gear has an efficiency below the limit.
    Efficiency,
    /// A reverse gear has an efficiency below the limit.
    ReverseEfficiency,
    /// The circulating power in a forward gear exceeds the limit.
    Circulation,
}

/// Numbers of solutions left out, by reason.
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
