//! Reader of a tree of nodes as a Rust type. Every fault has the place and the path of its value.
//!
//! An unknown key comes with the allowed keys, a decimal comma is recognised where a number is required, and
//! a [`Quantity`](epicyclic_units::Quantity) is parsed here, so that its error keeps its name. A number is
//! not text, and an empty value is no empty sequence.
//!
//! After a fault the type is read again with an allowed value in place of the wrong one. So all independent
//! faults are found.

use std::collections::{HashMap, HashSet};
use std::slice::Iter;

use serde::de::value::StrDeserializer;
use serde::de::{
    self, DeserializeOwned, DeserializeSeed, EnumAccess, Expected, MapAccess, SeqAccess, VariantAccess,
    Visitor,
};
use serde::{Deserializer, forward_to_deserialize_any};

use super::fault::{Fault, FaultPlace, Inner, wrong_type};
use super::filled::Filled;
use super::path::Segment;
use super::tree::{Content, Entry, Found, Node, Scalar};
use super::words;
use crate::error::{Problem, nearest};
use epicyclic_units::{self as quantity, Dimension, QuantityError};

/// Greatest number of faults listed of one document.
const MOST_FAULTS: usize = 50;

/// Reads a node, or finds its faults in the order of their positions.
pub(super) fn read<T: DeserializeOwned>(root: &Node) -> Result<T, Vec<Found>> {
    let mut repairs = Repairs::default();
    let mut faults: Vec<Found> = vec![];
    while faults.len() < MOST_FAULTS {
        let Inner { problem, place, path } = match T::deserialize(Reader { node: root, repairs: &repairs }) {
            Ok(read) if faults.is_empty() => return Ok(read),
            Ok(_) => break,
            Err(Fault(inner)) => *inner,
        };
        let place = place.unwrap_or(FaultPlace { at: root.at, node: root, is_key: false, is_scalar: false });
        let problem = in_usual_unit(problem, &path);
        match repairs.add(&problem, &place, !faults.is_empty()) {
            Some(true) => faults.push((place.at, path.into_iter().rev().collect(), problem)),
            Some(false) => {}
            None => {
                if faults.is_empty() {
                    faults.push((place.at, path.into_iter().rev().collect(), problem));
                }
                break;
            }
        }
    }
    faults.sort_by_key(|(at, ..)| *at);
    Err(faults)
}

/// Units that engineers use of a key, where they are not the usual ones of its dimension.
const USUAL_UNITS: [(&str, &str); 12] = [
    ("life", "h"),
    ("load_rating", "kN"),
    ("static_load_rating", "kN"),
    ("flank_roughness", "µm"),
    ("root_roughness", "µm"),
    ("pitch_deviations", "µm"),
    ("profile_deviations", "µm"),
    ("tip_relief", "µm"),
    ("transmission_error", "µm"),
    ("ring_transmission_error", "µm"),
    ("thickness_allowances", "µm"),
    ("centre_distance_deviations", "µm"),
];

/// The problem with the unit that is usual of a key of its path, for a number without a unit.
fn in_usual_unit(problem: Problem, path: &[Segment]) -> Problem {
    let own = |segment: &Segment| match segment {
        Segment::Key(key) => USUAL_UNITS.into_iter().find(|(of, _)| of == key),
        Segment::Index(_) => None,
    };
    match (problem, path.iter().find_map(own)) {
        (Problem::Quantity(error), Some((_, unit))) => error.in_unit(unit).into(),
        (problem, _) => problem,
    }
}

/// Changes with which the reading goes on after a fault, by the node that has the fault.
#[derive(Default)]
struct Repairs {
    filled: HashSet<*const Node>,
    left_out: HashSet<*const Node>,
    /// Keys added to a map.
    added: HashMap<*const Node, Vec<String>>,
    /// Keys that a wrong key probably means. Their absence is no fault of its own.
    meant: Vec<String>,
}

