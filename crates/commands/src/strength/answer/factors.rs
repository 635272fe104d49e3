//! Factors that a file gives by their symbols, each once in any spelling.

use crate::error::Error;
use crate::shared::fault::{Named, refused};
use epicyclic_formats::yaml::Value;
use epicyclic_formats::{Document, Path};
use epicyclic_strength::factor::Symbol;

/// Keys of `strength` that hold factors.
pub(crate) const KEYS: [&str; 6] =
    ["factors", "sun_mesh_factors", "ring_mesh_factors", "sun_factors", "planet_factors", "ring_factors"];

/// Refuses names that are not factors, a factor given twice under one key, such as `K_A` and `KA`, and values
/// of gears and meshes that the set has not.
pub(crate) fn check(
    document: &Document,
    strength: &Path,
    gears: &[String],
    meshes: &[String],
) -> Result<(), Error> {
    for key in KEYS {
        check_names(document, &strength.clone().key(key))?;
    }
    let lists = [
        (&["gear_factors"][..], gears),
        (&["mesh_factors"], meshes),
        (&["rims"], gears),
        (&["accuracy", "bores"], gears),
    ];
    for (keys, names) in lists {
        let path = keys.iter().fold(strength.clone(), |path, key| path.key(*key));
        let given = document.value_at(&path).and_then(Value::as_mapping).into_iter().flatten();
        for name in given.filter_map(|(name, _)| name.as_str()) {
            if !names.iter().any(|one| one == name) {
                let message = format!("`{}` has no `{name}`; there are {}", keys.join("."), names.join(", "));
                return Err(refused(document, &path, &[name], &Named("no-such-gear", message)));
            }
            if keys[0].ends_with("factors") {
                check_names(document, &path.clone().key(name))?;
            }
        }
    }
    Ok(())
}

fn check_names(document: &Document, path: &Path) -> Result<(), Error> {
    let names = document.value_at(path).and_then(Value::as_mapping).into_iter().flatten();
    let mut before: Vec<(Symbol, &str)> = vec![];
    for name in names.filter_map(|(name, _)| name.as_str()) {
        let of = symbol(document, path, name)?;
        if let Some((_, other)) = before.iter().find(|(other, _)| *other == of) {
            let why = Named("factor-twice", twice(of, [other, name]));
            return Err(refused(document, path, &[name], &why));
        }
        before.push((of, name));
    }
    Ok(())
}

/// Symbol of the factor with this name under a key.
pub(crate) fn symbol(document: &Document, key: &Path, name: &str) -> Result<Symbol, Error> {
    Symbol::named(name).ok_or_else(|| {
        let all: Vec<String> = Symbol::ALL.iter().map(Symbol::to_string).collect();
        let message = format!("no factor is called `{name}`; there are {}", all.join(", "));
        refused(document, key, &[name], &Named("no-factor", message))
    })
}

/// Message about a factor given twice, with both spellings.
#[must_use]
pub fn twice(symbol: Symbol, [one, other]: [&str; 2]) -> String {
    format!("`{one}` and `{other}` are the same factor, {symbol}; give it once")
}
