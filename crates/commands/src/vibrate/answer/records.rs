//! Records of vibration: modes of sets, orders of excitation, resonances, frequencies over the speed.

use epicyclic_pictures::modes::Part;
use epicyclic_vibration::Kind;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Serialize, Serializer};
use serde_json::Value;
use std::collections::BTreeMap;

/// Modes of a set in the gears that hold the same members and load the same flanks.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct SetModes {
    /// Name of the set.
    pub set: String,
    /// Names of the gears; empty for a gearbox without gears.
    pub gears: Vec<String>,
    /// Members whose links are held in these gears.
    pub held: Vec<String>,
    /// Number of planets of each kind; 0 of a pair.
    pub planets: u32,
    /// Angles of the planets on the carrier from `x`, in rad; of several kinds those of the first.
    pub planet_angles_rad: Vec<f64>,
    /// Whether the planets are equally spaced. With other spacings, modes may be mixed, and double modes
    /// split.
    pub equally_spaced: bool,
    /// Central gears, carrier, and one planet of each kind.
    pub bodies: Vec<VibratingBody>,
    /// Springs: one mesh of each kind, the bearing of one planet, supports.
    pub springs: Vec<Spring>,
    /// Stiffnesses of the springs of a simple set; null of other sets.
    pub stiffness: Option<Stiffnesses>,
    /// Working pressure angle of the sun meshes of a simple set in rad; null of other sets.
    pub sun_pressure_angle_rad: Option<f64>,
    /// Working pressure angle of the ring meshes of a simple set in rad; null of other sets.
    pub ring_pressure_angle_rad: Option<f64>,
    /// Modes at rest in increasing order of frequency; modes of equal frequency and kind are one entry.
    pub modes: Vec<Mode>,
}

/// Body of a set.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct VibratingBody {
    /// Name of the body.
    pub body: String,
    /// Kind of the body: external central gears are suns, internal ones rings.
    pub part: Part,
    /// Mass in kg; null if the centre of the body is held.
    pub mass_kg: Option<f64>,
    /// Moment of inertia in kg·m²; null if the body cannot rotate.
    pub inertia_kg_m2: Option<f64>,
    /// Base radius of a gear in m, of a stepped planet that of its first gear; for the carrier the radius of
    /// the planet centres.
    pub radius_m: f64,
    /// Centre at rest in m, of a planet that of the first of its kind.
    pub centre_m: [f64; 2],
}

/// Spring of a set.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Spring {
    /// Name of the spring: `sun mesh`, `planet bearing`, `ring support`.
    pub spring: String,
    /// Stiffness in N/m: of a mesh along its line of action in the transverse plane, of a bearing or support
    /// radial, of a tangential support torsional over the square of the body's radius.
    pub stiffness_n_m: f64,
    /// Origin of the stiffness.
    pub by: StiffnessOrigin,
    /// Transverse working pressure angle of a mesh in rad; null for other springs.
    pub pressure_angle_rad: Option<f64>,
    /// Helix angle of a mesh in rad; null for other springs. Only the motion in the transverse plane is
    /// calculated.
    pub helix_angle_rad: Option<f64>,
}

/// Stiffnesses of the springs of a simple set.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Stiffnesses {
    /// Origin of the mesh stiffness.
    pub meshes_by: StiffnessOrigin,
    /// Stiffness of a sun mesh along the line of action, in N/m.
    pub sun_mesh_n_m: f64,
    /// Stiffness of a ring mesh along the line of action, in N/m.
    pub ring_mesh_n_m: f64,
    /// Radial stiffness of the bearings of one planet, in N/m.
    pub planet_bearing_n_m: f64,
    /// Radial stiffness of the sun's support, in N/m; null for a rigid support.
    pub sun_support_n_m: Option<f64>,
    /// Radial stiffness of the ring's support, in N/m; null for a rigid support.
    pub ring_support_n_m: Option<f64>,
    /// Radial stiffness of the carrier's support, in N/m; null for a rigid support.
    pub carrier_support_n_m: Option<f64>,
    /// Torsional stiffness that holds the sun against rotation, over the square of its base radius, in N/m.
    /// Null if the sun is free or held rigidly.
    pub sun_tangential_support_n_m: Option<f64>,
    /// Torsional stiffness that holds the ring against rotation, over the square of its base radius, in N/m.
    /// Null if the ring is free or held rigidly.
    pub ring_tangential_support_n_m: Option<f64>,
    /// Torsional stiffness that holds the carrier against rotation, over the square of the radius of the
    /// planet centres, in N/m. Null if the carrier is free or held rigidly.
    pub carrier_tangential_support_n_m: Option<f64>,
}

