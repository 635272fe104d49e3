//! Tooth numbers with profile shift: *every* simple set within bounds whose ring departs from `z_s + 2·z_p`
//! by an offset, of a ratio or of any.
//!
//! The search runs over sun, planet, offset and number of planets, and each set whose ratio is near is
//! [closed](super::closing). Sets are excluded beforehand only by ratio, bounds and assembly.
//! [`Family::choose`](super::family::Family::choose) explains what it may miss.
//!
//! [`ShiftedSearch::first_for_ratio`] ranks the sets of one ratio; [`ShiftedSearch::of_sun`] gives all of a
//! sun to searches that combine sets.

use super::check::{Check, Rule};
use super::closing::Closing;
use super::family::{Choice, natural_centre_distance};
use super::left_out::LeftOut;
use crate::mesh::coaxial_ring;
use crate::simple_set::{BasicRatio, Fraction, Mode, exact_ratio};
use crate::spacing::PlanetSpacing;
use crate::synthesis::{Bounds, Placement, Ranked, Search, ToothNumbers};
use crate::{Error, ToothCount};
use epicyclic_units::Physical;
use std::ops::{ControlFlow, RangeInclusive};

/// The largest offset that is tried, either way: beyond some few teeth no shifts close a set.
pub const MOST_OFFSET: i32 = 9;

/// Offsets of rings from equal centre distances without shift, and the way in which such sets are closed,
/// each at its [natural centre distance](super::family::natural_centre_distance).
#[derive(Debug, Clone, PartialEq)]
pub struct ProfileShift {
    /// Offsets `z_r − z_s − 2·z_p`.
    pub offsets: RangeInclusive<i32>,
    /// Data with which the sets are closed; their number of planets is that of each set, and their centre
    /// distance the natural one.
    pub closing: Closing,
}

impl ProfileShift {
    /// The search within bounds.
    #[must_use]
    pub fn within(&self, bounds: &Bounds) -> ShiftedSearch {
        let closing = Closing { centre_distance: None, ..self.closing };
        ShiftedSearch { bounds: bounds.clone(), offsets: self.offsets.clone(), closing }
    }

    /// A set with the shifts that the aim picks.
    ///
    /// # Errors
    /// Those of [`Closing::close`]; none of a set that [`ShiftedSearch`] found.
    pub fn close(&self, teeth: &ToothNumbers) -> Result<Choice, Error> {
        let closing = Closing { planets: teeth.planets, centre_distance: None, ..self.closing };
        closing.close([teeth.sun, teeth.planet, teeth.ring])
    }

    /// Working over reference diameters of sun and planets, `2·a·cos β/(z_a + z_g)`: 1 without an offset of
    /// the ring. Sets with the same ratios of teeth have the same.
    ///
    /// # Errors
    /// Those of [`natural_centre_distance`]; none of a set that [`ShiftedSearch`] found.
    pub fn working_over_reference(&self, teeth: &ToothNumbers) -> Result<f64, Error> {
        if teeth.ring_offset() == 0 {
            return Ok(1.0);
        }
        let profile = *self.closing.profiles.shared();
        let a = natural_centre_distance([teeth.sun, teeth.planet, teeth.ring], profile)?;
        let cos_beta = libm::cos(profile.helix_angle.si());
        Ok(2.0 * a * cos_beta / (teeth.sun.as_f64() + teeth.planet.as_f64()))
    }
}

/// Search for sets with profile shift: bounds, offsets of the ring, and how sets are closed.
#[derive(Debug, Clone, PartialEq)]
pub struct ShiftedSearch {
    /// Ranges of teeth, planets and `k`, and how the planets may be placed. Its rack and tip gap are those of
    /// `closing`.
    pub bounds: Bounds,
    /// Offsets `z_r − z_s − 2·z_p`.
    pub offsets: RangeInclusive<i32>,
    /// Data with which the sets are closed; the number of planets is that of the bounds.
    pub closing: Closing,
}

/// A set with profile shift for a ratio.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shifted {
    /// Tooth numbers of the set.
    pub teeth: ToothNumbers,
    /// Ratio of the tooth numbers.
    pub ratio: f64,
    /// Ratio as an exact fraction.
    pub exact_ratio: Fraction,
    /// Relative deviation from the target ratio.
    pub ratio_error: f64,
    /// Gears of the set with their shifts.
    pub choice: Choice,
}

