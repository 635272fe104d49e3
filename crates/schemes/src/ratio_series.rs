//! Series of ratios for 2 to 4 speeds of a machine, and the place of direct drive among them.
//!
//! A gearbox of λ speeds has λ − 1 braked gears and direct drive. The place of direct drive decides the
//! regime: *reduction* (the fastest speed), *overdrive* (the slowest; "multiplication" in the source),
//! *combined* (one between). Series list the fastest output first, so ratios rise.
//!
//! # Where this departs from the print
//! The source takes speeds in a geometric progression and says that this costs nothing in other cases. Let
//! three speeds be `v₁ < v₂ < v₃`, with `d = v₃/v₁` and `q = v₃/v₂`. Its series then serve the required
//! speeds only in part:
//!
//! | regime | printed | right |
//! |---|---|---|
//! | reduction (2.13), (2.33) | 1, q, d | 1, q, d |
//! | overdrive (2.14), (2.34) | 1/d, 1/q, 1 | 1/d, **q/d**, 1 |
//! | combined (2.15), (2.35) | 1/q, 1, q | 1/q, 1, **d/q** |
//!
//! Both columns agree only for `d = q²`. [`RatioSeries::of_speeds`] gives the right ratios for any speeds;
//! [`PrintedSeries`] keeps the printed ones. (2.16) is printed with four places and three members, `q²` is
//! missing.
//!
//! # Source
//! multispeed-gearboxes (2.10)–(2.21), (2.33)–(2.35). It calls the combined regime undesirable.

use crate::Error;
use crate::quantity::SeriesParameter;
use epicyclic_units::Physical;
use uom::si::f64::Velocity;

/// Regime of a gearbox: whether it gives the other speeds by slowing down, by speeding up, or both.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "names", derive(serde::Serialize, schemars::JsonSchema))]
#[cfg_attr(feature = "names", serde(rename_all = "snake_case"), schemars(rename = "Regime"))]
pub enum Regime {
    /// Direct drive is the fastest: all ratios at least 1.
    Reduction,
    /// Direct drive is the slowest: all ratios at most 1.
    Overdrive,
    /// Direct drive is between the other speeds; undesirable.
    Combined,
}

