//! Change of a number in a document without parsing all of the document again.

use std::sync::OnceLock;

use super::Document;
use super::path::{Path, Segment};
use super::position::Position;
use super::tree::{Content, Node, Scalar};

impl Document {
    /// Replaces a plain decimal number at a place by another one and shifts the places behind it. Returns
    /// `false` and changes nothing where the old or the new text is no such number; the caller then parses
    /// the text again.
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
        let Some(node) =
            path.segments().iter().try_fold(&mut self.root, |node, segment| node.step_mut(segment))
        else {
            return false;
        };
        let Content::Scalar(scalar, text) = &mut node.content else { return false };
        // A number in quotes is a text.
        if *scalar == Scalar::Text || self::number(text).as_ref() != Some(scalar) {
            return false;
        }
        let by = to.len() as isize - text.len() as isize;
        to.clone_into(text);
        *scalar = number;
        let behind = |position: &mut Position| {
            if position.line == at.line && position.column > at.column {
                position.column = position.column.saturating_add_signed(by);
            }
        };
        self.value = OnceLock::new();
        self.root.each_position(&behind);
        true
    }
}

/// Number in plain digits, with a decimal point or without.
fn number(text: &str) -> Option<Scalar> {
    let are_digits =
        |text: &str| !text.is_empty() && text.len() <= 9 && text.bytes().all(|byte| byte.is_ascii_digit());
    let is_whole = |text: &str| are_digits(text) && (text == "0" || !text.starts_with('0'));
    match text.split_once('.') {
        None if is_whole(text) => text.parse::<u64>().ok().map(Scalar::Whole),
        Some((whole, part)) if is_whole(whole) && are_digits(part) => {
            text.parse::<f64>().ok().map(Scalar::Number)
        }
        _ => None,
    }
}

/// Finds the scalar at a position and completes the path to it.
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
        Content::Scalar(..) => node.at == at,
        Content::Sequence(items) => {
            items.iter().enumerate().any(|(index, item)| into(Segment::Index(index), item))
        }
        Content::Map(map) => {
            map.entries().iter().any(|entry| into(Segment::Key(entry.key.clone()), &entry.value))
        }
    }
}
