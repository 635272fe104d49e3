//! Trains in the order of their bounds, until the first are sized in full.

use super::stage::{Behind, RANGE, Stages};
use super::{FirstPair, Found, Order, Teeth, Train, Trains};
use crate::Error;
use crate::bounded::{Cost, Geometries, TriedSet};
use crate::sizing::SetTeeth;
use epicyclic_gears::ToothCount;
use epicyclic_gears::teeth::gcd;
use epicyclic_numerics::threads::{map, map_while};
use std::cmp::Reverse;
use std::collections::{BinaryHeap, HashMap};
use std::ops::{Add, ControlFlow, Range};

/// Growth of the bound up to which trains are listed, from one round to the next.
const GROWTH: f64 = 1.06;

/// Price over the least bound up to which trains are listed in rounds; then all with as many stages beyond
/// usual practice.
const HEAVIEST: f64 = 2.0;

/// Stages that are sized at most.
const MOST: u64 = 3000;

/// Trains that are listed at most at a time.
const MOST_LISTED: usize = 2_000_000;

/// Bounds up to which trains are listed, round by round; the last has no end.
fn levels(first: Cost, stages: usize) -> impl Iterator<Item = Cost> {
    let prices = move || {
        let all = std::iter::successors(Some(first.price * GROWTH), |price| Some(price * GROWTH));
        all.take_while(move |price| *price < HEAVIEST * first.price)
    };
    let levels = (0..=stages).flat_map(move |more| {
        prices().map(move |price| Cost { unusual: first.unusual + more as f64, price, ..first })
    });
    levels.chain([Cost { unusual: f64::INFINITY, price: f64::INFINITY, ..first }])
}

/// Trials and gears of sets, which do not depend on their torques: several searches share them if their orders
/// differ in numbers of stages, ratios by some per cent, torques and tooth numbers alone.
#[derive(Debug, Default)]
pub struct KnownSets {
    tried: HashMap<SetTeeth, Option<TriedSet>>,
    geometries: Geometries,
}

/// The best `most` trains of each number of stages, unless `goes_on`, which is called now and then, breaks.
/// It uses the sets that are known and adds others.
///
/// # Errors
/// [`Error::NothingToSearch`] for a space without modules, face widths or planets; [`Error::Cancelled`]; those
/// of [`size`](crate::sizing::size).
pub fn search(
    order: &Order,
    most: usize,
    known: &mut KnownSets,
    goes_on: &dyn Fn() -> ControlFlow<()>,
) -> Result<Found, Error> {
    order.of_stage.space.check()?;
    let stages = Stages::new(order);
    let all = order.candidates();
    let is_new = |teeth: &&SetTeeth| !known.tried.contains_key(*teeth);
    let new: Vec<SetTeeth> = all.iter().filter(is_new).copied().collect();
    let tried = map_while(&new, goes_on, |teeth| stages.stage(*teeth)).ok_or(Error::Cancelled)?;
    for (teeth, tried) in new.into_iter().zip(tried) {
        known.tried.insert(teeth, tried?);
    }
    let mut sets: Vec<TriedSet> = all.iter().filter_map(|teeth| known.tried[teeth].clone()).collect();
    // Pairs are behind all sets.
    let is_pair = |set: &TriedSet| set.teeth.is_pair();
    sets.sort_by(|one, other| is_pair(one).cmp(&is_pair(other)).then(one.ratio.total_cmp(&other.ratio)));
    let table = Table::new(&stages, &sets, *order.stages.end());
    let (in_range, exact, geometries) = (HashMap::new(), HashMap::new(), &mut known.geometries);
    let mut search = Search { stages, sets, table, count: 1, in_range, exact, geometries, sized: 0, goes_on };
    let mut all = vec![];
    for count in order.stages.clone().filter(|count| *count > 0) {
        search.count = count;
        search.sized = 0;
        let (found, is_complete) = search.best(most)?;
        let trains = search.trains();
        all.push(Trains { stages: count, trains, sized: search.sized, is_complete, found });
    }
    Ok(Found { sets: search.sets.len(), all })
}

impl Order {
    /// Sets, and pairs for the first stage, whose ratio can be part of a train.
    fn candidates(&self) -> Vec<SetTeeth> {
        let sets = self.teeth.all();
        let ends = ends_of(&sets).unwrap_or([1.0; 2]);
        let pairs = self.first_pair.as_ref().map_or_else(Vec::new, |pair| pair.all(self.teeth.is_hunting));
        let of_first = if self.first_pair.is_some() { ends_of(&pairs) } else { Some(ends) };
        let Some(of_first) = of_first else { return vec![] };
        let fits = |own: f64, [least, most]: [f64; 2]| {
            own * least <= *self.ratio.end() && own * most >= *self.ratio.start()
        };
        let is_part = |teeth: &SetTeeth| {
            let behind_pair = self.first_pair.is_some() && !teeth.is_pair();
            let (known, first) = if behind_pair { (2, of_first) } else { (1, [1.0; 2]) };
            // Least and greatest product of the other stages.
            let others = |sets: usize| [0, 1].map(|end| first[end] * libm::pow(ends[end], sets as f64));
            let mut left = self.stages.clone().filter_map(|stages| stages.checked_sub(known));
            left.any(|sets| fits(teeth.ratio(), others(sets)))
        };
        sets.into_iter().chain(pairs).filter(is_part).collect()
    }
}

