//! The construction of a motor's arcs in place of the motor: `--construction`, and `--l` with `--a`.

use crate::desk::Call;
use crate::failure::Failure;
use crate::motor::answer::Designed;
use crate::motor::construction::answer::Constructed;
use crate::motor::construction::answer::construction;
use crate::motor::options::Design;
use crate::motor::options::design::{numbers, place, refuse};
use crate::motor::options::files::Wanted;
use crate::motor::table as motor;
use crate::motor::table::View;

const NOT_OF_ARCS: &str =
    "the construction (1)-(8) is of the arcs alone and does not take this option; leave it out";
const OF_THE_MOTOR: &str = "with both --l and --a the answer is the construction of the arcs, which does not take this option; leave it \
     out, or one of --l and --a for a motor that closes";

/// Whether it is asked for: arcs with both distances need not close, and of an open rotor there is no motor.
pub(crate) fn is_asked(args: &Design) -> bool {
    args.construction || (args.l.is_some() && args.a.is_some())
}

/// Runs the command; the motor is that of the file, or of the options.
pub(crate) fn run(
    call: &Call<'_>,
    args: &Design,
    wanted: &Wanted,
    of_file: Option<&Designed>,
) -> Result<(), Failure> {
    let in_vain = args.beyond_the_arcs().into_iter().chain(args.teeth.given());
    crate::motor::options::refuse_given(in_vain, if args.construction { NOT_OF_ARCS } else { OF_THE_MOTOR })?;
    if args.files.view.is_some_and(|view| view != View::Construction) {
        let message = "the construction has the view construction alone; for another give one of --l and --a, and no \
                       --construction";
        return Err(Failure::invalid("--view", message));
    }
    let constructed = match of_file {
        Some(designed) => Constructed::of_motor(designed),
        None => {
            let (numbers, module) = numbers(args)?;
            match (args.l, args.a) {
                (Some(l), Some(a)) => Constructed::of_distances(numbers, module, l.0, a.0),
                _ => Constructed::of_place(numbers, module, place(args)),
            }
        }
    };
    let constructed = constructed.map_err(refuse)?;
    let answer = construction(&constructed).map_err(refuse)?;
    let files = if wanted.is_empty() {
        vec![]
    } else {
        wanted.drawn(&motor::construction(&constructed)?, &args.files)?
    };
    args.output.but_for_drawings().deliver_with(call, files, &answer)
}
