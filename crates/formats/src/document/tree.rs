//! Tree of a YAML text, from the events of a parser. Each key and each value has its place.
//!
//! Repeated keys, merge keys, anchors, tags and numbers that are not finite are refused.

use std::collections::HashMap;

use saphyr_parser::{Event, Parser, ScalarStyle};

use super::path::{Path, Segment};
use super::position::Position;
use crate::error::Problem;
use crate::yaml::Value;
use epicyclic_units::{self as quantity, QuantityError};

/// Greatest depth of nested maps and sequences. A case nests about five levels.
pub(super) const DEPTH_LIMIT: usize = 100;

/// Greatest number of values in a file: scalars, maps and sequences, without keys. The largest file of
/// [`super::SIZE_LIMIT`] bytes could hold two million, and each takes some hundred bytes.
pub(super) const VALUE_LIMIT: usize = 200_000;

/// Position of a problem, path of the node that has it, and the problem.
pub(super) type Found = (Position, Path, Problem);

/// A value of the text and its place.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Node {
    pub(super) at: Position,
    pub(super) content: Content,
}

#[derive(Debug, Clone, PartialEq)]
pub(super) enum Content {
    /// Meaning of the scalar, and its text without quotes and escapes.
    Scalar(Scalar, String),
    Sequence(Vec<Node>),
    Map(Map),
}

/// Meaning of a scalar by the core schema of YAML 1.2. In quotes every scalar is a text.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Scalar {
    Null,
    Bool(bool),
    Whole(u64),
    Negative(i64),
    Number(f64),
    Text,
}

/// A whole number of more than 64 bits.
pub(super) struct TooLong;

impl Scalar {
    /// Meaning of a plain scalar.
    ///
    /// # Errors
    /// [`TooLong`] for whole numbers of 65 to 128 bits. Longer ones are floating-point numbers.
    pub(super) fn of(text: &str) -> Result<Self, TooLong> {
        match text {
            "" | "~" | "null" | "Null" | "NULL" => return Ok(Self::Null),
            "true" | "True" | "TRUE" => return Ok(Self::Bool(true)),
            "false" | "False" | "FALSE" => return Ok(Self::Bool(false)),
            ".nan" | ".NaN" | ".NAN" => return Ok(Self::Number(f64::NAN)),
            _ => {}
        }
        let digits = text.strip_prefix(['+', '-']).unwrap_or(text);
        let sign = if text.starts_with('-') { "-" } else { "" };
        // `007` is a name.
        let is_padded =
            digits.len() > 1 && digits.starts_with('0') && digits.bytes().all(|b| b.is_ascii_digit());
        if digits.starts_with(['+', '-']) || is_padded {
            return Ok(Self::Text);
        }
        if matches!(digits, ".inf" | ".Inf" | ".INF") {
            return Ok(Self::Number(if sign.is_empty() { f64::INFINITY } else { f64::NEG_INFINITY }));
        }
        for (prefix, radix) in [("0x", 16), ("0o", 8), ("0b", 2), ("", 10)] {
            let Some(rest) = digits.strip_prefix(prefix).filter(|rest| !rest.starts_with(['+', '-'])) else {
                continue;
            };
            let signed = format!("{sign}{rest}");
            if sign.is_empty()
                && let Ok(value) = u64::from_str_radix(rest, radix)
            {
                return Ok(Self::Whole(value));
            }
            if let Ok(value) = i64::from_str_radix(&signed, radix) {
                return Ok(u64::try_from(value).map_or(Self::Negative(value), Self::Whole));
            }
            let is_long = u128::from_str_radix(rest, radix).is_ok() && sign.is_empty();
            if is_long || i128::from_str_radix(&signed, radix).is_ok() {
                return Err(TooLong);
            }
        }
        let number = text.parse::<f64>().ok().filter(|number| number.is_finite());
        Ok(number.map_or(Self::Text, Self::Number))
    }
}

#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Map {
    entries: Vec<Entry>,
    by_key: HashMap<String, usize>,
}

#[derive(Debug, Clone, PartialEq)]
pub(super) struct Entry {
    pub(super) key: String,
    pub(super) key_at: Position,
    /// Meaning of the key, for maps from numbers.
    pub(super) key_is: Scalar,
    pub(super) value: Node,
}

