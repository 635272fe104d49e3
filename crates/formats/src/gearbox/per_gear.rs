//! Values of the gears of a set, in their order or by their names.

use super::DescriptionError;
use crate::document::LIST;
use crate::faults::Faults;
use crate::{Path, nearest};
use epicyclic_gears::geometry::GearKind;
use epicyclic_train::set::SetKind;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::Deserialize;
use serde::de::{Deserializer, MapAccess, SeqAccess, Visitor};
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::fmt;
use std::marker::PhantomData;

/// Values of the gears of a set: a list from the first central gear over the planets to the second, or a map
/// from gears to values.
///
/// Gears have the names that answers give them: `sun`, `planet`, `ring`; `planet 1`, `planet 2` of two
/// planets or two steps; `gear 1`, `gear 2` of a pair. Those of compound sets have the names that its meshes
/// use.
#[derive(Debug, Clone, PartialEq)]
pub enum PerGear<T> {
    /// In the order of the gears.
    List(Vec<T>),
    /// By gear.
    Named(BTreeMap<String, T>),
}

impl<T> Default for PerGear<T> {
    /// No values.
    fn default() -> Self {
        Self::Named(BTreeMap::new())
    }
}

impl<T> PerGear<T> {
    /// The values in the order of these gears, as far as they are given.
    ///
    /// # Errors
    /// [`DescriptionError::Values`] for a list of another length, [`DescriptionError::ByName`] for a list of
    /// a compound set, [`DescriptionError::NoSuchGear`].
    pub fn given(
        &self,
        set: &str,
        key: &'static str,
        gears: &Gears,
    ) -> Result<Vec<Option<&T>>, DescriptionError> {
        let names = &gears.names;
        match self {
            Self::List(_) if !gears.has_order => {
                let (set, of) = (set.to_owned(), gears.of);
                Err(DescriptionError::ByName { set, key, of, gears: names.join(", ") })
            }
            Self::List(values) if values.len() == names.len() => Ok(values.iter().map(Some).collect()),
            Self::List(values) => Err(DescriptionError::Values {
                set: set.to_owned(),
                key,
                of: names.join(", "),
                given: values.len(),
                expected: names.len(),
            }),
            Self::Named(values) => {
                let mut given = vec![None; names.len()];
                for (name, value) in values {
                    let place = gears.place(name).ok_or_else(|| gears.unknown(set, key, name))?;
                    if given[place].replace(value).is_some() {
                        let (set, name) = (set.to_owned(), names[place].clone());
                        return Err(DescriptionError::ValueTwice { set, key, name });
                    }
                }
                Ok(given)
            }
        }
    }

    /// The values in the order of these gears, as far as they are given: those of wrong names are refused
    /// where the set is read.
    #[must_use]
    pub fn of_gears(&self, gears: &Gears) -> Vec<Option<&T>> {
        self.given("", "", gears).unwrap_or_else(|_| vec![None; gears.names.len()])
    }
}

/// Meshes in words, as what has the names of [`Gears`].
pub(super) const MESHES: &str = "meshes";

/// Gears of a set as its keys know them, or bodies or meshes.
#[derive(Debug, Clone, PartialEq)]
pub struct Gears {
    /// Names, in the order of [`PlanetSet::gears`](epicyclic_train::PlanetSet::gears).
    pub names: Vec<String>,
    /// External or internal; `None` of bevel gears.
    pub kinds: Vec<Option<GearKind>>,
    /// Whether lists may be in their order: not in compound sets, whose gears have none.
    pub has_order: bool,
    /// Things that have these names, in words.
    pub of: &'static str,
}

impl Gears {
    /// Gears of a kind of set.
    #[must_use]
    pub fn of_kind(kind: SetKind) -> Self {
        let (names, kinds) = kind.gears().into_iter().map(|(name, kind)| (name.to_owned(), kind)).unzip();
        Self { names, kinds, has_order: true, of: "gears" }
    }

