//! All sets of elements of a structure that have the wanted gears.

use crate::motion::{Element, Motion, Speeds, elements};
use crate::parts::{Bounds, Grid, Parts};
use crate::ratio::{Polynomial, Ratio};
use crate::solve::{Function, Outcome, Solver};
use crate::structure::Structure;
use crate::ternary::{Ternary, Word};
use rustc_hash::{FxHashMap, FxHashSet};
use std::ops::RangeInclusive;

/// What is wanted of a gearbox.
#[derive(Debug, Clone, PartialEq)]
pub struct Wish {
    /// The bounds of each gear's ratio.
    pub gears: Vec<Bounds>,
    /// How many elements.
    pub elements: usize,
    /// The range of the ring-to-sun ratios.
    pub k: RangeInclusive<f64>,
}

/// A set of elements with all gears.
#[derive(Debug, Clone, PartialEq)]
pub struct Solution {
    /// The elements, each the first of those that lock the same.
    pub elements: Vec<Element>,
    /// Ring-to-sun ratios with which all gears are within their bounds.
    pub k: Vec<f64>,
    /// For each gear the elements that it engages, by their places.
    pub gears: Vec<Vec<usize>>,
}

/// Counts of what a search came to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Tally {
    /// Structures searched.
    pub structures: u64,
    /// Structures in which each gear is within reach of some elements.
    pub within_reach: u64,
    /// Sets of elements that have parts with all gears.
    pub candidates: u64,
    /// Parts of these in which a point was sought.
    pub parts: u64,
    /// Sets with all gears only if some `k` moves none of them, or some element is spare.
    pub reducible: u64,
    /// Sets for which some part is undecided.
    pub undecided: u64,
}

/// A function in reach of a gear somewhere.
struct Record {
    function: Function,
    /// Gears within reach, as bits.
    gears: u32,
    /// The parts within reach of each gear.
    reach: Vec<Parts>,
}

/// What a function is that no gear can have.
const DEAD: u32 = u32::MAX;

/// A search through structures of one class; functions that it has met are kept.
pub struct Search<W> {
    wish: Wish,
    sets: usize,
    engaged: usize,
    grid: Grid,
    motion: Motion<W>,
    all: Vec<Element>,
    known: FxHashMap<Speeds<W>, u32>,
    ratios: FxHashMap<Ratio, u32>,
    records: Vec<Record>,
    tally: Tally,
    /// How many choices of `j + 1` of the places below `place`: `choices[j][place]`.
    choices: Vec<Vec<usize>>,
    /// For each choice of elements its function.
    gears: Vec<u32>,
    lists: Vec<Vec<(u64, Parts)>>,
    seen: FxHashSet<u64>,
    candidates: Vec<(u64, Parts)>,
}

fn wide<W: Word>(speeds: Speeds<W>) -> [Polynomial; 2] {
    [speeds.input, speeds.output].map(|speed| Ternary { plus: speed.plus.into(), minus: speed.minus.into() })
}

impl<W: Word> Search<W> {
    /// For structures of so many sets and links.
    #[must_use]
    pub fn new(wish: Wish, sets: usize, links: usize) -> Self {
        let engaged = links - sets - 1;
        let all = elements(links);
        let choices = (0..engaged)
            .map(|j| (0..=all.len()).map(|place| (0..=j).fold(1, |all, i| all * place.saturating_sub(i) / (i + 1))).collect())
            .collect();
        let lists = vec![Vec::new(); wish.gears.len()];
        Self {
            grid: Grid::new(&vec![wish.k.clone(); sets]),
            wish,
            sets,
            engaged,
            motion: Motion::new(links - sets),
            all,
            known: FxHashMap::default(),
            ratios: FxHashMap::default(),
            records: Vec::new(),
            tally: Tally::default(),
            choices,
            gears: Vec::new(),
            lists,
            seen: FxHashSet::default(),
            candidates: Vec::new(),
        }
    }

    /// What was searched so far.
    #[must_use]
    pub fn tally(&self) -> Tally {
        self.tally
    }

    /// How many functions are known: speeds met, and ratios that a gear can have.
    #[must_use]
    pub fn functions(&self) -> (usize, usize) {
        (self.known.len(), self.records.len())
    }

