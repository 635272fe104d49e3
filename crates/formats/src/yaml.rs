//! Values without places, and their YAML text. Only this module calls `serde_yaml`, which writes; documents
//! are read by [`document`](crate::document).

use serde::Serialize;
pub(crate) use serde_yaml::Number;
pub use serde_yaml::{Mapping, Value};

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