impl Shifted {
    /// Offset of the ring, `z_r − z_s − 2·z_p`.
    #[must_use]
    pub fn offset(&self) -> i32 {
        self.teeth.ring_offset()
    }
}

impl ShiftedSearch {
    /// Number of sets for a ratio, and the first `most` of them.
    ///
    /// The most exact come first, equally exact ones by the size of the offset, ring, sun and number of
    /// planets. `done` receives the completed share of the bounds, from 0 to 1; a break ends the search.
    ///
    /// ```
    /// use epicyclic_gears::involute::closing::Closing;
    /// use epicyclic_gears::involute::search::ShiftedSearch;
    /// use epicyclic_gears::simple_set::{Member, Mode};
    /// use epicyclic_gears::synthesis::{Bounds, Ranked};
    /// # fn main() -> Result<(), epicyclic_gears::Error> {
    /// let bounds = Bounds { sun: 18..=18, planets: 3..=3, ..Bounds::default() };
    /// let search = ShiftedSearch { bounds, offsets: -3..=3, closing: Closing::default() };
    /// let mode = Mode::new(Member::Sun, Member::Carrier)?;
    /// // i = 1 + 93/18: 18/36/93 and its neighbours.
    /// let Ranked { found, first: sets, .. } = search
    ///     .first_for_ratio(111.0 / 18.0, mode, 0.0, 10, |_| std::ops::ControlFlow::Continue(()))?;
    /// let planets: Vec<u32> = sets.iter().map(|set| set.teeth.planet.get()).collect();
    /// assert_eq!((found, planets), (4, vec![37, 38, 36, 39]));
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// Errors of [`Bounds::for_ratio`]; [`Error::Cancelled`]; [`Error::RingOffset`] for offsets beyond
    /// [`MOST_OFFSET`]; [`Error::Negative`] for limits below 0; those of
    /// [`Profile::check`](super::Profile::check).
    pub fn first_for_ratio(
        &self,
        wanted: f64,
        mode: Mode,
        tolerance: f64,
        most: usize,
        mut done: impl FnMut(f64) -> ControlFlow<()>,
    ) -> Result<Ranked<Shifted>, Error> {
        self.check()?;
        let mut search = Search::new(wanted, tolerance)?;
        let order = |one: &Shifted, other: &Shifted| {
            let key = |set: &Shifted| (set.offset().abs(), set.teeth.ring, set.teeth.sun, set.teeth.planets);
            one.ratio_error.abs().total_cmp(&other.ratio_error.abs()).then_with(|| key(one).cmp(&key(other)))
        };
        let (mut found, mut held): (u64, Vec<Shifted>) = (0, Vec::new());
        let mut left_out = None;
        let (first, last) = (*self.bounds.sun.start(), *self.bounds.sun.end());
        for sun in first..=last {
            self.each_ring(ToothCount::new(sun)?, |gears @ [sun, _, ring]| {
                let ratio = BasicRatio::simple(sun, ring).ratio(mode)?;
                if !(search.is_near(ratio) || search.is_nearer(ratio)) {
                    return Ok(());
                }
                let exact_ratio = exact_ratio(sun, ring, mode);
                self.each_closed(gears, |teeth, choice| {
                    let choice = match choice {
                        Ok(choice) => choice,
                        Err(check) if search.is_near(ratio) => {
                            return LeftOut::add(&mut left_out, || teeth.to_string(), &check);
                        }
                        Err(_) => return,
                    };
                    let Some(ratio_error) = search.take(ratio) else { return };
                    found += 1;
                    held.push(Shifted { teeth, ratio, exact_ratio, ratio_error, choice });
                    if held.len() >= most.saturating_mul(2) {
                        held.select_nth_unstable_by(most, order);
                        held.truncate(most);
                    }
                });
                Ok(())
            })?;
            if done(f64::from(sun - first + 1) / f64::from(last - first + 1)).is_break() {
                return Err(Error::Cancelled);
            }
        }
        if found == 0 {
            let nearest = search.nearest();
            return Err(Error::NoToothNumbers {
                wanted,
                mode,
                tolerance,
                nearest,
                left_out,
                fewer_planets: None,
            });
        }
        held.sort_by(order);
        held.truncate(most);
        Ok(Ranked { found, first: held, left_out })
    }

