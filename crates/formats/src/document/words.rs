//! What was found and what is due, in the words of an engineer rather than of a program.

use serde::de::Unexpected;

use crate::yaml::Value;

/// The text of a scalar; nothing for maps and sequences.
pub(super) fn scalar(value: &Value) -> Option<String> {
    match value {
        Value::Null => Some("null".to_owned()),
        Value::Bool(value) => Some(value.to_string()),
        Value::Number(number) => Some(number.to_string()),
        Value::String(text) => Some(text.clone()),
        Value::Sequence(_) | Value::Mapping(_) | Value::Tagged(_) => None,
    }
}

pub(super) fn found_value(value: &Value) -> String {
    match value {
        Value::Null => "nothing".to_owned(),
        Value::Bool(value) => format!("the truth value {value}"),
        Value::Number(number) => format!("the number {number}"),
        Value::String(text) => found_text(text),
        Value::Sequence(_) => "a sequence".to_owned(),
        Value::Mapping(_) => "a map".to_owned(),
        Value::Tagged(tagged) => format!("the tag {}", tagged.tag),
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

/// How many entries a visitor expects: it says `an array of length 3`, `a tuple of size 3`,
/// `3 elements in sequence`.
pub(super) fn expected_count(expected: &str) -> String {
    let count = expected.split(' ').find(|word| word.parse::<usize>().is_ok());
    count.map_or_else(|| self::expected(expected), |count| format!("exactly {count}"))
}

/// What a visitor says it expects, in plain words.
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
