//! What a design takes that no speed tells: materials, factors, tools, oil, life and required safeties.

use super::records::BasisKey;
use crate::Error;
use crate::fault::Named;
use crate::strength::place::refused;
use epicyclic_formats::yaml::Value;
use epicyclic_formats::{Document, Path};

/// Materials, factors, tools, oil, life and required safeties, as a gearbox file writes them.
#[derive(Debug, Clone, PartialEq)]
pub struct Basis {
    /// The key `strength` of each set.
    pub strength: Value,
    /// Keys of the gearbox: life, oil, required, materials, density, pressure angle, addendum.
    pub keys: Vec<(String, Value)>,
}

/// Keys of a gearbox that a basis has.
const KEYS: [&str; 7] = ["life", "oil", "required", "materials", "density", "pressure_angle", "addendum"];

/// The basis where none is given.
pub const USUAL: &str = include_str!("basis.yaml");

impl Default for Basis {
    /// [`USUAL`].
    ///
    /// # Panics
    /// Never: a test reads the text.
    fn default() -> Self {
        let document = Document::parse_one("the usual basis", USUAL.as_bytes());
        document.map_err(Error::from).and_then(|document| Self::of(&document)).expect("a test reads it")
    }
}

impl Basis {
    /// The basis of a file: `strength` at its top, or of the first set that has it, and those of its keys that a basis has; what the
    /// file does not say is as [usual](USUAL). So a gearbox whose strength is calculated is a basis for another.
    ///
    /// # Errors
    /// [`Error::Document`] for a file without `strength`.
    pub fn of(document: &Document) -> Result<Self, Error> {
        let file = document.value();
        let sets = file.get("sets").and_then(Value::as_sequence).into_iter().flatten();
        let of_sets = || sets.filter_map(|set| set.get("strength")).next();
        let strength = file.get("strength").or_else(of_sets).ok_or_else(|| {
            let message = "a basis has the key `strength`, at its top or of a set: materials, roughness, shaper, factors";
            refused(document, &Path::root(), &[], &Named("missing-key", message))
        })?;
        let own = |key: &&str| Some(((*key).to_owned(), file.get(*key)?.clone()));
        Ok(Self { strength: strength.clone(), keys: KEYS.iter().filter_map(own).collect() })
    }

    /// The same with what is usual in place of the keys that it does not have.
    #[must_use]
    pub fn completed(mut self) -> Self {
        for (key, value) in Self::default().keys {
            if !self.keys.iter().any(|(own, _)| *own == key) {
                self.keys.push((key, value));
            }
        }
        self
    }

    /// All keys with their values.
    pub(super) fn told(&self) -> Vec<BasisKey> {
        let key = |key: String, value: &Value| BasisKey { key, value: flow(value) };
        let own = self.keys.iter().map(|(name, value)| key(name.clone(), value));
        let of_strength = self.strength.as_mapping().into_iter().flatten();
        let name = |name: &Value| format!("strength.{}", name.as_str().unwrap_or_default());
        own.chain(of_strength.map(|(of, value)| key(name(of), value))).collect()
    }

    /// The same with another value of a key.
    #[must_use]
    pub fn with(mut self, key: &str, value: Value) -> Self {
        self.keys.retain(|(own, _)| own != key);
        self.keys.push((key.to_owned(), value));
        self
    }

    /// The same with factors of both meshes by their symbols in place of those of the same symbol.
    #[must_use]
    pub fn with_factors(mut self, factors: &[(String, f64)]) -> Self {
        if let Some(strength) = self.strength.as_mapping_mut() {
            let own = strength.entry("factors".into()).or_insert_with(|| Value::Mapping(Default::default()));
            if let Some(own) = own.as_mapping_mut() {
                for (symbol, value) in factors {
                    own.insert(symbol.as_str().into(), (*value).into());
                }
            }
        }
        self
    }
}

/// A value in one line: lists and mappings as people write them in a line of YAML.
fn flow(value: &Value) -> String {
    match value {
        Value::Sequence(items) => items.iter().map(flow).collect::<Vec<_>>().join(", "),
        Value::Mapping(pairs) => {
            let pair = |(key, value): (&Value, &Value)| format!("{} {}", flow(key), flow(value));
            pairs.iter().map(pair).collect::<Vec<_>>().join(", ")
        }
        Value::String(text) => text.clone(),
        Value::Number(number) => number.to_string(),
        Value::Bool(truth) => truth.to_string(),
        Value::Null | Value::Tagged(_) => String::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(text: &str) -> Result<Basis, Error> {
        Basis::of(&Document::parse_one("basis.yaml", text.as_bytes()).unwrap())
    }

    #[test]
    fn the_usual_basis_has_what_strength_asks_for() {
        let usual = Basis::default();
        let keys: Vec<&str> = usual.keys.iter().map(|(key, _)| key.as_str()).collect();
        assert_eq!(keys, ["life", "oil", "required"]);
        assert!(usual.strength.get("factors").is_some());
    }

    #[test]
    fn a_gearbox_is_a_basis_and_what_it_lacks_is_usual() {
        let own = of("life: 5 h\nsets: [{ id: a }, { id: b, strength: { factors: { K_A: 2 } } }]\n").unwrap();
        assert_eq!(own.keys.len(), 1);
        let whole = own.completed();
        assert_eq!(whole.keys.len(), 3);
        assert_eq!(whole.keys[0].1, Value::from("5 h"));
        let changed = whole.with_factors(&[("K_A".into(), 1.5), ("K_v".into(), 1.1)]);
        assert_eq!(changed.strength["factors"]["K_A"], Value::from(1.5));
        assert_eq!(changed.with("life", Value::from("7 h")).keys.len(), 3);
        let refused = of("life: 5 h\n").unwrap_err().to_string();
        assert!(refused.starts_with("basis.yaml:1:1") && refused.contains("`strength`"), "{refused}");
    }
}
