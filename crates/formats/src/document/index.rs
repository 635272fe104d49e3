//! Where every key and value of a YAML text stands, from parser events.
//!
//! The same pass refuses what a value tree would no longer show: repeated keys, merge keys, anchors, tags.

use std::collections::HashMap;

use saphyr_parser::{Event, Parser, ScalarStyle};

use super::path::{Path, Segment};
use super::position::Position;
use crate::error::Problem;
use epicyclic_units as quantity;

/// How deep maps and sequences may nest. A case nests five levels or so; the value parser stops at 128.
pub(super) const DEPTH_LIMIT: usize = 100;

/// How many values a file may have: scalars, maps and sequences, without keys. The largest file of
/// [`super::SIZE_LIMIT`] bytes could hold two million, and each takes some hundred bytes here and in the
/// value tree.
pub(super) const VALUE_LIMIT: usize = 200_000;

/// A problem, the position of it, and the path of the node it is in.
pub(super) type Found = (Position, Path, Problem);

/// A node of the text.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Node {
    pub(super) at: Position,
    pub(super) content: Content,
}

#[derive(Debug, Clone, PartialEq)]
pub(super) enum Content {
    /// The text of it, unescaped.
    Scalar(String),
    Sequence(Vec<Node>),
    Map(Map),
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
    pub(super) value: Node,
}

impl Map {
    pub(super) fn get(&self, key: &str) -> Option<&Entry> {
        self.by_key.get(key).and_then(|index| self.entries.get(*index))
    }

    fn get_mut(&mut self, key: &str) -> Option<&mut Entry> {
        self.by_key.get(key).and_then(|index| self.entries.get_mut(*index))
    }

    /// In the order of the text.
    pub(super) fn entries(&self) -> &[Entry] {
        &self.entries
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

    /// Every position here and below, of keys too.
    pub(super) fn each_position(&mut self, change: &impl Fn(&mut Position)) {
        change(&mut self.at);
        match &mut self.content {
            Content::Scalar(_) => {}
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

/// The root of every document in a text.
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

/// Builds nodes with a stack of its own, so that no text can exhaust the program's.
#[derive(Default)]
struct Builder {
    documents: Vec<Node>,
    open: Vec<Open>,
    /// How many there are so far.
    values: usize,
}

struct Open {
    at: Position,
    content: Content,
    /// In a map: the key that waits for its value.
    key: Option<(String, Position)>,
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
                self.close(Node { at, content: Content::Scalar(text.into_owned()) });
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
        if let Some(open) = self.open.last_mut() {
            open.key = Some((key, at));
        }
        Ok(())
    }

    fn close(&mut self, node: Node) {
        match self.open.last_mut() {
            None => self.documents.push(node),
            Some(Open { content: Content::Sequence(items), .. }) => items.push(node),
            Some(Open { content: Content::Map(map), key, .. }) => {
                if let Some((key, key_at)) = key.take() {
                    map.by_key.insert(key.clone(), map.entries.len());
                    map.entries.push(Entry { key, key_at, value: node });
                }
            }
            Some(Open { content: Content::Scalar(_), .. }) => {}
        }
    }

    /// `{ mass: 31,5 kg }`: to YAML a value of 31 and, right behind the comma, a key without a value.
    fn decimal_comma(&self) -> Option<Found> {
        let Open { content: Content::Map(map), key: Some((key, key_at)), .. } = self.open.last()? else {
            return None;
        };
        let Entry { key: before, value: Node { at, content: Content::Scalar(text) }, .. } =
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
                (_, Some((key, _))) => path.push(Segment::Key(key.clone())),
                _ => {}
            }
        }
        (at, path, problem)
    }
}
