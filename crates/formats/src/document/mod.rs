//! YAML documents that know where everything stands.
//!
//! Values come from one parser and positions from another, run over the same bytes; where the two would see a
//! different structure the document is refused. Also refused, each by name: repeated keys, merge keys,
//! anchors and aliases, tags, and numbers that are not finite.

mod index;
pub(crate) mod path;
pub(crate) mod position;
mod reader;
mod renamed;
mod renumbered;
mod words;

use std::borrow::Cow;
use std::sync::Arc;

use serde::de::DeserializeOwned;

use self::{
    index::{Content, Node},
    reader::{Fault, Reader},
};
pub use self::{
    path::{Path, Segment},
    position::Position,
};
use crate::{
    error::{Error, Place, Problem},
    yaml::{self, Value},
};
use epicyclic_units::QuantityError;
pub use renamed::RENAMED;

/// The most bytes that a file may have. A description of a gearbox has some thousands; what is far beyond is
/// not one.
pub const SIZE_LIMIT: u64 = 4 << 20;

/// A YAML document: its value, and the position of each key and value in it.
#[derive(Debug, Clone, PartialEq)]
pub struct Document {
    file: Arc<str>,
    value: Value,
    root: Node,
}

impl Document {
    /// Every document of a file; they are parted by `---`. There is at least one.
    ///
    /// # Errors
    /// More than [`SIZE_LIMIT`] bytes, bytes that are not UTF-8, invisible characters, nothing to read,
    /// broken syntax, and whatever this module refuses.
    pub fn parse_all(file_name: &str, bytes: &[u8]) -> Result<Vec<Self>, Error> {
        let file: Arc<str> = file_name.into();
        let size = bytes.len() as u64;
        if size > SIZE_LIMIT {
            return Err(too_large(file_name, Some(size)));
        }
        let fail = |(position, path, problem)| {
            Error::new(Place { file: Arc::clone(&file), position, path }, problem)
        };
        let at_root = |position, problem| fail((position, Path::root(), problem));

        let text = decode(bytes).map_err(|(position, problem)| at_root(position, problem))?;
        let text = &*joined_surrogates(text);
        let roots = index::documents(text).map_err(fail)?;
        if roots.is_empty() {
            return Err(at_root(Position::START, Problem::EmptyFile));
        }
        let values = yaml::parse_stream(text).map_err(|refusal| {
            let position = refusal.line_column.map(|(line, column)| Position { line, column });
            at_root(position.unwrap_or(Position::START), Problem::Syntax { message: refusal.message })
        })?;
        if values.len() != roots.len() {
            let extra = roots.get(values.len()).map_or(Position::START, |root| root.at);
            return Err(at_root(extra, Problem::ReadTwoWays));
        }
        if values.iter().all(Value::is_null) {
            return Err(at_root(Position::START, Problem::EmptyFile));
        }
        values
            .into_iter()
            .zip(roots)
            .map(|(value, root)| {
                if value.is_null() {
                    return Err(at_root(root.at, Problem::EmptyDocument));
                }
                compare(&value, &root, &mut Path::root()).map_err(fail)?;
                Ok(Self { file: Arc::clone(&file), value, root })
            })
            .collect()
    }

    /// The only document of a file.
    ///
    /// # Errors
    /// Those of [`Document::parse_all`], and [`Problem::SeveralDocuments`].
    pub fn parse_one(file_name: &str, bytes: &[u8]) -> Result<Self, Error> {
        let mut documents = Self::parse_all(file_name, bytes)?;
        match documents.get(1) {
            Some(second) => {
                Err(second.error(&Path::root(), Problem::SeveralDocuments { count: documents.len() }))
            }
            // There is always one.
            None => Ok(documents.swap_remove(0)),
        }
    }

    /// The file's name.
    #[must_use]
    pub fn file(&self) -> &str {
        &self.file
    }

    /// The whole value.
    #[must_use]
    pub fn value(&self) -> &Value {
        &self.value
    }

    /// The value at a path.
    #[must_use]
    pub fn value_at(&self, path: &Path) -> Option<&Value> {
        path.segments().iter().try_fold(&self.value, |value, segment| step(value, segment))
    }

    /// The text of a scalar exactly as written, but for quotes and escapes: `2.940`, where the value is 2.94.
    #[must_use]
    pub fn text_at(&self, path: &Path) -> Option<&str> {
        match &path.segments().iter().try_fold(&self.root, Node::step)?.content {
            Content::Scalar(text) => Some(text),
            Content::Sequence(_) | Content::Map(_) => None,
        }
    }

    /// Where the value at `path` stands, or else its nearest ancestor. A map stands where its first key does,
    /// or its brace; a value left out stands where its key does.
    #[must_use]
    pub fn position(&self, path: &Path) -> Position {
        self.nearest(path).at
    }

