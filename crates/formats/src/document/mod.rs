//! YAML documents with the place of every key and value.
//!
//! One parser makes a tree of nodes with places, and every type is read from this tree. Repeated keys, merge
//! keys, anchors and aliases, tags, and numbers that are not finite are refused, each by name.

mod fault;
mod filled;
pub(crate) mod path;
pub(crate) mod position;
mod reader;
mod renamed;
mod renumbered;
mod tree;
mod words;

use std::borrow::Cow;
use std::sync::{Arc, OnceLock};

use serde::de::DeserializeOwned;

use self::tree::{Content, Node};
pub use self::{
    path::{Path, Segment},
    position::Position,
};
use crate::{
    error::{Error, Fault, Place, Problem},
    yaml::Value,
};
pub(crate) use filled::LIST;
pub use renamed::RENAMED;

/// The most bytes that a file may have. A description of a gearbox has some thousands; what is far beyond is
/// not one.
pub const SIZE_LIMIT: u64 = 4 << 20;

/// A YAML document with the place of each key and value.
#[derive(Debug, Clone)]
pub struct Document {
    file: Arc<str>,
    root: Node,
    /// The root without places, made when it is first asked for.
    value: OnceLock<Value>,
}

impl PartialEq for Document {
    fn eq(&self, other: &Self) -> bool {
        (&self.file, &self.root) == (&other.file, &other.root)
    }
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
        let roots = tree::documents(text).map_err(fail)?;
        if roots.iter().all(Node::is_null) {
            return Err(at_root(Position::START, Problem::EmptyFile));
        }
        if let Some(root) = roots.iter().find(|root| root.is_null()) {
            return Err(at_root(root.at, Problem::EmptyDocument));
        }
        let document = |root| Self { file: Arc::clone(&file), root, value: OnceLock::new() };
        Ok(roots.into_iter().map(document).collect())
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
        self.value.get_or_init(|| self.root.value())
    }

    /// The value at a path.
    #[must_use]
    pub fn value_at(&self, path: &Path) -> Option<&Value> {
        path.segments().iter().try_fold(self.value(), |value, segment| step(value, segment))
    }

    /// Whether there is a value at a path.
    #[must_use]
    pub fn has(&self, path: &Path) -> bool {
        path.segments().iter().try_fold(&self.root, Node::step).is_some()
    }

    /// The text of a scalar exactly as written, but for quotes and escapes: `2.940`, where the value is 2.94.
    #[must_use]
    pub fn text_at(&self, path: &Path) -> Option<&str> {
        self.root.text_at(path)
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
        self.fault(path.clone(), problem).into()
    }

    /// A fault at a path of this document.
    pub(crate) fn fault(&self, path: Path, problem: Problem) -> Fault {
        let value = self.root.text_at(&path);
        Fault::new(self.place(self.position(&path), path), problem, value)
    }

    fn place(&self, position: Position, path: Path) -> Place {
        Place { file: Arc::clone(&self.file), position, path }
    }

    /// The document as a `T`.
    ///
    /// # Errors
    /// All independent faults with their places.
    pub fn read<T: DeserializeOwned>(&self) -> Result<T, Error> {
        self.read_node(&self.root, &Path::root())
    }

    /// The value at `path` as a `T`.
    ///
    /// # Errors
    /// Those of [`Document::read`]; [`Problem::MissingKey`] if there is no such value.
    pub fn read_at<T: DeserializeOwned>(&self, path: &Path) -> Result<T, Error> {
        let mut node = &self.root;
        for (depth, segment) in path.segments().iter().enumerate() {
            let Some(next) = node.step(segment) else {
                let key = match segment {
                    Segment::Key(key) => key.clone(),
                    Segment::Index(index) => format!("[{index}]"),
                };
                let parent = path.segments()[..depth].iter().cloned().collect();
                return Err(Error::new(self.place(node.at, parent), Problem::MissingKey { key }));
            };
            node = next;
        }
        self.read_node(node, path)
    }

    /// A changed copy of the value at `base` as a `T`, with the places of this document. A part that this
    /// document lacks has the place of its nearest ancestor.
    ///
    /// # Errors
    /// Those of [`Document::read`].
    pub fn read_value<T: DeserializeOwned>(&self, value: &Value, base: &Path) -> Result<T, Error> {
        let own = base.segments().iter().try_fold(&self.root, Node::step);
        self.read_node(&Node::placed(self.position(base), value, own), base)
    }

    fn read_node<T: DeserializeOwned>(&self, node: &Node, base: &Path) -> Result<T, Error> {
        reader::read(node).map_err(|faults| {
            let faults = faults.into_iter().map(|(position, path, problem)| {
                Fault::new(self.place(position, base.join(&path)), problem, node.text_at(&path))
            });
            Error::all(faults.collect())
        })
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
        (Value::Mapping(map), Segment::Key(key)) => map
            .get(key.as_str())
            .or_else(|| map.iter().find(|(other, _)| tree::scalar(other).1 == *key).map(|(_, value)| value)),
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

#[cfg(test)]
mod tests;
