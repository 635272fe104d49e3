//! Refusals with names, for their places in files.

use crate::error::Error;
use epicyclic_formats::{Document, Path, Problem};
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
    epicyclic_train::Error,
    epicyclic_vibration::Error
);

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
