//! Records of the catalogue's gearboxes, which several answers share: links, gears, shift elements, speeds.

use crate::shared::number::plain;
use epicyclic_schemes::catalogue::{SchemeElement, SchemeGear};
use epicyclic_schemes::structures::Role;
use epicyclic_train::speeds::PlanetMotion;
use schemars::JsonSchema;
use serde::Serialize;
use std::fmt;

/// A link of a gearbox of the catalogue.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
pub enum Link {
    /// The driving shaft.
    D,
    /// The driven shaft.
    B,
    /// The link braked in gear 1.
    T1,
    /// The link braked in gear 2.
    T2,
}

impl Link {
    /// The link of this role.
    #[must_use]
    pub fn of(role: Role) -> Self {
        match role {
            Role::D => Self::D,
            Role::B => Self::B,
            Role::T1 => Self::T1,
            Role::T2 => Self::T2,
        }
    }

    /// The link of this name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        [Self::D, Self::B, Self::T1, Self::T2].into_iter().find(|link| link.name() == name)
    }

    pub(crate) const fn role(self) -> Role {
        match self {
            Self::D => Role::D,
            Self::B => Role::B,
            Self::T1 => Role::T1,
            Self::T2 => Role::T2,
        }
    }

    /// Name in the sources and in gearbox files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        self.role().symbol()
    }
}

impl fmt::Display for Link {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// A gear of a gearbox of the catalogue.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
pub enum GearName {
    /// The first brake is engaged.
    #[serde(rename = "1")]
    First,
    /// The second brake is engaged.
    #[serde(rename = "2")]
    Second,
    /// The direct-drive clutch is engaged.
    #[serde(rename = "direct")]
    Direct,
}

impl GearName {
    /// The gear of a scheme.
    #[must_use]
    pub const fn of(gear: SchemeGear) -> Self {
        match gear {
            SchemeGear::First => Self::First,
            SchemeGear::Second => Self::Second,
            SchemeGear::Direct => Self::Direct,
        }
    }

    /// The gear of this name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        [Self::First, Self::Second, Self::Direct].into_iter().find(|gear| gear.name() == name)
    }

    const fn of_scheme(self) -> SchemeGear {
        match self {
            Self::First => SchemeGear::First,
            Self::Second => SchemeGear::Second,
            Self::Direct => SchemeGear::Direct,
        }
    }

    /// Name in the sources and in the gearbox.
    #[must_use]
    pub const fn name(self) -> &'static str {
        self.of_scheme().name()
    }

    /// Shift element engaged in the gear.
    #[must_use]
    pub const fn engaged(self) -> ShiftElement {
        ShiftElement::of(self.of_scheme().engaged())
    }
}

impl fmt::Display for GearName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// A shift element of a gearbox of the catalogue.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
pub enum ShiftElement {
    /// The brake on T1, engaged in gear 1.
    K1,
    /// The brake on T2, engaged in gear 2.
    K2,
    /// The direct-drive clutch.
    L,
}

impl ShiftElement {
    const fn of(element: SchemeElement) -> Self {
        match element {
            SchemeElement::FirstBrake => Self::K1,
            SchemeElement::SecondBrake => Self::K2,
            SchemeElement::DirectClutch => Self::L,
        }
    }

    const fn of_scheme(self) -> SchemeElement {
        match self {
            Self::K1 => SchemeElement::FirstBrake,
            Self::K2 => SchemeElement::SecondBrake,
            Self::L => SchemeElement::DirectClutch,
        }
    }

    /// Name in the sources and in the gearbox.
    #[must_use]
    pub const fn name(self) -> &'static str {
        self.of_scheme().name()
    }
}

/// The links of the members of a simple set.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct SetLinks {
    /// Link of the sun.
    pub sun: Link,
    /// Link of the ring.
    pub ring: Link,
    /// Link of the carrier.
    pub carrier: Link,
}

impl SetLinks {
    /// The links of these roles of sun, ring and carrier.
    #[must_use]
    pub fn of([sun, ring, carrier]: [Role; 3]) -> Self {
        Self { sun: Link::of(sun), ring: Link::of(ring), carrier: Link::of(carrier) }
    }

    /// Links of sun, ring and carrier.
    #[must_use]
    pub const fn links(&self) -> [Link; 3] {
        [self.sun, self.ring, self.carrier]
    }
}

/// Speeds in a simple set as multiples of the input's.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct SetSpeeds {
    /// Speed of the sun over that of the input.
    pub sun_of_input: Option<f64>,
    /// Speed of the ring over that of the input.
    pub ring_of_input: Option<f64>,
    /// Speed of the carrier over that of the input.
    pub carrier_of_input: Option<f64>,
    /// Speed of the planets about their own axes, over that of the input.
    pub planet_of_input: Option<f64>,
    /// Speed of the planets relative to their carrier, over that of the input.
    pub relative_planet_of_input: Option<f64>,
}

impl SetSpeeds {
    /// Speeds from those of sun, ring and carrier, and the motion of the planets.
    pub(crate) fn of(
        [sun_of_input, ring_of_input, carrier_of_input]: [Option<f64>; 3],
        planet: Option<PlanetMotion>,
    ) -> Self {
        Self {
            sun_of_input: sun_of_input.map(plain),
            ring_of_input: ring_of_input.map(plain),
            carrier_of_input: carrier_of_input.map(plain),
            planet_of_input: planet.and_then(|planet| planet.speed).map(plain),
            relative_planet_of_input: planet.map(|planet| plain(planet.relative)),
        }
    }
}

/// A range of ring-to-sun ratios.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct KRange {
    /// The least.
    pub least: f64,
    /// The greatest.
    pub greatest: f64,
}

impl KRange {
    /// From its ends.
    #[must_use]
    pub const fn of(least: f64, greatest: f64) -> Self {
        Self { least, greatest }
    }
}