/// Ratios of a gearbox with direct drive among them, in the order of its gears: of a series from speeds the
/// fastest output first.
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
    /// # fn main() -> Result<(), epicyclic_schemes::Error> {
    /// let speeds = [0.76, 1.33, 1.95].map(Velocity::new::<meter_per_second>);
    /// let series = RatioSeries::of_speeds(&speeds, 1)?;
    /// assert!((series.ratios()[1] - 1.466).abs() < 1e-3 && (series.ratios()[2] - 2.566).abs() < 1e-3);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`Error::SpeedCount`], [`Error::SpeedsOutOfOrder`], [`Error::DirectPlace`].
    pub fn of_speeds(speeds: &[Velocity], direct: usize) -> Result<Self, Error> {
        let count = speeds.len();
        counts(count, direct)?;
        let mut before = 0.0;
        for (place, speed) in speeds.iter().enumerate() {
            let speed = speed.si();
            if !(speed > before && speed.is_finite()) {
                return Err(Error::SpeedsOutOfOrder { place: place + 1, speed, before });
            }
            before = speed;
        }
        let straight = speeds[count - direct];
        let ratios = speeds.iter().rev().map(|speed| (straight / *speed).value).collect();
        Ok(Self { ratios, direct: direct - 1 })
    }

    /// Series for the range of speeds `d`, fastest over slowest, and with three speeds also `q`, fastest over
    /// middle. Direct drive is the fastest speed.
    ///
    /// ```text
    /// v₁ < v₂          d = v₂/v₁                 ratios  1, d
    /// v₁ < v₂ < v₃     d = v₃/v₁   q = v₃/v₂     ratios  1, q, d
    /// ```
    ///
    /// # Errors
    /// [`Error::SpeedRange`], [`Error::MiddleSpeed`].
    ///
    /// # Source
    /// Section 3.2.
    pub fn of_range(d: f64, q: Option<f64>) -> Result<Self, Error> {
        range(SeriesParameter::SpeedRange, d)?;
        match q {
            None => Self::of_braked_gears(&[d]),
            Some(q) if q > 1.0 && q < d => Self::of_braked_gears(&[q, d]),
            Some(q) => Err(Error::MiddleSpeed { q, d }),
        }
    }

    /// Series of direct drive and the ratios of the braked gears, in their order and with their signs.
    ///
    /// # Errors
    /// [`Error::RatioCount`], [`Error::Ratio`], [`Error::EqualRatios`].
    pub fn of_braked_gears(ratios: &[f64]) -> Result<Self, Error> {
        if !(1..=3).contains(&ratios.len()) {
            return Err(Error::RatioCount { count: ratios.len() });
        }
        for (place, &ratio) in ratios.iter().enumerate() {
            if !ratio.is_finite() || ratio == 0.0 || ratio == 1.0 {
                return Err(Error::Ratio { ratio });
            }
            if ratios[..place].contains(&ratio) {
                return Err(Error::EqualRatios { ratio });
            }
        }
        Ok(Self { ratios: std::iter::once(1.0).chain(ratios.iter().copied()).collect(), direct: 0 })
    }

    /// The geometric series of step `q`: `1, q, q², …` for direct drive in place 1, and as a whole divided
    /// by `q^(direct − 1)` for another place.
    ///
    /// # Errors
    /// [`Error::SpeedCount`], [`Error::DirectPlace`], [`Error::SpeedRange`] for `q ≤ 1`.
    ///
    /// # Source
    /// (2.10)–(2.19).
    pub fn geometric(step: f64, count: usize, direct: usize) -> Result<Self, Error> {
        counts(count, direct)?;
        range(SeriesParameter::Step, step)?;
        let power = |place: usize| step.powi(place as i32 - (direct as i32 - 1));
        Ok(Self { ratios: (0..count).map(power).collect(), direct: direct - 1 })
    }

    /// The ratios, direct drive among them.
    #[must_use]
    pub fn ratios(&self) -> &[f64] {
        &self.ratios
    }

    /// The ratios of the braked gears: all but direct drive.
    #[must_use]
    pub fn braked(&self) -> Vec<f64> {
        let braked = self.ratios.iter().enumerate().filter(|(place, _)| *place != self.direct);
        braked.map(|(_, ratio)| *ratio).collect()
    }

    /// Place of direct drive among them, from 0.
    #[must_use]
    pub fn direct(&self) -> usize {
        self.direct
    }

    /// The regime.
    #[must_use]
    pub fn regime(&self) -> Regime {
        let slows = self.ratios.iter().any(|ratio| ratio.abs() > 1.0);
        let speeds_up = self.ratios.iter().any(|ratio| ratio.abs() < 1.0);
        match (slows, speeds_up) {
            (true, true) => Regime::Combined,
            (false, true) => Regime::Overdrive,
            (_, false) => Regime::Reduction,
        }
    }

    /// Range of speeds `d`, the fastest over the slowest.
    #[must_use]
    pub fn speed_range(&self) -> f64 {
        let sizes = self.ratios.iter().map(|ratio| ratio.abs());
        sizes.clone().fold(0.0, f64::max) / sizes.fold(f64::INFINITY, f64::min)
    }
}

fn counts(count: usize, direct: usize) -> Result<(), Error> {
    if !(2..=4).contains(&count) {
        return Err(Error::SpeedCount { count });
    }
    if !(1..=count).contains(&direct) {
        return Err(Error::DirectPlace { place: direct, count });
    }
    Ok(())
}

fn range(what: SeriesParameter, value: f64) -> Result<(), Error> {
    if value > 1.0 && value.is_finite() { Ok(()) } else { Err(Error::SpeedRange { what, value }) }
}

