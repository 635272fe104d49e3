//! The design of a planetary drive from power, speed and ratio to the time it takes to start.
//!
//! Driven at the sun, ring at rest, load on the carrier. One pure function, [`design`], takes a
//! [`DriveSpec`] through
//!
//! ```text
//! ratio → teeth → efficiency → speeds → torques → diameters → shafts, bearings → masses, inertias
//!       → forces → J_pr, T → accelerations → starting time
//! ```
//!
//! What stops the calculation is an [`Error`]; what deserves a second look is a [`Warning`].
//!
//! # Source
//! excavator-dynamics, from end to end. Departures from it: the planet speed is that on the turning
//! carrier, inertias are those of the shapes described, `J_pr` has `(z_1 + z_3)²` in every term, and a
//! default sun sits on its shaft rather than on a bearing.
//!
//! # Left out
//! Strength of the teeth, bending of shafts and planet pins, life of the bearings, losses outside the meshes,
//! a mesh load factor above 1 (planets that share the load unequally).
//!
//! # Example
//!
//! ```
//! use epicyclic_dynamics::drive::{DriveSpec, Start, design};
//! use uom::si::angular_velocity::revolution_per_minute;
//! use uom::si::f64::{AngularVelocity, Length, Power, Torque};
//! use uom::si::{length::millimeter, power::kilowatt, torque::newton_meter};
//!
//! let mm = Length::new::<millimeter>;
//! let speed = AngularVelocity::new::<revolution_per_minute>(1950.0);
//! let spec = DriveSpec::new(Power::new::<kilowatt>(106.5), speed, 6.0, mm(8.0), mm(60.0));
//! let full_load = design(&spec)?;
//! assert!((full_load.torques.sun.get::<newton_meter>() - 521.5).abs() < 0.1);
//! assert_eq!(full_load.with_losses.start, Start::InBalance);
//!
//! let half_load = design(&DriveSpec { load: Some(full_load.torques.carrier / 2.0), ..spec })?;
//! assert!(matches!(half_load.with_losses.start, Start::After(_)));
//! # Ok::<(), epicyclic_dynamics::Error>(())
//! ```

mod bodies;
mod motion;
mod result;
mod shafts;
mod spec;
mod teeth;
#[cfg(test)]
mod tests;
mod warning;

pub use result::{
    BoredGear, Choice, DriveDesign, Efficiency, EquivalentInertia, Forces, GearMass, GearSetGeometry, Masses,
    Motion, Powers, Shaft, ShaftDesign, Shafts, Speeds, Start, TeethDesign, Torques,
};
pub use spec::{
    Bore, CarrierSpec, DriveSpec, GearSetSpec, Given, ShaftSpec, ShaftsSpec, TeethSpec, default_bounds,
};
pub use warning::Warning;

use crate::units::{angular_velocity, force, meters, n_m, newtons, rad_per_s};
use crate::{Error, loads};
use epicyclic_gears::efficiency::{self, MeshEfficiency};
use epicyclic_gears::geometry::{self, GearKind, centre_distance};
use epicyclic_gears::simple_set::{Member, Mode};
use epicyclic_gears::synthesis::{ToothNumbers, check_tolerance};
use epicyclic_gears::{planet_bearing, willis};
use uom::si::angular_velocity::revolution_per_minute;
use uom::si::power::kilowatt;

/// Usual range of the ratio of a single stage.
///
/// # Source
/// excavator-dynamics.
pub const USUAL_RATIO: std::ops::RangeInclusive<f64> = 3.0..=10.0;

/// Designs a drive.
///
/// # Errors
/// [`Error::Gear`] with the part's own error for quantities out of range, a ratio that no set of tooth numbers
/// reaches, gears without root, holes outside their arms, shafts beyond the standard diameters;
/// [`Error::UnequalCentreDistances`], [`Error::BoreTooLarge`], [`Error::Impossible`], [`Error::NotFinite`],
/// [`Error::NoInertia`], [`Error::SelfLocking`], and [`Error::Overflow`] where a result is beyond numbers.
pub fn design(spec: &DriveSpec) -> Result<DriveDesign, Error> {
    check(spec)?;
    let mut warnings = Vec::new();
    let numbers = teeth::tooth_numbers(spec)?;
    let gear_set = gear_set(spec, numbers)?;
    let teeth = teeth::conditions(spec, numbers, &gear_set, &mut warnings)?;
    let efficiency = efficiencies(spec, numbers)?;
    let speeds = speeds(spec, numbers)?;
    let torques = torques(spec, &teeth, efficiency)?;
    let powers = powers(spec, &speeds, &torques);
    let shafts = shafts::shafts(spec, &torques, &mut warnings)?;
    let masses = bodies::masses(spec, numbers, &gear_set, &shafts, &mut warnings)?;
    let forces = forces(spec, numbers, &gear_set, &torques, &speeds, &masses)?;
    let drive = bodies::planetary_drive(spec, numbers, &gear_set, &masses);
    let equivalent_inertia = motion::equivalent_inertia(spec, &drive, &masses)?;
    let driving_torque = spec.driving_torque.unwrap_or(torques.sun);
    let load = spec.load.unwrap_or(torques.carrier);
    Ok(DriveDesign {
        without_losses: motion::without_losses(spec, &drive, driving_torque, load)?,
        with_losses: motion::with_losses(spec, &drive, driving_torque, load)?,
        teeth,
        efficiency,
        speeds,
        torques,
        powers,
        gear_set,
        forces,
        shafts,
        masses,
        equivalent_inertia,
        driving_torque,
        load,
        warnings,
    })
}

/// Sun drives, carrier is driven, ring at rest.
fn mode() -> Result<Mode, Error> {
    Ok(Mode::new(Member::Sun, Member::Carrier)?)
}