    /// Where the last key of `path` stands; for an index or an unknown key, the same as
    /// [`Document::position`].
    #[must_use]
    pub fn key_position(&self, path: &Path) -> Position {
        let mut parent = path.clone();
        let key = parent.pop();
        if let (Some(Segment::Key(key)), Some(node)) =
            (key, parent.segments().iter().try_fold(&self.root, Node::step))
            && let Content::Map(map) = &node.content
            && let Some(entry) = map.get(&key)
        {
            return entry.key_at;
        }
        self.position(path)
    }

    /// An error at a path of this document, for what only the caller can judge.
    #[must_use]
    pub fn error(&self, path: &Path, problem: Problem) -> Error {
        self.error_at(self.position(path), path.clone(), problem)
    }

    /// The document as a `T`.
    ///
    /// # Errors
    /// The first thing wrong with it, with its place.
    pub fn read<T: DeserializeOwned>(&self) -> Result<T, Error> {
        self.read_value(&self.value, &Path::root())
    }

    /// What stands at `path` as a `T`.
    ///
    /// # Errors
    /// As [`Document::read`]; [`Problem::MissingKey`] if nothing stands there.
    pub fn read_at<T: DeserializeOwned>(&self, path: &Path) -> Result<T, Error> {
        if let Some(value) = self.value_at(path) {
            return self.read_value(value, path);
        }
        let mut parent = path.clone();
        let mut missing = String::new();
        while self.value_at(&parent).is_none() {
            match parent.pop() {
                Some(Segment::Key(key)) => missing = key,
                Some(Segment::Index(index)) => missing = format!("[{index}]"),
                None => break,
            }
        }
        Err(self.error(&parent, Problem::MissingKey { key: missing }))
    }

    /// A value made from the one at `base` as a `T`; positions are those of this document. What has no place
    /// in it, since the caller put it there, gets that of its nearest ancestor.
    ///
    /// # Errors
    /// As [`Document::read`].
    pub fn read_value<T: DeserializeOwned>(&self, value: &Value, base: &Path) -> Result<T, Error> {
        serde_path_to_error::deserialize(Reader(value)).map_err(|error| {
            let mut path = base.clone();
            let mut node = Some(value);
            for segment in error.path() {
                use serde_path_to_error::Segment as Theirs;
                let segment = match segment {
                    Theirs::Seq { index } => Segment::Index(*index),
                    Theirs::Map { key } => Segment::Key(key.clone()),
                    // A name on its own is not a step into anything.
                    Theirs::Enum { variant } if node.is_some_and(Value::is_mapping) => {
                        Segment::Key(variant.clone())
                    }
                    Theirs::Enum { .. } | Theirs::Unknown => continue,
                };
                node = node.and_then(|node| step(node, &segment));
                path.push(segment);
            }
            let Fault(problem) = error.into_inner();
            let position = match &*problem {
                Problem::UnknownKey { .. } | Problem::RenamedKey { .. } | Problem::DuplicateKey { .. } => {
                    self.key_position(&path)
                }
                Problem::UnknownName { found, .. } if node.is_some_and(Value::is_mapping) => {
                    path.push(Segment::Key(found.clone()));
                    self.key_position(&path)
                }
                _ => self.position(&path),
            };
            self.error_at(position, path, *problem)
        })
    }

    fn error_at(&self, position: Position, path: Path, problem: Problem) -> Error {
        Error::new(Place { file: Arc::clone(&self.file), position, path }, problem)
    }

    fn nearest(&self, path: &Path) -> &Node {
        let mut node = &self.root;
        for segment in path.segments() {
            match node.step(segment) {
                Some(next) => node = next,
                None => break,
            }
        }
        node
    }
}

/// The error for a file of more than [`SIZE_LIMIT`] bytes, for who reads no further; with the size, if it is
/// known.
#[must_use]
pub fn too_large(file_name: &str, size: Option<u64>) -> Error {
    let place = Place { file: file_name.into(), position: Position::START, path: Path::root() };
    Error::new(place, Problem::TooLarge { limit: SIZE_LIMIT, size })
}

fn step<'a>(value: &'a Value, segment: &Segment) -> Option<&'a Value> {
    match (value, segment) {
        (Value::Mapping(map), Segment::Key(key)) => map.get(key.as_str()).or_else(|| {
            map.iter().find(|(other, _)| words::scalar(other).as_deref() == Some(key)).map(|(_, value)| value)
        }),
        (Value::Sequence(items), Segment::Index(index)) => items.get(*index),
        _ => None,
    }
}

