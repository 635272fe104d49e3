//! A row in a gearbox: its kind, its stationary ratio, what its meshes lose, where its members go.

use crate::Error;
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::row::{Fraction, StationaryRatio};
use epicyclic_gears::teeth::ToothCount;
use std::fmt;

/// How the planets of a row join its two central wheels.
///
/// | kind | central wheels `1`, `2` | `i₀` |
/// |---|---|---|
/// | [`Simple`](Self::Simple) | sun, ring | `−z_2/z_1` |
/// | [`DoublePlanet`](Self::DoublePlanet) | sun, ring | `+z_2/z_1` |
/// | [`SteppedSunRing`](Self::SteppedSunRing) | sun, ring | `−(z_g/z_1)·(z_2/z_f)` |
/// | [`SteppedSuns`](Self::SteppedSuns) | two suns | `+(z_g/z_1)·(z_2/z_f)` |
/// | [`SteppedRings`](Self::SteppedRings) | two rings | `+(z_g/z_1)·(z_2/z_f)` |
/// | [`MeshingSuns`](Self::MeshingSuns) | two suns of planets in mesh | `−z_2/z_1` |
/// | [`Bevel`](Self::Bevel) | two bevel wheels | `−z_2/z_1` |
/// | [`ExternalPair`](Self::ExternalPair) | two wheels on fixed axes | `−z_2/z_1` |
/// | [`InternalPair`](Self::InternalPair) | pinion, ring on fixed axes | `+z_2/z_1` |
///
/// The first central wheel is called the sun and the second the ring throughout. The carrier of a
/// pair is the housing. Of the steps of a planet `g` meshes with wheel 1 and `f` with wheel 2.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum RowKind {
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
    /// Bevel row.
    Bevel,
    /// Two wheels outside each other on fixed axes.
    ExternalPair,
    /// A pinion in a ring on fixed axes.
    InternalPair,
}

impl RowKind {
    /// Sign of the stationary ratio.
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

impl fmt::Display for RowKind {
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

/// What is known of a row's ratio.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Gearing {
    /// `k = |i₀|`; the kind gives the sign.
    Parameter(f64),
    /// Teeth of the central wheels 1 and 2.
    Teeth(ToothCount, ToothCount),
}

/// What the meshes of a row lose.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum MeshLoss {
    /// `η₀` of the whole row under a resting carrier.
    Row(MeshEfficiency),
    /// `η` of every mesh, from wheel 1 to wheel 2.
    Meshes {
        /// Wheel 1 with its planet.
        first: MeshEfficiency,
        /// Planet with planet, where there are two; otherwise [`MeshEfficiency::IDEAL`].
        between: MeshEfficiency,
        /// Planet with wheel 2.
        second: MeshEfficiency,
    },
}

impl MeshLoss {
    /// A row without losses.
    pub const IDEAL: Self = Self::Row(MeshEfficiency::IDEAL);

    /// Losses of the sun–planet and planet–ring meshes of a row with one planet.
    #[must_use]
    pub fn sun_and_ring(sun_planet: MeshEfficiency, planet_ring: MeshEfficiency) -> Self {
        Self::Meshes { first: sun_planet, between: MeshEfficiency::IDEAL, second: planet_ring }
    }

    /// `η₀`, the product over the meshes.
    #[must_use]
    pub fn row_efficiency(self) -> MeshEfficiency {
        match self {
            Self::Row(eta) => eta,
            Self::Meshes { first, between, second } => MeshEfficiency::of_meshes(&[first, between, second]),
        }
    }
}

