//! What safeties are of: meshes and gears of a simple set, flanks and roots; and what they are against.

use schemars::JsonSchema;
use serde::Serialize;
use std::fmt;

/// A mesh of a simple set.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum MeshName {
    /// Of sun and planets.
    SunPlanet,
    /// Of planets and ring.
    PlanetRing,
}

impl MeshName {
    /// Both.
    pub const BOTH: [Self; 2] = [Self::SunPlanet, Self::PlanetRing];

    /// Its gears, in the order of the calculation.
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

/// A gear of a simple set.
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

/// Where a tooth fails.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Place {
    /// The flank, by pitting.
    Flank,
    /// The root, by bending.
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

/// What a safety is against.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Against {
    /// The load of the operating point for the required life.
    OperatingPoint,
    /// The duty.
    Duty,
    /// An overload of the file.
    Overload,
}
