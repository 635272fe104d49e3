//! Faults of documents and their places.

use std::{fmt, sync::Arc};

use crate::document::{path::Path, position::Position};
use epicyclic_units::{QuantityError, visible::one_line};

/// The faults of a document, each a [`Problem`] at its [`Place`]. Displays each on a line as
/// `file.yaml:12:7: given.power: 106,5 kW: decimal comma; write 106.5 kW`.
#[derive(Debug, Clone, PartialEq)]
pub struct Error(Box<(Fault, Vec<Fault>)>);

/// A problem at its place.
#[derive(Debug, Clone, PartialEq)]
pub struct Fault {
    /// Place of the wrong value or key.
    pub at: Place,
    /// Problem of the value or key.
    pub problem: Problem,
    /// Text of the wrong value, or of the wrong key, as written in the file; `None` for lists, maps and
    /// missing keys.
    pub value: Option<String>,
}

impl Fault {
    /// A fault at a place with a value of this text.
    pub(crate) fn new(at: Place, problem: Problem, value: Option<&str>) -> Self {
        let value = match &problem {
            Problem::UnknownKey { key, .. } | Problem::RenamedKey { key, .. } => Some(key.as_str()),
            // Within braces the text is two entries.
            Problem::Quantity(QuantityError::DecimalComma { text, .. }) => Some(text.as_str()),
            Problem::MissingKey { .. } => None,
            _ => value,
        };
        let value = value.map(str::to_owned);
        Self { at, problem, value }
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // Names in a file may hold any characters; a message stays one line that shows all of them.
        f.write_str(&one_line(&format!("{}: {}", self.at, self.problem)))
    }
}

impl Error {
    pub(crate) fn new(at: Place, problem: Problem) -> Self {
        Fault::new(at, problem, None).into()
    }

    /// An error of several faults, in this order. Without any it is an empty file.
    pub(crate) fn all(faults: Vec<Fault>) -> Self {
        let mut faults = faults.into_iter();
        let empty = Place { file: "".into(), position: Position::START, path: Path::root() };
        let first = faults.next().unwrap_or_else(|| Fault::new(empty, Problem::EmptyFile, None));
        Self(Box::new((first, faults.collect())))
    }

    /// Faults in the order of their positions.
    pub fn faults(&self) -> impl Iterator<Item = &Fault> {
        let (first, others) = &*self.0;
        std::iter::once(first).chain(others)
    }

    /// Place of the first fault.
    #[must_use]
    pub fn at(&self) -> &Place {
        &self.0.0.at
    }

    /// Problem of the first fault.
    #[must_use]
    pub fn problem(&self) -> &Problem {
        &self.0.0.problem
    }

    /// Name of the first problem, which does not change: `unknown-key`.
    #[must_use]
    pub fn name(&self) -> &'static str {
        self.problem().name()
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (number, fault) in self.faults().enumerate() {
            write!(f, "{}{fault}", if number > 0 { "\n" } else { "" })?;
        }
        Ok(())
    }
}

impl From<Fault> for Error {
    fn from(fault: Fault) -> Self {
        Self(Box::new((fault, vec![])))
    }
}

// No `source`: the message already says all the problem says.
impl std::error::Error for Error {}

/// A file, a position in it, and the path to the node there. Displays as `file.yaml:12:7: given.power`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Place {
    /// The file's name, as given by the caller.
    pub file: Arc<str>,
    /// Line and column.
    pub position: Position,
    /// From the root of the document; empty for the root itself, and for what precedes any structure.
    pub path: Path,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}", self.file, self.position)?;
        if self.path.is_root() { Ok(()) } else { write!(f, ": {}", self.path) }
    }
}

