//! Tooth numbers around a solution: every choice within limits that keeps each gear within its bounds.
//!
//! # Steps
//! 1. The tooth numbers of a simple set are those of [`epicyclic_gears::synthesis::Bounds`]: equal centre
//!    distances, assembly, clearance between planets. Sets that differ only in the number of planets are one,
//!    with the most planets. The tooth numbers of a double-planet set are those of
//!    [`epicyclic_gears::double_planet`]. Of the pairs of planets that fit a sun and a ring,
//!    [`double_planet_choices`](synthesis::Bounds::double_planet_choices) takes one, since ratios do not
//!    depend on it. Simple sets with profile shift ([`Choice::shifted`]) are those that
//!    [`epicyclic_gears::involute::search`] closes. Of the planets that fit a sun and a ring one is taken,
//!    since ratios do not depend on it either.
//! 2. The choices are put into the ratios set by set, which leaves polynomials in the `k` of the other sets.
//!    The box of these `k` is shrunk by the signs of `P − gQ` at its corners, which hold everywhere in it. A
//!    box without a point ends the branch.
//! 3. A full choice is decided by its ratios as fractions: `P` and `Q` are whole numbers over the suns'
//!    teeth, also with `k′ = (z_ring − z_sun)/z_sun` of double-planet sets.
//!
//! So nothing is lost. Step 2 leaves out what no `k` within the bounds can have, widened by 10⁻⁹. Step 3
//! accepts a ratio that is off its bound by the rounding of one division.

use crate::Error;
use crate::parts::{Bounds, Cuboid};
use crate::ratio::{Polynomial, Ratio};
pub use crate::set_teeth::SetTeeth;
use crate::sharing::Compound;
use crate::tolerance::WIDENING;
use crate::watch::Watch;
use epicyclic_gears::ToothCount;
use epicyclic_gears::involute::left_out::LeftOut;
use epicyclic_gears::involute::search::ProfileShift;
use epicyclic_gears::simple_set::Fraction;
use epicyclic_gears::synthesis::{self, ToothNumbers};
#[cfg(feature = "parallel")]
use rayon::iter::{IntoParallelRefIterator as _, ParallelIterator as _};
use rustc_hash::FxHashMap;
use std::cmp::Reverse;
use std::collections::BTreeMap;
use std::ops::RangeInclusive;

/// Largest number of boxes for one solution, some ten seconds of work.
pub const MOST_BOXES: u64 = 30_000_000;

/// Objective for the best tooth numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Aim {
    /// The least greatest deviation of a ratio, by half its bounds' width; of equal ones the fewest teeth.
    #[default]
    Deviation,
    /// The fewest teeth of all suns and rings; of equal ones the least deviation.
    Teeth,
}

/// Least number of sets that must be alike; 0 and 1 require nothing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Alike {
    /// Sets with equal rings.
    pub rings: usize,
    /// Sets with equal suns.
    pub suns: usize,
    /// Sets of one kind with equal suns and rings.
    pub sets: usize,
}

impl Alike {
    /// Whether some chosen sets, with `left` still to be chosen, can be alike as required.
    fn can_be(self, chosen: &[&SetTeeth], left: usize) -> bool {
        fn most<T: PartialEq>(of: impl Fn(usize) -> T, count: usize) -> usize {
            let alike = |one: usize| (0..count).filter(|other| of(*other) == of(one)).count();
            (0..count).map(alike).max().unwrap_or(0)
        }
        let count = chosen.len();
        let enough = |wanted: usize, most: usize| wanted <= 1 || most + left >= wanted;
        let of = |set: usize| chosen[set];
        enough(self.rings, most(|set| of(set).ring(), count))
            && enough(self.suns, most(|set| of(set).sun(), count))
            && enough(
                self.sets,
                most(|set| (of(set).is_double_planet(), of(set).sun(), of(set).ring()), count),
            )
    }
}

/// Required ratios of the gears.
#[derive(Debug, Clone, Copy)]
pub struct Gears<'a> {
    /// The bounds of each gear's ratio.
    pub bounds: &'a [Bounds],
    /// Gears side by side, as of a [`Wish`](crate::wish::Wish): their ratios fall, and any within the bounds
    /// is as good.
    pub side_by_side: &'a [Vec<usize>],
}

