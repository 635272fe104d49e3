//! A planet set with three members, in short: its kind, its basic ratio, the losses of its meshes, the links
//! of its members.
//!
//! The short form names one of the usual arrangements; [`PlanetSet`](crate::PlanetSet) is the set it
//! represents, with every gear and mesh. A set with more members, or with shared planets, is described whole
//! by [`CompoundSpec`](crate::compound::CompoundSpec).

pub use crate::set_kind::SetKind;
pub use crate::tooth_shape::Shifts;

use crate::Error;
use crate::spacing::Spacing;
use crate::tolerance::BASIC_RATIO;
use crate::tooth_shape::ToothShape;
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::simple_set::{BasicRatio, Fraction};
use epicyclic_gears::teeth::ToothCount;

/// Known ratio of a set.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Gearing {
    /// Size of the basic ratio, `|i₀|`: of a simple set its ring-to-sun ratio `k`. The kind gives the sign.
    BasicRatio(f64),
    /// Teeth of the central gears 1 and 2.
    Teeth(ToothCount, ToothCount),
}

/// Losses in the meshes of a set.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum MeshLoss {
    /// `η₀` of the whole set with the carrier fixed.
    Set(MeshEfficiency),
    /// `η` of every mesh, from central gear 1 to central gear 2.
    Meshes {
        /// Central gear 1 with its planet.
        first: MeshEfficiency,
        /// Planet with planet, if a set has two; otherwise [`MeshEfficiency::IDEAL`].
        between: MeshEfficiency,
        /// Planet with central gear 2.
        second: MeshEfficiency,
    },
}

impl MeshLoss {
    /// A set without losses.
    pub const IDEAL: Self = Self::Set(MeshEfficiency::IDEAL);

    /// Losses of the sun–planet and planet–ring meshes of a set with one planet.
    #[must_use]
    pub fn sun_and_ring(sun_planet: MeshEfficiency, planet_ring: MeshEfficiency) -> Self {
        Self::Meshes { first: sun_planet, between: MeshEfficiency::IDEAL, second: planet_ring }
    }

    /// `η₀`, the product over the meshes.
    #[must_use]
    pub fn set_efficiency(self) -> MeshEfficiency {
        match self {
            Self::Set(eta) => eta,
            Self::Meshes { first, between, second } => MeshEfficiency::of_meshes(&[first, between, second]),
        }
    }
}

/// Description of one set, by name; [`GearboxBuilder`](crate::GearboxBuilder) turns it into a
/// [`PlanetSet`](crate::PlanetSet).
///
/// ```
/// use epicyclic_train::set::{SetKind, SetSpec};
/// # fn main() -> Result<(), epicyclic_gears::Error> {
/// let by_k = SetSpec::simple("P1", ["sun", "ring", "carrier"], 2.94);
/// let by_teeth = SetSpec::teeth("P2", SetKind::DoublePlanet, ["s", "r", "c"], 30, 72)?;
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct SetSpec {
    /// Name of the set.
    pub id: String,
    /// Kind.
    pub kind: SetKind,
    /// Links of sun (central gear 1), ring (central gear 2) and carrier. That of a pair's carrier is
    /// `ground`.
    pub members: [String; 3],
    /// Ratio or teeth.
    pub gearing: Gearing,
    /// Losses.
    pub loss: MeshLoss,
    /// Teeth of the planet, or of its step, in mesh with central gear 1: `z_g`.
    pub planet: Option<ToothCount>,
    /// Teeth of the second planet, or of the step, in mesh with central gear 2: `z_f`.
    pub second_planet: Option<ToothCount>,
    /// Number of planets, or pairs of planets, around the axis.
    pub planet_count: Option<u32>,
    /// Spacing of the planets on the carrier.
    pub spacing: Spacing,
    /// Shifts, helix angles and tools of its gears.
    pub tooth_shape: ToothShape,
}

impl SetSpec {
    /// A set of any kind known by the size of its basic ratio, `k = |i₀|`.
    #[must_use]
    pub fn new(id: &str, kind: SetKind, members: [&str; 3], k: f64) -> Self {
        Self {
            id: id.into(),
            kind,
            members: members.map(Into::into),
            gearing: Gearing::BasicRatio(k),
            loss: MeshLoss::IDEAL,
            planet: None,
            second_planet: None,
            planet_count: None,
            spacing: Spacing::default(),
            tooth_shape: ToothShape::default(),
        }
    }

