//! One value of a scenario in place of another.

use crate::document::Segment;
use crate::yaml::Value;
use crate::{Document, Path};

/// The path that a key with its entries means: `shifts[0].overlap`, or of an entry by its name
/// `elements[C].holding`.
///
/// # Errors
/// Why it is none, in words.
pub fn path_of(document: &Document, key: &str) -> Result<Path, String> {
    let form = || format!("{key}: write a key of the file as shifts[0].overlap or elements[C].holding");
    let mut path = Path::root();
    for part in key.split('.') {
        let (name, entry) = match part.split_once('[') {
            Some((name, entry)) => (name, Some(entry.strip_suffix(']').ok_or_else(form)?)),
            None => (part, None),
        };
        if name.is_empty() {
            return Err(form());
        }
        path = path.key(name);
        if let Some(entry) = entry {
            let Some(Value::Sequence(entries)) = document.value_at(&path) else {
                return Err(format!("{key}: the file has no list {path}"));
            };
            let by_name =
                || entries.iter().position(|one| one.get("id").and_then(Value::as_str) == Some(entry));
            let place = by_name().or_else(|| entry.parse().ok().filter(|place| *place < entries.len()));
            let place = place.ok_or_else(|| format!("{key}: {path} has no entry {entry}"))?;
            path = path.index(place);
        }
    }
    match document.value_at(&path) {
        Some(Value::Number(_) | Value::String(_)) => Ok(path),
        Some(_) => Err(format!("{key}: it holds no single number")),
        None => Err(format!("{key}: the file has no such key, and only what it has is swept")),
    }
}

/// The document's value with a number in a unit at a path, or a plain number.
#[must_use]
pub fn changed(document: &Document, path: &Path, number: f64, unit: Option<&str>) -> Value {
    let mut whole = document.value().clone();
    let mut place = Some(&mut whole);
    for segment in path.segments() {
        place = place.and_then(|value| match segment {
            Segment::Key(key) => value.get_mut(key.as_str()),
            Segment::Index(index) => value.get_mut(*index),
        });
    }
    if let Some(value) = place {
        *value = match unit {
            Some(unit) => Value::String(format!("{number} {unit}")),
            None => Value::Number(number.into()),
        };
    }
    whole
}
