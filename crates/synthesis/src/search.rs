//! Search for all sets of elements of a structure that have the wanted gears.
//!
//! # Steps
//! 1. Elements that lock the same are one. Each choice of `e` elements has a function, from the library.
//! 2. Elements are chosen for the gears in turn, the gear with the fewest choices first, up to as many as may
//!    be. This is done in all parts of the range of `k` at once.
//! 3. A full set of elements stays a candidate in the parts in which each gear can have a function of its
//!    own.
//! 4. In each such part a point is searched for, or proved not to exist ([`solve`](crate::solve)).
//!
//! If some sets of one kind have to have equal `k`, steps 2 and 3 keep to the parts that hold such points.
//! Step 4 is then taken for each choice of these sets ([`equal`](crate::equal)).
//!
//! # Why nothing is lost
//! Steps 2 and 3 leave out what a part excludes by the signs at its corners, which hold everywhere in it.
//! Step 2 splits by parts. In a part in which the chosen elements do not reach a gear, a solution must have a
//! further choice that does. In a part in which they reach all gears, any further element is tried.

mod decide;

use crate::choices::choose;
use crate::equal::Equal;
use crate::library::Library;
use crate::motion::{Element, Motion, elements};
use crate::parts::{Grid, Parts};
use crate::ratio::Ratio;
use crate::rules::may_be;
use crate::solve::can_match;
use crate::structure::Structure;
use crate::table::{Functions, Table, members};
use crate::tally::Tally;
use crate::ternary::Word;
use crate::watch::Watch;
use crate::wish::Wish;
use rustc_hash::{FxHashMap, FxHashSet};

/// A set of elements with all gears.
#[derive(Debug, Clone, PartialEq)]
pub struct Solution {
    /// Pairs of links that each element may join; the pairs of an element all lock the same.
    pub elements: Vec<Vec<Element>>,
    /// Ring-to-sun ratios with which all gears are within their bounds.
    pub k: Vec<f64>,
    /// Sets with equal `k`, if the wish requires them.
    pub equal: Equal,
    /// The gears in the order of the wish.
    pub gears: Vec<Gear>,
}

/// A gear of a solution.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Gear {
    /// Ratio of the gear as a formula.
    pub ratio: Ratio,
    /// The elements that it engages, by their places: each choice that gives this ratio.
    pub engaged: Vec<Vec<usize>>,
}

/// A search through structures of one class. The functions learned are kept from one structure to the next.
pub struct Search<W> {
    wish: Wish,
    engaged: usize,
    motion: Motion<W>,
    /// Pairs of links that an element may join.
    pairs: Vec<Element>,
    library: Library<W>,
    /// Every choice of sets with equal `k`, and the parts in which they can be.
    equals: Vec<(Equal, Parts)>,
    /// The parts in which some can be.
    open: Parts,
    /// Pairs of gears, the first with the higher ratio.
    falling: Vec<[usize; 2]>,
    tally: Tally,
    /// The functions of the structure.
    table: Table<W>,
    /// The pairs that each element of the structure may join.
    elements: Vec<Vec<Element>>,
    /// Whether the wish bounds the numbers of brakes and clutches.
    counts_brakes: bool,
    /// Elements that can only be brakes, and elements that can only be clutches, as bits.
    alone: [u64; 2],
    /// Gears, those with the fewest choices first.
    order: Vec<usize>,
    /// Chosen elements, and the parts in which the search continued from them.
    visited: FxHashMap<u64, Parts>,
    /// Full sets of elements that were evaluated.
    seen: FxHashSet<u64>,
    /// Full sets of elements with the parts in which each gear can have a function.
    candidates: Vec<(u64, Parts)>,
    /// Sets of functions, used again.
    room: Vec<Functions>,
    /// The gears that functions reach in a part, used again.
    reached: Vec<u32>,
}

