//! Check that words replaced by those of the field do not return: in code, docs, help texts, book and files.
//!
//! Words are compared whole, without case, across `_`, `-`, a line's end and the humps of a name:
//! `row parameter` is in `RowParameter`, `row_parameter` and `Row parameters`.

use super::{Breach, source::Source};
use std::ops::Range;

/// Word, or sequence of words, that is no longer used.
pub struct Word {
    /// Words in lower case with single blanks; the last one is also found with an `s`.
    pub not: &'static str,
    /// Replacement for the word.
    pub but: &'static str,
    /// Places that are searched for the word.
    pub within: Within,
}

/// Places that are searched for a word.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Within {
    /// Everything that people and callers read.
    All,
    /// Texts read without the code: the book, README, ARCHITECTURE.
    Book,
    /// Names in the code, not its comments and texts.
    Code,
    /// Keys of files and of YAML in the book.
    Keys,
    /// The book, the program and the crates named.
    BookProgramAnd(&'static [&'static str]),
}

use Within::{All, Book, BookProgramAnd, Code, Keys};

const fn word(not: &'static str, but: &'static str, within: Within) -> Word {
    Word { not, but, within }
}

/// Words that are gone.
pub const GONE: &[Word] = &[
    word("efficiency of overrun", "back-driving efficiency", All),
    word("bears itself out", "self-consistent", All),
    word("box of k", "range of k", All),
    word("capacity", "load_rating", Keys),
    word("row parameter", "ring-to-sun ratio", All),
    word("two row", "two sets", All),
    word("tooth_shape", "external gear, internal gear", All),
    word("tooth set", "tooth numbers", Book),
    word("control", "shift element", Book),
    word("control", "shift element", Code),
    word("shift table", "engagement table", All),
    word("stationary ratio", "basic ratio", All),
    word("relative power", "rolling power", All),
    word("reduced inertia", "equivalent inertia", All),
    word("bear themselves out", "self-consistent", All),
    word("locks itself", "self-locking", All),
    word("lock", "direct-drive clutch", Code),
    word("neighbour condition", "clearance between planets", All),
    word("speed plan", "speed diagram", All),
    word("one sense", "same direction of rotation", All),
    word("mixed sense", "mixed direction of rotation", All),
    word("demand", "requirements", BookProgramAnd(&["schemes", "selection"])),
    word("hangs on", "depends on", All),
    word("hang on", "depend on", All),
    word("wheels", "gear_set", Keys),
    word("bearing capacity", "basic dynamic load rating", All),
];

/// Files in which a word may occur, with the reason.
const EXCEPTIONS: &[(&str, &str)] = &[
    // The book's glossary names the words of the sources.
    ("docs/src/glossary.md", "row parameter"),
    ("docs/src/glossary.md", "reduced inertia"),
    ("docs/src/glossary.md", "neighbour condition"),
    // Old keys of files and options are refused with the names of the new ones.
    ("CHANGELOG.md", "bearing capacity"),
    ("CHANGELOG.md", "control"),
    ("CHANGELOG.md", "one sense"),
    ("docs/src/reference/files.md", "bearing capacity"),
    ("docs/src/reference/files.md", "control"),
    ("crates/formats/src/document/renamed.rs", "bearing capacity"),
    // The torque that a clutch can carry is its capacity; the word that has gone is that of bearings.
    ("docs/src/reference/files.md", "capacity"),
    ("docs/src/tutorials/simulate.md", "capacity"),
    ("examples/every-scenario-key.yaml", "capacity"),
    ("examples/power-shift.yaml", "capacity"),
];

/// Names of others that have such a word in them: of the standard library, and of text.
const OF_OTHERS: &[&str] = &[
    "is_control",
    "control character",
    "ControlFlow",
    "ControlCharacter",
    "control-character",
    ".lock()",
    "try_lock",
    "OnceLock",
    "LazyLock",
    "TryLockError",
];

/// Places where a word has returned.
#[must_use]
pub fn check(sources: &[Source]) -> Vec<Breach> {
    found(sources, GONE)
}

/// Places of the given words.
#[must_use]
pub fn found(sources: &[Source], words: &[Word]) -> Vec<Breach> {
    sources.iter().flat_map(|source| of(source, words)).collect()
}

fn of(source: &Source, words: &[Word]) -> Vec<Breach> {
    let read: Vec<&Word> = words.iter().filter(|word| is_within(&source.path, word.within)).collect();
    let mut breaches = Vec::new();
    for word in read {
        if EXCEPTIONS.contains(&(source.path.as_str(), word.not)) {
            continue;
        }
        let text = if word.within == Code { &source.code } else { &source.text };
        for at in places(text, word) {
            let message = format!("`{}`: the word is `{}`", word.not, word.but);
            breaches.push(Breach::new(&source.path, source.line_of(at), message));
        }
    }
    breaches
}

