//! Assumed values of designs and sizes: materials, factors, tools, oil, life and required safeties.

use crate::error::Error;
use crate::shared::fault::{Named, refused};
use crate::strength::answer::factors;
use epicyclic_formats::gearbox::{Gears, StatedLimit, check_limits};
use epicyclic_formats::yaml::{Mapping, Value};
use epicyclic_formats::{Document, Faults, Path};
use epicyclic_strength::factor::Symbol;
use epicyclic_train::set::SetKind;
use epicyclic_units::Quantity;
use epicyclic_units::format::trimmed;
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;
use uom::si::f64::Angle;

/// Assumed materials, factors, tools, oil, life and required safeties, as written in a gearbox file.
#[derive(Debug, Clone, PartialEq)]
pub struct Basis {
    /// Value of the key `strength` of each set; null if a file lacks it.
    pub strength: Value,
    /// Value of the key `tools` of each set; if `None`, the usual tools are assumed.
    pub tools: Option<Value>,
    /// Helix angle of the teeth of each set; `None` of spur teeth.
    pub helix_angle: Option<Quantity<Angle>>,
    /// Keys of the gearbox: life, oil, required, limits, materials, density, pressure angle, addendum.
    pub keys: Vec<(String, Value)>,
}

/// Assumed value with its key.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct BasisKey {
    /// Name of the key; those below `strength` and `efficiency` are of each set.
    pub key: String,
    /// Value as written in the file, in one line.
    pub value: String,
}

impl BasisKey {
    /// A number to six digits.
    pub(crate) fn of_number(key: &str, value: f64) -> Self {
        Self { key: key.to_owned(), value: trimmed(value, 6) }
    }
}

/// Keys of a gearbox that belong to a basis.
const KEYS: [&str; 8] =
    ["life", "oil", "required", "limits", "materials", "density", "pressure_angle", "addendum"];

/// Keys of `strength` that a pair has as well.
const OF_PAIRS: [&str; 8] = [
    "materials",
    "flank_roughness",
    "root_roughness",
    "factors",
    "accuracy",
    "accuracy_grade",
    "pitting_allowed",
    "long_life_factor",
];

/// Values of sun, planet and ring as those of a pair, whose gears are as sun and planet.
fn to_pair(value: &mut Value) {
    let [of_set, of_pair] = [SetKind::Simple, SetKind::ExternalPair].map(|kind| Gears::of_kind(kind).names);
    if let Some(list) = value.as_sequence_mut().filter(|list| list.len() == of_set.len()) {
        list.truncate(of_pair.len());
    }
    if let Some(named) = value.as_mapping_mut() {
        for (from, to) in of_set.iter().zip(of_pair.iter().map(Some).chain([None])) {
            let own = named.shift_remove(from);
            to.zip(own).map(|(to, own)| named.insert(to.as_str().into(), own));
        }
    }
}

/// Default basis.
pub const USUAL: &str = include_str!("basis.yaml");

impl Default for Basis {
    /// Basis of [`USUAL`].
    ///
    /// # Panics
    /// Never: a test reads the text.
    fn default() -> Self {
        let document = Document::parse_one("the usual basis", USUAL.as_bytes());
        document.map_err(Error::from).and_then(|document| Self::of(&document)).expect("a test reads it")
    }
}