impl Map {
    pub(super) fn get(&self, key: &str) -> Option<&Entry> {
        self.by_key.get(key).and_then(|index| self.entries.get(*index))
    }

    fn get_mut(&mut self, key: &str) -> Option<&mut Entry> {
        self.by_key.get(key).and_then(|index| self.entries.get_mut(*index))
    }

    /// Entries in the order of the text.
    pub(super) fn entries(&self) -> &[Entry] {
        &self.entries
    }

    pub(super) fn push(&mut self, entry: Entry) {
        self.by_key.insert(entry.key.clone(), self.entries.len());
        self.entries.push(entry);
    }
}

impl Node {
    pub(super) fn step(&self, segment: &Segment) -> Option<&Self> {
        match (&self.content, segment) {
            (Content::Map(map), Segment::Key(key)) => map.get(key).map(|entry| &entry.value),
            (Content::Sequence(items), Segment::Index(index)) => items.get(*index),
            _ => None,
        }
    }

    pub(super) fn step_mut(&mut self, segment: &Segment) -> Option<&mut Self> {
        match (&mut self.content, segment) {
            (Content::Map(map), Segment::Key(key)) => map.get_mut(key).map(|entry| &mut entry.value),
            (Content::Sequence(items), Segment::Index(index)) => items.get_mut(*index),
            _ => None,
        }
    }

    /// The text of the scalar at a path from here.
    pub(super) fn text_at(&self, path: &Path) -> Option<&str> {
        match &path.segments().iter().try_fold(self, Self::step)?.content {
            Content::Scalar(_, text) => Some(text),
            Content::Sequence(_) | Content::Map(_) => None,
        }
    }

    pub(super) const fn is_null(&self) -> bool {
        matches!(self.content, Content::Scalar(Scalar::Null, _))
    }

    /// The node as a value without places, to be changed and written.
    pub(super) fn value(&self) -> Value {
        match &self.content {
            Content::Scalar(Scalar::Null, _) => Value::Null,
            Content::Scalar(Scalar::Bool(value), _) => Value::Bool(*value),
            Content::Scalar(Scalar::Whole(number), _) => Value::from(*number),
            Content::Scalar(Scalar::Negative(number), _) => Value::from(*number),
            Content::Scalar(Scalar::Number(number), _) => Value::from(*number),
            Content::Scalar(Scalar::Text, text) => Value::from(text.as_str()),
            Content::Sequence(items) => Value::Sequence(items.iter().map(Self::value).collect()),
            Content::Map(map) => {
                let key = |entry: &Entry| {
                    let content = Content::Scalar(entry.key_is, entry.key.clone());
                    Self { at: entry.key_at, content }.value()
                };
                Value::Mapping(map.entries.iter().map(|entry| (key(entry), entry.value.value())).collect())
            }
        }
    }

    /// A value with the places of this node. Parts that this node lacks have the place of their nearest
    /// ancestor.
    pub(super) fn placed(at: Position, value: &Value, like: Option<&Self>) -> Self {
        let at = like.map_or(at, |like| like.at);
        let content = match value {
            Value::Sequence(items) => {
                let like = |index| like.and_then(|like| like.step(&Segment::Index(index)));
                let items = items.iter().enumerate();
                Content::Sequence(items.map(|(index, item)| Self::placed(at, item, like(index))).collect())
            }
            Value::Mapping(pairs) => {
                let mut map = Map::default();
                for (key, value) in pairs {
                    let (key_is, key) = scalar(key);
                    let own = match like.map(|like| &like.content) {
                        Some(Content::Map(own)) => own.get(&key),
                        _ => None,
                    };
                    let value = Self::placed(at, value, own.map(|own| &own.value));
                    let key_at = own.map_or(at, |own| own.key_at);
                    map.push(Entry { key, key_at, key_is, value });
                }
                Content::Map(map)
            }
            Value::Tagged(tagged) => return Self::placed(at, &tagged.value, like),
            value => {
                let (scalar, text) = scalar(value);
                Content::Scalar(scalar, text)
            }
        };
        Self { at, content }
    }

