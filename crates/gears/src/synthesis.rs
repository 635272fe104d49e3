//! Tooth numbers of a simple set: *every* set of tooth numbers within bounds.
//!
//! ```text
//! equal centre distances      z_a + z_g = z_b − z_g
//! clearance between planets   (z_a + z_g)·sin(γ/2) > z_g + 2·h_a* + s      γ least angle between planets
//! assembly                    (z_a + z_b)/N integer, for equal spacing γ = 2π/N
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | `z_a`, `z_g`, `z_b` | teeth of sun, planet, ring | 1 |
//! | `N` | number of planets | 1 |
//! | `h_a*` | addendum coefficient | modules |
//! | `s` | required gap between the tip circles of adjacent planets | modules |
//!
//! Gears have no profile shift. [`ShiftedSearch`](crate::involute::search::ShiftedSearch) finds the sets that
//! deviate from `z_b = z_a + 2·z_g` by some teeth and close by profile shift.
//!
//! # Source
//! excavator-dynamics (1) and the conditions after it. Its condition of assembly is that `z_1·U/N·(1 + N·n)`
//! is an integer for some integer `n`. It is the condition above: `z_1·U = z_a + z_b`, and the factor is an
//! integer without a common divisor with `N`.

use crate::checks::not_negative;
use crate::involute::check::Check;
use crate::involute::left_out::LeftOut;
use crate::involute::plain;
use crate::mesh::{TipCircle, coaxial_ring};
pub(crate) use crate::nearest::Search;
pub use crate::nearest::check_tolerance;
use crate::quantity::SimpleGear;
use crate::rack::BasicRack;
use crate::simple_set::{BasicRatio, Fraction, Mode, exact_ratio};
use crate::spacing::PlanetSpacing;
use crate::teeth::ToothCount;
use crate::{Error, Quantity};
use epicyclic_units::Physical;
use std::f64::consts::PI;
use std::fmt;
use std::ops::{ControlFlow, RangeInclusive};

/// Tooth numbers and number of planets of a simple set that goes together.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ToothNumbers {
    /// Teeth of the sun, `z_a`.
    pub sun: ToothCount,
    /// Teeth of a planet, `z_g`.
    pub planet: ToothCount,
    /// Teeth of the ring, `z_b`.
    pub ring: ToothCount,
    /// Number of planets, `N`.
    pub planets: u32,
}

/// Sun, planet, ring and how many planets: `20/40/100 ×4`.
impl fmt::Display for ToothNumbers {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}/{} ×{}", self.sun, self.planet, self.ring, self.planets)
    }
}

impl ToothNumbers {
    /// Ring-to-sun ratio `k = z_b/z_a`.
    #[must_use]
    pub fn ring_to_sun_ratio(&self) -> f64 {
        self.ring.as_f64() / self.sun.as_f64()
    }

    /// Offset of the ring from equal centre distances without profile shift, `z_b − z_a − 2·z_g`.
    #[must_use]
    pub fn ring_offset(&self) -> i32 {
        let coaxial = i64::from(coaxial_ring(self.sun.get(), self.planet.get()));
        (i64::from(self.ring.get()) - coaxial) as i32
    }

    /// Planet-to-sun ratio `r = z_g/z_a`; without an offset of the ring it is `(k − 1)/2`, and computed so.
    #[must_use]
    pub fn planet_to_sun_ratio(&self) -> f64 {
        match self.ring_offset() {
            0 => (self.ring_to_sun_ratio() - 1.0) / 2.0,
            _ => self.planet.as_f64() / self.sun.as_f64(),
        }
    }

    /// A planet as its neighbours see it, in modules.
    #[must_use]
    pub fn planet_circle(&self, rack: &BasicRack) -> TipCircle {
        TipCircle::of_planet(self.sun, self.planet, rack)
    }

    /// Basic ratio `−z_b/z_a`.
    #[must_use]
    pub fn basic_ratio(&self) -> BasicRatio {
        BasicRatio::simple(self.sun, self.ring)
    }
}

