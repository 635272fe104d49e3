//! Options that an error of a selection refers to.

use super::Request;
use crate::error::Error;
use crate::failure::Failure;
use crate::select::answer::duty::{DutyProblem, DutyQuantity};
use crate::shared::selection::refuse_selection;

/// Converts an error to a failure with the option that caused it.
pub(super) fn refuse(request: &Request, error: Error) -> Failure {
    match error {
        Error::Selection(error) => refuse_selection(error),
        Error::Duty(problem) => refuse_duty(request, problem),
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

fn refuse_duty(request: &Request, problem: DutyProblem) -> Failure {
    const DUE: &str = "a finite quantity above 0 is due";
    let duty = &request.duty;
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
