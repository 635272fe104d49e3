//! Series of ratios for 2 to 4 speeds of a machine, and where direct drive stands among them.
//!
//! A gearbox of λ speeds has λ − 1 braked gears and direct drive. Where direct drive serves decides the regime:
//! *reduction* (the fastest speed), *overdrive* (the slowest; "multiplication" in the source), *combined* (one between). Series list the
//! fastest output first, so ratios rise.
//!
//! # Where this departs from the print
//! The source takes speeds in a geometric progression and says that this costs nothing in other cases. With
//! three speeds `v₁ < v₂ < v₃`, `d = v₃/v₁`, `q = v₃/v₂`, its series serve the wanted speeds only as far as
//!
//! | regime | printed | right |
//! |---|---|---|
//! | reduction (2.13), (2.33) | 1, q, d | 1, q, d |
//! | overdrive (2.14), (2.34) | 1/d, 1/q, 1 | 1/d, **q/d**, 1 |
//! | combined (2.15), (2.35) | 1/q, 1, q | 1/q, 1, **d/q** |
//!
//! and the two agree only for `d = q²`. [`RatioSeries::of_speeds`] gives the right ones for any speeds;
//! [`PrintedSeries`] keeps the printed. (2.16) is printed with four places and three members, `q²` is missing.
//!
//! # Source
//! multispeed-gearboxes (2.10)–(2.21), (2.33)–(2.35). It calls the combined regime undesirable.

use crate::DesignError;
use crate::quantity::SeriesParameter;
use uom::si::f64::Velocity;
use uom::si::velocity::meter_per_second;

/// Which speeds the gearbox gives by slowing down, which by speeding up.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Regime {
    /// Direct drive is the fastest: all ratios at least 1.
    Reduction,
    /// Direct drive is the slowest: all ratios at most 1.
    Overdrive,
    /// Direct drive is between; undesirable.
    Combined,
}

/// Ratios of a gearbox, the fastest output first, one of them direct drive.
#[derive(Debug, Clone, PartialEq)]
pub struct RatioSeries {
    ratios: Vec<f64>,
    direct: usize,
}

impl RatioSeries {
    /// The series that gives these speeds, listed slowest first, with direct drive in place `direct`
    /// counted from 1, the fastest.
    ///
    /// ```text
    /// i_m = v_direct/v_m
    /// ```
    ///
    /// ```
    /// use epicyclic_schemes::ratio_series::RatioSeries;
    /// use uom::si::f64::Velocity;
    /// use uom::si::velocity::meter_per_second;
    /// # fn main() -> Result<(), epicyclic_schemes::DesignError> {
    /// let speeds = [0.76, 1.33, 1.95].map(Velocity::new::<meter_per_second>);
    /// let series = RatioSeries::of_speeds(&speeds, 1)?;
    /// assert!((series.ratios()[1] - 1.466).abs() < 1e-3 && (series.ratios()[2] - 2.566).abs() < 1e-3);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`DesignError::SpeedCount`], [`DesignError::SpeedsOutOfOrder`], [`DesignError::DirectPlace`].
    pub fn of_speeds(speeds: &[Velocity], direct: usize) -> Result<Self, DesignError> {
        let count = speeds.len();
        counts(count, direct)?;
        let mut before = 0.0;
        for (place, speed) in speeds.iter().enumerate() {
            let speed = speed.get::<meter_per_second>();
            if !(speed > before && speed.is_finite()) {
                return Err(DesignError::SpeedsOutOfOrder { place: place + 1, speed, before });
            }
            before = speed;
        }
        let straight = speeds[count - direct];
        let ratios = speeds.iter().rev().map(|speed| (straight / *speed).value).collect();
        Ok(Self { ratios, direct: direct - 1 })
    }

    /// The geometric series of step `q`: `1, q, q², …` for direct drive in place 1, and as a whole divided
    /// by `q^(direct − 1)` for another place.
    ///
    /// # Errors
    /// [`DesignError::SpeedCount`], [`DesignError::DirectPlace`], [`DesignError::SpeedRange`] for `q ≤ 1`.
    ///
    /// # Source
    /// (2.10)–(2.19).
    pub fn geometric(step: f64, count: usize, direct: usize) -> Result<Self, DesignError> {
        counts(count, direct)?;
        range(SeriesParameter::Step, step)?;
        let power = |place: usize| step.powi(place as i32 - (direct as i32 - 1));
        Ok(Self { ratios: (0..count).map(power).collect(), direct: direct - 1 })
    }

