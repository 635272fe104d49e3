//! The flanks of a motor under load: sealing, forces, stresses.

use super::teeth::Wheel;
use super::{Designed, Push};
use crate::error::Error;
use crate::shared::number::{maybe_si, plain, si};
use crate::tolerance::{beside_zero, rounded};
use epicyclic_hydromotor::flanks::{
    self, ContactStress, ForceBound, Governing, LoadedPath, MaterialLimits, PeakPressure, RootStress,
    SealingContact,
};
use epicyclic_hydromotor::profile::Profile;
use epicyclic_units::Physical as _;
use schemars::JsonSchema;
use serde::Serialize;
use uom::si::f64::{Length, Pressure};

/// Flanks under load, by contacts that seal and carry where the teeth touch.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Flanks {
    /// Satellites that part high from low pressure, `2n`; the others are idle.
    pub loaded_satellites: u32,
    /// Ripple of flow and torque, satellites sealing at the flanks; that at the pitch points is
    /// `work.ripple`.
    pub ripple: f64,
    /// Least over mean flow, which is that of the torque.
    pub least_over_mean: f64,
    /// Angle of the rotor with the least, from where one of its crests faces one of the stator's.
    pub least_at_rad: f64,
    /// Least torque; null without width and pressure.
    pub least_torque_n_m: Option<f64>,
    /// Forces; null without width and pressure.
    pub forces: Option<FlankForces>,
    /// Effective modulus of the teeth, `1/E* = 2(1 − ν²)/E`.
    pub effective_modulus_pa: f64,
    /// Contact stresses of Hertz, of stator and rotor, by crests and by troughs; empty without a pressure.
    pub contact: Vec<ContactStresses>,
    /// Bending at the roots; empty without a pressure.
    pub roots: Vec<RootStresses>,
    /// The pressure drop that the shape allows; null without limits of the material.
    pub allowed: Option<AllowedPressure>,
}

/// Forces on flanks and bearing over a revolution.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct FlankForces {
    /// The greatest on each flank of a satellite by a crest, with contacts at the pitch points.
    pub by_crest: ForceAt,
    /// The greatest of one by a trough.
    pub by_trough: ForceAt,
    /// A bound of the force on the stator's flanks with the contacts where they are and a third flank that
    /// holds the satellite.
    pub stator_bound: ForceAt,
    /// The same on the rotor's flanks.
    pub rotor_bound: ForceAt,
    /// The same on the back flanks of the stator; null where they never hold.
    pub stator_back_bound: Option<ForceAt>,
    /// The same on the back flanks of the rotor.
    pub rotor_back_bound: Option<ForceAt>,
    /// The greatest load of the rotor's bearing; 0 where lobes have a common divisor.
    pub bearing_load: ForceAt,
}

/// A force, and the angle of the rotor at which it is so.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ForceAt {
    /// The force.
    pub force_n: f64,
    /// Angle of the rotor; of forces on satellites, of satellite 0.
    pub at_rad: f64,
}

/// Stresses of Hertz of the satellites that are pushed one way in one mesh.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ContactStresses {
    /// The wheel.
    pub wheel: Wheel,
    /// By a crest or by a trough.
    pub by: Push,
    /// The greatest with the contact at the pitch point.
    pub at_pitch_point_pa: f64,
    /// The greatest where one pair of flanks alone is in mesh; null where there always are two.
    pub alone_pa: Option<f64>,
    /// Where that is, along the line of action from the pitch point, positive towards the satellite's base
    /// circle.
    pub alone_offset_m: Option<f64>,
    /// The greatest on the whole path with all load on one pair, a bound; null where a loaded satellite has
    /// no path.
    pub on_path_pa: Option<f64>,
    /// Where that is.
    pub on_path_offset_m: Option<f64>,
}

/// Greatest nominal bending stress at the roots of a wheel.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct RootStresses {
    /// The wheel.
    pub wheel: Wheel,
    /// Loaded where one pair of flanks alone is in mesh; null where there always are two.
    pub alone_pa: Option<f64>,
    /// Loaded anywhere on its path by all load, a bound.
    pub on_path_pa: Option<f64>,
    /// Thickness of the section with the bound.
    pub thickness_m: Option<f64>,
}

/// The pressure drop that limits of the material allow.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct AllowedPressure {
    /// The least of both, where one pair of flanks alone is in mesh.
    pub pressure_pa: f64,
    /// By contact there.
    pub by_contact_pa: f64,
    /// By bending there.
    pub by_root_pa: f64,
    /// What limits it.
    pub governing: GoverningLimit,
    /// The least of both with all load on one pair on the whole path, a bound.
    pub on_path_pa: f64,
}

/// What limits the pressure.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum GoverningLimit {
    /// Contact stress.
    Contact,
    /// Bending at the stator's roots.
    StatorRoot,
    /// Bending at the rotor's roots.
    RotorRoot,
    /// Bending at the satellites' roots.
    SatelliteRoot,
}

impl GoverningLimit {
    pub(crate) fn of(governing: Governing) -> Self {
        match governing {
            Governing::Contact => Self::Contact,
            Governing::Root(wheel) => match Wheel::of(wheel) {
                Wheel::Stator => Self::StatorRoot,
                Wheel::Rotor => Self::RotorRoot,
                Wheel::Satellite => Self::SatelliteRoot,
            },
        }
    }
}

