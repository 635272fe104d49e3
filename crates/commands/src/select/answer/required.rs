//! What is wanted of a gearbox, as a record.

use super::duty::Duty;
use crate::error::Error;
use crate::shared::catalogue::KRange;
use epicyclic_selection::{self as selection, Order, Orders, Requirements, Signs};
use epicyclic_units::Physical;
use schemars::JsonSchema;
use serde::Serialize;

/// What is wanted.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Required {
    /// Ratios of the braked gears, one or two.
    pub ratios: Vec<f64>,
    /// How far a ratio may be off, as a share of it.
    pub tolerance: f64,
    /// Which brake gives which ratio.
    pub brakes: Brakes,
    /// Which signs the ratios may have.
    pub signs: RatioSigns,
    /// What decides first, and what next where that is equal.
    pub order: Vec<Objective>,
    /// Ring-to-sun ratios allowed.
    pub k: KRange,
    /// Ring-to-sun ratios preferred.
    pub preferred_k: KRange,
    /// Efficiency of each set with its carrier fixed.
    pub set_efficiency: f64,
    /// Least efficiency of a gear.
    pub least_efficiency: f64,
    /// Greatest speed of a link; `null` where there is no limit.
    pub greatest_link_speed_of_input: Option<f64>,
    /// Greatest speed of a planet relative to its carrier; `null` where there is no limit.
    pub greatest_planet_speed_of_input: Option<f64>,
    /// Greatest slip of the open direct-drive clutch; `null` where there is no limit.
    pub greatest_clutch_slip_of_input: Option<f64>,
    /// Greatest circulating power of a gear over what enters; `null` where there is no limit.
    pub greatest_circulating_of_entering: Option<f64>,
    /// Whether all gears must turn the output in the same direction.
    pub same_direction: bool,
    /// Whether the scheme must be drawable: realizable with nested shafts, no link across another.
    pub drawable: bool,
    /// Number of planets of each set, where no tooth numbers say.
    pub planets: u32,
    /// Mesh load factors K_γ with 2, 3, … 8 planets.
    pub mesh_load_factors: Vec<f64>,
    /// Face width over the pitch diameter of the smaller of sun and planet.
    pub face_width_ratio: f64,
    /// Load factor K of the sun's teeth; with it and a torque sizes are lengths.
    pub load_factor_pa: Option<f64>,
    /// Speed of the input.
    pub input_speed_rad_s: Option<f64>,
    /// Torque on the input.
    pub input_torque_n_m: Option<f64>,
}

/// Which brake gives which ratio.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Brakes {
    /// Either brake gives either ratio.
    Either,
    /// The first brake gives the first ratio.
    AsGiven,
}

/// Which signs the ratios may have; direct drive is positive.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum RatioSigns {
    /// All positive, or all negative.
    Alike,
    /// Each by itself.
    Any,
    /// Those given.
    AsGiven,
}

/// What designs are compared by.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Objective {
    /// The direction of the output, alike in all gears or not: before all others, and none that an order
    /// names.
    Direction,
    /// The least efficiency of a braked gear; more is better.
    Efficiency,
    /// The largest speed of a link, or of a planet relative to its carrier; less is better.
    Speed,
    /// The distance of ln k from the preferred range, summed over the sets; less is better.
    RingToSunRatio,
    /// The largest error of a ratio; less is better.
    RatioError,
    /// The largest ring at the same load of the teeth; less is better.
    Size,
    /// The largest circulating power of a braked gear; less is better.
    Circulation,
}

impl Objective {
    /// The objective as a record.
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
            brakes: match requirements.orders {
                Orders::Both => Brakes::Either,
                Orders::AsGiven => Brakes::AsGiven,
            },
            signs: match requirements.signs {
                Signs::Alike => RatioSigns::Alike,
                Signs::Any => RatioSigns::Any,
                Signs::AsGiven => RatioSigns::AsGiven,
            },
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
