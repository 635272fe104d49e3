//! Words of a set: its kind, and what rolls in its planet bearings.

use epicyclic_gears::life::Rolling;
use epicyclic_train::set::SetKind;
use schemars::JsonSchema;
use serde::Deserialize;

/// Rolling elements of a bearing, or the oil that a plain one turns on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum RollingEntry {
    /// Not stated: balls. A pair, which has no planets, must not state it.
    #[default]
    #[serde(skip)]
    Unstated,
    /// Balls.
    Balls,
    /// Rollers in a cage.
    Rollers,
    /// Needles in a cage, which bear a faster orbit.
    Needles,
    /// Rollers or needles without a cage, which bear less speed.
    FullComplement,
    /// Oil: a plain bearing, whose `load_rating` is the load that it may bear.
    Plain,
}

impl From<RollingEntry> for Rolling {
    fn from(rolling: RollingEntry) -> Self {
        match rolling {
            RollingEntry::Unstated | RollingEntry::Balls => Self::Balls,
            RollingEntry::Rollers => Self::Rollers,
            RollingEntry::Needles => Self::Needles,
            RollingEntry::FullComplement => Self::FullComplement,
            RollingEntry::Plain => Self::Plain,
        }
    }
}

/// A kind of set.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum KindEntry {
    /// Sun, ring, one planet in mesh with both.
    #[default]
    Simple,
    /// Sun, ring, two planets in mesh between them.
    DoublePlanet,
    /// Stepped planet between a sun and a ring.
    SteppedSunRing,
    /// Stepped planet between two suns.
    SteppedSuns,
    /// Stepped planet between two rings.
    SteppedRings,
    /// Two suns, each with its planet, the planets in mesh.
    MeshingSuns,
    /// Bevel set.
    Bevel,
    /// Two wheels outside each other on fixed axes.
    ExternalPair,
    /// A pinion in a ring on fixed axes.
    InternalPair,
}

impl From<KindEntry> for SetKind {
    fn from(kind: KindEntry) -> Self {
        match kind {
            KindEntry::Simple => Self::Simple,
            KindEntry::DoublePlanet => Self::DoublePlanet,
            KindEntry::SteppedSunRing => Self::SteppedSunRing,
            KindEntry::SteppedSuns => Self::SteppedSuns,
            KindEntry::SteppedRings => Self::SteppedRings,
            KindEntry::MeshingSuns => Self::MeshingSuns,
            KindEntry::Bevel => Self::Bevel,
            KindEntry::ExternalPair => Self::ExternalPair,
            KindEntry::InternalPair => Self::InternalPair,
        }
    }
}