fn is_within(path: &str, within: Within) -> bool {
    let is_book = path.starts_with("docs/src/") || !path.contains('/') || path.ends_with("/README.md");
    let is_code = path.starts_with("crates/") && path.contains("/src/");
    let is_yaml = path.starts_with("examples/") || path.starts_with("docs/src/");
    match within {
        All => is_book || is_code || is_yaml,
        Book => is_book,
        Code => is_code,
        Keys => is_yaml,
        BookProgramAnd(crates) => {
            let of_crate = |name: &str| path.starts_with(&format!("crates/{name}/src/"));
            is_book || of_crate("cli") || crates.iter().any(|name| of_crate(name))
        }
    }
}

/// Where a text has a word.
fn places(text: &str, word: &Word) -> Vec<usize> {
    let wanted: Vec<&str> = word.not.split(' ').collect();
    let parts = parts(text);
    let matches_at = |first: usize| {
        wanted.iter().enumerate().all(|(offset, wanted)| {
            let Some(part) = parts.get(first + offset) else { return false };
            let here = text[part.clone()].to_lowercase();
            let plural = offset + 1 == word.not.split(' ').count() && here.strip_suffix('s') == Some(*wanted);
            let joined = offset == 0 || joins(&text[parts[first + offset - 1].end..part.start]);
            joined && (here == *wanted || plural)
        }) && (word.within != Keys || is_key(text, parts[first].start, parts[first + wanted.len() - 1].end))
    };
    let starts = (0..parts.len()).filter(|first| matches_at(*first)).map(|first| parts[first].start);
    starts.filter(|start| !OF_OTHERS.iter().any(|name| stands_in(text, *start, name))).collect()
}

/// Whether a place of a text is within a name.
fn stands_in(text: &str, place: usize, name: &str) -> bool {
    (0..name.len()).any(|before| {
        place.checked_sub(before).is_some_and(|start| text.as_bytes()[start..].starts_with(name.as_bytes()))
    })
}

/// Whether what is between two parts joins them to one term.
fn joins(between: &str) -> bool {
    let has_end = between.contains('\n');
    between.chars().all(|c| matches!(c, ' ' | '_' | '-' | '\n') || (has_end && matches!(c, '/' | '!')))
}

/// Whether a part is a YAML key.
fn is_key(text: &str, start: usize, end: usize) -> bool {
    let before = text[..start].rsplit('\n').next().unwrap_or("");
    text[end..].starts_with(':')
        && before.trim_end().chars().last().is_none_or(|last| matches!(last, '-' | '{' | ',' | '`'))
}

/// The words of a text, the humps of its names apart.
fn parts(text: &str) -> Vec<Range<usize>> {
    let mut found: Vec<Range<usize>> = Vec::new();
    let mut before = ' ';
    for (at, c) in text.char_indices() {
        if c.is_alphanumeric() {
            let hump = before.is_lowercase() && c.is_uppercase();
            match found.last_mut() {
                Some(last) if before.is_alphanumeric() && !hump => last.end = at + c.len_utf8(),
                _ => found.push(at..at + c.len_utf8()),
            }
        }
        before = c;
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    const WORDS: &[Word] = &[
        word("row parameter", "ring-to-sun ratio", All),
        word("control", "shift element", Code),
        word("wheels", "gear_set", Keys),
    ];

    fn count(path: &str, text: &str) -> usize {
        found(&[Source::new(path, text)], WORDS).len()
    }

    #[test]
    fn a_word_is_found_in_every_spelling() {
        for text in [
            "row parameter",
            "Row-parameters",
            "RowParameter::new",
            "its row_parameter",
            "a row\n/// parameter",
        ] {
            assert_eq!(count("crates/gears/src/a.rs", text), 1, "{text}");
        }
    }

    #[test]
    fn other_words_are_not() {
        for text in ["row. Parameter", "the row", "arrow parameter", "row parametric"] {
            assert_eq!(count("crates/gears/src/a.rs", text), 0, "{text}");
        }
        assert_eq!(count("xtask/src/a.rs", "row parameter"), 0);
    }

    #[test]
    fn a_name_is_looked_for_in_code_and_a_key_where_keys_stand() {
        assert_eq!(count("crates/gears/src/a.rs", "fn controls() {} // under control"), 1);
        assert_eq!(
            count("crates/gears/src/a.rs", "fn a(c: char) { c.is_control(); Problem::ControlCharacter }"),
            0
        );
        assert_eq!(count("docs/src/a.md", "under control"), 0);
        assert_eq!(count("examples/a.yaml", "wheels: { sun: 12 }\n# wheels turn: they do\n"), 1);
    }
}