impl<'a> Gears<'a> {
    /// Gears without any side by side.
    #[must_use]
    pub const fn apart(bounds: &'a [Bounds]) -> Self {
        Self { bounds, side_by_side: &[] }
    }

    fn is_side_by_side(&self, gear: usize) -> bool {
        self.side_by_side.iter().any(|run| run.contains(&gear))
    }

    /// Whether the ratios of gears side by side fall, as fractions.
    fn are_falling(&self, ratios: &[[i128; 2]]) -> bool {
        let at = |gear: usize| ratios.get(gear).map(|[above, below]| Fraction::new(*above, *below));
        self.side_by_side.iter().flat_map(|run| run.windows(2)).all(|pair| at(pair[0]) > at(pair[1]))
    }
}

/// Tooth numbers of all sets.
#[derive(Debug, Clone, PartialEq)]
pub struct Design {
    /// Tooth numbers of each set.
    pub sets: Vec<SetTeeth>,
    /// The ratio of each gear.
    pub ratios: Vec<Fraction>,
    /// The greatest deviation of a ratio, by half its bounds' width; that of gears side by side does not
    /// count.
    pub deviation: f64,
}

impl Design {
    /// Teeth of all suns and rings.
    #[must_use]
    pub fn teeth(&self) -> u32 {
        self.sets.iter().map(|set| set.sun().get() + set.ring().get()).sum()
    }
}

/// The tooth numbers found.
#[derive(Debug, Clone, PartialEq)]
pub struct Designs {
    /// Number of designs found.
    pub count: u64,
    /// Whether all were found: at most [`MOST_BOXES`] boxes were needed.
    pub complete: bool,
    /// The best, best first.
    pub first: Vec<Design>,
}

/// Tooth numbers of all sets to choose from.
#[derive(Debug, Clone, Copy)]
pub struct Sets<'a> {
    /// Tooth numbers of each set.
    pub choices: &'a [&'a Choice],
    /// The sets that share planets.
    pub compounds: &'a [Compound],
    /// Bounds of the planets that they share.
    pub bounds: Option<&'a synthesis::Bounds>,
}

impl<'a> Sets<'a> {
    /// Sets that share no planets.
    #[must_use]
    pub const fn apart(choices: &'a [&'a Choice]) -> Self {
        Self { choices, compounds: &[], bounds: None }
    }
}

/// Tooth numbers of a set to choose from, by rising `k`.
#[derive(Debug, Clone, PartialEq)]
pub struct Choice {
    sets: Vec<SetTeeth>,
    left_out: Option<Box<LeftOut>>,
}

impl Choice {
    /// Simple sets within bounds whose gears can be cut and turned together, each pair of sun and ring once.
    ///
    /// # Errors
    /// [`Error::Teeth`] for bounds that nothing can keep.
    pub fn within(bounds: &synthesis::Bounds) -> Result<Self, Error> {
        let mut by_teeth: BTreeMap<_, ToothNumbers> = BTreeMap::new();
        for set in bounds.tooth_numbers().map_err(Error::Teeth)? {
            let known = by_teeth.entry((set.sun, set.ring)).or_insert(set);
            known.planets = known.planets.max(set.planets);
        }
        let (mut sets, mut left_out) = (vec![], None);
        for set in by_teeth.into_values() {
            if bounds.can_turn(&set, &mut left_out).map_err(Error::Teeth)? {
                sets.push(SetTeeth::Simple(set));
            }
        }
        Ok(Self { left_out, ..Self::sorted(sets) })
    }

    /// Simple sets with profile shift within bounds, each pair of sun and ring once. Of the planets with
    /// which a pair closes, the one with the least offset of the ring is taken, of two with equal offsets the
    /// smaller. The number of planets is the largest that fits.
    ///
    /// # Errors
    /// [`Error::Teeth`] for bounds, offsets and limits that nothing can keep.
    pub fn shifted(bounds: &synthesis::Bounds, shift: &ProfileShift) -> Result<Self, Error> {
        let search = shift.within(bounds);
        search.check().map_err(Error::Teeth)?;
        let suns: Vec<u32> = bounds.sun.clone().collect();
        #[cfg(feature = "parallel")]
        let suns = suns.par_iter();
        #[cfg(not(feature = "parallel"))]
        let suns = suns.iter();
        let of_suns = suns.map(|sun| search.of_sun(ToothCount::new(*sun)?, |_, _| true));
        let of_suns: Vec<_> = of_suns.collect::<Result<_, _>>().map_err(Error::Teeth)?;
        let mut by_teeth: BTreeMap<_, ToothNumbers> = BTreeMap::new();
        for set in of_suns.into_iter().flatten() {
            let key = |set: &ToothNumbers| (set.ring_offset().abs(), set.planet, Reverse(set.planets));
            let known = by_teeth.entry((set.sun, set.ring)).or_insert(set);
            if key(&set) < key(known) {
                *known = set;
            }
        }
        Ok(Self::sorted(by_teeth.into_values().map(SetTeeth::Simple).collect()))
    }

