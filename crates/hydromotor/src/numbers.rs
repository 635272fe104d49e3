//! Admissible numbers of lobes and teeth of a motor.
//!
//! ```text
//! 1 ≤ N − n ≤ 3          Z_3/N = Z_1/n = an integer          Z_s < (Z_3 − Z_1)/2
//! ```
//!
//! | symbol | meaning |
//! |---|---|
//! | `N`, `n` | lobes of the stator (the outer wheel 3) and of the rotor (the inner wheel 1) |
//! | `Z_3`, `Z_1`, `Z_s` | teeth of stator, rotor and satellite |
//!
//! Reasons:
//!
//! - *`N > n`*: with fewer arches than lobes the centrodes of the two wheels interfere.
//! - *`N − n ≤ 3`*: with more the satellites are too far from being neighbours.
//! - *`Z_3/N` an integer*: assembly; all arches then have their teeth alike.
//! - *`Z_1/n` the same*: both wheels roll equal arcs on the satellite in a half-lobe, so their lobes are
//!   equally long. All `N + n` satellites pass one another's places, a rotor's `1/n` turn apart; their teeth
//!   are in phase when the common value is an integer.
//! - *`Z_s < (Z_3 − Z_1)/2`*: at equality both centrodes are circles and no chamber changes its volume.
//!
//! Two remarks of the source concern the choice. A common divisor of `N` and `n` makes the reactions in the
//! bearings of the central wheels vanish ([`MotorNumbers::bearing_reactions_vanish`]), since the pressures
//! then repeat around the axis. The source also says that the torque fluctuates less the closer `N/n` is to
//! 1, which is not so: the number of pulses decides first ([`MotorNumbers::pulses_per_cycle`], derived in
//! [`crate::flow`]). 7×4 with `N/n = 1.75` has 22 pulses and a ripple of 1.8 %, 6×4 with 1.5 has 10 and
//! 7.4 %. Both have 11 teeth a lobe and satellites of 10, each 0.3 along its family.
//!
//! # Source
//! rotary-hydromotor, conditions 1–4. The copy lost the sides of `Z_1/n = Z_3/N` and the bound of `Z_s`; both
//! are restored from the mechanics, and follow from the closure of the rotor ([`crate::closure`]).

use crate::quantity::{Quantity, WheelKind};
use std::ops::RangeInclusive;

use crate::Error;

/// The greatest difference `N − n`.
pub const MOST_LOBE_DIFFERENCE: u32 = 3;

/// The greatest number of stator teeth that the crate reckons with.
pub const MOST_TEETH: u32 = 10_000;

/// Numbers of lobes and teeth that fulfil every condition.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct MotorNumbers {
    stator_lobes: u32,
    rotor_lobes: u32,
    stator_teeth: u32,
    satellite_teeth: u32,
}

impl MotorNumbers {
    /// Numbers `N`, `n`, `Z_3`, `Z_s`; the rotor's teeth follow, `Z_1 = n·Z_3/N`.
    ///
    /// # Errors
    /// One variant a condition: [`Error::NoLobes`], [`Error::NoTeeth`], [`Error::TooManyTeeth`],
    /// [`Error::LobesNotMore`], [`Error::LobesTooDifferent`], [`Error::TeethPerLobe`],
    /// [`Error::SatelliteTooLarge`].
    ///
    /// # Example
    /// ```
    /// use epicyclic_hydromotor::MotorNumbers;
    ///
    /// let numbers = MotorNumbers::new(5, 3, 55, 10)?;
    /// assert_eq!((numbers.rotor_teeth(), numbers.satellites()), (33, 8));
    /// # Ok::<(), epicyclic_hydromotor::Error>(())
    /// ```
    pub fn new(
        stator_lobes: u32,
        rotor_lobes: u32,
        stator_teeth: u32,
        satellite_teeth: u32,
    ) -> Result<Self, Error> {
        let numbers = Self { stator_lobes, rotor_lobes, stator_teeth, satellite_teeth };
        numbers.faults().into_iter().next().map_or(Ok(numbers), Err)
    }