/// Description of one row, by name; [`GearboxBuilder`](crate::GearboxBuilder) turns it into a [`Row`].
///
/// ```
/// use epicyclic_schemes::row::{RowKind, RowSpec};
/// # fn main() -> Result<(), epicyclic_gears::Error> {
/// let by_k = RowSpec::simple("P1", ["sun", "ring", "carrier"], 2.94);
/// let by_teeth = RowSpec::teeth("P2", RowKind::DoublePlanet, ["s", "r", "c"], 30, 72)?;
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct RowSpec {
    /// Name of the row.
    pub id: String,
    /// Kind.
    pub kind: RowKind,
    /// Links of sun (wheel 1), ring (wheel 2) and carrier. That of a pair's carrier is `ground`.
    pub members: [String; 3],
    /// Ratio or teeth.
    pub gearing: Gearing,
    /// Losses.
    pub loss: MeshLoss,
    /// Teeth of the planet, or of its step, in mesh with wheel 1: `z_g`.
    pub planet: Option<ToothCount>,
    /// Teeth of the second planet, or of the step, in mesh with wheel 2: `z_f`.
    pub second_planet: Option<ToothCount>,
    /// How many planets, or pairs of planets, stand around the axis.
    pub planet_count: Option<u32>,
}

impl RowSpec {
    /// A row of any kind known by the size of its stationary ratio, `k = |i₀|`.
    #[must_use]
    pub fn new(id: &str, kind: RowKind, members: [&str; 3], k: f64) -> Self {
        Self {
            id: id.into(),
            kind,
            members: members.map(Into::into),
            gearing: Gearing::Parameter(k),
            loss: MeshLoss::IDEAL,
            planet: None,
            second_planet: None,
            planet_count: None,
        }
    }

    /// A simple row known by `k = z_b/z_a`.
    #[must_use]
    pub fn simple(id: &str, members: [&str; 3], k: f64) -> Self {
        Self::new(id, RowKind::Simple, members, k)
    }

    /// A row of any kind known by the teeth of its central wheels. A stepped row also needs
    /// [`planet_teeth`](Self::planet_teeth).
    ///
    /// # Errors
    /// [`epicyclic_gears::Error::NoTeeth`] for a tooth count of 0.
    pub fn teeth(
        id: &str,
        kind: RowKind,
        members: [&str; 3],
        first: u32,
        second: u32,
    ) -> Result<Self, epicyclic_gears::Error> {
        let gearing = Gearing::Teeth(ToothCount::new(first)?, ToothCount::new(second)?);
        Ok(Self { gearing, ..Self::new(id, kind, members, 1.0) })
    }

    /// Two wheels on fixed axes outside each other.
    ///
    /// # Errors
    /// [`epicyclic_gears::Error::NoTeeth`] for a tooth count of 0.
    pub fn pair(
        id: &str,
        wheels: [&str; 2],
        first: u32,
        second: u32,
    ) -> Result<Self, epicyclic_gears::Error> {
        let [a, b] = wheels;
        Self::teeth(id, RowKind::ExternalPair, [a, b, crate::GROUND], first, second)
    }

    /// The same row with these losses.
    #[must_use]
    pub fn with_loss(self, loss: MeshLoss) -> Self {
        Self { loss, ..self }
    }

    /// The same row with the teeth `z_g` and `z_f` of its planets or steps.
    #[must_use]
    pub fn planet_teeth(self, first: ToothCount, second: Option<ToothCount>) -> Self {
        Self { planet: Some(first), second_planet: second, ..self }
    }

    /// The same row with this many planets.
    #[must_use]
    pub fn planet_count(self, count: u32) -> Self {
        Self { planet_count: Some(count), ..self }
    }

