//! Efficiency, speeds, torques and powers of a drive at its power.

use super::part::Computed;
use super::result::{Efficiency, Powers, Speeds, TeethDesign, Torques};
use super::{MODE, finite};
use crate::planetary::GearSet;
use crate::{Error, loads};
use epicyclic_gears::efficiency::{self, MeshEfficiency};
use epicyclic_units::Physical;
use uom::si::f64::{AngularVelocity, Power};

/// Load of the gear set: efficiency, speeds, torques and powers.
pub(super) struct Carried {
    pub(super) efficiency: Efficiency,
    pub(super) speeds: Speeds,
    pub(super) torques: Torques,
    pub(super) powers: Powers,
}

/// Efficiencies of the meshes, and of the bearings that a planet turns in between them.
#[derive(Clone, Copy)]
pub(super) struct Meshes {
    pub(super) sun_planet: MeshEfficiency,
    pub(super) planet_bearings: MeshEfficiency,
    pub(super) planet_ring: MeshEfficiency,
}

impl Meshes {
    /// Efficiencies from the sun to the planets' teeth, and from there through the planet bearings to the
    /// ring.
    pub(super) fn two(self) -> [MeshEfficiency; 2] {
        [self.sun_planet, MeshEfficiency::of_meshes(&[self.planet_bearings, self.planet_ring])]
    }
}

pub(super) fn carried(
    power: Power,
    speed: AngularVelocity,
    meshes: Meshes,
    set: &GearSet,
    teeth: &TeethDesign,
) -> Result<Carried, Error> {
    let eta0 = MeshEfficiency::of_meshes(&meshes.two());
    let overall = efficiency::efficiency(teeth.numbers.basic_ratio(), eta0, MODE)?;
    let ratios = set.ratios();
    let (planet, carrier) = (speed * ratios.planet, speed * ratios.carrier);
    let speeds = Speeds { sun: speed, planet, planet_relative: planet - carrier, carrier };
    finite(Computed::PlanetSpeed, planet.si())?;

    let sun = loads::shaft_torque(power, speed)?;
    let planet_to_sun = teeth.numbers.planet.as_f64() / teeth.numbers.sun.as_f64();
    let carrier = loads::carrier_torque(sun, teeth.ratio, overall);
    finite(Computed::CarrierTorque, carrier.si())?;
    let planets = loads::planet_torque(sun, meshes.sun_planet, planet_to_sun);
    let torques = Torques { sun, planets, carrier, ring_reaction: carrier - sun };

    let mesh = loads::shaft_power(sun, speeds.sun - speeds.carrier);
    let powers = Powers {
        input: power,
        mesh,
        lost: mesh * (1.0 - eta0.get()),
        planets: loads::planet_power(power, meshes.sun_planet, meshes.planet_bearings),
        output: loads::shaft_power(carrier, speeds.carrier),
    };
    Ok(Carried { efficiency: Efficiency { basic: eta0.get(), overall }, speeds, torques, powers })
}
