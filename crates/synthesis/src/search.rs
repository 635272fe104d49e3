//! All sets of elements of a structure that have the wanted gears.
//!
//! # Steps
//! 1. Elements that lock the same are one. Each choice of `e` elements has a function, from the library.
//! 2. Elements are chosen for the gears in turn, the gear with the fewest choices first, in all parts of the range of `k` at
//!    once, up to as many elements as may be.
//! 3. A full set of elements stays a candidate in the parts in which each gear can have a function of its own.
//! 4. In each such part a point is sought, or proved not to be there ([`solve`](crate::solve)).
//!
//! Where some sets of one kind have to have equal `k`, steps 2 and 3 keep to the parts that hold such points, and step 4 is taken for
//! each choice of these sets ([`equal`](crate::equal)).
//!
//! # Why nothing is lost
//! Steps 2 and 3 leave out what a part does not allow by the signs at its corners, which hold everywhere in it. Step 2 splits by
//! parts: in a part where the chosen elements do not reach a gear, a solution must have a further choice that does; where they
//! reach all gears, any further element is tried.

use crate::choices::choose;
use crate::equal::Equal;
use crate::library::Library;
use crate::motion::{Element, Motion, elements};
use crate::parts::{Grid, Parts, places};
use crate::ratio::Ratio;
use crate::rules::may_be;
use crate::shifts::fewest;
use crate::solve::{Function, Outcome, Solver, can_match};
use crate::structure::Structure;
use crate::table::{Functions, Local, Table, members};
use crate::tally::Tally;
use crate::ternary::Word;
use crate::wish::{Wish, forward};
use rustc_hash::{FxHashMap, FxHashSet};

/// A set of elements with all gears.
#[derive(Debug, Clone, PartialEq)]
pub struct Solution {
    /// For each element the pairs of links that it may join, all of which lock the same.
    pub elements: Vec<Vec<Element>>,
    /// Ring-to-sun ratios with which all gears are within their bounds.
    pub k: Vec<f64>,
    /// Which of them are equal, where the wish asks for it.
    pub equal: Equal,
    /// The gears in the order of the wish.
    pub gears: Vec<Gear>,
}

/// A gear of a solution.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Gear {
    /// Its ratio as a formula.
    pub ratio: Ratio,
    /// The elements that it engages, by their places: each choice that gives this ratio.
    pub engaged: Vec<Vec<usize>>,
}

/// A search through structures of one class. What it learns of functions is kept from one structure to the next.
pub struct Search<W> {
    wish: Wish,
    engaged: usize,
    motion: Motion<W>,
    /// All pairs of links.
    pairs: Vec<Element>,
    library: Library<W>,
    /// Every choice of sets with equal `k`, and the parts in which they can be.
    equals: Vec<(Equal, Parts)>,
    /// The parts in which some can be.
    open: Parts,
    /// Pairs of gears of which the first has the higher ratio.
    falling: Vec<[usize; 2]>,
    tally: Tally,
    /// The functions of the structure.
    table: Table<W>,
    /// The pairs that each element of the structure may join.
    elements: Vec<Vec<Element>>,
    /// Whether the wish bounds the numbers of brakes and clutches.
    counts_brakes: bool,
    /// Those that can be brakes alone, and those that can be clutches alone, as bits.
    alone: [u64; 2],
    /// Gears, those with the fewest choices first.
    order: Vec<usize>,
    /// Chosen elements, and the parts in which they were gone on from.
    visited: FxHashMap<u64, Parts>,
    /// Full sets of elements that were looked at.
    seen: FxHashSet<u64>,
    /// Full sets of elements with the parts in which each gear can have a function.
    candidates: Vec<(u64, Parts)>,
    /// Sets of functions, used again.
    room: Vec<Functions>,
    /// The gears that functions reach in a part, used again.
    reached: Vec<u32>,
}

impl<W: Word> Search<W> {
    /// For structures of so many sets, with `wish.k` for each, and links.
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

    /// What was searched since the last call.
    pub fn take_tally(&mut self) -> Tally {
        std::mem::take(&mut self.tally)
    }

    /// About how many bytes it holds of what it learned.
    #[must_use]
    pub fn bytes(&self) -> usize {
        self.library.bytes()
    }

    /// All solutions of a structure; of those that an automorphism makes equal, one.
    pub fn structure(&mut self, structure: &Structure) -> Vec<Solution> {
        self.tally.structures += 1;
        self.take(structure);
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
        self.grow(0, self.open);
        let candidates = std::mem::take(&mut self.candidates);
        let symmetries = if candidates.is_empty() { Vec::new() } else { self.symmetries(structure) };
        let mut found = Vec::new();
        for (chosen, parts) in &candidates {
            let least = symmetries.iter().all(|places| image(*chosen, places) >= *chosen);
            if least {
                found.extend(self.decide(*chosen, *parts));
            }
        }
        self.candidates = candidates;
        found
    }

    /// How the structure's automorphisms, but the identity, permute its elements.
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
    fn take(&mut self, structure: &Structure) {
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
        self.table.take(self.engaged, kept.len(), &mut self.motion, &mut self.library);
    }

