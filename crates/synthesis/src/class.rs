//! Classes of structures: numbers of sets and links, and the structures left out.
//!
//! `n` simple sets; `L` moving links besides the housing, input and output among them. A structure has
//! `F = L − n` degrees of freedom, so a gear engages `F − 1` shift elements.

use crate::Error;
use crate::kind::Kind;
use std::fmt;

/// The most sets: a polynomial in the ring-to-sun ratios has one bit of 64 for each of its `2ⁿ` terms.
pub const MOST_SETS: usize = 6;

/// The most moving links: an element set is a word of 64 bits, and 11 links and the housing have 64 pairs
/// without the brakes of input and output.
pub const MOST_LINKS: usize = 11;

/// The most shift elements that a gear engages.
pub const MOST_ENGAGED: usize = 4;

/// Largest number of shift elements of a gearbox: that of real gearboxes and two more.
pub const MOST_ELEMENTS: usize = 8;

/// A class of structures.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Class {
    kind: Kind,
    sets: usize,
    links: usize,
}

impl Class {
    /// Class of the structures with these numbers of sets and moving links.
    ///
    /// # Errors
    /// [`Error::Sets`] outside 1…[`MOST_SETS`]; [`Error::Links`] below `sets + 2`, where no shift element is
    /// left to engage, or above what `kind` can have: `2·sets + 1` joined links in [`Kind::Core`],
    /// `3·sets + 2` in [`Kind::AllSparse`], [`MOST_LINKS`] in both.
    pub fn new(kind: Kind, sets: usize, links: usize) -> Result<Self, Error> {
        if !(1..=MOST_SETS).contains(&sets) {
            return Err(Error::Sets { sets, most: MOST_SETS });
        }
        let most = match kind {
            Kind::Core => 2 * sets + 1,
            Kind::AllSparse => 3 * sets + 2,
        };
        let most = most.min(MOST_LINKS);
        if !(sets + 2..=most).contains(&links) {
            return Err(Error::Links { kind, sets, links, least: sets + 2, most });
        }
        Ok(Self { kind, sets, links })
    }

    /// Kind of structures in the class.
    #[must_use]
    pub const fn kind(self) -> Kind {
        self.kind
    }

    /// `n`, how many sets.
    #[must_use]
    pub const fn sets(self) -> usize {
        self.sets
    }

    /// `L`, how many moving links.
    #[must_use]
    pub const fn links(self) -> usize {
        self.links
    }

    /// `e = L − n − 1`, how many shift elements a gear engages.
    #[must_use]
    pub const fn engaged(self) -> usize {
        self.links - self.sets - 1
    }
}

impl fmt::Display for Class {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} structures of {} sets and {} links", self.kind.name(), self.sets, self.links)
    }
}