    /// Sets of one sun whose ratio is accepted, by planet, ring and number of planets: those that close,
    /// ascending.
    ///
    /// ```
    /// use epicyclic_gears::ToothCount;
    /// use epicyclic_gears::involute::closing::Closing;
    /// use epicyclic_gears::involute::search::ShiftedSearch;
    /// use epicyclic_gears::synthesis::Bounds;
    /// # fn main() -> Result<(), epicyclic_gears::Error> {
    /// let bounds = Bounds { planets: 3..=3, ring: 108..=108, ..Bounds::default() };
    /// let search = ShiftedSearch { bounds, offsets: -3..=3, closing: Closing::default() };
    /// search.check()?;
    /// let of_21 = search.of_sun(ToothCount::new(21)?, |_, _| true)?;
    /// let planets: Vec<u32> = of_21.iter().map(|teeth| teeth.planet.get()).collect();
    /// assert_eq!(planets, [42, 43, 44, 45]);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// None within bounds that [`check`](Self::check) accepts.
    pub fn of_sun(
        &self,
        sun: ToothCount,
        is_wanted: impl Fn(ToothCount, ToothCount) -> bool,
    ) -> Result<Vec<ToothNumbers>, Error> {
        let mut found = vec![];
        self.each_ring(sun, |gears @ [sun, _, ring]| {
            if is_wanted(sun, ring) {
                self.each_closed(gears, |teeth, choice| {
                    if choice.is_ok() {
                        found.push(teeth);
                    }
                });
            }
            Ok(())
        })?;
        Ok(found)
    }

    /// Number of combinations of sun, planet, ring and number of planets to be checked, before assembly and
    /// shifts.
    ///
    /// # Errors
    /// As [`check`](Self::check).
    pub fn space(&self) -> Result<u64, Error> {
        self.check()?;
        let mut rings = 0_u64;
        for sun in self.bounds.sun.clone() {
            self.each_ring(ToothCount::new(sun)?, |_| {
                rings += 1;
                Ok(())
            })?;
        }
        Ok(rings * self.bounds.planets.clone().count() as u64)
    }

    /// Refuses invalid bounds, offsets, limits and profiles.
    ///
    /// # Errors
    /// [`Error::RingOffset`] for offsets beyond [`MOST_OFFSET`]; [`Error::Negative`] for limits below 0;
    /// those of [`Bounds`] and of [`Profile::check`](super::Profile::check).
    pub fn check(&self) -> Result<(), Error> {
        self.bounds.check()?;
        self.closing.profiles.check()?;
        self.closing.limits.check()?;
        let (from, to) = (*self.offsets.start(), *self.offsets.end());
        if from > to || from < -MOST_OFFSET || to > MOST_OFFSET {
            return Err(Error::RingOffset { from, to, most: MOST_OFFSET });
        }
        Ok(())
    }

    /// Planets and rings of one sun within the bounds, ascending: sun, planet, ring.
    fn each_ring(
        &self,
        sun: ToothCount,
        mut each: impl FnMut([ToothCount; 3]) -> Result<(), Error>,
    ) -> Result<(), Error> {
        let bounds = &self.bounds;
        // An offset of o requires planets of up to o/2 teeth more or fewer within the ranges of ring and k.
        let slack = self.offsets.start().abs().max(self.offsets.end().abs()).unsigned_abs().div_ceil(2);
        let planets = bounds.planets_of(sun.get());
        let from = planets.start().saturating_sub(slack).max(*bounds.planet.start());
        for planet in from..=(planets.end() + slack).min(*bounds.planet.end()) {
            let planet = ToothCount::new(planet)?;
            for offset in self.offsets.clone() {
                let Some(ring) = coaxial_ring(sun.get(), planet.get()).checked_add_signed(offset) else {
                    continue;
                };
                let k = f64::from(ring) / sun.as_f64();
                if bounds.ring.contains(&ring) && bounds.ring_to_sun_ratio.contains(&k) {
                    each([sun, planet, ToothCount::new(ring)?])?;
                }
            }
        }
        Ok(())
    }

