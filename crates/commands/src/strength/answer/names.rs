//! Names of the places of a safety (meshes, gears, flanks, roots), and of the loads that it is against.

use epicyclic_gears::involute::check::SetMesh;
use epicyclic_train::PlanetSet;
use epicyclic_train::planet_set::GearOf;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Serialize, Serializer};
use std::borrow::Cow;
use std::fmt;

/// Name of a mesh: its gears, joined by a hyphen in words and by an underscore in data.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MeshName {
    /// Names of the gears, the first one first.
    pub gears: [String; 2],
}

impl MeshName {
    /// A gear of the mesh; if it is in several of these meshes, with its mate: `planet at sun`.
    pub(crate) fn gear_among<'m>(&self, gear: &str, mut all: impl Iterator<Item = &'m Self>) -> String {
        let is_alone = all.all(|other| other == self || other.gears.iter().all(|one| one != gear));
        match self.gears.iter().find(|mate| *mate != gear) {
            Some(mate) if !is_alone => format!("{gear} at {mate}"),
            _ => gear.to_owned(),
        }
    }

    pub(crate) fn of(set: &PlanetSet, gears: [GearOf; 2]) -> Self {
        Self { gears: gears.map(|gear| set.gear_name(gear)) }
    }
}

impl fmt::Display for MeshName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&self.gears.join("-"))
    }
}

impl Serialize for MeshName {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&self.gears.join("_").replace(' ', "_"))
    }
}

impl JsonSchema for MeshName {
    fn schema_name() -> Cow<'static, str> {
        "MeshOfSet".into()
    }

    fn inline_schema() -> bool {
        true
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "type": "string", "description": "Names of the gears of a mesh: sun_planet." })
    }
}

impl From<SetMesh> for MeshName {
    fn from(mesh: SetMesh) -> Self {
        Self { gears: mesh.gears().map(|gear| gear.to_string()) }
    }
}

/// Loads against which a safety is computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Against {
    /// Load of the operating point for the required life.
    OperatingPoint,
    /// Duty of the file.
    Duty,
    /// Overload of the file.
    Overload,
}
