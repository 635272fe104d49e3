//! A fault of a value, as serde knows it, with its place.

use std::fmt;

use serde::de::{self, Expected, Unexpected};

use super::path::Segment;
use super::position::Position;
use super::renamed::renamed;
use super::tree::Node;
use super::words;
use crate::error::Problem;
use epicyclic_units::QuantityError;

/// A [`Problem`] with its place. The readers of the values around it complete the path.
#[derive(Debug)]
pub(super) struct Fault(pub(super) Box<Inner>);

#[derive(Debug)]
pub(super) struct Inner {
    pub(super) problem: Problem,
    pub(super) place: Option<FaultPlace>,
    /// Segments of the path, from the value to the root.
    pub(super) path: Vec<Segment>,
}

/// The node that has a fault.
#[derive(Debug)]
pub(super) struct FaultPlace {
    pub(super) at: Position,
    pub(super) node: *const Node,
    /// Whether the key of the node in its map is wrong, not the value.
    pub(super) is_key: bool,
    pub(super) is_scalar: bool,
}

impl From<Problem> for Fault {
    fn from(problem: Problem) -> Self {
        Self(Box::new(Inner { problem, place: None, path: vec![] }))
    }
}

impl From<QuantityError> for Fault {
    fn from(error: QuantityError) -> Self {
        Problem::Quantity(error).into()
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.problem.fmt(f)
    }
}

impl std::error::Error for Fault {}

impl de::Error for Fault {
    fn custom<T: fmt::Display>(message: T) -> Self {
        Problem::refused("invalid-value", message.to_string()).into()
    }

    fn invalid_type(found: Unexpected<'_>, expected: &dyn Expected) -> Self {
        wrong_type(words::found(&found), expected, None)
    }

    fn invalid_value(found: Unexpected<'_>, expected: &dyn Expected) -> Self {
        Problem::OutOfRange { found: words::found(&found), expected: words::expected(&expected.to_string()) }
            .into()
    }

    fn invalid_length(found: usize, expected: &dyn Expected) -> Self {
        Problem::WrongLength { found, expected: words::expected_count(&expected.to_string()) }.into()
    }

    fn unknown_variant(found: &str, allowed: &'static [&'static str]) -> Self {
        Problem::UnknownName { found: found.to_owned(), allowed: owned(allowed) }.into()
    }

    fn unknown_field(key: &str, allowed: &'static [&'static str]) -> Self {
        let key = key.to_owned();
        match renamed(&key, allowed) {
            Some(new) => Problem::RenamedKey { key, new: new.to_owned() }.into(),
            None => Problem::UnknownKey { key, allowed: owned(allowed) }.into(),
        }
    }

    fn missing_field(key: &'static str) -> Self {
        Problem::MissingKey { key: key.to_owned() }.into()
    }
}

fn owned(names: &[&str]) -> Vec<String> {
    names.iter().map(|name| (*name).to_owned()).collect()
}

pub(super) fn wrong_type(found: String, expected: &dyn Expected, correction: Option<String>) -> Fault {
    let expected = words::expected(&expected.to_string());
    let correction = correction.or_else(|| match (found.as_str(), expected.as_str()) {
        ("nothing", "a sequence") => Some("[] for an empty one".to_owned()),
        ("nothing", "a map") => Some("{} for an empty one".to_owned()),
        (found, "a sequence") => {
            found.strip_prefix("the number ").map(|number| format!("[{number}] for one entry"))
        }
        _ => None,
    });
    Problem::WrongType { found, expected, correction }.into()
}