    /// Goes on from chosen elements, in those of some parts where this was not done before.
    fn grow(&mut self, chosen: u64, parts: Parts) {
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
                        self.grow(chosen | choice, open);
                    }
                }
            }
            parts = parts.and(covered);
        }
        self.room.push(functions);
        if !parts.is_empty() {
            self.add_any(chosen, parts);
        }
    }

    /// Adds each further element.
    fn add_any(&mut self, chosen: u64, parts: Parts) {
        for element in 0..self.elements.len() {
            if chosen >> element & 1 == 0 {
                self.grow(chosen | 1 << element, parts);
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

    /// The parts in which chosen elements may belong to a solution: so many gears need so many functions, of which each choice
    /// with an element that is not chosen yet can give one.
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

    /// The solution of a candidate, if it has all gears at one point; where several choices of sets with equal `k` have such points, with
    /// the one that has the least deviation at its best.
    fn decide(&mut self, chosen: u64, parts: Parts) -> Option<Solution> {
        self.tally.candidates += 1;
        let mut locals: Vec<Local> = Vec::new();
        let mut choices: Vec<Vec<u64>> = Vec::new();
        self.table.for_each_choice(chosen, &mut |function, choice| match locals
            .iter()
            .position(|known| *known == function)
        {
            Some(place) => choices[place].push(choice),
            None => {
                locals.push(function);
                choices.push(vec![choice]);
            }
        });
        let (mut found, mut missed, mut undecided) = (Vec::new(), None, false);
        for place in 0..self.equals.len() {
            let (equal, on_it) = self.equals[place];
            let mut choices = choices.clone();
            if equal != Equal::NONE {
                // Where input or output stand still wherever these k are equal, there is no ratio, whatever is left of the formula.
                let motion = &mut self.motion;
                let mut drives = |choice: &u64| {
                    let speeds = motion.gear(&places(*choice).collect::<Vec<_>>());
                    !equal.vanishes(speeds.input) && !equal.vanishes(speeds.output)
                };
                choices.iter_mut().for_each(|choices| choices.retain(&mut drives));
            }
            match self.decide_with(chosen, parts.and(on_it), equal, &locals, &choices) {
                Verdict::Solution(solution) => found.push(solution),
                Verdict::Misses(demand) => missed = missed.max(Some(demand)),
                Verdict::Undecided => undecided = true,
                Verdict::None => {}
            }
        }
        if found.is_empty() {
            match missed {
                Some(1) => self.tally.reducible += 1,
                Some(2) => self.tally.without_direct += 1,
                Some(_) => self.tally.without_single_shifts += 1,
                None => self.tally.undecided += u64::from(undecided),
            }
        }
        self.best(found)
    }

    /// Of solutions that differ in which `k` are equal the one with the least deviation at its best.
    fn best(&self, mut found: Vec<Solution>) -> Option<Solution> {
        if found.len() <= 1 {
            return found.pop();
        }
        let deviation = |solution: &Solution| {
            let ratios: Vec<Ratio> = solution.gears.iter().map(|gear| gear.ratio).collect();
            self.wish.refine(&ratios, &solution.k, solution.equal).deviation
        };
        let deviations: Vec<f64> = found.iter().map(deviation).collect();
        let best = (0..found.len()).min_by(|one, other| deviations[*one].total_cmp(&deviations[*other]))?;
        Some(found.swap_remove(best))
    }

    /// A point and functions of which those of gears side by side fall at the best `k`, too, if some exchange of them does: the best `k` of
    /// all exchanges are one, since any ratio of these gears is as good. Else the same as given.
    fn falling_at_best(
        &self,
        k: Vec<f64>,
        assigned: Vec<usize>,
        equal: Equal,
        ratios: &[Ratio],
        accept: Demand<'_>,
    ) -> (Vec<f64>, Vec<usize>) {
        let of = |assigned: &[usize]| assigned.iter().map(|function| ratios[*function]).collect::<Vec<_>>();
        let best = self.wish.refine(&of(&assigned), &k, equal).k;
        let mut sorted = assigned.clone();
        for run in &self.wish.side_by_side {
            let mut functions: Vec<usize> = run.iter().map(|gear| assigned[*gear]).collect();
            functions.sort_by(|one, other| ratios[*other].value(&best).total_cmp(&ratios[*one].value(&best)));
            run.iter().zip(functions).for_each(|(gear, function)| sorted[*gear] = function);
        }
        let values: Vec<f64> = of(&sorted).iter().map(|ratio| ratio.value(&best)).collect();
        let within = values.iter().zip(&self.wish.gears).all(|(value, gear)| gear.contain(*value));
        if sorted != assigned && within && self.wish.are_falling(&values) && accept(&sorted) {
            (best, sorted)
        } else {
            (k, assigned)
        }
    }

    /// What a candidate comes to in some parts with some `k` equal, by its functions and, for each, the choices that have it.
    fn decide_with(
        &self,
        chosen: u64,
        parts: Parts,
        equal: Equal,
        locals: &[Local],
        choices: &[Vec<u64>],
    ) -> Verdict {
        let sets = self.wish.k.len();
        let ratio = |function: &Local| self.library.ratio(self.table.number(*function));
        let functions: Vec<Function> =
            locals.iter().map(|function| Function::with_equal(ratio(function), sets, equal)).collect();
        let functions: Vec<&Function> = functions.iter().collect();
        let every = (1usize << self.wish.k.len()) - 1;
        let moves_all = |assigned: &[usize]| {
            assigned.iter().fold(0, |all, function| all | functions[*function].ratio.variables()) == every
        };
        let engages_all = |assigned: &[usize]| {
            assigned.iter().flat_map(|function| &choices[*function]).fold(0, |all, choice| all | choice)
                == chosen
        };
        let rules = &self.wish.rules;
        let is_direct =
            |assigned: &[usize]| assigned.iter().any(|function| functions[*function].ratio == Ratio::ONE);
        let forward = forward(&self.wish.gears);
        let shifts = |assigned: &[usize]| {
            let choices: Vec<&[u64]> =
                forward.iter().map(|gear| choices[assigned[*gear]].as_slice()).collect();
            fewest(&choices, rules.shifts).is_some()
        };
        // What functions have to keep, in the order in which a set that misses it is counted.
        let demands: [Demand<'_>; 4] =
            [&engages_all, &moves_all, &|assigned| !rules.direct || is_direct(assigned), &|assigned| {
                !rules.shifts.bind() || shifts(assigned)
            }];
        // Functions that are one where these k are equal are not two gears.
        let are_apart = |assigned: &[usize]| {
            equal == Equal::NONE
                || self.falling.iter().all(|[higher, lower]| {
                    let [one, other] = [higher, lower].map(|gear| functions[assigned[*gear]].ratio);
                    !equal.makes_equal(one, other)
                })
        };
        let mut undecided = false;
        let mut missed = [false; 4];
        // The first so many demands kept: a point with functions, and which demand others missed first.
        let mut seek = |kept: usize| {
            let mut accept =
                |assigned: &[usize]| match demands[..kept].iter().position(|keep| !keep(assigned)) {
                    None => are_apart(assigned),
                    Some(first) => {
                        missed[first] = true;
                        false
                    }
                };
            let mut solver = Solver::new(&functions, &self.wish.gears, &mut accept)
                .with_equal(equal)
                .with_falling(&self.falling);
            let found = parts.iter().find_map(|part| {
                let gears = locals.iter().zip(choices).map(|(function, choices)| {
                    if choices.is_empty() { 0 } else { self.table.reached_in(*function, part) }
                });
                match solver.search_among(&self.library.grid().part(part), gears) {
                    Outcome::Found { k, functions } => Some((k, functions)),
                    Outcome::None => None,
                    Outcome::Undecided => {
                        undecided = true;
                        None
                    }
                }
            });
            (found, missed)
        };
        let (found, missed) = seek(demands.len());
        let Some((k, assigned)) = found else {
            // Functions that missed a demand were passed over: have they a point?
            let without =
                (1..demands.len()).rev().find(|demand| missed[*demand] && seek(*demand).0.is_some());
            return match without {
                Some(demand) => Verdict::Misses(demand),
                None if undecided => Verdict::Undecided,
                None => Verdict::None,
            };
        };
        let (k, assigned) = if self.falling.is_empty() {
            (k, assigned)
        } else {
            let ratios: Vec<Ratio> = functions.iter().map(|function| function.ratio).collect();
            self.falling_at_best(k, assigned, equal, &ratios, &|assigned| {
                demands.iter().all(|keep| keep(assigned)) && are_apart(assigned)
            })
        };
        let places: Vec<usize> = places(chosen).collect();
        let by_places =
            |choice: &u64| (0..places.len()).filter(|place| choice >> places[*place] & 1 == 1).collect();
        let gear = |function: &usize| Gear {
            ratio: functions[*function].ratio,
            engaged: choices[*function].iter().map(by_places).collect(),
        };
        let gears = assigned.iter().map(gear).collect();
        let mut elements: Vec<Vec<Element>> =
            places.iter().map(|place| self.elements[*place].clone()).collect();
        rules.order(&mut elements);
        Verdict::Solution(Solution { elements, k, equal, gears })
    }
}

/// What a candidate comes to.
enum Verdict {
    /// It has all gears.
    Solution(Solution),
    /// It has all gears, but not with the demand of this number.
    Misses(usize),
    /// Neither a point nor the proof that there is none.
    Undecided,
    /// There is no point.
    None,
}

/// What functions together have to keep.
type Demand<'a> = &'a dyn Fn(&[usize]) -> bool;

/// Elements after a permutation of them.
fn image(chosen: u64, places: &[usize]) -> u64 {
    places
        .iter()
        .enumerate()
        .filter(|(element, _)| chosen >> element & 1 == 1)
        .fold(0, |all, (_, place)| all | 1 << place)
}

/// The parts that at least so many of some sets of parts hold: their numbers are added up bit by bit, for all parts at
/// once.
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