    /// Every position of this node and of those within it, of keys too.
    pub(super) fn each_position(&mut self, change: &impl Fn(&mut Position)) {
        change(&mut self.at);
        match &mut self.content {
            Content::Scalar(..) => {}
            Content::Sequence(items) => items.iter_mut().for_each(|item| item.each_position(change)),
            Content::Map(map) => {
                for entry in &mut map.entries {
                    change(&mut entry.key_at);
                    entry.value.each_position(change);
                }
            }
        }
    }
}

/// Meaning and text of a scalar value; of other values nothing.
pub(super) fn scalar(value: &Value) -> (Scalar, String) {
    match value {
        Value::Bool(value) => (Scalar::Bool(*value), value.to_string()),
        Value::Number(number) => {
            let whole = number.as_u64().map(Scalar::Whole).or(number.as_i64().map(Scalar::Negative));
            (whole.unwrap_or(Scalar::Number(number.as_f64().unwrap_or(f64::NAN))), number.to_string())
        }
        Value::String(text) => (Scalar::Text, text.clone()),
        _ => (Scalar::Null, String::new()),
    }
}

/// Root of every document in a text.
pub(super) fn documents(text: &str) -> Result<Vec<Node>, Found> {
    let mut builder = Builder::default();
    let mut parser = Parser::new_from_str(text);
    while let Some(event) = parser.next_event() {
        match event {
            Ok((event, span)) => builder.take(event, Position::of(span.start))?,
            Err(error) => {
                let message = error.info().to_owned();
                return Err(builder.fail(Position::of(*error.marker()), Problem::Syntax { message }));
            }
        }
    }
    Ok(builder.documents)
}

/// Builder of nodes with its own stack, so that no text can exhaust the stack of the program.
#[derive(Default)]
struct Builder {
    documents: Vec<Node>,
    open: Vec<Open>,
    /// Number of values so far.
    values: usize,
}

struct Open {
    at: Position,
    content: Content,
    /// Key of a map that has no value yet.
    key: Option<(String, Position, Scalar)>,
}

impl Builder {
    fn take(&mut self, event: Event<'_>, at: Position) -> Result<(), Found> {
        match event {
            Event::Alias(_) => Err(self.fail(at, Problem::Anchor)),
            Event::Scalar(text, style, anchor, tag) => {
                self.refuse_decoration(at, anchor, tag.as_deref())?;
                let plain = style == ScalarStyle::Plain;
                if self.awaits_key() {
                    return self.key(text.into_owned(), at, plain);
                }
                let scalar = self.meaning(&text, at, plain)?;
                self.count(at)?;
                // A value left out has no position of its own: its key has.
                let left_out = plain && text.is_empty();
                if left_out && let Some(found) = self.decimal_comma() {
                    return Err(found);
                }
                let at = self
                    .open
                    .last()
                    .and_then(|open| open.key.as_ref())
                    .filter(|_| left_out)
                    .map_or(at, |key| key.1);
                self.close(Node { at, content: Content::Scalar(scalar, text.into_owned()) });
                Ok(())
            }
            Event::SequenceStart(anchor, tag) => {
                self.refuse_decoration(at, anchor, tag.as_deref())?;
                self.open(at, Content::Sequence(Vec::new()))
            }
            Event::MappingStart(anchor, tag) => {
                self.refuse_decoration(at, anchor, tag.as_deref())?;
                self.open(at, Content::Map(Map::default()))
            }
            Event::SequenceEnd | Event::MappingEnd => {
                if let Some(Open { at, content, .. }) = self.open.pop() {
                    self.close(Node { at, content });
                }
                Ok(())
            }
            _ => Ok(()),
        }
    }

    fn awaits_key(&self) -> bool {
        matches!(self.open.last(), Some(Open { content: Content::Map(_), key: None, .. }))
    }

    fn refuse_decoration(
        &self,
        at: Position,
        anchor: usize,
        tag: Option<&saphyr_parser::Tag>,
    ) -> Result<(), Found> {
        if anchor > 0 {
            return Err(self.fail(at, Problem::Anchor));
        }
        match tag {
            Some(tag) if tag.is_yaml_core_schema() => {
                Err(self.fail(at, Problem::Tag { tag: format!("!!{}", tag.suffix) }))
            }
            Some(tag) => Err(self.fail(at, Problem::Tag { tag: format!("{}{}", tag.handle, tag.suffix) })),
            None => Ok(()),
        }
    }