    /// Stationary ratio as a number, and as an exact fraction where the teeth are known.
    pub(crate) fn ratio(&self) -> Result<(StationaryRatio, Option<Fraction>), Error> {
        let bad_parameter = |k| Error::RowParameter { row: self.id.clone(), kind: self.kind, k };
        let simple_fits = |k: f64| self.kind != RowKind::Simple || k > 1.0;
        match self.gearing {
            Gearing::Parameter(k) => {
                if !(k > 0.0 && k.is_finite() && simple_fits(k)) {
                    return Err(bad_parameter(k));
                }
                let ratio = StationaryRatio::new(self.kind.sign() * k).map_err(|_| bad_parameter(k))?;
                Ok((ratio, None))
            }
            Gearing::Teeth(first, second) => {
                let of = |teeth: ToothCount| i128::from(teeth.get());
                let mut size = Fraction::new(of(second), of(first));
                if self.kind.is_stepped() {
                    let (Some(g), Some(f)) = (self.planet, self.second_planet) else {
                        return Err(Error::StepsMissing { row: self.id.clone(), kind: self.kind });
                    };
                    size *= Fraction::new(of(g), of(f));
                }
                let k = *size.numer() as f64 / *size.denom() as f64;
                if !simple_fits(k) {
                    return Err(bad_parameter(k));
                }
                let ratio = StationaryRatio::new(self.kind.sign() * k).map_err(|_| bad_parameter(k))?;
                Ok((ratio, Some(if self.kind.sign() < 0.0 { -size } else { size })))
            }
        }
    }
}

/// One planet, or step of a planet, of a row: what its speed relative to the carrier follows from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct PlanetRatio {
    /// 0: rolls on wheel 1; 1: rolls on wheel 2.
    pub(crate) wheel: usize,
    /// `(ω_g − ω_H)/(ω_wheel − ω_H)`.
    pub(crate) factor: f64,
}

/// A row of a built gearbox.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    pub(crate) spec: RowSpec,
    pub(crate) members: [crate::LinkId; 3],
    pub(crate) ratio: StationaryRatio,
    pub(crate) exact: Option<Fraction>,
}

impl Row {
    /// Name of the row.
    #[must_use]
    pub fn id(&self) -> &str {
        &self.spec.id
    }

    /// What it was built from.
    #[must_use]
    pub fn spec(&self) -> &RowSpec {
        &self.spec
    }

    /// Links of sun (wheel 1), ring (wheel 2) and carrier.
    #[must_use]
    pub fn members(&self) -> [crate::LinkId; 3] {
        self.members
    }

    /// Stationary ratio `i₀`.
    #[must_use]
    pub fn stationary_ratio(&self) -> StationaryRatio {
        self.ratio
    }

    /// `i₀` as a fraction of tooth counts, where they are known.
    #[must_use]
    pub fn exact_ratio(&self) -> Option<Fraction> {
        self.exact
    }

    /// How the planets turn relative to the carrier: one entry a planet on its own axis.
    ///
    /// A simple row known by `k` alone has `z_g/z_a = (k − 1)/2` by coaxiality; planets of the
    /// other kinds are known by their teeth only.
    pub(crate) fn planets(&self) -> Vec<PlanetRatio> {
        let central = match self.spec.gearing {
            Gearing::Teeth(first, second) => Some([first.as_f64(), second.as_f64()]),
            Gearing::Parameter(_) => None,
        };
        let rolling = |wheel: usize, planet: Option<ToothCount>, sign: f64| {
            let factor = sign * central?[wheel] / planet?.as_f64();
            Some(PlanetRatio { wheel, factor })
        };
        let (g, f) = (self.spec.planet, self.spec.second_planet);
        let found = match self.spec.kind {
            RowKind::ExternalPair | RowKind::InternalPair => vec![],
            RowKind::Simple if g.is_none() || central.is_none() => {
                let k = -self.ratio.get();
                vec![Some(PlanetRatio { wheel: 0, factor: -2.0 / (k - 1.0) })]
            }
            RowKind::Simple | RowKind::SteppedSunRing | RowKind::SteppedSuns | RowKind::Bevel => {
                vec![rolling(0, g, -1.0)]
            }
            RowKind::SteppedRings => vec![rolling(0, g, 1.0)],
            RowKind::DoublePlanet => vec![rolling(0, g, -1.0), rolling(1, f, 1.0)],
            RowKind::MeshingSuns => vec![rolling(0, g, -1.0), rolling(1, f, -1.0)],
        };
        found.into_iter().flatten().collect()
    }
}
