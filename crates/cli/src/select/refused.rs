//! The option that a refusal of a selection speaks of.

use crate::failure::Failure;
use epicyclic_selection::quantity::{KRange, Limited, Rated};

/// The option that it speaks of.
pub(crate) fn refuse_selection(error: epicyclic_selection::Error) -> Failure {
    use epicyclic_schemes::Error as S;
    use epicyclic_selection::Error as E;
    let option = match &error {
        E::SpeedCount { .. } => "--speeds, --ratios",
        E::Scheme(S::SpeedCount { .. } | S::SpeedsOutOfOrder { .. }) => "--speeds",
        E::RatioCount { .. }
        | E::OneRatio { .. }
        | E::Scheme(S::RatioCount { .. } | S::Ratio { .. } | S::EqualRatios { .. }) => "--ratios",
        E::Tolerance { .. } => "--tolerance",
        E::RingToSunRange { what: KRange::Preferred, .. } => "--prefer",
        E::RingToSunRange { .. } => "--k",
        E::Limit { what: Limited::Efficiency, .. } => "--least-efficiency",
        E::Limit { what: Limited::LinkSpeed, .. } => "--link-speed",
        E::Limit { what: Limited::PlanetSpeed, .. } => "--planet-speed",
        E::Limit { what: Limited::ClutchSlip, .. } => "--clutch-slip",
        E::Limit { what: Limited::Circulation, .. } => "--circulation",
        E::Limit { what: Limited::Module, .. } => "--least-module, --greatest-module",
        E::Limit { what: Limited::RingDiameter, .. } | E::SizeWithoutTorque => "--ring-diameter",
        E::Rating { what: Rated::MeshLoadFactor, .. } => "--mesh-load-factors",
        E::Rating { what: Rated::FaceWidthRatio, .. } => "--face-width-ratio",
        E::Rating { what: Rated::LoadFactor, .. } => "--load-factor",
        E::PlanetNumber { .. } => "--planets",
        E::TooManyToothSets { .. } => "--sun, --planet, --ring, --k",
        E::TooManyWindows { .. } => "--sun, --planet, --ring, --k, --all-structures",
        E::TooManyNear { .. } | E::TooManyPairs { .. } | E::FrontTooLarge { .. } => {
            "--sun, --planet, --ring, --k, --tolerance"
        }
        E::GearSet(error) => match crate::options::of_teeth(error, "--planet-count") {
            Some(option) => option,
            None => return Failure::Selection(E::GearSet(error.clone())),
        },
        E::RepeatedObjective { .. } | E::UnknownObjective { .. } | E::NoObjectiveOfTeeth { .. } => "--order",
        _ => return Failure::Selection(error),
    };
    Failure::Option { option, message: error.to_string() }
}
