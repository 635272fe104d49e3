//! Sets and teeth that are not rated, with the reasons.

use super::names::{Against, MeshName};
use epicyclic_strength as strength;
use epicyclic_strength::rating::Place;
use schemars::JsonSchema;
use serde::Serialize;

/// Reasons why a set, mesh, flank or root is not rated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Reason {
    /// A planet of the set meshes with no central gear, so that its place is not known before its size.
    PlanetAlone,
    /// No radius of the planets is within reach of all their meshes at the modules.
    NoCommonRadius,
    /// The gears are bevel gears.
    Bevel,
    /// Keys are missing in the entry of the file.
    KeysMissing,
    /// A factor is not given and cannot be calculated.
    FactorMissing,
    /// A value is outside the range of the standard.
    BeyondStandard,
    /// Torques cannot be computed in the gear, or it cannot carry the load.
    NoTorquesFollow,
    /// The set carries no torque.
    NoTorque,
    /// The set does not roll: it turns as a block or is at rest.
    NoRolling,
}

/// Set that is not rated, or a mesh, flank or root of it.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct NotRated {
    /// Name of the set.
    pub set: String,
    /// Load against which the set is not rated; null for all.
    pub against: Option<Against>,
    /// Selected gears in which the set is not rated; empty for all.
    pub gears: Vec<String>,
    /// Name of the mesh; null if no mesh of the set is rated.
    pub mesh: Option<MeshName>,
    /// Gear of the mesh; null if neither gear is rated.
    pub toothed_gear: Option<String>,
    /// Flank or root of this gear; null if neither is rated.
    pub place: Option<Place>,
    /// Reason why the part is not rated.
    pub reason: Reason,
    /// Keys, or the factor, that are missing.
    pub missing: Vec<String>,
    /// Data from which the factor would follow, or the value outside the standard; otherwise null.
    pub because: Option<String>,
    /// Value outside the standard, lengths in mm, roughness in µm; otherwise null.
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

    /// Record for an error in the calculation of a set or a part of it; `None` for an error of the input.
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

    /// Restricts the record to one mesh.
    pub(crate) fn of_mesh(self, mesh: &MeshName) -> Self {
        Self { mesh: Some(mesh.clone()), ..self }
    }

    /// Records of the flanks and roots of both gears of a mesh that have an error.
    pub(crate) fn parts(
        set: &str,
        mesh: &MeshName,
        errors: [(Option<strength::Error>, Option<strength::Error>); 2],
    ) -> Vec<Self> {
        let of_gear = |(side, (flank, root)): (usize, (Option<strength::Error>, Option<strength::Error>))| {
            [(Place::Flank, flank), (Place::Root, root)].into_iter().filter_map(move |(place, error)| {
                let row = Self::of_error(set, &error?)?.of_mesh(mesh);
                Some(Self { toothed_gear: Some(mesh.gears[side].clone()), place: Some(place), ..row })
            })
        };
        errors.into_iter().enumerate().flat_map(of_gear).collect()
    }

    /// Restricts the record to one gear.
    pub(crate) fn of_gear(self, gear: &str) -> Self {
        Self { gears: vec![gear.to_owned()], ..self }
    }

    /// Restricts the record to one load.
    pub(crate) fn against(self, against: Against) -> Self {
        Self { against: Some(against), ..self }
    }

    /// Adds the record to others, and merges the gears of equal sets and reasons.
    pub(crate) fn join(mut self, all: &mut Vec<Self>) {
        let alike = |one: &&mut Self| {
            let part =
                |one: &Self| (one.against, one.mesh.clone(), one.toothed_gear.clone(), one.place, one.reason);
            part(one) == part(&self)
                && (&one.set, &one.missing, &one.because) == (&self.set, &self.missing, &self.because)
                && !one.gears.is_empty()
        };
        match all.iter_mut().find(alike) {
            Some(one) => one.gears.append(&mut self.gears),
            None => all.push(self),
        }
    }

    /// Keys that are missing, or the reason in words.
    pub(crate) fn lacks(&self) -> Vec<String> {
        if self.reason == Reason::KeysMissing { self.missing.clone() } else { vec![self.why()] }
    }

    /// Part and reason in words: `set 1: module missing`.
    pub(crate) fn told(&self) -> String {
        format!("{}: {}", self.of(), self.why())
    }

    /// Part that is not rated, in words: `set 1`, `set 1, mesh planet-ring, root of the ring`.
    #[must_use]
    pub fn of(&self) -> String {
        let mut words = format!("set {}", self.set);
        if let Some(mesh) = &self.mesh {
            words += &format!(", mesh {mesh}");
        }
        if let (Some(gear), Some(place)) = (&self.toothed_gear, self.place) {
            words += &format!(", {place} of the {gear}");
        }
        words
    }

    /// Reason in words.
    #[must_use]
    pub fn why(&self) -> String {
        let against = if self.against == Some(Against::Overload) { "against the overload: " } else { "" };
        let missing = self.missing.join(", ");
        let why = match (self.reason, &self.because) {
            (Reason::NoCommonRadius, _) => {
                "at these modules the meshes of a planet have no radius in common: state other modules"
                    .to_owned()
            }
            (Reason::PlanetAlone, _) => "a planet meshes with no central gear".to_owned(),
            (Reason::Bevel, _) => "its gears are bevel gears, which ISO 6336 does not rate".to_owned(),
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
