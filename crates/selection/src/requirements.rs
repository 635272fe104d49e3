//! What is wanted of a gearbox: ratios, their tolerance, and the limits of section 3.1.

use super::SelectionError;
use super::size::Rating;
use crate::quantity::{KRange, Limited};
use crate::units::metres_per_second;
use epicyclic_gears::efficiency::MeshEfficiency;
use std::ops::RangeInclusive;
use uom::si::f64::Velocity;

/// Ratios wanted of the braked gears beside direct drive: one or two.
///
/// ```text
/// v₁ < v₂          d = v₂/v₁                 ratios  d
/// v₁ < v₂ < v₃     d = v₃/v₁   q = v₃/v₂     ratios  q, d
/// ```
///
/// # Source
/// multispeed-gearboxes, section 3.2.
#[derive(Debug, Clone, PartialEq)]
pub struct RatioSeries(Vec<f64>);

impl RatioSeries {
    /// Of two or three rising speeds, the fastest in direct drive.
    ///
    /// # Errors
    /// [`SelectionError::SpeedCount`], [`SelectionError::SpeedsOutOfOrder`].
    pub fn of_speeds(speeds: &[Velocity]) -> Result<Self, SelectionError> {
        let speeds: Vec<f64> = speeds.iter().copied().map(metres_per_second).collect();
        if !(2..=3).contains(&speeds.len()) {
            return Err(SelectionError::SpeedCount { count: speeds.len() });
        }
        let mut before = 0.0;
        for (place, &speed) in speeds.iter().enumerate() {
            if !(speed > before && speed.is_finite()) {
                return Err(SelectionError::SpeedsOutOfOrder { place: place + 1, speed, before });
            }
            before = speed;
        }
        Self::new(&speeds.iter().rev().skip(1).map(|speed| before / speed).collect::<Vec<_>>())
    }

    /// Of the range of speeds `d`, fastest over slowest, and with three speeds of `q`, fastest over
    /// middle.
    ///
    /// # Errors
    /// [`SelectionError::SpeedRange`], [`SelectionError::MiddleSpeed`].
    pub fn of_range(d: f64, q: Option<f64>) -> Result<Self, SelectionError> {
        if !(d > 1.0 && d.is_finite()) {
            return Err(SelectionError::SpeedRange { d });
        }
        match q {
            None => Self::new(&[d]),
            Some(q) if q > 1.0 && q < d => Self::new(&[q, d]),
            Some(q) => Err(SelectionError::MiddleSpeed { q, d }),
        }
    }

    /// Of the ratios themselves, in the order of the gears.
    ///
    /// # Errors
    /// [`SelectionError::RatioCount`], [`SelectionError::Ratio`], [`SelectionError::EqualRatios`].
    pub fn new(ratios: &[f64]) -> Result<Self, SelectionError> {
        if !(1..=2).contains(&ratios.len()) {
            return Err(SelectionError::RatioCount { count: ratios.len() });
        }
        for &ratio in ratios {
            if !ratio.is_finite() || ratio == 0.0 || ratio == 1.0 {
                return Err(SelectionError::Ratio { ratio });
            }
        }
        if ratios.len() == 2 && ratios[0] == ratios[1] {
            return Err(SelectionError::EqualRatios { ratio: ratios[0] });
        }
        Ok(Self(ratios.to_vec()))
    }

    /// The ratios.
    #[must_use]
    pub fn ratios(&self) -> &[f64] {
        &self.0
    }
}

/// Which gear may have which of two ratios.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Orders {
    /// The first brake gives the first ratio.
    AsGiven,
    /// Either brake gives either.
    #[default]
    Both,
}

/// Which signs the ratios may have.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Signs {
    /// Those given.
    AsGiven,
    /// All positive, or all negative.
    #[default]
    Alike,
    /// Each by itself.
    Any,
}

