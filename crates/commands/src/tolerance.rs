//! Tolerances of the answers: values below them count as zero.
//!
//! - `ROUNDED`: a loss over the power that enters, an imbalance, an angle that a rotor leaves open, rad.
//!   Rounding leaves 1e-15 of a balance of some dozen terms.
//! - `SAME`: the members of a printed series, over their right values. The series are calculated, not read
//!   from print.
//! - `SAME_RATIO`: ratios of two gears, over the larger. One ratio by two engagements differs by rounding
//!   only; different teeth differ by far more.
//! - `CLOSED`: the residual of a closed motor, rad. The smallest power of ten that is shown.
//! - `OBJECTIVE`: a difference of two objectives. The order compares on a grid of this size.
//! - `AT_EDGE`: the distance of a ring-to-sun ratio from the end of its range, over that end. The best ratio
//!   is known to 1e-4.
//! - `MET`: the distance of an order from the frequency it meets, over that frequency. Far below the accuracy
//!   of any stiffness, far above rounding.
//! - `PEAK`: the interval about the speed of a greatest force, over that speed. A ten-thousandth of the
//!   sharpest peak that is allowed.
//! - `THERMAL`: the interval about a thermal limit, over the torque there. The loss is known to as much.
//! - `EQUAL_SPACING`: the distance of a planet from its place among equally spaced ones, rad. Angles in
//!   degrees have nine digits.
//! - `STILL`: the displacement of a body in a mode, over the largest. The error of a vector beside a
//!   neighbouring frequency.
//! - `LEAST_MODULE_M`: the module, if no least one is given. A micrometre: no gear has less.
//! - `RESIDUAL`: the energy that a motion does not account for, over the largest. A run keeps the energies to
//!   1e-11 of a step.
//! - `NOTHING`: a multiple. The zero that rounding leaves.
//! - `LEVEL`: the differences of a curve, over its largest value. A level line.
//! - `CIRCULATES`: circulating power, over the power that enters. Less has no practical meaning.
//! - `RESTS`: the speed of a planet on its pin, over the input's. Rounding of a planet that does not turn.
//! - `SHARES`: the sum of shares, less 1. Rounding of the numbers as written.
//! - `PRESSED_M`: overlap of flanks within their tolerances, m. Half of the last digit that is printed.
//! - `EDGE`: a radius beyond the reach of a search, over the step. Reach and multiples are rounded.
//! - `BESIDE`: an angle beside a jump, rad. Values right beside a jump are taken at this distance: 6·10⁻⁵
//!   degrees.

use epicyclic_units::Physical as _;
use uom::si::f64::Angle;

/// The sum of shares may be off 1 by as much.
pub(crate) const SHARES: f64 = 1e-6;

/// A radius within this share of a step beyond the reach of a search is within it.
pub(crate) const EDGE: f64 = 1e-6;

/// A sum of balanced terms below this is zero.
pub(crate) const ROUNDED: f64 = 1e-12;

const BESIDE: f64 = 1e-6;

/// Angle in radians; 0 for an angle that marks one side of a jump at 0.
pub(crate) fn beside_zero(angle: Angle) -> f64 {
    if angle.si().abs() < BESIDE { 0.0 } else { angle.si() }
}

/// A share or an angle, 0 where it is only the rounding that balances and differences of speeds leave.
pub(crate) fn rounded(share: f64) -> f64 {
    if share.abs() < ROUNDED { 0.0 } else { share }
}

/// Members of a series that differ by less are the right ones.
pub(crate) const SAME: f64 = 1e-9;

/// Ratios of gears that differ by less, over the larger, are one.
pub(crate) const SAME_RATIO: f64 = 1e-9;

/// Smallest power of ten that is shown for the residual of a closed motor, rad.
pub(crate) const CLOSED: f64 = 1e-12;

/// A number of a file to be written differs from a shorter one by less than this share of it: rounding.
pub(crate) const SHORT: f64 = 1e-12;

/// Objectives that differ by less are equal.
pub(crate) const OBJECTIVE: f64 = 2e-12;

/// Ring-to-sun ratios nearer to an end of their range are at it.
pub(crate) const AT_EDGE: f64 = 1e-4;

/// An order meets a natural frequency where it is this near, over it.
pub(crate) const MET: f64 = 1e-12;

/// A greatest force is known to be within this part of its speed.
pub(crate) const PEAK: f64 = 1e-8;

/// A thermal limit is known to this part of its torque.
pub(crate) const THERMAL: f64 = 1e-12;

/// A body that moves by less of the largest displacement of a mode is at rest.
pub(crate) const STILL: f64 = 1e-6;

/// Planets that are this near to equally spaced places, rad, are equally spaced.
pub(crate) const EQUAL_SPACING: f64 = 1e-9;

/// The least module where none is given, in m.
pub(crate) const LEAST_MODULE_M: f64 = 1e-6;

/// Energies of a motion that miss more, over the largest of them, are warned of.
pub(crate) const RESIDUAL: f64 = 1e-9;

/// A place of a planet is whole within this, in places: rounding of an angle times some hundred of them.
pub(crate) const AT_POSITION: f64 = 1e-6;

/// A multiple below this is the zero that rounding leaves.
pub(crate) const NOTHING: f64 = 1e-12;

/// A curve whose values differ by less, over the largest, is a level line.
pub(crate) const LEVEL: f64 = 1e-9;

/// Less circulating power, over what enters, is not objected to.
pub(crate) const CIRCULATES: f64 = 1e-6;

/// A planet that turns slower on its pin, over the input's speed, does not turn.
pub(crate) const RESTS: f64 = 1e-12;

/// The least backlash of a mesh is below 0 where it is below this, m: less prints as 0.
pub(crate) const PRESSED_M: f64 = 5e-7;

/// Part of a limit below whose distance a value lies on the limit by choice, not near it by chance: a rim that
/// is stated as the usual one.
pub(crate) const APART: f64 = 1e-6;
