//! Another number in a document that was read, without reading all of it again.

use super::Document;
use super::index::{Content, Node};
use super::path::{Path, Segment};
use super::position::Position;
use crate::yaml::Value;

impl Document {
    /// The document of the same text with another number at a place, where that is all that changes: a plain
    /// number in decimals, before and after. Otherwise nothing changes, and the text is to be read anew.
    ///
    /// ```
    /// use epicyclic_formats::{Document, Path, Position};
    ///
    /// let mut document = Document::parse_one("g.yaml", b"{ k: 2.94, z: 20 }")?;
    /// assert!(document.renumber(Position { line: 1, column: 6 }, "3.125"));
    /// assert_eq!(document.text_at(&Path::root().key("k")), Some("3.125"));
    /// assert_eq!(document.position(&Path::root().key("z")), Position { line: 1, column: 16 });
    /// assert!(!document.renumber(Position { line: 1, column: 6 }, "none"));
    /// # Ok::<(), epicyclic_formats::Error>(())
    /// ```
    #[must_use]
    pub fn renumber(&mut self, at: Position, to: &str) -> bool {
        let Some(number) = number(to) else { return false };
        let mut path = Path::root();
        if !find(&self.root, at, &mut path) {
            return false;
        }
        let Some(value) =
            path.segments().iter().try_fold(&mut self.value, |value, segment| step(value, segment))
        else {
            return false;
        };
        let Some(node) =
            path.segments().iter().try_fold(&mut self.root, |node, segment| node.step_mut(segment))
        else {
            return false;
        };
        let Content::Scalar(text) = &mut node.content else { return false };
        // In quotes it would be a text.
        if !value.is_number() || self::number(text).as_ref() != Some(value) {
            return false;
        }
        let by = to.len() as isize - text.len() as isize;
        to.clone_into(text);
        *value = number;
        let behind = |position: &mut Position| {
            if position.line == at.line && position.column > at.column {
                position.column = position.column.saturating_add_signed(by);
            }
        };
        self.root.each_position(&behind);
        true
    }
}

/// A number as every reader of YAML takes it: digits, with a decimal point or without.
fn number(text: &str) -> Option<Value> {
    let are_digits =
        |text: &str| !text.is_empty() && text.len() <= 9 && text.bytes().all(|byte| byte.is_ascii_digit());
    let is_whole = |text: &str| are_digits(text) && (text == "0" || !text.starts_with('0'));
    match text.split_once('.') {
        None if is_whole(text) => text.parse::<u64>().ok().map(Value::from),
        Some((whole, part)) if is_whole(whole) && are_digits(part) => {
            text.parse::<f64>().ok().map(Value::from)
        }
        _ => None,
    }
}

/// The path of the scalar at a position.
fn find(node: &Node, at: Position, path: &mut Path) -> bool {
    let mut into = |segment: Segment, node: &Node| {
        path.push(segment);
        let is_found = find(node, at, path);
        if !is_found {
            path.pop();
        }
        is_found
    };
    match &node.content {
        Content::Scalar(_) => node.at == at,
        Content::Sequence(items) => {
            items.iter().enumerate().any(|(index, item)| into(Segment::Index(index), item))
        }
        Content::Map(map) => {
            map.entries().iter().any(|entry| into(Segment::Key(entry.key.clone()), &entry.value))
        }
    }
}

fn step<'a>(value: &'a mut Value, segment: &Segment) -> Option<&'a mut Value> {
    match (value, segment) {
        (Value::Mapping(map), Segment::Key(key)) => map.get_mut(key.as_str()),
        (Value::Sequence(items), Segment::Index(index)) => items.get_mut(*index),
        _ => None,
    }
}
