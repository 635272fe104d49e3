//! Design of a planetary drive from power, speed and ratio to its starting time.
//!
//! The sun drives, the ring is at rest, the load acts on the carrier. One pure function, [`design`], takes a
//! [`DriveSpec`] through these stages:
//!
//! ```text
//! ratio → teeth, geometry → efficiency, speeds, torques → diameters, shafts, bearings → masses, inertias
//!       → forces → J_pr, T → accelerations → starting time
//! ```
//!
//! Each arrow is a value that the next stage takes, together with the part of the specification that concerns
//! it. The solver of gearboxes is called once, for the speeds.
//!
//! An [`Error`] stops the calculation. A [`Warning`] marks a result to be checked.
//!
//! # Source
//! excavator-dynamics, from end to end. Departures from it: the planet speed is that on the turning carrier;
//! inertias are those of the shapes described; `J_pr` has `(z_1 + z_3)²` in every term; a default sun sits on
//! its shaft rather than on a bearing.
//!
//! # Left out
//! Strength of the teeth, bending of shafts and planet pins, life of the bearings, and losses outside the
//! meshes. Also left out is a mesh load factor above 1 (planets that share the load unequally).
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
mod faults;
mod forces;
mod loads;
mod motion;
mod part;
mod result;
mod shafts;
mod spec;
mod teeth;
#[cfg(test)]
mod tests;
mod warning;

pub use part::{BoredGear, Computed, Shaft};
pub use result::{
    Choice, DriveDesign, Efficiency, EquivalentInertia, Forces, GearMass, GearSetGeometry, Masses, Motion,
    Powers, ShaftDesign, Shafts, Speeds, Start, TeethDesign, Torques,
};
pub use spec::{
    Bore, CarrierSpec, DriveSpec, GearSetSpec, Given, KnownPart, KnownParts, ShaftSpec, ShaftsSpec,
    TeethSpec, default_bounds,
};
pub use warning::Warning;

use crate::Error;
use bodies::Ends;
use epicyclic_gears::simple_set::Mode;
use loads::{Carried, Meshes};
use motion::Starting;
use teeth::{Geared, Wanted};

/// Usual range of the ratio of a single stage.
///
/// # Source
/// excavator-dynamics.
pub const USUAL_RATIO: std::ops::RangeInclusive<f64> = 3.0..=10.0;

/// Designs a drive.
///
/// # Errors
/// [`Error::Gear`] with the part's own error for quantities out of range, a ratio that no set of tooth
/// numbers reaches, or gears without root; also for holes outside their arms, or shafts beyond the standard
/// diameters. [`Error::UnequalCentreDistances`], [`Error::BoreTooLarge`], [`Error::Impossible`],
/// [`Error::NotFinite`], [`Error::NoInertia`], [`Error::SelfLocking`]; [`Error::Overflow`] for a result
/// beyond the range of numbers.
pub fn design(spec: &DriveSpec) -> Result<DriveDesign, Error> {
    design_all(spec).map_err(|mut faults| faults.swap_remove(0))
}

/// Designs a drive as [`design`] does.
///
/// # Errors
/// All independent faults, at least one: first those of the values ([`DriveSpec::faults`]), and if there are
/// none, those of the parts.
pub fn design_all(spec: &DriveSpec) -> Result<DriveDesign, Vec<Error>> {
    designed(spec).map_err(|Faults(faults)| faults)
}

/// Independent faults, at least one.
struct Faults(Vec<Error>);

impl From<Error> for Faults {
    fn from(error: Error) -> Self {
        Self(vec![error])
    }
}

fn designed(spec: &DriveSpec) -> Result<DriveDesign, Faults> {
    let faults = spec.faults();
    if !faults.is_empty() {
        return Err(Faults(faults));
    }
    let wanted = Wanted { ratio: spec.ratio, tolerance: spec.ratio_tolerance };
    let meshes = Meshes {
        sun_planet: spec.sun_planet_efficiency,
        planet_bearings: spec.planet_bearing_efficiency,
        planet_ring: spec.planet_ring_efficiency,
    };
    let ends = Ends { motor: spec.motor_inertia, machine: spec.machine_inertia };
    let mut warnings = Vec::new();

    let Geared { set, teeth, geometry } = teeth::geared(wanted, &spec.teeth, &spec.gear_set, &mut warnings)?;
    let planets = teeth.numbers.planets;
    let Carried { efficiency, speeds, torques, powers } =
        loads::carried(spec.power, spec.speed, meshes, &set, &teeth)?;
    let shafts = shafts::shafts(&spec.shafts, &torques, &mut warnings)?;
    let series = spec.shafts.bearing_series;
    let of_shapes =
        bodies::masses(&spec.gear_set, &spec.carrier, series, planets, &geometry, &shafts, &mut warnings)?;
    warnings.extend(of_shapes.unlike(&spec.known));
    let masses = of_shapes.with(&spec.known);
    let forces = forces::forces(meshes, planets, &geometry, &torques, speeds.carrier, &masses.planet)?;

    let turning = |masses: &Masses| -> Result<_, Error> {
        let drive = bodies::planetary_drive(set, geometry.centre_distance, masses, ends);
        let inertia = motion::equivalent_inertia(&drive, masses, ends, spec.speed)?;
        Ok((drive, inertia))
    };
    let (drive, equivalent_inertia) = turning(&masses)?;
    let inertia_of_shapes = if masses == of_shapes { None } else { Some(turning(&of_shapes)?.1) };
    let driving_torque = spec.driving_torque.unwrap_or(torques.sun);
    let load = spec.load.unwrap_or(torques.carrier);
    let start = Starting { speed: spec.speed, driving: driving_torque, load };
    let without_losses = motion::without_losses(&drive, start)?;
    let with_losses = motion::with_losses(&drive, start, meshes)?;
    Ok(DriveDesign {
        without_losses,
        with_losses,
        teeth,
        efficiency,
        speeds,
        torques,
        powers,
        gear_set: geometry,
        forces,
        shafts,
        masses,
        equivalent_inertia,
        inertia_of_shapes,
        driving_torque,
        load,
        warnings,
    })
}

/// Sun drives, carrier is driven, ring at rest.
const MODE: Mode = Mode::SUN_TO_CARRIER;

/// Refuses what overflowed on the way.
fn finite(what: Computed, value: f64) -> Result<f64, Error> {
    if value.is_finite() { Ok(value) } else { Err(Error::Overflow { what, value }) }
}
