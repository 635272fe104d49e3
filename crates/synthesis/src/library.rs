//! The functions that elements engage, each worked out once: its formula, and which gears it reaches where.

use crate::motion::Speeds;
use crate::parts::{Bounds, Grid, Parts};
use crate::ratio::Ratio;
use crate::solve::Function;
use crate::ternary::Word;
use rustc_hash::FxHashMap;

/// The number of a function in a library.
pub(crate) type Number = u32;

/// What engaged elements give that no wanted gear can have.
pub(crate) const USELESS: Number = Number::MAX;

/// A function that reaches a gear somewhere.
struct Record {
    function: Function,
    /// Gears within reach, as bits.
    gears: u32,
    /// The parts within reach of some gear.
    useful: Parts,
}

/// The functions met so far.
pub(crate) struct Library<W> {
    sets: usize,
    gears: Vec<Bounds>,
    grid: Grid,
    by_speeds: FxHashMap<Speeds<W>, Number>,
    by_ratio: FxHashMap<Ratio, Number>,
    records: Vec<Record>,
    /// For each record, for each gear, the parts within reach.
    reach: Vec<Parts>,
}

impl<W: Word> Library<W> {
    pub(crate) fn new(sets: usize, gears: Vec<Bounds>, grid: Grid) -> Self {
        let (by_speeds, by_ratio) = (FxHashMap::default(), FxHashMap::default());
        Self { sets, gears, grid, by_speeds, by_ratio, records: Vec::new(), reach: Vec::new() }
    }

    /// The parts of the range.
    pub(crate) fn grid(&self) -> &Grid {
        &self.grid
    }

    /// The number of the function with these speeds, or [`USELESS`].
    pub(crate) fn number(&mut self, speeds: Speeds<W>) -> Number {
        let Self { sets, gears, grid, by_speeds, by_ratio, records, reach: all } = self;
        *by_speeds.entry(speeds).or_insert_with(|| {
            let Some(ratio) = Ratio::of(speeds) else { return USELESS };
            *by_ratio.entry(ratio).or_insert_with(|| {
                let reach = grid.reach(ratio, gears);
                let within = (0..reach.len()).filter(|gear| !reach[*gear].is_empty());
                let within = within.fold(0, |all, gear| all | 1 << gear);
                if within == 0 {
                    return USELESS;
                }
                let useful = reach.iter().fold(Parts::default(), |all, reach| all.or(*reach));
                records.push(Record { function: Function::new(ratio, *sets), gears: within, useful });
                all.extend(reach);
                Number::try_from(records.len() - 1).unwrap_or(USELESS)
            })
        })
    }

    /// The function of this number.
    pub(crate) fn function(&self, number: Number) -> &Function {
        &self.records[number as usize].function
    }

    /// The gears that a function reaches, as bits.
    #[inline]
    pub(crate) fn gears(&self, number: Number) -> u32 {
        self.records[number as usize].gears
    }

    /// The parts in which a function reaches some gear.
    #[inline]
    pub(crate) fn useful(&self, number: Number) -> Parts {
        self.records[number as usize].useful
    }

    /// The parts in which a function reaches a gear.
    #[inline]
    pub(crate) fn reach(&self, number: Number, gear: usize) -> Parts {
        self.reach[number as usize * self.gears.len() + gear]
    }
}