/// Placement of the planets.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "names", derive(clap::ValueEnum))]
pub enum Placement {
    /// Equal angles only.
    #[default]
    Equal,
    /// The assembly positions nearest to equal angles, where equal angles do not assemble.
    LeastUnequal,
}

/// Bounds of the search for sets of tooth numbers.
///
/// All ranges include their ends. By default sun and planet have 12 teeth and more, the ring up to 200, and
/// `k` is from 1.3 to 10. There are 3 to 8 equally spaced planets, the standard addendum, and tips that just
/// clear.
#[derive(Debug, Clone, PartialEq)]
pub struct Bounds {
    /// Teeth of the sun.
    pub sun: RangeInclusive<u32>,
    /// Teeth of the planet.
    pub planet: RangeInclusive<u32>,
    /// Teeth of the ring.
    pub ring: RangeInclusive<u32>,
    /// Number of planets, from 2 to [`MOST_PLANETS`].
    pub planets: RangeInclusive<u32>,
    /// Ring-to-sun ratio `k = z_b/z_a`.
    pub ring_to_sun_ratio: RangeInclusive<f64>,
    /// The basic rack: its addendum `h_a*` decides on the gap between planets, with the pressure angle on
    /// undercut.
    pub rack: BasicRack,
    /// Least gap between the tip circles of adjacent planets, in modules.
    pub tip_gap: f64,
    /// Permissible placement of the planets.
    pub placement: Placement,
}

/// The greatest number of planets that the synthesis places.
pub const MOST_PLANETS: u32 = 8;

/// The fewest planets of a set that is searched for.
const LEAST_PLANETS: u32 = 2;

/// The greatest tooth count that the synthesis considers.
pub const MOST_TEETH: u32 = 10_000;

impl Default for Bounds {
    fn default() -> Self {
        Self {
            sun: 12..=200,
            planet: 12..=200,
            ring: 12..=200,
            planets: 3..=8,
            ring_to_sun_ratio: 1.3..=10.0,
            rack: BasicRack::default(),
            tip_gap: 0.0,
            placement: Placement::Equal,
        }
    }
}

impl Bounds {
    pub(crate) fn check(&self) -> Result<(), Error> {
        let ranges = [
            (SimpleGear::Sun, &self.sun),
            (SimpleGear::Planet, &self.planet),
            (SimpleGear::Ring, &self.ring),
        ];
        for (gear, range) in ranges {
            if *range.start() == 0 {
                return Err(Error::NoTeeth);
            }
            if range.is_empty() || *range.end() > MOST_TEETH {
                let (from, to) = (*range.start(), *range.end());
                return Err(Error::ToothRange { gear, from, to, most: MOST_TEETH });
            }
        }
        if self.planets.is_empty()
            || *self.planets.start() < LEAST_PLANETS
            || *self.planets.end() > MOST_PLANETS
        {
            return Err(Error::PlanetNumber {
                from: *self.planets.start(),
                to: *self.planets.end(),
                most: MOST_PLANETS,
            });
        }
        let (from, to) = (*self.ring_to_sun_ratio.start(), *self.ring_to_sun_ratio.end());
        if !(from > 1.0 && from <= to && to.is_finite()) {
            return Err(Error::RingToSunRange { from, to });
        }
        self.rack.check()?;
        not_negative(Quantity::TipGap, self.tip_gap, "modules")?;
        Ok(())
    }

    /// Every set of tooth numbers within the bounds, ascending by sun, planet and number of planets.
    ///
    /// ```
    /// use epicyclic_gears::synthesis::Bounds;
    /// assert_eq!(Bounds::default().tooth_numbers()?.len(), 8016);
    /// # Ok::<(), epicyclic_gears::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::NoTeeth`], [`Error::ToothRange`], [`Error::PlanetNumber`],
    /// [`Error::RingToSunRange`], [`Error::Negative`] for invalid bounds.
    pub fn tooth_numbers(&self) -> Result<Vec<ToothNumbers>, Error> {
        let mut found = Vec::new();
        self.each(|_| ControlFlow::Continue(()), |set| found.push(set))?;
        Ok(found)
    }