/// Limits of section 3.1; infinity (of an efficiency 0) lifts one.
#[derive(Debug, Clone, PartialEq)]
pub struct Limits {
    /// Ring-to-sun ratios allowed, 1.3 to 10.
    pub ring_to_sun: RangeInclusive<f64>,
    /// Ring-to-sun ratios preferred, 2.5 to 3: best in size and mass.
    pub preferred: RangeInclusive<f64>,
    /// Least efficiency of a gear, 0.9.
    pub efficiency: f64,
    /// Greatest speed of a link over the input's, 2.
    pub link_speed: f64,
    /// Greatest speed of a planet relative to its carrier over the input's, 2.
    pub planet_speed: f64,
    /// Greatest slip of the open direct-drive clutch over the input's speed, 2.
    pub clutch_slip: f64,
    /// Whether all gears, direct drive among them, must turn the output alike. Off: mixed
    /// directions are reported.
    pub same_direction: bool,
    /// Whether the scheme must be drawable without self-crossing, where that is examined.
    pub drawable: bool,
}

impl Default for Limits {
    fn default() -> Self {
        Self {
            ring_to_sun: 1.3..=10.0,
            preferred: 2.5..=3.0,
            efficiency: 0.9,
            link_speed: 2.0,
            planet_speed: 2.0,
            clutch_slip: 2.0,
            same_direction: false,
            drawable: true,
        }
    }
}

/// What is wanted.
#[derive(Debug, Clone, PartialEq)]
pub struct Requirements {
    /// Ratios of the braked gears.
    pub series: RatioSeries,
    /// Relative tolerance of each, 0.1.
    pub tolerance: f64,
    /// Which gear may have which ratio.
    pub orders: Orders,
    /// Which signs the ratios may have.
    pub signs: Signs,
    /// Limits.
    pub limits: Limits,
    /// Efficiency `η₀` of each set with the carrier fixed, 0.98·0.99.
    pub eta0: MeshEfficiency,
    /// What sizes are measured by.
    pub rating: Rating,
}

impl Requirements {
    /// These ratios with the source's tolerance, limits and losses, both orders, signs alike.
    #[must_use]
    pub fn new(series: RatioSeries) -> Self {
        let meshes = [0.98, 0.99].map(|eta| MeshEfficiency::new(eta).unwrap_or(MeshEfficiency::IDEAL));
        Self {
            series,
            tolerance: 0.1,
            orders: Orders::default(),
            signs: Signs::default(),
            limits: Limits::default(),
            eta0: MeshEfficiency::of_meshes(&meshes),
            rating: Rating::default(),
        }
    }

    /// Every assignment of signed ratios to the gears, each once: as given first.
    #[must_use]
    pub fn targets(&self) -> Vec<Vec<f64>> {
        let given = self.series.ratios().to_vec();
        let mut orders = vec![given.clone()];
        if self.orders == Orders::Both && given.len() == 2 {
            orders.push(vec![given[1], given[0]]);
        }
        let signs: &[[f64; 2]] = match self.signs {
            Signs::AsGiven => &[],
            Signs::Alike => &[[1.0, 1.0], [-1.0, -1.0]],
            Signs::Any => &[[1.0, 1.0], [-1.0, -1.0], [1.0, -1.0], [-1.0, 1.0]],
        };
        let mut found = vec![];
        for order in orders {
            if signs.is_empty() {
                found.push(order.clone());
            }
            for sign in signs {
                let target: Vec<f64> = order.iter().zip(sign).map(|(i, sign)| i.abs() * sign).collect();
                // Ratios given as ±1, or of equal size, are invalid with some signs.
                let is_one = RatioSeries::new(&target).is_err();
                if !is_one && !found.contains(&target) {
                    found.push(target);
                }
            }
        }
        found
    }

