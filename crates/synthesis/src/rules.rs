//! Rules for a gearbox besides its ratios: brakes and clutches, shifts, a direct gear.
//!
//! # What complete means here
//! Rules are applied to all choices that a solution leaves, before one is listed:
//!
//! - *Brakes and clutches*: elements that lock the same are one element. It may be built as a brake or as a
//!   clutch if its pairs of links allow both. A set of elements is kept if some choice of pairs has numbers
//!   within both ranges, and such a choice is listed. Sets that cannot come to such numbers are not searched.
//! - *Shifts* and the *direct gear* depend on the function of each gear and the elements that engage it. A
//!   set of elements is kept if some functions and some choices keep the rule at a common point. A set that
//!   has all ratios, but not with the rule, is counted.

use crate::error::Error;
use crate::motion::Element;
use crate::parts::Bounds;
use crate::shifts::Shifts;
use crate::structure::HOUSING;
use std::ops::RangeInclusive;

/// Rules for a gearbox besides its ratios. By default none.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Rules {
    /// Range of the number of brakes among the elements.
    pub brakes: RangeInclusive<usize>,
    /// Range of the number of clutches among the elements.
    pub clutches: RangeInclusive<usize>,
    /// Shifts that have to be single.
    pub shifts: Shifts,
    /// Whether a gear turns the gearbox as one block: its ratio is 1 whatever the `k`.
    pub direct: bool,
}

impl Default for Rules {
    fn default() -> Self {
        Self { brakes: 0..=64, clutches: 0..=64, shifts: Shifts::default(), direct: false }
    }
}

/// Whether an element with these pairs of links may be a brake, and whether it may be a clutch.
pub(crate) fn may_be(pairs: &[Element]) -> [bool; 2] {
    let brakes = pairs.iter().filter(|pair| pair[0] == HOUSING).count();
    [brakes > 0, brakes < pairs.len()]
}

impl Rules {
    /// Checks whether gearboxes with these gears and this number of elements can keep the rules at all.
    pub(crate) fn check(&self, gears: &[Bounds], elements: usize) -> Result<(), Error> {
        let fault = |why: String| Err(Error::Wish { why });
        if self.brakes_of(elements, 0, 0).is_none() {
            let text = |range: &RangeInclusive<usize>| format!("{} to {}", range.start(), range.end());
            return fault(format!(
                "{elements} shift elements are not {} brakes and {} clutches",
                text(&self.brakes),
                text(&self.clutches)
            ));
        }
        if self.direct && !gears.iter().any(|gear| gear.contain(1.0)) {
            return fault("a direct gear is asked for, and no gear may have the ratio 1".into());
        }
        Ok(())
    }

    /// Whether the rules exclude some numbers of brakes and clutches among this number of elements.
    pub(crate) fn counts_brakes(&self, elements: usize) -> bool {
        !(0..=elements)
            .all(|brakes| self.brakes.contains(&brakes) && self.clutches.contains(&(elements - brakes)))
    }

    /// Number of brakes among some elements if both numbers are within their ranges: the largest possible.
    ///
    /// Of these elements `brakes_alone` can only be brakes, and `clutches_alone` only clutches.
    pub(crate) fn brakes_of(
        &self,
        elements: usize,
        brakes_alone: usize,
        clutches_alone: usize,
    ) -> Option<usize> {
        let possible = brakes_alone..=elements - clutches_alone;
        possible
            .rev()
            .find(|brakes| self.brakes.contains(brakes) && self.clutches.contains(&(elements - brakes)))
    }

    /// Sorts the pairs of each element so that the first keeps the numbers of brakes and clutches: a brake if
    /// there is a choice, as long as their number allows it.
    pub(crate) fn order(&self, elements: &mut [Vec<Element>]) {
        let count =
            |which: fn([bool; 2]) -> bool| elements.iter().filter(|pairs| which(may_be(pairs))).count();
        let brakes_alone = count(|[_, clutch]| !clutch);
        let Some(brakes) = self.brakes_of(elements.len(), brakes_alone, count(|[brake, _]| !brake)) else {
            return;
        };
        let mut free = brakes - brakes_alone;
        for pairs in elements.iter_mut().filter(|pairs| may_be(pairs) == [true, true]) {
            let brake = free > 0;
            free -= usize::from(brake);
            // A stable sort: within both kinds the order stays.
            pairs.sort_by_key(|pair| (pair[0] == HOUSING) != brake);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn elements_that_lock_the_same_take_the_kind_that_the_numbers_want() {
        let elements = vec![vec![[0, 3]], vec![[0, 4], [1, 3], [1, 4]], vec![[1, 2]]];
        for (brakes, clutches, first) in
            [(0..=64, 0..=64, [0, 4]), (0..=1, 0..=64, [1, 3]), (0..=64, 2..=3, [1, 3])]
        {
            let rules = Rules { brakes, clutches, ..Rules::default() };
            let mut ordered = elements.clone();
            rules.order(&mut ordered);
            assert_eq!(ordered[1][0], first, "{rules:?}");
            assert_eq!((&ordered[0], &ordered[2]), (&elements[0], &elements[2]));
        }
        let none = Rules { brakes: 0..=0, ..Rules::default() };
        assert_eq!(none.brakes_of(3, 1, 1), None);
    }
}