    fn open(&mut self, at: Position, content: Content) -> Result<(), Found> {
        if self.awaits_key() {
            return Err(self.fail(at, Problem::ComplexKey));
        }
        self.count(at)?;
        if self.open.len() == DEPTH_LIMIT {
            return Err(self.fail(at, Problem::TooDeep { limit: DEPTH_LIMIT }));
        }
        self.open.push(Open { at, content, key: None });
        Ok(())
    }

    fn count(&mut self, at: Position) -> Result<(), Found> {
        self.values += 1;
        if self.values > VALUE_LIMIT {
            return Err(self.fail(at, Problem::TooManyValues { limit: VALUE_LIMIT }));
        }
        Ok(())
    }

    fn key(&mut self, key: String, at: Position, plain: bool) -> Result<(), Found> {
        if plain && key == "<<" {
            return Err(self.fail(at, Problem::MergeKey));
        }
        let first = match self.open.last() {
            Some(Open { content: Content::Map(map), .. }) => map.get(&key).map(|entry| entry.key_at),
            _ => None,
        };
        if let Some(first) = first {
            let (at, path, problem) = self.fail(at, Problem::DuplicateKey { key: key.clone(), first });
            return Err((at, path.key(key), problem));
        }
        let key_is =
            self.meaning(&key, at, plain).map_err(|(at, path, problem)| (at, path.key(&key), problem))?;
        if let Some(open) = self.open.last_mut() {
            open.key = Some((key, at, key_is));
        }
        Ok(())
    }

    fn meaning(&self, text: &str, at: Position, plain: bool) -> Result<Scalar, Found> {
        if !plain {
            return Ok(Scalar::Text);
        }
        match Scalar::of(text) {
            Ok(Scalar::Number(number)) if !number.is_finite() => {
                let text = if number.is_nan() {
                    ".nan"
                } else if number > 0.0 {
                    ".inf"
                } else {
                    "-.inf"
                };
                Err(self.fail(at, QuantityError::NotFinite { text: text.to_owned() }.into()))
            }
            Ok(scalar) => Ok(scalar),
            Err(TooLong) => {
                let message = "a whole number of more than 64 bits; write it with a decimal point".to_owned();
                Err(self.fail(at, Problem::Syntax { message }))
            }
        }
    }

    fn close(&mut self, node: Node) {
        match self.open.last_mut() {
            None => self.documents.push(node),
            Some(Open { content: Content::Sequence(items), .. }) => items.push(node),
            Some(Open { content: Content::Map(map), key, .. }) => {
                if let Some((key, key_at, key_is)) = key.take() {
                    map.push(Entry { key, key_at, key_is, value: node });
                }
            }
            Some(Open { content: Content::Scalar(..), .. }) => {}
        }
    }

    /// Decimal comma in braces, `{ mass: 31,5 kg }`: for YAML a value of 31 and a key without a value
    /// directly after the comma.
    fn decimal_comma(&self) -> Option<Found> {
        let Open { content: Content::Map(map), key: Some((key, key_at, _)), .. } = self.open.last()? else {
            return None;
        };
        let Entry { key: before, value: Node { at, content: Content::Scalar(_, text) }, .. } =
            map.entries.last()?
        else {
            return None;
        };
        let is_close = key_at.line == at.line && key_at.column == at.column + text.chars().count() + 1;
        let are_digits =
            text.ends_with(|c: char| c.is_ascii_digit()) && key.starts_with(|c: char| c.is_ascii_digit());
        if !is_close || !are_digits {
            return None;
        }
        let error = quantity::parse(&format!("{text},{key}")).err()?;
        error.corrected()?;
        let (at, mut path, problem) = self.fail(*at, Problem::Quantity(error));
        path.pop();
        Some((at, path.key(before), problem))
    }

    fn fail(&self, at: Position, problem: Problem) -> Found {
        let mut path = Path::root();
        for open in &self.open {
            match (&open.content, &open.key) {
                (Content::Sequence(items), _) => path.push(Segment::Index(items.len())),
                (_, Some((key, ..))) => path.push(Segment::Key(key.clone())),
                _ => {}
            }
        }
        (at, path, problem)
    }
}