    /// Number of sets of tooth numbers within the bounds, without storing them.
    ///
    /// # Errors
    /// As [`tooth_numbers`](Self::tooth_numbers).
    pub fn count(&self) -> Result<u64, Error> {
        let mut count = 0;
        self.each(|_| ControlFlow::Continue(()), |_| count += 1)?;
        Ok(count)
    }

    /// Passes each set of tooth numbers within the bounds to `each`, ascending by sun, planet and number of
    /// planets, without storing them. `done` receives the completed share of the bounds, from 0 to 1; a break
    /// ends the search.
    ///
    /// # Errors
    /// Errors of [`tooth_numbers`](Self::tooth_numbers); [`Error::Cancelled`].
    pub fn each(
        &self,
        done: impl FnMut(f64) -> ControlFlow<()>,
        mut each: impl FnMut(ToothNumbers),
    ) -> Result<(), Error> {
        self.visit(done, |teeth| {
            each(teeth);
            Ok(())
        })
    }

    /// Whether its gears without profile shift can be cut and turned together; where they cannot, it is
    /// counted among those left out.
    ///
    /// ```
    /// use epicyclic_gears::synthesis::Bounds;
    /// let bounds = Bounds { sun: 8..=20, planet: 7..=16, ring: 24..=52, ..Bounds::default() };
    /// let mut left_out = None;
    /// let mut sets = bounds.tooth_numbers()?;
    /// sets.retain(|set| bounds.can_turn(set, &mut left_out).unwrap_or(false));
    /// assert!(!sets.is_empty() && left_out.is_some());
    /// # Ok::<(), epicyclic_gears::Error>(())
    /// ```
    ///
    /// # Errors
    /// Those of [`plain::miss`].
    pub fn can_turn(&self, set: &ToothNumbers, left_out: &mut Option<Box<LeftOut>>) -> Result<bool, Error> {
        let miss = plain::miss([set.sun, set.planet, set.ring], &self.rack)?;
        if let Some(check) = &miss {
            LeftOut::add(left_out, || set.to_string(), check);
        }
        Ok(miss.is_none())
    }

    /// The planets that a sun leaves, by the ranges of ring and `k`.
    pub(crate) fn planets_of(&self, sun: u32) -> RangeInclusive<u32> {
        let z_a = f64::from(sun);
        let (low_k, high_k) = (*self.ring_to_sun_ratio.start(), *self.ring_to_sun_ratio.end());
        // One tooth of slack against rounding; the test on k itself decides.
        let from_k = ((low_k - 1.0) / 2.0 * z_a).floor().max(0.0) as u32;
        let to_k = (((high_k - 1.0) / 2.0 * z_a).ceil()).min(f64::from(MOST_TEETH)) as u32;
        // Equal centre distances and the range of the ring limit the planet to these teeth.
        let from_ring = self.ring.start().saturating_sub(sun).div_ceil(2);
        let to_ring = self.ring.end().saturating_sub(sun) / 2;
        (*self.planet.start()).max(from_k).max(from_ring)..=(*self.planet.end()).min(to_k).min(to_ring)
    }

    /// Passes each set of tooth numbers to `each`, and after each sun the share of completed suns to `done`.
    fn visit(
        &self,
        mut done: impl FnMut(f64) -> ControlFlow<()>,
        mut each: impl FnMut(ToothNumbers) -> Result<(), Error>,
    ) -> Result<(), Error> {
        self.check()?;
        let half_gap_sines: Vec<(u32, f64)> =
            self.planets.clone().map(|n| (n, libm::sin(PI / f64::from(n)))).collect();
        let most_sum = self.sun.end() + self.ring.end();
        // Bit n of entry s: n planets divide s slots evenly.
        let divisors: Vec<u16> = (0..=most_sum)
            .map(|s| self.planets.clone().filter(|n| s % n == 0).fold(0, |bits, n| bits | 1 << n))
            .collect();

        let suns = f64::from(self.sun.end() - self.sun.start()) + 1.0;
        for sun in self.sun.clone() {
            let z_a = f64::from(sun);
            for planet in self.planets_of(sun) {
                let ring = coaxial_ring(sun, planet);
                if !self.ring_to_sun_ratio.contains(&(f64::from(ring) / z_a)) {
                    continue;
                }
                let even = divisors[(sun + ring) as usize];
                let (Ok(sun), Ok(planet), Ok(ring)) =
                    (ToothCount::new(sun), ToothCount::new(planet), ToothCount::new(ring))
                else {
                    continue;
                };
                let circle = TipCircle::of_planet(sun, planet, &self.rack);
                for &(planets, sine) in &half_gap_sines {
                    // More planets are closer together: none of the following numbers fits either.
                    if !circle.clears_alike(sine, self.tip_gap) {
                        break;
                    }
                    let placed = || PlanetSpacing::least_unequal(sun, ring, planets).half_gap_sine();
                    let assembles = even >> planets & 1 == 1
                        || self.placement == Placement::LeastUnequal
                            && circle.clears_alike(placed(), self.tip_gap);
                    if assembles {
                        each(ToothNumbers { sun, planet, ring, planets })?;
                    }
                }
            }
            if done((z_a - f64::from(*self.sun.start()) + 1.0) / suns).is_break() {
                return Err(Error::Cancelled);
            }
        }
        Ok(())
    }

