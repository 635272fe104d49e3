//! The lightest of many gearboxes of simple sets: schemes, tooth numbers and sizes chosen together.
//!
//! # Objective
//! First the number of sets with warnings by usual practice, and a gearbox with other warnings counts as one
//! set more; then the mass, a quarter more for each warning: of the gears, or by
//! [`Objective::Whole`] of gears, carriers and housing. Masses are sums over
//! the sets.
//!
//! # How the best gearbox is found
//! Each set has a bound below its cost, for the least of the loads that it has in any gearbox of its group.
//! All gearboxes are put in the order of the sums of these bounds. One set of the first gearbox is sized:
//! for the least load, later for its own. Its cost takes the place of its bound, and the gearbox goes back
//! into the queue. The gearbox that comes first with all sets sized is the best: no other has a lower bound.
//!
//! # Limit of the whole mass
//! A gearbox is left out once its parts beside the sets and the least masses of its sets, whatever rules they miss,
//! exceed the limit; one with all sets sized counts with their masses.

use crate::Error;
use crate::bounded::{Cost, Geometries, Load, Sets, TriedSet, greatest};
use crate::sizing::{Objective, SetOverload, SetStep, SetTeeth, Sizing, Space};
use crate::tolerance::MASS;
use epicyclic_units::Physical;
use std::cmp::Reverse;
use std::collections::{BinaryHeap, HashMap};
use std::ops::{Add, ControlFlow};

/// Sets that are sized at most.
const MOST: u64 = 3000;

/// Sets that are sized at most where a limit of the mass leaves none: most are left out by bounds.
const MOST_WITHIN: u64 = 400;

/// Sets that are sized at most for the best gearboxes of other groups than those found first.
const MOST_FOR_OTHERS: u64 = 40;

/// Set of a gearbox with its loads.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadedSet {
    /// Teeth of its gears.
    pub teeth: SetTeeth,
    /// Steps of the duty, as many as of every other set of the gearbox's group.
    pub duty: Vec<SetStep>,
    /// The overloads.
    pub overloads: Vec<SetOverload>,
}

/// Gearbox to choose from.
#[derive(Debug, Clone, PartialEq)]
pub struct Gearbox {
    /// Gearboxes of one group have the same sets in the same places; their ratios differ little.
    pub group: usize,
    /// Sets in their places.
    pub sets: Vec<LoadedSet>,
    /// Rules of usual practice that the gearbox misses besides those of its sets.
    pub rules_missed: u32,
    /// Mass of its parts beside gears, carriers and housing, in kg.
    pub others_kg: f64,
}

/// Number and limit of the gearboxes that are searched.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wanted {
    /// Number of the best gearboxes.
    pub most: usize,
    /// Greatest mass of the whole in kg; `None` without a limit.
    pub whole_kg: Option<f64>,
}

/// Gearbox with the cost of its sets at their best sizes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Costed {
    /// Place of the gearbox.
    pub place: usize,
    /// Sets beyond usual practice, and one more for a gearbox beyond it.
    pub unusual: u32,
    /// Rules of usual practice that sets and gearbox miss.
    pub rules_missed: u32,
    /// Mass in kg that the objective counts.
    pub mass_kg: f64,
    /// Mass with a quarter more for each rule missed, in kg.
    pub price_kg: f64,
    /// Mass of gears, carriers, housing and the other parts of the gearbox, in kg.
    pub whole_kg: f64,
}

/// Result of a search.
#[derive(Debug, Clone, PartialEq)]
pub struct Found {
    /// Sets that were sized.
    pub sized: u64,
    /// Whether no other gearbox can be better; false if the search ended early for its length.
    pub is_complete: bool,
    /// The best gearboxes, in order.
    pub best: Vec<Costed>,
    /// The best gearboxes of groups without one of these, in order, as far as a short search finds them.
    pub of_other_groups: Vec<Costed>,
    /// The lightest gearbox above the limit of the mass among those with all sets sized; where bounds alone leave
    /// out all, the best without the limit.
    pub above: Option<Costed>,
}

