//! Tooth numbers of a solution.

use super::gear::WantedGear;
use crate::shared::Fraction;
use epicyclic_gears::synthesis::{Bounds as ToothBounds, ToothNumbers};
use epicyclic_synthesis::parts::Bounds;
use epicyclic_synthesis::run::Found;
use epicyclic_synthesis::teeth::{Aim, Alike, Choice, Design, designs};
use schemars::JsonSchema;
use serde::Serialize;
use std::ops::RangeInclusive;

/// Which tooth numbers are wanted.
#[derive(Debug, Clone, PartialEq)]
pub struct TeethWanted {
    /// Limits of teeth and planets; the `k` are those of the search.
    pub bounds: ToothBounds,
    /// How many sets are alike at least.
    pub alike: Alike,
    /// Which are the best.
    pub aim: Aim,
    /// How many choices are told of each solution.
    pub most: usize,
}

/// Tooth numbers that keep the tolerances of a solution.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Teeth {
    /// How many choices of tooth numbers there are; those that differ in the numbers of planets alone are one.
    pub found: u64,
    /// Whether all were counted; the trial ends after a great many.
    pub complete: bool,
    /// The best of them, the best first.
    pub choices: Vec<TeethOfSets>,
}

/// Tooth numbers of all sets.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct TeethOfSets {
    /// Of each set.
    pub sets: Vec<TeethOfSet>,
    /// The ratio of each gear, exactly.
    pub ratios: Vec<Fraction>,
    /// The greatest deviation of a ratio from the one wanted, as a share of it; 0 where all are ranges.
    pub greatest_deviation: f64,
}

/// Tooth numbers of a set.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct TeethOfSet {
    /// Teeth of the sun.
    pub sun: u32,
    /// Teeth of a planet.
    pub planet: u32,
    /// Teeth of the ring.
    pub ring: u32,
    /// The most planets that assemble at equal angles and clear each other.
    pub planets: u32,
}

impl Teeth {
    /// Those of a solution, its best choices also as the search has them.
    pub(super) fn of(
        found: &Found,
        gears: &[WantedGear],
        k: &[RangeInclusive<f64>],
        choice: &Choice,
        wanted: &TeethWanted,
    ) -> (Self, Vec<Design>) {
        let mut ratios: Vec<_> = found.solution.gears.iter().map(|gear| gear.ratio).collect();
        let mut bounds: Vec<_> = gears.iter().map(WantedGear::bounds).collect();
        // k that are equal are so in teeth: exactly, since ratios are fractions of whole numbers.
        ratios.extend(found.solution.equal.ratios());
        bounds.resize(ratios.len(), Bounds { least: 1.0, most: 1.0 });
        let mut all = designs(&ratios, &bounds, k, choice, wanted.alike, wanted.aim, wanted.most);
        all.first.iter_mut().for_each(|design| design.ratios.truncate(gears.len()));
        let told = all.first.iter().map(|design| TeethOfSets::of(design, gears)).collect();
        (Self { found: all.count, complete: all.complete, choices: told }, all.first)
    }
}

impl TeethOfSets {
    fn of(design: &Design, wanted: &[WantedGear]) -> Self {
        let deviation = |(ratio, wanted): (&epicyclic_gears::simple_set::Fraction, &WantedGear)| {
            let wanted = wanted.wanted_ratio?;
            Some((*ratio.numer() as f64 / *ratio.denom() as f64 / wanted - 1.0).abs())
        };
        Self {
            sets: design.sets.iter().map(TeethOfSet::of).collect(),
            ratios: design.ratios.iter().map(|ratio| Fraction::of(*ratio)).collect(),
            greatest_deviation: design.ratios.iter().zip(wanted).filter_map(deviation).fold(0.0, f64::max),
        }
    }
}

impl TeethOfSet {
    fn of(set: &ToothNumbers) -> Self {
        let ToothNumbers { sun, planet, ring, planets } = *set;
        Self { sun: sun.get(), planet: planet.get(), ring: ring.get(), planets }
    }
}
