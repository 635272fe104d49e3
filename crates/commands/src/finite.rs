//! Rejects answers with infinite numbers or NaN: JSON cannot express them, and `null` means that a value is
//! missing.

use crate::error::Error;
use serde::ser::{self, Impossible, Serialize};
use std::fmt;

/// Walks through all numbers of a record.
///
/// # Errors
/// [`Error::NotFinite`] with the key of the first that is infinite or not a number: `gears[2].torque_n_m`.
pub fn check(record: &impl Serialize) -> Result<(), Error> {
    record.serialize(&mut Walk { path: String::new() }).map_err(|found| Error::NotFinite { figure: found.0 })
}

/// Where the walk is.
struct Walk {
    path: String,
}

/// Key of a number that is infinite or NaN.
#[derive(Debug)]
struct Found(String);

impl fmt::Display for Found {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for Found {}

impl ser::Error for Found {
    fn custom<T: fmt::Display>(message: T) -> Self {
        Self(message.to_string())
    }
}

impl Walk {
    /// A value one step down: `before` and `step` together are the step.
    fn down<T: Serialize + ?Sized>(&mut self, before: &str, step: &str, value: &T) -> Result<(), Found> {
        let length = self.path.len();
        self.path += before;
        self.path += step;
        value.serialize(&mut *self)?;
        self.path.truncate(length);
        Ok(())
    }

    fn key<T: Serialize + ?Sized>(&mut self, key: &str, value: &T) -> Result<(), Found> {
        let dot = if self.path.is_empty() { "" } else { "." };
        self.down(dot, key, value)
    }
}

/// The entries of a list, numbered from 0, or the values of a map.
struct Entries<'a> {
    walk: &'a mut Walk,
    count: usize,
    key: String,
}

impl Entries<'_> {
    fn entry<T: Serialize + ?Sized>(&mut self, value: &T) -> Result<(), Found> {
        self.count += 1;
        self.walk.down("", &format!("[{}]", self.count - 1), value)
    }
}

macro_rules! nothing_to_check {
    ($($method:ident: $type:ty),*) => { $(
        fn $method(self, _: $type) -> Result<(), Found> {
            Ok(())
        }
    )* };
}

impl<'a> ser::Serializer for &'a mut Walk {
    type Ok = ();
    type Error = Found;
    type SerializeSeq = Entries<'a>;
    type SerializeTuple = Entries<'a>;
    type SerializeTupleStruct = Entries<'a>;
    type SerializeTupleVariant = Impossible<(), Found>;
    type SerializeMap = Entries<'a>;
    type SerializeStruct = &'a mut Walk;
    type SerializeStructVariant = &'a mut Walk;

    nothing_to_check!(
        serialize_bool: bool, serialize_i8: i8, serialize_i16: i16, serialize_i32: i32, serialize_i64: i64,
        serialize_u8: u8, serialize_u16: u16, serialize_u32: u32, serialize_u64: u64, serialize_char: char,
        serialize_bytes: &[u8], serialize_i128: i128, serialize_u128: u128
    );

    fn serialize_f32(self, value: f32) -> Result<(), Found> {
        self.serialize_f64(value.into())
    }

    fn serialize_f64(self, value: f64) -> Result<(), Found> {
        if value.is_finite() { Ok(()) } else { Err(Found(self.path.clone())) }
    }

    fn serialize_str(self, text: &str) -> Result<(), Found> {
        if self.path.is_empty() {
            self.path = text.to_owned();
        }
        Ok(())
    }

    fn serialize_none(self) -> Result<(), Found> {
        Ok(())
    }

    fn serialize_some<T: Serialize + ?Sized>(self, value: &T) -> Result<(), Found> {
        value.serialize(self)
    }

    fn serialize_unit(self) -> Result<(), Found> {
        Ok(())
    }

    fn serialize_unit_struct(self, _: &'static str) -> Result<(), Found> {
        Ok(())
    }

    fn serialize_unit_variant(self, _: &'static str, _: u32, _: &'static str) -> Result<(), Found> {
        Ok(())
    }

    fn serialize_newtype_struct<T: Serialize + ?Sized>(
        self,
        _: &'static str,
        value: &T,
    ) -> Result<(), Found> {
        value.serialize(self)
    }

    fn serialize_newtype_variant<T: Serialize + ?Sized>(
        self,
        _: &'static str,
        _: u32,
        variant: &'static str,
        value: &T,
    ) -> Result<(), Found> {
        self.key(variant, value)
    }

