//! Records of vibration: modes of sets, orders that excite them, resonances, frequencies over the speed.

use epicyclic_vibration::Kind;
use schemars::JsonSchema;
use serde::Serialize;

/// The modes of a set in the gears that hold the same of its members.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct SetModes {
    /// The set.
    pub set: String,
    /// The gears; empty of a gearbox without gears.
    pub gears: Vec<String>,
    /// Members whose links are held there.
    pub held: Vec<Member>,
    /// Number of planets.
    pub planets: u32,
    /// Their angles on the carrier from `x`.
    pub planet_angles_rad: Vec<f64>,
    /// Whether they are equally spaced; of others modes can be of no one kind, and double ones part.
    pub equally_spaced: bool,
    /// Sun, ring, carrier, and one planet.
    pub bodies: Vec<VibratingBody>,
    /// The springs.
    pub stiffness: Stiffnesses,
    /// Working pressure angle of the meshes of the sun.
    pub sun_pressure_angle_rad: f64,
    /// Working pressure angle of the meshes of the ring.
    pub ring_pressure_angle_rad: f64,
    /// The modes at rest in ascending order of frequency, those of one frequency and kind together.
    pub modes: Vec<Mode>,
}

/// A body of a set.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct VibratingBody {
    /// Which.
    pub body: Member,
    /// Its mass; `null` where its centre is held.
    pub mass_kg: Option<f64>,
    /// Its inertia; `null` where it cannot rotate.
    pub inertia_kg_m2: Option<f64>,
    /// Base radius of a gear; of the carrier that of the planets' circle.
    pub radius_m: f64,
}

/// Stiffness of the springs of a set.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Stiffnesses {
    /// Where those of the meshes come from.
    pub meshes_by: StiffnessOrigin,
    /// Of a mesh of the sun, along the line of action.
    pub sun_mesh_n_m: f64,
    /// Of a mesh of the ring.
    pub ring_mesh_n_m: f64,
    /// Radial, of the bearings of one planet.
    pub planet_bearing_n_m: f64,
    /// Radial, of the support of the sun; `null` of a rigid one.
    pub sun_support_n_m: Option<f64>,
    /// Radial, of the support of the ring; `null` of a rigid one.
    pub ring_support_n_m: Option<f64>,
    /// Radial, of the support of the carrier; `null` of a rigid one.
    pub carrier_support_n_m: Option<f64>,
    /// Of what holds the sun against rotation, over the square of its base radius; `null` where it is free or
    /// held rigidly.
    pub sun_tangential_support_n_m: Option<f64>,
    /// The same of the ring.
    pub ring_tangential_support_n_m: Option<f64>,
    /// The same of the carrier, over the square of the radius of the planets' circle.
    pub carrier_tangential_support_n_m: Option<f64>,
}

/// Where the stiffness of meshes comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum StiffnessOrigin {
    /// The file gives it.
    Given,
    /// `c_γα·b` by ISO 6336-1.
    Iso6336,
}

/// A body of a set.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Member {
    /// The sun.
    Sun,
    /// The ring.
    Ring,
    /// The carrier.
    Carrier,
    /// A planet.
    Planet,
}

/// Modes of one frequency and kind.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Mode {
    /// Its number, from 1.
    pub mode: u32,
    /// What central members do.
    pub kind: ModeKind,
    /// How many modes have this frequency.
    pub multiplicity: u32,
    /// Natural frequency; 0 where all turn by their ratios and no spring is bent.
    pub frequency_hz: f64,
    /// Shares of the bodies in the kinetic energy.
    pub kinetic: KineticShares,
    /// Shares of the springs in the strain energy; `null` where no spring is bent. Half a share is by how
    /// many per cent the frequency rises where the stiffness of these springs rises by one.
    pub strain: Option<StrainShares>,
    /// What the bodies do: sun, ring, carrier, planets. Of several modes the one with the most of the first
    /// of these that moves.
    pub shape: Vec<BodyMotion>,
}

