//! Keys of a gearbox file for the strength of its teeth: of sets, of the gearbox, and its duty.

use super::PerGear;
use epicyclic_units::{Number, Quantity};
use schemars::JsonSchema;
use serde::Deserialize;
use std::collections::BTreeMap;
use uom::si::f64::{AngularVelocity, KinematicViscosity, Length, Pressure, Ratio, Torque};

/// Data for the strength of a set besides its teeth, modules and face widths. Values of gears are lists in
/// their order (sun, planets, ring), or by the names of gears.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StrengthEntry {
    /// Materials of the gears: a designation of the table, or a name of `materials`.
    #[serde(default)]
    pub materials: PerGear<String>,
    /// Roughness `R_z` of the flanks.
    #[serde(default)]
    pub flank_roughness: PerGear<Quantity<Length>>,
    /// Roughness `R_z` of the roots.
    #[serde(default)]
    pub root_roughness: PerGear<Quantity<Length>>,
    /// The shaper that cuts rings; their own `tools` go before it.
    #[serde(default)]
    pub shaper: Option<ShaperEntry>,
    /// Thickness of the rim under the planets' teeth. Default: solid planets.
    #[serde(default)]
    pub planet_rim: Option<Quantity<Length>>,
    /// Thickness of the rim outside the ring's teeth. Default: thick.
    #[serde(default)]
    pub ring_rim: Option<Quantity<Length>>,
    /// Thickness of the rims of gears under their teeth, in place of `planet_rim` and `ring_rim`.
    #[serde(default)]
    pub rims: BTreeMap<String, Quantity<Length>>,
    /// Factors given for all meshes by their symbols, Greek letters as such or spelled: `K_A`, `K_gamma`,
    /// `K_v`, `K_H_beta`.
    #[serde(default)]
    pub factors: BTreeMap<String, Number>,
    /// Factors given for the mesh of sun and planets; they go before `factors`.
    #[serde(default)]
    pub sun_mesh_factors: BTreeMap<String, Number>,
    /// Factors given for the mesh of planets and ring; they go before `factors`.
    #[serde(default)]
    pub ring_mesh_factors: BTreeMap<String, Number>,
    /// Factors given for the sun alone; they, and those of planets and ring, go before all others.
    #[serde(default)]
    pub sun_factors: BTreeMap<String, Number>,
    /// Factors given for the planets alone, in both meshes.
    #[serde(default)]
    pub planet_factors: BTreeMap<String, Number>,
    /// Factors given for the ring alone, such as `Y_delta_rel_T_stat`.
    #[serde(default)]
    pub ring_factors: BTreeMap<String, Number>,
    /// Factors given for single meshes, by their gears: `planet-ring`, `long.2-ring`; they go before
    /// `factors`.
    #[serde(default)]
    pub mesh_factors: BTreeMap<String, BTreeMap<String, Number>>,
    /// Factors given for single gears, in all their meshes; they go before all others.
    #[serde(default)]
    pub gear_factors: BTreeMap<String, BTreeMap<String, Number>>,
    /// Deviations of the teeth, for `K_v`, `K_Hα` and `K_Fα` by method B where they are not given.
    #[serde(default)]
    pub accuracy: Option<AccuracyEntry>,
    /// Accuracy grade by ISO 1328-1: to 4, deep teeth share their load. Default 6.
    #[serde(default)]
    pub accuracy_grade: Option<u8>,
    /// Whether some pitting is allowed, which lengthens the life of flanks. Default false.
    #[serde(default)]
    pub pitting_allowed: Option<bool>,
    /// Life factors `Z_NT` and `Y_NT` at 10¹⁰ cycles, 0.85 to 1. Default 0.85.
    #[serde(default)]
    pub long_life_factor: Option<Number>,
}

/// Deviations of the teeth of a set.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AccuracyEntry {
    /// Base pitch deviations `f_pb` of the gears.
    pub pitch_deviations: PerGear<Quantity<Length>>,
    /// Profile form deviations `f_fα` of the gears.
    pub profile_deviations: PerGear<Quantity<Length>>,
    /// Tip relief `C_a`, of gears of grade 5 and finer. Default none.
    #[serde(default)]
    pub tip_relief: Option<Quantity<Length>>,
    /// Bore of the sun, for its mass. Default a solid sun. That of the planets is their `planet_bore`.
    #[serde(default)]
    pub sun_bore: Option<Quantity<Length>>,
    /// Bores of gears, for their masses, in place of `sun_bore`; of a ring its outside diameter.
    #[serde(default)]
    pub bores: BTreeMap<String, Quantity<Length>>,
    /// Gear blank factor `C_R`. Default 1, of solid discs.
    #[serde(default)]
    pub blank_factor: Option<Number>,
}