/// Step of a geometric series of `count` speeds over the range `d`: `q = d^(1/(λ − 1))`, from (2.10).
///
/// # Errors
/// [`Error::SpeedCount`], [`Error::SpeedRange`] for `d ≤ 1`.
pub fn step(speed_range: f64, count: usize) -> Result<f64, Error> {
    counts(count, 1)?;
    range(SeriesParameter::SpeedRange, speed_range)?;
    Ok(libm::pow(speed_range, 1.0 / (count as f64 - 1.0)))
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
    /// (2.11)–(2.21) and (2.33)–(2.35), in their order; (2.10) for four speeds last, which (2.16) repeats
    /// with a fault.
    pub const ALL: [Self; 15] = [
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
        printed("(2.10)", &[[0, 0], [1, 0], [2, 0], [3, 0]], 4, 1),
    ];

    /// The series of this number, `(2.14)`.
    #[must_use]
    pub fn numbered(number: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|series| series.number == number)
    }

    /// Number in the source.
    #[must_use]
    pub fn number(self) -> &'static str {
        self.number
    }

    /// Number of speeds of the series.
    #[must_use]
    pub fn count(self) -> usize {
        self.count
    }

    /// Place of direct drive, from 1, the fastest.
    #[must_use]
    pub fn direct(self) -> usize {
        self.direct
    }

    /// Members of the series for `q`, the fastest speed over the next, and `d`, the fastest over the slowest.
    #[must_use]
    pub fn members(self, q: f64, d: f64) -> Vec<f64> {
        self.members.iter().map(|[of_q, of_d]| q.powi(*of_q) * d.powi(*of_d)).collect()
    }

    /// Whether the series gives these speeds (slowest first), each to `tolerance` relative.
    ///
    /// # Errors
    /// Those of [`RatioSeries::of_speeds`].
    pub fn serves(self, speeds: &[Velocity], tolerance: f64) -> Result<bool, Error> {
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
        values.iter().map(|v| Velocity::from_si(*v)).collect()
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
        assert_eq!(refused(&[1.0], 1), Error::SpeedCount { count: 1 });
        assert_eq!(refused(&[1.0, 2.0], 3), Error::DirectPlace { place: 3, count: 2 });
        assert!(matches!(refused(&[2.0, 1.0], 1), Error::SpeedsOutOfOrder { place: 2, .. }));
        assert!(matches!(refused(&[f64::NAN, 1.0], 1), Error::SpeedsOutOfOrder { place: 1, .. }));
        assert!(RatioSeries::geometric(1.0, 3, 1).is_err());
        assert!(step(0.9, 3).is_err() && step(2.0, 5).is_err());
    }

    #[test]
    fn a_range_and_the_braked_gears_make_a_series() {
        let series = RatioSeries::of_range(2.566, Some(1.466)).unwrap();
        assert_eq!((series.ratios(), series.braked()), (&[1.0, 1.466, 2.566][..], vec![1.466, 2.566]));
        assert_eq!((series.regime(), series.speed_range()), (Regime::Reduction, 2.566));
        let mixed = RatioSeries::of_braked_gears(&[-2.0, 0.5]).unwrap();
        assert_eq!((mixed.regime(), mixed.speed_range(), mixed.direct()), (Regime::Combined, 4.0, 0));
        assert_eq!(RatioSeries::of_range(2.0, Some(3.0)), Err(Error::MiddleSpeed { q: 3.0, d: 2.0 }));
        assert!(matches!(RatioSeries::of_range(1.0, None), Err(Error::SpeedRange { .. })));
        assert!(RatioSeries::of_range(f64::NAN, None).is_err());
        for bad in [0.0, 1.0, f64::NAN, f64::INFINITY] {
            assert!(matches!(RatioSeries::of_braked_gears(&[bad, 2.0]), Err(Error::Ratio { .. })), "{bad}");
        }
        assert_eq!(RatioSeries::of_braked_gears(&[2.0, 2.0]), Err(Error::EqualRatios { ratio: 2.0 }));
        assert_eq!(RatioSeries::of_braked_gears(&[]), Err(Error::RatioCount { count: 0 }));
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