    /// Sets of tooth numbers whose ratio in `mode` is within `tolerance` (relative) of `wanted`: every one,
    /// the most exact first; equally exact ones by ring, sun and number of planets.
    ///
    /// # Errors
    /// As [`tooth_numbers`](Self::tooth_numbers); [`Error::Tolerance`]; [`Error::NoToothNumbers`], with the
    /// nearest ratio within the bounds, where none comes close enough.
    pub fn for_ratio(&self, wanted: f64, mode: Mode, tolerance: f64) -> Result<Vec<Candidate>, Error> {
        self.for_ratio_watched(wanted, mode, tolerance, |_| ControlFlow::Continue(()))
    }

    /// Sets of tooth numbers as by [`for_ratio`](Self::for_ratio), with progress: `done` receives the
    /// completed share of the bounds, from 0 to 1; a break ends the search.
    ///
    /// # Errors
    /// Errors of [`for_ratio`](Self::for_ratio); [`Error::Cancelled`].
    pub fn for_ratio_watched(
        &self,
        wanted: f64,
        mode: Mode,
        tolerance: f64,
        done: impl FnMut(f64) -> ControlFlow<()>,
    ) -> Result<Vec<Candidate>, Error> {
        Ok(self.first_for_ratio(wanted, mode, tolerance, usize::MAX, done)?.first)
    }

    /// Number of sets of tooth numbers for a ratio, and the first `most` of them in the order of
    /// [`for_ratio`](Self::for_ratio). Memory holds no more than twice these. `done` is used as in
    /// [`for_ratio_watched`](Self::for_ratio_watched).
    ///
    /// # Errors
    /// As [`for_ratio`](Self::for_ratio); [`Error::Cancelled`].
    pub fn first_for_ratio(
        &self,
        wanted: f64,
        mode: Mode,
        tolerance: f64,
        most: usize,
        done: impl FnMut(f64) -> ControlFlow<()>,
    ) -> Result<Ranked, Error> {
        let order = |one: &Near, other: &Near| {
            let key = |near: &Near| (near.teeth.ring, near.teeth.sun, near.teeth.planets);
            one.ratio_error.abs().total_cmp(&other.ratio_error.abs()).then_with(|| key(one).cmp(&key(other)))
        };
        let mut held: Vec<Near> = Vec::new();
        let (found, left_out) = self.each_for_ratio(wanted, mode, tolerance, done, |near| {
            held.push(near);
            if held.len() >= most.saturating_mul(2) {
                held.select_nth_unstable_by(most, order);
                held.truncate(most);
            }
        })?;
        held.sort_by(order);
        held.truncate(most);
        Ok(Ranked {
            found,
            left_out,
            first: held.into_iter().map(|near| self.candidate(near, mode)).collect(),
        })
    }