    /// Double-planet sets within bounds, each pair of sun and ring once. The bounds of the ratio are those of
    /// the real `k`.
    ///
    /// # Errors
    /// [`Error::Teeth`] for bounds that nothing can keep.
    pub fn of_double_planets(bounds: &synthesis::Bounds) -> Result<Self, Error> {
        let (all, left_out) = bounds.double_planet_choices().map_err(Error::Teeth)?;
        Ok(Self { left_out, ..Self::sorted(all.into_iter().map(SetTeeth::DoublePlanet).collect()) })
    }

    fn sorted(mut all: Vec<SetTeeth>) -> Self {
        all.sort_by(|one, other| one.k_of_word().total_cmp(&other.k_of_word()));
        Self { sets: all, left_out: None }
    }

    /// Number of tooth numbers to choose from.
    #[must_use]
    pub fn count(&self) -> usize {
        self.sets.len()
    }

    /// Pairs of sun and ring without profile shift that are left out since a check of their teeth does not
    /// hold.
    #[must_use]
    pub fn left_out(&self) -> Option<&LeftOut> {
        self.left_out.as_deref()
    }

    /// Tooth numbers within a range, also those that rounding, as of `k − 1`, leaves just outside.
    fn between(&self, [least, most]: [f64; 2]) -> &[SetTeeth] {
        let slack = |end: f64| 4.0 * f64::EPSILON * (1.0 + end);
        let from = self.sets.partition_point(|set| set.k_of_word() < least - slack(least));
        let to = self.sets.partition_point(|set| set.k_of_word() <= most + slack(most));
        &self.sets[from.min(to)..to]
    }
}

/// Finds all tooth numbers with which gears of these ratios are within their bounds, and fall if they are
/// side by side; the best `most` are listed. Each set has its range of `k`, for a double-planet set of `k′`,
/// and its tooth numbers to choose from. Sets that share planets have equal teeth on a common gear, and
/// planets that fit all of them. The result is not complete if `ended`, which is called now and then, ends
/// the trial.
///
/// # Panics
/// Unless there are as many choices as ranges.
#[must_use]
pub fn designs(
    ratios: &[Ratio],
    gears: Gears,
    ranges_of_k: &[RangeInclusive<f64>],
    from: Sets,
    (alike, aim, most): (Alike, Aim, usize),
    ended: &dyn Fn() -> bool,
) -> Designs {
    let sets = ranges_of_k.len();
    assert_eq!(from.choices.len(), sets, "each set has its choice");
    let mut search = Search {
        ratios,
        gears,
        widened: gears.bounds.iter().map(|gear| gear.widened()).collect(),
        from,
        planets: vec![FxHashMap::default(); from.compounds.len()],
        alike,
        aim,
        most,
        sets,
        boxes: 0,
        watch: Watch::new(ended),
        found: Designs { count: 0, complete: true, first: Vec::new() },
    };
    let functions: Vec<[Vec<f64>; 2]> = ratios
        .iter()
        .map(|ratio| {
            [ratio.numerator, ratio.denominator]
                .map(|of| (0..1 << sets).map(|product| f64::from(of.coefficient(product))).collect())
        })
        .collect();
    let cuboid = ranges_of_k.iter().map(|range| [*range.start(), *range.end()]).collect();
    search.go(&functions, cuboid, &mut Vec::new());
    search.found
}

/// Sets with common planets by their suns and rings; `None` if no planets fit.
type SharedPlanets = FxHashMap<Vec<[ToothCount; 2]>, Option<Vec<SetTeeth>>>;