impl Stiffnesses {
    /// Stiffnesses by the springs of a set; `None` of a set without a sun, a ring and one kind of planets.
    pub(super) fn of(springs: &[Spring]) -> Option<Self> {
        let of = |name: &str| springs.iter().find(|spring| spring.spring == name);
        let stiffness = |name: &str| of(name).map(|spring| spring.stiffness_n_m);
        Some(Self {
            meshes_by: of("sun mesh")?.by,
            sun_mesh_n_m: stiffness("sun mesh")?,
            ring_mesh_n_m: stiffness("ring mesh")?,
            planet_bearing_n_m: stiffness("planet bearing")?,
            sun_support_n_m: stiffness("sun support"),
            ring_support_n_m: stiffness("ring support"),
            carrier_support_n_m: stiffness("carrier support"),
            sun_tangential_support_n_m: stiffness("sun, tangential"),
            ring_tangential_support_n_m: stiffness("ring, tangential"),
            carrier_tangential_support_n_m: stiffness("carrier, tangential"),
        })
    }
}

/// Shares of named parts in an energy, with the sum 1.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Shares(pub Vec<(String, f64)>);

impl Shares {
    /// Share of a part.
    #[must_use]
    pub fn of(&self, part: &str) -> Option<f64> {
        self.0.iter().find(|(name, _)| name == part).map(|(_, share)| *share)
    }
}

impl Serialize for Shares {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(name, share)| (name, share)))
    }
}

/// Schema of [`Shares`] in which simple sets have these parts; others have the names of their gears.
fn shares(types: &Value, parts: [&str; 4]) -> Schema {
    let share = || json_schema!({ "type": "number" });
    let properties: BTreeMap<&str, Schema> = parts.into_iter().map(|part| (part, share())).collect();
    json_schema!({ "type": types, "properties": properties, "additionalProperties": share() })
}

fn kinetic_shares(_: &mut SchemaGenerator) -> Schema {
    shares(&"object".into(), ["sun", "ring", "carrier", "planets"])
}

fn strain_shares(_: &mut SchemaGenerator) -> Schema {
    shares(&vec!["object", "null"].into(), ["sun_meshes", "ring_meshes", "planet_bearings", "supports"])
}

/// Origins of the mesh stiffness.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum StiffnessOrigin {
    /// Given in the file.
    Given,
    /// Mesh stiffness `c_γα·b` by ISO 6336-1.
    Iso6336,
}

/// Modes of one frequency and kind.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Mode {
    /// Number of the mode, from 1.
    pub mode: u32,
    /// Motion of the central members.
    pub kind: Kind,
    /// Number of modes with this frequency.
    pub multiplicity: u32,
    /// Natural frequency in Hz; 0 if all bodies turn by their ratios without deformation of a spring.
    pub frequency_hz: f64,
    /// Parts of the bodies in the kinetic energy: of central gears and the carrier by name, of all planets
    /// together as `planets`, where there are several kinds of each kind by name.
    #[schemars(schema_with = "kinetic_shares")]
    pub kinetic: Shares,
    /// Parts of the springs in the strain energy; null if no spring is deformed: `sun_meshes`,
    /// `planet_bearings`, `supports`. Half of a part is the increase of the frequency in per cent if the
    /// stiffness of these springs increases by 1 %.
    #[schemars(schema_with = "strain_shares")]
    pub strain: Option<Shares>,
    /// Motions of central gears, carrier and planets. If several modes have one frequency, the one with the
    /// largest motion of the first moving body in this order is given.
    pub shape: Vec<BodyMotion>,
}

/// Motion of a body in a mode.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct BodyMotion {
    /// Name of the body.
    pub body: String,
    /// Number of the planet among those of its kind, from 1; null for other bodies.
    pub planet: Option<u32>,
    /// Displacement of the centre along `x`, towards the first planet, relative to the largest displacement
    /// of the mode.
    pub x: f64,
    /// Displacement of the centre along `y`, relative to the largest displacement of the mode.
    pub y: f64,
    /// Rotation times radius, relative to the largest displacement of the mode.
    pub u: f64,
}

/// Sources of excitation with a frequency that follows from speeds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Source {
    /// Meshing teeth, with equal frequency at sun and ring.
    Mesh,
    /// Parts that turn with the sun, such as its runout: once per turn relative to the carrier.
    SunTurn,
    /// Parts that turn with the ring or are fixed with it: once per turn relative to the carrier.
    RingTurn,
    /// Parts that turn with a gear of a pair.
    GearTurn,
    /// Planets that pass a place of the sun.
    SunPlanetPass,
    /// Planets that pass a place of the ring.
    RingPlanetPass,
    /// Parts that turn with a planet: once per turn relative to the carrier.
    PlanetTurn,
    /// Drive or load of a link: once per turn, for torsional modes only.
    LinkTurn,
}