/// The best gearboxes that are wanted, unless `goes_on`, which is called now and then, breaks. `of_set` is a set
/// with materials, factors, requirements and space; its teeth, duty and overloads are not used.
///
/// # Errors
/// [`Error::NothingToSearch`] for a space without modules, face widths or planets; [`Error::Cancelled`]; those
/// of [`size`](crate::sizing::size).
pub fn lightest(
    of_set: &Sizing,
    gearboxes: &[Gearbox],
    Wanted { most, whole_kg }: Wanted,
    goes_on: &dyn Fn() -> ControlFlow<()>,
) -> Result<Found, Error> {
    of_set.space.check()?;
    let mut search = Search::new(of_set, gearboxes, goes_on)?;
    if whole_kg.is_some() {
        search.weigh();
    }
    let is_above = |mass: f64| whole_kg.is_some_and(|most| mass > most * (1.0 + MASS));
    let mut queue = BinaryHeap::new();
    for place in 0..gearboxes.len() {
        let bounds = search.known(place).into_iter().map(|(cost, _)| cost);
        queue.extend(search.whole(place, bounds).map(|cost| Reverse(Queued { cost, place })));
    }
    let mut found = Found::default();
    let mut others_from = None;
    while let Some(Reverse(next)) = queue.pop() {
        let group = gearboxes[next.place].group;
        let is_enough = found.best.len() >= most;
        let has = |all: &[Costed]| all.iter().any(|one| gearboxes[one.place].group == group);
        if is_enough && (has(&found.best) || has(&found.of_other_groups)) {
            continue;
        }
        let known = search.known(next.place);
        if is_above(search.least_mass(next.place)) {
            continue;
        }
        let costs = known.iter().map(|(cost, _)| *cost);
        let Some(cost) = search.whole(next.place, costs) else { continue };
        if cost > next.cost {
            queue.push(Reverse(Queued { cost, ..next }));
            continue;
        }
        let least = known.iter().enumerate().min_by_key(|(_, (_, known))| *known);
        match least {
            Some((set, (_, known))) if *known < Known::Sized => {
                let limit = match is_enough {
                    true => *others_from.get_or_insert(search.sized) + MOST_FOR_OTHERS,
                    false if found.best.is_empty() && whole_kg.is_some() => MOST_WITHIN,
                    false => MOST,
                };
                if search.sized >= limit {
                    found.is_complete = is_enough;
                    break;
                }
                search.learn(next.place, set, *known)?;
                queue.push(Reverse(next));
            }
            _ => {
                let costed = Costed {
                    place: next.place,
                    unusual: cost.unusual as u32,
                    rules_missed: cost.missed,
                    mass_kg: cost.mass,
                    price_kg: cost.price,
                    whole_kg: cost.whole + gearboxes[next.place].others_kg,
                };
                if is_above(costed.whole_kg) {
                    let least = found.above.is_none_or(|above| costed.whole_kg < above.whole_kg);
                    found.above = if least { Some(costed) } else { found.above };
                    continue;
                }
                if is_enough { &mut found.of_other_groups } else { &mut found.best }.push(costed);
            }
        }
    }
    found.sized = search.sized;
    if found.best.is_empty() && found.above.is_none() && whole_kg.is_some() {
        let free = lightest(of_set, gearboxes, Wanted { most: 1, whole_kg: None }, goes_on)?;
        found.above = free.best.first().copied();
        found.sized += free.sized;
    }
    Ok(found)
}

/// A gearbox in the queue with a bound below its cost.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Queued {
    cost: Cost,
    place: usize,
}

/// How far the cost of a set is known.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Known {
    /// By its trial.
    Tried,
    /// Sized for the least load of its group.
    Least,
    /// Sized for its own load.
    Sized,
}

impl Default for Found {
    /// Search without gearboxes.
    fn default() -> Self {
        Self { sized: 0, is_complete: true, best: vec![], of_other_groups: vec![], above: None }
    }
}