fn check(spec: &DriveSpec) -> Result<(), Error> {
    let positive = |quantity, value: f64, unit| {
        if value > 0.0 && value.is_finite() {
            Ok(())
        } else {
            Err(Error::NotPositive { quantity, value, unit })
        }
    };
    positive(Given::Power, spec.power.get::<kilowatt>(), "kW")?;
    positive(Given::Speed, spec.speed.get::<revolution_per_minute>(), "rpm")?;
    positive(Given::Ratio, spec.ratio, "")?;
    check_tolerance(spec.ratio_tolerance)?;
    if let Some(driving) = spec.driving_torque {
        positive(Given::DrivingTorque, n_m(driving), "N·m")?;
    }
    match spec.load.map(n_m) {
        Some(value) if !value.is_finite() => Err(Error::LoadNotFinite { value }),
        _ => Ok(()),
    }
}

/// Refuses what overflowed on the way.
fn finite(what: &'static str, value: f64) -> Result<f64, Error> {
    if value.is_finite() { Ok(value) } else { Err(Error::Overflow { what, value }) }
}

fn gear_set(spec: &DriveSpec, teeth: ToothNumbers) -> Result<GearSetGeometry, Error> {
    let GearSetSpec { module, rack, face_width, .. } = spec.gear_set;
    let sun = geometry::ToothedGear::new(GearKind::External, module, teeth.sun, rack)?;
    let planet = geometry::ToothedGear::new(GearKind::External, module, teeth.planet, rack)?;
    let ring = geometry::ToothedGear::new(GearKind::Internal, module, teeth.ring, rack)?;
    finite("root diameter of the ring", meters(ring.root_diameter()))?;
    Ok(GearSetGeometry { sun, planet, ring, centre_distance: centre_distance(&sun, &planet)?, face_width })
}

fn efficiencies(spec: &DriveSpec, teeth: ToothNumbers) -> Result<Efficiency, Error> {
    let eta0 = MeshEfficiency::of_meshes(&[spec.sun_planet_efficiency, spec.planet_ring_efficiency]);
    let overall = efficiency::efficiency(teeth.basic_ratio(), eta0, mode()?)?;
    Ok(Efficiency { basic: eta0.get(), overall })
}

fn speeds(spec: &DriveSpec, teeth: ToothNumbers) -> Result<Speeds, Error> {
    let fixed = angular_velocity(0.0);
    let set = willis::speeds(teeth.basic_ratio(), Some(spec.speed), Some(fixed), None)?;
    let planet = willis::planet_speed(teeth.planet.as_f64() / teeth.sun.as_f64(), set.sun, set.carrier)?;
    finite("speed of the planet", rad_per_s(planet.absolute))?;
    Ok(Speeds {
        sun: set.sun,
        planet: planet.absolute,
        planet_relative: planet.relative,
        carrier: set.carrier,
    })
}

fn torques(spec: &DriveSpec, teeth: &TeethDesign, efficiency: Efficiency) -> Result<Torques, Error> {
    let sun = loads::shaft_torque(spec.power, spec.speed)?;
    let planet_to_sun = teeth.numbers.planet.as_f64() / teeth.numbers.sun.as_f64();
    let carrier = loads::carrier_torque(sun, teeth.ratio, efficiency.overall);
    finite("torque of the carrier", n_m(carrier))?;
    Ok(Torques {
        sun,
        planets: loads::planet_torque(sun, spec.sun_planet_efficiency, planet_to_sun),
        carrier,
        ring_reaction: carrier - sun,
    })
}

fn powers(spec: &DriveSpec, speeds: &Speeds, torques: &Torques) -> Powers {
    let eta0 = spec.sun_planet_efficiency.get() * spec.planet_ring_efficiency.get();
    let mesh = loads::shaft_power(torques.sun, speeds.sun - speeds.carrier);
    Powers {
        input: spec.power,
        mesh,
        lost: mesh * (1.0 - eta0),
        output: loads::shaft_power(torques.carrier, speeds.carrier),
    }
}

fn forces(
    spec: &DriveSpec,
    teeth: ToothNumbers,
    gear_set: &GearSetGeometry,
    torques: &Torques,
    speeds: &Speeds,
    masses: &Masses,
) -> Result<Forces, Error> {
    let (planets, radius) = (teeth.planets, gear_set.centre_distance);
    let nominal = |t, gear: &geometry::ToothedGear| {
        force(2.0 * n_m(t) / (f64::from(planets) * meters(gear.pitch_diameter())))
    };
    let sun_mesh = planet_bearing::mesh_force(torques.sun, torques.planets, planets, radius)?;
    let ring_mesh = planet_bearing::mesh_force(torques.ring_reaction, -torques.planets, planets, radius)?;
    let planet_bearing_tangential = planet_bearing::tangential_force(torques.carrier, planets, radius)?;
    let planet_bearing_meshes = (sun_mesh - ring_mesh) * spec.gear_set.rack.pressure_angle.tan().value;
    let planet_bearing_centrifugal =
        planet_bearing::centrifugal_force(masses.planet.body.total().mass, radius, speeds.carrier)?;
    let resultant = planet_bearing::resultant(
        planet_bearing_tangential,
        planet_bearing_meshes + planet_bearing_centrifugal,
    );
    finite("force on a planet bearing", newtons(resultant))?;
    finite("force at a mesh", newtons(sun_mesh))?;
    Ok(Forces {
        sun_mesh,
        ring_mesh,
        sun_nominal: nominal(torques.sun, &gear_set.sun),
        ring_nominal: nominal(torques.ring_reaction, &gear_set.ring),
        planet_bearing_tangential,
        planet_bearing_meshes,
        planet_bearing_centrifugal,
        planet_bearing: resultant,
    })
}