    /// All independent faults of numbers `N`, `n`, `Z_3`, `Z_s`; none for the numbers of a motor.
    ///
    /// ```
    /// use epicyclic_hydromotor::{Error, MotorNumbers};
    ///
    /// let faults = MotorNumbers::all_faults(5, 5, 54, 10);
    /// assert!(matches!(faults[..], [Error::LobesNotMore { .. }, Error::TeethPerLobe { .. }]));
    /// ```
    #[must_use]
    pub fn all_faults(
        stator_lobes: u32,
        rotor_lobes: u32,
        stator_teeth: u32,
        satellite_teeth: u32,
    ) -> Vec<Error> {
        Self { stator_lobes, rotor_lobes, stator_teeth, satellite_teeth }.faults()
    }

    fn faults(self) -> Vec<Error> {
        let Self { stator_lobes: stator, rotor_lobes: rotor, stator_teeth, satellite_teeth } = self;
        let mut faults = vec![];
        for (wheel, lobes) in [(WheelKind::Stator, stator), (WheelKind::Rotor, rotor)] {
            if lobes == 0 {
                faults.push(Error::NoLobes { wheel });
            }
        }
        for (wheel, teeth) in [(WheelKind::Stator, stator_teeth), (WheelKind::Satellite, satellite_teeth)] {
            if teeth == 0 {
                faults.push(Error::NoTeeth { wheel });
            }
        }
        if stator_teeth > MOST_TEETH {
            let wheel = WheelKind::Stator;
            faults.push(Error::TooManyTeeth { wheel, teeth: stator_teeth, most: MOST_TEETH });
        }
        let most = MOST_LOBE_DIFFERENCE;
        if stator > 0 && rotor > 0 {
            if stator <= rotor {
                faults.push(Error::LobesNotMore { stator, rotor, most });
            } else if stator - rotor > most {
                faults.push(Error::LobesTooDifferent { stator, rotor, most });
            }
        }
        if stator > 0 && (1..=MOST_TEETH).contains(&stator_teeth) {
            faults.extend(evenly_shared(WheelKind::Stator, stator_teeth, stator).err());
        }
        // The limit of the satellite follows from all other numbers.
        if faults.is_empty() {
            // (Z_3 − Z_1)/2 is half a whole number: the greatest Z_s below it is the next whole one down.
            let twice_limit = stator_teeth - self.rotor_teeth();
            if satellite_teeth >= twice_limit.div_ceil(2) {
                faults.push(Error::SatelliteTooLarge {
                    teeth: satellite_teeth,
                    limit: f64::from(twice_limit) / 2.0,
                    most: twice_limit.div_ceil(2) - 1,
                });
            }
        }
        faults
    }

    /// Numbers as by [`new`](Self::new), with the rotor's teeth `Z_1` given and checked.
    ///
    /// # Errors
    /// Errors of [`new`](Self::new); [`Error::TeethPerLobe`] if `Z_1/n` is no integer;
    /// [`Error::TeethPerLobeDiffer`] if `Z_1/n` differs from `Z_3/N`.
    pub fn with_rotor_teeth(
        stator_lobes: u32,
        rotor_lobes: u32,
        stator_teeth: u32,
        rotor_teeth: u32,
        satellite_teeth: u32,
    ) -> Result<Self, Error> {
        if rotor_teeth == 0 {
            return Err(Error::NoTeeth { wheel: WheelKind::Rotor });
        }
        if rotor_lobes > 0 {
            evenly_shared(WheelKind::Rotor, rotor_teeth, rotor_lobes)?;
        }
        let numbers = Self::new(stator_lobes, rotor_lobes, stator_teeth, satellite_teeth)?;
        if rotor_teeth == numbers.rotor_teeth() {
            Ok(numbers)
        } else {
            Err(Error::TeethPerLobeDiffer { rotor_teeth, needed: numbers.rotor_teeth() })
        }
    }

    /// Lobes of the stator, `N`.
    #[must_use]
    pub fn stator_lobes(self) -> u32 {
        self.stator_lobes
    }

    /// Lobes of the rotor, `n`.
    #[must_use]
    pub fn rotor_lobes(self) -> u32 {
        self.rotor_lobes
    }

    /// Teeth of the stator, `Z_3`.
    #[must_use]
    pub fn stator_teeth(self) -> u32 {
        self.stator_teeth
    }

    /// Teeth of the rotor, `Z_1 = n·Z_3/N`.
    #[must_use]
    pub fn rotor_teeth(self) -> u32 {
        self.teeth_per_lobe() * self.rotor_lobes
    }

    /// Teeth of a satellite, `Z_s`.
    #[must_use]
    pub fn satellite_teeth(self) -> u32 {
        self.satellite_teeth
    }

