//! Records of the vibration of a whole gearbox: torsional modes with their resonances, and coupled modes in
//! the plane.

use super::links::TrainSet;
use super::records::Source;
use epicyclic_train::compound::CentralKind;
use epicyclic_train::planet_set::GearOf;
use epicyclic_vibration::{Kind, SpringId};
use schemars::JsonSchema;
use serde::Serialize;

/// Torsional modes of the whole gearbox in a gear.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct TorsionalModes {
    /// Name of the gear.
    pub gear: String,
    /// Number of modes with frequency 0: the degrees of freedom that the gear keeps.
    pub freedoms: u32,
    /// Inertia of the whole gearbox, with what its links carry, reduced to the input, in kg·m²: the kinetic
    /// energy is `½·J·ω²` at the speed of the input. Null in a gear that keeps no freedom or several.
    pub inertia_at_input_kg_m2: Option<f64>,
    /// Inertia of the whole gearbox reduced to the output, in kg·m²; null as that at the input.
    pub inertia_at_output_kg_m2: Option<f64>,
    /// Modes in increasing order of frequency.
    pub modes: Vec<TorsionalMode>,
    /// Orders of excitation, in coordinates on the carrier of each set; empty without speeds.
    pub orders: Vec<TorsionalOrder>,
    /// Resonances in increasing order of speed; empty without speeds.
    pub resonances: Vec<TorsionalResonance>,
    /// Least and greatest requested input speed in rad/s; null without speeds.
    pub input_speeds_rad_s: Option<[f64; 2]>,
}

/// Order of excitation of the torsional modes in a gear.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct TorsionalOrder {
    /// Name of the set; for a turn of links, the links that turn as one piece.
    pub of: String,
    /// Source of the excitation.
    pub source: Source,
    /// Part of the set that excites, as for orders of a set; null for links and simple sets.
    pub part: Option<String>,
    /// Number of the harmonic of the source.
    pub harmonic: u32,
    /// Frequency relative to the input's rotational frequency.
    pub of_input: f64,
    /// Frequency at the greatest requested speed of the input, in Hz.
    pub frequency_hz: f64,
    /// Kind of modes that the order can excite by the phases of the planets of its set; null if it can excite
    /// all.
    pub excites: Option<Kind>,
}

/// Speed at which an order has the frequency of a torsional mode that it can excite.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct TorsionalResonance {
    /// Input speed in rad/s.
    pub input_speed_rad_s: f64,
    /// Name of the set, or of the links.
    pub of: String,
    /// Source of the excitation.
    pub source: Source,
    /// Part of the set that excites, as for orders of a set; null for links and simple sets.
    pub part: Option<String>,
    /// Number of the harmonic of the source.
    pub harmonic: u32,
    /// Number of the mode.
    pub mode: u32,
    /// Frequency of the mode in Hz.
    pub frequency_hz: f64,
    /// Part of the mode's energy at the place of excitation: for a set that of its meshes in the strain
    /// energy, for links their part in the kinetic energy.
    pub share: f64,
}

/// Torsional modes of one frequency.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct TorsionalMode {
    /// Number of the mode, from 1.
    pub mode: u32,
    /// Kind of the mode. Rotational: links rotate; planet: links are at rest.
    pub kind: Kind,
    /// Number of modes with this frequency and kind.
    pub multiplicity: u32,
    /// Natural frequency in Hz.
    pub frequency_hz: f64,
    /// Parts of the bodies in the kinetic energy.
    pub kinetic: Vec<TorsionalKinetic>,
    /// Parts of the springs in the strain energy; empty if no spring is twisted.
    pub strain: Vec<TorsionalStrain>,
}

/// Part of links that turn as one piece, or of the planets of a set about their axes, in the kinetic energy.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct TorsionalKinetic {
    /// Names of the links; a member on its own support by name and set. Empty for planets.
    pub links: Vec<String>,
    /// Name of the set of the planets; null for links.
    pub planets_of: Option<String>,
    /// Part of the kinetic energy, from 0 to 1.
    pub share: f64,
}

/// Part of springs in the strain energy.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct TorsionalStrain {
    /// Kind of the springs.
    pub part: StrainPart,
    /// Name of the set of the meshes, of the shaft, or of the supported part.
    pub of: String,
    /// Name of the meshes in their set: a central gear, or both gears; null for other springs.
    pub mesh: Option<String>,
    /// Part of the strain energy, from 0 to 1.
    pub share: f64,
}