/// Set under the least of the loads that it has in the gearboxes of a group.
#[derive(Debug, Clone)]
struct Least {
    teeth: SetTeeth,
    duty: Vec<SetStep>,
    overloads: Vec<SetOverload>,
    load: Load,
    /// Bound, and cost for this load once it is sized; `None` if nothing holds.
    bound: Option<Cost>,
    sized: Option<Option<Cost>>,
    /// Mass of gears and structure that no size is below, whatever rules it misses, kg; 0 until it is weighed.
    mass: f64,
}

/// Group, place and teeth of a set.
type Key = (usize, usize, SetTeeth);

struct Search<'a> {
    gearboxes: &'a [Gearbox],
    sets: Sets<'a>,
    tried: HashMap<SetTeeth, Option<TriedSet>>,
    least: Vec<Least>,
    /// Places of the sets of each gearbox in `least`.
    of_gearbox: Vec<Vec<usize>>,
    /// Costs of sets for their own loads, by gearbox and place.
    own: HashMap<(usize, usize), Option<Cost>>,
    geometries: Geometries,
    sized: u64,
    goes_on: &'a dyn Fn() -> ControlFlow<()>,
}

impl<'a> Search<'a> {
    fn new(
        of_set: &'a Sizing,
        gearboxes: &'a [Gearbox],
        goes_on: &'a dyn Fn() -> ControlFlow<()>,
    ) -> Result<Self, Error> {
        let sets = Sets::new(of_set);
        let (mut places, mut least, mut of_gearbox) = (HashMap::<Key, usize>::new(), vec![], vec![]);
        for gearbox in gearboxes {
            let mut own = vec![];
            for (place, set) in gearbox.sets.iter().enumerate() {
                let at = *places.entry((gearbox.group, place, set.teeth)).or_insert(least.len());
                match least.get_mut(at) {
                    None => least.push(Least::of(set)),
                    Some(least) => least.lower(set),
                }
                own.push(at);
            }
            of_gearbox.push(own);
        }
        let mut by_teeth = HashMap::<SetTeeth, Vec<usize>>::new();
        for (place, one) in least.iter().enumerate().filter(|(_, one)| greatest(&one.duty) > 0.0) {
            by_teeth.entry(one.teeth).or_default().push(place);
        }
        let mut tried = HashMap::new();
        for (teeth, places) in by_teeth {
            if goes_on().is_break() {
                return Err(Error::Cancelled);
            }
            let duties: Vec<Vec<SetStep>> = places.iter().map(|place| least[*place].duty.clone()).collect();
            let set = sets.tried(teeth, duties)?;
            for (duty, place) in places.into_iter().enumerate() {
                let one = &mut least[place];
                one.load = Load { duty, ..sets.load(teeth, &one.duty) };
                one.bound = set.as_ref().and_then(|set| sets.bound(set, one.load));
            }
            tried.insert(teeth, set);
        }
        let (own, geometries) = (HashMap::new(), HashMap::new());
        Ok(Self { gearboxes, sets, tried, least, of_gearbox, own, geometries, sized: 0, goes_on })
    }

    /// Costs of the sets of a gearbox as far as they are known; `None` where nothing holds.
    fn known(&self, gearbox: usize) -> Vec<(Option<Cost>, Known)> {
        let of = |(place, least): (usize, &usize)| {
            let least = &self.least[*least];
            match (self.own.get(&(gearbox, place)), least.sized) {
                (Some(cost), _) => (*cost, Known::Sized),
                (None, Some(cost)) => (cost, Known::Least),
                (None, None) => (least.bound, Known::Tried),
            }
        };
        self.of_gearbox[gearbox].iter().enumerate().map(of).collect()
    }

