//! Rating of a solution by the solver at its best ring-to-sun ratios.

use crate::shared::drawability::answer::Conflict;
use epicyclic_layout::{Options, Verdict, draw};
use epicyclic_synthesis::judge::Judged;
use epicyclic_synthesis::rank::{self, Objective};
use schemars::JsonSchema;
use serde::Serialize;

/// Values of the objectives for a solution.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Rating {
    /// Whether the solution is non-dominated: no other is better in one objective of the front and worse in
    /// none.
    pub non_dominated: bool,
    /// First objective by which the solution is behind the first one; null for the first, and for an equal
    /// one.
    pub behind_by: Option<Objective>,
    /// Whether the scheme with all shift elements can be drawn without links that cross.
    pub drawable: bool,
    /// Elements that cannot be drawn together; null for a drawable scheme.
    pub conflict: Option<Conflict>,
    /// Mean of `drag_of_input` over the forward gears.
    pub mean_drag_of_input: f64,
    /// Greatest torque of a shift element or a member of a set in any gear, with losses, relative to the
    /// input torque.
    pub greatest_torque_of_input: f64,
    /// Greatest speed of a link, or planet speed relative to its carrier, in any gear, relative to the input
    /// speed.
    pub greatest_speed_of_input: f64,
    /// Greatest circulating power of a gear relative to the entering power.
    pub greatest_circulating_of_entering: f64,
    /// Greatest ratio of a step between forward gears to the previous step; null for fewer than two steps.
    pub progression: Option<f64>,
    /// Greatest deviation of a ratio over half the width of its bounds.
    pub deviation_of_tolerance: f64,
    /// Figures of the gears, in the order in which they were required.
    pub gears: Vec<GearRating>,
}

/// Figures of a gear.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct GearRating {
    /// Greatest torque of a shift element with losses, relative to the input torque.
    pub greatest_shift_element_torque_of_input: f64,
    /// Greatest torque of a member of a set with losses, relative to the input torque.
    pub greatest_member_torque_of_input: f64,
    /// Slip of each shift element relative to the input speed, in the order of the elements: speed of the
    /// first link minus that of the second. The slip is 0 if engaged, null if a speed is unknown.
    pub slips_of_input: Vec<Option<f64>>,
    /// Sum of the absolute slips of the open shift elements, relative to the input speed.
    pub drag_of_input: f64,
    /// Greatest speed of a link relative to the input speed.
    pub greatest_link_speed_of_input: f64,
    /// Greatest planet speed relative to its carrier, relative to the input speed; for planets of a
    /// double-planet set a lower bound.
    pub greatest_planet_speed_of_input: f64,
    /// Circulating power relative to the entering power.
    pub circulating_of_entering: f64,
}

impl Rating {
    pub(super) fn of(
        rating: &rank::Rating,
        judged: &Judged,
        non_dominated: bool,
        behind_by: Option<Objective>,
    ) -> Self {
        let conflict = (!rating.is_drawable())
            .then(|| draw(&judged.gearbox, Options { attempts: 1, ..Options::default() }))
            .and_then(|verdict| match verdict {
                Verdict::SelfCrossing(witness) => Some(Conflict::of(&judged.gearbox, &witness)),
                Verdict::Drawable(_) => None,
            });
        Self {
            non_dominated,
            behind_by,
            drawable: rating.is_drawable(),
            conflict,
            mean_drag_of_input: rating.value(Objective::Drag),
            greatest_torque_of_input: rating.value(Objective::Torque),
            greatest_speed_of_input: rating.value(Objective::Speed),
            greatest_circulating_of_entering: rating.value(Objective::Circulation),
            progression: rating.progression,
            deviation_of_tolerance: rating.value(Objective::Deviation),
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
