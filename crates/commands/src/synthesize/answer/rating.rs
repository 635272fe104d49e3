//! What a solution is worth, by the solver at its best ring-to-sun ratios.

use crate::shared::drawability::answer::Conflict;
use epicyclic_layout::{Options, Verdict, draw};
use epicyclic_synthesis::judge::Judged;
use epicyclic_synthesis::rank;
use schemars::JsonSchema;
use serde::Serialize;

/// What a solution is measured by.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Objective {
    /// Whether its scheme can be drawn without links that cross.
    Drawable,
    /// Shifts between neighbouring forward gears that exchange more than one shift element; less is better.
    Shifts,
    /// The efficiency of the forward gears: the least, or the mean by the shares of time; more is better.
    Efficiency,
    /// The mean over the forward gears of the sum of the slips of the open shift elements; less is better.
    Drag,
    /// The greatest torque of a shift element or a member of a set; less is better.
    Torque,
    /// The greatest speed of a link, or of a planet relative to its carrier; less is better.
    Speed,
    /// The greatest circulating power; less is better.
    Circulation,
    /// The greatest ratio of a step to the step before it; less is better.
    Progression,
    /// The greatest deviation of a ratio, by half its bounds' width; less is better.
    Deviation,
    /// The least efficiency of a reverse gear; more is better.
    Reverse,
}

/// A solution's figures for the objectives.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Rating {
    /// Whether no other solution is nowhere worse and somewhere better, in the objectives of the front.
    pub non_dominated: bool,
    /// The first objective of the order in which it is behind the first solution; `null` of the first, and of
    /// one that is equal.
    pub behind_by: Option<Objective>,
    /// Whether the scheme can be drawn without links that cross, with all shift elements.
    pub drawable: bool,
    /// What cannot be drawn together; `null` of a drawable scheme.
    pub conflict: Option<Conflict>,
    /// The mean over the forward gears of `drag_of_input`.
    pub mean_drag_of_input: f64,
    /// The greatest torque of a shift element or a member of a set in any gear, over the input's, with
    /// losses.
    pub greatest_torque_of_input: f64,
    /// The greatest speed of a link, or of a planet relative to its carrier, in any gear, over the input's.
    pub greatest_speed_of_input: f64,
    /// The greatest circulating power of a gear, over what enters.
    pub greatest_circulating_of_entering: f64,
    /// The greatest ratio of a step between forward gears to the step before it; `null` of fewer than two
    /// steps.
    pub progression: Option<f64>,
    /// The greatest deviation of a ratio, by half its bounds' width.
    pub deviation_of_tolerance: f64,
    /// The gears, in the order of the wish.
    pub gears: Vec<GearRating>,
}

/// A gear's figures.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct GearRating {
    /// The greatest torque of a shift element over the input's, with losses.
    pub greatest_shift_element_torque_of_input: f64,
    /// The greatest torque of a member of a set over the input's, with losses.
    pub greatest_member_torque_of_input: f64,
    /// Slip of each shift element, in their order: speed of the first link less that of the second, over the
    /// input's; 0 where it is engaged, `null` where a speed does not follow.
    pub slips_of_input: Vec<Option<f64>>,
    /// The sum of the slips of the open shift elements, without their signs.
    pub drag_of_input: f64,
    /// The greatest speed of a link over the input's.
    pub greatest_link_speed_of_input: f64,
    /// The greatest speed of a planet relative to its carrier, over the input's; of a double-planet set's
    /// planets what they exceed.
    pub greatest_planet_speed_of_input: f64,
    /// Circulating power over what enters.
    pub circulating_of_entering: f64,
}

impl Objective {
    /// The objective as a record.
    #[must_use]
    pub const fn of(objective: rank::Objective) -> Self {
        match objective {
            rank::Objective::Drawable => Self::Drawable,
            rank::Objective::Shifts => Self::Shifts,
            rank::Objective::Efficiency => Self::Efficiency,
            rank::Objective::Drag => Self::Drag,
            rank::Objective::Torque => Self::Torque,
            rank::Objective::Speed => Self::Speed,
            rank::Objective::Circulation => Self::Circulation,
            rank::Objective::Progression => Self::Progression,
            rank::Objective::Deviation => Self::Deviation,
            rank::Objective::Reverse => Self::Reverse,
        }
    }
}

impl Rating {
    pub(super) fn of(
        rating: &rank::Rating,
        judged: &Judged,
        non_dominated: bool,
        behind_by: Option<rank::Objective>,
    ) -> Self {
        let conflict = (!rating.is_drawable())
            .then(|| draw(&judged.gearbox, Options { attempts: 1, ..Options::default() }))
            .and_then(|verdict| match verdict {
                Verdict::SelfCrossing(witness) => Some(Conflict::of(&judged.gearbox, &witness)),
                Verdict::Drawable(_) => None,
            });
        Self {
            non_dominated,
            behind_by: behind_by.map(Objective::of),
            drawable: rating.is_drawable(),
            conflict,
            mean_drag_of_input: rating.value(rank::Objective::Drag),
            greatest_torque_of_input: rating.value(rank::Objective::Torque),
            greatest_speed_of_input: rating.value(rank::Objective::Speed),
            greatest_circulating_of_entering: rating.value(rank::Objective::Circulation),
            progression: rating.progression,
            deviation_of_tolerance: rating.value(rank::Objective::Deviation),
            gears: rating.gears.iter().map(GearRating::of).collect(),
        }
    }
}

impl GearRating {
    fn of(gear: &rank::GearRating) -> Self {
        Self {
            greatest_shift_element_torque_of_input: gear.shift_element_torque,
            greatest_member_torque_of_input: gear.member_torque,
            slips_of_input: gear.slips.clone(),
            drag_of_input: gear.drag,
            greatest_link_speed_of_input: gear.link_speed,
            greatest_planet_speed_of_input: gear.planet_speed,
            circulating_of_entering: gear.circulation,
        }
    }
}