struct Search<'a> {
    ratios: &'a [Ratio],
    gears: Gears<'a>,
    widened: Vec<Bounds>,
    from: Sets<'a>,
    /// Sets with common planets of each compound set, by their suns and rings.
    planets: Vec<SharedPlanets>,
    alike: Alike,
    aim: Aim,
    most: usize,
    sets: usize,
    boxes: u64,
    watch: Watch<'a>,
    found: Designs,
}

impl<'a> Search<'a> {
    /// Chooses the first set of the remaining box, whose polynomials are these.
    fn go(&mut self, functions: &[[Vec<f64>; 2]], mut cuboid: Cuboid, chosen: &mut Vec<&'a SetTeeth>) {
        if cuboid.is_empty() {
            return self.decide(chosen);
        }
        if self.boxes >= MOST_BOXES || self.watch.is_over() {
            self.found.complete = false;
            return;
        }
        self.boxes += 1;
        if !shrink(functions, &self.widened, &mut cuboid) {
            return;
        }
        let choice = self.from.choices[chosen.len()];
        for set in choice.between(cuboid[0]) {
            chosen.push(set);
            if self.alike.can_be(chosen, self.sets - chosen.len())
                && self.from.compounds.iter().all(|compound| compound.agree(chosen))
            {
                let k = set.k_of_word();
                let rest: Vec<[Vec<f64>; 2]> =
                    functions.iter().map(|of| of.each_ref().map(|of| put_in(of, k))).collect();
                self.go(&rest, cuboid[1..].to_vec(), chosen);
            }
            chosen.pop();
        }
    }

    /// Takes a full choice whose ratios are within their bounds.
    fn decide(&mut self, chosen: &[&SetTeeth]) {
        let mut ratios = Vec::with_capacity(self.ratios.len());
        let mut deviation: f64 = 0.0;
        for (place, (ratio, gear)) in self.ratios.iter().zip(self.gears.bounds).enumerate() {
            let (above, below) = (whole(ratio.numerator, chosen), whole(ratio.denominator, chosen));
            if below == 0 {
                return;
            }
            let value = above as f64 / below as f64;
            let slack = 4.0 * f64::EPSILON * value.abs();
            if !(gear.least - slack <= value && value <= gear.most + slack) {
                return;
            }
            if !self.gears.is_side_by_side(place) {
                let [middle, half] = gear.middle_and_half();
                deviation = deviation.max((value - middle).abs() / half);
            }
            ratios.push([above, below]);
        }
        if !self.gears.are_falling(&ratios) {
            return;
        }
        let Some(chosen) = self.with_common_planets(chosen) else { return };
        self.found.count += 1;
        let ratios = || ratios.iter().map(|[above, below]| Fraction::new(*above, *below)).collect();
        let first = &mut self.found.first;
        let teeth: u32 = chosen.iter().map(|set| set.sun().get() + set.ring().get()).sum();
        let aim = self.aim;
        let comes_after = |other: &Design| {
            let by_deviation = other.deviation.total_cmp(&deviation);
            let by_teeth = other.teeth().cmp(&teeth);
            let order = match aim {
                Aim::Deviation => by_deviation.then(by_teeth),
                Aim::Teeth => by_teeth.then(by_deviation),
            };
            order.is_gt()
        };
        // Of equal ones the first found stays first.
        let place = first.partition_point(|other| !comes_after(other));
        if place < self.most {
            first.insert(place, Design { sets: chosen, ratios: ratios(), deviation });
            first.truncate(self.most);
        }
    }
}

impl Search<'_> {
    /// A full choice with planets that fit all sets which share them; `None` if no planets fit.
    fn with_common_planets(&mut self, chosen: &[&SetTeeth]) -> Option<Vec<SetTeeth>> {
        let mut sets: Vec<SetTeeth> = chosen.iter().map(|set| **set).collect();
        let Some(bounds) = self.from.bounds else { return Some(sets) };
        for (compound, known) in self.from.compounds.iter().zip(&mut self.planets) {
            let key = compound.sets.iter().map(|set| [chosen[*set].sun(), chosen[*set].ring()]).collect();
            let fitted = known.entry(key).or_insert_with(|| compound.with_planets(chosen, bounds));
            for (set, teeth) in compound.sets.iter().zip(fitted.as_ref()?) {
                sets[*set] = *teeth;
            }
        }
        Some(sets)
    }
}