/// What a body does in a mode.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct BodyMotion {
    /// Which.
    pub body: Member,
    /// Number of a planet, from 1; `null` of the others.
    pub planet: Option<u32>,
    /// Displacement of its centre along `x`, towards the first planet, over the largest of the mode.
    pub x: f64,
    /// Displacement along `y`.
    pub y: f64,
    /// Its rotation times its radius.
    pub u: f64,
}

/// Shares in the kinetic energy of a mode; they add up to 1.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct KineticShares {
    /// Of the sun.
    pub sun: f64,
    /// Of the ring.
    pub ring: f64,
    /// Of the carrier.
    pub carrier: f64,
    /// Of all planets.
    pub planets: f64,
}

/// Shares in the strain energy of a mode; they add up to 1.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct StrainShares {
    /// Of the meshes of the sun with all planets.
    pub sun_meshes: f64,
    /// Of the meshes of the ring.
    pub ring_meshes: f64,
    /// Of the bearings of all planets.
    pub planet_bearings: f64,
    /// Of the supports of sun, ring and carrier.
    pub supports: f64,
}

/// What central members do in a mode.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ModeKind {
    /// They rotate and do not translate.
    Rotational,
    /// They translate and do not rotate.
    Translational,
    /// They are at rest.
    Planet,
    /// They rotate and translate.
    Mixed,
}

impl ModeKind {
    /// A kind that the library does not name yet is none of the others.
    pub(super) const fn of(kind: Kind) -> Self {
        match kind {
            Kind::Rotational => Self::Rotational,
            Kind::Translational => Self::Translational,
            Kind::Planet => Self::Planet,
            _ => Self::Mixed,
        }
    }
}

/// What excites the modes of a set with a frequency that follows from speeds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Source {
    /// The teeth in mesh, with sun and ring alike.
    Mesh,
    /// What turns with the sun, such as its runout, once a turn relative to the carrier.
    SunTurn,
    /// What turns with the ring, or stands with it, once a turn relative to the carrier.
    RingTurn,
    /// Planets that pass a place of the sun.
    SunPlanetPass,
    /// Planets that pass a place of the ring.
    RingPlanetPass,
    /// What turns with a planet, once a turn relative to the carrier.
    PlanetTurn,
    /// What drives or loads a link, once a turn; of torsional modes alone.
    LinkTurn,
}

/// An order of excitation of a set in a gear.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Order {
    /// The set.
    pub set: String,
    /// The gear.
    pub gear: String,
    /// What excites.
    pub source: Source,
    /// Which harmonic of it.
    pub harmonic: u32,
    /// Its frequency over the input's, in axes on the carrier.
    pub of_input: f64,
    /// The kind of modes that it can excite; `null` where it can excite all.
    pub excites: Option<ModeKind>,
}

/// A speed at which an order has the frequency of a mode that it can excite.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Resonance {
    /// The set.
    pub set: String,
    /// The gear.
    pub gear: String,
    /// Speed of the input.
    pub input_speed_rad_s: f64,
    /// What excites.
    pub source: Source,
    /// Which harmonic of it.
    pub harmonic: u32,
    /// The mode at rest from which the one met comes.
    pub mode: u32,
    /// Its kind.
    pub kind: ModeKind,
    /// The frequency, in axes on the carrier.
    pub frequency_hz: f64,
}

/// Natural frequencies of a set over the speed in a gear, with the gyroscopic effect of the carrier's speed.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Campbell {
    /// The set.
    pub set: String,
    /// The gear.
    pub gear: String,
    /// Speed of the carrier over that of the input.
    pub carrier_speed_of_input: f64,
    /// Speeds of the input.
    pub input_speeds_rad_s: Vec<f64>,
    /// Natural frequencies over them, one branch for each mode of a frequency.
    pub branches: Vec<Branch>,
}

/// A natural frequency over the speed.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Branch {
    /// The mode at rest from which it comes.
    pub mode: u32,
    /// Its kind.
    pub kind: ModeKind,
    /// Frequencies at the speeds, in axes on the carrier.
    pub frequencies_hz: Vec<f64>,
}

