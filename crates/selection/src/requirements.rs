//! Requirements of a gearbox: ratios, their tolerance, and the limits of section 3.1.

use super::Error;
use super::size::Rating;
use crate::quantity::{KRange, Limited};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_schemes::RatioSeries;
use std::ops::RangeInclusive;

/// Orders of two ratios: the gears that may have each of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "names", derive(serde::Serialize, schemars::JsonSchema, clap::ValueEnum))]
#[cfg_attr(feature = "names", serde(rename_all = "snake_case"), schemars(rename = "Brakes"))]
pub enum Orders {
    /// Either brake gives either ratio.
    #[default]
    Either,
    /// The first brake gives the first ratio.
    AsGiven,
}

/// Signs that the ratios may have.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "names", derive(serde::Serialize, schemars::JsonSchema, clap::ValueEnum))]
#[cfg_attr(feature = "names", serde(rename_all = "snake_case"), schemars(rename = "RatioSigns"))]
pub enum Signs {
    /// All positive, or all negative.
    #[default]
    Alike,
    /// Each by itself.
    Any,
    /// Those of --ratios.
    AsGiven,
}

/// Circulating power over the power that enters, from which on it is an objection if no limit is given. Half
/// of the power that loads the sets then comes from the loop and not from the input, and has no part in the
/// output.
pub const OBJECTED_CIRCULATION: f64 = 0.5;

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
    /// Greatest circulating power of a gear over what enters; infinite by default, and then more than
    /// [`OBJECTED_CIRCULATION`] is an objection.
    pub circulation: f64,
    /// Whether all gears, direct drive among them, must turn the output alike. Off: mixed
    /// directions are reported, and ranked behind all others.
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
            circulation: f64::INFINITY,
            same_direction: false,
            drawable: true,
        }
    }
}

/// Requirements of a gearbox.
#[derive(Debug, Clone, PartialEq)]
pub struct Requirements {
    /// Ratios of direct drive and of one or two braked gears.
    pub series: RatioSeries,
    /// Relative tolerance of each, 0.1.
    pub tolerance: f64,
    /// Orders of the ratios among the gears.
    pub orders: Orders,
    /// Signs that the ratios may have.
    pub signs: Signs,
    /// Limits.
    pub limits: Limits,
    /// Efficiency `η₀` of each set with the carrier fixed, 0.98·0.99.
    pub eta0: MeshEfficiency,
    /// Rating by which sizes are measured.
    pub rating: Rating,
}

impl Requirements {
    /// Requirements for these ratios with the source's tolerance, limits and losses, both orders, equal
    /// signs.
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
        let given = self.series.braked();
        let mut orders = vec![given.clone()];
        if self.orders == Orders::Either && given.len() == 2 {
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
                let is_one = RatioSeries::of_braked_gears(&target).is_err();
                if !is_one && !found.contains(&target) {
                    found.push(target);
                }
            }
        }
        found
    }

    /// Whether the signs of these ratios keep to [`Limits::same_direction`].
    #[must_use]
    pub fn allows_directions_of(&self, ratios: &[f64]) -> bool {
        !self.limits.same_direction || ratios.iter().all(|ratio| *ratio > 0.0)
    }

    pub(crate) fn check(&self) -> Result<(), Error> {
        let count = self.series.ratios().len();
        if !(2..=3).contains(&count) {
            return Err(Error::SpeedCount { count });
        }
        if !(self.tolerance >= 0.0 && self.tolerance < 1.0) {
            return Err(Error::Tolerance { tolerance: self.tolerance });
        }
        let limits = &self.limits;
        for (what, range) in [(KRange::Allowed, &limits.ring_to_sun), (KRange::Preferred, &limits.preferred)]
        {
            let (from, to) = (*range.start(), *range.end());
            if !(from > 1.0 && from <= to && to.is_finite()) {
                return Err(Error::RingToSunRange { what, from, to });
            }
        }
        for (what, value) in [
            (Limited::Efficiency, limits.efficiency),
            (Limited::LinkSpeed, limits.link_speed),
            (Limited::PlanetSpeed, limits.planet_speed),
            (Limited::ClutchSlip, limits.clutch_slip),
            (Limited::Circulation, limits.circulation),
        ] {
            if value.is_nan() || value < 0.0 {
                return Err(Error::Limit { what, value });
            }
        }
        self.rating.check()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_gearbox_of_two_sets_has_no_fourth_speed() {
        let requirements = Requirements::new(RatioSeries::geometric(1.5, 4, 1).unwrap());
        assert_eq!(requirements.check(), Err(Error::SpeedCount { count: 4 }));
    }

    #[test]
    fn invalid_limits_are_refused() {
        let requirements = Requirements::new(RatioSeries::of_braked_gears(&[1.5, 2.5]).unwrap());
        assert_eq!(requirements.check(), Ok(()));
        let with = |change: &dyn Fn(&mut Requirements)| {
            let mut requirements = requirements.clone();
            change(&mut requirements);
            requirements.check()
        };
        assert!(matches!(with(&|d| d.tolerance = f64::NAN), Err(Error::Tolerance { .. })));
        assert!(matches!(with(&|d| d.limits.ring_to_sun = 1.0..=10.0), Err(Error::RingToSunRange { .. })));
        assert!(matches!(with(&|d| d.limits.link_speed = f64::NAN), Err(Error::Limit { .. })));
        assert!(matches!(with(&|d| d.rating.planets = 0), Err(Error::PlanetNumber { .. })));
    }

    #[test]
    fn both_orders_and_both_signs_are_four_targets() {
        let mut requirements = Requirements::new(RatioSeries::of_braked_gears(&[1.5, 2.5]).unwrap());
        assert_eq!(requirements.targets().len(), 4);
        requirements.signs = Signs::Any;
        assert_eq!(requirements.targets().len(), 8);
        (requirements.signs, requirements.orders) = (Signs::AsGiven, Orders::AsGiven);
        assert_eq!(requirements.targets(), [[1.5, 2.5]]);
    }
}