    /// Teeth of a lobe, of stator and rotor alike: `Z_3/N = Z_1/n`.
    #[must_use]
    pub fn teeth_per_lobe(self) -> u32 {
        self.stator_teeth / self.stator_lobes
    }

    /// Number of satellites and of chambers, `N + n`.
    #[must_use]
    pub fn satellites(self) -> u32 {
        self.stator_lobes + self.rotor_lobes
    }

    /// `N/n`. It does not order the ripple of motors: see [`pulses_per_cycle`](Self::pulses_per_cycle).
    #[must_use]
    pub fn lobe_ratio(self) -> f64 {
        f64::from(self.stator_lobes) / f64::from(self.rotor_lobes)
    }

    /// The greatest common divisor of `N` and `n`: how often the chambers repeat around the axis.
    #[must_use]
    pub fn common_divisor(self) -> u32 {
        let (mut a, mut b) = (self.stator_lobes, self.rotor_lobes);
        while b > 0 {
            (a, b) = (b, a % b);
        }
        a
    }

    /// Pulses of flow and torque in a cycle, while a satellite passes from one crest of the stator to the
    /// next.
    ///
    /// ```text
    /// M = (N + n)/d for an even quotient, else twice as many        d = gcd(N, n)
    /// ```
    ///
    /// The chambers have `(N + n)/d` different phases. With an even number one chamber is greatest while
    /// another is least; with an odd number these changeovers alternate, as with the pistons of a pump
    /// ([`crate::flow`]).
    ///
    /// ```
    /// use epicyclic_hydromotor::MotorNumbers;
    ///
    /// assert_eq!(MotorNumbers::new(5, 3, 55, 10)?.pulses_per_cycle(), 8);
    /// assert_eq!(MotorNumbers::new(6, 4, 66, 10)?.pulses_per_cycle(), 10); // 5 phases
    /// assert_eq!(MotorNumbers::new(7, 4, 77, 10)?.pulses_per_cycle(), 22); // 11 phases
    /// # Ok::<(), epicyclic_hydromotor::Error>(())
    /// ```
    #[must_use]
    pub fn pulses_per_cycle(self) -> u32 {
        self.changeovers_alternate() * self.satellites() / self.common_divisor()
    }

    /// Pulses of flow and torque in a revolution of the rotor: the least common multiple of `N` and `n`,
    /// doubled where `(N + n)/gcd(N, n)` is odd.
    #[must_use]
    pub fn pulses_per_revolution(self) -> u32 {
        self.changeovers_alternate() * (self.stator_lobes / self.common_divisor()) * self.rotor_lobes
    }

    /// 2 where chambers reach their greatest and their least area in turn, 1 where two do so at once.
    fn changeovers_alternate(self) -> u32 {
        1 + self.satellites() / self.common_divisor() % 2
    }

    /// Whether the pressures put no load on the bearings of the central wheels: they repeat at least twice
    /// around the axis.
    #[must_use]
    pub fn bearing_reactions_vanish(self) -> bool {
        self.common_divisor() > 1
    }
}

fn evenly_shared(wheel: WheelKind, teeth: u32, lobes: u32) -> Result<(), Error> {
    if teeth.is_multiple_of(lobes) {
        return Ok(());
    }
    let below = (teeth / lobes).max(1) * lobes;
    Err(Error::TeethPerLobe {
        wheel,
        teeth,
        lobes,
        below,
        above: below.max((teeth / lobes + 1).saturating_mul(lobes)),
    })
}

/// Bounds of an enumeration.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Bounds {
    /// Lobes of the stator, `N`.
    pub stator_lobes: RangeInclusive<u32>,
    /// Teeth of the stator, `Z_3`.
    pub stator_teeth: RangeInclusive<u32>,
    /// Teeth of a satellite, `Z_s`.
    pub satellite_teeth: RangeInclusive<u32>,
}

impl Default for Bounds {
    /// `N ≤ 10`, `Z_3 ≤ 120`, `Z_s ≥ 8`.
    fn default() -> Self {
        Self { stator_lobes: 2..=10, stator_teeth: 1..=120, satellite_teeth: 8..=60 }
    }
}

