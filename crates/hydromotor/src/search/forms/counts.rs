//! Counts of some points of a search by their results.

use crate::reason::{Reason, Refusals};

/// Counts of some points by their results.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(super) struct Counts {
    pub(super) refused: Refusals,
    pub(super) as_good: u64,
    pub(super) admissible: u64,
}

impl Counts {
    pub(super) fn refuse(&mut self, reason: Reason) {
        self.refused.count(reason);
    }
}