impl Flanks {
    /// Of a motor with teeth.
    pub(crate) fn of(designed: &Designed, profile: &Profile) -> Result<Self, Error> {
        let motor = &designed.motor;
        // Where the flanks hold no satellite nothing else is told of them.
        let held = (Length::from_si(1.0), Pressure::from_si(1.0));
        motor.greatest_flank_forces(profile.form().pressure_angle, held.0, held.1)?;
        let ripple = profile.flank_ripple(SealingContact::default());
        let (contact, roots) = match designed.pressure {
            Some(drop) => (contact_stresses(profile, designed.made.modulus, drop)?, roots(profile, drop)?),
            None => (vec![], vec![]),
        };
        let mean = motor.ripple().mean;
        let torque = designed.width.zip(designed.pressure);
        let torque = torque.map(|(width, drop)| motor.theoretical_torque(width, drop)).transpose()?;
        // The mean at the flanks is a little more than that of the volumes.
        let least = ripple.at_flanks.least / mean;
        Ok(Self {
            loaded_satellites: 2 * motor.numbers().rotor_lobes(),
            ripple: plain(ripple.at_flanks.delta),
            least_over_mean: plain(ripple.least_over_mean),
            least_at_rad: beside_zero(ripple.least_at),
            least_torque_n_m: maybe_si(torque.map(|torque| torque * least)),
            forces: designed
                .width
                .zip(designed.pressure)
                .map(|(width, drop)| FlankForces::of(profile, width, drop))
                .transpose()?,
            effective_modulus_pa: si(designed.made.modulus),
            contact,
            roots,
            allowed: designed.made.limits.map(|limits| AllowedPressure::of(profile, &limits)).transpose()?,
        })
    }
}

impl FlankForces {
    fn of(profile: &Profile, width: Length, drop: Pressure) -> Result<Self, Error> {
        let (motor, alpha) = (profile.motor(), profile.form().pressure_angle);
        let [by_crest, by_trough] = motor.greatest_flank_forces(alpha, width, drop)?;
        let bounds = profile.third_contact_bounds(SealingContact::default(), width, drop)?;
        let bearing = motor.greatest_bearing_load(alpha, width, drop)?;
        let greatest = |one: flanks::GreatestFlankForce| ForceAt {
            force_n: si(one.force),
            at_rad: beside_zero(one.rotation),
        };
        Ok(Self {
            by_crest: greatest(by_crest),
            by_trough: greatest(by_trough),
            stator_bound: ForceAt::of(bounds.stator),
            rotor_bound: ForceAt::of(bounds.rotor),
            stator_back_bound: bounds.stator_back.map(ForceAt::of),
            rotor_back_bound: bounds.rotor_back.map(ForceAt::of),
            // What rounding leaves of forces that balance is none.
            bearing_load: ForceAt {
                force_n: si(by_crest.force) * rounded(si(bearing.force) / si(by_crest.force)),
                at_rad: beside_zero(bearing.rotation),
            },
        })
    }
}

impl ForceAt {
    fn of(bound: ForceBound) -> Self {
        Self { force_n: si(bound.force), at_rad: beside_zero(bound.rotation) }
    }
}

/// Stresses of Hertz in both meshes.
pub(crate) fn contact_stresses(
    profile: &Profile,
    modulus: Pressure,
    drop: Pressure,
) -> Result<Vec<ContactStresses>, Error> {
    let record = |one: &ContactStress| {
        let pressure = |peak: Option<PeakPressure>| maybe_si(peak.map(|peak| peak.pressure));
        let offset = |peak: Option<PeakPressure>| maybe_si(peak.map(|peak| peak.offset));
        ContactStresses {
            wheel: match one.mesh {
                flanks::Mesh::Stator => Wheel::Stator,
                flanks::Mesh::Rotor => Wheel::Rotor,
            },
            by: Push::of(one.push),
            at_pitch_point_pa: si(one.at_pitch_point.pressure),
            alone_pa: pressure(one.in_single_contact),
            alone_offset_m: offset(one.in_single_contact),
            on_path_pa: pressure(one.on_path),
            on_path_offset_m: offset(one.on_path),
        }
    };
    Ok(profile.contact_stresses(drop, modulus)?.iter().map(record).collect())
}

fn roots(profile: &Profile, drop: Pressure) -> Result<Vec<RootStresses>, Error> {
    let alone = profile.root_stresses(LoadedPath::SingleContact, drop)?;
    let whole = profile.root_stresses(LoadedPath::Whole, drop)?;
    let of = |all: &[RootStress], wheel: Wheel| all.iter().find(|one| Wheel::of(one.wheel) == wheel).copied();
    let record = |wheel: Wheel| {
        let (alone, whole) = (of(&alone, wheel), of(&whole, wheel));
        RootStresses {
            wheel,
            alone_pa: maybe_si(alone.map(|one| one.stress)),
            on_path_pa: maybe_si(whole.map(|one| one.stress)),
            thickness_m: maybe_si(whole.map(|one| one.thickness)),
        }
    };
    Ok([Wheel::Stator, Wheel::Rotor, Wheel::Satellite].map(record).to_vec())
}

impl AllowedPressure {
    fn of(profile: &Profile, limits: &MaterialLimits) -> Result<Self, Error> {
        let alone = profile.allowed_pressure(LoadedPath::SingleContact, limits)?;
        let whole = profile.allowed_pressure(LoadedPath::Whole, limits)?;
        Ok(Self {
            pressure_pa: si(alone.pressure),
            by_contact_pa: si(alone.by_contact),
            by_root_pa: si(alone.by_root),
            governing: GoverningLimit::of(alone.governing),
            on_path_pa: si(whole.pressure),
        })
    }
}
