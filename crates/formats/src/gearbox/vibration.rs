//! Keys of a gearbox file for the vibration of its sets: bodies, bearings, supports, stiffness of meshes.

use epicyclic_units::Quantity;
use epicyclic_units::TorsionalStiffness;
use schemars::JsonSchema;
use serde::Deserialize;
use std::collections::BTreeMap;
use uom::si::f64::{Angle, AngularVelocity, Length, Mass, MomentOfInertia, Ratio, SurfaceTension};

/// A stiffness, N/m.
pub type Stiffness = SurfaceTension;

/// Data for the vibration of the whole gearbox besides its sets, and its excitation.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct VibrationOfGearbox {
    /// Inertias of links beside the members of sets: of motors, machines, couplings.
    #[serde(default)]
    pub link_inertias: BTreeMap<String, Quantity<MomentOfInertia>>,
    /// Ties that are springs.
    #[serde(default)]
    pub shafts: Vec<ShaftEntry>,
    /// Least and greatest speed of the input, for resonances and forces. An option gives others.
    #[serde(default)]
    pub speeds: Option<[Quantity<AngularVelocity>; 2]>,
    /// Number of harmonics of the meshes. Default 3.
    #[serde(default)]
    pub harmonics: Option<u32>,
    /// Amplitudes of the transmission error of the meshes, the first harmonic first.
    #[serde(default)]
    pub transmission_error: Vec<Quantity<Length>>,
    /// Transmission error of the ring's meshes, if it differs.
    #[serde(default)]
    pub ring_transmission_error: Vec<Quantity<Length>>,
    /// Damping ratio of every mode, for the forces that transmission errors make.
    #[serde(default)]
    pub damping: Option<Quantity<Ratio>>,
}

/// A tie that is a shaft.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ShaftEntry {
    /// Name of the shaft.
    pub id: String,
    /// The two links, which `ties` join.
    pub between: [String; 2],
    /// Torsional stiffness.
    pub stiffness: Quantity<TorsionalStiffness>,
    /// Lateral stiffness between the centres of the two links, for their motion in the plane. Default:
    /// none.
    #[serde(default)]
    pub lateral_stiffness: Option<Quantity<Stiffness>>,
}

/// Data for the vibration of a simple set besides its teeth, module, face width and planets.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct VibrationEntry {
    /// The sun.
    #[serde(default)]
    pub sun: SunEntry,
    /// The ring.
    #[serde(default)]
    pub ring: RingEntry,
    /// The carrier without planets.
    #[serde(default)]
    pub carrier: CarrierEntry,
    /// A planet; its mass is `planet_mass` of the set, or that of its shape.
    #[serde(default)]
    pub planet: PlanetEntry,
    /// Radial stiffness of the bearings of one planet together.
    pub planet_bearing: Quantity<Stiffness>,
    /// Read as `planet_angles` of the set, where files before version 2 have them; a file gives one of the
    /// two.
    #[serde(default)]
    pub planet_angles: Option<Vec<Quantity<Angle>>>,
    /// Stiffness of one mesh of the sun and of one of the ring along the line of action. Default: `c_γα·b` by
    /// ISO 6336.
    #[serde(default)]
    pub mesh_stiffness: Option<[Quantity<Stiffness>; 2]>,
    /// Transverse working pressure angles of the meshes of sun and ring. Default: those of the teeth.
    #[serde(default)]
    pub pressure_angles: Option<[Quantity<Angle>; 2]>,
    /// Base radii of sun, planets and ring. Default: those of the teeth.
    #[serde(default)]
    pub base_radii: Option<[Quantity<Length>; 3]>,
}

/// The sun as a body.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SunEntry {
    /// Mass. Default: that of the shape.
    #[serde(default)]
    pub mass: Option<Quantity<Mass>>,
    /// Inertia with all that turns with the body. Default: that of the shape.
    #[serde(default)]
    pub inertia: Option<Quantity<MomentOfInertia>>,
    /// In place of the inertia: the inertia over the square of the base radius, `I/r_b²`.
    #[serde(default)]
    pub rotary_mass: Option<Quantity<Mass>>,
    /// Diameter of its bore, for its shape. Default: solid.
    #[serde(default)]
    pub bore: Option<Quantity<Length>>,
    /// Radial stiffness of its bearings; 0 of a floating sun. Default: rigid.
    #[serde(default)]
    pub support: Option<Quantity<Stiffness>>,
    /// Stiffness of what holds it against rotation in gears in which its link is held: torsional stiffness
    /// over `r_b²`. Default: rigid.
    #[serde(default)]
    pub tangential_support: Option<Quantity<Stiffness>>,
}

/// The ring as a body.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RingEntry {
    /// Mass. Default: that of the shape.
    #[serde(default)]
    pub mass: Option<Quantity<Mass>>,
    /// Inertia with all that turns with the body. Default: that of the shape.
    #[serde(default)]
    pub inertia: Option<Quantity<MomentOfInertia>>,
    /// In place of the inertia: `I/r_b²`.
    #[serde(default)]
    pub rotary_mass: Option<Quantity<Mass>>,
    /// Outside diameter, for the shape.
    #[serde(default)]
    pub outside_diameter: Option<Quantity<Length>>,
    /// Radial stiffness of its bearings or fixing; 0 of a floating ring. Default: rigid.
    #[serde(default)]
    pub support: Option<Quantity<Stiffness>>,
    /// Stiffness of what holds it against rotation in gears in which its link is held: torsional stiffness
    /// over `r_b²`. Default: rigid.
    #[serde(default)]
    pub tangential_support: Option<Quantity<Stiffness>>,
}

/// The carrier as a body, without planets.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CarrierEntry {
    /// Mass.
    #[serde(default)]
    pub mass: Option<Quantity<Mass>>,
    /// Inertia with all that turns with the body.
    #[serde(default)]
    pub inertia: Option<Quantity<MomentOfInertia>>,
    /// In place of the inertia: the inertia over the square of the radius of the planets' circle.
    #[serde(default)]
    pub rotary_mass: Option<Quantity<Mass>>,
    /// Radial stiffness of its bearings; 0 of a floating carrier. Default: rigid.
    #[serde(default)]
    pub support: Option<Quantity<Stiffness>>,
    /// Stiffness of what holds it against rotation in gears in which its link is held, over the square of
    /// that radius. Default: rigid.
    #[serde(default)]
    pub tangential_support: Option<Quantity<Stiffness>>,
}

/// A planet as a body.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PlanetEntry {
    /// Inertia. Default: that of the shape.
    #[serde(default)]
    pub inertia: Option<Quantity<MomentOfInertia>>,
    /// In place of the inertia: `I/r_b²`.
    #[serde(default)]
    pub rotary_mass: Option<Quantity<Mass>>,
}
