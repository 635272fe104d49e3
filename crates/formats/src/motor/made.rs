//! Data that a maker adds to the geometry of a motor: material, oil, gaps, friction, ports.

use schemars::JsonSchema;
use serde::Deserialize;
use uom::si::f64::{
    Angle, DynamicViscosity, KinematicViscosity, Length, MassDensity, Pressure, TemperatureCoefficient,
    TemperatureInterval, Volume,
};

use crate::Span;
use epicyclic_units::{Number, Quantity};

/// Data of a maker besides the geometry.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Keys {
    /// Material of all teeth.
    pub material: Option<MaterialGroup>,
    /// The fluid.
    pub oil: Option<OilGroup>,
    /// Gaps at the end faces.
    pub gaps: Option<GapsGroup>,
    /// Coefficient of friction of the flanks, from the least to the greatest.
    pub friction: Option<Span<f64>>,
    /// Ports as made.
    pub ports: Option<PortsGroup>,
}

/// Material of all teeth.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MaterialGroup {
    /// Young's modulus. Default 206 GPa of steels.
    pub youngs_modulus: Option<Quantity<Pressure>>,
    /// Poisson's ratio. Default 0.3.
    pub poissons_ratio: Option<Number>,
    /// Contact stress that the flanks may have; with it the allowed pressure follows.
    pub contact_limit: Option<Quantity<Pressure>>,
    /// Stress that the roots of the teeth may have.
    pub root_limit: Option<Quantity<Pressure>>,
}

/// The fluid, at the temperature at which the motor works.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct OilGroup {
    /// Kinematic viscosity; it needs the density.
    pub viscosity: Option<Quantity<KinematicViscosity>>,
    /// Dynamic viscosity, in place of the kinematic one.
    pub dynamic_viscosity: Option<Quantity<DynamicViscosity>>,
    /// Density.
    pub density: Option<Quantity<MassDensity>>,
    /// Bulk modulus `K`, for pressure trapped and oil compressed.
    pub bulk_modulus: Option<Quantity<Pressure>>,
    /// Law of the gaps beyond the laminar range, measured by the user. Default: there is none, and such gaps
    /// are refused.
    pub turbulence: Option<TurbulenceGroup>,
}

/// Friction of a turbulent flow between plates, `λ = factor·Re^(−exponent)`.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TurbulenceGroup {
    /// Above 0.
    pub factor: Number,
    /// From 0 to 1.
    pub exponent: Number,
}

/// Gaps between the faces of rotor and satellites and the covers; each on one face.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GapsGroup {
    /// At each face of a satellite.
    pub satellites: Quantity<Length>,
    /// At each face of the rotor. Default: that of the satellites.
    pub rotor: Option<Quantity<Length>>,
    /// Bore of the rotor, within which its face has no gap. Default none.
    pub rotor_bore: Option<Quantity<Length>>,
    /// Coefficient of thermal expansion of all wheels; with `temperature_rise` it closes the gaps.
    pub expansion: Option<Quantity<TemperatureCoefficient>>,
    /// By how much satellites and rotor are warmer than the stator.
    pub temperature_rise: Option<Quantity<TemperatureInterval>>,
}

/// Ports as made; one of each pressure at every crest of the stator.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PortsGroup {
    /// Round holes at the ideal places, their diameter as a part of the greatest that a satellite covers; in
    /// place of `high`.
    pub part: Option<Number>,
    /// The port at high pressure before a crest.
    pub high: Option<PortGroup>,
    /// The one at low pressure. Default: the same mirrored in the crest.
    pub low: Option<PortGroup>,
    /// Volume between a port and its chamber, which the oil fills too, of each chamber. Default none.
    pub dead_volume: Option<Quantity<Volume>>,
    /// Discharge coefficient of the openings; without it nothing is said of throttling.
    pub discharge: Option<Number>,
    /// Change of pressure in a closed chamber above which a warning is told.
    pub most_trapped: Option<Quantity<Pressure>>,
}

/// A port: a round hole of `diameter` and `pitch_radius`, or a kidney of `inner_radius`, `outer_radius` and
/// `span`.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PortGroup {
    /// Polar angle of its middle from the crest, counter-clockwise.
    pub angle: Quantity<Angle>,
    /// Diameter of a hole.
    pub diameter: Option<Quantity<Length>>,
    /// Distance of the hole's centre from the axis.
    pub pitch_radius: Option<Quantity<Length>>,
    /// Inner radius of a kidney.
    pub inner_radius: Option<Quantity<Length>>,
    /// Outer radius.
    pub outer_radius: Option<Quantity<Length>>,
    /// Angle from end to end of it.
    pub span: Option<Quantity<Angle>>,
    /// Radius of its corners. Default: half the height, round ends.
    pub corner_radius: Option<Quantity<Length>>,
}