    /// Passes each set of tooth numbers for a ratio to `each`, in no particular order, without storing them.
    ///
    /// Returns the number of sets and those that a check of their teeth leaves out. `done` is used as in
    /// [`for_ratio_watched`](Self::for_ratio_watched).
    ///
    /// # Errors
    /// Errors of [`for_ratio`](Self::for_ratio); [`Error::Cancelled`].
    pub fn each_for_ratio(
        &self,
        wanted: f64,
        mode: Mode,
        tolerance: f64,
        mut done: impl FnMut(f64) -> ControlFlow<()>,
        mut each: impl FnMut(Near),
    ) -> Result<(u64, Option<Box<LeftOut>>), Error> {
        let mut search = Search::new(wanted, tolerance)?;
        let (mut found, mut left_out) = (0, None);
        // The same gears come with several numbers of planets.
        let mut last: Option<([ToothCount; 3], Option<Check>)> = None;
        self.visit(&mut done, |teeth| {
            let ratio = teeth.basic_ratio().ratio(mode)?;
            if !(search.is_near(ratio) || search.is_nearer(ratio)) {
                return Ok(());
            }
            let gears = [teeth.sun, teeth.planet, teeth.ring];
            let miss = match last {
                Some((known, miss)) if known == gears => miss,
                _ => plain::miss(gears, &self.rack)?,
            };
            last = Some((gears, miss));
            if let Some(check) = miss {
                if search.is_near(ratio) {
                    LeftOut::add(&mut left_out, || teeth.to_string(), &check);
                }
            } else if let Some(ratio_error) = search.take(ratio) {
                found += 1;
                each(Near { teeth, ratio, ratio_error });
            }
            Ok(())
        })?;
        if found == 0 {
            let nearest = search.nearest();
            let fewer_planets = self.fewer_planets(wanted, mode, tolerance, &mut done);
            return Err(Error::NoToothNumbers { wanted, mode, tolerance, nearest, left_out, fewer_planets });
        }
        Ok((found, left_out))
    }

    /// The most planets, fewer than the bounds ask for, with which there are sets of a ratio.
    fn fewer_planets(
        &self,
        wanted: f64,
        mode: Mode,
        tolerance: f64,
        done: &mut dyn FnMut(f64) -> ControlFlow<()>,
    ) -> Option<u32> {
        let most = self.planets.start().saturating_sub(1);
        let fewer = Self { planets: LEAST_PLANETS..=most, ..self.clone() };
        if most < LEAST_PLANETS || fewer.check().is_err() {
            return None;
        }
        let mut most = None;
        let each = |near: Near| most = most.max(Some(near.teeth.planets));
        let found = fewer.each_for_ratio(wanted, mode, tolerance, done, each);
        found.ok().and(most)
    }

    /// Number of combinations of sun, planet and number of planets to be checked, before clearances and
    /// assembly; of double-planet sets those of sun, ring and number of pairs.
    ///
    /// ```
    /// use epicyclic_gears::synthesis::Bounds;
    /// assert!(Bounds::default().space(false)? >= Bounds::default().count()?);
    /// # Ok::<(), epicyclic_gears::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`tooth_numbers`](Self::tooth_numbers).
    pub fn space(&self, double_planets: bool) -> Result<u64, Error> {
        self.check()?;
        let count = |range: RangeInclusive<u32>| u64::from((range.end() + 1).saturating_sub(*range.start()));
        let of_sun = |sun: u32| match double_planets {
            true => count((*self.ring.start()).max(sun + 1)..=*self.ring.end()),
            false => count(self.planets_of(sun)),
        };
        Ok(self.sun.clone().map(of_sun).sum::<u64>() * count(self.planets.clone()))
    }

    fn candidate(&self, Near { teeth, ratio, ratio_error }: Near, mode: Mode) -> Candidate {
        Candidate {
            ratio,
            exact_ratio: exact_ratio(teeth.sun, teeth.ring, mode),
            ratio_error,
            most_planets: teeth.planet_circle(&self.rack).most(self.tip_gap),
            undercut_sun: self.rack.undercuts(teeth.sun),
            undercut_planet: self.rack.undercuts(teeth.planet),
            spacing: PlanetSpacing::least_unequal(teeth.sun, teeth.ring, teeth.planets),
            teeth,
        }
    }
}