impl TorsionalStrain {
    /// Parts of the meshes of a set, those of one kind together.
    pub(super) fn of_meshes(
        set: &TrainSet<'_>,
        springs: &[SpringId],
        share: impl Fn(&[SpringId]) -> f64,
    ) -> impl Iterator<Item = Self> {
        set.prepared.meshes.iter().enumerate().map(move |(place, mesh)| {
            let central = mesh.gears.iter().find_map(|(gear, _)| match gear {
                GearOf::Central(central) => Some(set.of.set.centrals()[*central].kind),
                GearOf::Planet(..) => None,
            });
            let part = match central {
                _ if set.of.set.is_pair() => StrainPart::PairMesh,
                Some(CentralKind::Ring) => StrainPart::RingMeshes,
                Some(_) => StrainPart::SunMeshes,
                None => StrainPart::PlanetMeshes,
            };
            let share = share(&set.prepared.of_mesh(springs, place));
            Self { part, of: set.of.set.id().to_owned(), mesh: Some(mesh.name.clone()), share }
        })
    }
}

/// Kinds of springs in a mode of the whole gearbox.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum StrainPart {
    /// Meshes of a sun.
    SunMeshes,
    /// Meshes of a ring.
    RingMeshes,
    /// Meshes of two planets.
    PlanetMeshes,
    /// Mesh of a pair.
    PairMesh,
    /// Torsion of a shaft.
    Shaft,
    /// Support that holds a member against rotation.
    Support,
    /// Bearings of the planets of a set.
    PlanetBearings,
    /// Support of a centre.
    CentreSupport,
    /// Bending of a shaft.
    Bending,
}

/// Modes of all sets of a gearbox in the plane, on common links and centres, in a gear.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct CoupledModes {
    /// Name of the gear.
    pub gear: String,
    /// Number of modes with frequency 0: the degrees of freedom that the gear keeps, and centres without
    /// support.
    pub freedoms: u32,
    /// Bodies whose centres move in the plane as one piece.
    pub centres: Vec<CentreBody>,
    /// Modes at rest in increasing order of frequency.
    pub modes: Vec<CoupledMode>,
}

/// Members whose centre moves as one piece.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct CentreBody {
    /// Members with this centre.
    pub members: Vec<CentreMember>,
    /// Total mass of the members in kg, carriers without planets; null if the centre is held.
    pub mass_kg: Option<f64>,
    /// Total stiffness of the members' radial supports in N/m; null if the centre is held.
    pub support_n_m: Option<f64>,
}

/// Part of a set.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct CentreMember {
    /// Name of the set.
    pub set: String,
    /// Name of the member.
    pub member: String,
}

/// Modes of one frequency and kind.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct CoupledMode {
    /// Number of the mode, from 1.
    pub mode: u32,
    /// Motion of links and centres.
    pub kind: Kind,
    /// Number of modes with this frequency and kind.
    pub multiplicity: u32,
    /// Natural frequency in Hz.
    pub frequency_hz: f64,
    /// Motion of the members of each set.
    pub sets: Vec<SetInMode>,
    /// Parts of the bodies in the kinetic energy.
    pub kinetic: Vec<CoupledKinetic>,
    /// Parts of the springs in the strain energy; empty if no spring is deformed.
    pub strain: Vec<TorsionalStrain>,
}

/// Motion of a set in a mode of the whole gearbox.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct SetInMode {
    /// Name of the set.
    pub set: String,
    /// Motion of central gears and carrier; null if the planets are at rest, too.
    pub kind: Option<Kind>,
}

/// Part of a body in the kinetic energy.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct CoupledKinetic {
    /// Kind of the moving body.
    pub part: KineticPart,
    /// Names of the links, of the members of a centre as in `sun of P`, or of the set of the planets.
    pub of: Vec<String>,
    /// Part of the kinetic energy, from 0 to 1.
    pub share: f64,
}

/// Kinds of moving bodies in a mode of the whole gearbox.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum KineticPart {
    /// Links that rotate.
    Rotation,
    /// Centre that translates.
    Translation,
    /// Planets of a set.
    Planets,
}
