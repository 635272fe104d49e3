//! Faults of what a record describes, each with its path in the record.

use crate::document::{Document, Path};
use crate::error::{Error, Fault, Problem};
use std::fmt;

/// Faults of a record, in the order in which they were found. Displays their messages, each on a line.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Faults(Vec<(At, Problem)>);

/// Path in a record.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct At {
    path: Path,
    /// Keys below the path, those of maps within each other joined by dots: the first that the file has is
    /// meant.
    keys: Keys,
    /// Whether the path stays as it is where the file does not have it: it is the key that would help.
    is_missing: bool,
}

pub(crate) type Keys = &'static [&'static str];

impl From<Path> for At {
    fn from(path: Path) -> Self {
        Self { path, keys: &[], is_missing: false }
    }
}

impl From<Keys> for At {
    fn from(keys: Keys) -> Self {
        Path::root().first_of(keys)
    }
}

impl From<&'static str> for At {
    fn from(key: &'static str) -> Self {
        Path::dotted(key).into()
    }
}

impl Path {
    /// The first of these keys that the file has below this path; this path if it has none.
    pub(crate) fn first_of(self, keys: Keys) -> At {
        At { path: self, keys, is_missing: false }
    }
}

impl At {
    /// The path, continued from the end of another one.
    pub(crate) fn below(self, base: &Path) -> Self {
        Self { path: base.join(&self.path), ..self }
    }

    /// The longest part of the path that the document has; the whole path of a key that would help.
    fn in_document(&self, document: &Document) -> Path {
        if self.is_missing {
            return self.path.clone();
        }
        let keys = self.keys.iter().map(|keys| self.path.join(&Path::dotted(keys)));
        let mut path = keys.into_iter().find(|path| document.has(path)).unwrap_or_else(|| self.path.clone());
        while !document.has(&path) {
            path.pop();
        }
        path
    }
}

impl Faults {
    pub(crate) fn push(&mut self, at: impl Into<At>, problem: impl Into<Problem>) {
        self.0.push((at.into(), problem.into()));
    }

    /// Adds a fault that a calculation finds, at the key that it is about. The file need not have the key: it
    /// is also the one that would help.
    pub fn add(&mut self, key: Path, problem: impl Into<Problem>) {
        self.0.push((At { path: key, keys: &[], is_missing: true }, problem.into()));
    }

    /// The value, or `None` and its fault.
    pub(crate) fn keep<T, E: Into<Problem>>(&mut self, at: impl Into<At>, value: Result<T, E>) -> Option<T> {
        value.map_err(|problem| self.push(at, problem)).ok()
    }

    /// Finds the faults of the part of the record at this path.
    pub(crate) fn below<T>(&mut self, base: &Path, part: impl FnOnce(&mut Self) -> T) -> T {
        let before = self.0.len();
        let value = part(self);
        for (at, _) in &mut self.0[before..] {
            at.path = base.join(&at.path);
        }
        value
    }

    /// Faults of this record and of another part of the same one.
    #[must_use]
    pub fn and(mut self, others: Option<Self>) -> Self {
        self.0.extend(others.into_iter().flat_map(|others| others.0));
        self
    }

    /// The value of a part, and whether the part is without faults.
    pub(crate) fn sound<T>(&mut self, part: impl FnOnce(&mut Self) -> T) -> (T, bool) {
        let before = self.0.len();
        let value = part(self);
        (value, self.0.len() == before)
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The value, unless there are faults.
    pub(crate) fn or<T>(self, value: T) -> Result<T, Self> {
        if self.is_empty() { Ok(value) } else { Err(self) }
    }

    /// Name of the first fault, which does not change with the message: `unknown`.
    #[must_use]
    pub fn name(&self) -> &'static str {
        self.0.first().map_or("", |(_, problem)| problem.name())
    }

    /// The faults at their places in the document, in the order of these; `base` is the path of the record,
    /// the root of a file with one.
    #[must_use]
    pub fn placed(&self, document: &Document, base: &Path) -> Error {
        let placed = |(at, problem): &(At, Problem)| {
            document.fault(at.clone().below(base).in_document(document), problem.clone())
        };
        let mut faults: Vec<Fault> = vec![];
        for fault in self.0.iter().map(placed) {
            // Two calculations may refuse the same value.
            if !faults.contains(&fault) {
                faults.push(fault);
            }
        }
        faults.sort_by_key(|fault| fault.at.position);
        Error::all(faults)
    }
}

impl fmt::Display for Faults {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let messages: Vec<String> = self.0.iter().map(|(_, problem)| problem.to_string()).collect();
        f.write_str(&messages.join("\n"))
    }
}

impl std::error::Error for Faults {}

impl From<epicyclic_gears::Error> for Problem {
    fn from(error: epicyclic_gears::Error) -> Self {
        Self::refused(error.name(), error.to_string())
    }
}

impl From<epicyclic_dynamics::Error> for Problem {
    fn from(error: epicyclic_dynamics::Error) -> Self {
        Self::refused(error.name(), error.to_string())
    }
}

impl From<epicyclic_hydromotor::Error> for Problem {
    fn from(error: epicyclic_hydromotor::Error) -> Self {
        Self::refused(error.name(), error.to_string())
    }
}

impl From<epicyclic_train::Error> for Problem {
    fn from(error: epicyclic_train::Error) -> Self {
        use epicyclic_train::{CompoundFault::UnknownGear, Error as E};
        let (name, message) = (error.name(), error.to_string());
        let remedy = match error {
            E::Unknown { suggestion, .. } | E::Compound { fault: UnknownGear { suggestion, .. }, .. } => {
                suggestion
            }
            _ => None,
        };
        Self::Refused { name, message, remedy }
    }
}