    /// All solutions of a structure.
    pub fn structure(&mut self, structure: &Structure) -> Vec<Solution> {
        self.tally.structures += 1;
        let representatives = self.representatives(structure);
        if !self.functions_of(structure, &representatives) {
            return Vec::new();
        }
        self.tally.within_reach += 1;
        self.seen.clear();
        self.candidates.clear();
        let mut order: Vec<usize> = (0..self.wish.gears.len()).collect();
        order.sort_by_key(|gear| self.lists[*gear].len());
        let parts = Parts::first(self.grid.count());
        self.grow(&order, 0, parts);
        let candidates = std::mem::take(&mut self.candidates);
        self.tally.candidates += candidates.len() as u64;
        let found = candidates.iter().filter_map(|(chosen, parts)| self.decide(*chosen, *parts, &representatives)).collect();
        self.candidates = candidates;
        found
    }

    /// The elements of a structure, one of those that lock the same.
    fn representatives(&mut self, structure: &Structure) -> Vec<Element> {
        self.motion.take(structure, &self.all);
        let mut kept: Vec<usize> = Vec::new();
        for element in 0..self.all.len() {
            if !kept.iter().any(|other| self.motion.lock_the_same(element, *other)) {
                kept.push(element);
            }
        }
        kept.into_iter().map(|element| self.all[element]).collect()
    }

    /// Finds the function of each choice of elements, and lists for each gear those within reach. Whether each gear has one.
    fn functions_of(&mut self, structure: &Structure, elements: &[Element]) -> bool {
        self.motion.take(structure, elements);
        let Self { motion, known, ratios, records, grid, wish, sets, gears, lists, choices, .. } = self;
        gears.clear();
        gears.resize(choose(elements.len(), self.engaged), DEAD);
        lists.iter_mut().for_each(Vec::clear);
        motion.for_each_gear(&mut |first, last| {
            let from = first.last().map_or(0, |element| element + 1);
            let base: usize = first.iter().zip(choices.iter()).map(|(element, choices)| choices[*element]).sum();
            let mask = first.iter().fold(0u64, |mask, element| mask | 1 << element);
            let top = &choices[first.len()];
            for (offset, speeds) in last.iter().enumerate() {
                if speeds.input.is_zero() || speeds.output.is_zero() {
                    continue;
                }
                let number = *known.entry(*speeds).or_insert_with(|| {
                    let [input, output] = wide(*speeds);
                    let Some(ratio) = Ratio::new(input, output) else { return DEAD };
                    *ratios.entry(ratio).or_insert_with(|| {
                        let reach = grid.reach(ratio, &wish.gears);
                        let within = (0..reach.len()).filter(|gear| !reach[*gear].is_empty());
                        let within = within.fold(0, |all, gear| all | 1 << gear);
                        if within == 0 {
                            return DEAD;
                        }
                        records.push(Record { function: Function::new(ratio, *sets), gears: within, reach });
                        (records.len() - 1) as u32
                    })
                });
                if number == DEAD {
                    continue;
                }
                let element = from + offset;
                gears[base + top[element]] = number;
                let record = &records[number as usize];
                let mut left = record.gears;
                while left != 0 {
                    let gear = left.trailing_zeros() as usize;
                    left &= left - 1;
                    lists[gear].push((mask | 1 << element, record.reach[gear]));
                }
            }
        });
        lists.iter().all(|list| !list.is_empty())
    }

    /// Adds what elements the next gear needs to those chosen.
    fn grow(&mut self, order: &[usize], chosen: u64, parts: Parts) {
        if chosen.count_ones() as usize == self.wish.elements || order.is_empty() {
            return self.complete(chosen);
        }
        let gear = order[0];
        let covered = self.covered(chosen, gear).and(parts);
        if !covered.is_empty() {
            self.grow(&order[1..], chosen, covered);
        }
        for place in 0..self.lists[gear].len() {
            let (mask, reach) = self.lists[gear][place];
            let with = chosen | mask;
            if with == chosen || with.count_ones() as usize > self.wish.elements {
                continue;
            }
            let parts = parts.and(reach);
            if !parts.is_empty() {
                self.grow(&order[1..], with, parts);
            }
        }
    }

    /// The parts in which chosen elements have a gear.
    fn covered(&self, chosen: u64, gear: usize) -> Parts {
        let mut covered = Parts::default();
        self.for_each_function(chosen, &mut |_, number| {
            let record = &self.records[number as usize];
            if record.gears >> gear & 1 == 1 {
                covered = covered.or(record.reach[gear]);
            }
        });
        covered
    }