impl Basis {
    /// Reads the basis from a file: `strength` and `tools`, at its top or of the first set with `strength`,
    /// and keys such as `life` and `limits`. [`completed_by`](Self::completed_by) adds what is missing. A
    /// gearbox with calculated strength can therefore serve as the basis of another.
    ///
    /// # Errors
    /// [`Error::Document`] for a file without any of these keys, and for factors and limits that cannot be.
    pub fn of(document: &Document) -> Result<Self, Error> {
        let file = document.value();
        let sets = file.get("sets").and_then(Value::as_sequence).map_or(0, Vec::len);
        let of_sets = (0..sets).map(|place| Path::root().key("sets").index(place));
        let mut places = std::iter::once(Path::root()).chain(of_sets);
        let found = places.find_map(|of| Some((document.value_at(&of.clone().key("strength"))?, of)));
        let own = |key: &&str| Some(((*key).to_owned(), file.get(*key)?.clone()));
        let keys: Vec<(String, Value)> = KEYS.iter().filter_map(own).collect();
        if found.is_none() && keys.is_empty() {
            let message = format!(
                "a basis has the key `strength`, at its top or of a set: materials, roughness, shaper, factors; or one of `{}`",
                KEYS.join("`, `")
            );
            return Err(refused(document, &Path::root(), &[], &Named("missing-key", message)));
        }
        let mut faults = Faults::default();
        let of_limits = Path::root().key("limits");
        if document.has(&of_limits) {
            check_limits(&document.read_at::<BTreeMap<String, StatedLimit>>(&of_limits)?, &mut faults);
        }
        let (mut strength, of) =
            found.map_or((Value::Null, Path::root()), |(strength, of)| (strength.clone(), of));
        // Rims of a set are those of its own size.
        if let Some(of_set) = strength.as_mapping_mut().filter(|_| of != Path::root()) {
            for rim in ["planet_rim", "ring_rim"] {
                of_set.shift_remove(rim);
            }
        }
        let gears = Gears::of_kind(SetKind::Simple).names;
        let meshes = [0, 1].map(|first: usize| [first, first + 1].map(|gear| gears[gear].clone()));
        let kinds = ["sun", "planet", "ring"];
        let named = factors::Named { set: "of a design", gears: &gears, meshes: &meshes, kinds: &kinds };
        named.check(document, &of.clone().key("strength"), &mut faults);
        if !faults.is_empty() {
            return Err(faults.placed(document, &Path::root()).into());
        }
        let tools = document.value_at(&of.key("tools")).cloned();
        Ok(Self { strength, tools, helix_angle: None, keys })
    }

    /// Adds the values that another basis has of missing keys, also of `strength`: materials with what
    /// depends on them, roughness, shaper, and factors that no key states.
    #[must_use]
    pub fn completed_by(mut self, usual: Self) -> Self {
        match self.strength.as_mapping_mut() {
            Some(own) => complete(own, &usual.strength),
            None => self.strength = usual.strength.clone(),
        }
        for (key, value) in usual.keys {
            if !self.keys.iter().any(|(own, _)| *own == key) {
                self.keys.push((key, value));
            }
        }
        self
    }

    /// The keys as a file, with `strength` at its top.
    pub(crate) fn file(&self) -> Value {
        let strength = ("strength".to_owned(), self.strength.clone());
        let keys = self.keys.iter().cloned().chain([strength]);
        Value::Mapping(keys.map(|(key, value)| (Value::from(key), value)).collect::<Mapping>())
    }

    /// Lists all keys with their values.
    pub(crate) fn told(&self) -> Vec<BasisKey> {
        let key = |key: String, value: &Value| BasisKey { key, value: flow(value) };
        let own = self.keys.iter().map(|(name, value)| key(name.clone(), value));
        let of_strength = self.strength.as_mapping().into_iter().flatten();
        let name = |name: &Value| format!("strength.{}", name.as_str().unwrap_or_default());
        let tools = self.tools.iter().map(|tools| key("tools".to_owned(), tools));
        own.chain(of_strength.map(|(of, value)| key(name(of), value))).chain(tools).collect()
    }

    /// `strength` of a pair on fixed axes: its gears are as sun and planet, its mesh as that of the sun. What
    /// concerns rings, rims and several planets is left out, as is what planets alone have.
    pub(crate) fn strength_of_pair(&self) -> Value {
        let mut strength = self.strength.clone();
        if let Some(own) = strength.as_mapping_mut() {
            let mut factors = Mapping::new();
            for key in ["factors", "sun_mesh_factors", "sun_factors"] {
                factors.extend(own.get(key).and_then(Value::as_mapping).cloned().unwrap_or_default());
            }
            factors.retain(|name, _| name.as_str().and_then(Symbol::named) != Some(Symbol::LoadSharing));
            own.retain(|key, _| key.as_str().is_some_and(|key| OF_PAIRS.contains(&key)));
            own.insert("factors".into(), Value::Mapping(factors));
            own.iter_mut().for_each(|(_, value)| to_pair(value));
            if let Some(accuracy) = own.get_mut("accuracy").and_then(Value::as_mapping_mut) {
                accuracy.shift_remove("sun_bore");
                accuracy.iter_mut().for_each(|(_, value)| to_pair(value));
            }
        }
        strength
    }

