//! Choices and objectives of a search with free tooth forms, with their names in options and records.

use crate::shared::named::{named, paired};
use crate::shared::number::{maybe_si, si};
use epicyclic_hydromotor::profile;
use epicyclic_hydromotor::search::forms::{self, FamilyKind, FlankFigures, FormDesign};
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
    /// Greatest contact ratio.
    ContactRatio,
    /// Least ripple if satellites seal at the flanks.
    FlankRipple,
    /// Largest least torque over mean torque if satellites seal at the flanks.
    LeastTorque,
    /// Least Hertzian contact stress.
    ContactStress,
    /// Least bending stress at the roots.
    RootStress,
    /// Greatest pressure drop that the material allows.
    AllowedPressure,
}

/// Families of motors.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Family {
    /// Stator of two arcs.
    Arcs,
    /// Rotor by the cosine law.
    Cosine,
    /// Rotor with a second harmonic.
    SecondHarmonic,
}

/// Tooth or space in the middle of the stator's crests.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Crest {
    /// Middle of a space.
    Space,
    /// Middle of a tooth.
    Tooth,
}

named! {
    Objective {
        Volume "volume"
        Ripple "ripple"
        Radius "radius"
        ContactRatio "contact-ratio"
        FlankRipple "flank-ripple"
        LeastTorque "least-torque"
        ContactStress "contact-stress"
        RootStress "root-stress"
        AllowedPressure "allowed-pressure"
    }
    Family {
        Arcs "arcs"
        Cosine "cosine"
        SecondHarmonic "second-harmonic"
    }
    Crest {
        Space "space"
        Tooth "tooth"
    }
}

paired! {
    Objective, forms::Objective {
        Volume DisplacementByVolume
        Ripple Ripple
        Radius LeastRadius
        ContactRatio ContactRatio
        FlankRipple FlankRipple
        LeastTorque LeastTorque
        ContactStress ContactStress
        RootStress RootStress
        AllowedPressure AllowedPressure
    }
    Family, FamilyKind {
        Arcs TwoArcs
        Cosine CosineLaw
        SecondHarmonic SecondHarmonic
    }
    Crest, profile::Crest {
        Space Space
        Tooth Tooth
    }
}

impl Objective {
    /// Cost of a design by this objective, the less the better; a missing value comes last.
    pub(crate) fn cost(self, design: &FormDesign) -> f64 {
        // A design without flanks under load must not win by a missing value, so it costs infinity.
        let of = |figure: &dyn Fn(&FlankFigures) -> Option<f64>| {
            design.flanks.as_ref().and_then(figure).unwrap_or(f64::INFINITY)
        };
        match self {
            // Values to be maximized are negated, so that the least cost is always the best.
            Self::Volume => -design.displacement_by_volume,
            Self::Ripple => design.ripple,
            Self::Radius => -design.least_radius,
            Self::ContactRatio => -design.contact_ratio,
            Self::FlankRipple => of(&|flanks| Some(flanks.ripple)),
            Self::LeastTorque => of(&|flanks| Some(-flanks.least_over_mean)),
            Self::ContactStress => of(&|flanks| maybe_si(flanks.contact_stress)),
            Self::RootStress => of(&|flanks| maybe_si(flanks.root_stress)),
            Self::AllowedPressure => of(&|flanks| Some(-si(flanks.allowed.pressure))),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shared::named::Named as _;

    #[test]
    fn every_choice_is_read_from_its_name_and_goes_to_the_search_and_back() {
        for &objective in Objective::ALL {
            assert_eq!(objective.to_string().parse(), Ok(objective));
            assert_eq!(Objective::of(objective.of_search()), objective);
        }
        for &family in Family::ALL {
            assert_eq!(family.to_string().parse(), Ok(family));
            assert_eq!(Family::of(family.of_search()), family);
        }
        for &crest in Crest::ALL {
            assert_eq!(crest.to_string().parse(), Ok(crest));
            assert_eq!(Crest::of(crest.of_search()), crest);
        }
        assert_eq!((Objective::ALL.len(), Family::ALL.len()), (forms::Objective::ALL.len(), 3));
        let refused = "arc".parse::<Family>().unwrap_err();
        assert_eq!(refused, "\"arc\" is none of arcs, cosine, second-harmonic");
    }
}
