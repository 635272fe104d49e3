//! Keys of a file with another value, and the check that each changes the results.

use std::collections::{BTreeMap, BTreeSet};

/// Changes of a file: the old text and the new text.
pub(crate) type Changes = &'static [(&'static str, &'static str)];

/// Key with another value, and the command options that show its effect.
pub(crate) struct Key<Look = ()> {
    pub(crate) path: &'static str,
    /// Changes that make the key matter.
    pub(crate) first: Changes,
    pub(crate) from: &'static str,
    pub(crate) to: &'static str,
    pub(crate) look: Look,
}

/// Key that has an effect in the example as it is, for files with a single command.
pub(crate) const fn key(path: &'static str, from: &'static str, to: &'static str) -> Key {
    after(&[], path, from, to)
}

/// Key that has an effect only after changes.
pub(crate) const fn after(first: Changes, path: &'static str, from: &'static str, to: &'static str) -> Key {
    Key { path, first, from, to, look: () }
}

/// File with a text replaced by another.
pub(crate) fn replaced(file: &str, from: &str, to: &str) -> String {
    assert!(file.contains(from), "{from}");
    file.replacen(from, to, 1)
}

/// Checks that each key changes the results for the file, which is refused neither before nor after.
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