    /// `tools` of a pair on fixed axes, whose gears are as sun and planet.
    pub(crate) fn tools_of_pair(&self) -> Option<Value> {
        let mut tools = self.tools.clone()?;
        to_pair(&mut tools);
        Some(tools)
    }

    /// Whether a factor of all meshes is given.
    pub(crate) fn has_factor(&self, symbol: Symbol) -> bool {
        let factors = ["factors", "sun_mesh_factors", "sun_factors"].into_iter();
        let mut names =
            factors.filter_map(|key| self.strength.get(key)?.as_mapping()).flat_map(Mapping::keys);
        names.any(|name| Symbol::named(&flow(name)) == Some(symbol))
    }

    /// Replaces the value of a key.
    #[must_use]
    pub fn with(mut self, key: &str, value: Value) -> Self {
        self.keys.retain(|(own, _)| own != key);
        self.keys.push((key.to_owned(), value));
        self
    }

    /// Sets factors of both meshes by the names of their symbols. A factor replaces those of the same symbol
    /// under any key and in any spelling.
    #[must_use]
    pub fn with_factors(mut self, factors: &[(String, f64)]) -> Self {
        let Some(strength) = self.strength.as_mapping_mut() else { return self };
        for (name, value) in factors {
            let symbol = Symbol::named(name);
            let is_same = |other: &Value| other.as_str().is_some_and(|other| Symbol::named(other) == symbol);
            for key in factors::KEYS {
                let Some(own) = strength.get_mut(key).and_then(Value::as_mapping_mut) else { continue };
                if key == "factors" {
                    // The key keeps its place and its spelling.
                    own.iter_mut()
                        .filter(|(other, _)| is_same(other))
                        .for_each(|(_, own)| *own = (*value).into());
                } else {
                    own.retain(|other, _| !is_same(other));
                }
            }
            let own = strength.entry("factors".into()).or_insert_with(|| Value::Mapping(Default::default()));
            if let Some(own) = own.as_mapping_mut().filter(|own| !own.keys().any(is_same)) {
                own.insert(name.as_str().into(), (*value).into());
            }
        }
        let is_of_factors = |key: &Value| key.as_str().is_some_and(|key| factors::KEYS.contains(&key));
        strength.retain(|key, value| {
            !(is_of_factors(key)
                && value.as_mapping().is_some_and(epicyclic_formats::yaml::Mapping::is_empty))
        });
        self
    }
}

/// Adds the values of a usual `strength` that another one lacks.
fn complete(own: &mut Mapping, usual: &Value) {
    // The static factor of the ring depends on its material.
    let with_materials = if own.contains_key("materials") { &[][..] } else { &["materials", "ring_factors"] };
    for key in [with_materials, &["flank_roughness", "root_roughness", "shaper"]].concat() {
        if let Some(usual) = usual.get(key).filter(|_| !own.contains_key(key)) {
            own.insert(key.into(), usual.clone());
        }
    }
    let symbols = |own: &Mapping, key: &str| -> Vec<Symbol> {
        let names = own.get(key).and_then(Value::as_mapping).into_iter().flatten();
        names.filter_map(|(name, _)| Symbol::named(name.as_str()?)).collect()
    };
    let stated = symbols(own, "factors");
    let of_meshes = ["sun_mesh_factors", "ring_mesh_factors"].map(|key| symbols(own, key));
    let lacks = |symbol: &Symbol| {
        !stated.contains(symbol) && !of_meshes.iter().all(|factors| factors.contains(symbol))
    };
    let usual = usual.get("factors").and_then(Value::as_mapping).into_iter().flatten();
    let missing: Vec<(Value, Value)> = usual
        .filter(|(name, _)| name.as_str().and_then(Symbol::named).is_some_and(|symbol| lacks(&symbol)))
        .map(|(name, value)| (name.clone(), value.clone()))
        .collect();
    if !missing.is_empty() {
        let factors = own.entry("factors".into()).or_insert_with(|| Value::Mapping(Mapping::new()));
        factors.as_mapping_mut().into_iter().for_each(|factors| factors.extend(missing.clone()));
    }
}

