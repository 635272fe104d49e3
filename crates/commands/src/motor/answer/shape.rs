//! Shape of a motor: the stator's arcs and their family, or the law of the rotor.

use super::Chosen;
use crate::error::Error;
use crate::shared::number::{maybe_si, plain, power_of_ten_above, si};
use crate::tolerance::CLOSED;
use epicyclic_hydromotor as hydromotor;
use epicyclic_hydromotor::arcs::StatorArcs;
use epicyclic_hydromotor::closure::{self, Family};
use epicyclic_hydromotor::second_harmonic::{self, HarmonicLaw};
use schemars::JsonSchema;
use serde::Serialize;

/// Stator of two arcs, and the family of motors to which it belongs.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Arcs {
    /// Reason for the choice of the motor from its family.
    pub chosen: Chosen,
    /// Distance `l` of the centre of arc 1, at the troughs, from the axis, in m.
    pub l_m: f64,
    /// Distance `a` of the centre of arc 2, at the crests, from the axis, in m.
    pub a_m: f64,
    /// Radius of arc 1 in m.
    pub r1_m: f64,
    /// Radius of arc 2 in m.
    pub r2_m: f64,
    /// Angle of arc 1 at its centre, in rad.
    pub gamma_rad: f64,
    /// Angle of arc 2 at its centre, in rad.
    pub beta_rad: f64,
    /// Ranges of the distance `l` for which a motor of these numbers closes: usually one, for few lobes two.
    pub family: Vec<Interval>,
    /// Closure error of a half-lobe by quadrature of the rolling, in rad, rounded up to a power of ten.
    pub closes_by_quadrature_within_rad: f64,
    /// Closure error of a half-lobe in rad caused by an error of 0.01 modules in `a`.
    pub opened_by_a_hundredth_module_rad: f64,
}

/// Interval of a family.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Interval {
    /// Least `l` of the interval, in m.
    pub from_m: f64,
    /// Limit at the least `l`.
    pub from_limit: closure::Limit,
    /// Greatest `l` of the interval in m; null if rounding leaves none at a cusp.
    pub to_m: Option<f64>,
    /// Limit at the greatest `l`.
    pub to_limit: closure::Limit,
}

/// Rotor by the cosine law.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct CosineLaw {
    /// Mean radius of the rotor, `c`, in m.
    pub mean_radius_m: f64,
    /// Relative amplitude `ε`.
    pub amplitude: f64,
    /// Relative amplitude of the second harmonic, `ε₂`; 0 without one.
    pub second_amplitude: f64,
    /// Relative amplitude at which the stator gets cusps; null with a second harmonic.
    pub cusp_amplitude: Option<f64>,
    /// Range of `ε₂` in which motors of these numbers close without cusps; null if none exists.
    pub second_harmonics: Option<HarmonicRange>,
}

/// Range of `ε₂`, both ends excluded.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct HarmonicRange {
    /// Lower end of the range, excluded.
    pub from: f64,
    /// Upper end of the range, excluded.
    pub to: f64,
}

impl CosineLaw {
    pub(crate) fn of(motor: &hydromotor::Motor, law: &HarmonicLaw) -> Self {
        let range = second_harmonic::range(motor.numbers()).ok();
        Self {
            mean_radius_m: si(law.mean_radius),
            amplitude: plain(law.amplitude),
            second_amplitude: plain(law.second_amplitude),
            cusp_amplitude: motor.cosine_law().map(|law| plain(law.cusp_amplitude)),
            second_harmonics: range.map(|range| HarmonicRange {
                from: range.lower.second_amplitude,
                to: range.upper.second_amplitude,
            }),
        }
    }
}

/// Deviation of arcs from the rotor's exact curve.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Rotor {
    /// Deviation of the best pair of tangent arcs, in m.
    pub best_arcs_deviation_m: f64,
    /// Deviation of the circles that the source gives, in m; null if it gives none.
    pub published_circles_deviation_m: Option<f64>,
    /// Angle at which these circles meet, in rad; null if the source gives none.
    pub published_circles_kink_rad: Option<f64>,
}

impl Arcs {
    pub(crate) fn of(
        motor: &hydromotor::Motor,
        arcs: &StatorArcs,
        family: &Family,
        chosen: Chosen,
    ) -> Result<Self, Error> {
        let closed = closure::closure(motor.numbers(), arcs)?;
        let within = power_of_ten_above(closed.residual_by_quadrature_rad.abs(), CLOSED);
        Ok(Self {
            chosen,
            l_m: si(arcs.trough_distance()),
            a_m: si(arcs.crest_distance()),
            r1_m: si(arcs.trough_radius()),
            r2_m: si(arcs.crest_radius()),
            gamma_rad: si(arcs.trough_angle()),
            beta_rad: si(arcs.crest_angle()),
            family: Interval::all(family),
            closes_by_quadrature_within_rad: within,
            // Closure error for a hundredth of a module in a, at the same l.
            opened_by_a_hundredth_module_rad: plain(0.01 * closed.by_crest_distance),
        })
    }
}

impl Interval {
    /// Lists the intervals of a family.
    pub(crate) fn all(family: &Family) -> Vec<Self> {
        family.intervals().iter().filter_map(Self::of).collect()
    }

    fn of(interval: &closure::Interval) -> Option<Self> {
        let at = |end: &closure::End| end.arcs().map(StatorArcs::trough_distance);
        Some(Self {
            from_m: si(at(&interval.lower)?),
            from_limit: interval.lower.limit,
            to_m: maybe_si(at(&interval.upper)),
            to_limit: interval.upper.limit,
        })
    }
}

impl Rotor {
    pub(crate) fn of(motor: &hydromotor::Motor) -> Self {
        let circles = motor.published_circles();
        Self {
            best_arcs_deviation_m: si(motor.two_arc_fit().deviation),
            published_circles_deviation_m: circles.as_ref().map(|circles| si(circles.deviation)),
            published_circles_kink_rad: circles.as_ref().map(|circles| si(circles.kink)),
        }
    }
}