/// Forces of the meshes of a set in a gear that transmission errors make, beside the mean ones.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Response {
    /// The set.
    pub set: String,
    /// The gear.
    pub gear: String,
    /// Damping ratio of every mode.
    pub damping_ratio: f64,
    /// Whether the gyroscopic effect of the carrier's speed is part of it; without it, or where the carrier
    /// rests, the matrices are those at rest.
    pub gyroscopic: bool,
    /// What each harmonic of the meshes does.
    pub harmonics: Vec<HarmonicResponse>,
}

/// Forces that a harmonic of the meshes makes.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct HarmonicResponse {
    /// Which.
    pub harmonic: u32,
    /// Amplitude of the transmission error of a mesh of the sun.
    pub sun_error_m: f64,
    /// The same of the ring.
    pub ring_error_m: f64,
    /// The greatest force of a mesh of the sun within the speeds.
    pub greatest_sun: Greatest,
    /// The same of the ring.
    pub greatest_ring: Greatest,
    /// Speeds of the input: those asked, and more about resonances.
    pub input_speeds_rad_s: Vec<f64>,
    /// Amplitudes of the force of the mesh of the sun that has most, at these speeds.
    pub sun_forces_n: Vec<f64>,
    /// The same of the ring.
    pub ring_forces_n: Vec<f64>,
}

/// The greatest force that a harmonic makes in a mesh.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Greatest {
    /// Its amplitude.
    pub force_n: f64,
    /// Speed of the input.
    pub input_speed_rad_s: f64,
    /// Its frequency, in axes on the carrier.
    pub frequency_hz: f64,
    /// Torque on the sun, shared by all planets, below which the flanks part: the mean force is less than
    /// this one.
    pub parts_below_sun_torque_n_m: f64,
}

/// A set without modes, or without orders, in a gear.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct NotCalculated {
    /// The set.
    pub set: String,
    /// The gear; `null` where it is so in all.
    pub gear: Option<String>,
    /// What is not calculated.
    pub what: What,
    /// Why.
    pub reason: Reason,
    /// The keys of the set that are missing.
    pub missing: Vec<String>,
}

/// What is not calculated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum What {
    /// Its modes.
    Modes,
    /// Orders and resonances.
    Resonances,
    /// Torsional modes of the whole gearbox, for want of this set.
    Torsional,
    /// Modes of the whole gearbox in the plane, for want of this set.
    Coupled,
}

/// Why something is not calculated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Reason {
    /// The set is not simple.
    NotSimple,
    /// The file does not say enough of it.
    KeysMissing,
    /// Its planets cannot stand at equal angles, (z_s + z_r)/N is no integer.
    UnequalPlanets,
    /// Its teeth are helical: it moves along its axis and tilts, too, which the planar model has not.
    Helical,
    /// Its members are joined, or several are held: no mesh turns.
    DoesNotRoll,
    /// No speeds follow in the gear.
    NoSpeeds,
    /// It is the second set with fewer than three planets, or with planets at unequal angles: what two such
    /// sets do depends on the angle between them.
    NoSymmetry,
    /// The centrifugal forces of its planets, at unequal angles, have a resultant: its carrier does not turn
    /// about its centre.
    Unbalanced,
}

impl NotCalculated {
    /// Why, in words.
    #[must_use]
    pub fn why(&self) -> String {
        match self.reason {
            Reason::NotSimple => "no simple set".to_owned(),
            Reason::KeysMissing => format!("{} missing", self.missing.join(", ")),
            Reason::UnequalPlanets => {
                "its planets cannot stand at equal angles, (z_s + z_r)/N is no integer".to_owned()
            }
            Reason::Helical => {
                "its teeth are helical; vibrate takes spur teeth alone, helix_angle: 0 deg, since its model is planar".to_owned()
            }
            Reason::DoesNotRoll => {
                "no mesh turns: its members are joined, or several are held; with a tangential_support of a held one its modes are calculated"
                    .to_owned()
            }
            Reason::NoSpeeds => "no speeds follow in this gear".to_owned(),
            Reason::NoSymmetry => {
                "the second set without three or more planets at equal angles: what two such do depends on the angle between them".to_owned()
            }
            Reason::Unbalanced => {
                "the centrifugal forces of its planets have a resultant, the carrier does not turn about its centre".to_owned()
            }
        }
    }
}
