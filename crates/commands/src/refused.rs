//! A question that is refused or has no answer, as an answer of its own: what `--format json` writes in place
//! of the one asked for.

use crate::answer::Answer;
use crate::error::Error;
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

impl Place {
    /// Where a fault of a document is.
    #[must_use]
    pub fn of(error: &epicyclic_formats::Error) -> Self {
        let at = error.at();
        Self {
            file: at.file.to_string(),
            line: at.position.line,
            column: at.position.column,
            path: if at.path.is_root() { String::new() } else { at.path.to_string() },
        }
    }

    /// Where an error that has a place is.
    #[must_use]
    pub fn of_answer(error: &Error) -> Option<Self> {
        match error {
            Error::Document(error) => Some(Self::of(error)),
            Error::Placed { at, .. } => Some(Self::of(at)),
            _ => None,
        }
    }
}

impl Answer for Refused {
    const NAME: &'static str = "error";
}