impl FirstPair {
    /// Pairs within the bounds of tooth numbers.
    fn all(&self, is_hunting: bool) -> Vec<SetTeeth> {
        let mut all = vec![];
        for pinion in self.pinions.clone() {
            for wheel in self.wheels.clone() {
                let ratio = f64::from(wheel) / f64::from(pinion);
                if !self.ratio.contains(&ratio) || is_hunting && gcd(u64::from(pinion), u64::from(wheel)) > 1
                {
                    continue;
                }
                if let [Ok(pinion), Ok(wheel)] = [pinion, wheel].map(ToothCount::new) {
                    all.push(SetTeeth::Pair([pinion, wheel]));
                }
            }
        }
        all
    }
}

impl Teeth {
    /// Least and greatest ratio of one stage; `None` if the bounds leave no set.
    #[must_use]
    pub fn ratios(&self) -> Option<[f64; 2]> {
        ends_of(&self.all())
    }

    /// Sets within the bounds of tooth numbers.
    fn all(&self) -> Vec<SetTeeth> {
        let mut all = vec![];
        for sun in self.suns.clone() {
            for planet in self.planets.clone() {
                for offset in self.ring_offsets.clone() {
                    let ring = i64::from(sun) + 2 * i64::from(planet) + i64::from(offset);
                    let Ok(ring) = u32::try_from(ring) else { continue };
                    let k = f64::from(ring) / f64::from(sun);
                    if !self.rings.contains(&ring) || !self.ring_to_sun_ratio.contains(&k) {
                        continue;
                    }
                    if self.is_hunting
                        && [sun, ring].iter().any(|of| gcd(u64::from(planet), u64::from(*of)) > 1)
                    {
                        continue;
                    }
                    let teeth = [sun, planet, ring].map(ToothCount::new);
                    if let [Ok(sun), Ok(planet), Ok(ring)] = teeth {
                        all.push(SetTeeth::Simple([sun, planet, ring]));
                    }
                }
            }
        }
        all
    }
}

/// Least and greatest ratio of these sets; `None` without sets.
fn ends_of(sets: &[SetTeeth]) -> Option<[f64; 2]> {
    let ratios = sets.iter().map(SetTeeth::ratio).map(|ratio| [ratio; 2]);
    ratios.reduce(|[least, most], [ratio, _]| [least.min(ratio), most.max(ratio)])
}

/// Bounds of stages and of the rest of a train, by the range of the product of the ratios before them.
struct Table {
    /// By range and set.
    own: Vec<Vec<Option<Cost>>>,
    /// By number of stages that are left, less one, and range.
    rest: Vec<Vec<Option<Cost>>>,
    /// Ratios of the sets, ascending, and behind them those of the pairs.
    ratios: Vec<f64>,
    /// Number of sets.
    sets: usize,
    /// Places of what the first stage may be: the pairs of an order that asks for one, or the sets.
    first: Range<usize>,
    allowed: [f64; 2],
}

/// Ends of a range of products.
fn ends(range: usize) -> [f64; 2] {
    [range, range + 1].map(|power| libm::pow(RANGE, power as f64))
}

/// Range of a product.
fn range(product: f64) -> usize {
    (libm::log(product) / libm::log(RANGE)).floor().max(0.0) as usize
}

impl Table {
    fn new(stages: &Stages<'_>, sets: &[TriedSet], most: usize) -> Self {
        let allowed = [*stages.order.ratio.start(), *stages.order.ratio.end()];
        // A product lies below the end of its range; rounding may put it into a neighbour.
        let ranges = range(allowed[1]) + 2;
        let bound = |set: &TriedSet, before: [f64; 2]| {
            let is_part = before[0] * set.ratio <= allowed[1] && (before[0] == 1.0 || !set.teeth.is_pair());
            is_part.then(|| stages.bound(set, before)).flatten()
        };
        let of_sets = sets.iter().take_while(|set| !set.teeth.is_pair()).count();
        let first = if stages.order.first_pair.is_some() { of_sets..sets.len() } else { 0..of_sets };
        let bounds = |of: &usize| sets.iter().map(|set| bound(set, ends(*of))).collect();
        let all: Vec<usize> = (0..ranges).collect();
        let mut table = Self {
            own: map(&all, bounds),
            rest: vec![],
            ratios: sets.iter().map(|set| set.ratio).collect(),
            sets: of_sets,
            first,
            allowed,
        };
        for left in 1..most {
            let rest = (0..ranges).map(|of| table.bound_of(0..of_sets, left, of)).collect();
            table.rest.push(rest);
        }
        table
    }