/// A shaper.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ShaperEntry {
    /// Number of teeth of the shaper.
    pub teeth: u32,
    /// Profile shift coefficient of the shaper. Default 0.
    #[serde(default)]
    pub shift: Option<Number>,
    /// Addendum of the shaper, in modules. Default: the one that leaves the root circle of the basic rack;
    /// searches take the dedendum of the rack.
    #[serde(default)]
    pub addendum: Option<Number>,
    /// Radius of its tip corners, which is the fillet of the rack that stands for it in the standard, in
    /// modules. Default 0.38 in the standard's formulas, 0.3 for the teeth as it cuts them.
    #[serde(default)]
    pub fillet: Option<Number>,
}

/// A material of one's own.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MaterialEntry {
    /// The name by which sets know it.
    pub name: String,
    /// Class of the material.
    pub class: MaterialClass,
    /// Contact stress limit `σ_Hlim`.
    pub contact_limit: Quantity<Pressure>,
    /// Root stress limit `σ_Flim` of the test gear, for one direction of load.
    pub root_limit: Quantity<Pressure>,
    /// Brinell hardness of the flank, for `Z_W` of a soft gear in mesh with a hard one.
    #[serde(default)]
    pub hardness: Option<Number>,
    /// Yield strength, proof stress or tensile strength, as the notch factor of the class asks for it.
    #[serde(default)]
    pub strength: Option<Quantity<Pressure>>,
    /// Young's modulus. Default 206 GPa of steels; cast iron states its own. Poisson's ratio is 0.3.
    #[serde(default)]
    pub youngs_modulus: Option<Quantity<Pressure>>,
}

/// Class of a material.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum MaterialClass {
    /// Structural steel (St).
    Structural,
    /// Through-hardened steel (V).
    ThroughHardened,
    /// Grey cast iron (GG).
    GreyIron,
    /// Nodular cast iron, pearlitic or bainitic (GGG).
    NodularPearlitic,
    /// Nodular cast iron, ferritic (GGG).
    NodularFerritic,
    /// Black malleable cast iron (GTS).
    Malleable,
    /// Case-hardened steel (Eh).
    CaseHardened,
    /// Induction- or flame-hardened steel (IF).
    SurfaceHardened,
    /// Nitriding steel, nitrided (NT).
    Nitrided,
    /// Through-hardened steel, nitrided (NV, nitr.).
    ThroughHardenedNitrided,
    /// Steel, nitrocarburized (NV, nitrocar.).
    Nitrocarburized,
}

/// The oil.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct OilEntry {
    /// Kinematic viscosity at 40 °C.
    pub viscosity: Quantity<KinematicViscosity>,
    /// Kinematic viscosity at the temperature of the planet bearings, for their modified life.
    #[serde(default)]
    pub working_viscosity: Option<Quantity<KinematicViscosity>>,
    /// Contamination factor `e_C` of the planet bearings, 0 to 1, for their modified life.
    #[serde(default)]
    pub contamination: Option<Number>,
}

/// A part of the time in one gear at one load.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DutyEntry {
    /// The gear.
    pub gear: String,
    /// Share of the time; those of all steps sum to 1.
    pub share: Quantity<Ratio>,
    /// Torque on the input.
    pub torque: Quantity<Torque>,
    /// Speed of the input.
    pub speed: Quantity<AngularVelocity>,
}

/// A greatest torque in the life.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct OverloadEntry {
    /// The gear.
    pub gear: String,
    /// Torque on the input, dynamic forces among it.
    pub torque: Quantity<Torque>,
    /// Required safeties against it. Default 1 of flanks and roots.
    #[serde(default)]
    pub required: Option<RequiredEntry>,
}

/// Required safeties.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RequiredEntry {
    /// Safety of the flanks, `S_H`.
    pub flank: Number,
    /// Safety of the roots, `S_F`.
    pub root: Number,
}

/// Member of a planetary set that floats.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum FloatingEntry {
    /// The sun.
    Sun,
    /// The ring.
    Ring,
    /// The carrier.
    Carrier,
    /// No member: all turn in rigid bearings.
    None,
}