impl Repairs {
    /// Repairs a fault. `Some(false)` for a consequence of an earlier fault, `None` where nothing can be
    /// repaired.
    fn add(&mut self, problem: &Problem, place: &FaultPlace, has_faults: bool) -> Option<bool> {
        let (node, is_scalar) = (place.node, place.is_scalar);
        if place.is_key {
            match problem {
                Problem::RenamedKey { new, .. } => self.meant.push(new.clone()),
                Problem::UnknownKey { key, allowed } => {
                    self.meant.extend(nearest(key, allowed).map(str::to_owned));
                }
                _ => {}
            }
            return self.left_out.insert(node).then_some(true);
        }
        if let Problem::MissingKey { key } = problem {
            let added = self.added.entry(node).or_default();
            if added.contains(key) {
                return None;
            }
            added.push(key.clone());
            return Some(!self.meant.iter().any(|meant| meant == key));
        }
        // A check of several values fails on the values that were put in.
        if matches!(problem, Problem::Refused { .. }) && has_faults && !is_scalar {
            return None;
        }
        self.filled.insert(node).then_some(true)
    }
}

/// Reader of a node.
#[derive(Clone, Copy)]
struct Reader<'de> {
    node: &'de Node,
    repairs: &'de Repairs,
}

impl<'de> Reader<'de> {
    fn of(self, node: &'de Node) -> Self {
        Self { node, ..self }
    }

    /// A fault without a place is at this node.
    fn here<T>(self, read: Result<T, Fault>) -> Result<T, Fault> {
        read.map_err(|mut fault| {
            fault.0.place.get_or_insert(FaultPlace {
                at: self.node.at,
                node: self.node,
                is_key: false,
                is_scalar: matches!(self.node.content, Content::Scalar(..)),
            });
            fault
        })
    }

    /// Reads a part of this node.
    fn part<S: DeserializeSeed<'de>>(
        self,
        node: &'de Node,
        seed: S,
        segment: impl FnOnce() -> Segment,
    ) -> Result<S::Value, Fault> {
        let part = self.of(node);
        let read = if self.repairs.filled.contains(&std::ptr::from_ref(node)) {
            seed.deserialize(Filled)
        } else {
            seed.deserialize(part)
        };
        part.here(read).map_err(|mut fault| {
            fault.0.path.push(segment());
            fault
        })
    }

    /// Reads the key of an entry.
    fn key<S: DeserializeSeed<'de>>(self, entry: &'de Entry, seed: S) -> Result<S::Value, Fault> {
        seed.deserialize(KeyReader(entry)).map_err(|mut fault| {
            fault.0.place = Some(FaultPlace {
                at: entry.key_at,
                node: &raw const entry.value,
                is_key: true,
                is_scalar: true,
            });
            fault.0.path.push(Segment::Key(entry.key.clone()));
            fault
        })
    }

    fn mismatch(self, expected: &dyn Expected) -> Fault {
        wrong_type(words::found_node(self.node), expected, None)
    }

    fn number<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        match &self.node.content {
            Content::Scalar(scalar, text) => number(*scalar, text, visitor),
            _ => Err(self.mismatch(&visitor)),
        }
    }

    fn sequence<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        let Content::Sequence(items) = &self.node.content else { return Err(self.mismatch(&visitor)) };
        let mut access = Items { reader: self, items: items.iter(), next: 0 };
        let read = visitor.visit_seq(&mut access)?;
        if access.items.len() > 0 {
            let read = items.len() - access.items.len();
            return Err(de::Error::invalid_length(
                items.len(),
                &format!("{read} elements in sequence").as_str(),
            ));
        }
        Ok(read)
    }

    fn map<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        let Content::Map(map) = &self.node.content else { return Err(self.mismatch(&visitor)) };
        let added = self.repairs.added.get(&std::ptr::from_ref(self.node)).map_or(&[][..], Vec::as_slice);
        visitor.visit_map(Entries {
            reader: self,
            entries: map.entries().iter(),
            value: None,
            added: added.iter(),
        })
    }
}

struct Items<'de> {
    reader: Reader<'de>,
    items: Iter<'de, Node>,
    next: usize,
}

impl<'de> SeqAccess<'de> for Items<'de> {
    type Error = Fault;

    fn next_element_seed<S: DeserializeSeed<'de>>(&mut self, seed: S) -> Result<Option<S::Value>, Fault> {
        let Some(item) = self.items.next() else { return Ok(None) };
        let index = self.next;
        self.next += 1;
        self.reader.part(item, seed, || Segment::Index(index)).map(Some)
    }

    fn size_hint(&self) -> Option<usize> {
        Some(self.items.len())
    }
}

struct Entries<'de> {
    reader: Reader<'de>,
    entries: Iter<'de, Entry>,
    value: Option<&'de Entry>,
    added: Iter<'de, String>,
}

