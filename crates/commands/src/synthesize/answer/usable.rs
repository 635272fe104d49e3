//! Usable gearboxes, and the limits that the others exceed.

use super::kept::Kept;
use super::left_out::{LeftOut, LeftOuts, Reason};
use epicyclic_synthesis::usable::Usable;
use schemars::JsonSchema;
use serde::Serialize;

/// Limits of a usable gearbox, which must also be drawable.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct LimitsOfUse {
    /// Minimum efficiency of a forward gear.
    pub least_forward_efficiency: f64,
    /// Minimum efficiency of a reverse gear.
    pub least_reverse_efficiency: f64,
    /// Maximum circulating power of a forward gear relative to the entering power.
    pub greatest_circulating_of_entering: f64,
}

/// Numbers of gearboxes that are not usable, by the limit that they exceed.
pub(super) fn faults(kept: &[Kept]) -> Vec<LeftOut> {
    let mut all = LeftOuts::default();
    kept.iter().filter_map(|one| one.fault).for_each(|fault| all.add(Reason::of_fault(fault), 1));
    all.told()
}

impl LimitsOfUse {
    pub(super) const fn of(usable: Usable) -> Self {
        Self {
            least_forward_efficiency: usable.forward,
            least_reverse_efficiency: usable.reverse,
            greatest_circulating_of_entering: usable.circulation,
        }
    }
}
