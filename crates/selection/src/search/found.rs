//! Result of a search: its entries, and the designs behind each.

use super::levels::Level;
use super::patch::{Allowed, Patch};
use crate::Error;
use crate::front::Entry;
use crate::objectives::Objectives;
use crate::quantity::Limited;
use crate::size::Rating;
use epicyclic_gears::involute::left_out::LeftOut;
use epicyclic_gears::synthesis::ToothNumbers;
use epicyclic_schemes::structures::Structure;
use epicyclic_units::Physical;
use std::ops::RangeInclusive;
use uom::si::f64::Length;

/// Result of a search over teeth.
#[derive(Debug, Clone)]
pub struct Found {
    pub(super) entries: Vec<Entry>,
    pub(super) points: Vec<Point>,
    pub(super) patches: Vec<Patch>,
    pub(super) levels: Vec<Level>,
    pub(super) tooth_sets: Vec<ToothNumbers>,
    pub(super) left_out: Option<Box<LeftOut>>,
    pub(super) counts: Counts,
    pub(super) size: SizeLimits,
    pub(super) allowed: Allowed,
    pub(super) rating: Rating,
}

/// Numbers of designs of a search.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Counts {
    /// Combinations of tooth numbers of a set.
    pub tooth_sets: usize,
    /// Distinct ring-to-sun ratios among them.
    pub levels: usize,
    /// Structures with an assignment of ratios.
    pub patches: usize,
    /// Patches with any pair to try.
    pub patches_tried: usize,
    /// Designs in all: pairs of combinations of tooth numbers, times `patches`.
    pub designs: u128,
    /// Pairs of ring-to-sun ratios tried in full.
    pub tried: u64,
    /// Pairs tried that meet every required criterion.
    pub feasible: u64,
}

/// Designs of one structure that share objectives: any of these tooth numbers in set 1 with any in set 2,
/// except where [`pairs`](Self::pairs) says otherwise.
#[derive(Debug, Clone, PartialEq)]
pub struct ToothDesign {
    /// The structure.
    pub structure: Structure,
    /// Target ratios of gears 1 and 2.
    pub wanted: [f64; 2],
    /// Ring-to-sun ratios.
    pub k: [f64; 2],
    /// Tooth numbers of both sets, each pair a design.
    pub pairs: Vec<[ToothNumbers; 2]>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Point {
    pub(super) patch: u32,
    pub(super) levels: [u32; 2],
}

/// Limits of size over the relative size of 1.
#[derive(Debug, Clone, Copy)]
pub(super) struct SizeLimits {
    pub(super) module: Option<[f64; 2]>,
    pub(super) ring: f64,
}

impl SizeLimits {
    /// Limits of size from lengths, at the load of a rating.
    pub(super) fn new(
        module: Option<&RangeInclusive<Length>>,
        ring_diameter: Option<Length>,
        rating: &Rating,
    ) -> Result<Self, Error> {
        if module.is_none() && ring_diameter.is_none() {
            return Ok(Self { module: None, ring: f64::INFINITY });
        }
        let unit = rating.unit().ok_or(Error::SizeWithoutTorque)?.si();
        let relative = |what, length: Length| {
            let value = length.si();
            if value > 0.0 { Ok(value / unit) } else { Err(Error::Limit { what, value }) }
        };
        let module = match module {
            Some(range) => {
                Some([relative(Limited::Module, *range.start())?, relative(Limited::Module, *range.end())?])
            }
            None => None,
        };
        let ring = ring_diameter.map_or(Ok(f64::INFINITY), |limit| relative(Limited::RingDiameter, limit))?;
        Ok(Self { module, ring })
    }

    /// Whether there are any.
    pub(super) fn are_any(self) -> bool {
        self.module.is_some() || self.ring.is_finite()
    }

    /// Whether tooth numbers keep to them, `cube` the cube of their relative ring diameter.
    pub(super) fn fits(self, cube: f64, teeth: &ToothNumbers) -> bool {
        let ring = libm::cbrt(cube);
        let module = ring / teeth.ring.as_f64();
        ring <= self.ring && self.module.is_none_or(|[least, greatest]| module >= least && module <= greatest)
    }
}

impl Level {
    pub(super) fn of<'a>(&self, tooth_sets: &'a [ToothNumbers]) -> &'a [ToothNumbers] {
        &tooth_sets[self.tooth_sets[0] as usize..self.tooth_sets[1] as usize]
    }
}

impl Found {
    /// Entries of the front, the best first by the search's order. Their members are for
    /// [`designs`](Self::designs).
    #[must_use]
    pub fn entries(&self) -> &[Entry] {
        &self.entries
    }

    /// Numbers of designs of the search.
    #[must_use]
    pub fn counts(&self) -> Counts {
        self.counts
    }

    /// Tooth numbers of a set that are left out since a check of their teeth does not hold.
    #[must_use]
    pub fn left_out(&self) -> Option<&LeftOut> {
        self.left_out.as_deref()
    }

    /// The designs of an entry: every pair of tooth numbers with its objectives.
    #[must_use]
    pub fn designs(&self, entry: &Entry) -> Vec<ToothDesign> {
        entry.members.iter().filter_map(|&member| self.design(self.points.get(member)?, entry)).collect()
    }

    /// The first design of an entry, with its first pair of tooth numbers alone, and how many pairs the entry
    /// has in all; never more than one design is held. `None` of an entry of another search.
    #[must_use]
    pub fn first_design(&self, entry: &Entry) -> Option<(ToothDesign, u64)> {
        let mut first: Option<ToothDesign> = None;
        let mut count = 0;
        for &member in &entry.members {
            let Some(mut design) = self.points.get(member).and_then(|point| self.design(point, entry)) else {
                continue;
            };
            count += design.pairs.len() as u64;
            if first.is_none() {
                design.pairs.truncate(1);
                design.pairs.shrink_to_fit();
                first = Some(design);
            }
        }
        first.map(|first| (first, count))
    }

    fn design(&self, point: &Point, entry: &Entry) -> Option<ToothDesign> {
        let patch = &self.patches[point.patch as usize];
        let pair = point.levels.map(|level| level as usize);
        let levels = pair.map(|level| &self.levels[level]);
        let sides = [0, 1].map(|set| patch.side(set, levels[set]));
        let measured = patch.measure(&self.levels, pair, [&sides[0], &sides[1]], &self.allowed)?;
        let costs = entry.objectives;
        let share = |teeth: &ToothNumbers| self.rating.share(teeth.planets);
        let mut pairs = vec![];
        let fits = |set: usize, teeth: &ToothNumbers| {
            self.size.fits(measured.cube(set, levels[set], share(teeth)), teeth)
        };
        for first in levels[0].of(&self.tooth_sets).iter().filter(|teeth| fits(0, teeth)) {
            for second in levels[1].of(&self.tooth_sets).iter().filter(|teeth| fits(1, teeth)) {
                let theirs = patch.costs(&measured, levels, [share(first), share(second)]);
                if Objectives::of_costs(theirs, None) == costs {
                    pairs.push([*first, *second]);
                }
            }
        }
        let k = levels.map(|level| level.k);
        Some(ToothDesign { structure: patch.structure, wanted: patch.wanted, k, pairs })
    }
}
