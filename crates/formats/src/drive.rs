//! The file that describes a planetary drive: `epicyclic drive drive.yaml`.
//!
//! ```yaml
//! power: 30 kW
//! speed: 1450 rpm
//! ratio: 5
//! wheels: { module: 5 mm, face_width: 50 mm }
//! ```
//!
//! is enough; every other key has a default, stated at the field. A [`DriveFile`] says what was written,
//! [`DriveFile::spec`] what is meant by it.

use epicyclic_dynamics::drive::{Bore, CarrierSpec, DriveSpec, ShaftSpec, TeethSpec, Wheel, default_bounds};
use epicyclic_gears::bearing::{self, Series};
use epicyclic_gears::carrier::{Arm, Hole, Hub};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::geometry::BasicRack;
use epicyclic_gears::synthesis::{Placement, ToothSet};
use epicyclic_gears::{Error as GearError, ToothCount};
use schemars::JsonSchema;
use serde::Deserialize;
use std::ops::RangeInclusive;
use uom::si::f64::{
    Angle, AngularVelocity, Length, MassDensity, MomentOfInertia, Power, Pressure, Ratio, Torque,
};

use crate::{Document, Error, Number, Path, Physical, Problem, Quantity, Span};

mod fields;
mod place;
#[cfg(test)]
mod tests;

pub use fields::{BearingSeries, BoreText, Designation};
pub use place::place;

/// A planetary drive: driven at the sun, ring at rest, load on the carrier.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DriveFile {
    /// What the drive is for; printed above the answer.
    pub title: Option<String>,
    /// Power at the sun's shaft.
    pub power: Quantity<Power>,
    /// Speed of the sun.
    pub speed: Quantity<AngularVelocity>,
    /// Ratio of the speeds of sun and carrier. It may be left out where `teeth` gives sun, planets, and planet or ring.
    pub ratio: Option<Number>,
    /// How far the ratio may be off. Default 1 %.
    pub ratio_tolerance: Option<Quantity<Ratio>>,
    /// Tooth numbers, or bounds for them. Default: sought.
    pub teeth: Option<TeethFile>,
    /// Efficiencies of the meshes.
    pub mesh_efficiency: Option<MeshEfficiencyFile>,
    /// Module, width and material of the wheels.
    pub wheels: WheelsFile,
    /// Shafts and bearings. Default: sized by reduced torsional stress.
    pub shafts: Option<ShaftsFile>,
    /// The carrier. Default: taken as massless, with a warning.
    pub carrier: Option<CarrierFile>,
    /// Inertias attached to the drive.
    pub attached: Option<AttachedFile>,
    /// Torques while the drive starts.
    pub start: Option<StartFile>,
}

/// Tooth numbers or bounds for them: one number, or a range with both ends included.
///
/// Where sun, planets, and planet or ring are single numbers the set is taken as given, even if it does not fit.
/// Otherwise the set nearest to the ratio is taken; of equally near ones that with most planets, then the
/// smallest.
#[derive(Debug, Clone, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TeethFile {
    /// Teeth of the sun. Default 17..200, without undercut.
    pub sun: Option<Span<u32>>,
    /// Teeth of a planet. Default 17..200, without undercut.
    pub planet: Option<Span<u32>>,
    /// Teeth of the ring. Default 12..200.
    pub ring: Option<Span<u32>>,
    /// Number of planets. Default 3..8, as many as fit.
    pub planets: Option<Span<u32>>,
    /// `equal`, the default, or `least-unequal`: where equal angles do not assemble, as near to them as do.
    pub spacing: Option<Spacing>,
    /// Least gap between the tips of neighbouring planets, in modules. Default 0.
    pub tip_gap: Option<Number>,
}

/// How the planets may be placed.
#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Spacing {
    /// At equal angles only.
    Equal,
    /// At equal angles, or as near to them as assembles.
    LeastUnequal,
}