impl<W: Word> Search<W> {
    /// Prepares a search through structures with this number of links and one set for each range of `wish.k`.
    #[must_use]
    pub fn new(wish: Wish, links: usize) -> Self {
        let sets = wish.k.len();
        let engaged = links - sets - 1;
        let pairs = elements(links);
        let library = Library::new(wish.gears.clone(), Grid::new(&wish.k));
        let equals: Vec<(Equal, Parts)> = Equal::choices(wish.equal_k, sets, wish.double_planets)
            .into_iter()
            .map(|equal| (equal, equal.parts(library.grid())))
            .collect();
        Self {
            engaged,
            motion: Motion::new(links - sets),
            table: Table::new(engaged, pairs.len(), wish.gears.len()),
            pairs,
            library,
            open: equals.iter().fold(Parts::default(), |all, (_, parts)| all.or(*parts)),
            equals,
            falling: wish.falling(),
            tally: Tally::default(),
            elements: Vec::new(),
            counts_brakes: wish.rules.counts_brakes(wish.elements),
            alone: [0; 2],
            order: Vec::new(),
            visited: FxHashMap::default(),
            seen: FxHashSet::default(),
            candidates: Vec::new(),
            room: Vec::new(),
            reached: Vec::new(),
            wish,
        }
    }

    /// Takes the counts since the last call.
    pub fn take_tally(&mut self) -> Tally {
        std::mem::take(&mut self.tally)
    }

    /// Approximate memory of what the search has learned, in bytes.
    #[must_use]
    pub fn bytes(&self) -> usize {
        self.library.bytes()
    }

    /// Solutions of a structure; of those that an automorphism makes equal, one.
    pub fn structure(&mut self, structure: &Structure) -> Vec<Solution> {
        self.solutions(structure, &Watch::new(&|| false))
    }

    /// Solutions of a structure, as by `structure`. `None` if `ended`, which is called now and then, ends the
    /// search before all are found; then the structure is not counted.
    pub fn structure_unless(
        &mut self,
        structure: &Structure,
        ended: &dyn Fn() -> bool,
    ) -> Option<Vec<Solution>> {
        let (before, watch) = (self.tally, Watch::new(ended));
        let found = self.solutions(structure, &watch);
        if watch.is_over() {
            self.tally = before;
            return None;
        }
        Some(found)
    }

    fn solutions(&mut self, structure: &Structure, watch: &Watch<'_>) -> Vec<Solution> {
        self.tally.structures += 1;
        self.take(structure, watch);
        let gears = 0..self.wish.gears.len();
        if gears.clone().any(|gear| self.table.reaching(gear).is_empty()) {
            return Vec::new();
        }
        self.tally.in_reach += 1;
        self.order.clear();
        self.order.extend(gears);
        self.order.sort_by_key(|gear| self.table.choices_for(*gear));
        self.visited.clear();
        self.seen.clear();
        self.candidates.clear();
        self.grow(0, self.open, watch);
        let candidates = std::mem::take(&mut self.candidates);
        let symmetries = if candidates.is_empty() { Vec::new() } else { self.symmetries(structure) };
        let mut found = Vec::new();
        for (chosen, parts) in &candidates {
            if watch.is_over() {
                break;
            }
            let least = symmetries.iter().all(|places| image(*chosen, places) >= *chosen);
            if least {
                found.extend(self.decide(*chosen, *parts, watch));
            }
        }
        self.candidates = candidates;
        found
    }

    /// Permutations of the elements by the structure's automorphisms other than the identity.
    fn symmetries(&self, structure: &Structure) -> Vec<Vec<usize>> {
        let automorphisms = structure.automorphisms();
        // The ranges of k move with the sets.
        let keeps_ranges = |order: &&Vec<usize>| {
            order.iter().enumerate().all(|(place, set)| self.wish.k[place] == self.wish.k[*set])
        };
        let of = |order: &Vec<usize>| {
            let names = structure.renaming(order);
            let image = |element: &Vec<Element>| {
                let mut pair = element[0].map(|link| names[usize::from(link)]);
                pair.sort_unstable();
                self.elements.iter().position(|pairs| pairs.contains(&pair))
            };
            self.elements.iter().filter_map(image).collect::<Vec<_>>()
        };
        automorphisms.iter().skip(1).filter(keeps_ranges).map(of).collect()
    }