    /// A simple set known by `k = z_b/z_a`.
    #[must_use]
    pub fn simple(id: &str, members: [&str; 3], k: f64) -> Self {
        Self::new(id, SetKind::Simple, members, k)
    }

    /// A set of any kind known by the teeth of its central gears. A stepped set also needs
    /// [`planet_teeth`](Self::planet_teeth).
    ///
    /// # Errors
    /// [`epicyclic_gears::Error::NoTeeth`] for a tooth count of 0.
    pub fn teeth(
        id: &str,
        kind: SetKind,
        members: [&str; 3],
        first: u32,
        second: u32,
    ) -> Result<Self, epicyclic_gears::Error> {
        let gearing = Gearing::Teeth(ToothCount::new(first)?, ToothCount::new(second)?);
        Ok(Self { gearing, ..Self::new(id, kind, members, 1.0) })
    }

    /// Two gears on fixed axes outside each other.
    ///
    /// # Errors
    /// [`epicyclic_gears::Error::NoTeeth`] for a tooth count of 0.
    pub fn pair(id: &str, gears: [&str; 2], first: u32, second: u32) -> Result<Self, epicyclic_gears::Error> {
        let [a, b] = gears;
        Self::teeth(id, SetKind::ExternalPair, [a, b, crate::GROUND], first, second)
    }

    /// Returns the set with these losses.
    #[must_use]
    pub fn with_loss(self, loss: MeshLoss) -> Self {
        Self { loss, ..self }
    }

    /// Returns the set with the teeth `z_g` and `z_f` of its planets or steps.
    #[must_use]
    pub fn planet_teeth(self, first: ToothCount, second: Option<ToothCount>) -> Self {
        Self { planet: Some(first), second_planet: second, ..self }
    }

    /// Returns the set with this number of planets.
    #[must_use]
    pub fn planet_count(self, count: u32) -> Self {
        Self { planet_count: Some(count), ..self }
    }

    /// Returns the set with this spacing of its planets. Given angles also set the number of planets, unless
    /// it is already known.
    #[must_use]
    pub fn spaced(self, spacing: Spacing) -> Self {
        let planet_count = self.planet_count.or(spacing.count());
        Self { planet_count, spacing, ..self }
    }

    /// Basic ratio as a number, and as an exact fraction where the teeth are known.
    pub(crate) fn ratio(&self) -> Result<(BasicRatio, Option<Fraction>), Error> {
        let bad_ratio = |k| Error::RingToSunRatio { set: self.id.clone(), kind: self.kind, k };
        let simple_fits = |k: f64| self.kind != SetKind::Simple || k > 1.0;
        match self.gearing {
            Gearing::BasicRatio(k) => {
                if !((1.0 / BASIC_RATIO..=BASIC_RATIO).contains(&k) && simple_fits(k)) {
                    return Err(bad_ratio(k));
                }
                let ratio = BasicRatio::new(self.kind.sign() * k).map_err(|_| bad_ratio(k))?;
                Ok((ratio, None))
            }
            Gearing::Teeth(first, second) => {
                let of = |teeth: ToothCount| i128::from(teeth.get());
                let mut size = Fraction::new(of(second), of(first));
                if self.kind.is_stepped() {
                    let (Some(g), Some(f)) = (self.planet, self.second_planet) else {
                        return Err(Error::StepsMissing { set: self.id.clone(), kind: self.kind });
                    };
                    size *= Fraction::new(of(g), of(f));
                }
                let k = *size.numer() as f64 / *size.denom() as f64;
                if !((1.0 / BASIC_RATIO..=BASIC_RATIO).contains(&k) && simple_fits(k)) {
                    return Err(bad_ratio(k));
                }
                let ratio = BasicRatio::new(self.kind.sign() * k).map_err(|_| bad_ratio(k))?;
                Ok((ratio, Some(if self.kind.sign() < 0.0 { -size } else { size })))
            }
        }
    }
}
