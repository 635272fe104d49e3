//! Keys of a file with another value, and that each changes what is seen.

use std::collections::{BTreeMap, BTreeSet};

/// Changes of a file: what stands in it, and what in its place.
pub(crate) type Changes = &'static [(&'static str, &'static str)];

/// A key with another value, and what shows it.
pub(crate) struct Key<Look = ()> {
    pub(crate) path: &'static str,
    /// Changes that make the key matter.
    pub(crate) first: Changes,
    pub(crate) from: &'static str,
    pub(crate) to: &'static str,
    pub(crate) look: Look,
}

/// A key that matters as the example is, where there is one look alone.
pub(crate) const fn key(path: &'static str, from: &'static str, to: &'static str) -> Key {
    after(&[], path, from, to)
}

/// The same after changes.
pub(crate) const fn after(first: Changes, path: &'static str, from: &'static str, to: &'static str) -> Key {
    Key { path, first, from, to, look: () }
}

/// A file with something else in place of what stands in it.
pub(crate) fn replaced(file: &str, from: &str, to: &str) -> String {
    assert!(file.contains(from), "{from}");
    file.replacen(from, to, 1)
}

/// Checks that each key changes what is seen of the file, which is refused neither before nor after.
pub(crate) fn check<Look: Copy + Ord, Seen: PartialEq>(
    file: &str,
    keys: &[Key<Look>],
    mut seen: impl FnMut(&str, Look) -> Result<Seen, String>,
) {
    let mut before = BTreeMap::new();
    let mut faults = vec![];
    for Key { path, first, from, to, look } in keys {
        let plain = first.iter().fold(file.to_owned(), |file, (from, to)| replaced(&file, from, to));
        let after = seen(&replaced(&plain, from, to), *look);
        let before = before.entry((plain.clone(), *look)).or_insert_with(|| seen(&plain, *look));
        match (before, after) {
            (Ok(before), Ok(after)) if *before != after => {}
            (Ok(_), Ok(_)) => faults.push(format!("{path} changes nothing: {from} → {to}")),
            (Err(error), _) => faults.push(format!("{path}: before {to}: {error}")),
            (_, Err(error)) => faults.push(format!("{path}: {to}: {error}")),
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// The paths of keys.
pub(crate) fn paths<Look>(keys: &[Key<Look>]) -> BTreeSet<String> {
    keys.iter().map(|key| key.path.to_owned()).collect()
}