    fn serialize_seq(self, _: Option<usize>) -> Result<Entries<'a>, Found> {
        Ok(Entries { walk: self, count: 0, key: String::new() })
    }

    fn serialize_tuple(self, _: usize) -> Result<Entries<'a>, Found> {
        self.serialize_seq(None)
    }

    fn serialize_tuple_struct(self, _: &'static str, _: usize) -> Result<Entries<'a>, Found> {
        self.serialize_seq(None)
    }

    fn serialize_tuple_variant(
        self,
        _: &'static str,
        _: u32,
        variant: &'static str,
        _: usize,
    ) -> Result<Self::SerializeTupleVariant, Found> {
        Err(ser::Error::custom(format!("{variant}: no record has variants of several values")))
    }

    fn serialize_map(self, _: Option<usize>) -> Result<Entries<'a>, Found> {
        self.serialize_seq(None)
    }

    fn serialize_struct(self, _: &'static str, _: usize) -> Result<&'a mut Walk, Found> {
        Ok(self)
    }

    fn serialize_struct_variant(
        self,
        _: &'static str,
        _: u32,
        _: &'static str,
        _: usize,
    ) -> Result<&'a mut Walk, Found> {
        Ok(self)
    }
}

impl ser::SerializeSeq for Entries<'_> {
    type Ok = ();
    type Error = Found;

    fn serialize_element<T: Serialize + ?Sized>(&mut self, value: &T) -> Result<(), Found> {
        self.entry(value)
    }

    fn end(self) -> Result<(), Found> {
        Ok(())
    }
}

impl ser::SerializeTuple for Entries<'_> {
    type Ok = ();
    type Error = Found;

    fn serialize_element<T: Serialize + ?Sized>(&mut self, value: &T) -> Result<(), Found> {
        self.entry(value)
    }

    fn end(self) -> Result<(), Found> {
        Ok(())
    }
}

impl ser::SerializeTupleStruct for Entries<'_> {
    type Ok = ();
    type Error = Found;

    fn serialize_field<T: Serialize + ?Sized>(&mut self, value: &T) -> Result<(), Found> {
        self.entry(value)
    }

    fn end(self) -> Result<(), Found> {
        Ok(())
    }
}

impl ser::SerializeMap for Entries<'_> {
    type Ok = ();
    type Error = Found;

    fn serialize_key<T: Serialize + ?Sized>(&mut self, key: &T) -> Result<(), Found> {
        // A walk of its own: with nothing above it, a text is its path.
        let mut name = Walk { path: String::new() };
        key.serialize(&mut name)?;
        self.key = name.path;
        Ok(())
    }

    fn serialize_value<T: Serialize + ?Sized>(&mut self, value: &T) -> Result<(), Found> {
        let key = std::mem::take(&mut self.key);
        self.walk.key(&key, value)
    }

    fn end(self) -> Result<(), Found> {
        Ok(())
    }
}

impl ser::SerializeStruct for &mut Walk {
    type Ok = ();
    type Error = Found;

    fn serialize_field<T: Serialize + ?Sized>(&mut self, key: &'static str, value: &T) -> Result<(), Found> {
        self.key(key, value)
    }

    fn end(self) -> Result<(), Found> {
        Ok(())
    }
}

impl ser::SerializeStructVariant for &mut Walk {
    type Ok = ();
    type Error = Found;

    fn serialize_field<T: Serialize + ?Sized>(&mut self, key: &'static str, value: &T) -> Result<(), Found> {
        self.key(key, value)
    }

    fn end(self) -> Result<(), Found> {
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde::Serialize;
    use std::collections::BTreeMap;

    #[derive(Serialize)]
    struct Record {
        name: &'static str,
        values: Vec<Option<f64>>,
        by_link: BTreeMap<String, [f64; 2]>,
    }

    #[test]
    fn the_key_of_a_number_that_is_none_is_told() {
        let mut record = Record { name: "a", values: vec![Some(1.0), None], by_link: BTreeMap::new() };
        assert!(check(&record).is_ok());
        record.by_link.insert("D".to_owned(), [0.0, f64::NAN]);
        let told = |record: &Record| check(record).unwrap_err().to_string();
        assert!(told(&record).starts_with("not a finite number: by_link.D[1];"), "{}", told(&record));
        record.values.push(Some(f64::INFINITY));
        assert!(told(&record).contains(": values[2];"), "{}", told(&record));
    }
}
