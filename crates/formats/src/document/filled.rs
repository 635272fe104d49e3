//! An allowed value of any type, which replaces a faulty value so that the reader finds the faults after it.

use serde::de::value::{MapDeserializer, SeqDeserializer, StrDeserializer};
use serde::de::{DeserializeSeed, EnumAccess, IntoDeserializer, VariantAccess, Visitor};
use serde::{Deserializer, forward_to_deserialize_any};

use super::fault::Fault;
use epicyclic_units::{Dimension, token_dimension};

/// Name for types that read a list or a map.
pub(crate) const LIST: &str = "list";

/// Deserializer of an allowed value: 1, a text, an empty list, the first name.
#[derive(Clone, Copy)]
pub(super) struct Filled;

impl IntoDeserializer<'_, Fault> for Filled {
    type Deserializer = Self;

    fn into_deserializer(self) -> Self {
        self
    }
}

fn fields<'de, V: Visitor<'de>>(fields: &'static [&'static str], visitor: V) -> Result<V::Value, Fault> {
    visitor.visit_map(MapDeserializer::new(fields.iter().map(|field| (*field, Filled))))
}

fn items<'de, V: Visitor<'de>>(count: usize, visitor: V) -> Result<V::Value, Fault> {
    visitor.visit_seq(SeqDeserializer::new(std::iter::repeat_n(Filled, count)))
}

impl<'de> Deserializer<'de> for Filled {
    type Error = Fault;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        visitor.visit_u64(1)
    }

    fn deserialize_bool<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        visitor.visit_bool(false)
    }

    fn deserialize_str<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        visitor.visit_str("a")
    }

    fn deserialize_string<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        visitor.visit_str("a")
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        visitor.visit_none()
    }

    fn deserialize_unit<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        visitor.visit_unit()
    }

    fn deserialize_newtype_struct<V: Visitor<'de>>(
        self,
        name: &'static str,
        visitor: V,
    ) -> Result<V::Value, Fault> {
        match token_dimension(name) {
            Some(Dimension::Dimensionless) => visitor.visit_newtype_struct(StrDeserializer::new("1")),
            Some(dimension) => {
                let text = format!("1 {}", dimension.usual_unit().symbol);
                visitor.visit_newtype_struct(StrDeserializer::new(&text))
            }
            None if name == LIST => {
                visitor.visit_newtype_struct(SeqDeserializer::new(std::iter::empty::<Self>()))
            }
            None => visitor.visit_newtype_struct(self),
        }
    }

    fn deserialize_seq<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        items(0, visitor)
    }

    fn deserialize_tuple<V: Visitor<'de>>(self, len: usize, visitor: V) -> Result<V::Value, Fault> {
        items(len, visitor)
    }

    fn deserialize_map<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        fields(&[], visitor)
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _name: &'static str,
        names: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Fault> {
        fields(names, visitor)
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _name: &'static str,
        variants: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Fault> {
        visitor.visit_enum(First(variants.first().copied().unwrap_or_default()))
    }

    fn deserialize_ignored_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        visitor.visit_unit()
    }

    forward_to_deserialize_any! {
        i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char bytes byte_buf unit_struct tuple_struct identifier
    }
}

/// The first name of an enum.
struct First(&'static str);

impl<'de> EnumAccess<'de> for First {
    type Error = Fault;
    type Variant = Filled;

    fn variant_seed<S: DeserializeSeed<'de>>(self, seed: S) -> Result<(S::Value, Filled), Fault> {
        Ok((seed.deserialize(StrDeserializer::<Fault>::new(self.0))?, Filled))
    }
}

impl<'de> VariantAccess<'de> for Filled {
    type Error = Fault;

    fn unit_variant(self) -> Result<(), Fault> {
        Ok(())
    }

    fn newtype_variant_seed<S: DeserializeSeed<'de>>(self, seed: S) -> Result<S::Value, Fault> {
        seed.deserialize(self)
    }

    fn tuple_variant<V: Visitor<'de>>(self, len: usize, visitor: V) -> Result<V::Value, Fault> {
        items(len, visitor)
    }

    fn struct_variant<V: Visitor<'de>>(
        self,
        names: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Fault> {
        fields(names, visitor)
    }
}