impl Bounds {
    /// Every admissible set within the bounds, by rising `N`, `n`, `Z_3`, `Z_s`.
    ///
    /// [`crate::closure::Family`] decides whether a set closes with two arcs.
    ///
    /// # Errors
    /// [`Error::EmptyRange`] for bounds the wrong way round, [`Error::TooManyTeeth`] above [`MOST_TEETH`].
    ///
    /// # Example
    /// ```
    /// use epicyclic_hydromotor::numbers::Bounds;
    ///
    /// let bounds = Bounds { stator_lobes: 5..=5, stator_teeth: 55..=55, satellite_teeth: 8..=60 };
    /// let sets = bounds.all()?;
    /// // Z_s < 11 with three rotor lobes, < 5.5 with four, < 16.5 with two.
    /// assert_eq!(sets.len(), 9 + 3);
    /// # Ok::<(), epicyclic_hydromotor::Error>(())
    /// ```
    pub fn all(&self) -> Result<Vec<MotorNumbers>, Error> {
        let mut sets = Vec::new();
        for (stator, rotor, per_lobe, satellites) in self.lobes()? {
            for satellite in satellites {
                sets.push(MotorNumbers::new(stator, rotor, per_lobe * stator, satellite)?);
            }
        }
        Ok(sets)
    }

    /// Number of sets that [`all`](Self::all) returns, without making them.
    ///
    /// # Errors
    /// Errors of [`all`](Self::all).
    pub fn count(&self) -> Result<u64, Error> {
        let of = |satellites: RangeInclusive<u32>| {
            u64::from((satellites.end() + 1).saturating_sub(*satellites.start()))
        };
        Ok(self.lobes()?.map(|(_, _, _, satellites)| of(satellites)).sum())
    }