    /// Finds the least masses of the sets.
    fn weigh(&mut self) {
        let of_set = self.sets.of_set;
        let space = Space { length_price: 0.0, ..of_set.space.clone() };
        let of_set = Sizing { practice: None, objective: Objective::Whole, space, ..of_set.clone() };
        let (sets, tried) = (Sets::new(&of_set), &self.tried);
        for one in self.least.iter_mut().filter(|one| one.bound.is_some()) {
            let set = tried.get(&one.teeth).and_then(Option::as_ref).map(TriedSet::unjudged);
            one.mass = set.and_then(|set| sets.bound(&set, one.load)).map_or(0.0, |cost| cost.whole);
        }
    }

    /// Mass of a whole gearbox, of sets that are not sized the least.
    fn least_mass(&self, gearbox: usize) -> f64 {
        let of = |(place, least): (usize, &usize)| match self.own.get(&(gearbox, place)) {
            Some(cost) => cost.map_or(0.0, |cost| cost.whole),
            None => self.least[*least].mass,
        };
        let sets = self.of_gearbox[gearbox].iter().enumerate().map(of);
        self.gearboxes[gearbox].others_kg + sets.sum::<f64>()
    }

    /// Cost of a gearbox; `None` if a set has none.
    fn whole(&self, gearbox: usize, costs: impl Iterator<Item = Option<Cost>>) -> Option<Cost> {
        let sum = costs.collect::<Option<Vec<Cost>>>()?.into_iter().fold(Cost::default(), Add::add);
        Some(sum.with_missed(self.gearboxes[gearbox].rules_missed))
    }

    /// Gets to know more of a set of a gearbox.
    fn learn(&mut self, gearbox: usize, place: usize, known: Known) -> Result<(), Error> {
        if (self.goes_on)().is_break() {
            return Err(Error::Cancelled);
        }
        self.sized += 1;
        let own = &self.gearboxes[gearbox].sets[place];
        let least = &self.least[self.of_gearbox[gearbox][place]];
        // A bound says that there is a trial.
        let Some(Some(set)) = self.tried.get(&own.teeth) else { return Ok(()) };
        // A set that has the least load alone is sized at once.
        let is_least = known == Known::Tried && !least.is_load_of(own);
        let (load, duty, overloads) = match is_least {
            true => (least.load, &least.duty, &least.overloads),
            false => {
                let load = Load { duty: least.load.duty, ..self.sets.load(own.teeth, &own.duty) };
                (load, &own.duty, &own.overloads)
            }
        };
        let loads = (duty.clone(), overloads.clone());
        let cost = self.sets.size(set, (load, is_least), loads, &mut self.geometries, self.goes_on)?;
        if is_least {
            self.least[self.of_gearbox[gearbox][place]].sized = Some(cost);
        } else {
            self.own.insert((gearbox, place), cost);
        }
        Ok(())
    }
}

impl Least {
    fn of(set: &LoadedSet) -> Self {
        let LoadedSet { teeth, duty, overloads } = set.clone();
        let load = Load { duty: 0, torque: 0.0, wear: [[0.0; 4]; 2], carrier_speed: 0.0 };
        Self { teeth, duty, overloads, load, bound: None, sized: None, mass: 0.0 }
    }

    /// Takes the lesser of each load.
    fn lower(&mut self, other: &LoadedSet) {
        for (own, other) in self.duty.iter_mut().zip(&other.duty) {
            own.lower(other);
        }
        for (own, other) in self.overloads.iter_mut().zip(&other.overloads) {
            own.sun_torque = own.sun_torque.abs().min(other.sun_torque.abs());
        }
    }

    /// Whether a set has this load, whatever the signs.
    fn is_load_of(&self, set: &LoadedSet) -> bool {
        let steps = self.duty.iter().zip(&set.duty).all(|(one, other)| {
            one.share == other.share
                && one.sun_torque.si().abs() == other.sun_torque.si().abs()
                && one.sun_speed.si().abs() == other.sun_speed.si().abs()
                && one.carrier_speed.si().abs() == other.carrier_speed.si().abs()
        });
        let torque = |one: &SetOverload| one.sun_torque.si().abs();
        steps && self.overloads.iter().map(torque).eq(set.overloads.iter().map(torque))
    }
}