/// Efficiencies of the meshes, above 0 and up to 1.
#[derive(Debug, Clone, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MeshEfficiencyFile {
    /// Of sun and planet. Default 0.97.
    pub sun_planet: Option<Quantity<Ratio>>,
    /// Of planet and ring. Default 0.98.
    pub planet_ring: Option<Quantity<Ratio>>,
}

/// Module, width and material of the wheels.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WheelsFile {
    /// Module.
    pub module: Quantity<Length>,
    /// Face width.
    pub face_width: Quantity<Length>,
    /// Addendum coefficient. Default 1.
    pub addendum: Option<Number>,
    /// Clearance coefficient. Default 0.25.
    pub clearance: Option<Number>,
    /// Pressure angle. Default 20 deg.
    pub pressure_angle: Option<Quantity<Angle>>,
    /// Density of wheels and carrier. Default 7850 kg/m³, steel.
    pub density: Option<Quantity<MassDensity>>,
    /// Bore of the sun: `shaft`, the default, its shaft's diameter; `bearing`, its bearing's outside diameter; or a
    /// diameter.
    pub sun_bore: Option<BoreText>,
    /// Bore of a planet: `bearing`, the default, `shaft`, or a diameter.
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

/// What is already decided of a shaft; a warning says where it does not satisfy the formula.
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

/// A value that is well written but means nothing, and the path to it.
#[derive(Debug, Clone, PartialEq)]
pub struct Misfit {
    /// Where it is.
    pub path: Path,
    /// What is wrong with it.
    pub problem: Problem,
}

impl Misfit {
    fn new(path: &str, reason: impl std::fmt::Display) -> Self {
        Self { path: place::path(path), problem: Problem::Refused { message: format!("{reason}") } }
    }
}

/// The file in a document, and what is meant by it.
///
/// ```
/// use epicyclic_formats::{Document, drive};
///
/// let text = b"power: 30 kW\nspeed: 1450 rpm\nratio: 5\nwheels: { module: 5 mm, face_width: 50 mm }\n";
/// let (file, spec) = drive::read(&Document::parse_one("drive.yaml", text)?)?;
/// assert_eq!((file.title, spec.ratio), (None, 5.0));
///
/// let text = b"power: 30 kW\nspeed: 1450 rpm\nratio: 5\nwheels: { module: 5, face_width: 50 mm }\n";
/// let error = drive::read(&Document::parse_one("drive.yaml", text)?).unwrap_err();
/// assert!(error.to_string().starts_with("drive.yaml:4:19: wheels.module: 5: no unit; write 5 mm"));
/// # Ok::<(), epicyclic_formats::Error>(())
/// ```
///
/// # Errors
/// The first thing wrong, with its place.
pub fn read(document: &Document) -> Result<(DriveFile, DriveSpec), Error> {
    let file: DriveFile = document.read()?;
    let spec = file.spec().map_err(|misfit| document.error(&misfit.path, misfit.problem))?;
    Ok((file, spec))
}

