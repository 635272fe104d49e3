//! Library of the functions that elements engage, each worked out once: its formula, and the parts in which
//! it reaches each gear.
//!
//! Exchanging `k` that have the same range gives a function that reaches the same gears in the
//! correspondingly exchanged parts. So the bounds are calculated for only one function of each such family:
//! in a class of four sets for one in twenty.

use crate::motion::Speeds;
use crate::parts::{Bounds, Grid, Parts};
use crate::permutation::{Permutation, permutations};
use crate::ratio::Ratio;
use crate::ternary::Word;
use rustc_hash::FxHashMap;

/// The number of a function in a library.
pub(crate) type Number = u32;

/// Number for elements whose function no wanted gear can have.
pub(crate) const USELESS: Number = Number::MAX;

/// A function that reaches a gear in some part of the range.
struct Record {
    ratio: Ratio,
    /// Gears within reach, as bits.
    gears: u32,
    /// Beginning of the parts of the function: for each of these gears those within reach.
    reach: usize,
}

/// The functions met so far.
pub(crate) struct Library<W> {
    gears: Vec<Bounds>,
    grid: Grid,
    permutations: Vec<Permutation>,
    by_speeds: FxHashMap<Speeds<W>, Number>,
    by_ratio: FxHashMap<Ratio, Number>,
    /// Gears within reach of the least formula of each family, and the beginning of its parts.
    families: FxHashMap<Ratio, (u32, usize)>,
    of_families: Vec<Parts>,
    records: Vec<Record>,
    reach: Vec<Parts>,
}

impl<W: Word> Library<W> {
    pub(crate) fn new(gears: Vec<Bounds>, grid: Grid) -> Self {
        Self {
            permutations: permutations(&grid),
            gears,
            grid,
            by_speeds: FxHashMap::default(),
            by_ratio: FxHashMap::default(),
            families: FxHashMap::default(),
            of_families: Vec::new(),
            records: Vec::new(),
            reach: Vec::new(),
        }
    }

    /// The parts of the range.
    pub(crate) fn grid(&self) -> &Grid {
        &self.grid
    }

    /// Approximate memory in bytes: the allotted bytes, and one more for each place of a hash table.
    pub(crate) fn bytes(&self) -> usize {
        let Self { by_speeds, by_ratio, families, of_families, records, reach, .. } = self;
        by_speeds.capacity() * (size_of::<(Speeds<W>, Number)>() + 1)
            + by_ratio.capacity() * (size_of::<(Ratio, Number)>() + 1)
            + families.capacity() * (size_of::<(Ratio, (u32, usize))>() + 1)
            + (of_families.capacity() + reach.capacity()) * size_of::<Parts>()
            + records.capacity() * size_of::<Record>()
    }

    /// The number of the function with these speeds, or [`USELESS`].
    pub(crate) fn number(&mut self, speeds: Speeds<W>) -> Number {
        if let Some(number) = self.by_speeds.get(&speeds) {
            return *number;
        }
        let number = Ratio::of(speeds).map_or(USELESS, |ratio| self.number_of_ratio(ratio));
        self.by_speeds.insert(speeds, number);
        number
    }

    fn number_of_ratio(&mut self, ratio: Ratio) -> Number {
        if let Some(number) = self.by_ratio.get(&ratio) {
            return *number;
        }
        let Self { gears, grid, permutations, families, of_families, .. } = self;
        let (least, permutation) = permutations
            .iter()
            .map(|permutation| (permutation.ratio(ratio), permutation))
            .min_by_key(|(ratio, _)| ratio.words())
            .unwrap_or((ratio, &permutations[0]));
        let (within, from) = *families.entry(least).or_insert_with(|| {
            let from = of_families.len();
            let mut within = 0;
            for (gear, reach) in grid.reach(least, gears).into_iter().enumerate() {
                if !reach.is_empty() {
                    within |= 1 << gear;
                    of_families.push(reach);
                }
            }
            (within, from)
        });
        let number = if within == 0 {
            USELESS
        } else {
            let reach = self.reach.len();
            let own = &of_families[from..][..within.count_ones() as usize];
            self.reach.extend(own.iter().map(|parts| permutation.parts_before(*parts)));
            self.records.push(Record { ratio, gears: within, reach });
            Number::try_from(self.records.len() - 1).unwrap_or(USELESS)
        };
        self.by_ratio.insert(ratio, number);
        number
    }

    /// The formula of the function of this number.
    pub(crate) fn ratio(&self, number: Number) -> Ratio {
        self.records[number as usize].ratio
    }

    /// The gears that a function reaches, as bits.
    pub(crate) fn gears(&self, number: Number) -> u32 {
        self.records[number as usize].gears
    }

    /// Parts in which the function reaches each of these gears, in turn.
    pub(crate) fn reach(&self, number: Number) -> &[Parts] {
        let record = &self.records[number as usize];
        &self.reach[record.reach..][..record.gears.count_ones() as usize]
    }
}