/// Formats a value in one line: lists and mappings as in one line of YAML.
pub(crate) fn flow(value: &Value) -> String {
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
        let whole = own.completed_by(Basis::default());
        assert_eq!(whole.keys.len(), 3);
        assert_eq!(whole.keys[0].1, Value::from("5 h"));
        let changed = whole.with_factors(&[("K_A".into(), 1.5), ("K_v".into(), 1.1)]);
        assert_eq!(changed.strength["factors"]["K_A"], Value::from(1.5));
        assert_eq!(changed.with("life", Value::from("7 h")).keys.len(), 3);
        let tools =
            of("sets: [{ id: a }, { strength: {}, tools: { sun: { profile: D } } }]\n").unwrap().tools;
        assert_eq!(tools.unwrap()["sun"]["profile"], Value::from("D"));
        let refused = of("gearbox: P\n").unwrap_err().to_string();
        assert!(refused.starts_with("basis.yaml:1:1") && refused.contains("`strength`"), "{refused}");
    }

    #[test]
    fn a_basis_without_strength_gets_that_of_another_and_keeps_its_limits() {
        let own = of("life: 5 h\nlimits: { face-width: 0.4..1.4 }\n").unwrap();
        let whole = own.completed_by(Basis::default());
        assert_eq!(whole.strength, Basis::default().strength);
        assert!(whole.keys.iter().any(|(key, value)| key == "limits" && value.get("face-width").is_some()));
        let part = of("strength: { factors: { KA: 2 }, materials: [a, b, c] }\n").unwrap();
        let whole = part.completed_by(Basis::default()).strength;
        assert_eq!((whole["factors"]["KA"].as_i64(), whole["factors"].get("K_A")), (Some(2), None));
        assert_eq!(whole["materials"][0].as_str(), Some("a"));
        assert!(whole["factors"].get("K_v").is_some() && whole.get("shaper").is_some());
        assert!(whole.get("ring_factors").is_none());
        let refused = of("limits: { face-width: -1..1.4 }\n").unwrap_err().to_string();
        assert!(refused.contains("limits.face-width") && refused.contains("above 0"), "{refused}");
    }

    /// The key and the spelling of a factor do not matter.
    #[test]
    fn a_factor_given_by_option_acts_in_any_spelling() {
        let file = "strength: { factors: { KA: 2, K_v: 1 }, sun_mesh_factors: { K_Hβ: 1.3 }, ring_factors: { Y_S: 2 } }\n";
        let factors = [("K_A".to_owned(), 3.0), ("K_H_beta".to_owned(), 1.1), ("YS".to_owned(), 1.5)];
        let changed = of(file).unwrap().with_factors(&factors);
        let own = of("strength: { factors: { KA: 3.0, K_v: 1, K_H_beta: 1.1, YS: 1.5 } }\n").unwrap();
        assert_eq!(changed.strength, own.strength);
    }

    #[test]
    fn a_factor_that_stands_twice_is_refused_with_both_spellings() {
        for key in factors::KEYS {
            for [one, other] in
                [["K_A", "KA"], ["K_Hβ", "K_H_beta"], ["Z_B", "Z_D"], ["Y_δrelT", "Y_delta_rel_T"]]
            {
                let file = format!("sets:\n- strength:\n    {key}:\n      {one}: 1\n      {other}: 1\n");
                let refused = of(&file).unwrap_err().to_string();
                let both = format!("`{one}` and `{other}` are the same factor");
                assert!(refused.contains("basis.yaml:5:") && refused.contains(&both), "{refused}");
            }
        }
        assert!(of("strength: { factors: { K_A: 1 }, sun_mesh_factors: { K_A: 2 } }\n").is_ok());
    }
}