/// Problem of a document.
#[derive(Debug, Clone, PartialEq, thiserror::Error, strum::IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum Problem {
    /// Bytes that are not UTF-8.
    #[error("not UTF-8 text (byte {offset} of the file); save the file as UTF-8")]
    NotUtf8 {
        /// Offset of the first bad byte, from 0.
        offset: usize,
    },
    /// A control character, or another that shows nothing.
    #[error("an invisible character, U+{code:04X}; remove it")]
    ControlCharacter {
        /// Code point of the character.
        code: u32,
    },
    /// More bytes than a document may have.
    #[error("the file is larger than {limit} bytes{}; a description is text and far smaller", has(*size))]
    TooLarge {
        /// The most that is read: [`crate::document::SIZE_LIMIT`].
        limit: u64,
        /// How many there are, if that is known.
        size: Option<u64>,
    },
    /// No document in the file.
    #[error("the file is empty; write a document in it")]
    EmptyFile,
    /// Nothing between two `---`, or a document that is `null`.
    #[error("the document is empty; remove its `---` or write the document")]
    EmptyDocument,
    /// More documents than the one due.
    #[error("the file has {count} documents, and one is due; remove this one and those after it")]
    SeveralDocuments {
        /// How many there are.
        count: usize,
    },
    /// Not YAML.
    #[error("not YAML: {message}")]
    Syntax {
        /// Message of the parser.
        message: String,
    },
    /// Maps and sequences within each other beyond reason.
    #[error("nested deeper than {limit} levels")]
    TooDeep {
        /// How deep is allowed.
        limit: usize,
    },
    /// More values than a description may have.
    #[error("the file has more than {limit} values")]
    TooManyValues {
        /// How many are allowed.
        limit: usize,
    },
    /// A key written twice in one map.
    #[error("the key {key} is written twice, first at {first}; remove one")]
    DuplicateKey {
        /// The key.
        key: String,
        /// Line and column of the first.
        first: Position,
    },
    /// A key that is a map or a sequence.
    #[error("a key must be plain text, not a map or a sequence")]
    ComplexKey,
    /// `<<`.
    #[error("merge keys (`<<`) are not understood; write the keys themselves")]
    MergeKey,
    /// `&anchor` or `*alias`, which would hide where a value is written.
    #[error("anchors and aliases are not understood; write the value itself")]
    Anchor,
    /// `!tag`.
    #[error("the tag {tag} is not understood; remove it, and put the value in quotes if it is to stay text")]
    Tag {
        /// The tag as written, or `!` and its name.
        tag: String,
    },
    /// A key that is not known here.
    #[error("unknown key {key}{}; allowed: {}", suggestion(key, allowed), list(allowed))]
    UnknownKey {
        /// The key.
        key: String,
        /// The keys known here.
        allowed: Vec<String>,
    },
    /// A key that has another name today.
    #[error("the key {key} is now {new}; write {new}")]
    RenamedKey {
        /// The key.
        key: String,
        /// Name of the key today.
        new: String,
    },
    /// A key that must be here.
    #[error("the key {key} is missing")]
    MissingKey {
        /// The key.
        key: String,
    },
    /// A name that is none of those allowed.
    #[error("unknown name {found}{}; allowed: {}", suggestion(found, allowed), list(allowed))]
    UnknownName {
        /// The name.
        found: String,
        /// The names known here.
        allowed: Vec<String>,
    },
    /// Text for a number, a number for a map, and so on.
    #[error("{found} where {expected} is due{}", or_write(correction.as_deref()))]
    WrongType {
        /// Value in the file, in words.
        found: String,
        /// Allowed values, in words.
        expected: String,
        /// Text to write instead, if it is known.
        correction: Option<String>,
    },
    /// A value of the right type that is out of its range.
    #[error("{found} where {expected} is due")]
    OutOfRange {
        /// Value in the file, in words.
        found: String,
        /// Allowed values, in words.
        expected: String,
    },
    /// A sequence or map with too few or too many entries.
    #[error("{found} entries where {expected} are due")]
    WrongLength {
        /// How many there are.
        found: usize,
        /// Allowed values, in words.
        expected: String,
    },
    /// A value that its type or a calculation refuses.
    #[error("{message}")]
    Refused {
        /// The name of the fault, which does not change with the message: `cyclic-grounds`.
        name: &'static str,
        /// Reason of the refusal.
        message: String,
        /// Text that would be right here, if it is known.
        remedy: Option<String>,
    },
    /// A fault of a number or quantity.
    #[error(transparent)]
    Quantity(#[from] QuantityError),
}

impl Problem {
    /// A refusal by its name, and why.
    #[must_use]
    pub fn refused(name: &'static str, message: impl Into<String>) -> Self {
        Self::Refused { name, message: message.into(), remedy: None }
    }

    /// Text to write in place of the wrong value or key, if it is known.
    #[must_use]
    pub fn remedy(&self) -> Option<&str> {
        match self {
            Self::UnknownKey { key: text, allowed } | Self::UnknownName { found: text, allowed } => {
                nearest(text, allowed).filter(|_| !is_after_comma(text))
            }
            Self::RenamedKey { new, .. } => Some(new),
            Self::WrongType { correction, .. } => {
                let text = correction.as_deref()?;
                let known = [" for an empty one", " for one entry", ", in quotes"].into_iter();
                Some(known.fold(text, |text, reason| text.strip_suffix(reason).unwrap_or(text)))
            }
            Self::Refused { remedy, .. } => remedy.as_deref(),
            Self::Quantity(error) => error.corrected(),
            _ => None,
        }
    }

    /// The name of the fault, which does not change: `unknown-key`; of a quantity or a calculation that of
    /// its error.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Refused { name, .. } => name,
            Self::Quantity(error) => error.name(),
            named => named.into(),
        }
    }
}

fn has(size: Option<u64>) -> String {
    size.map(|size| format!(": it has {size}")).unwrap_or_default()
}

/// The one of `allowed` most like `text`, if one is like it at all.
#[must_use]
pub fn nearest<'a>(text: &str, allowed: &'a [String]) -> Option<&'a str> {
    let likeness = |candidate: &str| {
        strsim::normalized_damerau_levenshtein(&candidate.to_lowercase(), &text.to_lowercase())
    };
    let best = allowed.iter().max_by(|a, b| likeness(a).total_cmp(&likeness(b)))?;
    (likeness(best) >= 0.5).then_some(best)
}

/// Whether a key is the rest of a decimal: `efficiency: 0,99` within braces is two entries.
fn is_after_comma(key: &str) -> bool {
    !key.is_empty() && key.bytes().all(|byte| byte.is_ascii_digit())
}

fn suggestion(text: &str, allowed: &[String]) -> String {
    if is_after_comma(text) {
        return "; a comma parts entries: write a decimal point before these digits?".to_owned();
    }
    nearest(text, allowed).map(|best| format!("; write {best}?")).unwrap_or_default()
}

fn list(allowed: &[String]) -> String {
    if allowed.is_empty() { "none".to_owned() } else { allowed.join(", ") }
}

fn or_write(correction: Option<&str>) -> String {
    correction.map(|text| format!("; write {text}")).unwrap_or_default()
}