    pub(crate) fn check(&self) -> Result<(), SelectionError> {
        if !(self.tolerance >= 0.0 && self.tolerance < 1.0) {
            return Err(SelectionError::Tolerance { tolerance: self.tolerance });
        }
        let limits = &self.limits;
        for (what, range) in [(KRange::Allowed, &limits.ring_to_sun), (KRange::Preferred, &limits.preferred)]
        {
            let (from, to) = (*range.start(), *range.end());
            if !(from > 1.0 && from <= to && to.is_finite()) {
                return Err(SelectionError::RingToSunRange { what, from, to });
            }
        }
        for (what, value) in [
            (Limited::Efficiency, limits.efficiency),
            (Limited::LinkSpeed, limits.link_speed),
            (Limited::PlanetSpeed, limits.planet_speed),
            (Limited::ClutchSlip, limits.clutch_slip),
        ] {
            if value.is_nan() || value < 0.0 {
                return Err(SelectionError::Limit { what, value });
            }
        }
        self.rating.check()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::velocity;

    fn speeds(speeds: &[f64]) -> Result<RatioSeries, SelectionError> {
        RatioSeries::of_speeds(&speeds.iter().copied().map(velocity).collect::<Vec<_>>())
    }

    #[test]
    fn speeds_give_q_and_d() {
        let series = speeds(&[0.76, 1.33, 1.95]).unwrap();
        assert!((series.ratios()[0] - 1.95 / 1.33).abs() < 1e-15);
        assert!((series.ratios()[1] - 1.95 / 0.76).abs() < 1e-15);
        assert!((speeds(&[0.8, 3.15]).unwrap().ratios()[0] - 3.9375).abs() < 1e-12);
    }

    #[test]
    fn an_invalid_series_is_refused() {
        assert_eq!(speeds(&[1.0]), Err(SelectionError::SpeedCount { count: 1 }));
        let refused = SelectionError::SpeedsOutOfOrder { place: 2, speed: 1.0, before: 1.0 };
        assert_eq!(speeds(&[1.0, 1.0]), Err(refused));
        for bad in [[0.0, 1.0], [2.0, 1.0], [1.0, f64::NAN], [1.0, f64::INFINITY]] {
            assert!(matches!(speeds(&bad), Err(SelectionError::SpeedsOutOfOrder { .. })), "{bad:?}");
        }
        assert_eq!(RatioSeries::of_range(1.0, None), Err(SelectionError::SpeedRange { d: 1.0 }));
        assert!(RatioSeries::of_range(f64::NAN, None).is_err());
        let refused = SelectionError::MiddleSpeed { q: 3.0, d: 2.0 };
        assert_eq!(RatioSeries::of_range(2.0, Some(3.0)), Err(refused));
        for bad in [0.0, 1.0, f64::NAN, f64::INFINITY] {
            assert!(matches!(RatioSeries::new(&[bad, 2.0]), Err(SelectionError::Ratio { .. })), "{bad}");
        }
        assert_eq!(RatioSeries::new(&[2.0, 2.0]), Err(SelectionError::EqualRatios { ratio: 2.0 }));
        assert_eq!(RatioSeries::new(&[]), Err(SelectionError::RatioCount { count: 0 }));
    }

    #[test]
    fn invalid_limits_are_refused() {
        let requirements = Requirements::new(RatioSeries::new(&[1.5, 2.5]).unwrap());
        assert_eq!(requirements.check(), Ok(()));
        let with = |change: &dyn Fn(&mut Requirements)| {
            let mut requirements = requirements.clone();
            change(&mut requirements);
            requirements.check()
        };
        assert!(matches!(with(&|d| d.tolerance = f64::NAN), Err(SelectionError::Tolerance { .. })));
        assert!(matches!(
            with(&|d| d.limits.ring_to_sun = 1.0..=10.0),
            Err(SelectionError::RingToSunRange { .. })
        ));
        assert!(matches!(with(&|d| d.limits.link_speed = f64::NAN), Err(SelectionError::Limit { .. })));
        assert!(matches!(with(&|d| d.rating.planets = 0), Err(SelectionError::PlanetNumber { .. })));
    }

    #[test]
    fn both_orders_and_both_signs_are_four_targets() {
        let mut requirements = Requirements::new(RatioSeries::new(&[1.5, 2.5]).unwrap());
        assert_eq!(requirements.targets().len(), 4);
        requirements.signs = Signs::Any;
        assert_eq!(requirements.targets().len(), 8);
        (requirements.signs, requirements.orders) = (Signs::AsGiven, Orders::AsGiven);
        assert_eq!(requirements.targets(), [[1.5, 2.5]]);
    }
}
