//! Records of the vibration of a whole gearbox: torsional modes with their resonances, and coupled modes in
//! the plane.

use super::records::{Member, ModeKind, Source};
use schemars::JsonSchema;
use serde::Serialize;

/// Torsional modes of the whole gearbox in a gear.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct TorsionalModes {
    /// The gear.
    pub gear: String,
    /// How many modes have no frequency: the freedoms that the gear keeps.
    pub freedoms: u32,
    /// The modes in ascending order of frequency.
    pub modes: Vec<TorsionalMode>,
    /// What excites them, in axes on the carrier of each set; empty without speeds.
    pub orders: Vec<TorsionalOrder>,
    /// Where an order has the frequency of a mode that it can excite, ascending; empty without speeds.
    pub resonances: Vec<TorsionalResonance>,
    /// The least and the greatest speed of the input that were asked; `null` without.
    pub input_speeds_rad_s: Option<[f64; 2]>,
}

/// An order of excitation of the torsional modes in a gear.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct TorsionalOrder {
    /// The set; of a turn of links, the links that turn as one piece.
    pub of: String,
    /// What excites.
    pub source: Source,
    /// Which harmonic of it.
    pub harmonic: u32,
    /// Its frequency over that of a turn of the input.
    pub of_input: f64,
    /// The kind of modes that it can excite by the phases of the planets of its set; `null` where it can
    /// excite all.
    pub excites: Option<ModeKind>,
}

/// A speed at which an order has the frequency of a torsional mode that it can excite.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct TorsionalResonance {
    /// Speed of the input.
    pub input_speed_rad_s: f64,
    /// The set or the links.
    pub of: String,
    /// What excites.
    pub source: Source,
    /// Which harmonic of it.
    pub harmonic: u32,
    /// The mode.
    pub mode: u32,
    /// Its frequency.
    pub frequency_hz: f64,
    /// How much of the mode is where the excitation is: the share of the meshes of the set in the strain
    /// energy, or of the links in the kinetic energy.
    pub share: f64,
}

/// Torsional modes of one frequency.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct TorsionalMode {
    /// Its number, from 1.
    pub mode: u32,
    /// Rotational: links rotate; planet: they are at rest.
    pub kind: ModeKind,
    /// How many modes have this frequency and kind.
    pub multiplicity: u32,
    /// Natural frequency.
    pub frequency_hz: f64,
    /// Shares in the kinetic energy.
    pub kinetic: Vec<TorsionalKinetic>,
    /// Shares in the strain energy; empty where no spring is twisted.
    pub strain: Vec<TorsionalStrain>,
}

/// Share of links that turn as one piece, or of the planets of a set about their axes, in the kinetic energy.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct TorsionalKinetic {
    /// The links; a member on a support of its own by name and set; empty of planets.
    pub links: Vec<String>,
    /// The set of the planets; `null` of links.
    pub planets_of: Option<String>,
    /// The share.
    pub share: f64,
}

/// Share of springs in the strain energy.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct TorsionalStrain {
    /// What springs.
    pub part: StrainPart,
    /// The set of the meshes, the name of the shaft, or what stands on the support.
    pub of: String,
    /// The share.
    pub share: f64,
}

/// What springs in a mode of the whole gearbox.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum StrainPart {
    /// The meshes of a sun.
    SunMeshes,
    /// The meshes of a ring.
    RingMeshes,
    /// A shaft.
    Shaft,
    /// What holds a member against rotation.
    Support,
    /// The bearings of the planets of a set.
    PlanetBearings,
    /// What supports a centre.
    CentreSupport,
    /// A shaft that bends.
    Bending,
}

/// Modes of all sets of a gearbox in the plane, on common links and centres, in a gear.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct CoupledModes {
    /// The gear.
    pub gear: String,
    /// How many modes have no frequency: the freedoms that the gear keeps, and centres that float.
    pub freedoms: u32,
    /// What moves in the plane as one piece.
    pub centres: Vec<CentreBody>,
    /// The modes at rest in ascending order of frequency.
    pub modes: Vec<CoupledMode>,
}

/// Members whose centre moves as one piece.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct CentreBody {
    /// The members.
    pub members: Vec<CentreMember>,
    /// Their mass together, carriers without planets; `null` where the centre is held.
    pub mass_kg: Option<f64>,
    /// Their radial supports together; `null` where the centre is held.
    pub support_n_m: Option<f64>,
}

/// A member of a set.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct CentreMember {
    /// The set.
    pub set: String,
    /// The member.
    pub member: Member,
}

/// Modes of one frequency and kind.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct CoupledMode {
    /// Its number, from 1.
    pub mode: u32,
    /// What links and centres do.
    pub kind: ModeKind,
    /// How many modes have this frequency and kind.
    pub multiplicity: u32,
    /// Natural frequency.
    pub frequency_hz: f64,
    /// What the members of each set do.
    pub sets: Vec<SetInMode>,
    /// Shares in the kinetic energy.
    pub kinetic: Vec<CoupledKinetic>,
    /// Shares in the strain energy; empty where no spring is bent.
    pub strain: Vec<TorsionalStrain>,
}

/// What a set does in a mode of the whole gearbox.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct SetInMode {
    /// The set.
    pub set: String,
    /// What its sun, ring and carrier do; `null` where its planets are at rest, too.
    pub kind: Option<ModeKind>,
}

/// Share of a body in the kinetic energy.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct CoupledKinetic {
    /// What moves.
    pub part: KineticPart,
    /// The links, the members of a centre as `sun of P`, or the set of the planets.
    pub of: Vec<String>,
    /// The share.
    pub share: f64,
}

/// What moves in a mode of the whole gearbox.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum KineticPart {
    /// Links that rotate.
    Rotation,
    /// A centre that translates.
    Translation,
    /// The planets of a set.
    Planets,
}