impl DriveFile {
    /// What is meant, defaults filled in.
    ///
    /// # Errors
    /// A [`Misfit`] for a tooth count of 0, an open range that its default turns around, an efficiency
    /// outside 0…1, an unknown bearing, a carrier with both inertia and shape or with half a shape, and a
    /// missing ratio.
    pub fn spec(&self) -> Result<DriveSpec, Misfit> {
        let wheels = &self.wheels;
        let rack = BasicRack::default();
        let rack = BasicRack {
            addendum: wheels.addendum.map_or(rack.addendum, Number::get),
            clearance: wheels.clearance.map_or(rack.clearance, Number::get),
            pressure_angle: or(wheels.pressure_angle, rack.pressure_angle),
        };
        let (teeth, own_ratio) = teeth(&self.teeth.clone().unwrap_or_default(), rack.addendum)?;
        let ratio = self.ratio.map(Number::get).or(own_ratio).ok_or_else(|| Misfit {
            path: Path::root(),
            problem: Problem::MissingKey { key: "ratio".to_owned() },
        })?;

        let mut spec =
            DriveSpec::new(self.power.0, self.speed.0, ratio, wheels.module.0, wheels.face_width.0);
        spec.ratio_tolerance = self.ratio_tolerance.map_or(spec.ratio_tolerance, |given| given.0.si());
        spec.teeth = teeth;
        if let Some(mesh) = &self.mesh_efficiency {
            let eta = |given: Option<Quantity<Ratio>>, usual, path| {
                given.map_or(Ok(usual), |given| {
                    MeshEfficiency::new(given.0.si()).map_err(|error| Misfit::new(path, error))
                })
            };
            spec.sun_planet_efficiency =
                eta(mesh.sun_planet, spec.sun_planet_efficiency, "mesh_efficiency.sun_planet")?;
            spec.planet_ring_efficiency =
                eta(mesh.planet_ring, spec.planet_ring_efficiency, "mesh_efficiency.planet_ring")?;
        }
        spec.wheels.rack = rack;
        spec.wheels.density = or(wheels.density, spec.wheels.density);
        spec.wheels.sun_bore = bore(wheels.sun_bore, spec.wheels.sun_bore, "wheels.sun_bore")?;
        spec.wheels.planet_bore = bore(wheels.planet_bore, spec.wheels.planet_bore, "wheels.planet_bore")?;
        if let Some(shafts) = &self.shafts {
            spec.shafts.allowable_stress = or(shafts.allowable_stress, spec.shafts.allowable_stress);
            spec.shafts.bearing_series = shafts.bearing_series.map_or(Series::Medium300, |given| given.0);
            spec.shafts.sun = shaft(shafts.sun.as_ref(), "shafts.sun")?;
            spec.shafts.planet = shaft(shafts.planet.as_ref(), "shafts.planet")?;
            spec.shafts.carrier = shaft(shafts.carrier.as_ref(), "shafts.carrier")?;
        }
        if let Some(given) = &self.carrier {
            spec.carrier = carrier(given)?;
        }
        if let Some(attached) = &self.attached {
            spec.motor_inertia = or(attached.motor, spec.motor_inertia);
            spec.machine_inertia = or(attached.machine, spec.machine_inertia);
        }
        if let Some(start) = &self.start {
            spec.driving_torque = start.driving_torque.map(|given| given.0);
            spec.load = start.load.map(|given| given.0);
        }
        Ok(spec)
    }
}

fn or<T>(given: Option<Quantity<T>>, usual: T) -> T {
    given.map_or(usual, |given| given.0)
}

