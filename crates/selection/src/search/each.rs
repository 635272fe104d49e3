//! Best design of each single structure.

use super::patch::Patch;
use super::{Found, ToothSearch, Watch};
use crate::Error;

impl ToothSearch {
    /// First entry of the front of each single structure that has one; the best first by the order. Another
    /// structure may dominate it.
    ///
    /// # Errors
    /// Errors of [`front_watched`](Self::front_watched).
    pub fn best_of_each_watched(&self, watch: &Watch) -> Result<Vec<Found>, Error> {
        let all = self.prepared(watch)?;
        let mut best = vec![];
        for structure in &self.structures {
            let of_it = all.patches.iter().filter(|patch| patch.structure == *structure);
            let patches: Vec<Patch> = of_it.cloned().collect();
            if patches.is_empty() {
                continue;
            }
            let found = self.best_of(Found { patches, ..all.clone() }, 1, watch)?;
            if !found.entries.is_empty() {
                best.push(found);
            }
        }
        let first = |found: &Found| found.entries[0].objectives;
        best.sort_by(|one, other| self.order.compare(&first(one).costs(), &first(other).costs()));
        Ok(best)
    }
}
