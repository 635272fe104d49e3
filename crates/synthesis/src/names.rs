//! Links and ring-to-sun ratios of a structure in a gearbox of the solver.

use crate::structure::{HOUSING, INPUT, Link, OUTPUT, Structure, link_name};
use epicyclic_train::GROUND;

/// The name that a link has in a gearbox of the solver: `in` the input, `out` the output, letters the others.
#[must_use]
pub fn solver_name(link: Link) -> String {
    match link {
        HOUSING => GROUND.into(),
        INPUT => "in".into(),
        OUTPUT => "out".into(),
        _ => link_name(link).to_string(),
    }
}

/// The ring-to-sun ratio of a set of the structure by that of its word: of a double-planet set `k = k′ + 1`.
#[must_use]
pub fn real_k(structure: &Structure, place: usize, k: f64) -> f64 {
    if structure.is_double_planet(place) { k + 1.0 } else { k }
}
