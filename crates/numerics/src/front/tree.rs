//! A tree of sixteen branches over the ranks of designs.

use super::ranks::{Columns, Scales, WIDE};
use crate::front::dominates;
#[cfg(feature = "parallel")]
use rayon::prelude::*;

/// Number of designs from which the cost of the widest spread is found.
const SAMPLE: usize = 32;

/// Number of designs from which on the two halves are sorted in parallel.
#[cfg(feature = "parallel")]
const JOINT: usize = 1 << 12;

/// A design by the ranks of its costs.
#[derive(Debug, Clone, Copy)]
struct Row<const N: usize> {
    ranks: [u16; N],
    place: u32,
}

/// Boxes around designs, sixteen beside each other in one group; each box is around a group of the level
/// below.
#[derive(Debug)]
struct Level<const N: usize> {
    least: Vec<Columns<N>>,
    greatest: Vec<Columns<N>>,
    /// A good design of each box.
    good: Vec<Columns<N>>,
    /// Least of a whole group.
    floor: Vec<[u16; N]>,
}

/// The designs are in an order in which neighbours are alike.
#[derive(Debug)]
pub(crate) struct Tree<'a, const N: usize> {
    costs: &'a [[f64; N]],
    places: Vec<u32>,
    designs: Vec<Columns<N>>,
    floor: Vec<[u16; N]>,
    /// The lowest first; the last has one group.
    levels: Vec<Level<N>>,
}

/// A box, and a good design in it.
#[derive(Debug, Clone, Copy)]
struct Ends<const N: usize> {
    least: [u16; N],
    greatest: [u16; N],
    good: [u16; N],
    sum: u32,
}

impl<const N: usize> Ends<N> {
    fn of(ranks: [u16; N]) -> Self {
        Self {
            least: ranks,
            greatest: ranks,
            good: ranks,
            sum: ranks.iter().map(|rank| u32::from(*rank)).sum(),
        }
    }

    fn with(mut self, other: Self) -> Self {
        for cost in 0..N {
            self.least[cost] = self.least[cost].min(other.least[cost]);
            self.greatest[cost] = self.greatest[cost].max(other.greatest[cost]);
        }
        if other.sum < self.sum {
            (self.good, self.sum) = (other.good, other.sum);
        }
        self
    }
}

impl<'a, const N: usize> Tree<'a, N> {
    /// Tree over designs whose costs are all numbers.
    pub(crate) fn new(costs: &'a [[f64; N]], places: &[u32]) -> Self {
        let scales = Scales::new(costs, places);
        let row = |&place: &u32| Row { ranks: scales.ranks(&costs[place as usize]), place };
        let mut rows: Vec<Row<N>> = places.iter().map(row).collect();
        arrange(&mut rows);
        let groups = rows.chunks(WIDE);
        let mut designs = vec![Columns::EMPTY; groups.len()];
        let mut ends = Vec::with_capacity(groups.len());
        for (columns, group) in designs.iter_mut().zip(groups) {
            for (lane, row) in group.iter().enumerate() {
                columns.set(lane, &row.ranks);
            }
            ends.extend(group.iter().map(|row| Ends::of(row.ranks)).reduce(Ends::with));
        }
        let floor = ends.iter().map(|ends| ends.least).collect();
        let mut levels = vec![];
        while ends.len() > 1 {
            let groups = ends.chunks(WIDE);
            let empty = || vec![Columns::EMPTY; groups.len()];
            let mut level = Level { least: empty(), greatest: empty(), good: empty(), floor: vec![] };
            let mut above = Vec::with_capacity(groups.len());
            for (place, group) in groups.clone().enumerate() {
                for (lane, ends) in group.iter().enumerate() {
                    level.least[place].set(lane, &ends.least);
                    level.greatest[place].set(lane, &ends.greatest);
                    level.good[place].set(lane, &ends.good);
                }
                above.extend(group.iter().copied().reduce(Ends::with));
            }
            level.floor = above.iter().map(|ends: &Ends<N>| ends.least).collect();
            levels.push(level);
            ends = above;
        }
        Self { costs, places: rows.into_iter().map(|row| row.place).collect(), designs, floor, levels }
    }

