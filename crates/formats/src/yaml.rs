//! `serde_yaml`, behind this one door.
//!
//! It builds values and writes them; positions come from elsewhere, since it forgets them once it has parsed.

use serde::{Deserialize, Serialize};
pub use serde_yaml::{Mapping, Value};

/// What the YAML parser refused, and where, if it said so: 1-based, columns in characters.
#[derive(Debug)]
pub(crate) struct Refusal {
    pub(crate) line_column: Option<(usize, usize)>,
    pub(crate) message: String,
}

/// The value of every document of a stream.
pub(crate) fn parse_stream(text: &str) -> Result<Vec<Value>, Refusal> {
    serde_yaml::Deserializer::from_str(text)
        .map(|document| {
            Value::deserialize(document).map_err(|error| {
                let message = error.to_string();
                // The position is reported apart from the message.
                let message = message.split(" at line ").next().unwrap_or_default();
                let message = match message {
                    // The parser's only complaint about types: its values stop at 64 bits.
                    _ if message.ends_with("expected any YAML value") => {
                        "a whole number of more than 64 bits; write it with a decimal point".to_owned()
                    }
                    message => message.to_owned(),
                };
                let line_column = error.location().map(|location| (location.line(), location.column()));
                Refusal { line_column, message }
            })
        })
        .collect()
}

/// YAML text of a value.
///
/// # Errors
/// A value YAML cannot express, such as a map keyed by sequences within an enum.
pub fn to_string(value: &impl Serialize) -> Result<String, WriteError> {
    serde_yaml::to_string(value).map_err(|error| WriteError { message: error.to_string() })
}

/// A [`Value`] from anything serializable.
///
/// # Errors
/// As [`to_string`].
pub fn to_value(value: impl Serialize) -> Result<Value, WriteError> {
    serde_yaml::to_value(value).map_err(|error| WriteError { message: error.to_string() })
}

/// A value that YAML cannot express.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("cannot be written as YAML: {message}")]
pub struct WriteError {
    message: String,
}
