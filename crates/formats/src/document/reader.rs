//! A value read as a Rust type, with faults that keep their parts.
//!
//! `serde_yaml` reports a fault as a text. This deserializer walks its [`Value`] instead, and its error is a
//! [`Problem`]: an unknown key comes with the keys allowed, a number with a decimal comma is recognised where a number
//! is due, and a [`Quantity`](epicyclic_units::Quantity) is parsed here, so that its error keeps its name.
//! It is stricter, too: nothing is not an empty sequence, and a number is not text.

use std::fmt;

use serde::{
    Deserializer,
    de::{
        self, Expected, IntoDeserializer, Unexpected, Visitor,
        value::{
            BorrowedStrDeserializer, MapAccessDeserializer, MapDeserializer, SeqDeserializer, StrDeserializer,
        },
    },
    forward_to_deserialize_any,
};

use super::renamed::renamed;
use super::words;
use crate::{error::Problem, yaml::Value};
use epicyclic_units::{self as quantity, Dimension, QuantityError};

/// A [`Problem`] on its way through `serde`.
#[derive(Debug)]
pub(super) struct Fault(pub(super) Box<Problem>);

impl From<Problem> for Fault {
    fn from(problem: Problem) -> Self {
        Self(Box::new(problem))
    }
}

impl From<QuantityError> for Fault {
    fn from(error: QuantityError) -> Self {
        Problem::Quantity(error).into()
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
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

fn wrong_type(found: String, expected: &dyn Expected, correction: Option<String>) -> Fault {
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

/// A node to read.
#[derive(Clone, Copy)]
pub(super) struct Reader<'de>(pub(super) &'de Value);

impl<'de> Reader<'de> {
    fn mismatch(self, expected: &dyn Expected) -> Fault {
        match self.0 {
            Value::Tagged(tagged) => Problem::Tag { tag: tagged.tag.to_string() }.into(),
            value => wrong_type(words::found_value(value), expected, None),
        }
    }

    fn number<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        match self.0 {
            Value::Number(_) => self.deserialize_any(visitor),
            Value::String(text) => match quantity::parse_number(text) {
                // It was put in quotes, or has leading zeros.
                Ok(value) => Err(wrong_type(words::found_value(self.0), &visitor, Some(value.to_string()))),
                Err(QuantityError::Empty { .. } | QuantityError::NotANumber { .. }) => {
                    Err(self.mismatch(&visitor))
                }
                Err(error) => Err(error.into()),
            },
            _ => Err(self.mismatch(&visitor)),
        }
    }

    fn quantity<V: Visitor<'de>>(self, dimension: Dimension, visitor: V) -> Result<V::Value, Fault> {
        let text = match self.0 {
            Value::String(text) => text.clone(),
            Value::Number(number) => number.to_string(),
            _ => return Err(self.mismatch(&visitor)),
        };
        quantity::parse_as(&text, dimension)?;
        visitor.visit_newtype_struct(StrDeserializer::<Fault>::new(&text))
    }

    fn sequence<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        let Value::Sequence(items) = self.0 else { return Err(self.mismatch(&visitor)) };
        let mut items = SeqDeserializer::new(items.iter().map(Reader));
        let read = visitor.visit_seq(&mut items)?;
        items.end()?;
        Ok(read)
    }

    fn map<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        let Value::Mapping(map) = self.0 else { return Err(self.mismatch(&visitor)) };
        let mut entries =
            MapDeserializer::new(map.iter().map(|(key, value)| (KeyReader(key), Reader(value))));
        let read = visitor.visit_map(&mut entries)?;
        entries.end()?;
        Ok(read)
    }
}

impl<'de> IntoDeserializer<'de, Fault> for Reader<'de> {
    type Deserializer = Self;

    fn into_deserializer(self) -> Self {
        self
    }
}

macro_rules! forward {
    ($($method:ident)* => $reader:ident($to:ident)) => {$(
        fn $method<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
            $reader(self.0).$to(visitor)
        }
    )*};
}