/// Order of excitation of a set in a gear.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Order {
    /// Name of the set.
    pub set: String,
    /// Name of the gear.
    pub gear: String,
    /// Source of the excitation.
    pub source: Source,
    /// Central gear, planet or meshes that excite, of a set that is not simple; null in simple sets, where
    /// the source names it.
    pub part: Option<String>,
    /// Number of the harmonic of the source.
    pub harmonic: u32,
    /// Frequency in coordinates on the carrier, relative to the input's rotational frequency.
    pub of_input: f64,
    /// Frequency at the greatest requested speed of the input, in Hz.
    pub frequency_hz: f64,
    /// Kind of modes that the order can excite; null if it can excite all.
    pub excites: Option<Kind>,
}

/// Speed at which an order has the frequency of a mode that it can excite.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Resonance {
    /// Name of the set.
    pub set: String,
    /// Name of the gear.
    pub gear: String,
    /// Input speed in rad/s.
    pub input_speed_rad_s: f64,
    /// Source of the excitation.
    pub source: Source,
    /// Part that excites, as for orders.
    pub part: Option<String>,
    /// Number of the harmonic of the source.
    pub harmonic: u32,
    /// Number of the mode at rest from which the excited mode develops.
    pub mode: u32,
    /// Kind of the mode.
    pub kind: Kind,
    /// Frequency in Hz, in coordinates on the carrier.
    pub frequency_hz: f64,
}

/// Natural frequencies of a set over the speed in a gear, with the gyroscopic effect of the carrier speed.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Campbell {
    /// Name of the set.
    pub set: String,
    /// Name of the gear.
    pub gear: String,
    /// Speed of the carrier relative to the input speed; 0 of a pair.
    pub carrier_speed_of_input: f64,
    /// Input speeds in rad/s.
    pub input_speeds_rad_s: Vec<f64>,
    /// Branches of the natural frequencies over these speeds, one for each mode of a frequency.
    pub branches: Vec<Branch>,
}

/// Natural frequency over the speed.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Branch {
    /// Number of the mode at rest from which the branch starts.
    pub mode: u32,
    /// Kind of the mode.
    pub kind: Kind,
    /// Frequencies at the speeds in Hz, in coordinates on the carrier.
    pub frequencies_hz: Vec<f64>,
}

/// Dynamic mesh forces of a set in a gear caused by transmission errors, in addition to the mean forces.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Response {
    /// Name of the set.
    pub set: String,
    /// Name of the gear.
    pub gear: String,
    /// Damping ratio of every mode.
    pub damping_ratio: f64,
    /// Whether the gyroscopic effect of the carrier speed is included. Without it, or with the carrier at
    /// rest, the matrices are those at rest.
    pub gyroscopic: bool,
    /// Responses to the harmonics of the meshes.
    pub harmonics: Vec<HarmonicResponse>,
}

/// Forces caused by a harmonic of meshes.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct HarmonicResponse {
    /// Number of the harmonic.
    pub harmonic: u32,
    /// Meshes that excite, of a set that is not simple; null in simple sets, where all do.
    pub part: Option<String>,
    /// Forces in the meshes of each kind.
    pub meshes: Vec<MeshResponse>,
    /// Amplitude of the transmission error of a sun mesh, in m; null in sets that are not simple.
    pub sun_error_m: Option<f64>,
    /// Amplitude of the transmission error of a ring mesh, in m; null in sets that are not simple.
    pub ring_error_m: Option<f64>,
    /// Greatest force of a sun mesh within the speeds; null in sets that are not simple.
    pub greatest_sun: Option<Greatest>,
    /// Greatest force of a ring mesh within the speeds; null in sets that are not simple.
    pub greatest_ring: Option<Greatest>,
    /// Input speeds in rad/s: the requested ones, and further ones near resonances.
    pub input_speeds_rad_s: Vec<f64>,
    /// Force amplitudes in N at these speeds, of the sun mesh with the largest; null in sets that are not
    /// simple.
    pub sun_forces_n: Option<Vec<f64>>,
    /// Force amplitudes in N at these speeds, of the ring mesh with the largest; null in sets that are not
    /// simple.
    pub ring_forces_n: Option<Vec<f64>>,
}