/// The teeth, and the ratio of a set given in full.
fn teeth(file: &TeethFile, addendum: f64) -> Result<(TeethSpec, Option<f64>), Misfit> {
    let single = |span: Option<Span<u32>>| span.and_then(|span| span.single());
    let count = |value, path| ToothCount::new(value).map_err(|error| Misfit::new(path, error));
    let (sun, planet, ring) = (single(file.sun), single(file.planet), single(file.ring));
    if let (Some(sun), Some(planets)) = (sun, single(file.planets))
        && (planet.is_some() || ring.is_some())
        && (file.planet.is_none() || planet.is_some())
        && (file.ring.is_none() || ring.is_some())
    {
        let sun = count(sun, "teeth.sun")?;
        let (planet, ring) = match (planet, ring) {
            (Some(planet), Some(ring)) => (planet, ring),
            (Some(planet), None) => (planet, planet.saturating_mul(2).saturating_add(sun.get())),
            (_, ring) => {
                let ring = ring.unwrap_or(0);
                let twice = ring.checked_sub(sun.get()).filter(|twice| *twice > 0 && twice % 2 == 0);
                let odd = || {
                    Misfit::new(
                        "teeth.ring",
                        format!(
                            "a ring of {ring} and a sun of {sun} teeth leave no whole number of teeth to the \
                             planet; their difference must be even and above 0"
                        ),
                    )
                };
                (twice.ok_or_else(odd)? / 2, ring)
            }
        };
        let (planet, ring) = (count(planet, "teeth.planet")?, count(ring, "teeth.ring")?);
        let ratio = 1.0 + ring.as_f64() / sun.as_f64();
        return Ok((TeethSpec::Given(ToothSet { sun, planet, ring, planets }), Some(ratio)));
    }
    let mut bounds = default_bounds(addendum);
    let range = |span: Option<Span<u32>>, usual: &RangeInclusive<u32>, path| {
        let range = span.map_or(Ok(usual.clone()), |span| span.within(usual.clone()));
        let range = range.map_err(|error| Misfit::new(path, error))?;
        if *range.start() == 0 { Err(Misfit::new(path, GearError::NoTeeth)) } else { Ok(range) }
    };
    bounds.sun = range(file.sun, &bounds.sun, "teeth.sun")?;
    bounds.planet = range(file.planet, &bounds.planet, "teeth.planet")?;
    bounds.ring = range(file.ring, &bounds.ring, "teeth.ring")?;
    if let Some(planets) = file.planets {
        let range = planets.within(bounds.planets.clone());
        bounds.planets = range.map_err(|error| Misfit::new("teeth.planets", error))?;
    }
    bounds.tip_gap = file.tip_gap.map_or(bounds.tip_gap, Number::get);
    bounds.placement = match file.spacing {
        None | Some(Spacing::Equal) => Placement::Equal,
        Some(Spacing::LeastUnequal) => Placement::LeastUnequal,
    };
    Ok((TeethSpec::Within(bounds), None))
}

fn bore(given: Option<BoreText>, usual: Bore, path: &str) -> Result<Bore, Misfit> {
    match given.map(|given| given.0) {
        Some(Bore::Given(diameter)) if diameter.si() < 0.0 => {
            Err(Misfit::new(path, "a bore below 0; write 0 mm for a solid wheel"))
        }
        given => Ok(given.unwrap_or(usual)),
    }
}

fn shaft(given: Option<&ShaftFile>, path: &str) -> Result<ShaftSpec, Misfit> {
    let Some(given) = given else { return Ok(ShaftSpec::default()) };
    if given.diameter.is_some_and(|diameter| diameter.0.si() <= 0.0) {
        return Err(Misfit::new(&format!("{path}.diameter"), "a shaft's diameter must be above 0"));
    }
    let bearing = given.bearing.as_ref().map(|designation| {
        bearing::by_designation(&designation.0)
            .map_err(|error| Misfit::new(&format!("{path}.bearing"), error))
    });
    Ok(ShaftSpec { diameter: given.diameter.map(|given| given.0), bearing: bearing.transpose()? })
}

fn carrier(given: &CarrierFile) -> Result<CarrierSpec, Misfit> {
    match (&given.inertia, &given.arms, &given.hub) {
        (Some(inertia), None, None) => Ok(CarrierSpec::Inertia(inertia.0)),
        (None, Some(arms), Some(hub)) => Ok(CarrierSpec::Shape {
            arm: Arm {
                length: arms.length.0,
                width: arms.width.0,
                thickness: arms.thickness.0,
                hole: arms
                    .hole
                    .as_ref()
                    .map(|hole| Hole { radius: hole.radius.0, from_outer_end: hole.from_outer_end.0 }),
            },
            hub: Hub {
                outer_radius: hub.outside_radius.0,
                inner_radius: or(hub.inside_radius, Length::default()),
                width: hub.width.0,
            },
        }),
        (Some(_), _, _) => {
            Err(Misfit::new("carrier.inertia", "a carrier has its inertia given, or arms and hub, not both"))
        }
        (None, _, _) => Err(Misfit::new("carrier", "give the carrier both arms and hub, or its inertia")),
    }
}