    /// The bound of `left` stages behind a range of products, the next of them at one of these places.
    fn bound_of(&self, next: Range<usize>, left: usize, of: usize) -> Option<Cost> {
        let [least, most] = ends(of);
        let costs = self.ratios[next.clone()].iter().zip(&self.own[of][next]).filter_map(|(ratio, own)| {
            let own = (*own)?;
            let products = [least * ratio, most * ratio];
            if left == 1 {
                return (products[0] <= self.allowed[1] && products[1] >= self.allowed[0]).then_some(own);
            }
            let behind = &self.rest[left - 2];
            let ranges = range(products[0])..=range(products[1]);
            ranges.filter_map(|range| *behind.get(range)?).min().map(|rest| own + rest)
        });
        costs.min()
    }
}

/// A train in the queue with a bound below its cost.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
struct Queued {
    cost: Cost,
    sets: Vec<usize>,
}

/// How far the cost of a stage is known.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Known {
    /// By its trial.
    Tried,
    /// Sized for the least load of a range of products.
    InRange,
    /// Sized for its own load.
    Sized,
}

/// A stage of a train.
#[derive(Debug, Clone, Copy)]
struct Place {
    set: usize,
    /// Product of the ratios before it.
    before: f64,
    /// Ratio of the train.
    ratio: f64,
}

struct Search<'a> {
    stages: Stages<'a>,
    sets: Vec<TriedSet>,
    table: Table,
    /// Number of stages.
    count: usize,
    /// Cost of a set behind a range of products.
    in_range: HashMap<(usize, usize), Option<Cost>>,
    /// Cost of a set behind a product, and where rings turn in a train of a ratio, in bits.
    exact: HashMap<(usize, u64, u64), Option<Cost>>,
    geometries: &'a mut Geometries,
    sized: u64,
    goes_on: &'a dyn Fn() -> ControlFlow<()>,
}

