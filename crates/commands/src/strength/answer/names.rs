//! Names of the places of a safety (meshes, gears, flanks, roots), and of the loads that it is against.

use schemars::JsonSchema;
use serde::Serialize;
use std::fmt;

/// Meshes of a simple set.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum MeshName {
    /// Mesh of sun and planets.
    SunPlanet,
    /// Mesh of planets and ring.
    PlanetRing,
}

impl MeshName {
    /// List of both meshes.
    pub const BOTH: [Self; 2] = [Self::SunPlanet, Self::PlanetRing];

    /// Gears of the mesh, in the order of the calculation.
    #[must_use]
    pub const fn gears(self) -> [ToothedGear; 2] {
        match self {
            Self::SunPlanet => [ToothedGear::Sun, ToothedGear::Planet],
            Self::PlanetRing => [ToothedGear::Planet, ToothedGear::Ring],
        }
    }
}

impl fmt::Display for MeshName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [first, second] = self.gears();
        write!(f, "{first}-{second}")
    }
}

/// Gears of a simple set.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ToothedGear {
    /// The sun.
    Sun,
    /// A planet.
    Planet,
    /// The ring.
    Ring,
}

impl fmt::Display for ToothedGear {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Sun => "sun",
            Self::Planet => "planet",
            Self::Ring => "ring",
        })
    }
}

/// Places of failure of a tooth.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Place {
    /// Flank, which fails by pitting.
    Flank,
    /// Root, which fails by bending.
    Root,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Flank => "flank",
            Self::Root => "root",
        })
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
