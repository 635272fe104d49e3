//! A question that is refused or has no answer, as an answer of its own: what `--format json` writes in place
//! of the one asked for.

use crate::answer::Answer;
use crate::error::Error;
use epicyclic_formats::Fault;
use schemars::JsonSchema;
use serde::Serialize;

/// Why there is no answer.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Refused {
    /// Kind of the error: a name that does not change with the message.
    pub name: &'static str,
    /// Error and allowed values, for people.
    pub message: String,
    /// The exit code of the program.
    pub exit_code: u8,
    /// The option that it is about; `null` where it is about none.
    pub option: Option<String>,
    /// Where in a file it is; `null` where it is not in a file.
    pub place: Option<Place>,
    /// Faults: all of a file, otherwise the one of this refusal.
    pub faults: Vec<RefusedFault>,
}

/// One of the faults of a refusal.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct RefusedFault {
    /// Kind of the fault: a name that does not change with the message.
    pub name: &'static str,
    /// Fault and allowed values, for people.
    pub message: String,
    /// Text of the wrong value or key as written in the file or call; `null` for lists, maps and missing
    /// keys.
    pub value: Option<String>,
    /// Text to write in its place; `null` where none is known.
    pub remedy: Option<String>,
    /// Where in a file it is; `null` where it is not in a file.
    pub place: Option<Place>,
}

/// A place in a file.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Place {
    /// The file as it was named, or `standard input`.
    pub file: String,
    /// Line in the file, from 1.
    pub line: usize,
    /// The column in characters, from 1.
    pub column: usize,
    /// The keys and places of lists that lead there: `sets[0].k`; empty for the whole document.
    pub path: String,
}

impl Refused {
    /// A refusal with one fault, which is in no file.
    #[must_use]
    pub fn new(name: &'static str, message: String, exit_code: u8) -> Self {
        let fault = RefusedFault { name, message: message.clone(), value: None, remedy: None, place: None };
        Self { name, message, exit_code, option: None, place: None, faults: vec![fault] }
    }

    /// A refusal of a command.
    #[must_use]
    pub fn of_answer(error: &Error, exit_code: u8) -> Self {
        let refused = Self::new(error.name(), error.to_string(), exit_code);
        match error {
            Error::Document(error) => refused.in_file(error),
            Error::Placed { at, .. } | Error::MissingKeys { at, .. } => refused.in_file(at),
            _ => refused,
        }
    }

    /// The refusal with the places and faults of this error of a file.
    #[must_use]
    pub fn in_file(self, error: &epicyclic_formats::Error) -> Self {
        let faults: Vec<RefusedFault> = error.faults().map(RefusedFault::of).collect();
        Self { place: Some(Place::of(error.at())), faults, ..self }
    }

    /// The refusal of this option.
    #[must_use]
    pub fn of_option(self, option: impl Into<Option<String>>) -> Self {
        Self { option: option.into(), ..self }
    }
}

impl RefusedFault {
    fn of(fault: &Fault) -> Self {
        let Fault { at, problem, value } = fault;
        Self {
            name: problem.name(),
            message: problem.to_string(),
            value: value.clone(),
            remedy: problem.remedy().map(str::to_owned),
            place: Some(Place::of(at)),
        }
    }
}

impl Place {
    fn of(at: &epicyclic_formats::Place) -> Self {
        Self {
            file: at.file.to_string(),
            line: at.position.line,
            column: at.position.column,
            path: if at.path.is_root() { String::new() } else { at.path.to_string() },
        }
    }
}

impl Answer for Refused {
    const NAME: &'static str = "error";
}
