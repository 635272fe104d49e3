//! The file that describes a planetary drive: `epicyclic drive drive.yaml`.
//!
//! ```yaml
//! power: 30 kW
//! speed: 1450 rpm
//! ratio: 5
//! gear_set: { module: 5 mm, face_width: 50 mm }
//! ```
//!
//! is enough; every other key has a default, stated at the field. A [`DriveFile`] says what was written,
//! [`DriveFile::spec`] what is meant by it.

use epicyclic_dynamics::drive::DriveSpec;
use epicyclic_gears::synthesis::Placement;
use schemars::JsonSchema;
use serde::Deserialize;
use uom::si::f64::{
    Angle, AngularVelocity, Length, Mass, MassDensity, MomentOfInertia, Power, Pressure, Ratio, Torque,
};

use crate::{Document, Error, FileKind, Path, Span};
use epicyclic_units::{Module, Number, Quantity};

mod fields;
mod meaning;
mod place;
#[cfg(test)]
mod tests;

pub use fields::{BearingSeries, BoreText, Designation};
pub use place::place;

/// A planetary drive: driven at the sun, ring at rest, load on the carrier.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DriveFile {
    /// Purpose of the drive; printed above the answer.
    pub title: Option<String>,
    /// Power at the sun's shaft.
    pub power: Quantity<Power>,
    /// Speed of the sun.
    pub speed: Quantity<AngularVelocity>,
    /// Ratio of the speeds of sun and carrier. It may be left out where `teeth` gives sun, planets, and
    /// planet or ring.
    pub ratio: Option<Number>,
    /// How far the ratio may be off, below 100 %. Default 1 %.
    pub ratio_tolerance: Option<Quantity<Ratio>>,
    /// Tooth numbers, or bounds for them. Default: found by a search.
    pub teeth: Option<TeethFile>,
    /// Efficiencies of the meshes.
    pub mesh_efficiency: Option<MeshEfficiencyFile>,
    /// Module, width and material of the gears.
    pub gear_set: GearSetFile,
    /// Shafts and bearings. Default: sized by reduced torsional stress.
    pub shafts: Option<ShaftsFile>,
    /// The carrier. Default: taken as massless, with a warning.
    pub carrier: Option<CarrierFile>,
    /// Masses and inertias that are known of single parts. Default: those of the shapes.
    pub parts: Option<PartsFile>,
    /// Inertias attached to the drive.
    pub attached: Option<AttachedFile>,
    /// Torques while the drive starts.
    pub start: Option<StartFile>,
}

/// Tooth numbers or bounds for them: one number, or a range with both ends included.
///
/// Where sun, planets, and planet or ring are single numbers the set is taken as given, even if it does not
/// fit. Otherwise the set nearest to the ratio is taken; of equally near ones that with most planets, then
/// the smallest.
#[derive(Debug, Clone, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TeethFile {
    /// Teeth of the sun. Default: from the fewest without undercut, 17 at 20° and addendum 1, to 200.
    pub sun: Option<Span<u32>>,
    /// Teeth of a planet. Default: as of the sun.
    pub planet: Option<Span<u32>>,
    /// Teeth of the ring. Default 12..200.
    pub ring: Option<Span<u32>>,
    /// Number of planets. Default 3..8, as many as fit.
    pub planets: Option<Span<u32>>,
    /// `equal`, the default, or `least-unequal`: where equal angles do not assemble, as near to them as do. A
    /// set given in full that does not assemble at equal angles is warned of unless unequal ones are allowed.
    pub spacing: Option<Spacing>,
    /// Least gap between the tips of neighbouring planets, in modules. Default 0. A set given in full with a
    /// smaller one is warned of.
    pub tip_gap: Option<Number>,
}

/// How the planets are placed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Spacing {
    /// At equal angles only.
    Equal,
    /// At equal angles, or as near to them as assembles.
    #[serde(alias = "least-unequal")]
    LeastUnequal,
}

impl From<Spacing> for Placement {
    fn from(spacing: Spacing) -> Self {
        match spacing {
            Spacing::Equal => Self::Equal,
            Spacing::LeastUnequal => Self::LeastUnequal,
        }
    }
}

/// Efficiencies of the meshes, above 0 and up to 1.
#[derive(Debug, Clone, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MeshEfficiencyFile {
    /// Mesh of sun and planet. Default 0.97.
    pub sun_planet: Option<Quantity<Ratio>>,
    /// Mesh of planet and ring. Default 0.98.
    pub planet_ring: Option<Quantity<Ratio>>,
    /// Bearings of a planet on its pin. Default 1: nothing lost in them.
    pub planet_bearings: Option<Quantity<Ratio>>,
}

/// Masses and inertias that are known of single parts, weighed or from a drawing; they replace those of the
/// shapes.
#[derive(Debug, Clone, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PartsFile {
    /// The sun.
    pub sun: Option<PartFile>,
    /// One planet.
    pub planet: Option<PartFile>,
    /// The carrier without planets.
    pub carrier: Option<PartFile>,
}

/// Known mass and inertia of a part.
#[derive(Debug, Clone, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PartFile {
    /// Mass of the part. Default: that of the shape.
    pub mass: Option<Quantity<Mass>>,
    /// Inertia of the part about its own axis, of the carrier about the axis of the gearbox. Default: that
    /// of the shape.
    pub inertia: Option<Quantity<MomentOfInertia>>,
}

