//! The satellites that a motor's other numbers admit: `motor` without `--zs`.

use crate::desk::Call;
use crate::failure::Failure;
use crate::motor::options::Design;
use crate::motor::options::design::{form, numbers, refuse};
use crate::motor::satellites::answer::satellites_of;

const OF_ONE_MOTOR: &str = "this option is for one motor: give the teeth of a satellite, --zs, or leave it out to list all satellites";

/// Runs the command.
pub(crate) fn run(call: &Call<'_>, args: &Design) -> Result<(), Failure> {
    let files = &args.files;
    let of_one_motor = [
        ("--l", args.l.is_some()),
        ("--a", args.a.is_some()),
        ("--part", args.part.is_some()),
        ("--cosine", args.cosine),
        ("--construction", args.construction),
        ("--view", files.view.is_some()),
        ("--svg", files.svg.is_some()),
        ("--dxf", files.dxf.is_some()),
    ];
    crate::motor::options::refuse_given(
        of_one_motor.into_iter().chain(args.beyond_the_arcs()),
        OF_ONE_MOTOR,
    )?;
    let (numbers, module) = numbers(args)?;
    let answer = satellites_of(numbers, module, form(&args.teeth)).map_err(refuse)?;
    args.output.deliver(call, &answer)?;
    match answer.motors.is_empty() {
        true => Err(Failure::NothingFound("no satellite gives a motor of these numbers".to_owned())),
        false => Ok(()),
    }
}