impl<'de> Deserializer<'de> for Reader<'de> {
    type Error = Fault;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        match self.0 {
            Value::Null => visitor.visit_unit(),
            Value::Bool(value) => visitor.visit_bool(*value),
            Value::Number(number) => {
                if let Some(value) = number.as_u64() {
                    visitor.visit_u64(value)
                } else if let Some(value) = number.as_i64() {
                    visitor.visit_i64(value)
                } else {
                    match number.as_f64() {
                        Some(value) if value.is_finite() => visitor.visit_f64(value),
                        _ => Err(QuantityError::NotFinite { text: number.to_string() }.into()),
                    }
                }
            }
            Value::String(text) => visitor.visit_borrowed_str(text),
            Value::Sequence(_) => self.sequence(visitor),
            Value::Mapping(_) => self.map(visitor),
            Value::Tagged(_) => Err(self.mismatch(&visitor)),
        }
    }

    forward! {
        deserialize_i8 deserialize_i16 deserialize_i32 deserialize_i64 deserialize_i128
        deserialize_u8 deserialize_u16 deserialize_u32 deserialize_u64 deserialize_u128
        deserialize_f32 deserialize_f64 => Reader(number)
    }

    fn deserialize_str<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        match self.0 {
            Value::String(text) => visitor.visit_borrowed_str(text),
            Value::Number(_) | Value::Bool(_) => {
                let quoted = words::scalar(self.0).map(|text| format!("{text:?}, in quotes"));
                Err(wrong_type(words::found_value(self.0), &visitor, quoted))
            }
            _ => Err(self.mismatch(&visitor)),
        }
    }

    forward! { deserialize_string deserialize_char => Reader(deserialize_str) }
    forward! { deserialize_seq => Reader(sequence) }
    forward! { deserialize_map => Reader(map) }

    fn deserialize_tuple<V: Visitor<'de>>(self, _len: usize, visitor: V) -> Result<V::Value, Fault> {
        self.sequence(visitor)
    }

    fn deserialize_tuple_struct<V: Visitor<'de>>(
        self,
        _name: &'static str,
        _len: usize,
        visitor: V,
    ) -> Result<V::Value, Fault> {
        self.sequence(visitor)
    }

    // A derived type would take a sequence for its fields in order: not what anyone means to write.
    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _name: &'static str,
        _fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Fault> {
        self.map(visitor)
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        match self.0 {
            Value::Null => visitor.visit_none(),
            _ => visitor.visit_some(self),
        }
    }

    fn deserialize_newtype_struct<V: Visitor<'de>>(
        self,
        name: &'static str,
        visitor: V,
    ) -> Result<V::Value, Fault> {
        match quantity::token_dimension(name) {
            Some(dimension) => self.quantity(dimension, visitor),
            None => visitor.visit_newtype_struct(self),
        }
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _name: &'static str,
        _variants: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Fault> {
        match self.0 {
            Value::String(name) => visitor.visit_enum(BorrowedStrDeserializer::new(name)),
            // A name such as `1`, for which YAML reads a number: a name all the same.
            Value::Number(_) | Value::Bool(_) => {
                let name = words::scalar(self.0).unwrap_or_default();
                visitor.visit_enum(StrDeserializer::<Fault>::new(&name))
            }
            Value::Mapping(map) if map.len() == 1 => {
                let entries = map.iter().map(|(key, value)| (KeyReader(key), Reader(value)));
                visitor.visit_enum(MapAccessDeserializer::new(MapDeserializer::new(entries)))
            }
            _ => Err(self.mismatch(&"a name, or a map with one name as its key")),
        }
    }

    fn deserialize_ignored_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        visitor.visit_unit()
    }

    forward_to_deserialize_any! {
        bool bytes byte_buf unit unit_struct identifier
    }
}

/// The key of a map: always text, whatever YAML took it for.
#[derive(Clone, Copy)]
struct KeyReader<'de>(&'de Value);

impl<'de> IntoDeserializer<'de, Fault> for KeyReader<'de> {
    type Deserializer = Self;

    fn into_deserializer(self) -> Self {
        self
    }
}

impl KeyReader<'_> {
    fn text(self) -> Result<String, Fault> {
        words::scalar(self.0).ok_or_else(|| Problem::ComplexKey.into())
    }
}

impl<'de> Deserializer<'de> for KeyReader<'de> {
    type Error = Fault;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        match self.0 {
            Value::String(text) => visitor.visit_borrowed_str(text),
            _ => visitor.visit_string(self.text()?),
        }
    }

    // A map from numbers: `7: sun`.
    forward! {
        deserialize_i8 deserialize_i16 deserialize_i32 deserialize_i64 deserialize_i128
        deserialize_u8 deserialize_u16 deserialize_u32 deserialize_u64 deserialize_u128
        deserialize_f32 deserialize_f64 => Reader(number)
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        visitor.visit_some(self)
    }

    fn deserialize_newtype_struct<V: Visitor<'de>>(
        self,
        name: &'static str,
        visitor: V,
    ) -> Result<V::Value, Fault> {
        match quantity::token_dimension(name) {
            Some(dimension) => Reader(self.0).quantity(dimension, visitor),
            None => visitor.visit_newtype_struct(self),
        }
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _name: &'static str,
        _variants: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Fault> {
        visitor.visit_enum(StrDeserializer::<Fault>::new(&self.text()?))
    }

    fn deserialize_ignored_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        visitor.visit_unit()
    }

    forward_to_deserialize_any! {
        bool char str string bytes byte_buf unit unit_struct seq tuple tuple_struct map struct identifier
    }
}