    /// `N`, `n`, teeth per lobe, and the range of `Z_s`, which may be empty.
    fn lobes(&self) -> Result<impl Iterator<Item = (u32, u32, u32, RangeInclusive<u32>)>, Error> {
        for (what, range) in [
            (Quantity::StatorLobes, &self.stator_lobes),
            (Quantity::StatorTeeth, &self.stator_teeth),
            (Quantity::SatelliteTeeth, &self.satellite_teeth),
        ] {
            let (from, to) = (*range.start(), *range.end());
            if from > to {
                return Err(Error::EmptyRange { what, from, to });
            }
        }
        let [least_teeth, most_teeth] = [*self.stator_teeth.start(), *self.stator_teeth.end()];
        if most_teeth > MOST_TEETH {
            return Err(Error::TooManyTeeth {
                wheel: WheelKind::Stator,
                teeth: most_teeth,
                most: MOST_TEETH,
            });
        }
        let [least_satellite, most_satellite] = [*self.satellite_teeth.start(), *self.satellite_teeth.end()];
        // A lobe has at least one tooth: no more lobes than teeth.
        let (least, most) = (*self.stator_lobes.start(), *self.stator_lobes.end());
        let pairs = (least.max(2)..=most.min(most_teeth)).flat_map(|stator| {
            (stator.saturating_sub(MOST_LOBE_DIFFERENCE).max(1)..stator).map(move |rotor| (stator, rotor))
        });
        Ok(pairs.flat_map(move |(stator, rotor)| {
            (least_teeth.div_ceil(stator).max(1)..=most_teeth / stator).map(move |per_lobe| {
                let twice_limit = per_lobe * (stator - rotor);
                let largest = most_satellite.min(twice_limit.div_ceil(2).saturating_sub(1));
                (stator, rotor, per_lobe, least_satellite.max(1)..=largest)
            })
        }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn the_difference_of_lobes_gives_the_pulses() {
        for rotor in 1..200 {
            for more in 1..=3 {
                let numbers = MotorNumbers {
                    stator_lobes: rotor + more,
                    rotor_lobes: rotor,
                    stator_teeth: 0,
                    satellite_teeth: 0,
                };
                let all = 2 * rotor + more;
                let pulses = match more {
                    2 => all,
                    3 if rotor % 3 == 0 => 2 * all / 3,
                    _ => 2 * all,
                };
                assert_eq!(numbers.pulses_per_cycle(), pulses, "{rotor} + {more}");
                let cycles = (rotor + more) * rotor;
                assert_eq!(numbers.pulses_per_revolution() * all, pulses * cycles, "{rotor} + {more}");
            }
        }
    }

    #[test]
    fn the_motors_of_the_source_are_admissible() {
        let five = MotorNumbers::with_rotor_teeth(5, 3, 55, 33, 10).unwrap();
        assert_eq!((five.satellites(), five.teeth_per_lobe()), (8, 11));
        assert!(!five.bearing_reactions_vanish());
        let six = MotorNumbers::with_rotor_teeth(6, 4, 66, 44, 10).unwrap();
        assert!(six.bearing_reactions_vanish() && six.lobe_ratio() < five.lobe_ratio());
    }

    #[test]
    fn every_condition_has_its_own_error() {
        let refused = |n3, n1, z3, zs| MotorNumbers::new(n3, n1, z3, zs).unwrap_err();
        assert_eq!(refused(0, 3, 55, 10), Error::NoLobes { wheel: WheelKind::Stator });
        assert_eq!(refused(5, 0, 55, 10), Error::NoLobes { wheel: WheelKind::Rotor });
        assert_eq!(refused(5, 3, 0, 10), Error::NoTeeth { wheel: WheelKind::Stator });
        assert_eq!(refused(5, 3, 55, 0), Error::NoTeeth { wheel: WheelKind::Satellite });
        assert!(matches!(refused(5, 3, 20_000, 10), Error::TooManyTeeth { .. }));
        assert!(matches!(refused(5, 5, 55, 10), Error::LobesNotMore { .. }));
        assert!(matches!(refused(3, 5, 55, 10), Error::LobesNotMore { .. }));
        assert!(matches!(refused(7, 3, 70, 10), Error::LobesTooDifferent { .. }));
        let uneven =
            Error::TeethPerLobe { wheel: WheelKind::Stator, teeth: 56, lobes: 5, below: 55, above: 60 };
        assert_eq!(refused(5, 3, 56, 10), uneven);
        assert_eq!(refused(5, 3, 55, 11), Error::SatelliteTooLarge { teeth: 11, limit: 11.0, most: 10 });
        assert_eq!(refused(5, 4, 55, 6), Error::SatelliteTooLarge { teeth: 6, limit: 5.5, most: 5 });
        assert!(MotorNumbers::new(5, 4, 55, 5).is_ok());
        let with = |z1| MotorNumbers::with_rotor_teeth(5, 3, 55, z1, 10).unwrap_err();
        assert_eq!(with(0), Error::NoTeeth { wheel: WheelKind::Rotor });
        assert!(matches!(
            with(34),
            Error::TeethPerLobe { wheel: WheelKind::Rotor, below: 33, above: 36, .. }
        ));
        assert_eq!(with(30), Error::TeethPerLobeDiffer { rotor_teeth: 30, needed: 33 });
    }

    #[test]
    #[allow(clippy::reversed_empty_ranges)] // the fault under test
    fn bounds_the_wrong_way_round_are_refused() {
        let bounds = Bounds { stator_lobes: 6..=5, ..Bounds::default() };
        assert_eq!(bounds.all(), Err(Error::EmptyRange { what: Quantity::StatorLobes, from: 6, to: 5 }));
        let many = Bounds { stator_teeth: 1..=u32::MAX, ..Bounds::default() };
        assert!(matches!(many.all(), Err(Error::TooManyTeeth { .. })));
    }

    proptest! {
        #[test]
        fn enumeration_finds_what_trial_finds(
            lobes in 1..9_u32, more in 0..4_u32, teeth in 1..60_u32, wider in 0..20_u32, least in 0..9_u32, width in 0..9_u32,
        ) {
            let bounds = Bounds {
                stator_lobes: lobes..=lobes + more,
                stator_teeth: teeth..=teeth + wider,
                satellite_teeth: least..=least + width,
            };
            let mut trial = Vec::new();
            for stator in bounds.stator_lobes.clone() {
                for rotor in 1..=stator {
                    for teeth in bounds.stator_teeth.clone() {
                        for satellite in bounds.satellite_teeth.clone() {
                            trial.extend(MotorNumbers::new(stator, rotor, teeth, satellite));
                        }
                    }
                }
            }
            prop_assert_eq!(bounds.count().unwrap(), trial.len() as u64);
            prop_assert_eq!(bounds.all().unwrap(), trial);
        }

        #[test]
        fn any_numbers_are_accepted_or_refused(
            a in any::<u32>(), b in any::<u32>(), c in any::<u32>(), d in any::<u32>(), e in any::<u32>(),
        ) {
            let _ = MotorNumbers::with_rotor_teeth(a, b, c, d, e);
            let _ = MotorNumbers::new(a % 12, b % 12, c % 200, d % 30);
        }
    }
}