impl<'de> MapAccess<'de> for Entries<'de> {
    type Error = Fault;

    fn next_key_seed<S: DeserializeSeed<'de>>(&mut self, seed: S) -> Result<Option<S::Value>, Fault> {
        let left_out = &self.reader.repairs.left_out;
        self.value = self.entries.find(|entry| !left_out.contains(&std::ptr::from_ref(&entry.value)));
        match (self.value, self.value.is_none().then(|| self.added.next()).flatten()) {
            (Some(entry), _) => self.reader.key(entry, seed).map(Some),
            (None, Some(key)) => seed.deserialize(StrDeserializer::<Fault>::new(key)).map(Some),
            (None, None) => Ok(None),
        }
    }

    fn next_value_seed<S: DeserializeSeed<'de>>(&mut self, seed: S) -> Result<S::Value, Fault> {
        match self.value {
            Some(entry) => self.reader.part(&entry.value, seed, || Segment::Key(entry.key.clone())),
            None => seed.deserialize(Filled),
        }
    }
}

/// A name as the only key of a map, with the value of the name.
struct NameOf<'de> {
    reader: Reader<'de>,
    entry: &'de Entry,
}

impl<'de> EnumAccess<'de> for NameOf<'de> {
    type Error = Fault;
    type Variant = Self;

    fn variant_seed<S: DeserializeSeed<'de>>(self, seed: S) -> Result<(S::Value, Self), Fault> {
        self.reader.key(self.entry, seed).map(|name| (name, self))
    }
}

impl NameOf<'_> {
    fn placed<T>(self, read: Result<T, Fault>) -> Result<T, Fault> {
        self.reader.of(&self.entry.value).here(read).map_err(|mut fault| {
            fault.0.path.push(Segment::Key(self.entry.key.clone()));
            fault
        })
    }
}

impl<'de> VariantAccess<'de> for NameOf<'de> {
    type Error = Fault;

    fn unit_variant(self) -> Result<(), Fault> {
        let read = serde::Deserialize::deserialize(self.reader.of(&self.entry.value));
        self.placed(read)
    }

    fn newtype_variant_seed<S: DeserializeSeed<'de>>(self, seed: S) -> Result<S::Value, Fault> {
        self.reader.part(&self.entry.value, seed, || Segment::Key(self.entry.key.clone()))
    }

    fn tuple_variant<V: Visitor<'de>>(self, _len: usize, visitor: V) -> Result<V::Value, Fault> {
        let read = self.reader.of(&self.entry.value).sequence(visitor);
        self.placed(read)
    }

    fn struct_variant<V: Visitor<'de>>(
        self,
        _: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Fault> {
        let read = self.reader.of(&self.entry.value).map(visitor);
        self.placed(read)
    }
}

/// Hands a scalar on as what it means.
fn visit<'de, V: Visitor<'de>>(scalar: Scalar, text: &'de str, visitor: V) -> Result<V::Value, Fault> {
    match scalar {
        Scalar::Null => visitor.visit_unit(),
        Scalar::Bool(value) => visitor.visit_bool(value),
        Scalar::Whole(value) => visitor.visit_u64(value),
        Scalar::Negative(value) => visitor.visit_i64(value),
        Scalar::Number(value) if value.is_finite() => visitor.visit_f64(value),
        Scalar::Number(value) => Err(QuantityError::NotFinite { text: words::number(value) }.into()),
        Scalar::Text => visitor.visit_borrowed_str(text),
    }
}

fn number<'de, V: Visitor<'de>>(scalar: Scalar, text: &'de str, visitor: V) -> Result<V::Value, Fault> {
    let found = || words::found_scalar(scalar, text);
    match scalar {
        Scalar::Whole(_) | Scalar::Negative(_) | Scalar::Number(_) => visit(scalar, text, visitor),
        Scalar::Text => match quantity::parse_number(text) {
            Ok(value) if text.contains(['/', ':', '%', '‰']) => visitor.visit_f64(value),
            // In quotes, or with leading zeros.
            Ok(value) => Err(wrong_type(found(), &visitor, Some(value.to_string()))),
            Err(QuantityError::Empty { .. } | QuantityError::NotANumber { .. }) => {
                Err(wrong_type(found(), &visitor, None))
            }
            Err(error) => Err(error.into()),
        },
        Scalar::Null | Scalar::Bool(_) => Err(wrong_type(found(), &visitor, None)),
    }
}