/// A set of tooth numbers whose ratio is near the target.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Near {
    /// The teeth and the number of planets.
    pub teeth: ToothNumbers,
    /// The ratio it has.
    pub ratio: f64,
    /// Relative error of the ratio, `i/i_wanted − 1`.
    pub ratio_error: f64,
}

/// The sets of tooth numbers for a ratio, of double-planet sets the pairs of sun and ring: how many, and the
/// first of them.
#[derive(Debug, Clone, PartialEq)]
pub struct Ranked<Set = Candidate> {
    /// Number of sets found.
    pub found: u64,
    /// The first, the most exact before the others.
    pub first: Vec<Set>,
    /// Sets of this ratio that a check of their teeth leaves out.
    pub left_out: Option<Box<LeftOut>>,
}

/// A set of tooth numbers that meets a target ratio, with its ratio and ratio error.
#[derive(Debug, Clone, PartialEq)]
pub struct Candidate {
    /// The teeth and the number of planets.
    pub teeth: ToothNumbers,
    /// The ratio it has.
    pub ratio: f64,
    /// The ratio as a fraction.
    pub exact_ratio: Fraction,
    /// Relative error of the ratio, `i/i_wanted − 1`.
    pub ratio_error: f64,
    /// The largest number of equally spaced planets that clear each other.
    pub most_planets: u32,
    /// Whether a rack would undercut the sun.
    pub undercut_sun: bool,
    /// Whether a rack would undercut the planet.
    pub undercut_planet: bool,
    /// Positions of the planets.
    pub spacing: PlanetSpacing,
}

impl Candidate {
    /// Smallest angle between adjacent planets, in radians.
    #[must_use]
    pub fn smallest_gap_rad(&self) -> f64 {
        self.spacing.smallest_gap().si()
    }
}

