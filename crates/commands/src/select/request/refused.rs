//! Options that an error of a selection refers to.

use super::Args;
use crate::error::Error;
use crate::failure::Failure;
use crate::select::answer::duty::{DutyProblem, DutyQuantity};
use epicyclic_selection::quantity::{KRange, Limited, Rated};

/// Converts an error to a failure with the option that caused it.
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
        E::GearSet(error) => match crate::shared::options::of_teeth(error, "--planet-count") {
            Some(option) => option,
            None => return Failure::Selection(E::GearSet(error.clone())),
        },
        E::RepeatedObjective { .. } | E::UnknownObjective { .. } | E::NoObjectiveOfTeeth { .. } => "--order",
        _ => return Failure::Selection(error),
    };
    Failure::of_option(option, &error)
}

/// Converts an error to a failure with the option that caused it.
pub(super) fn refuse(args: &Args, error: Error) -> Failure {
    match error {
        Error::Selection(error) => refuse_selection(error),
        Error::Duty(problem) => refuse_duty(args, problem),
        Error::TooManyDesigns { .. } => {
            let message = format!(
                "{error}; narrow the ranges of teeth or the tolerance to see the non-dominated designs further back"
            );
            Failure::named(error.name(), "--limit", message)
        }
        Error::ModuleRange { .. } => Failure::of_option("--least-module", &error),
        error => error.into(),
    }
}

fn refuse_duty(args: &Args, problem: DutyProblem) -> Failure {
    const DUE: &str = "a finite quantity above 0 is due";
    let duty = &args.duty;
    let (option, written) = match problem {
        DutyProblem::NotPositive { quantity: DutyQuantity::InputSpeed } => {
            ("--input", duty.input.map(|speed| speed.to_string()))
        }
        DutyProblem::NotPositive { quantity: DutyQuantity::Torque } => {
            ("--torque", duty.torque.map(|torque| torque.to_string()))
        }
        DutyProblem::NotPositive { quantity: DutyQuantity::Power } => {
            ("--power", duty.power.map(|power| power.to_string()))
        }
        DutyProblem::TorqueOfPower { torque_n_m } => {
            let written = duty.power.zip(duty.input);
            ("--power", written.map(|(power, speed)| format!("{power} at {speed}, {torque_n_m} N·m")))
        }
        DutyProblem::PowerWithoutSpeed => return Error::Duty(problem).into(),
    };
    let message = written.map_or_else(|| DUE.to_owned(), |written| format!("{written}: {DUE}"));
    Failure::invalid(option, message)
}
