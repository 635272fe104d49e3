//! Names of the places of a safety (meshes, gears, flanks, roots), and of the loads that it is against.

use epicyclic_gears::involute::check::SetMesh;
use schemars::JsonSchema;
use serde::Serialize;

/// Name of a mesh in tables and messages, its gears joined by a hyphen.
pub(crate) fn mesh_name(mesh: SetMesh) -> String {
    mesh.gears().map(|gear| gear.to_string()).join("-")
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