/// Sets of tooth numbers by trying every combination of teeth and planets: slow, and the oracle of
/// [`Bounds::tooth_numbers`].
///
/// # Errors
/// As [`Bounds::tooth_numbers`].
pub fn tooth_numbers_by_trial(bounds: &Bounds) -> Result<Vec<ToothNumbers>, Error> {
    bounds.check()?;
    let mut found = Vec::new();
    for sun in bounds.sun.clone() {
        for planet in bounds.planet.clone() {
            for ring in bounds.ring.clone() {
                for planets in bounds.planets.clone() {
                    let (a, g, b) = (ToothCount::new(sun)?, ToothCount::new(planet)?, ToothCount::new(ring)?);
                    let spacing = PlanetSpacing::least_unequal(a, b, planets);
                    let placed = spacing.is_equal() || bounds.placement == Placement::LeastUnequal;
                    let chord = (a.as_f64() + g.as_f64()) * libm::sin(spacing.smallest_gap().si() / 2.0);
                    let clears = chord > g.as_f64() + 2.0 * bounds.rack.addendum + bounds.tip_gap;
                    let k = b.as_f64() / a.as_f64();
                    if sun + planet == ring.wrapping_sub(planet)
                        && placed
                        && clears
                        && bounds.ring_to_sun_ratio.contains(&k)
                    {
                        found.push(ToothNumbers { sun: a, planet: g, ring: b, planets });
                    }
                }
            }
        }
    }
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simple_set::Member;
    use proptest::prelude::*;
    use uom::si::f64::Angle;

    fn teeth(count: u32) -> ToothCount {
        ToothCount::new(count).unwrap()
    }

    fn sun_to_carrier() -> Mode {
        Mode::new(Member::Sun, Member::Carrier).unwrap()
    }

    #[test]
    fn who_watches_sees_the_share_rise_to_one() {
        let mut seen = vec![];
        let mode = Mode::new(Member::Sun, Member::Carrier).unwrap();
        let watched = Bounds::default().for_ratio_watched(6.0, mode, 0.01, |share| {
            seen.push(share);
            ControlFlow::Continue(())
        });
        let watched = watched.unwrap();
        let broken = Bounds::default().for_ratio_watched(6.0, mode, 0.01, |_| ControlFlow::Break(()));
        assert_eq!(broken, Err(Error::Cancelled));
        assert_eq!(watched.len(), Bounds::default().for_ratio(6.0, mode, 0.01).unwrap().len());
        assert_eq!((seen.len(), seen.last()), (189, Some(&1.0)));
        assert!(seen.is_sorted());
    }

    #[test]
    fn the_excavators_set_is_found_for_its_ratio() {
        let bounds = Bounds { planets: 4..=4, sun: 20..=20, ..Bounds::default() };
        let found = bounds.for_ratio(6.0, sun_to_carrier(), 0.0).unwrap();
        assert_eq!(found.len(), 1);
        let only = &found[0];
        assert_eq!(
            only.teeth,
            ToothNumbers { sun: teeth(20), planet: teeth(40), ring: teeth(100), planets: 4 }
        );
        assert_eq!(only.exact_ratio, Fraction::from_integer(6));
        assert_eq!(only.most_planets, 4);
        assert!(!only.undercut_sun && !only.undercut_planet);
    }

    #[test]
    fn values_show_as_they_are_written() {
        let numbers = ToothNumbers { sun: teeth(20), planet: teeth(40), ring: teeth(100), planets: 4 };
        assert_eq!(numbers.to_string(), "20/40/100 ×4");
        assert_eq!(format!("{:.2}", numbers.basic_ratio()), "-5.00");
        assert_eq!(crate::efficiency::MeshEfficiency::IDEAL.to_string(), "1");
    }

    #[test]
    fn a_ratio_out_of_reach_names_the_nearest() {
        let error = Bounds::default().for_ratio(20.0, sun_to_carrier(), 0.01).unwrap_err();
        let Error::NoToothNumbers { nearest: Some(nearest), .. } = error else { panic!("{error}") };
        assert!(nearest > 10.0 && nearest <= 11.0);
    }

    /// Five planets have no room around 20 teeth at a ratio of 6: four have.
    #[test]
    fn with_fewer_planets_the_ratio_may_be_had() {
        let bounds = Bounds { sun: 20..=20, planets: 5..=5, ..Bounds::default() };
        let error = bounds.for_ratio(6.0, sun_to_carrier(), 0.01).unwrap_err();
        assert!(matches!(error, Error::NoToothNumbers { fewer_planets: Some(4), .. }), "{error:?}");
        assert!(error.to_string().ends_with("more stand too close or do not assemble"), "{error}");
        let far = bounds.for_ratio(60.0, sun_to_carrier(), 0.01).unwrap_err();
        assert!(matches!(far, Error::NoToothNumbers { fewer_planets: None, .. }), "{far:?}");
    }

    #[test]
    fn invalid_bounds_are_refused() {
        let base = Bounds::default;
        let cases = [
            (Bounds { sun: 0..=20, ..base() }, Error::NoTeeth),
            (
                Bounds { sun: RangeInclusive::new(20, 19), ..base() },
                Error::ToothRange { gear: SimpleGear::Sun, from: 20, to: 19, most: MOST_TEETH },
            ),
            (Bounds { planets: 1..=3, ..base() }, Error::PlanetNumber { from: 1, to: 3, most: MOST_PLANETS }),
            (Bounds { ring_to_sun_ratio: 0.9..=3.0, ..base() }, Error::RingToSunRange { from: 0.9, to: 3.0 }),
            (
                Bounds { rack: BasicRack { addendum: -1.0, ..BasicRack::default() }, ..base() },
                Error::Negative { quantity: Quantity::AddendumCoefficient, value: -1.0, unit: "modules" },
            ),
        ];
        for (bounds, expected) in cases {
            assert_eq!(bounds.tooth_numbers(), Err(expected));
        }
        for tolerance in [-0.1, 1.0, 1e308, f64::INFINITY] {
            assert_eq!(
                base().for_ratio(6.0, sun_to_carrier(), tolerance),
                Err(Error::Tolerance { tolerance })
            );
        }
        assert!(matches!(base().for_ratio(6.0, sun_to_carrier(), f64::NAN), Err(Error::Tolerance { .. })));
        assert!(base().for_ratio(6.0, sun_to_carrier(), 0.999).is_ok());
        assert!(matches!(base().for_ratio(0.0, sun_to_carrier(), 0.1), Err(Error::Ratio { .. })));
    }

    /// 7/6.25 − 1 is 0.12 exactly, and as floats a rounding above it.
    #[test]
    fn a_set_at_the_tolerance_itself_is_within() {
        let exact = |tolerance: f64| {
            let found = Bounds::default().for_ratio(6.25, sun_to_carrier(), tolerance).unwrap();
            found.iter().any(|set| set.ratio == 7.0)
        };
        assert!(exact(0.12) && !exact(0.12 - 1e-14));
    }

    #[test]
    fn the_first_are_those_of_all_and_none_is_held_beyond_them() {
        let bounds = Bounds { placement: Placement::LeastUnequal, ..Bounds::default() };
        let all = bounds.for_ratio(5.3, sun_to_carrier(), 0.2).unwrap();
        assert!(all.len() > 1000, "{}", all.len());
        for most in [0, 1, 7, 100, all.len() - 1, all.len(), all.len() + 1] {
            let ranked = bounds
                .first_for_ratio(5.3, sun_to_carrier(), 0.2, most, |_| ControlFlow::Continue(()))
                .unwrap();
            assert_eq!(ranked.found, all.len() as u64);
            assert_eq!(ranked.first, all[..most.min(all.len())]);
        }
        assert_eq!(Bounds::default().count(), Ok(8016));
    }

    #[test]
    fn ten_thousand_teeth_are_the_most() {
        let sun = |to| Bounds { sun: 9_998..=to, planet: 1..=1, ring: 1..=10_000, ..Bounds::default() };
        let wide = |to| Bounds { ring_to_sun_ratio: 1.0001..=2.0, planets: 2..=2, tip_gap: 0.0, ..sun(to) };
        assert_eq!(MOST_TEETH, 10_000);
        assert_eq!(wide(10_000).tooth_numbers().unwrap().len(), 1);
        let refused = Error::ToothRange { gear: SimpleGear::Sun, from: 9_998, to: 10_001, most: 10_000 };
        assert_eq!(wide(10_001).tooth_numbers(), Err(refused));
    }

    /// The pressure angle decides on undercut alone, the addendum on undercut and on the gap between planets.
    #[test]
    fn undercut_follows_the_rack() {
        let with = |addendum: f64, alpha_deg: f64| {
            let rack = BasicRack {
                addendum,
                pressure_angle: Angle::from_degrees(alpha_deg),
                ..BasicRack::default()
            };
            let bounds = Bounds { sun: 15..=15, planet: 30..=30, planets: 3..=3, rack, ..Bounds::default() };
            let found = bounds.for_ratio(6.0, sun_to_carrier(), 0.0).unwrap();
            (found[0].undercut_sun, found[0].undercut_planet)
        };
        assert_eq!(with(1.0, 14.5), (true, true));
        assert_eq!(with(1.0, 20.0), (true, false));
        assert_eq!(with(1.0, 25.0), (false, false));
        assert_eq!(with(0.8, 20.0), (false, false));
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(32))]

        #[test]
        fn tooth_numbers_are_those_that_trial_finds(
            sun in 1..30_u32, suns in 0..12_u32,
            planet in 1..30_u32, spread in 0..12_u32,
            ring in 1..90_u32, rings in 0..40_u32,
            planets in 2..=8_u32, more in 0..6_u32,
            low_k in 1.01..4.0_f64, wide in 0.0..8.0_f64,
            tip_gap in prop_oneof![Just(0.0), 0.0..1.5_f64],
            unequal in any::<bool>(),
        ) {
            let bounds = Bounds {
                sun: sun..=sun + suns,
                planet: planet..=planet + spread,
                ring: ring..=ring + rings,
                planets: planets..=(planets + more).min(8),
                ring_to_sun_ratio: low_k..=low_k + wide,
                tip_gap,
                placement: if unequal { Placement::LeastUnequal } else { Placement::Equal },
                ..Bounds::default()
            };
            prop_assert_eq!(bounds.tooth_numbers().unwrap(), tooth_numbers_by_trial(&bounds).unwrap());
        }
    }
}
