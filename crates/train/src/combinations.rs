//! Combinations of shift elements, with the state of each.

use crate::{Analysis, Error, Gearbox, Named};
use std::ops::RangeInclusive;

/// Largest number of shift elements: more have more combinations than anyone reads.
const MOST_SHIFT_ELEMENTS: usize = 16;

impl Gearbox {
    /// Analyses every choice of shift elements of these sizes between the gearbox's input and output, in the
    /// order of size and then of the elements.
    ///
    /// ```
    /// use epicyclic_train::{Gearbox, set::SetSpec};
    /// # fn main() -> Result<(), epicyclic_train::Error> {
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
        let count = self.shift_elements.len();
        if count > MOST_SHIFT_ELEMENTS {
            return Err(Error::TooMany { what: Named::ShiftElement, count, limit: MOST_SHIFT_ELEMENTS });
        }
        let mut sets: Vec<Vec<&str>> = (0..1_u32 << count)
            .map(|bits| (0..count).filter(|c| bits >> c & 1 == 1).collect::<Vec<_>>())
            .filter(|set| sizes.contains(&set.len()))
            .map(|set| set.into_iter().map(|c| self.shift_elements[c].id()).collect())
            .collect();
        let place = |id: &str| self.shift_elements.iter().position(|shift_element| shift_element.id() == id);
        sets.sort_by_key(|set| (set.len(), set.iter().map(|id| place(id)).collect::<Vec<_>>()));
        let [input, output] = [self.input, self.output].map(|link| self.link_name(link));
        sets.iter().map(|set| self.analyze_gear(&self.gear_of(set, input, output)?)).collect()
    }
}
