//! Requirements of a gearbox as a record.

use super::duty::Duty;
use crate::error::Error;
use crate::shared::catalogue::KRange;
use epicyclic_selection::{self as selection, Order, Orders, Requirements, Signs};
use epicyclic_units::Physical;
use schemars::JsonSchema;
use serde::Serialize;

/// Requirements of a gearbox.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Required {
    /// Required ratios of the braked gears, one or two.
    pub ratios: Vec<f64>,
    /// Allowed relative deviation of a ratio.
    pub tolerance: f64,
    /// Assignment of brakes to ratios.
    pub brakes: Orders,
    /// Allowed signs of the ratios.
    pub signs: Signs,
    /// Objectives in the order in which they decide.
    pub order: Vec<Objective>,
    /// Allowed range of ring-to-sun ratios.
    pub k: KRange,
    /// Preferred range of ring-to-sun ratios.
    pub preferred_k: KRange,
    /// Efficiency of each set with its carrier fixed.
    pub set_efficiency: f64,
    /// Minimum efficiency of a gear.
    pub least_efficiency: f64,
    /// Maximum speed of a link relative to the input speed; null without limit.
    pub greatest_link_speed_of_input: Option<f64>,
    /// Maximum planet speed relative to the carrier, relative to the input speed; null without limit.
    pub greatest_planet_speed_of_input: Option<f64>,
    /// Maximum slip of the open direct-drive clutch relative to the input speed; null without limit.
    pub greatest_clutch_slip_of_input: Option<f64>,
    /// Maximum circulating power of a gear relative to the entering power; null without limit.
    pub greatest_circulating_of_entering: Option<f64>,
    /// Whether all gears must turn the output in the same direction.
    pub same_direction: bool,
    /// Whether the scheme must be drawable: realizable with nested shafts, no link across another.
    pub drawable: bool,
    /// Number of planets of each set, used if no tooth numbers determine it.
    pub planets: u32,
    /// Mesh load factors K_γ for 2, 3, … 8 planets.
    pub mesh_load_factors: Vec<f64>,
    /// Face width over the pitch diameter of the smaller of sun and planet.
    pub face_width_ratio: f64,
    /// Load factor K of the sun's teeth in Pa; together with a torque it gives sizes as lengths. Null if not
    /// given.
    pub load_factor_pa: Option<f64>,
    /// Input speed in rad/s; null if not given.
    pub input_speed_rad_s: Option<f64>,
    /// Torque on the input in N·m; null if not given.
    pub input_torque_n_m: Option<f64>,
}

/// Objectives by which designs are compared.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Objective {
    /// Direction of the output: equal in all gears or mixed. This objective precedes all others, and no order
    /// names it.
    Direction,
    /// Least efficiency of a braked gear; more is better.
    Efficiency,
    /// Largest speed of a link, or planet speed relative to the carrier; less is better.
    Speed,
    /// Distance of ln k from the preferred range, summed over the sets; less is better.
    RingToSunRatio,
    /// Largest error of a ratio; less is better.
    RatioError,
    /// Size of the largest ring at equal tooth load; less is better.
    Size,
    /// Largest circulating power of a braked gear; less is better.
    Circulation,
}

impl Objective {
    /// Converts the objective into a record.
    #[must_use]
    pub fn of(objective: selection::Objective) -> Self {
        match objective {
            selection::Objective::Efficiency => Self::Efficiency,
            selection::Objective::Speed => Self::Speed,
            selection::Objective::RingToSun => Self::RingToSunRatio,
            selection::Objective::RatioError => Self::RatioError,
            selection::Objective::Size => Self::Size,
            selection::Objective::Circulation => Self::Circulation,
        }
    }
}

pub(super) fn finite(limit: f64) -> Option<f64> {
    limit.is_finite().then_some(limit)
}

impl Required {
    pub(super) fn of(requirements: &Requirements, order: Order, duty: &Duty) -> Result<Self, Error> {
        let limits = &requirements.limits;
        let rating = &requirements.rating;
        let range = |range: &std::ops::RangeInclusive<f64>| KRange::of(*range.start(), *range.end());
        Ok(Self {
            ratios: requirements.series.braked(),
            tolerance: requirements.tolerance,
            brakes: requirements.orders,
            signs: requirements.signs,
            order: order.objectives().into_iter().map(Objective::of).collect(),
            k: range(&limits.ring_to_sun),
            preferred_k: range(&limits.preferred),
            set_efficiency: requirements.eta0.get(),
            least_efficiency: limits.efficiency,
            greatest_link_speed_of_input: finite(limits.link_speed),
            greatest_planet_speed_of_input: finite(limits.planet_speed),
            greatest_clutch_slip_of_input: finite(limits.clutch_slip),
            greatest_circulating_of_entering: finite(limits.circulation),
            same_direction: limits.same_direction,
            drawable: limits.drawable,
            planets: rating.planets,
            mesh_load_factors: rating.mesh_load_factors.to_vec(),
            face_width_ratio: rating.face_width_ratio,
            load_factor_pa: rating.load.map(|(_, load_factor)| load_factor.si()),
            input_speed_rad_s: duty.input_speed.map(Physical::si),
            input_torque_n_m: duty.torque()?.map(Physical::si),
        })
    }
}
