//! Factors that a file gives by their symbols, each once in any spelling.

use crate::shared::fault::Fault as _;
use epicyclic_formats::yaml::Value;
use epicyclic_formats::{Document, Faults, Path, Problem, nearest};
use epicyclic_strength::factor::Symbol;
use epicyclic_units::Number;

/// Keys of `strength` that hold factors.
pub(crate) const KEYS: [&str; 6] =
    ["factors", "sun_mesh_factors", "ring_mesh_factors", "sun_factors", "planet_factors", "ring_factors"];

/// Gears and meshes that keys of a set's strength may name.
pub(crate) struct Named<'n> {
    /// Name of the set.
    pub(crate) set: &'n str,
    /// Names of its gears.
    pub(crate) gears: &'n [String],
    /// Gears of its meshes.
    pub(crate) meshes: &'n [[String; 2]],
    /// Kinds of gears that it has, of a pair only `ring`.
    pub(crate) kinds: &'n [&'static str],
}

/// Keys for all gears or meshes of a kind, and the key for single ones.
const OF_KINDS: [(&str, &[&str], &str); 9] = [
    ("sun", &["sun_mesh_factors"], "mesh_factors"),
    ("sun", &["sun_factors"], "gear_factors"),
    ("sun", &["accuracy", "sun_bore"], "accuracy.bores"),
    ("planet", &["planet_factors"], "gear_factors"),
    ("planet", &["planet_rim"], "rims"),
    ("ring", &["ring_mesh_factors"], "mesh_factors"),
    ("ring", &["ring_factors"], "gear_factors"),
    ("ring", &["ring_rim"], "rims"),
    ("ring", &["shaper"], "tools"),
];

impl Named<'_> {
    /// Adds what is wrong with factors, such as one given twice, as `K_A` and `KA`; and values of gears and
    /// meshes that the set has not. `strength` is the path of the key.
    pub(crate) fn check(&self, document: &Document, strength: &Path, faults: &mut Faults) {
        let below = |keys: &[&str]| keys.iter().fold(strength.clone(), |path, key| path.key(*key));
        for key in KEYS {
            check_factors(
                document,
                &below(&[key]),
                !key.ends_with("mesh_factors") && key != "factors",
                faults,
            );
        }
        for (kind, keys, instead) in OF_KINDS {
            let path = below(keys);
            if self.kinds.contains(&kind) || !document.has(&path) {
                continue;
            }
            let message = format!(
                "set `{}`: `{}` is of {kind}s, and its gears are {}; write `{instead}`, or leave it out",
                self.set,
                keys.join("."),
                self.gears.join(", ")
            );
            faults.add(path, Problem::refused("no-such-gear", message));
        }
        let meshes: Vec<String> = self.meshes.iter().map(|gears| gears.join("-")).collect();
        let lists = [
            (&["gear_factors"][..], self.gears),
            (&["mesh_factors"], &meshes),
            (&["rims"], self.gears),
            (&["accuracy", "bores"], self.gears),
        ];
        for (keys, names) in lists {
            let path = below(keys);
            let given = document.value_at(&path).and_then(Value::as_mapping).into_iter().flatten();
            let mut before: Vec<String> = vec![];
            for name in given.filter_map(|(name, _)| name.as_str()) {
                let own = path.clone().key(name);
                let known = self.known(keys[0], name, names);
                match &known {
                    Some(other) if before.contains(other) => {
                        let message = format!("`{}` is given twice: keep one", keys.join("."));
                        faults.add(own.clone(), Problem::refused("duplicate", message));
                    }
                    Some(_) => {}
                    None => {
                        faults.add(own.clone(), Problem::refused("no-such-gear", no_such(keys, name, names)));
                    }
                }
                before.extend(known);
                if keys[0].ends_with("factors") {
                    check_factors(document, &own, keys[0] == "gear_factors", faults);
                }
            }
        }
    }

    /// The name as the set has it: a mesh may be named from either gear.
    fn known(&self, key: &str, name: &str, names: &[String]) -> Option<String> {
        let is_name = |place: &usize| {
            names[*place] == name || key == "mesh_factors" && reversed(&self.meshes[*place]) == name
        };
        (0..names.len()).find(is_name).map(|place| names[place].clone())
    }
}

/// A mesh, named from its second gear.
pub(crate) fn reversed([one, other]: &[String; 2]) -> String {
    format!("{other}-{one}")
}

fn no_such(keys: &[&str], name: &str, names: &[String]) -> String {
    let meant = nearest(name, names).map(|best| format!("; write {best}?")).unwrap_or_default();
    format!("`{}` has no `{name}`; there are {}{meant}", keys.join("."), names.join(", "))
}

/// Adds names that are not factors, factors given twice, values out of range, and factors of meshes at gears.
fn check_factors(document: &Document, path: &Path, is_of_gear: bool, faults: &mut Faults) {
    let names = document.value_at(path).and_then(Value::as_mapping).into_iter().flatten();
    let mut before: Vec<(Symbol, &str)> = vec![];
    for name in names.filter_map(|(name, _)| name.as_str()) {
        let at = path.clone().key(name);
        let Some(of) = Symbol::named(name) else {
            faults.add(at, no_factor(name));
            continue;
        };
        if let Some((_, other)) = before.iter().find(|(other, _)| *other == of) {
            faults.add(at, Problem::refused("factor-twice", twice(of, [other, name])));
        } else if is_of_gear && of.is_of_mesh() {
            let message = format!(
                "{of} is of a mesh: it stands in `factors`, `sun_mesh_factors`, `ring_mesh_factors` or `mesh_factors`"
            );
            faults.add(at, Problem::refused("factor-of-a-mesh", message));
        } else if let Some(Err(error)) =
            document.read_at::<Number>(&at).ok().map(|value| of.checked(value.get()))
        {
            faults.add(at, error.problem());
        }
        before.push((of, name));
    }
}

fn no_factor(name: &str) -> Problem {
    let all: Vec<String> = Symbol::ALL.iter().map(Symbol::to_string).collect();
    let meant = nearest(name, &all).map(|best| format!("; write {best}?")).unwrap_or_default();
    Problem::refused(
        "no-factor",
        format!("no factor is called `{name}`; there are {}{meant}", all.join(", ")),
    )
}

/// Message about a factor given twice, with both spellings.
#[must_use]
pub fn twice(symbol: Symbol, [one, other]: [&str; 2]) -> String {
    format!("`{one}` and `{other}` are the same factor, {symbol}; give it once")
}