    /// The ratios, the fastest output first.
    #[must_use]
    pub fn ratios(&self) -> &[f64] {
        &self.ratios
    }

    /// Place of direct drive among them, from 0.
    #[must_use]
    pub fn direct(&self) -> usize {
        self.direct
    }

    /// The regime.
    #[must_use]
    pub fn regime(&self) -> Regime {
        match self.direct {
            0 => Regime::Reduction,
            last if last + 1 == self.ratios.len() => Regime::Overdrive,
            _ => Regime::Combined,
        }
    }

    /// Range of speeds `d`, the fastest over the slowest.
    #[must_use]
    pub fn speed_range(&self) -> f64 {
        self.ratios[self.ratios.len() - 1] / self.ratios[0]
    }
}

fn counts(count: usize, direct: usize) -> Result<(), DesignError> {
    if !(2..=4).contains(&count) {
        return Err(DesignError::SpeedCount { count });
    }
    if !(1..=count).contains(&direct) {
        return Err(DesignError::DirectPlace { place: direct, count });
    }
    Ok(())
}

fn range(what: SeriesParameter, value: f64) -> Result<(), DesignError> {
    if value > 1.0 && value.is_finite() { Ok(()) } else { Err(DesignError::SpeedRange { what, value }) }
}

/// Step of a geometric series of `count` speeds over the range `d`: `q = d^(1/(λ − 1))`, from (2.10).
///
/// # Errors
/// [`DesignError::SpeedCount`], [`DesignError::SpeedRange`] for `d ≤ 1`.
pub fn step(speed_range: f64, count: usize) -> Result<f64, DesignError> {
    counts(count, 1)?;
    range(SeriesParameter::SpeedRange, speed_range)?;
    Ok(speed_range.powf(1.0 / (count as f64 - 1.0)))
}

/// A numbered series of the source, as printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct PrintedSeries {
    number: &'static str,
    /// Powers of `q` and of `d` of each member.
    members: &'static [[i32; 2]],
    count: usize,
    direct: usize,
}

const fn printed(
    number: &'static str,
    members: &'static [[i32; 2]],
    count: usize,
    direct: usize,
) -> PrintedSeries {
    PrintedSeries { number, members, count, direct }
}

impl PrintedSeries {
    /// (2.11)–(2.21) and (2.33)–(2.35), in their order.
    pub const ALL: [Self; 14] = [
        printed("(2.11)", &[[0, 0], [0, 1]], 2, 1),
        printed("(2.12)", &[[0, -1], [0, 0]], 2, 2),
        printed("(2.13)", &[[0, 0], [1, 0], [0, 1]], 3, 1),
        printed("(2.14)", &[[0, -1], [-1, 0], [0, 0]], 3, 3),
        printed("(2.15)", &[[-1, 0], [0, 0], [1, 0]], 3, 2),
        // Four places, three members: q² is missing.
        printed("(2.16)", &[[0, 0], [1, 0], [0, 1]], 4, 1),
        printed("(2.17)", &[[0, -1], [-2, 0], [-1, 0], [0, 0]], 4, 4),
        printed("(2.18)", &[[-1, 0], [0, 0], [1, 0], [2, 0]], 4, 2),
        printed("(2.19)", &[[-2, 0], [-1, 0], [0, 0], [1, 0]], 4, 3),
        printed("(2.20)", &[[0, 0], [0, 1]], 2, 1),
        printed("(2.21)", &[[0, -1], [0, 0]], 2, 2),
        printed("(2.33)", &[[0, 0], [1, 0], [0, 1]], 3, 1),
        printed("(2.34)", &[[0, -1], [-1, 0], [0, 0]], 3, 3),
        printed("(2.35)", &[[-1, 0], [0, 0], [1, 0]], 3, 2),
    ];

