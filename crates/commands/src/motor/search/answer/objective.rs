//! Objectives by which the designs of a search are compared and ordered.

use crate::shared::named::{named, paired};
use epicyclic_hydromotor::search::{self, Design};
use schemars::JsonSchema;
use serde::Serialize;

/// Objectives of designs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Objective {
    /// Greatest displacement per volume.
    Volume,
    /// Least ripple if satellites seal at the pitch points.
    Ripple,
    /// Largest least curvature radius, in modules.
    Radius,
    /// Least ripple if satellites seal at the flanks.
    FlankRipple,
    /// Largest least torque over mean torque if satellites seal at the flanks.
    LeastTorque,
}

named! {
    Objective {
        Volume "volume"
        Ripple "ripple"
        Radius "radius"
        FlankRipple "flank-ripple"
        LeastTorque "least-torque"
    }
}

paired! {
    Objective, search::Objective {
        Volume DisplacementByVolume
        Ripple Ripple
        Radius LeastRadius
        FlankRipple FlankRipple
        LeastTorque LeastTorque
    }
}

impl Objective {
    /// Cost of a design by this objective, the less the better; a missing value comes last.
    pub(crate) fn cost(self, design: &Design) -> f64 {
        match self {
            Self::Volume => -design.displacement_by_volume,
            Self::Ripple => design.ripple,
            Self::Radius => -design.least_radius,
            Self::FlankRipple => design.at_flanks.map_or(f64::INFINITY, |at| at.ripple),
            Self::LeastTorque => design.at_flanks.map_or(f64::INFINITY, |at| -at.least_over_mean),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shared::named::Named as _;

    #[test]
    fn every_objective_is_read_from_its_name_and_goes_to_the_search_and_back() {
        for &objective in Objective::ALL {
            assert_eq!(objective.to_string().parse(), Ok(objective));
            assert_eq!(Objective::of(objective.of_search()), objective);
        }
        assert_eq!(Objective::ALL.len(), search::Objective::ALL.len());
        let refused = "contact-ratio".parse::<Objective>().unwrap_err();
        assert_eq!(
            refused,
            "\"contact-ratio\" is none of volume, ripple, radius, flank-ripple, least-torque"
        );
    }
}