fn quantity<'de, V: Visitor<'de>>(
    scalar: Scalar,
    text: &str,
    dimension: Dimension,
    visitor: V,
) -> Result<V::Value, Fault> {
    let text = match scalar {
        Scalar::Null | Scalar::Bool(_) => {
            return Err(wrong_type(words::found_scalar(scalar, text), &visitor, None));
        }
        scalar => words::scalar(scalar, text),
    };
    quantity::parse_as(&text, dimension)?;
    visitor.visit_newtype_struct(StrDeserializer::<Fault>::new(&text))
}

macro_rules! forward {
    ($($method:ident)* => $to:ident) => {$(
        fn $method<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
            self.$to(visitor)
        }
    )*};
}

impl<'de> Deserializer<'de> for Reader<'de> {
    type Error = Fault;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        match &self.node.content {
            Content::Scalar(scalar, text) => visit(*scalar, text, visitor),
            Content::Sequence(_) => self.sequence(visitor),
            Content::Map(_) => self.map(visitor),
        }
    }

    forward! {
        deserialize_i8 deserialize_i16 deserialize_i32 deserialize_i64 deserialize_i128
        deserialize_u8 deserialize_u16 deserialize_u32 deserialize_u64 deserialize_u128
        deserialize_f32 deserialize_f64 => number
    }

    fn deserialize_str<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        match &self.node.content {
            Content::Scalar(Scalar::Text, text) => visitor.visit_borrowed_str(text),
            Content::Scalar(scalar, text) if *scalar != Scalar::Null => {
                let quoted = format!("{:?}, in quotes", words::scalar(*scalar, text));
                Err(wrong_type(words::found_node(self.node), &visitor, Some(quoted)))
            }
            _ => Err(self.mismatch(&visitor)),
        }
    }

    forward! { deserialize_string deserialize_char => deserialize_str }
    forward! { deserialize_seq => sequence }
    forward! { deserialize_map => map }

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

    // A derived type would also read a sequence of its fields in order, which nobody means to write.
    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _name: &'static str,
        _fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Fault> {
        self.map(visitor)
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        if self.node.is_null() { visitor.visit_none() } else { visitor.visit_some(self) }
    }

    fn deserialize_newtype_struct<V: Visitor<'de>>(
        self,
        name: &'static str,
        visitor: V,
    ) -> Result<V::Value, Fault> {
        match (quantity::token_dimension(name), &self.node.content) {
            (Some(dimension), Content::Scalar(scalar, text)) => quantity(*scalar, text, dimension, visitor),
            (Some(_), _) => Err(self.mismatch(&visitor)),
            (None, _) => visitor.visit_newtype_struct(self),
        }
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _name: &'static str,
        _variants: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Fault> {
        match &self.node.content {
            // YAML reads a name such as `1` as a number.
            Content::Scalar(scalar, text) if *scalar != Scalar::Null => {
                visitor.visit_enum(StrDeserializer::<Fault>::new(&words::scalar(*scalar, text)))
            }
            Content::Map(map) if map.entries().len() == 1 => {
                visitor.visit_enum(NameOf { reader: self, entry: &map.entries()[0] })
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

/// Reader of the key of an entry. A key is a text, whatever YAML reads it as.
#[derive(Clone, Copy)]
struct KeyReader<'de>(&'de Entry);

impl<'de> KeyReader<'de> {
    fn number<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        number(self.0.key_is, &self.0.key, visitor)
    }
}

impl<'de> Deserializer<'de> for KeyReader<'de> {
    type Error = Fault;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        visitor.visit_borrowed_str(&self.0.key)
    }

    // A map from numbers: `7: sun`.
    forward! {
        deserialize_i8 deserialize_i16 deserialize_i32 deserialize_i64 deserialize_i128
        deserialize_u8 deserialize_u16 deserialize_u32 deserialize_u64 deserialize_u128
        deserialize_f32 deserialize_f64 => number
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
            Some(dimension) => quantity(self.0.key_is, &self.0.key, dimension, visitor),
            None => visitor.visit_newtype_struct(self),
        }
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _name: &'static str,
        _variants: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Fault> {
        visitor.visit_enum(StrDeserializer::<Fault>::new(&self.0.key))
    }

    fn deserialize_ignored_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        visitor.visit_unit()
    }

    forward_to_deserialize_any! {
        bool char str string bytes byte_buf unit unit_struct seq tuple tuple_struct map struct identifier
    }
}