/// The polynomial in the other `k` that is left where the first has this value.
fn put_in(polynomial: &[f64], k: f64) -> Vec<f64> {
    polynomial.chunks_exact(2).map(|pair| pair[0] + k * pair[1]).collect()
}

/// A polynomial times the teeth of all suns: a whole number.
fn whole(polynomial: Polynomial, chosen: &[&SetTeeth]) -> i128 {
    let term = |product: usize| {
        let teeth = |(place, set): (usize, &&SetTeeth)| {
            i128::from(if product >> place & 1 == 1 { set.over_sun() } else { i64::from(set.sun().get()) })
        };
        i128::from(polynomial.coefficient(product)) * chosen.iter().enumerate().map(teeth).product::<i128>()
    };
    (0..1 << chosen.len()).map(term).sum()
}

/// Values of a polynomial at the corners of a box.
fn corners(polynomial: &[f64], cuboid: &[[f64; 2]]) -> Vec<f64> {
    let mut values = polynomial.to_vec();
    for (set, [least, most]) in cuboid.iter().enumerate() {
        for lower in (0..values.len()).filter(|corner| corner >> set & 1 == 0) {
            let (constant, slope) = (values[lower], values[lower | 1 << set]);
            values[lower] = constant + least * slope;
            values[lower | 1 << set] = constant + most * slope;
        }
    }
    values
}

/// Shrinks a box to where all gears can be within their bounds, while that shortens a side by a tenth; false
/// where they cannot anywhere.
fn shrink(functions: &[[Vec<f64>; 2]], gears: &[Bounds], cuboid: &mut Cuboid) -> bool {
    loop {
        let mut shortened = false;
        for ([numerator, denominator], gear) in functions.iter().zip(gears) {
            let (above, below) = (corners(numerator, cuboid), corners(denominator, cuboid));
            if !gear.is_reached(&above, &below) {
                return false;
            }
            let sign = if below.iter().all(|value| *value > 0.0) {
                1.0
            } else if below.iter().all(|value| *value < 0.0) {
                -1.0
            } else {
                continue;
            };
            for (bound, side) in [(gear.least, sign), (gear.most, -sign)] {
                let (above, below) = (corners(numerator, cuboid), corners(denominator, cuboid));
                let values: Vec<f64> =
                    above.iter().zip(&below).map(|(above, below)| side * (above - bound * below)).collect();
                let sides = (0..cuboid.len()).map(|set| where_positive(&values, set)).collect::<Vec<_>>();
                for (side, [first, last]) in cuboid.iter_mut().zip(sides) {
                    if first > last {
                        return false;
                    }
                    let [least, most] = *side;
                    // Points that rounding could cut off stay.
                    let lower = (least + first * (most - least)) * (1.0 - WIDENING);
                    let upper = (least + last * (most - least)) * (1.0 + WIDENING);
                    *side = [lower.max(least), upper.min(most)];
                    shortened |= side[1] - side[0] < 0.9 * (most - least);
                }
            }
        }
        if !shortened {
            return true;
        }
    }
}

