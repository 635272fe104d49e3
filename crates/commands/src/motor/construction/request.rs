//! The construction of a motor's arcs in place of the motor: `--construction`, and `--l` with `--a`.

use crate::failure::Failure;
use crate::motor::answer::Designed;
use crate::motor::construction::answer::Constructed;
use crate::motor::options::design::refuse;
use crate::motor::options::{Request, refuse_given};

const NOT_OF_ARCS: &str =
    "the construction (1)-(8) is of the arcs alone and does not take this option; leave it out";
const OF_THE_MOTOR: &str = "with both --l and --a the answer is the construction of the arcs, which does not take this option; leave it \
     out, or one of --l and --a for a motor that closes";

impl Request {
    /// Whether the construction is asked for: arcs with both distances need not close, and of an open rotor
    /// there is no motor.
    pub(crate) fn is_of_construction(&self) -> bool {
        self.construction || (self.l.is_some() && self.a.is_some())
    }

    /// Constructs the arcs of the motor of a file, or of the options. Options of files and whether each is
    /// given come from the caller, who writes them.
    ///
    /// # Errors
    /// [`Failure::Option`] for a number that is missing or cannot be, and for an option of a closed motor.
    pub(crate) fn constructed(
        &self,
        of_file: Option<&Designed>,
        of_files: impl IntoIterator<Item = (&'static str, bool)>,
    ) -> Result<Constructed, Failure> {
        let in_vain = self.beyond_the_arcs().chain(of_files).chain(self.teeth.given());
        refuse_given(in_vain, if self.construction { NOT_OF_ARCS } else { OF_THE_MOTOR })?;
        let constructed = match of_file {
            Some(designed) => Constructed::of_motor(designed),
            None => {
                let (numbers, module) = self.numbers()?;
                match (self.l, self.a) {
                    (Some(l), Some(a)) => Constructed::of_distances(numbers, module, l.0, a.0),
                    _ => Constructed::of_place(numbers, module, self.place()),
                }
            }
        };
        constructed.map_err(refuse)
    }
}
