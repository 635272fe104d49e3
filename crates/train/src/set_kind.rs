//! Kinds of sets: arrangements of the planets between the two central gears.

use epicyclic_gears::geometry::GearKind;
use std::fmt;

/// Kind of a set: the arrangement of the planets between the two central gears.
///
/// | kind | central gears `1`, `2` | `i₀` |
/// |---|---|---|
/// | [`Simple`](Self::Simple) | sun, ring | `−z_2/z_1` |
/// | [`DoublePlanet`](Self::DoublePlanet) | sun, ring | `+z_2/z_1` |
/// | [`SteppedSunRing`](Self::SteppedSunRing) | sun, ring | `−(z_g/z_1)·(z_2/z_f)` |
/// | [`SteppedSuns`](Self::SteppedSuns) | two suns | `+(z_g/z_1)·(z_2/z_f)` |
/// | [`SteppedRings`](Self::SteppedRings) | two rings | `+(z_g/z_1)·(z_2/z_f)` |
/// | [`MeshingSuns`](Self::MeshingSuns) | two suns of planets in mesh | `−z_2/z_1` |
/// | [`Bevel`](Self::Bevel) | two bevel gears | `−z_2/z_1` |
/// | [`ExternalPair`](Self::ExternalPair) | two gears on fixed axes | `−z_2/z_1` |
/// | [`InternalPair`](Self::InternalPair) | pinion, ring on fixed axes | `+z_2/z_1` |
///
/// The first central gear is called the sun and the second the ring throughout. The carrier of a
/// pair is the housing. Of the steps of a planet `g` meshes with central gear 1 and `f` with central gear 2.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum SetKind {
    /// Sun, ring, one planet in mesh with both.
    Simple,
    /// Sun, ring, two planets in mesh between them.
    DoublePlanet,
    /// Stepped planet between a sun and a ring.
    SteppedSunRing,
    /// Stepped planet between two suns.
    SteppedSuns,
    /// Stepped planet between two rings.
    SteppedRings,
    /// Two suns, each with its planet, the planets in mesh (Ravigneaux without its ring).
    MeshingSuns,
    /// Bevel set.
    Bevel,
    /// Two gears outside each other on fixed axes.
    ExternalPair,
    /// A pinion in a ring on fixed axes.
    InternalPair,
}

impl SetKind {
    /// Number of meshes from the first central gear to the second.
    #[must_use]
    pub fn meshes(self) -> usize {
        match self {
            Self::ExternalPair | Self::InternalPair => 1,
            Self::DoublePlanet | Self::MeshingSuns => 3,
            _ => 2,
        }
    }

    /// Names of the gears, in the order of [`PlanetSet::gears`](crate::PlanetSet::gears), and whether they
    /// are external or internal; `None` of bevel gears.
    #[must_use]
    pub fn gears(self) -> Vec<(&'static str, Option<GearKind>)> {
        let (external, internal) = (Some(GearKind::External), Some(GearKind::Internal));
        let two = [("planet 1", external), ("planet 2", external)];
        let with = |first, planets: &[_], last| [&[first], planets, &[last]].concat();
        match self {
            Self::Simple => with(("sun", external), &[("planet", external)], ("ring", internal)),
            Self::DoublePlanet | Self::SteppedSunRing => with(("sun", external), &two, ("ring", internal)),
            Self::SteppedSuns | Self::MeshingSuns => with(("sun 1", external), &two, ("sun 2", external)),
            Self::SteppedRings => with(("ring 1", internal), &two, ("ring 2", internal)),
            Self::Bevel => {
                let bevel = [("bevel gear 1", None), ("planet", external), ("bevel gear 2", None)];
                bevel.to_vec()
            }
            Self::ExternalPair => vec![("gear 1", external), ("gear 2", external)],
            Self::InternalPair => vec![("gear 1", external), ("gear 2", internal)],
        }
    }

    /// Sign of the basic ratio.
    #[must_use]
    pub fn sign(self) -> f64 {
        match self {
            Self::Simple | Self::SteppedSunRing | Self::MeshingSuns | Self::Bevel | Self::ExternalPair => {
                -1.0
            }
            Self::DoublePlanet | Self::SteppedSuns | Self::SteppedRings | Self::InternalPair => 1.0,
        }
    }

    /// Whether the planet has two steps `g`, `f` on one shaft.
    #[must_use]
    pub fn is_stepped(self) -> bool {
        matches!(self, Self::SteppedSunRing | Self::SteppedSuns | Self::SteppedRings)
    }

    /// Whether the carrier is the housing.
    #[must_use]
    pub fn is_pair(self) -> bool {
        matches!(self, Self::ExternalPair | Self::InternalPair)
    }
}

impl fmt::Display for SetKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Simple => "simple",
            Self::DoublePlanet => "double planet",
            Self::SteppedSunRing => "stepped, sun and ring",
            Self::SteppedSuns => "stepped, two suns",
            Self::SteppedRings => "stepped, two rings",
            Self::MeshingSuns => "meshing suns",
            Self::Bevel => "bevel",
            Self::ExternalPair => "external pair",
            Self::InternalPair => "internal pair",
        })
    }
}
