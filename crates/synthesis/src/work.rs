//! Work on a share of a class: the structures that were searched, and the solutions found in them.

use crate::class::Class;
use crate::enumerate;
use crate::error::Error;
use crate::search::Solution;
use crate::structure::Structure;
use crate::tally::Tally;
use crate::watch::Watch;
use std::fmt;
use std::ops::{ControlFlow, Range};
use std::str::FromStr;

/// A solution and its structure.
#[derive(Debug, Clone, PartialEq)]
pub struct Found {
    /// The structure.
    pub structure: Structure,
    /// Elements, ring-to-sun ratios and gears.
    pub solution: Solution,
}

/// Progress of a search.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Progress {
    /// Structures that were searched.
    pub done: usize,
    /// Structures to search.
    pub of: usize,
    /// Solutions so far.
    pub found: usize,
}

/// Share of a class to be searched: of `of` shares the one with this number, from 0. The structures are dealt
/// out in turn in the order of their canonical words.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Share {
    /// The number of the share.
    pub number: usize,
    /// Number of shares.
    pub of: usize,
}

impl Share {
    /// The whole class.
    pub const WHOLE: Self = Self { number: 0, of: 1 };

    /// Structures of the share in the order of their canonical words, and the number of structures in the
    /// class. With double-planet sets each structure comes once with every choice of them, and these are
    /// dealt out. `None` if `ended`, which is called now and then, ends the enumeration.
    #[must_use]
    pub fn structures(
        self,
        class: Class,
        double_planets: usize,
        ended: &dyn Fn() -> bool,
    ) -> Option<(Vec<Structure>, usize)> {
        let (mut structures, mut count, mut dealt) = (Vec::new(), 0, 0);
        let watch = Watch::new(ended);
        let whole = enumerate::walk(class, &mut |sets| {
            if watch.is_over() {
                return ControlFlow::Break(());
            }
            if sets.len() < class.sets() {
                return ControlFlow::Continue(());
            }
            count += 1;
            let mut deal = |structure: &mut dyn FnMut() -> Structure| {
                if dealt % self.of.max(1) == self.number {
                    structures.push(structure());
                }
                dealt += 1;
            };
            let mut plain = || Structure::of_canonical_word(sets.to_vec(), class.links());
            if double_planets == 0 {
                deal(&mut plain);
            } else {
                for tagged in plain().with_double_planets(double_planets) {
                    deal(&mut || tagged.clone());
                }
            }
            ControlFlow::Continue(())
        });
        whole.is_continue().then_some((structures, count))
    }

    /// The place among all that are dealt out of the structure at a place of the share, both from 0.
    #[must_use]
    pub const fn place_in_class(self, place: usize) -> usize {
        self.number + place * self.of
    }
}

impl fmt::Display for Share {
    /// `1/8`: the first of eight.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.number + 1, self.of)
    }
}

impl FromStr for Share {
    type Err = Error;

    /// Reads `1/8`, the first of eight.
    fn from_str(text: &str) -> Result<Self, Error> {
        let fault = || Error::Share { text: text.into() };
        let (number, of) = text.split_once('/').ok_or_else(fault)?;
        let [number, of] = [number, of].map(|part| part.trim().parse::<usize>());
        let (Ok(number), Ok(of)) = (number, of) else { return Err(fault()) };
        if (1..=of).contains(&number) { Ok(Self { number: number - 1, of }) } else { Err(fault()) }
    }
}

/// Completed work of a search through a share.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Work {
    /// Structures in the class; 0 before the search begins.
    pub class_size: usize,
    /// Structures of the share.
    pub structures: usize,
    /// Places in the share of those that were searched: ranges in rising order that neither touch nor
    /// overlap.
    pub done: Vec<Range<usize>>,
    /// Solutions found, with the place of their structure in the share; in the order of places and elements
    /// once the search ends.
    pub found: Vec<(usize, Found)>,
    /// Counts.
    pub tally: Tally,
}

impl Work {
    /// Whether all structures of the share were searched. No class is empty, so a search that has not begun
    /// is not complete.
    #[must_use]
    pub fn is_complete(&self) -> bool {
        self.class_size > 0 && self.done_count() == self.structures
    }

    /// Whether the work is consistent: its ranges are in order and within the share, and solutions belong to
    /// structures that were searched.
    #[must_use]
    pub fn is_sound(&self) -> bool {
        let ordered = self.done.windows(2).all(|pair| pair[0].end < pair[1].start)
            && self.done.iter().all(|range| range.start < range.end);
        let within = self.done.last().is_none_or(|range| range.end <= self.structures);
        let is_done = |place: usize| {
            let at = self.done.partition_point(|range| range.end <= place);
            self.done.get(at).is_some_and(|range| range.contains(&place))
        };
        ordered && within && self.found.iter().all(|(place, _)| is_done(*place))
    }

