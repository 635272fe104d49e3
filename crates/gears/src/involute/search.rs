//! Tooth numbers with profile shift for a ratio: *every* simple set within bounds whose ring departs from `z_s + 2·z_p` by an offset.
//!
//! Sun, planet, offset and number of planets are gone through, and each set whose ratio is near is [closed](super::closing). Nothing is
//! left out beforehand but by ratio, bounds and assembly; what [`Family::choose`](super::family::Family::choose) may miss is told there.

use super::closing::Closing;
use super::family::Choice;
use super::fault::SetFault;
use crate::mesh::coaxial_ring;
use crate::simple_set::{Fraction, Mode, exact_ratio};
use crate::spacing::PlanetSpacing;
use crate::synthesis::{Bounds, Placement, Search, ToothNumbers};
use crate::{Error, ToothCount};
use std::ops::RangeInclusive;

/// The largest offset that is tried, either way: beyond some few teeth no shifts close a set.
pub const MOST_OFFSET: i32 = 9;

/// What is sought.
#[derive(Debug, Clone, PartialEq)]
pub struct ShiftedSearch {
    /// Ranges of teeth, planets and `k`, and how the planets may be placed. Its rack and tip gap are those of `closing`.
    pub bounds: Bounds,
    /// Offsets `z_r − z_s − 2·z_p`.
    pub offsets: RangeInclusive<i32>,
    /// How the sets are closed; the number of planets is that of the bounds.
    pub closing: Closing,
}

/// A set with profile shift for a ratio.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shifted {
    /// Its tooth numbers.
    pub teeth: ToothNumbers,
    /// Ratio that they give.
    pub ratio: f64,
    /// The same, exactly.
    pub exact_ratio: Fraction,
    /// Relative departure from the wanted ratio.
    pub ratio_error: f64,
    /// Its gears with their shifts.
    pub choice: Choice,
}

impl Shifted {
    /// Offset of the ring, `z_r − z_s − 2·z_p`.
    #[must_use]
    pub fn offset(&self) -> i32 {
        let coaxial = i64::from(coaxial_ring(self.teeth.sun.get(), self.teeth.planet.get()));
        (i64::from(self.teeth.ring.get()) - coaxial) as i32
    }
}

impl ShiftedSearch {
    /// How many sets there are for a ratio, and the first `most` of them: the most exact first, equally exact ones by the size of the offset,
    /// ring, sun and number of planets. `done` is told, from 0 to 1, how much of the bounds has been gone through.
    ///
    /// ```
    /// use epicyclic_gears::involute::closing::Closing;
    /// use epicyclic_gears::involute::search::ShiftedSearch;
    /// use epicyclic_gears::simple_set::{Member, Mode};
    /// use epicyclic_gears::synthesis::Bounds;
    /// # fn main() -> Result<(), epicyclic_gears::Error> {
    /// let bounds = Bounds { sun: 18..=18, planets: 3..=3, ..Bounds::default() };
    /// let search = ShiftedSearch { bounds, offsets: -3..=3, closing: Closing::default() };
    /// let mode = Mode::new(Member::Sun, Member::Carrier)?;
    /// // i = 1 + 93/18: 18/36/93 and its neighbours.
    /// let (found, sets) = search.first_for_ratio(111.0 / 18.0, mode, 0.0, 10, |_| {})?;
    /// let planets: Vec<u32> = sets.iter().map(|set| set.teeth.planet.get()).collect();
    /// assert_eq!((found, planets), (4, vec![37, 38, 36, 39]));
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// As [`Bounds::for_ratio`]; [`Error::RingOffset`] for offsets beyond [`MOST_OFFSET`]; [`Error::Negative`] for limits below 0; those of
    /// [`Profile::check`](super::Profile::check).
    pub fn first_for_ratio(
        &self,
        wanted: f64,
        mode: Mode,
        tolerance: f64,
        most: usize,
        mut done: impl FnMut(f64),
    ) -> Result<(u64, Vec<Shifted>), Error> {
        self.check()?;
        let mut search = Search::new(wanted, tolerance)?;
        let order = |one: &Shifted, other: &Shifted| {
            let key = |set: &Shifted| (set.offset().abs(), set.teeth.ring, set.teeth.sun, set.teeth.planets);
            one.ratio_error.abs().total_cmp(&other.ratio_error.abs()).then_with(|| key(one).cmp(&key(other)))
        };
        let (mut found, mut held): (u64, Vec<Shifted>) = (0, Vec::new());
        let (first, last) = (*self.bounds.sun.start(), *self.bounds.sun.end());
        for sun in first..=last {
            self.each_of(ToothCount::new(sun)?, mode, &mut search, |set| {
                found += 1;
                held.push(set);
                if held.len() >= most.saturating_mul(2) {
                    held.select_nth_unstable_by(most, order);
                    held.truncate(most);
                }
            })?;
            done(f64::from(sun - first + 1) / f64::from(last - first + 1));
        }
        if found == 0 {
            return Err(Error::NoToothNumbers { wanted, mode, tolerance, nearest: search.nearest() });
        }
        held.sort_by(order);
        held.truncate(most);
        Ok((found, held))
    }

