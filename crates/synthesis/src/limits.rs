//! Limits that a solution keeps or misses at its best ring-to-sun ratios.
//!
//! # What complete means here
//! Steps, slips and speeds depend on the `k`. They are judged at the point with the least greatest deviation
//! of the ratios ([`refine`](crate::refine)), with the elements that are listed. A solution that misses a
//! limit there is left out and counted; at other `k` within its ranges, or with other elements, it might keep
//! it.
//!
//! # Formulas
//! The step from a forward gear to the next is `i_g/i_{g+1}`, above 1. Slips and speeds are multiples of the
//! input's speed, each the greatest over all gears:
//! - `∣ω_u − ω_v∣/ω_1` of an open element;
//! - `∣ω∣/ω_1` of a link;
//! - `∣ω_g − ω_H∣/ω_1` of a planet on its carrier.
//!
//! The speed of the planets of a double-planet set depends on their teeth. The value is then a lower bound
//! for any teeth ([`planet_speed`](crate::judge::planet_speed)): a solution that misses the limit misses it
//! with any teeth, and one that keeps it may miss it with some.

use crate::Error;
use crate::judge::Judged;
use crate::parts::Bounds;
use crate::wish::forward;
use std::ops::RangeInclusive;

/// Limits for a solution at its best `k`. By default none.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Limits {
    /// The range of each ratio step between neighbouring forward gears.
    pub steps: Option<RangeInclusive<f64>>,
    /// Whether no step is larger than the previous step, from the first gear on.
    pub falling_steps: bool,
    /// The greatest slip of an open element over the input's speed.
    pub slip: Option<f64>,
    /// The greatest speed of a link over the input's.
    pub link_speed: Option<f64>,
    /// The greatest speed of a planet relative to its carrier over the input's.
    pub planet_speed: Option<f64>,
}

/// A limit that can be missed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Limit {
    /// A ratio step out of its range.
    Steps,
    /// A step larger than the previous step.
    FallingSteps,
    /// Slip of an open element.
    Slip,
    /// Speed of a link.
    LinkSpeed,
    /// Speed of a planet.
    PlanetSpeed,
}

impl Limits {
    /// Refuses steps that no ratios within their bounds have: a search would go from class to class and keep
    /// nothing.
    ///
    /// # Errors
    /// [`Error::Steps`], [`Error::RisingSteps`].
    pub fn check(&self, gears: &[Bounds]) -> Result<(), Error> {
        let forward = forward(gears);
        let of = |pair: &[usize]| {
            let [higher, lower] = [gears[pair[0]], gears[pair[1]]];
            [higher.least / lower.most, higher.most / lower.least]
        };
        let steps: Vec<[f64; 2]> = forward.windows(2).map(of).collect();
        let out = |range: &RangeInclusive<f64>| {
            steps.iter().copied().find(|[least, most]| most < range.start() || least > range.end())
        };
        if let Some((range, step)) = self.steps.as_ref().and_then(|range| Some((range, out(range)?))) {
            return Err(Error::Steps { step, allowed: [*range.start(), *range.end()] });
        }
        match steps.windows(2).find(|pair| pair[1][0] > pair[0][1]) {
            Some(pair) if self.falling_steps => {
                Err(Error::RisingSteps { before: pair[0][1], after: pair[1][0] })
            }
            _ => Ok(()),
        }
    }

    /// The first limit that a solution misses, in the order of [`Limit`].
    #[must_use]
    pub fn missed(&self, gears: &[Bounds], judged: &Judged) -> Option<Limit> {
        let steps = steps(gears, &judged.ratios);
        let above = |most: Option<f64>, value: f64| most.is_some_and(|most| value > most);
        [
            (
                Limit::Steps,
                self.steps.as_ref().is_some_and(|range| !steps.iter().all(|step| range.contains(step))),
            ),
            (Limit::FallingSteps, self.falling_steps && steps.windows(2).any(|pair| pair[1] > pair[0])),
            (Limit::Slip, above(self.slip, judged.slip)),
            (Limit::LinkSpeed, above(self.link_speed, judged.link_speed)),
            (Limit::PlanetSpeed, above(self.planet_speed, judged.planet_speed)),
        ]
        .into_iter()
        .find(|(_, missed)| *missed)
        .map(|(limit, _)| limit)
    }
}

/// The steps between neighbouring forward gears, from the highest ratio down.
#[must_use]
pub fn steps(gears: &[Bounds], ratios: &[f64]) -> Vec<f64> {
    forward(gears).windows(2).map(|pair| ratios[pair[0]] / ratios[pair[1]]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn around(ratios: &[f64]) -> Vec<Bounds> {
        ratios.iter().map(|ratio| Bounds { least: 0.99 * ratio, most: 1.01 * ratio }).collect()
    }

    #[test]
    fn steps_that_no_ratio_within_its_bounds_has_are_refused() {
        let steps = |least: f64, most: f64| Limits { steps: Some(least..=most), ..Limits::default() };
        let gears = around(&[1.0, 4.0, 2.0]);
        assert!(steps(1.0, 2.0).check(&gears).is_ok());
        // The greatest step can be is 2·1.01/0.99 = 2.0404.
        assert!(steps(2.04, 3.0).check(&gears).is_ok());
        assert!(matches!(steps(2.05, 3.0).check(&gears), Err(Error::Steps { .. })));
        assert!(matches!(steps(1.0, 1.95).check(&gears), Err(Error::Steps { .. })));
        let falling = Limits { falling_steps: true, ..Limits::default() };
        assert!(falling.check(&gears).is_ok());
        assert!(falling.check(&around(&[4.0, 2.0, 0.97])).is_ok());
        assert!(matches!(falling.check(&around(&[4.0, 2.0, 0.9])), Err(Error::RisingSteps { .. })));
        assert!(falling.check(&around(&[-4.0, 2.0])).is_ok() && Limits::default().check(&gears).is_ok());
    }
}
