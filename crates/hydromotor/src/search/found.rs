//! Result of a search: designs with all figures of a table, and counts of the motors by their results.

use uom::si::f64::Length;

use crate::Error;
use crate::arcs::StatorArcs;
use crate::checks::Subject;
use crate::machine;
use crate::motor::Motor;
use crate::numbers::MotorNumbers;
use crate::reason::{Reason, Refusals};

use super::MotorSearch;
use super::dimensions::Dimensions;
use super::front::Value;
use super::objective::AtFlanks;
use super::point::Point;
use super::requirements::Sizing;

/// The answer of a search.
#[derive(Debug, Clone, PartialEq)]
pub struct Found {
    /// The front, by falling displacement by volume.
    pub designs: Vec<Design>,
    /// Counts of the motors by their results.
    pub funnel: Funnel,
    /// The greatest spacing error of the designs; see [`crate::search`].
    pub spacing_error: SpacingError,
    /// Largest amount by which the front, before thinning, has motors better than the nearest at an evenly
    /// spaced place.
    pub refinement_gain: SpacingError,
}

/// Estimate of the amount by which an admissible motor between the places tried may be better, relative, in
/// each of the [objectives](MotorSearch::objectives); 0 for those that are none. See [`crate::search`].
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SpacingError {
    /// Displacement by volume: 0.01 where it may be 1.01 times as great.
    pub displacement_by_volume: f64,
    /// Ripple: 0.01 where it may be less by a factor of 1.01.
    pub ripple: f64,
    /// Least curvature radius: 0.01 where it may be 1.01 times as great.
    pub least_radius: f64,
    /// Ripple at the flanks: 0.01 where it may be less by a factor of 1.01.
    pub flank_ripple: f64,
    /// Least torque over the mean at the flanks: 0.01 where it may be 1.01 times as great.
    pub least_torque: f64,
}

impl SpacingError {
    /// Error from differences of logarithms.
    pub(super) fn of(excess: Value) -> Self {
        let [displacement_by_volume, ripple, least_radius, flank_ripple, least_torque] =
            excess.map(libm::expm1);
        Self { displacement_by_volume, ripple, least_radius, flank_ripple, least_torque }
    }
}

/// Counts of the motors by their results.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Funnel {
    /// Sets of numbers within the bounds that fulfil the conditions on them.
    pub sets: usize,
    /// Sets outside the limits of rotor lobes, rotor teeth or the common divisor.
    pub outside_limits: usize,
    /// Sets within these limits with which no motor of two arcs closes.
    pub without_family: usize,
    /// Motors at the evenly spaced places.
    pub points: usize,
    /// Motors added by refinement.
    pub refined: usize,
    /// Motors that passed every check and limit.
    pub accepted: usize,
    /// Accepted motors that no other dominates.
    pub front: usize,
    refused: Refusals,
}

impl Funnel {
    /// Motors refused for a reason, each counted once, by the first failure.
    #[must_use]
    pub fn refused(&self, reason: Reason) -> u64 {
        self.refused.of(reason)
    }

    pub(super) fn refuse(&mut self, reason: Option<Reason>) {
        if let Some(reason) = reason {
            self.refused.count(reason);
        }
    }
}

/// A design of the front: a shape, and the sizes in which it serves.
#[derive(Debug, Clone, PartialEq)]
pub struct Design {
    /// Lobes and teeth.
    pub numbers: MotorNumbers,
    /// Displacement over the volume of the cylinder about the stator's centrode.
    pub displacement_by_volume: f64,
    /// Ripple `δ` of flow and torque, satellites sealing at the pitch points.
    pub ripple: f64,
    /// Ripple and least torque with satellites that seal at the flanks of the
    /// [form](super::FlankTerms::form), where an objective or a bound is of them; [`AtFlanks::of`] gives them
    /// of any design's motor.
    pub at_flanks: Option<AtFlanks>,
    /// Least curvature radius of the centrodes over the module.
    pub least_radius: f64,
    /// The curve that has it.
    pub least_radius_of: Subject,
    /// The check nearest its limit.
    pub nearest_check: Subject,
    /// Margin of the nearest check over its limit, relative.
    pub nearest_margin: f64,
    /// Estimate of the amount by which motors between the places tried may be better.
    pub spacing_error: SpacingError,
    /// The sizes that keep the limits, at least one, in the order of the modules given.
    pub dimensions: Vec<Dimensions>,
    arcs: StatorArcs,
}

impl Design {
    /// The stator's arcs at a module.
    ///
    /// # Errors
    /// [`Error::NotPositive`].
    pub fn arcs(&self, module: Length) -> Result<StatorArcs, Error> {
        let module = machine::module(module)?;
        Ok(StatorArcs { module, ..self.arcs })
    }

    /// The motor at a module.
    ///
    /// # Errors
    /// [`Error::NotPositive`].
    pub fn motor(&self, module: Length) -> Result<Motor, Error> {
        Ok(Motor::of_closed_arcs(self.numbers, self.arcs(module)?))
    }
}

impl MotorSearch {
    /// The record of a point; none of one that was not worked.
    pub(super) fn design(
        &self,
        sizing: &Sizing,
        numbers: MotorNumbers,
        point: &Point,
        spacing_error: SpacingError,
    ) -> Option<Design> {
        let (working, arcs) = (point.working?, point.arcs?);
        let sizes = sizing.sizes(working.displacement, working.diameter);
        let dimensions =
            sizes.into_iter().map(|size| Dimensions::of(&self.requirements, &working, size)).collect();
        let (nearest_check, nearest_margin) = point.nearest;
        Some(Design {
            numbers,
            displacement_by_volume: working.by_volume(),
            ripple: working.ripple(),
            at_flanks: point.at_flanks,
            least_radius: point.radius,
            least_radius_of: point.radius_of,
            nearest_check,
            nearest_margin,
            spacing_error,
            dimensions,
            arcs,
        })
    }
}
