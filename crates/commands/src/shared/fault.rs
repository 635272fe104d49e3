//! Refusals with names, for their places in files.

use crate::error::Error;
use epicyclic_formats::{Document, Path, Problem};
use epicyclic_units::find_unit;
use epicyclic_units::format::{in_unit, sensible_unit, trimmed};
use std::fmt::Display;

/// A refusal with a name that does not change with its message.
pub(crate) trait Fault: Display {
    /// Name of the error: `not-positive`.
    fn name(&self) -> &'static str;

    /// The error as a problem of a file.
    fn problem(&self) -> Problem {
        Problem::refused(self.name(), self.to_string())
    }
}

macro_rules! faults {
    ($($error:ty),*) => { $(
        impl Fault for $error {
            fn name(&self) -> &'static str {
                <$error>::name(self)
            }
        }
    )* };
}

faults!(
    Error,
    epicyclic_formats::gearbox::DescriptionError,
    epicyclic_dynamics::Error,
    epicyclic_gears::Error,
    epicyclic_hydromotor::Error,
    epicyclic_motion::Error,
    epicyclic_schemes::Error,
    epicyclic_selection::Error,
    epicyclic_strength::Error,
    epicyclic_synthesis::Error,
    epicyclic_train::Error
);

impl Fault for epicyclic_vibration::Error {
    fn name(&self) -> &'static str {
        Self::name(self)
    }

    fn problem(&self) -> Problem {
        Problem::refused(self.name(), in_usual_units(self))
    }
}

/// Significant digits of values in messages.
const DIGITS: usize = 6;

/// Message of an error of the vibration with values in the units in which files have them, since that crate
/// knows SI units alone.
pub(crate) fn in_usual_units(error: &epicyclic_vibration::Error) -> String {
    use epicyclic_vibration::Error as E;
    let of = |value: f64, unit: &str| match find_unit(unit) {
        Some(unit) => {
            let si = unit.converted(value);
            in_unit(si, sensible_unit(unit.dimension, si), DIGITS)
        }
        None => format!("{} {unit}", trimmed(value, DIGITS)),
    };
    match error {
        E::NotPositive { field, value, unit } => {
            format!("{field} is {}; it must be finite and above 0", of(*value, unit))
        }
        E::Negative { field, value, unit } => {
            format!("{field} is {}; it must be finite and not below 0", of(*value, unit))
        }
        E::OutOfRange { field, value, low, high, unit } => {
            let [value, low, high] = [*value, *low, *high].map(|value| of(value, unit));
            format!("{field} is {value}; it must lie between {low} and {high}")
        }
        E::AboveCritical { speed_rad_s, remaining } => format!(
            "at a frame speed of {} the centripetal terms exceed the stiffness (what remains is {} of it); the speed must be below the first critical one",
            of(*speed_rad_s, "rad/s"),
            trimmed(*remaining, 3)
        ),
        error => error.to_string(),
    }
}

/// A name and a message, of a refusal that is no error of a calculation.
#[derive(Debug, Clone)]
pub(crate) struct Named<M>(pub(crate) &'static str, pub(crate) M);

impl<M: Display> Display for Named<M> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.1.fmt(f)
    }
}

impl<M: Display> Fault for Named<M> {
    fn name(&self) -> &'static str {
        self.0
    }
}

/// Error at the longest part of a path that exists in the file.
pub(crate) fn refused(document: &Document, path: &Path, keys: &[&str], why: &dyn Fault) -> Error {
    let deeper = |path: Path, key: &&str| {
        let inner = path.clone().key(*key);
        if document.value_at(&inner).is_some() { inner } else { path }
    };
    let place = keys.iter().fold(path.clone(), deeper);
    document.error(&place, why.problem()).into()
}
