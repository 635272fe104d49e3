//! Found and expected values in the words of an engineer.

use serde::de::Unexpected;

use super::tree::{Content, Node, Scalar};
use crate::yaml::Number;

/// A number in the form of YAML.
pub(super) fn number(value: f64) -> String {
    Number::from(value).to_string()
}

/// The value of a scalar as text.
pub(super) fn scalar(scalar: Scalar, text: &str) -> String {
    match scalar {
        Scalar::Null => "null".to_owned(),
        Scalar::Bool(value) => value.to_string(),
        Scalar::Whole(value) => value.to_string(),
        Scalar::Negative(value) => value.to_string(),
        Scalar::Number(value) => number(value),
        Scalar::Text => text.to_owned(),
    }
}

pub(super) fn found_scalar(scalar: Scalar, text: &str) -> String {
    match scalar {
        Scalar::Null => "nothing".to_owned(),
        Scalar::Bool(value) => format!("the truth value {value}"),
        Scalar::Text => found_text(text),
        _ => format!("the number {}", self::scalar(scalar, text)),
    }
}

pub(super) fn found_node(node: &Node) -> String {
    match &node.content {
        Content::Scalar(scalar, text) => found_scalar(*scalar, text),
        Content::Sequence(_) => "a sequence".to_owned(),
        Content::Map(_) => "a map".to_owned(),
    }
}

pub(super) fn found(found: &Unexpected<'_>) -> String {
    match found {
        Unexpected::Bool(value) => format!("the truth value {value}"),
        Unexpected::Unsigned(value) => format!("the number {value}"),
        Unexpected::Signed(value) => format!("the number {value}"),
        Unexpected::Float(value) => format!("the number {value:?}"),
        Unexpected::Char(value) => found_text(&value.to_string()),
        Unexpected::Str(text) => found_text(text),
        Unexpected::Unit | Unexpected::Option => "nothing".to_owned(),
        Unexpected::Seq => "a sequence".to_owned(),
        Unexpected::Map => "a map".to_owned(),
        other => other.to_string(),
    }
}

fn found_text(text: &str) -> String {
    const SHOWN: usize = 40;
    if text.chars().count() > SHOWN {
        let start: String = text.chars().take(SHOWN).collect();
        format!("the text {:?}", start + "…")
    } else {
        format!("the text {text:?}")
    }
}

/// Number of entries that a visitor expects. A visitor says `an array of length 3`, `a tuple of size 3`,
/// `3 elements in sequence`.
pub(super) fn expected_count(expected: &str) -> String {
    let count = expected.split(' ').find(|word| word.parse::<usize>().is_ok());
    count.map_or_else(|| self::expected(expected), |count| format!("exactly {count}"))
}

/// Expectation of a visitor in plain words.
pub(super) fn expected(expected: &str) -> String {
    let whole = |least: &str, most: &str| format!("a whole number from {least} to {most}");
    match expected {
        "f64" | "f32" => "a number".to_owned(),
        "u8" => whole("0", "255"),
        "u16" => whole("0", "65535"),
        "u32" => whole("0", "4294967295"),
        "u64" | "u128" | "usize" => "a whole number from 0".to_owned(),
        "i8" => whole("-128", "127"),
        "i16" => whole("-32768", "32767"),
        "i32" => whole("-2147483648", "2147483647"),
        "i64" | "i128" | "isize" => "a whole number".to_owned(),
        "a string" | "a character" | "string" => "text".to_owned(),
        "a boolean" => "true or false".to_owned(),
        "unit" => "nothing".to_owned(),
        _ if expected.starts_with("struct ") || expected == "a map" => "a map".to_owned(),
        _ => {
            let name = expected.trim_start_matches("tuple struct ").trim_start_matches("enum ");
            if name.len() == expected.len() { expected.to_owned() } else { format!("a value of {name}") }
        }
    }
}