impl Search<'_> {
    /// Trains within the allowed ratios.
    fn trains(&self) -> u64 {
        let Table { ratios, sets, first, .. } = &self.table;
        let products = |first: &[f64], sets_behind: usize| {
            (0..sets_behind).fold(first.to_vec(), |all, _| {
                all.iter().flat_map(|one| ratios[..*sets].iter().map(move |ratio| one * ratio)).collect()
            })
        };
        let others = self.count - 1;
        let mut behind: Vec<f64> = products(&[1.0], others.div_ceil(2));
        behind.sort_by(f64::total_cmp);
        let [least, most] = self.table.allowed;
        let fitting = |product: f64| {
            let from = behind.partition_point(|other| product * other < least);
            behind.partition_point(|other| product * other <= most).saturating_sub(from) as u64
        };
        products(&ratios[first.clone()], others / 2).into_iter().map(fitting).sum()
    }

    /// Lists the trains whose bound lies above one cost and not above another, behind some first stages.
    fn list(
        &self,
        sets: &mut Vec<usize>,
        (product, cost): (f64, Cost),
        within: [Cost; 2],
        all: &mut Vec<Queued>,
    ) {
        let left = self.count - sets.len();
        let [least, most] = self.table.allowed;
        let ratios = &self.table.ratios;
        let next = if sets.is_empty() { self.table.first.clone() } else { 0..self.table.sets };
        let places = match left {
            1 => {
                let own = &ratios[next.clone()];
                let from = next.start + own.partition_point(|ratio| product * ratio < least);
                from..(next.start + own.partition_point(|ratio| product * ratio <= most)).max(from)
            }
            _ => next,
        };
        let own = &self.table.own[range(product)];
        for place in places {
            if all.len() >= MOST_LISTED {
                return;
            }
            let Some(own) = own[place] else { continue };
            let (product, cost) = (product * ratios[place], cost + own);
            sets.push(place);
            if left == 1 {
                if cost > within[0] && cost <= within[1] {
                    all.push(Queued { cost, sets: sets.clone() });
                }
            } else if let Some(rest) = self.table.rest[left - 2].get(range(product)).copied().flatten()
                && cost + rest <= within[1]
            {
                self.list(sets, (product, cost), within, all);
            }
            sets.pop();
        }
    }

    /// Key of the load of a stage. Rings that turn have the speed of the output, so the ratio of the train is in it.
    fn key(&self, Place { set, before, ratio }: Place) -> (usize, u64, u64) {
        let ratio = if self.stages.order.rings_turn { ratio } else { 0.0 };
        (set, before.to_bits(), ratio.to_bits())
    }

    /// Cost of a stage as far as it is known; `None` if nothing holds.
    fn cost(&self, place: Place) -> (Option<Cost>, Known) {
        let of = range(place.before);
        if let Some(cost) = self.exact.get(&self.key(place)) {
            (*cost, Known::Sized)
        } else if let Some(cost) = self.in_range.get(&(place.set, of)) {
            (*cost, Known::InRange)
        } else {
            (self.table.own[of][place.set], Known::Tried)
        }
    }

    /// Gets to know more of a stage.
    fn learn(&mut self, place: Place, known: Known) -> Result<(), Error> {
        if (self.goes_on)().is_break() {
            return Err(Error::Cancelled);
        }
        self.sized += 1;
        let stage = &self.sets[place.set];
        let of = range(place.before);
        // The first stage has one load, unless its ring turns as the output.
        if known == Known::Tried && (of > 0 || self.stages.order.rings_turn) {
            let behind = Behind::Any(ends(of));
            let cost = self.stages.size(stage, behind, self.geometries, self.goes_on)?;
            self.in_range.insert((place.set, of), cost);
        } else {
            let behind = Behind::One { before: place.before, ratio: place.ratio };
            let cost = self.stages.size(stage, behind, self.geometries, self.goes_on)?;
            self.exact.insert(self.key(place), cost);
        }
        Ok(())
    }

    /// Products of the ratios before each stage, and the ratio.
    fn products(&self, sets: &[usize]) -> Vec<f64> {
        let mut all = vec![1.0];
        for set in sets {
            all.push(all[all.len() - 1] * self.table.ratios[*set]);
        }
        all
    }

    /// The best trains, in order, and whether no other can be better.
    fn best(&mut self, most: usize) -> Result<(Vec<Train>, bool), Error> {
        let mut found: Vec<Train> = vec![];
        let Some(first) = self.table.bound_of(self.table.first.clone(), self.count, 0) else {
            return Ok((found, true));
        };
        let mut is_whole = true;
        let mut listed = Cost { unusual: -1.0, ..Cost::default() };
        let mut queue: BinaryHeap<Reverse<Queued>> = BinaryHeap::new();
        for within in levels(first, self.count) {
            let mut all = vec![];
            self.list(&mut vec![], (1.0, Cost::default()), [listed, within], &mut all);
            listed = within;
            is_whole &= all.len() < MOST_LISTED;
            queue.extend(all.into_iter().map(Reverse));
            while queue.peek().is_some_and(|next| next.0.cost <= within) {
                let Some(Reverse(next)) = queue.pop() else { break };
                let most_unusual = self.stages.order.most_unusual.map_or(f64::INFINITY, f64::from);
                if next.cost.unusual > most_unusual {
                    return Ok((found, is_whole));
                }
                let products = self.products(&next.sets);
                let ratio = products[next.sets.len()];
                let place = |(set, before): (&usize, &f64)| Place { set: *set, before: *before, ratio };
                let places: Vec<Place> = next.sets.iter().zip(&products).map(place).collect();
                let known: Vec<(Option<Cost>, Known)> = places.iter().map(|of| self.cost(*of)).collect();
                let Some(costs) = known.iter().map(|(cost, _)| *cost).collect::<Option<Vec<Cost>>>() else {
                    continue;
                };
                let cost = costs.into_iter().fold(Cost::default(), Add::add);
                if cost > next.cost {
                    queue.push(Reverse(Queued { cost, ..next }));
                    continue;
                }
                // The last stages are the heaviest: they tell most.
                let least = known.iter().enumerate().rev().min_by_key(|(_, (_, known))| *known);
                match least {
                    Some((place, (_, known))) if *known < Known::Sized => {
                        if self.sized >= MOST {
                            return Ok((found, false));
                        }
                        self.learn(places[place], *known)?;
                        queue.push(Reverse(next));
                    }
                    _ => found.push(self.train(&next, ratio)),
                }
                if found.len() == most {
                    return Ok((found, is_whole));
                }
            }
        }
        Ok((found, is_whole))
    }

    fn train(&self, of: &Queued, ratio: f64) -> Train {
        Train {
            stages: of.sets.iter().map(|set| self.sets[*set].teeth).collect(),
            ratio,
            unusual_stages: of.cost.unusual as u32,
            rules_missed: of.cost.missed,
            mass_kg: of.cost.mass,
            price_kg: of.cost.price - self.stages.order.of_stage.space.length_price * of.cost.length,
            length_m: of.cost.length,
        }
    }
}