/// The text of a file, without its byte order mark.
fn decode(bytes: &[u8]) -> Result<&str, (Position, Problem)> {
    let text = std::str::from_utf8(bytes).map_err(|error| {
        let offset = error.valid_up_to();
        let before = String::from_utf8_lossy(&bytes[..offset]);
        (end_of(before.trim_start_matches('\u{feff}')), Problem::NotUtf8 { offset })
    })?;
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    match text.char_indices().find(|(_, c)| is_invisible(*c)) {
        Some((at, c)) => Err((end_of(&text[..at]), Problem::ControlCharacter { code: u32::from(c) })),
        None => Ok(text),
    }
}

/// JSON with each pair of surrogates in its strings, `\ud83d\ude00`, as the one escape that YAML has for it,
/// `\U0001f600`; two columns shorter. Of what does not begin as JSON does nothing changes.
fn joined_surrogates(text: &str) -> Cow<'_, str> {
    if !text.trim_start().starts_with(['{', '[']) || !text.contains("\\u") && !text.contains("\\U") {
        return Cow::Borrowed(text);
    }
    let unit = |at: usize| {
        let escape = text.get(at..at + 6)?.strip_prefix("\\u")?;
        u16::from_str_radix(escape, 16).ok()
    };
    let mut joined = String::with_capacity(text.len());
    let mut quote = None;
    let mut at = 0;
    while let Some(character) = text[at..].chars().next() {
        let mut length = character.len_utf8();
        let pair = || Some([unit(at)?, unit(at + 6)?]);
        match (quote, character) {
            (Some('"'), '\\') => {
                let pair = pair()
                    .and_then(|pair| char::decode_utf16(pair).next()?.ok())
                    .filter(|one| *one > '\u{ffff}');
                if let Some(one) = pair {
                    joined.push_str(&format!("\\U{:08x}", u32::from(one)));
                    at += 12;
                    continue;
                }
                // What is escaped ends nothing.
                length += text[at + length..].chars().next().map_or(0, char::len_utf8);
            }
            (None, '"' | '\'') => quote = Some(character),
            (None, '#') => length = text[at..].find('\n').unwrap_or(text.len() - at),
            (Some(open), _) if open == character => quote = None,
            _ => {}
        }
        joined.push_str(&text[at..at + length]);
        at += length;
    }
    Cow::Owned(joined)
}

/// Characters that show nothing, of which some end a line for one YAML parser and not for another.
const fn is_invisible(c: char) -> bool {
    matches!(c, '\0'..='\u{8}' | '\u{b}' | '\u{c}' | '\u{e}'..='\u{1f}' | '\u{7f}'..='\u{9f}' | '\u{2028}' | '\u{2029}' | '\u{feff}')
}

fn end_of(text: &str) -> Position {
    let last = text.rsplit('\n').next().unwrap_or_default();
    Position { line: text.matches('\n').count() + 1, column: last.chars().count() + 1 }
}

/// Holds the value against the text's own structure, and refuses numbers that are not finite.
fn compare(value: &Value, node: &Node, path: &mut Path) -> Result<(), index::Found> {
    let two_ways = |path: &Path| (node.at, path.clone(), Problem::ReadTwoWays);
    match (value, &node.content) {
        (Value::Sequence(values), Content::Sequence(nodes)) if values.len() == nodes.len() => {
            for (index, (value, node)) in values.iter().zip(nodes).enumerate() {
                path.push(Segment::Index(index));
                compare(value, node, path)?;
                path.pop();
            }
            Ok(())
        }
        (Value::Mapping(values), Content::Map(nodes)) if values.len() == nodes.entries().len() => {
            // Both in the order of the text. A key that YAML takes for a number may not look as written:
            // `0x10`.
            for ((key, value), entry) in values.iter().zip(nodes.entries()) {
                if key.as_str().is_some_and(|key| key != entry.key) || words::scalar(key).is_none() {
                    return Err(two_ways(path));
                }
                path.push(Segment::Key(entry.key.clone()));
                refuse_infinite(key, entry.key_at, path)?;
                compare(value, &entry.value, path)?;
                path.pop();
            }
            Ok(())
        }
        (Value::Sequence(_) | Value::Mapping(_) | Value::Tagged(_), _) => Err(two_ways(path)),
        (_, Content::Scalar(_)) => refuse_infinite(value, node.at, path),
        (_, Content::Sequence(_) | Content::Map(_)) => Err(two_ways(path)),
    }
}

fn refuse_infinite(value: &Value, at: Position, path: &Path) -> Result<(), index::Found> {
    match value {
        Value::Number(number) if !number.is_finite() => {
            Err((at, path.clone(), QuantityError::NotFinite { text: number.to_string() }.into()))
        }
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests;