    /// The series of this number, `(2.14)`.
    #[must_use]
    pub fn numbered(number: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|series| series.number == number)
    }

    /// Its number.
    #[must_use]
    pub fn number(self) -> &'static str {
        self.number
    }

    /// How many speeds it is for.
    #[must_use]
    pub fn count(self) -> usize {
        self.count
    }

    /// Place of direct drive, from 1, the fastest.
    #[must_use]
    pub fn direct(self) -> usize {
        self.direct
    }

    /// Its members for `q`, the fastest speed over the next, and `d`, the fastest over the slowest.
    #[must_use]
    pub fn members(self, q: f64, d: f64) -> Vec<f64> {
        self.members.iter().map(|[of_q, of_d]| q.powi(*of_q) * d.powi(*of_d)).collect()
    }

    /// Whether it gives these speeds (slowest first), each to `tolerance` relative.
    ///
    /// # Errors
    /// Those of [`RatioSeries::of_speeds`].
    pub fn serves(self, speeds: &[Velocity], tolerance: f64) -> Result<bool, DesignError> {
        let right = RatioSeries::of_speeds(speeds, self.direct.min(speeds.len()))?;
        let count = speeds.len();
        let q = (speeds[count - 1] / speeds[count - 2]).value;
        let members = self.members(q, right.speed_range());
        let close = |(a, b): (&f64, &f64)| (a / b - 1.0).abs() <= tolerance;
        Ok(count == self.count && members.len() == count && members.iter().zip(right.ratios()).all(close))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn speeds(values: &[f64]) -> Vec<Velocity> {
        values.iter().map(|v| Velocity::new::<meter_per_second>(*v)).collect()
    }

    #[test]
    fn the_middle_of_the_excavators_series_is_not_the_printed_one() {
        let wheel = speeds(&[0.76, 1.33, 1.95]);
        let series = RatioSeries::of_speeds(&wheel, 3).unwrap();
        assert_eq!(series.regime(), Regime::Overdrive);
        assert!((series.ratios()[1] - 0.76 / 1.33).abs() < 1e-15);
        let serves = |number| PrintedSeries::numbered(number).unwrap().serves(&wheel, 1e-9).unwrap();
        assert!(serves("(2.13)") && serves("(2.33)"));
        assert!(["(2.14)", "(2.34)", "(2.15)", "(2.35)"].into_iter().all(|number| !serves(number)));
    }

    #[test]
    fn speeds_that_are_no_series_are_refused() {
        let refused = |values: &[f64], direct| RatioSeries::of_speeds(&speeds(values), direct).unwrap_err();
        assert_eq!(refused(&[1.0], 1), DesignError::SpeedCount { count: 1 });
        assert_eq!(refused(&[1.0, 2.0], 3), DesignError::DirectPlace { place: 3, count: 2 });
        assert!(matches!(refused(&[2.0, 1.0], 1), DesignError::SpeedsOutOfOrder { place: 2, .. }));
        assert!(matches!(refused(&[f64::NAN, 1.0], 1), DesignError::SpeedsOutOfOrder { place: 1, .. }));
        assert!(RatioSeries::geometric(1.0, 3, 1).is_err());
        assert!(step(0.9, 3).is_err() && step(2.0, 5).is_err());
    }

    proptest! {
        #[test]
        fn geometric_speeds_are_served_by_all_but_the_short_series(q in 1.05..3.0, slowest in 0.1..5.0) {
            for printed in PrintedSeries::ALL {
                let values: Vec<f64> = (0..printed.count()).map(|n| slowest * f64::powi(q, n as i32)).collect();
                let served = printed.serves(&speeds(&values), 1e-12).unwrap();
                prop_assert_eq!(served, printed.number() != "(2.16)", "{}", printed.number());
                let series = RatioSeries::of_speeds(&speeds(&values), printed.direct()).unwrap();
                let geometric = RatioSeries::geometric(q, printed.count(), printed.direct()).unwrap();
                for (a, b) in series.ratios().iter().zip(geometric.ratios()) {
                    prop_assert!((a / b - 1.0).abs() < 1e-13);
                }
                prop_assert!((step(series.speed_range(), printed.count()).unwrap() - q).abs() < 1e-12);
            }
        }
    }
}