    /// Gears of each mesh of a kind of set.
    pub(super) fn meshes_of_kind(kind: SetKind) -> Vec<[String; 2]> {
        let names = Self::of_kind(kind).names;
        let mut meshes: Vec<[String; 2]> =
            names.windows(2).map(|pair| [pair[0].clone(), pair[1].clone()]).collect();
        if kind.is_stepped() {
            // The two steps of the planet are in no mesh with each other.
            meshes.remove(1);
        }
        meshes
    }

    /// Place of the gear, body or mesh with this name; a mesh may be named from either gear.
    fn place(&self, name: &str) -> Option<usize> {
        let is = |wanted: &str| self.names.iter().position(|own| own == wanted);
        let mut splits = name.match_indices('-').filter(|_| self.of == MESHES);
        is(name).or_else(|| splits.find_map(|(at, _)| is(&format!("{}-{}", &name[at + 1..], &name[..at]))))
    }

    pub(super) fn unknown(&self, set: &str, key: &'static str, gear: &str) -> DescriptionError {
        let (set, of) = (set.to_owned(), self.of);
        // Answers put the kind before the name of a central gear: `ring drum`.
        let meant = self.names.iter().find(|name| gear.ends_with(&format!(" {name}"))).map(String::as_str);
        // Or the kind alone.
        let of_kind = |kind| self.names.iter().zip(&self.kinds).filter(move |one| *one.1 == Some(kind));
        let meant = meant.or_else(|| match gear {
            "sun" => of_kind(GearKind::External).next().map(|one| one.0.as_str()),
            "ring" => of_kind(GearKind::Internal).next().map(|one| one.0.as_str()),
            _ => None,
        });
        let meant = meant.or_else(|| nearest(gear, &self.names));
        let meant = meant.map(|one| format!("; write {one}?")).unwrap_or_default();
        let gears = format!("{}{meant}", self.names.join(", "));
        DescriptionError::NoSuchGear { set, key, gear: gear.to_owned(), of, gears }
    }

    /// Adds what is wrong with the gears of values, at the name that is wrong; whether nothing is.
    pub(super) fn check<T>(
        &self,
        set: &str,
        (at, key): (Path, &'static str),
        values: &PerGear<T>,
        faults: &mut Faults,
    ) -> bool {
        match values.given(set, key, self) {
            Ok(_) => true,
            Err(DescriptionError::NoSuchGear { .. }) => {
                let PerGear::Named(values) = values else { return false };
                for gear in values.keys().filter(|gear| self.place(gear).is_none()) {
                    faults.push(at.clone().key(gear), self.unknown(set, key, gear));
                }
                false
            }
            Err(error) => {
                faults.push(at, error);
                false
            }
        }
    }
}

impl<'de, T: Deserialize<'de>> Deserialize<'de> for PerGear<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_newtype_struct(LIST, ListOrMap(PhantomData))
    }
}

struct ListOrMap<T>(PhantomData<T>);

impl<'de, T: Deserialize<'de>> Visitor<'de> for ListOrMap<T> {
    type Value = PerGear<T>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a list of values in the order of the gears, or a map from gears to values")
    }

    fn visit_newtype_struct<D: Deserializer<'de>>(self, deserializer: D) -> Result<Self::Value, D::Error> {
        deserializer.deserialize_any(self)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut values: A) -> Result<Self::Value, A::Error> {
        let mut all = vec![];
        while let Some(value) = values.next_element()? {
            all.push(value);
        }
        Ok(PerGear::List(all))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut values: A) -> Result<Self::Value, A::Error> {
        let mut all = BTreeMap::new();
        while let Some((gear, value)) = values.next_entry()? {
            all.insert(gear, value);
        }
        Ok(PerGear::Named(all))
    }
}

impl<T: JsonSchema> JsonSchema for PerGear<T> {
    fn schema_name() -> Cow<'static, str> {
        format!("PerGear_{}", T::schema_name()).into()
    }

    fn inline_schema() -> bool {
        true
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let value = generator.subschema_for::<T>();
        json_schema!({
            "anyOf": [
                { "type": "array", "items": value },
                { "type": "object", "additionalProperties": value },
            ],
            "description": "Values in the order of the gears, or by the names of gears.",
        })
    }
}