    /// Places of the designs that another dominates, in no order.
    pub(crate) fn dominated(&self) -> Vec<u32> {
        let mut dominated = vec![false; self.places.len()];
        if dominated.is_empty() {
            return vec![];
        }
        self.ask(self.levels.len(), 0, &[0], &mut dominated);
        let dominated = self.places.iter().zip(dominated).filter(|(_, is_dominated)| *is_dominated);
        dominated.map(|(place, _)| *place).collect()
    }

    /// Marks the designs of a group that others dominate. What dominates any of them is in one of the
    /// candidates, groups of the same level.
    fn ask(&self, level: usize, group: usize, candidates: &[u32], dominated: &mut [bool]) {
        let Some(below) = level.checked_sub(1) else {
            self.ask_designs(group, candidates, dominated);
            return;
        };
        let Level { least, greatest, good, floor } = &self.levels[below];
        let mut of_box: [Vec<u32>; WIDE] = std::array::from_fn(|_| Vec::with_capacity(candidates.len()));
        for &candidate in candidates {
            for lane in bits(greatest[group].at_or_above(&floor[candidate as usize])) {
                of_box[lane].push(candidate);
            }
        }
        let ask_box = |(lane, dominated): (usize, &mut [bool])| {
            let mut left = vec![];
            let (low, high) = (least[group].get(lane), greatest[group].get(lane));
            // Below in every rank is below in every cost.
            if !low.contains(&0) {
                let low = low.map(|rank| rank - 1);
                if of_box[lane].iter().any(|&candidate| good[candidate as usize].at_or_below(&low) != 0) {
                    dominated.fill(true);
                    return;
                }
            }
            for &candidate in &of_box[lane] {
                let found = bits(least[candidate as usize].at_or_below(&high));
                left.extend(found.map(|lane| candidate * WIDE as u32 + lane as u32));
            }
            self.ask(below, group * WIDE + lane, &left, dominated);
        };
        let size = WIDE.pow(level as u32);
        #[cfg(feature = "parallel")]
        if dominated.len() >= JOINT {
            dominated.par_chunks_mut(size).enumerate().for_each(ask_box);
            return;
        }
        dominated.chunks_mut(size).enumerate().for_each(ask_box);
    }

    fn ask_designs(&self, group: usize, candidates: &[u32], dominated: &mut [bool]) {
        let asked = &self.designs[group];
        let costs = |group: usize, lane: usize| &self.costs[self.places[group * WIDE + lane] as usize];
        let mut open: u32 = (1 << dominated.len()) - 1;
        for &candidate in candidates {
            let candidate = candidate as usize;
            let others = &self.designs[candidate];
            for lane in bits(asked.at_or_above(&self.floor[candidate]) & open) {
                let mut below = others.at_or_below(&asked.get(lane));
                if candidate == group {
                    below &= !(1 << lane);
                }
                if below != 0
                    && bits(below).any(|other| dominates(costs(candidate, other), costs(group, lane)))
                {
                    dominated[lane] = true;
                    open &= !(1 << lane);
                }
            }
            if open == 0 {
                return;
            }
        }
    }
}

/// Brings designs into an order in which sixteen in a row are alike, and sixteen times as many.
fn arrange<const N: usize>(rows: &mut [Row<N>]) {
    let count = rows.len();
    if count <= WIDE {
        return;
    }
    let (mut least, mut greatest) = ([u16::MAX; N], [0; N]);
    for row in rows.iter().step_by(count / SAMPLE + 1) {
        for cost in 0..N {
            least[cost] = least[cost].min(row.ranks[cost]);
            greatest[cost] = greatest[cost].max(row.ranks[cost]);
        }
    }
    let widest = (0..N).max_by_key(|&cost| greatest[cost].saturating_sub(least[cost])).unwrap_or(0);
    // Parted where a group of the highest level within begins.
    let mut whole = WIDE;
    while whole * WIDE < count {
        whole *= WIDE;
    }
    let middle = ((count + whole) / 2 / whole * whole).max(whole);
    rows.select_nth_unstable_by_key(middle, |row| row.ranks[widest]);
    let (low, high) = rows.split_at_mut(middle);
    #[cfg(feature = "parallel")]
    if count >= JOINT {
        rayon::join(|| arrange(low), || arrange(high));
        return;
    }
    arrange(low);
    arrange(high);
}

/// Places of the bits that are set, ascending.
#[inline]
fn bits(mut of: u32) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let place = of.trailing_zeros();
        of &= of.wrapping_sub(1);
        (place < u32::BITS).then_some(place as usize)
    })
}