    fn check(&self) -> Result<(), Error> {
        self.bounds.check()?;
        self.closing.profile.check()?;
        self.closing.limits.check()?;
        let (from, to) = (*self.offsets.start(), *self.offsets.end());
        if from > to || from < -MOST_OFFSET || to > MOST_OFFSET {
            return Err(Error::RingOffset { from, to, most: MOST_OFFSET });
        }
        Ok(())
    }

    /// The sets of one sun.
    fn each_of(
        &self,
        sun: ToothCount,
        mode: Mode,
        search: &mut Search,
        mut each: impl FnMut(Shifted),
    ) -> Result<(), Error> {
        let bounds = &self.bounds;
        // An offset of o asks for planets of up to o/2 teeth more or fewer within the ranges of ring and k.
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
                if !(bounds.ring.contains(&ring) && bounds.ring_to_sun_ratio.contains(&k)) {
                    continue;
                }
                let ring = ToothCount::new(ring)?;
                let exact_ratio = exact_ratio(sun, ring, mode);
                for planets in bounds.planets.clone() {
                    let teeth = ToothNumbers { sun, planet, ring, planets };
                    let ratio = teeth.basic_ratio().ratio(mode)?;
                    if !(search.is_near(ratio) || search.is_nearer(ratio)) {
                        break;
                    }
                    let is_equal = PlanetSpacing::least_unequal(sun, ring, planets).is_equal();
                    if !is_equal && bounds.placement == Placement::Equal {
                        continue;
                    }
                    match (Closing { planets, ..self.closing }).close([sun, planet, ring]) {
                        Ok(choice) => {
                            if let Some(ratio_error) = search.take(ratio) {
                                each(Shifted { teeth, ratio, exact_ratio, ratio_error, choice });
                            }
                        }
                        // More planets stand closer: of equally spaced ones none of the following clears.
                        Err(Error::NoShifts { fault: SetFault::Planets { .. }, .. }) if is_equal => break,
                        Err(_) => {}
                    }
                }
            }
        }
        Ok(())
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
        let refused =
            |search: ShiftedSearch| search.first_for_ratio(6.0, mode(), 0.01, 1, |_| {}).unwrap_err();
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
            let found = search.first_for_ratio(wanted, mode(), 0.05, usize::MAX, |_| {});
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
            let mut found: Vec<[u32; 4]> = found.map(|(_, sets)| sets).unwrap_or_default().iter()
                .map(|set| [set.teeth.sun.get(), set.teeth.planet.get(), set.teeth.ring.get(), set.teeth.planets]).collect();
            found.sort_unstable();
            prop_assert_eq!(found, by_trial);
        }
    }
}