    /// Progress of the search.
    #[must_use]
    pub fn progress(&self) -> Progress {
        Progress { done: self.done_count(), of: self.structures, found: self.found.len() }
    }

    fn done_count(&self) -> usize {
        self.done.iter().map(ExactSizeIterator::len).sum()
    }

    /// Work for a share with this number of structures. The work must be new or belong to such a share.
    pub(crate) fn on(mut self, class_size: usize, structures: usize) -> Result<Self, Error> {
        // New work takes the sizes of the share; other work has to match them.
        if self == Self::default() {
            (self.class_size, self.structures) = (class_size, structures);
        }
        if (self.class_size, self.structures) == (class_size, structures) && self.is_sound() {
            Ok(self)
        } else {
            Err(Error::OtherWork { given: self.structures, structures })
        }
    }

    /// Places of the share that were not searched.
    pub(crate) fn left(&self) -> impl Iterator<Item = usize> {
        let ends = self.done.iter().map(|range| range.start).chain([self.structures]);
        let starts = [0].into_iter().chain(self.done.iter().map(|range| range.end));
        starts.zip(ends).flat_map(|(start, end)| start..end)
    }

    /// Adds the solutions found at some places in rising order, and their counts.
    pub(crate) fn add(&mut self, places: &[usize], found: Vec<(usize, Found)>, tally: Tally) {
        for place in places {
            // Ranges that touch are joined, so that the list stays short and `is_sound` can ask for gaps.
            let at = self.done.partition_point(|range| range.end < *place);
            match self.done.get_mut(at) {
                Some(range) if range.end == *place => range.end += 1,
                Some(range) if range.start == place + 1 => range.start = *place,
                _ => self.done.insert(at, *place..place + 1),
            }
            if self.done.get(at + 1).is_some_and(|next| next.start == self.done[at].end) {
                self.done[at].end = self.done.remove(at + 1).end;
            }
        }
        self.found.extend(found);
        self.tally += tally;
    }

    pub(crate) fn sort(&mut self) {
        self.found.sort_by(|(place, one), (other_place, other)| {
            (place, &one.solution.elements).cmp(&(other_place, &other.solution.elements))
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_are_numbered_from_one() {
        assert_eq!("3/8".parse(), Ok(Share { number: 2, of: 8 }));
        assert_eq!("1/1".parse(), Ok(Share::WHOLE));
        assert_eq!(Share { number: 2, of: 8 }.to_string(), "3/8");
        for text in ["0/3", "4/3", "1/0", "1", "a/b", "-1/3", "1/3/5", ""] {
            let error = text.parse::<Share>().unwrap_err().to_string();
            assert!(error.contains("is no share: write 1/8"), "{text}: {error}");
        }
    }

    #[test]
    fn places_that_are_done_are_kept_as_ranges() {
        let mut work = Work::default().on(40, 20).unwrap();
        for places in [&[4, 5, 6][..], &[0, 1], &[9], &[2, 3], &[8], &[7]] {
            work.add(places, Vec::new(), Tally::default());
        }
        assert_eq!(work.done, std::slice::from_ref(&(0..10)));
        work.add(&[12, 14], Vec::new(), Tally::default());
        assert_eq!(work.done, [0..10, 12..13, 14..15]);
        assert_eq!(work.left().collect::<Vec<_>>(), [10, 11, 13, 15, 16, 17, 18, 19]);
        assert_eq!(work.progress(), Progress { done: 12, of: 20, found: 0 });
        assert!(!work.is_complete());
        work.add(&[10, 11, 13, 15, 16, 17, 18, 19], Vec::new(), Tally::default());
        assert!(work.is_complete() && work.left().next().is_none());
        assert!(work.on(40, 21).is_err());
    }

    #[test]
    fn work_beyond_its_share_is_refused() {
        let of = |done: Vec<Range<usize>>| Work { class_size: 40, structures: 20, done, ..Work::default() };
        assert!(of(vec![0..4, 5..20]).on(40, 20).is_ok());
        for done in [&[0..4, 4..20][..], &[5..6, 3..3], &[5..6, 0..2], &[0..1, 4..21]] {
            assert!(of(done.to_vec()).on(40, 20).is_err(), "{done:?}");
        }
    }
}
