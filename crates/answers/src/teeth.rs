//! Tooth numbers of a simple set for a ratio.
//!
//! | module | is |
//! |---|---|
//! | [`double_planet`] | the same of a double-planet set |
//! | [`shifted`] | the same of simple sets with profile shift |
//! | [`saved`] | a set as a gearbox |

pub mod double_planet;
pub mod saved;
pub mod shifted;

use crate::shared::{Fraction, Motion};
use crate::tolerance::ROUNDED;
use crate::{Answer, Error};
use epicyclic_formats::Physical;
use epicyclic_gears::simple_set::Mode;
use epicyclic_gears::synthesis::{Bounds, Candidate};
use schemars::JsonSchema;
use serde::Serialize;

/// The most sets that are written: their text is built whole, in some 100 MB.
pub const MOST_SETS: usize = 100_000;

/// What is wanted.
#[derive(Debug, Clone, PartialEq)]
pub struct Wanted {
    /// Ratio of the speeds of input and output; negative where they turn against each other.
    pub ratio: f64,
    /// Which member drives, which is driven, which rests.
    pub mode: Mode,
    /// How far the ratio may be off, as a share of it.
    pub tolerance: f64,
    /// Bounds of tooth numbers, of planets, of a double-planet set of each of its two and of the pairs, of k, and the rack.
    pub bounds: Bounds,
    /// How many of the sets are told.
    pub most: usize,
}

/// Sets of tooth numbers that give a ratio, the most exact first.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Teeth {
    /// The ratio wanted.
    pub ratio: f64,
    /// Which member drives, which is driven, which rests.
    pub mode: Motion,
    /// How far the ratio may be off, as a share of it.
    pub tolerance: f64,
    /// How many sets there are.
    pub found: u64,
    /// How many of them are told here.
    pub shown: usize,
    /// These.
    pub tooth_numbers: Vec<ToothNumbers>,
}

/// Tooth numbers of a simple set, and what follows from them.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ToothNumbers {
    /// Teeth of the sun.
    pub sun: u32,
    /// Teeth of a planet.
    pub planet: u32,
    /// Teeth of the ring.
    pub ring: u32,
    /// Number of planets.
    pub planets: u32,
    /// The ratio, input speed over output speed.
    pub ratio: f64,
    /// The same, exactly.
    pub exact_ratio: Fraction,
    /// How far it is from the ratio wanted, as a share of it.
    pub ratio_error: f64,
    /// The most planets that clear each other at equal spacing.
    pub most_planets: u32,
    /// Whether the rack undercuts the sun.
    pub undercut_sun: bool,
    /// Whether the rack undercuts the planets.
    pub undercut_planet: bool,
    /// Whether the planets stand at equal angles.
    pub equal_spacing: bool,
    /// Where each planet stands.
    pub planet_angles_rad: Vec<f64>,
    /// Distance of the planets' common centre of mass from the axis over the radius of their centres.
    pub imbalance: f64,
}

impl Answer for Teeth {
    const NAME: &'static str = "teeth";
}

/// Every set of tooth numbers for a ratio; `done` is told the share that is searched, from 0 to 1.
///
/// # Errors
/// [`Error::Gear`] where nothing is found, or of a bound that cannot be.
pub fn answer(wanted: &Wanted, done: impl FnMut(f64)) -> Result<Teeth, Error> {
    let &Wanted { ratio, mode, tolerance, ref bounds, most } = wanted;
    let found = bounds.first_for_ratio(ratio, mode, tolerance, most.min(MOST_SETS), done)?;
    if most > MOST_SETS && found.found > MOST_SETS as u64 {
        return Err(Error::TooMany { found: found.found, most: MOST_SETS });
    }
    let tooth_numbers: Vec<ToothNumbers> = found.first.iter().map(ToothNumbers::of).collect();
    Ok(Teeth {
        ratio,
        mode: Motion::of(mode),
        tolerance,
        found: found.found,
        shown: tooth_numbers.len(),
        tooth_numbers,
    })
}

impl ToothNumbers {
    fn of(found: &Candidate) -> Self {
        let imbalance = found.spacing.imbalance();
        Self {
            sun: found.teeth.sun.get(),
            planet: found.teeth.planet.get(),
            ring: found.teeth.ring.get(),
            planets: found.teeth.planets,
            ratio: found.ratio,
            exact_ratio: Fraction::of(found.exact_ratio),
            ratio_error: found.ratio_error,
            most_planets: found.most_planets,
            undercut_sun: found.undercut_sun,
            undercut_planet: found.undercut_planet,
            equal_spacing: found.spacing.is_equal(),
            planet_angles_rad: found.spacing.angles().into_iter().map(Physical::si).collect(),
            imbalance: if imbalance < ROUNDED { 0.0 } else { imbalance },
        }
    }
}
