//! Load sharing between planets if a file gives no mesh load factor.

use crate::answer::Warning;
use epicyclic_strength::load::{Floating, load_sharing};
use epicyclic_units::format::trimmed;
use schemars::JsonSchema;
use serde::Serialize;

/// Bases of a mesh load factor.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum SharingBasis {
    /// A member floats.
    Floating,
    /// No member floats.
    Rigid,
    /// Not stated: a floating member is assumed.
    Assumed,
}

impl SharingBasis {
    pub(crate) const fn of(floating: Floating) -> Self {
        match floating {
            Floating::Assumed => Self::Assumed,
            Floating::Yes => Self::Floating,
            Floating::No => Self::Rigid,
        }
    }
}

/// Load sharing between the planets of a set, if the file gives no `K_γ`.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct LoadSharing {
    /// Name of the set.
    pub set: String,
    /// Number of planets.
    pub planets: u32,
    /// Mesh load factor `K_γ`.
    pub mesh_load_factor: f64,
    /// Basis of the mesh load factor.
    pub basis: SharingBasis,
}

impl LoadSharing {
    /// Load sharing by the table; `None` if the table does not contain this number of planets.
    pub(crate) fn of(set: &str, planets: u32, floating: Floating) -> Option<Self> {
        let mesh_load_factor = load_sharing(planets, floating).ok()?;
        Some(Self { set: set.to_owned(), planets, mesh_load_factor, basis: SharingBasis::of(floating) })
    }

    /// Warning that no member floats, which loads planets unevenly; `None` if one does.
    pub(crate) fn warning(&self) -> Option<Warning> {
        (self.basis == SharingBasis::Rigid && self.planets > 1).then(|| Warning {
            name: "rigid-load-sharing",
            message: format!(
                "set {}: no member floats, so the {} planets share the load unevenly: K_γ = {} is assumed; measure or calculate it and \
                 give `K_gamma`",
                self.set,
                self.planets,
                trimmed(self.mesh_load_factor, 4)
            ),
        })
    }
}