/// Range along the edges of one side, from 0 to 1, in which a polynomial with these values at the corners is
/// anywhere at least 0.
fn where_positive(values: &[f64], set: usize) -> [f64; 2] {
    let (mut first, mut last) = (f64::INFINITY, f64::NEG_INFINITY);
    for corner in (0..values.len()).filter(|corner| corner >> set & 1 == 0) {
        let (begin, end) = (values[corner], values[corner | 1 << set]);
        if begin < 0.0 && end < 0.0 {
            continue;
        }
        let root = begin / (begin - end);
        first = first.min(if begin >= 0.0 { 0.0 } else { root });
        last = last.max(if end >= 0.0 { 1.0 } else { root });
    }
    [first, last]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gearbox::gearbox;
    use crate::structure::Structure;
    use epicyclic_gears::efficiency::MeshEfficiency;
    use epicyclic_gears::involute::closing::Closing;

    /// `1 + k₁`, `(1 + k₁ + k₂)/(1 + k₂)` and `−k₂`, as of a four-speed.
    fn four_speed() -> (Vec<Ratio>, Vec<Bounds>) {
        let polynomial = |products: &[usize], minus: bool| {
            let bits = products.iter().fold(0, |all, product| all | 1u64 << product);
            if minus { Polynomial { plus: 0, minus: bits } } else { Polynomial { plus: bits, minus: 0 } }
        };
        let ratio = |above: Polynomial, below: &[usize]| Ratio::new(above, polynomial(below, false)).unwrap();
        let ratios = vec![
            ratio(polynomial(&[0, 1], false), &[0]),
            ratio(polynomial(&[0, 1, 2], false), &[0, 2]),
            ratio(polynomial(&[2], true), &[0]),
        ];
        let around =
            |ratio: f64| Bounds { least: ratio - 0.02 * ratio.abs(), most: ratio + 0.02 * ratio.abs() };
        (ratios, vec![around(3.059), around(1.625), around(-2.294)])
    }

    fn few() -> Choice {
        let bounds = synthesis::Bounds { ring: 40..=90, planets: 3..=4, ..synthesis::Bounds::default() };
        Choice::within(&bounds).unwrap()
    }

    fn by_trial(choice: &Choice, alike: Alike, range: &RangeInclusive<f64>) -> Vec<[SetTeeth; 2]> {
        let (ratios, gears) = four_speed();
        let mut found = Vec::new();
        for one in &choice.sets {
            for two in &choice.sets {
                let k = [one.k_of_word(), two.k_of_word()];
                let within = k.iter().all(|k| range.contains(k))
                    && ratios.iter().zip(&gears).all(|(ratio, gear)| gear.contain(ratio.value(&k)))
                    && (alike.rings < 2 || one.ring() == two.ring())
                    && (alike.suns < 2 || one.sun() == two.sun())
                    && (alike.sets < 2 || (one.sun(), one.ring()) == (two.sun(), two.ring()));
                if within {
                    found.push([*one, *two]);
                }
            }
        }
        found
    }

    #[test]
    fn all_tooth_numbers_of_a_trial_are_found_and_no_others() {
        let (ratios, gears) = four_speed();
        let choice = few();
        let ranges = [1.4..=4.5, 1.4..=4.5];
        let alikes = [
            Alike::default(),
            Alike { rings: 2, ..Alike::default() },
            Alike { suns: 2, ..Alike::default() },
            Alike { sets: 2, ..Alike::default() },
        ];
        for (alike, some) in alikes.into_iter().zip([true, true, true, false]) {
            let found = designs(
                &ratios,
                Gears::apart(&gears),
                &ranges,
                Sets::apart(&[&choice; 2]),
                (alike, Aim::Deviation, usize::MAX),
                &|| false,
            );
            let mut teeth: Vec<[SetTeeth; 2]> =
                found.first.iter().map(|design| [design.sets[0], design.sets[1]]).collect();
            teeth.sort_unstable();
            let mut tried = by_trial(&choice, alike, &ranges[0]);
            tried.sort_unstable();
            assert_eq!(teeth, tried, "{alike:?}");
            assert_eq!((found.count, found.complete), (tried.len() as u64, true));
            assert_eq!(!tried.is_empty(), some, "{alike:?}");
        }
    }

    /// Against the closing of every sun, planet, ring and number of planets.
    #[test]
    fn each_pair_of_sun_and_ring_that_closes_is_a_choice_with_its_least_offset() {
        let bounds = synthesis::Bounds {
            sun: 17..=20,
            planet: 14..=38,
            ring: 60..=93,
            planets: 3..=4,
            ..synthesis::Bounds::default()
        };
        let shift = ProfileShift { offsets: -3..=3, closing: Closing::default() };
        let count = |teeth| ToothCount::new(teeth).unwrap();
        let mut expected = BTreeMap::new();
        for (sun, ring) in bounds.sun.clone().flat_map(|sun| bounds.ring.clone().map(move |ring| (sun, ring)))
        {
            for (planet, planets) in bounds.planet.clone().flat_map(|planet| [(planet, 3), (planet, 4)]) {
                let of = ToothNumbers { sun: count(sun), planet: count(planet), ring: count(ring), planets };
                if of.ring_offset().abs() > 3
                    || !(sun + ring).is_multiple_of(planets)
                    || shift.close(&of).is_err()
                {
                    continue;
                }
                let key = (of.ring_offset().abs(), planet, Reverse(planets));
                let least = expected.entry((sun, ring)).or_insert(key);
                *least = key.min(*least);
            }
        }
        let found: BTreeMap<_, _> = Choice::shifted(&bounds, &shift)
            .unwrap()
            .sets
            .into_iter()
            .map(|set| match set {
                SetTeeth::Simple(of) => {
                    let key = (of.ring_offset().abs(), of.planet.get(), Reverse(of.planets));
                    ((of.sun.get(), of.ring.get()), key)
                }
                SetTeeth::DoublePlanet(_) => panic!("a double-planet set"),
            })
            .collect();
        assert!(found.get(&(18, 93)) == Some(&(1, 37, Reverse(3))) && found == expected);
        let beyond = ProfileShift { offsets: -10..=3, ..shift };
        assert!(matches!(Choice::shifted(&bounds, &beyond), Err(Error::Teeth(_))));
    }

    #[test]
    fn the_best_are_the_first_of_all_by_either_aim() {
        let (ratios, gears) = four_speed();
        let (choice, ranges) = (few(), [1.4..=4.5, 1.4..=4.5]);
        for aim in [Aim::Deviation, Aim::Teeth] {
            let of = |most| {
                designs(
                    &ratios,
                    Gears::apart(&gears),
                    &ranges,
                    Sets::apart(&[&choice; 2]),
                    (Alike::default(), aim, most),
                    &|| false,
                )
            };
            let (all, five) = (of(usize::MAX), of(5));
            assert_eq!(five.first[..], all.first[..5]);
            assert_eq!(five.count, all.count);
            let rises =
                |key: fn(&Design) -> f64| all.first.windows(2).all(|two| key(&two[0]) <= key(&two[1]));
            match aim {
                Aim::Deviation => assert!(rises(|design| design.deviation)),
                Aim::Teeth => assert!(rises(|design| f64::from(design.teeth()))),
            }
        }
    }

    #[test]
    fn the_fractions_are_those_of_the_solver() {
        let (ratios, gears) = four_speed();
        let found = designs(
            &ratios,
            Gears::apart(&gears),
            &[1.4..=4.5, 1.4..=4.5],
            Sets::apart(&[&few(); 2]),
            (Alike::default(), Aim::Deviation, 3),
            &|| false,
        );
        // Links of the four-speed: 3 is a, 4 is b, 5 is c.
        let structure: Structure = "1-a-2 b-2-c".parse().unwrap();
        let elements = [[0, 4], [0, 5], [1, 4], [1, 5], [3, 5]];
        let engaged = [vec![1, 4], vec![0, 4], vec![1, 2]];
        for design in &found.first {
            let mut teeth = design.sets.iter();
            let gearbox = gearbox(&structure, &[2.0, 2.0], MeshEfficiency::IDEAL, &elements, &engaged)
                .unwrap()
                .to_builder()
                .map_sets(|set| teeth.next().unwrap().put_into(set))
                .build()
                .unwrap();
            for (gear, ratio) in gearbox.gears().iter().zip(&design.ratios) {
                assert_eq!(gearbox.analyze_gear(gear).unwrap().exact_ratio().as_ref(), Some(ratio));
            }
        }
    }

    #[test]
    fn a_ratio_with_a_pole_in_the_range_loses_nothing() {
        // i = 1/(k₁ − k₂): boxes on both sides of the pole.
        let one = Polynomial { plus: 1, minus: 0 };
        let ratio = Ratio::new(one, Polynomial { plus: 2, minus: 4 }).unwrap();
        let choice = few();
        for bounds in [Bounds { least: 3.001, most: 3.101 }, Bounds { least: -3.101, most: -3.001 }] {
            let found = designs(
                &[ratio],
                Gears::apart(&[bounds]),
                &[1.4..=4.5, 1.4..=4.5],
                Sets::apart(&[&choice; 2]),
                (Alike::default(), Aim::Teeth, 1),
                &|| false,
            );
            let in_range = choice.between([1.4, 4.5]);
            let is_within = |one: &SetTeeth, two: &SetTeeth| {
                bounds.contain(ratio.value(&[one.k_of_word(), two.k_of_word()]))
            };
            let tried: usize =
                in_range.iter().map(|one| in_range.iter().filter(|two| is_within(one, two)).count()).sum();
            assert_eq!(found.count, tried as u64);
            assert!(tried > 0);
        }
    }
}
