//! Sets that the tests share.

use epicyclic_vibration::{
    Body, Central, Group, Kind, Planet, PlanetarySet, Stiffness, Support, newtons_per_meter,
};
use uom::si::f64::{Angle, Frequency, Length, Mass};
use uom::si::{angle::degree, frequency::hertz, length::meter, mass::kilogram};

pub(crate) fn n_m(value: f64) -> Stiffness {
    newtons_per_meter(value)
}

/// A body of a mass and an `I/r²`, in kg.
pub(crate) fn body(mass: f64, rotary: f64, radius: f64) -> Body {
    let kg = Mass::new::<kilogram>;
    Body::with_rotary_mass(kg(mass), kg(rotary), Length::new::<meter>(radius))
}

pub(crate) fn degrees(value: f64) -> Angle {
    Angle::new::<degree>(value)
}

pub(crate) fn hz(value: Frequency) -> f64 {
    value.get::<hertz>()
}

/// Radius of the planets' circle of [`lin_parker`], m: chosen, as frequencies depend on `I/r²` alone.
pub(crate) const CARRIER_RADIUS: f64 = 0.1;

/// The example of Lin and Parker 1999. Base radii are those that a circle of planets of 0.1 m gives with
/// 24.6°.
pub(crate) fn lin_parker(planets: usize) -> PlanetarySet {
    let support = |radial, tangential| Support { radial: n_m(radial), tangential: n_m(tangential) };
    let cos = libm::cos(24.6_f64.to_radians());
    let [sun, ring, planet] = [0.045, 0.155, 0.055].map(|radius| radius * cos);
    let planet = Planet {
        body: body(0.66, 0.61, planet),
        angle: degrees(0.0),
        bearing: n_m(1e8),
        sun_mesh: n_m(5e8),
        ring_mesh: n_m(5e8),
    };
    PlanetarySet {
        sun: Central::new(body(0.4, 0.39, sun), support(1e8, 0.0)),
        ring: Central::new(body(2.35, 3.0, ring), support(1e8, 1e9)),
        carrier: Central::new(body(5.43, 6.29, CARRIER_RADIUS), support(1e8, 0.0)),
        planets: planet.equally_spaced(planets),
        sun_pressure_angle: degrees(24.6),
        ring_pressure_angle: degrees(24.6),
    }
}

/// Groups of a planar set.
pub(crate) fn groups(set: &PlanetarySet) -> Vec<Group> {
    let (model, parts) = set.planar().unwrap();
    model.groups(&parts.central()).unwrap()
}

/// Frequencies of a kind with their multiplicities.
pub(crate) fn of_kind(groups: &[Group], kind: Kind) -> Vec<(f64, usize)> {
    groups
        .iter()
        .filter(|group| group.kind == kind)
        .map(|group| (hz(group.frequency), group.multiplicity()))
        .collect()
}
