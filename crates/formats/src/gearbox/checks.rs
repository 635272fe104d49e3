//! Checks of names, numbers and tooth counts before a gearbox is built of them.

use super::DescriptionError;
use crate::Path;
use epicyclic_gears::teeth::ToothCount;
use epicyclic_train::Named;
use epicyclic_units::Number;
use std::collections::BTreeSet;

/// Refuses a name that stands twice, before any fault is placed by its name.
pub(super) fn unique<'n>(
    what: Named,
    mut names: impl Iterator<Item = &'n String>,
) -> Result<(), DescriptionError> {
    let mut seen = BTreeSet::new();
    match names.find(|name| !seen.insert(name.as_str())) {
        Some(name) => Err(epicyclic_train::Error::Duplicate { what, name: name.clone() }.into()),
        None => Ok(()),
    }
}

/// Tooth counts with the way to each.
pub(super) fn counts(set: &str, key: &str, teeth: &[u32]) -> Result<Vec<ToothCount>, DescriptionError> {
    let count = |(place, count): (usize, &u32)| {
        ToothCount::new(*count).map_err(|source| {
            let at = Path::root().key(key).index(place);
            DescriptionError::Set { set: set.to_owned(), at, source }
        })
    };
    teeth.iter().enumerate().map(count).collect()
}

/// The values of a key of a set, one for each of these gears or meshes.
pub(super) fn numbers<const N: usize>(
    set: &str,
    key: &'static str,
    of: &'static str,
    values: &[Number],
) -> Result<[f64; N], DescriptionError> {
    let wrong =
        || DescriptionError::Values { set: set.to_owned(), key, of, given: values.len(), expected: N };
    let values: [Number; N] = values.try_into().map_err(|_| wrong())?;
    Ok(values.map(Number::get))
}
