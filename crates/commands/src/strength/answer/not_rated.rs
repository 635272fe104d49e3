//! What of teeth is not rated, and why.

use super::names::{Against, MeshName, Place, ToothedGear};
use epicyclic_strength as strength;
use schemars::JsonSchema;
use serde::Serialize;

/// Why a set, or a mesh, flank or root of it, is not rated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Reason {
    /// It is no simple set: no sun, planet and ring.
    NotSimple,
    /// Its entry in the file lacks keys.
    KeysMissing,
    /// A factor is neither given nor can be calculated.
    FactorMissing,
    /// It is outside what the standard holds for.
    BeyondStandard,
    /// No torques follow in the gear, or it cannot take the load.
    NoTorquesFollow,
    /// It carries no torque.
    NoTorque,
    /// It does not roll: it turns as a block or rests.
    NoRolling,
}

/// A set that is not rated, or a mesh, flank or root of it.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct NotRated {
    /// The set.
    pub set: String,
    /// Against what not; `null` against all.
    pub against: Option<Against>,
    /// In which selected gears; empty in all.
    pub gears: Vec<String>,
    /// The mesh; `null` where none of the set is rated.
    pub mesh: Option<MeshName>,
    /// The gear of the mesh; `null` where neither is rated.
    pub toothed_gear: Option<ToothedGear>,
    /// Flank or root of this gear; `null` where neither is rated.
    pub place: Option<Place>,
    /// Why.
    pub reason: Reason,
    /// The keys, or the factor, that are missing.
    pub missing: Vec<String>,
    /// What the factor would follow from, or what is outside the standard.
    pub because: Option<String>,
    /// The value that is outside the standard, lengths in mm, roughness in µm.
    pub value: Option<f64>,
}

impl NotRated {
    pub(crate) fn new(set: &str, reason: Reason) -> Self {
        Self {
            set: set.to_owned(),
            against: None,
            gears: vec![],
            mesh: None,
            toothed_gear: None,
            place: None,
            reason,
            missing: vec![],
            because: None,
            value: None,
        }
    }

    /// Of a set and what ended the calculation of it or of a part; `None` of a fault of the input.
    pub(crate) fn of_error(set: &str, error: &strength::Error) -> Option<Self> {
        use strength::Error as E;
        match error {
            E::MissingFactor { symbol, because } => Some(Self {
                missing: vec![symbol.to_string()],
                because: Some((*because).to_owned()),
                ..Self::new(set, Reason::FactorMissing)
            }),
            E::IdleDuty => Some(Self::new(set, Reason::NoTorque)),
            error if error.is_beyond_standard() => Some(Self {
                because: Some(error.to_string()),
                value: match error {
                    E::OutOfRange { value, .. } | E::NotAbove { value, .. } => Some(*value),
                    _ => None,
                },
                ..Self::new(set, Reason::BeyondStandard)
            }),
            _ => None,
        }
    }

    /// The same of one mesh.
    pub(crate) fn of_mesh(self, mesh: MeshName) -> Self {
        Self { mesh: Some(mesh), ..self }
    }

    /// Flanks and roots of both gears of a mesh that have an error.
    pub(crate) fn parts(
        set: &str,
        mesh: MeshName,
        errors: [(Option<strength::Error>, Option<strength::Error>); 2],
    ) -> Vec<Self> {
        let of_gear = |(side, (flank, root)): (usize, (Option<strength::Error>, Option<strength::Error>))| {
            [(Place::Flank, flank), (Place::Root, root)].into_iter().filter_map(move |(place, error)| {
                let row = Self::of_error(set, &error?)?.of_mesh(mesh);
                Some(Self { toothed_gear: Some(mesh.gears()[side]), place: Some(place), ..row })
            })
        };
        errors.into_iter().enumerate().flat_map(of_gear).collect()
    }

    /// The same in one gear.
    pub(crate) fn of_gear(self, gear: &str) -> Self {
        Self { gears: vec![gear.to_owned()], ..self }
    }

    /// The same against one thing alone.
    pub(crate) fn against(self, against: Against) -> Self {
        Self { against: Some(against), ..self }
    }

    /// Adds it to others, gears of one set and reason together.
    pub(crate) fn join(mut self, all: &mut Vec<Self>) {
        let alike = |one: &&mut Self| {
            let part = |one: &Self| (one.against, one.mesh, one.toothed_gear, one.place, one.reason);
            part(one) == part(&self)
                && (&one.set, &one.missing, &one.because) == (&self.set, &self.missing, &self.because)
                && !one.gears.is_empty()
        };
        match all.iter_mut().find(alike) {
            Some(one) => one.gears.append(&mut self.gears),
            None => all.push(self),
        }
    }

    /// In words: `set 1: module missing`.
    pub(crate) fn told(&self) -> String {
        format!("{}: {}", self.of(), self.why())
    }

    /// What is not rated, in words: `set 1`, `set 1, mesh planet-ring, root of the ring`.
    #[must_use]
    pub fn of(&self) -> String {
        let mut words = format!("set {}", self.set);
        if let Some(mesh) = self.mesh {
            words += &format!(", mesh {mesh}");
        }
        if let (Some(gear), Some(place)) = (self.toothed_gear, self.place) {
            words += &format!(", {place} of the {gear}");
        }
        words
    }

    /// Why, in words.
    #[must_use]
    pub fn why(&self) -> String {
        let against = if self.against == Some(Against::Overload) { "against the overload: " } else { "" };
        let missing = self.missing.join(", ");
        let why = match (self.reason, &self.because) {
            (Reason::NotSimple, _) => "no simple set".to_owned(),
            (Reason::KeysMissing | Reason::FactorMissing, None) => format!("{missing} missing"),
            (Reason::KeysMissing | Reason::FactorMissing, Some(because)) => {
                format!("{missing} missing: {because}")
            }
            (Reason::BeyondStandard, because) => {
                format!("outside ISO 6336: {}", because.as_deref().unwrap_or_default())
            }
            (Reason::NoTorquesFollow, _) => "no torques follow".to_owned(),
            (Reason::NoTorque, _) => "carries no torque".to_owned(),
            (Reason::NoRolling, _) => "does not roll".to_owned(),
        };
        format!("{against}{why}")
    }
}