impl HarmonicResponse {
    /// Response with the meshes of sun and ring apart, where they are all.
    pub(super) fn of(
        harmonic: u32,
        part: Option<String>,
        input_speeds_rad_s: Vec<f64>,
        meshes: Vec<MeshResponse>,
    ) -> Self {
        let [sun, ring] = match &meshes[..] {
            [sun, ring] if part.is_none() => [Some(sun.clone()), Some(ring.clone())],
            _ => [None, None],
        };
        let error = |mesh: &Option<MeshResponse>| mesh.as_ref().map(|mesh| mesh.error_m);
        let greatest = |mesh: &Option<MeshResponse>| mesh.as_ref().map(|mesh| mesh.greatest);
        Self {
            harmonic,
            part,
            sun_error_m: error(&sun),
            ring_error_m: error(&ring),
            greatest_sun: greatest(&sun),
            greatest_ring: greatest(&ring),
            sun_forces_n: sun.map(|mesh| mesh.forces_n),
            ring_forces_n: ring.map(|mesh| mesh.forces_n),
            input_speeds_rad_s,
            meshes,
        }
    }
}

/// Forces in the meshes of one kind.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct MeshResponse {
    /// Name of the meshes: a central gear, or both gears.
    pub mesh: String,
    /// Amplitude of their transmission error in m; 0 if they do not excite.
    pub error_m: f64,
    /// Central gear whose torque keeps the flanks together; null for meshes of two planets.
    pub torque_on: Option<String>,
    /// Greatest force within the speeds.
    pub greatest: Greatest,
    /// Force amplitudes in N at the speeds, of the mesh with the largest.
    pub forces_n: Vec<f64>,
}

/// Greatest force that a harmonic causes in a mesh.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Greatest {
    /// Amplitude of the force in N.
    pub force_n: f64,
    /// Input speed in rad/s.
    pub input_speed_rad_s: f64,
    /// Frequency in Hz, in coordinates on the carrier.
    pub frequency_hz: f64,
    /// Torque on a central gear in N·m, shared by all planets, below which the flanks separate, because the
    /// mean force is less than this amplitude; null for meshes of two planets.
    pub parts_below_torque_n_m: Option<f64>,
    /// Torque at which the flanks part where it is on the sun of a simple set; null in other sets.
    pub parts_below_sun_torque_n_m: Option<f64>,
}

/// Set without modes, or without orders, in a gear.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct NotCalculated {
    /// Name of the set.
    pub set: String,
    /// Name of the gear; null if the reason applies to all gears.
    pub gear: Option<String>,
    /// Results that are not calculated.
    pub what: What,
    /// Reason why they are not calculated.
    pub reason: Reason,
    /// Keys of the set that are missing, or meshes whose phases are.
    pub missing: Vec<String>,
}

/// Results that may not be calculated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum What {
    /// Modes of the set.
    Modes,
    /// Orders and resonances.
    Resonances,
    /// Forces caused by transmission errors.
    Forces,
    /// Torsional modes of the whole gearbox, because of this set.
    Torsional,
    /// Modes of the whole gearbox in the plane, because of this set.
    Coupled,
}

/// Reasons why results are not calculated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Reason {
    /// The set has bevel gears, which do not move in one plane.
    Bevel,
    /// A link turns as a planet does about its own axis.
    PlanetShaft,
    /// The file lacks keys of the set.
    KeysMissing,
    /// The planets of a simple set cannot be equally spaced: (z_s + z_r)/N is not an integer.
    UnequalPlanets,
    /// The planets of another set cannot be equally spaced: their number does not divide the assembly
    /// positions.
    NotAssembled,
    /// Two planets in mesh do not reach each other on their circles.
    PlanetsApart,
    /// The members are joined, or several are held, so that no mesh turns.
    DoesNotRoll,
    /// No speeds can be computed in the gear.
    NoSpeeds,
    /// The set is the second one with fewer than three planets, or with unequal spacing. The vibration of two
    /// such sets depends on the angle between them.
    NoSymmetry,
    /// The centrifugal forces of unequally spaced planets have a resultant, so that the carrier does not turn
    /// about its centre.
    Unbalanced,
    /// Several meshes have one frequency, and the phase between their teeth is not known.
    PhasesUnknown,
}

impl NotCalculated {
    /// Reason in words.
    #[must_use]
    pub fn why(&self) -> String {
        match self.reason {
            Reason::Bevel => "it has bevel gears, whose axes cross".to_owned(),
            Reason::PlanetShaft => "a link turns as its planets do about their own axes".to_owned(),
            Reason::KeysMissing => format!("{} missing", self.missing.join(", ")),
            Reason::UnequalPlanets => {
                "its planets cannot stand at equal angles, (z_s + z_r)/N is no integer".to_owned()
            }
            Reason::NotAssembled => {
                "its teeth do not let planets stand at equal angles; write spacing: least_unequal".to_owned()
            }
            Reason::PlanetsApart => {
                "two of its planets in mesh do not reach each other: give their meshes the profile_shifts or modules that they need".to_owned()
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
            Reason::PhasesUnknown => format!(
                "the meshes {} have one frequency, and the phase between their teeth is not known",
                self.missing.join(", ")
            ),
        }
    }
}