    /// Takes up a structure: its elements, the function of each choice of them, and the lists of the gears.
    fn take(&mut self, structure: &Structure, watch: &Watch<'_>) {
        self.motion.take(structure, &self.pairs);
        let mut kept: Vec<usize> = Vec::new();
        self.elements.clear();
        for (place, pair) in self.pairs.iter().enumerate() {
            match kept.iter().position(|other| self.motion.tie_the_same(place, *other)) {
                Some(element) => self.elements[element].push(*pair),
                None => {
                    kept.push(place);
                    self.elements.push(vec![*pair]);
                }
            }
        }
        self.motion.keep(&kept);
        self.alone = [1, 0].map(|other| {
            let alone = (0..kept.len()).filter(|element| !may_be(&self.elements[*element])[other]);
            alone.fold(0, |all, element| all | 1 << element)
        });
        self.table.take(self.engaged, kept.len(), &mut self.motion, &mut self.library, watch);
    }

    /// Goes on from chosen elements, in those of some parts where this was not done before.
    fn grow(&mut self, chosen: u64, parts: Parts, watch: &Watch<'_>) {
        if watch.is_over() {
            return;
        }
        let missing = self.wish.elements - chosen.count_ones() as usize;
        if missing == 0 {
            if self.seen.insert(chosen) {
                let mut functions = self.room.pop().unwrap_or_default();
                self.table.functions_of(chosen, &mut functions);
                if self.table.may_have_all(&functions) {
                    self.complete(chosen, &functions);
                }
                self.room.push(functions);
            }
            return;
        }
        if !self.keeps_rules(chosen) {
            return;
        }
        let done = self.visited.entry(chosen).or_default();
        let mut parts = parts.without(*done);
        if parts.is_empty() {
            return;
        }
        let first = done.is_empty();
        *done = done.or(parts);
        if missing == 1 {
            // Trying every last element is quicker than asking which the parts allow, and is done once.
            if first {
                self.add_last(chosen);
            }
            return;
        }
        let mut functions = self.room.pop().unwrap_or_default();
        self.table.functions_of(chosen, &mut functions);
        parts = parts.and(self.promising(chosen, &functions));
        for place in 0..self.order.len() {
            if parts.is_empty() {
                break;
            }
            let gear = self.order[place];
            let covered = self.table.covered(&functions, gear);
            let open = parts.without(covered);
            for place in 0..self.table.reaching(gear).len() {
                let function = self.table.reaching(gear)[place];
                let open = open.and(self.table.reach(function, gear));
                if open.is_empty() {
                    continue;
                }
                for choice in 0..self.table.having(function).len() {
                    let choice = self.table.having(function)[choice];
                    // Without as many elements as may still come nothing may be left of it.
                    let left = (0..missing).fold(choice & !chosen, |left, _| left & left.wrapping_sub(1));
                    if left == 0 {
                        self.grow(chosen | choice, open, watch);
                    }
                }
            }
            parts = parts.and(covered);
        }
        self.room.push(functions);
        if !parts.is_empty() {
            self.add_any(chosen, parts, watch);
        }
    }

    /// Adds each further element.
    fn add_any(&mut self, chosen: u64, parts: Parts, watch: &Watch<'_>) {
        for element in 0..self.elements.len() {
            if chosen >> element & 1 == 0 {
                self.grow(chosen | 1 << element, parts, watch);
            }
        }
    }

    /// Whether elements, with others, may have as many brakes and clutches as the wish allows.
    fn keeps_rules(&self, chosen: u64) -> bool {
        if !self.counts_brakes {
            return true;
        }
        let [brakes, clutches] = self.alone.map(|alone| (chosen & alone).count_ones() as usize);
        self.wish.rules.brakes_of(self.wish.elements, brakes, clutches).is_some()
    }

