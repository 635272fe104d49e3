//! Gearboxes that are of use, and the others by the limit that they miss.

use super::kept::Kept;
use super::left_out::{LeftOut, LeftOuts, Reason};
use epicyclic_synthesis::usable::Usable;
use schemars::JsonSchema;
use serde::Serialize;

/// Limits of a gearbox that is of use, beside that it can be drawn.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct LimitsOfUse {
    /// The least efficiency of a forward gear.
    pub least_forward_efficiency: f64,
    /// The least efficiency of a reverse gear.
    pub least_reverse_efficiency: f64,
    /// The greatest circulating power of a forward gear over what enters.
    pub greatest_circulating_of_entering: f64,
}

/// By which limits of use how many gearboxes are of none.
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
