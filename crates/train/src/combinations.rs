//! Every combination of shift elements, with what it does.

use crate::{Analysis, Error, Gearbox, Named};
use std::ops::RangeInclusive;

/// More shift elements than this have more combinations than anyone reads.
const MOST_CONTROLS: usize = 16;

impl Gearbox {
    /// Analyses every choice of shift elements of these sizes between the gearbox's input and output, in the
    /// order of size and then of the elements.
    ///
    /// ```
    /// use epicyclic_schemes::{Gearbox, set::SetSpec};
    /// # fn main() -> Result<(), crate::Error> {
    /// let gearbox = Gearbox::builder("two speeds")
    ///     .links(["D", "B", "T1"])
    ///     .set(SetSpec::simple("1", ["D", "T1", "B"], 3.0))
    ///     .brake("K1", "T1")
    ///     .clutch("K2", "D", "B")
    ///     .input("D")
    ///     .output("B")
    ///     .build()?;
    /// let states: Vec<&str> =
    ///     gearbox.combinations(0..=2)?.iter().map(|found| found.state().name()).collect();
    /// assert_eq!(states, ["underdetermined", "driven", "driven", "input blocked"]);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`Error::TooMany`] beyond 16 shift elements.
    pub fn combinations(&self, sizes: RangeInclusive<usize>) -> Result<Vec<Analysis<'_>>, Error> {
        let count = self.controls.len();
        if count > MOST_CONTROLS {
            return Err(Error::TooMany { what: Named::Control, count, limit: MOST_CONTROLS });
        }
        let mut sets: Vec<Vec<&str>> = (0..1_u32 << count)
            .map(|bits| (0..count).filter(|c| bits >> c & 1 == 1).collect::<Vec<_>>())
            .filter(|set| sizes.contains(&set.len()))
            .map(|set| set.into_iter().map(|c| self.controls[c].id()).collect())
            .collect();
        let place = |id: &str| self.controls.iter().position(|control| control.id() == id);
        sets.sort_by_key(|set| (set.len(), set.iter().map(|id| place(id)).collect::<Vec<_>>()));
        let [input, output] = [self.input, self.output].map(|link| self.link_name(link));
        sets.iter().map(|set| self.analyze_gear(&self.gear_of(set, input, output)?)).collect()
    }
}