    /// Notes with which last elements chosen ones are candidates.
    fn add_last(&mut self, chosen: u64) {
        let (mut known, mut added) =
            (self.room.pop().unwrap_or_default(), self.room.pop().unwrap_or_default());
        self.table.functions_of(chosen, &mut known);
        self.table.added(chosen, &mut added);
        for (element, functions) in added.chunks_exact_mut(self.table.words() + 1).enumerate() {
            let functions = &mut functions[..known.len()];
            functions.iter_mut().zip(&known).for_each(|(one, other)| *one |= other);
            let with = chosen | 1 << element;
            if with != chosen && self.table.may_have_all(functions) && self.seen.insert(with) {
                self.complete(with, functions);
            }
        }
        self.room.extend([known, added]);
    }

    /// Parts in which chosen elements may belong to a solution. Every gear needs a function of its own, and
    /// each choice with an element that is not chosen yet can give one.
    fn promising(&self, chosen: u64, functions: &[u64]) -> Parts {
        let known = choose(chosen.count_ones() as usize, self.engaged);
        let more = choose(self.wish.elements, self.engaged) - known;
        let least = self.wish.gears.len().saturating_sub(more);
        at_least(self.table.useful(functions), least)
    }

    /// Notes a full set of elements, with these functions, as a candidate, where some parts have all gears.
    fn complete(&mut self, chosen: u64, functions: &[u64]) {
        if !self.keeps_rules(chosen) {
            return;
        }
        let parts = self.parts_with_all(functions);
        if !parts.is_empty() {
            self.candidates.push((chosen, parts));
        }
    }

    /// The parts in which each gear is in reach of a function of its own.
    fn parts_with_all(&mut self, functions: &[u64]) -> Parts {
        let gears = self.wish.gears.len();
        // As many functions that reach some gear as there are gears: of the simple conditions the strongest.
        let mut parts = self.open.and(at_least(self.table.useful(functions), gears));
        for gear in &self.order {
            if parts.is_empty() {
                return parts;
            }
            parts = parts.and(self.table.covered(functions, *gear));
        }
        let matched = |part: &usize| {
            self.reached.clear();
            self.reached.extend(members(functions).map(|function| self.table.reached_in(function, *part)));
            can_match(&self.reached, gears)
        };
        parts.iter().filter(matched).collect()
    }
}

/// Elements after a permutation of them.
fn image(chosen: u64, places: &[usize]) -> u64 {
    places
        .iter()
        .enumerate()
        .filter(|(element, _)| chosen >> element & 1 == 1)
        .fold(0, |all, (_, place)| all | 1 << place)
}

/// Parts held by at least this number of some sets of parts: their numbers are added up bit by bit, for all
/// parts at once.
fn at_least(sets: impl Iterator<Item = Parts>, least: usize) -> Parts {
    if least == 0 {
        return Parts::ALL;
    }
    let mut planes = [Parts::default(); 10];
    let mut used = 0;
    for mut carry in sets {
        for (place, plane) in planes.iter_mut().enumerate() {
            if carry.is_empty() {
                break;
            }
            used = used.max(place + 1);
            let both = plane.and(carry);
            *plane = plane.xor(carry);
            carry = both;
        }
    }
    if least >> used != 0 {
        return Parts::default();
    }
    // Compares from the highest bit down: larger so far, or equal so far.
    let (mut larger, mut equal) = (Parts::default(), Parts::ALL);
    for place in (0..used).rev() {
        if least >> place & 1 == 1 {
            equal = equal.and(planes[place]);
        } else {
            larger = larger.or(equal.and(planes[place]));
            equal = equal.without(planes[place]);
        }
    }
    larger.or(equal)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_of_parts_are_those_of_plain_counting() {
        let sets: Vec<Parts> =
            (0..11).map(|step| (0..256).filter(|part| (part * 7 + step * 13) % 5 < 2).collect()).collect();
        for least in 0..13 {
            let plain: Parts = (0..256)
                .filter(|part| sets.iter().filter(|set| set.contains(*part)).count() >= least)
                .collect();
            assert_eq!(at_least(sets.iter().copied(), least), plain, "at least {least}");
        }
    }
}
