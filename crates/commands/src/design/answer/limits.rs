//! Limits of an order for the whole gearbox, and what it says that no rule judges.

use super::masses::Masses;
use super::records::SizesStep;
use crate::answer::Warning;
use epicyclic_units::Dimension;
use schemars::JsonSchema;
use serde::Serialize;

/// Limits of an order for the whole gearbox, its greatest speed, and a load that no rule judges.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct OrderLimits {
    /// Greatest mass of the whole in kg; null without a limit.
    pub whole_kg: Option<f64>,
    /// Mass of the lightest gearbox found, in kg, if it is above the limit and not taken; null otherwise.
    pub lightest_kg: Option<f64>,
    /// Greatest length of the stages along the axis in m; null without a limit.
    pub length_m: Option<f64>,
    /// Length of the shortest stages found, in m, if they are above the limit and not taken; null otherwise.
    pub shortest_m: Option<f64>,
    /// Greatest speed of the input without load over that of the load; null if not asked for.
    pub runaway_over_speed: Option<f64>,
    /// Speed of the input without load in rad/s; null if not asked for.
    pub runaway_speed_rad_s: Option<f64>,
    /// Radial force on the output in N, which is not judged; null if not asked for.
    pub side_load_n: Option<f64>,
}

/// Length of the best sizes along the axis, in m.
pub(crate) fn length_m(sizes: &SizesStep) -> f64 {
    sizes.sets.iter().filter_map(|set| set.found.first()).map(|design| design.length_m).sum()
}

impl OrderLimits {
    /// Whether anything is asked for.
    pub(crate) const fn is_any(&self) -> bool {
        self.whole_kg.is_some()
            || self.length_m.is_some()
            || self.runaway_over_speed.is_some()
            || self.side_load_n.is_some()
    }

    /// Whether a gearbox keeps to the limits. What it exceeds is noted, the least of all.
    pub(super) fn allow(&mut self, masses: Option<&Masses>, sizes: &SizesStep) -> bool {
        let least = |noted: &mut Option<f64>, value: f64| {
            *noted = Some(noted.map_or(value, |before| before.min(value)));
            false
        };
        let length = length_m(sizes);
        if self.length_m.is_some_and(|most| length > most) {
            return least(&mut self.shortest_m, length);
        }
        match (self.whole_kg, masses) {
            (Some(most), Some(of)) if of.whole_kg > most => least(&mut self.lightest_kg, of.whole_kg),
            _ => true,
        }
    }

    /// The limits with what gearboxes of both exceed; nothing where one was taken.
    pub(super) fn with(mut self, other: Self, is_taken: bool) -> Self {
        let least = |one: Option<f64>, other: Option<f64>| {
            one.into_iter().chain(other).reduce(f64::min).filter(|_| !is_taken)
        };
        self.lightest_kg = least(self.lightest_kg, other.lightest_kg);
        self.shortest_m = least(self.shortest_m, other.shortest_m);
        self
    }

    /// A warning of a load that is not judged.
    pub(super) fn warning(&self) -> Option<Warning> {
        let force = self.side_load_n?;
        let force = crate::table::quantities::words(Dimension::Force, force, 4);
        Some(Warning {
            name: "side-load-not-judged",
            message: format!(
                "the bearings of the output are not in the design: leave them under the side load of {force} to their maker"
            ),
        })
    }
}