/// Module, width and material of the gears.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GearSetFile {
    /// Module.
    #[serde(deserialize_with = "crate::module::one")]
    #[schemars(with = "Quantity<Module>")]
    pub module: Quantity<Length>,
    /// Face width.
    pub face_width: Quantity<Length>,
    /// Addendum coefficient. Default 1.
    pub addendum: Option<Number>,
    /// Clearance coefficient. Default 0.25.
    pub clearance: Option<Number>,
    /// Pressure angle. It decides which gears are undercut, and the radial forces. Default 20 deg.
    pub pressure_angle: Option<Quantity<Angle>>,
    /// Density of gears and carrier. Default 7850 kg/m³, steel.
    pub density: Option<Quantity<MassDensity>>,
    /// Bore of the sun: `shaft`, the default, its shaft's diameter; `bearing`, its bearing's outside
    /// diameter; or a diameter.
    pub sun_bore: Option<BoreText>,
    /// Bore of a planet: `bearing`, `shaft`, or a diameter. Default its bearing's outside diameter where that
    /// goes into the planet; else the planet is taken as solid, with a warning.
    pub planet_bore: Option<BoreText>,
}

/// Shafts and bearings.
#[derive(Debug, Clone, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ShaftsFile {
    /// Reduced allowable torsional stress. Default 20 MPa; usual are 15 to 20 MPa.
    pub allowable_stress: Option<Quantity<Pressure>>,
    /// Series of deep-groove ball bearings: 200, 300 (the default) or 400.
    pub bearing_series: Option<BearingSeries>,
    /// The sun's shaft.
    pub sun: Option<ShaftFile>,
    /// The pin of a planet.
    pub planet: Option<ShaftFile>,
    /// The carrier's shaft.
    pub carrier: Option<ShaftFile>,
}

/// Data of a shaft that are already decided; a warning says where they do not satisfy the formula.
#[derive(Debug, Clone, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ShaftFile {
    /// Diameter. Default: the bearing's bore, or else the next standard diameter that satisfies the formula.
    pub diameter: Option<Quantity<Length>>,
    /// Bearing: 310, or 6310. Default: the smallest of the series that goes on the shaft.
    pub bearing: Option<Designation>,
}

/// The carrier: its inertia, or its shape with one arm for each planet around a hub.
#[derive(Debug, Clone, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CarrierFile {
    /// Inertia about the gearbox axis without planets; instead of `arms` and `hub`.
    pub inertia: Option<Quantity<MomentOfInertia>>,
    /// The arms.
    pub arms: Option<ArmsFile>,
    /// The hub.
    pub hub: Option<HubFile>,
}

/// Equal flat arms, one for each planet.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ArmsFile {
    /// Length along the radius, from the hub's outside.
    pub length: Quantity<Length>,
    /// Width.
    pub width: Quantity<Length>,
    /// Thickness along the axis.
    pub thickness: Quantity<Length>,
    /// Hole for the planet's pin. Default: none.
    pub hole: Option<HoleFile>,
}

/// A hole through an arm.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HoleFile {
    /// Radius.
    pub radius: Quantity<Length>,
    /// Distance of its centre from the outer end of the arm.
    pub from_outer_end: Quantity<Length>,
}

/// The ring from which the arms start.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HubFile {
    /// Outside radius.
    pub outside_radius: Quantity<Length>,
    /// Inside radius. Default 0, a solid hub.
    pub inside_radius: Option<Quantity<Length>>,
    /// Width along the axis.
    pub width: Quantity<Length>,
}

/// Inertias attached to the drive.
#[derive(Debug, Clone, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AttachedFile {
    /// On the sun's shaft: rotor of the motor, coupling. Default 0.
    pub motor: Option<Quantity<MomentOfInertia>>,
    /// On the carrier: the driven machine. Default 0.
    pub machine: Option<Quantity<MomentOfInertia>>,
}

/// Torques while the drive starts, taken as constant.
#[derive(Debug, Clone, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StartFile {
    /// Torque on the sun. Default: power over speed.
    pub driving_torque: Option<Quantity<Torque>>,
    /// Torque that the driven machine opposes to the carrier. Default: what the drive delivers at its power.
    pub load: Option<Quantity<Torque>>,
}

/// The file in a document, and what is meant by it.
///
/// ```
/// use epicyclic_formats::{Document, drive};
///
/// let text = b"power: 30 kW\nspeed: 1450 rpm\nratio: 5\ngear_set: { module: 5 mm, face_width: 50 mm }\n";
/// let (file, spec) = drive::read(&Document::parse_one("drive.yaml", text)?)?;
/// assert_eq!((file.title, spec.ratio), (None, 5.0));
///
/// let text = b"power: 30 kW\nspeed: 1450 rpm\nratio: 5\ngear_set: { module: 5, face_width: 50 mm }\n";
/// let error = drive::read(&Document::parse_one("drive.yaml", text)?).unwrap_err();
/// assert!(error.to_string().starts_with("drive.yaml:4:21: gear_set.module: 5: no unit; write 5 mm"));
/// # Ok::<(), epicyclic_formats::Error>(())
/// ```
///
/// # Errors
/// All independent faults with their places.
pub fn read(document: &Document) -> Result<(DriveFile, DriveSpec), Error> {
    document.must_be(FileKind::Drive)?;
    let file: DriveFile = document.read()?;
    let spec = file.spec().map_err(|faults| faults.placed(document, &Path::root()))?;
    Ok((file, spec))
}
