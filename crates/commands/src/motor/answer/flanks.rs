//! Flanks of a motor under load: sealing, forces, stresses.

use super::Designed;
use crate::error::Error;
use crate::shared::number::{maybe_si, plain, si};
use crate::tolerance::{beside_zero, rounded};
use epicyclic_hydromotor::centrode::Wheel;
use epicyclic_hydromotor::flanks::{
    self, ContactStress, ForceBound, Governing, LoadedPath, MaterialLimits, PeakPressure, Push, RootStress,
    SealingContact,
};
use epicyclic_hydromotor::profile::Profile;
use epicyclic_units::Physical as _;
use schemars::JsonSchema;
use serde::Serialize;
use uom::si::f64::{Length, Pressure};

/// Flanks under load: contacts seal and carry where the teeth touch.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Flanks {
    /// Number of satellites that separate high from low pressure, `2n`; the others are idle.
    pub loaded_satellites: u32,
    /// Ripple of flow and torque if satellites seal at the flanks; `work.ripple` is the ripple at the pitch
    /// points.
    pub ripple: f64,
    /// Least over mean flow, equal to least over mean torque.
    pub least_over_mean: f64,
    /// Rotor angle of the least flow in rad, from the position in which a crest of the rotor faces a crest of
    /// the stator.
    pub least_at_rad: f64,
    /// Least torque in N·m; null without width and pressure.
    pub least_torque_n_m: Option<f64>,
    /// Forces on flanks and bearing; null without width and pressure.
    pub forces: Option<FlankForces>,
    /// Effective modulus of the teeth in Pa, `1/E* = 2(1 − ν²)/E`.
    pub effective_modulus_pa: f64,
    /// Hertzian contact stresses in both meshes, at crests and at troughs; empty without a pressure.
    pub contact: Vec<ContactStresses>,
    /// Bending stresses at the tooth roots; empty without a pressure.
    pub roots: Vec<RootStresses>,
    /// Pressure drop that the teeth allow; null without limits of the material.
    pub allowed: Option<AllowedPressure>,
}

/// Forces on flanks and bearing over a revolution.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct FlankForces {
    /// Greatest force on each flank of a satellite near a crest, with contacts at the pitch points.
    pub by_crest: ForceAt,
    /// Greatest force on each flank of a satellite near a trough, with contacts at the pitch points.
    pub by_trough: ForceAt,
    /// Upper bound of the force on the stator's flanks, with the contacts at their real places and a third
    /// flank that holds the satellite.
    pub stator_bound: ForceAt,
    /// Upper bound of the force on the rotor's flanks, with a third flank that holds the satellite.
    pub rotor_bound: ForceAt,
    /// Upper bound of the force on the stator's back flanks; null if they never carry.
    pub stator_back_bound: Option<ForceAt>,
    /// Upper bound of the force on the rotor's back flanks; null if they never carry.
    pub rotor_back_bound: Option<ForceAt>,
    /// Greatest load of the rotor's bearing; 0 if the numbers of lobes have a common divisor.
    pub bearing_load: ForceAt,
}

/// Force, and the rotor angle at which it occurs.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ForceAt {
    /// Force in N.
    pub force_n: f64,
    /// Rotor angle in rad; for forces on satellites that of satellite 0.
    pub at_rad: f64,
}

/// Hertzian stresses of the satellites that are pushed in one direction, in one mesh.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ContactStresses {
    /// Wheel in mesh with the satellite.
    pub wheel: Wheel,
    /// Place of the satellites: near a crest or near a trough.
    pub by: Push,
    /// Greatest stress with the contact at the pitch point, in Pa.
    pub at_pitch_point_pa: f64,
    /// Greatest stress while a single pair of flanks is in mesh, in Pa; null if there are always two.
    pub alone_pa: Option<f64>,
    /// Place of that stress in m: along the line of action from the pitch point, positive towards the
    /// satellite's base circle.
    pub alone_offset_m: Option<f64>,
    /// Upper bound of the stress on the whole path of contact with all load on one pair, in Pa; null if a
    /// loaded satellite has no path.
    pub on_path_pa: Option<f64>,
    /// Place of that bound in m, along the line of action from the pitch point.
    pub on_path_offset_m: Option<f64>,
}

/// Greatest nominal bending stress at the roots of a wheel.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct RootStresses {
    /// Wheel whose roots are rated.
    pub wheel: Wheel,
    /// Stress for a load while a single pair of flanks is in mesh, in Pa; null if there are always two.
    pub alone_pa: Option<f64>,
    /// Upper bound of the stress in Pa: all load anywhere on the path of contact.
    pub on_path_pa: Option<f64>,
    /// Thickness of the critical section in m, for the upper bound.
    pub thickness_m: Option<f64>,
}

/// Pressure drop that the limits of the material allow.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct AllowedPressure {
    /// Allowed pressure drop in Pa: the least by contact and root stress, while a single pair of flanks is in
    /// mesh.
    pub pressure_pa: f64,
    /// Pressure drop allowed by contact stress in Pa, while a single pair of flanks is in mesh.
    pub by_contact_pa: f64,
    /// Pressure drop allowed by root bending in Pa, while a single pair of flanks is in mesh.
    pub by_root_pa: f64,
    /// Limit that governs the allowed pressure drop.
    pub governing: GoverningLimit,
    /// Lower bound of the allowed pressure drop in Pa, with all load on one pair on the whole path.
    pub on_path_pa: f64,
}

/// Limits of the pressure drop.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum GoverningLimit {
    /// Contact stress of the flanks.
    Contact,
    /// Bending at the roots of the stator.
    StatorRoot,
    /// Bending at the roots of the rotor.
    RotorRoot,
    /// Bending at the roots of the satellites.
    SatelliteRoot,
}

impl GoverningLimit {
    pub(crate) fn of(governing: Governing) -> Self {
        match governing {
            Governing::Contact => Self::Contact,
            Governing::Root(Wheel::Stator) => Self::StatorRoot,
            Governing::Root(Wheel::Rotor) => Self::RotorRoot,
            Governing::Root(Wheel::Satellite) => Self::SatelliteRoot,
        }
    }
}

/// Greatest contact stress in Pa while a single pair of flanks carries; at the pitch point if there are
/// always two.
pub(crate) fn greatest_contact(stresses: &[ContactStresses]) -> Option<f64> {
    stresses.iter().map(|one| one.alone_pa.unwrap_or(one.at_pitch_point_pa)).reduce(f64::max)
}

impl Flanks {
    /// Computes the flanks of a motor with teeth.
    pub(crate) fn of(designed: &Designed, profile: &Profile) -> Result<Self, Error> {
        let motor = &designed.motor;
        // The check at unit width and pressure ends here if the flanks cannot hold a satellite, because no
        // other result is then valid.
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
        // The mean flow at the flanks is slightly larger than that of the volumes.
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
            // Forces that balance leave a rounding error, which must not appear as a load.
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

/// Hertzian stresses in both meshes.
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
            by: one.push,
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
    let of = |all: &[RootStress], wheel: Wheel| all.iter().find(|one| one.wheel == wheel).copied();
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
