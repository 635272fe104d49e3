//! Tooth numbers near `z_r = z_s + 2·z_p` that make a set with profile shift.
//!
//! A set closes if, at its centre distance, some profile shifts leave no fault by the [`Limits`]. Every ring
//! within the offsets is checked; none is excluded beforehand. [`Family::choose`] explains which short ranges
//! of shifts may be missed.

use super::family::{Aim, Choice, Family, natural_centre_distance};
use super::profile::Profiles;
use super::set::Limits;
use crate::mesh::coaxial_ring;
use crate::{Error, ToothCount};
use std::ops::RangeInclusive;

/// Common data of the sets to be closed; lengths in modules.
///
/// ```
/// use epicyclic_gears::ToothCount;
/// use epicyclic_gears::involute::closing::Closing;
/// # fn main() -> Result<(), epicyclic_gears::Error> {
/// // At the centre distance of a wind gearbox, 584 mm with a module of 21 mm, sun 18, planets 36.
/// let wind = Closing { centre_distance: Some(584.0 / 21.0), ..Closing::default() };
/// let rings = wind.rings(ToothCount::new(18)?, ToothCount::new(36)?, -4..=5);
/// let closing = rings.iter().filter(|(_, choice)| choice.is_ok()).map(|(ring, _)| ring.get());
/// assert_eq!(closing.collect::<Vec<_>>(), [88, 89, 90, 91, 92, 93, 94, 95]);
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Closing {
    /// Number of planets; 3 by default.
    pub planets: u32,
    /// Basic racks and tools of sun, planet and ring; a shaper without an addendum of its own has the
    /// dedendum of its rack.
    pub profiles: Profiles,
    /// The centre distance; by default the [natural one](natural_centre_distance) of each set.
    pub centre_distance: Option<f64>,
    /// Aim that picks the shifts.
    pub aim: Aim,
    /// Limits for the checks of the sets.
    pub limits: Limits,
}

impl Default for Closing {
    fn default() -> Self {
        Self {
            planets: 3,
            profiles: Profiles::default(),
            centre_distance: None,
            aim: Aim::default(),
            limits: Limits::default(),
        }
    }
}

impl Closing {
    /// The set of sun, planets and ring that the aim picks.
    ///
    /// # Errors
    /// Those of [`natural_centre_distance`], [`Family::new`] and [`Family::choose`].
    pub fn close(&self, teeth: [ToothCount; 3]) -> Result<Choice, Error> {
        let a = match self.centre_distance {
            Some(given) => given,
            None => natural_centre_distance(teeth, *self.profiles.shared())?,
        };
        Family::new(teeth, self.planets, self.profiles, a)?.choose(self.aim, &self.limits)
    }

    /// Ring and set for each offset `z_r − z_s − 2·z_p`, or the reason why the set does not close; rings
    /// without teeth are skipped.
    #[must_use]
    pub fn rings(
        &self,
        sun: ToothCount,
        planet: ToothCount,
        offsets: RangeInclusive<i32>,
    ) -> Vec<(ToothCount, Result<Choice, Error>)> {
        let ring = |offset| {
            let teeth = coaxial_ring(sun.get(), planet.get()).checked_add_signed(offset)?;
            ToothCount::new(teeth).ok()
        };
        offsets.filter_map(ring).map(|ring| (ring, self.close([sun, planet, ring]))).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::involute::family::PARTS;
    use proptest::prelude::*;

    fn count(teeth: u32) -> ToothCount {
        ToothCount::new(teeth).unwrap()
    }

    #[test]
    fn rings_that_do_not_close_say_why() {
        let wind = Closing { centre_distance: Some(584.0 / 21.0), ..Closing::default() };
        let rings = wind.rings(count(18), count(36), -60..=40);
        let why = |ring: u32| {
            let (_, choice) = rings.iter().find(|(teeth, _)| teeth.get() == ring).unwrap();
            choice.as_ref().unwrap_err().to_string()
        };
        assert_eq!(rings.len(), 101);
        assert!(
            why(86).ends_with("contact ratio of the planet–ring mesh 0.682, at least 1.1 needed"),
            "{}",
            why(86)
        );
        assert!(why(96).starts_with("centre distance is 27.8095"), "{}", why(96));
        assert_eq!(
            why(30),
            "internal gear has 30 teeth and the gear inside it 36; the internal one must have more"
        );
    }

    #[test]
    fn a_ring_below_no_teeth_is_passed_over() {
        assert_eq!(Closing::default().rings(count(2), count(1), -5..=-3).len(), 1);
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(40))]
        /// Against the trial of every shift of the sun, step by step.
        #[test]
        fn sets_close_where_some_shift_has_no_fault(
            sun in 12..40_u32, planet in 12..50_u32, offset in -4..=4_i32, thick in 0.2..0.8_f64,
        ) {
            let closing = Closing { limits: Limits { tip_thickness: thick, ..Limits::default() }, ..Closing::default() };
            let ring = count((sun + 2 * planet).checked_add_signed(offset).unwrap());
            let teeth = [count(sun), count(planet), ring];
            let a = natural_centre_distance(teeth, *closing.profiles.shared()).unwrap();
            let family = Family::new(teeth, 3, closing.profiles, a).unwrap();
            let free = |step: i32| {
                let set = family.at(f64::from(step) * 0.02);
                set.is_ok_and(|set| set.faults(&closing.limits).is_empty())
            };
            let by_trial = (-150..150).filter(|step| free(*step)).count();
            // A stretch shorter than a part of the range may be passed over.
            let range = family.searched();
            let passed_over = ((range.end() - range.start()) / f64::from(PARTS) / 0.02).ceil() as usize;
            match closing.close(teeth) {
                Ok(choice) => prop_assert_eq!(choice.set.faults(&closing.limits), vec![]),
                Err(error) => prop_assert!(by_trial <= passed_over, "{} steps of 300, {}", by_trial, error),
            }
        }
    }
}
