//! The satellites that a motor's other numbers admit: `motor` without `--zs`.

use crate::failure::Failure;
use crate::motor::options::design::{form, refuse};
use crate::motor::options::{Request, refuse_given};
use crate::motor::satellites::answer::{MotorSatellites, satellites_of};

const OF_ONE_MOTOR: &str = "this option is for one motor: give the teeth of a satellite, --zs, or leave it out to list all satellites";

impl Request {
    /// Lists the satellites that the other numbers admit, each with a motor. Options of files and whether
    /// each is given come from the caller, who writes them.
    ///
    /// # Errors
    /// [`Failure::Option`] for a number that is missing or cannot be, and for an option of one motor.
    pub(crate) fn satellites(
        &self,
        of_files: impl IntoIterator<Item = (&'static str, bool)>,
    ) -> Result<MotorSatellites, Failure> {
        let of_arcs = [
            ("--l", self.l.is_some()),
            ("--a", self.a.is_some()),
            ("--part", self.part.is_some()),
            ("--cosine", self.cosine),
            ("--construction", self.construction),
        ];
        refuse_given(of_arcs.into_iter().chain(of_files).chain(self.beyond_the_arcs()), OF_ONE_MOTOR)?;
        let (numbers, module) = self.numbers()?;
        satellites_of(numbers, module, form(&self.teeth)).map_err(refuse)
    }
}
