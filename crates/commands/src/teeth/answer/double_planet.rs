//! Tooth numbers of a double-planet set for a ratio.

use super::{MOST_SETS, Wanted, gearbox};
use crate::answer::Answer;
use crate::error::Error;
use crate::shared::records::{Fraction, Motion};
use crate::shared::tooth_checks::answer::{TeethLeftOut, ToothChecks};
use crate::tolerance::ROUNDED;
use epicyclic_gears::ToothCount;
use epicyclic_gears::double_planet::DoublePlanetCandidate;
use epicyclic_train::Gearbox;
use epicyclic_train::set::{SetKind, SetSpec};
use epicyclic_units::Physical;
use schemars::JsonSchema;
use serde::Serialize;
use std::ops::ControlFlow;

/// Double-planet sets that give a ratio, the most exact first: each pair of sun and ring once, since the
/// ratio does not depend on the planets between them.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct DoublePlanetTeeth {
    /// The ratio wanted.
    pub ratio: f64,
    /// Which member drives, which is driven, which rests.
    pub mode: Motion,
    /// How far the ratio may be off, as a share of it.
    pub tolerance: f64,
    /// How many pairs of sun and ring there are.
    pub found: u64,
    /// Pairs of sun and ring of this ratio that are left out since none of their planets passes the checks
    /// of the teeth; `null` if no pair is left out.
    pub left_out: Option<TeethLeftOut>,
    /// How many of them are told here.
    pub shown: usize,
    /// These.
    pub tooth_numbers: Vec<DoublePlanetNumbers>,
    /// The checks of the teeth of one of them, the first unless another is asked for.
    pub tooth_checks: ToothChecks,
}

/// Tooth numbers of a double-planet set, and what follows from them.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct DoublePlanetNumbers {
    /// Teeth of the sun.
    pub sun: u32,
    /// Teeth of the inner planets, in mesh with the sun.
    pub inner_planet: u32,
    /// Teeth of the outer planets, in mesh with the ring.
    pub outer_planet: u32,
    /// Teeth of the ring.
    pub ring: u32,
    /// Number of pairs of planets.
    pub pairs: u32,
    /// The ratio, input speed over output speed.
    pub ratio: f64,
    /// The same, exactly.
    pub exact_ratio: Fraction,
    /// How far it is from the ratio wanted, as a share of it.
    pub ratio_error: f64,
    /// How many choices of both planets and of the number of pairs close, assemble and clear each other with
    /// this sun and ring within the bounds, whether or not their teeth pass the checks. This one is the
    /// first that passes them, by the most pairs, then the most teeth of the smaller planet.
    pub choices: u64,
    /// Whether the rack undercuts the sun.
    pub undercut_sun: bool,
    /// Whether the rack undercuts the inner planets.
    pub undercut_inner_planet: bool,
    /// Whether the rack undercuts the outer planets.
    pub undercut_outer_planet: bool,
    /// Whether the pairs stand at equal angles.
    pub equal_spacing: bool,
    /// Where each inner planet stands.
    pub pair_angles_rad: Vec<f64>,
    /// Distance of the pairs' common centre of mass from the axis over the radius of their centres.
    pub imbalance: f64,
}

impl Answer for DoublePlanetTeeth {
    const NAME: &'static str = "teeth-double-planet";
}

/// Every double-planet set for a ratio; `done` is told the share that is searched, from 0 to 1; a break ends
/// the search.
///
/// # Errors
/// [`Error::Gear`] where nothing is found, or of a bound that cannot be.
pub fn answer(wanted: &Wanted, done: impl FnMut(f64) -> ControlFlow<()>) -> Result<DoublePlanetTeeth, Error> {
    let &Wanted { ratio, mode, tolerance, ref bounds, most, .. } = wanted;
    let found = bounds.double_planets_for_ratio(ratio, mode, tolerance, most.min(MOST_SETS), done)?;
    if most > MOST_SETS && found.found > MOST_SETS as u64 {
        return Err(Error::TooMany { found: found.found, most: MOST_SETS });
    }
    let tooth_numbers: Vec<DoublePlanetNumbers> = found.first.iter().map(DoublePlanetNumbers::of).collect();
    Ok(DoublePlanetTeeth {
        ratio,
        mode: Motion::of(mode),
        tolerance,
        found: found.found,
        left_out: found.left_out.as_deref().map(TeethLeftOut::of),
        shown: tooth_numbers.len(),
        tooth_checks: wanted.checks(&tooth_numbers, DoublePlanetNumbers::gearbox)?,
        tooth_numbers,
    })
}

impl DoublePlanetNumbers {
    /// The set as a gearbox without losses.
    ///
    /// # Errors
    /// None of a set that [`answer`] tells.
    pub fn gearbox(&self, wanted: &Wanted) -> Result<Gearbox, Error> {
        let members = gearbox::members(wanted.mode);
        let set = SetSpec::teeth(gearbox::NAME, SetKind::DoublePlanet, members, self.sun, self.ring)?;
        let [inner, outer] = [self.inner_planet, self.outer_planet].map(ToothCount::new);
        wanted.built(set.planet_teeth(inner?, Some(outer?)).planet_count(self.pairs))
    }

    fn of(found: &DoublePlanetCandidate) -> Self {
        let imbalance = found.spacing.imbalance();
        Self {
            sun: found.teeth.sun.get(),
            inner_planet: found.teeth.inner.get(),
            outer_planet: found.teeth.outer.get(),
            ring: found.teeth.ring.get(),
            pairs: found.teeth.pairs,
            ratio: found.ratio,
            exact_ratio: Fraction::of(found.exact_ratio),
            ratio_error: found.ratio_error,
            choices: found.choices,
            undercut_sun: found.undercut_sun,
            undercut_inner_planet: found.undercut_inner,
            undercut_outer_planet: found.undercut_outer,
            equal_spacing: found.spacing.is_equal(),
            pair_angles_rad: found.spacing.angles().into_iter().map(Physical::si).collect(),
            imbalance: if imbalance < ROUNDED { 0.0 } else { imbalance },
        }
    }
}
