//! Tooth numbers of a double-planet set for a ratio.

use super::{Listed, gearbox, listed};
use crate::answer::Answer;
use crate::error::Error;
use crate::shared::judgement::answer::Judgement;
use crate::shared::records::{Fraction, Motion};
use crate::shared::tooth_checks::answer::{TeethLeftOut, ToothChecks};
use crate::teeth::options::Request;
use crate::tolerance::ROUNDED;
use epicyclic_gears::ToothCount;
use epicyclic_gears::double_planet::DoublePlanetCandidate;
use epicyclic_gears::synthesis::Bounds;
use epicyclic_train::Gearbox;
use epicyclic_train::set::{SetKind, SetSpec};
use epicyclic_units::Physical;
use schemars::JsonSchema;
use serde::Serialize;
use std::ops::ControlFlow;

/// Double-planet sets that give a ratio, the most exact first. Each pair of sun and ring occurs once, because
/// the ratio does not depend on the planets.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct DoublePlanetTeeth {
    /// Required ratio, input speed over output speed.
    pub ratio: f64,
    /// Driving, driven and fixed member.
    pub mode: Motion,
    /// Allowed relative deviation of the ratio.
    pub tolerance: f64,
    /// Number of pairs of sun and ring found.
    pub found: u64,
    /// Pairs of sun and ring of this ratio that are left out because the tooth checks fail with all planets;
    /// null if no pair is left out.
    pub left_out: Option<TeethLeftOut>,
    /// Number of sets listed.
    pub shown: usize,
    /// Listed sets of tooth numbers.
    pub tooth_numbers: Vec<DoublePlanetNumbers>,
    /// Tooth checks of one set, the first unless another is requested.
    pub tooth_checks: ToothChecks,
    /// Judgement of the same set by rules of practice.
    pub judgement: Judgement,
}

/// Tooth numbers of a double-planet set, with the properties that follow from them.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct DoublePlanetNumbers {
    /// Tooth number of the sun.
    pub sun: u32,
    /// Tooth number of the inner planets, in mesh with the sun.
    pub inner_planet: u32,
    /// Tooth number of the outer planets, in mesh with the ring.
    pub outer_planet: u32,
    /// Tooth number of the ring.
    pub ring: u32,
    /// Number of pairs of planets.
    pub pairs: u32,
    /// Ratio, input speed over output speed.
    pub ratio: f64,
    /// Exact ratio as a fraction.
    pub exact_ratio: Fraction,
    /// Relative deviation from the required ratio.
    pub ratio_error: f64,
    /// Number of choices of both planets and of the number of pairs that fit this sun and ring within the
    /// bounds. They have equal centre distances, can be assembled and clear each other; tooth checks are not
    /// considered. The one given is the first that passes the checks, by the most pairs, then the most teeth
    /// of the smaller planet.
    pub choices: u64,
    /// Whether the rack undercuts the sun.
    pub undercut_sun: bool,
    /// Whether the rack undercuts the inner planets.
    pub undercut_inner_planet: bool,
    /// Whether the rack undercuts the outer planets.
    pub undercut_outer_planet: bool,
    /// Whether the pairs are equally spaced.
    pub equal_spacing: bool,
    /// Angle of each inner planet about the axis, in rad.
    pub pair_angles_rad: Vec<f64>,
    /// Imbalance: distance of the pairs' common centre of mass from the axis over the radius of their
    /// centres.
    pub imbalance: f64,
}

impl Answer for DoublePlanetTeeth {
    const NAME: &'static str = "teeth-double-planet";
}

/// Finds all double-planet sets for a ratio.
///
/// # Errors
/// Those of [`super::answer`].
pub(in crate::teeth) fn answer(
    request: &Request,
    bounds: &Bounds,
    done: impl FnMut(f64) -> ControlFlow<()>,
) -> Result<DoublePlanetTeeth, Error> {
    let mode = request.simple_mode()?;
    let Listed { ratio, tolerance, found, left_out, sets, tooth_checks, judgement } = listed(
        request,
        &bounds.rack,
        |ratio, tolerance, most| bounds.double_planets_for_ratio(ratio, mode, tolerance, most, done),
        DoublePlanetNumbers::of,
        DoublePlanetNumbers::gearbox,
    )?;
    let shown = sets.len();
    Ok(DoublePlanetTeeth {
        ratio,
        mode: Motion::of(mode),
        tolerance,
        found,
        left_out,
        shown,
        tooth_numbers: sets,
        tooth_checks,
        judgement,
    })
}

impl DoublePlanetNumbers {
    /// Set as a gearbox without losses.
    ///
    /// # Errors
    /// No error is known for a set that an answer to this request lists.
    pub fn gearbox(&self, request: &Request) -> Result<Gearbox, Error> {
        let members = gearbox::members(request.simple_mode()?);
        let set = SetSpec::teeth(gearbox::NAME, SetKind::DoublePlanet, members, self.sun, self.ring)?;
        let [inner, outer] = [self.inner_planet, self.outer_planet].map(ToothCount::new);
        gearbox::built(request, set.planet_teeth(inner?, Some(outer?)).planet_count(self.pairs))
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