    /// Calls `visit` with each choice of chosen elements that has a function, as bits, and its number.
    fn for_each_function(&self, chosen: u64, visit: &mut impl FnMut(u64, u32)) {
        fn go(choices: &[Vec<usize>], left: u64, index: usize, mask: u64, visit: &mut impl FnMut(usize, u64)) {
            let Some((first, rest)) = choices.split_first() else { return visit(index, mask) };
            let mut candidates = left;
            while candidates != 0 {
                let element = candidates.trailing_zeros() as usize;
                candidates &= candidates - 1;
                go(rest, candidates, index + first[element], mask | 1 << element, visit);
            }
        }
        go(&self.choices, chosen, 0, 0, &mut |index, mask| {
            if self.gears[index] != DEAD {
                visit(mask, self.gears[index]);
            }
        });
    }

    /// Notes chosen elements as a candidate, where some parts have all gears.
    fn complete(&mut self, chosen: u64) {
        if !self.seen.insert(chosen) {
            return;
        }
        let mut functions = [0u32; 512];
        let mut count = 0;
        let mut gears = 0;
        self.for_each_function(chosen, &mut |_, number| {
            if count < functions.len() {
                functions[count] = number;
                count += 1;
            }
            gears |= self.records[number as usize].gears;
        });
        let functions = &functions[..count];
        if gears.count_ones() as usize != self.wish.gears.len() {
            return;
        }
        let mut parts = Parts::first(self.grid.count());
        for gear in 0..self.wish.gears.len() {
            let mut covered = Parts::default();
            for number in functions {
                let record = &self.records[*number as usize];
                if record.gears >> gear & 1 == 1 {
                    covered = covered.or(record.reach[gear]);
                }
            }
            parts = parts.and(covered);
            if parts.is_empty() {
                return;
            }
        }
        self.candidates.push((chosen, parts));
    }

    /// Whether chosen elements have all gears at one point.
    fn decide(&mut self, chosen: u64, parts: Parts, representatives: &[Element]) -> Option<Solution> {
        let mut numbers: Vec<u32> = Vec::new();
        let mut masks: Vec<Vec<u64>> = Vec::new();
        self.for_each_function(chosen, &mut |mask, number| match numbers.iter().position(|known| *known == number) {
            Some(place) => masks[place].push(mask),
            None => {
                numbers.push(number);
                masks.push(vec![mask]);
            }
        });
        let functions: Vec<&Function> = numbers.iter().map(|number| &self.records[*number as usize].function).collect();
        let whole = (1usize << self.sets) - 1;
        let mut reducible = false;
        let mut accept = |assigned: &[usize]| {
            let used = assigned.iter().fold(0, |all, function| all | functions[*function].ratio.variables());
            let engaged = assigned.iter().flat_map(|function| &masks[*function]).fold(0, |all, mask| all | mask);
            let irreducible = used == whole && engaged == chosen;
            reducible |= !irreducible;
            irreducible
        };
        let mut undecided = false;
        let mut found = None;
        {
            let mut solver = Solver::new(&functions, &self.wish.gears, &mut accept);
            for part in parts.iter() {
                self.tally.parts += 1;
                match solver.search(self.grid.part(part)) {
                    Outcome::Found { k, functions } => {
                        found = Some((k, functions));
                        break;
                    }
                    Outcome::None => {}
                    Outcome::Undecided => undecided = true,
                }
            }
        }
        if found.is_none() {
            self.tally.undecided += u64::from(undecided);
            self.tally.reducible += u64::from(!undecided && reducible);
        }
        let (k, assigned) = found?;
        let places: Vec<usize> = (0..64).filter(|element| chosen >> element & 1 == 1).collect();
        let gears = assigned
            .iter()
            .map(|function| (0..places.len()).filter(|place| masks[*function][0] >> places[*place] & 1 == 1).collect())
            .collect();
        Some(Solution { elements: places.iter().map(|place| representatives[*place]).collect(), k, gears })
    }
}

fn choose(count: usize, of: usize) -> usize {
    (0..of).fold(1, |all, i| all * count.saturating_sub(i) / (i + 1))
}