    /// The numbers of planets with which sun, planet and ring close, and what else is in the way of those
    /// that assemble.
    fn each_closed(
        &self,
        gears @ [sun, planet, ring]: [ToothCount; 3],
        mut each: impl FnMut(ToothNumbers, Result<Choice, Check>),
    ) {
        for planets in self.bounds.planets.clone() {
            let is_equal = PlanetSpacing::least_unequal(sun, ring, planets).is_equal();
            if !is_equal && self.bounds.placement == Placement::Equal {
                continue;
            }
            match (Closing { planets, ..self.closing }).close(gears) {
                Ok(choice) => each(ToothNumbers { sun, planet, ring, planets }, Ok(choice)),
                Err(Error::NoShifts { fault, .. }) => {
                    each(ToothNumbers { sun, planet, ring, planets }, Err(fault));
                    // More planets are closer together: of equally spaced ones none of the following clears.
                    if fault.rule == Rule::PlanetGap && is_equal {
                        break;
                    }
                }
                Err(_) => {}
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::involute::set::Limits;
    use crate::simple_set::Member;
    use proptest::prelude::*;

    fn mode() -> Mode {
        Mode::new(Member::Sun, Member::Carrier).unwrap()
    }

    #[test]
    fn bad_searches_are_refused() {
        let search =
            |offsets| ShiftedSearch { bounds: Bounds::default(), offsets, closing: Closing::default() };
        let refused = |search: ShiftedSearch| {
            search.first_for_ratio(6.0, mode(), 0.01, 1, |_| ControlFlow::Continue(())).unwrap_err()
        };
        assert_eq!(
            refused(search(-12..=3)).to_string(),
            "ring offsets from -12 to 3: write the smaller first, from -9 to 9"
        );
        let limits = Limits { tip_thickness: -0.1, ..Limits::default() };
        let thin = ShiftedSearch { closing: Closing { limits, ..Closing::default() }, ..search(0..=0) };
        assert_eq!(refused(thin).name(), "negative");
        let bounds = Bounds { sun: 17..=19, ring: 40..=60, ..Bounds::default() };
        let far = refused(ShiftedSearch { bounds, ..search(0..=1) });
        assert!(matches!(far, Error::NoToothNumbers { nearest: Some(_), .. }), "{far:?}");
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(12))]
        /// Against the trial of every sun, planet, ring and number of planets.
        #[test]
        fn sets_are_those_that_trial_finds(
            sun in 12..24_u32, planet in 12..30_u32, low in -3..=0_i32, more in 0..=3_i32, planets in 3..=5_u32,
            unequal in any::<bool>(),
        ) {
            let bounds = Bounds {
                sun: sun..=sun + 2,
                planet: planet..=planet + 2,
                planets: planets..=planets + 1,
                placement: if unequal { Placement::LeastUnequal } else { Placement::Equal },
                ..Bounds::default()
            };
            let search = ShiftedSearch { bounds: bounds.clone(), offsets: low..=low + more, closing: Closing::default() };
            let wanted = 2.0 + 2.0 * f64::from(planet) / f64::from(sun);
            let found = search.first_for_ratio(wanted, mode(), 0.05, usize::MAX, |_| ControlFlow::Continue(()));
            let mut by_trial = vec![];
            for sun in bounds.sun.clone() {
                for planet in bounds.planet.clone() {
                    for ring in bounds.ring.clone() {
                        for planets in bounds.planets.clone() {
                            let offset = i64::from(ring) - i64::from(sun + 2 * planet);
                            let ratio = 1.0 + f64::from(ring) / f64::from(sun);
                            let teeth = [sun, planet, ring].map(|count| ToothCount::new(count).unwrap());
                            let even = (sun + ring).is_multiple_of(planets);
                            if search.offsets.contains(&(offset as i32))
                                && (ratio / wanted - 1.0).abs() <= 0.05 + 4.0 * f64::EPSILON
                                && bounds.ring_to_sun_ratio.contains(&(ratio - 1.0))
                                && (even || unequal)
                                && (Closing { planets, ..search.closing }).close(teeth).is_ok()
                            {
                                by_trial.push([sun, planet, ring, planets]);
                            }
                        }
                    }
                }
            }
            let mut found: Vec<[u32; 4]> = found.map(|found| found.first).unwrap_or_default().iter()
                .map(|set| [set.teeth.sun.get(), set.teeth.planet.get(), set.teeth.ring.get(), set.teeth.planets]).collect();
            found.sort_unstable();
            prop_assert_eq!(found, by_trial);
        }
    }
}
