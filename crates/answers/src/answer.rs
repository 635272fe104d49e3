//! What all answers have in common: a name, a version, JSON and its schema.

use crate::{Error, finite};
use schemars::{JsonSchema, Schema, schema_for};
use serde::Serialize;

/// Version of the records: raised when a key goes, or changes its meaning or unit.
pub const SCHEMA_VERSION: u32 = 1;

/// An answer of the program.
pub trait Answer: Serialize + JsonSchema {
    /// Which answer it is, as JSON says it under `answer`.
    const NAME: &'static str;
}

/// Something that the reader of an answer should know.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Warning {
    /// Its kind: a name that stays the same whatever the message says.
    pub name: &'static str,
    /// What is the matter, for people.
    pub message: String,
}

/// An answer with its version and name.
#[derive(Serialize, JsonSchema)]
struct Whole<'a, A> {
    /// Version of the records; raised when a key goes, or changes its meaning or unit.
    schema_version: u32,
    /// Which answer it is.
    answer: &'static str,
    #[serde(flatten)]
    content: &'a A,
}

/// The JSON of an answer, with a final line break.
///
/// # Errors
/// [`Error::NotFinite`] with the key of a number that no double holds.
pub fn to_json<A: Answer>(answer: &A) -> Result<String, Error> {
    finite::check(answer)?;
    let whole = Whole { schema_version: SCHEMA_VERSION, answer: A::NAME, content: answer };
    let text = serde_json::to_string_pretty(&whole).map_err(|error| Error::Json(error.to_string()))?;
    Ok(text + "\n")
}

/// The JSON Schema of an answer.
#[must_use]
pub fn schema<A: Answer>() -> Schema {
    schema_for!(Whole<'_, A>)
}
