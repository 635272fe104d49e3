//! Records of the catalogue's gearboxes, which several answers share: links, gears, shift elements, speeds.

use crate::shared::number::plain;
use epicyclic_schemes::structures::Role;
use epicyclic_train::speeds::PlanetMotion;
use schemars::JsonSchema;
use serde::Serialize;

/// The links of the members of a simple set.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct SetLinks {
    /// Link of the sun.
    pub sun: Role,
    /// Link of the ring.
    pub ring: Role,
    /// Link of the carrier.
    pub carrier: Role,
}

impl SetLinks {
    /// The links of these roles of sun, ring and carrier.
    #[must_use]
    pub fn of([sun, ring, carrier]: [Role; 3]) -> Self {
        Self { sun, ring, carrier }
    }

    /// Links of sun, ring and carrier.
    #[must_use]
    pub const fn links(&self) -> [Role; 3] {
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
