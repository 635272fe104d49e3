//! Forces on the planet bearings, in one gear or in all.

use super::Worked;
use super::records::planet_name;
use crate::error::Error;
use crate::shared::gearbox::Gearbox;
use crate::tolerance::rounded;
use epicyclic_strength::planets::{AxialForces, axial_forces};
use epicyclic_train::planet_bearings as train;
use epicyclic_train::{Direction, LoadCase, PlanetSet};
use epicyclic_units::Physical;
use schemars::JsonSchema;
use serde::Serialize;
use uom::si::f64::Torque;

/// Bearing of one of the equally loaded planets of a kind, in a gear.
///
/// Tangential forces act along the orbit, positive in the direction in which all planets of the set together
/// push the carrier. Radial forces are those of the meshes, positive outwards.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct PlanetBearing {
    /// Name of the set.
    pub set: String,
    /// Name of the gear.
    pub gear: String,
    /// Name of the planet, or its number in the set.
    pub planet: String,
    /// Number of planets of this kind; null if unknown.
    pub planets: Option<u32>,
    /// Radius of the planet centres in m; null if unknown.
    pub carrier_radius_m: Option<f64>,
    /// Mass of one planet in kg; null if unknown.
    pub planet_mass_kg: Option<f64>,
    /// Absolute value of the carrier torque relative to the input torque; null if planets that differ share
    /// it.
    pub carrier_torque_of_input: Option<f64>,
    /// Carrier torque per planet relative to the input torque; null if planets that differ share it.
    pub carrier_torque_each_of_input: Option<f64>,
    /// Tangential force in N at an input torque of 1 N·m; null if it cannot be computed.
    pub tangential_force_n_per_input_n_m: Option<f64>,
    /// Radial force of the meshes in N at an input torque of 1 N·m; null if it cannot be computed.
    pub radial_force_n_per_input_n_m: Option<f64>,
    /// Tangential force at the given load, in N; null without a load or if it cannot be computed.
    pub tangential_force_n: Option<f64>,
    /// Radial force of the meshes at the given load, in N; null without a load or if it cannot be computed.
    pub radial_force_n: Option<f64>,
    /// Centrifugal force at the given speed, in N; null without a speed or mass.
    pub centrifugal_force_n: Option<f64>,
    /// Resultant of tangential, radial and centrifugal force, in N; null if one of them is unknown.
    pub force_n: Option<f64>,
    /// Axial forces in N on the planet in its meshes with sun and ring, opposite to each other; null for spur
    /// teeth.
    pub axial_forces_n: Option<[f64; 2]>,
    /// Moment of the axial forces that tilts the planet, in N·m; not contained in the resultant force. Null
    /// for spur teeth.
    pub tilting_moment_n_m: Option<f64>,
    /// Basic dynamic load rating of the bearings of one planet, in N; null if not given, and of plain bearings.
    pub bearing_load_rating_n: Option<f64>,
    /// Planet speed relative to its carrier in rad/s; null if unknown.
    pub bearing_speed_rad_s: Option<f64>,
    /// Basic rating life in s, which 90 % of the bearings reach; null if unknown or the planet does not turn.
    pub bearing_life_s: Option<f64>,
    /// Data that are missing for the forces, or reasons why they cannot be computed.
    pub missing: Vec<Lack>,
}

/// Missing data for a force on a planet bearing.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Lack {
    /// Kind of the missing data.
    pub lack: LackName,
    /// Name of the other planet concerned, or its number in the set; otherwise null.
    pub other_planet: Option<String>,
    /// Radii in m of the centres of this planet and the other, if the two cannot mesh; otherwise null.
    pub radii_m: Option<[f64; 2]>,
    /// Centre distance in m of the two planets by module and tooth numbers, if they cannot mesh; otherwise
    /// null.
    pub distance_m: Option<f64>,
}

/// Kinds of missing data.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum LackName {
    /// The number of planets.
    Planets,
    /// The radius of the planet centres, or module and tooth numbers.
    Radius,
    /// One radius is given for planets that differ; it is not used.
    CommonRadius,
    /// The tooth numbers, needed for the radial force of the meshes.
    Teeth,
    /// The radius of the centre of another meshing planet.
    OtherRadius,
    /// Module or tooth numbers of the mesh with another planet.
    Distance,
    /// Two meshing planets whose centre distance does not fit their radii.
    Triangle,
    /// The mass of a planet, or its face width, needed for the centrifugal force.
    Mass,
    /// Forces on bevel planets, which are not computed.
    Bevel,
    /// The set belongs to a list of transmissions, which has no sizes for this kind of set.
    NoSizesInList,
}

impl Lack {
    fn named(lack: LackName) -> Self {
        Self { lack, other_planet: None, radii_m: None, distance_m: None }
    }

    fn of(set: &PlanetSet, lack: &train::Lack) -> Self {
        let with =
            |lack, other: &usize| Self { other_planet: Some(planet_name(set, *other)), ..Self::named(lack) };
        match lack {
            train::Lack::Planets => Self::named(LackName::Planets),
            train::Lack::Radius => Self::named(LackName::Radius),
            train::Lack::CommonRadius => Self::named(LackName::CommonRadius),
            train::Lack::Teeth => Self::named(LackName::Teeth),
            train::Lack::OtherRadius { other } => with(LackName::OtherRadius, other),
            train::Lack::Distance { other } => with(LackName::Distance, other),
            train::Lack::Triangle { other, radii, distance } => Self {
                radii_m: Some(radii.map(Physical::si)),
                distance_m: Some(distance.si()),
                ..with(LackName::Triangle, other)
            },
            train::Lack::Mass => Self::named(LackName::Mass),
            train::Lack::Bevel => Self::named(LackName::Bevel),
        }
    }
}

/// Forces on the planet bearings in one gear; empty if neither a size nor a torque is known.
pub(super) fn of_gear(subject: &Gearbox, worked: &Worked<'_>) -> Result<Vec<PlanetBearing>, Error> {
    if has_sizes(subject) || worked.analysis.ideal().is_some() {
        bearings(subject, worked)
    } else {
        Ok(vec![])
    }
}

/// Forces on the planet bearings in all gears; empty unless the size of a set is known.
pub(super) fn of_gears(subject: &Gearbox, worked: &[Worked<'_>]) -> Result<Vec<PlanetBearing>, Error> {
    let mut all = vec![];
    if has_sizes(subject) {
        for worked in worked {
            all.extend(bearings(subject, worked)?);
        }
    }
    Ok(all)
}

fn has_sizes(subject: &Gearbox) -> bool {
    subject.planet_bearings.iter().any(|bearing| bearing.radius.is_some())
}

fn bearings(subject: &Gearbox, worked: &Worked<'_>) -> Result<Vec<PlanetBearing>, Error> {
    subject.planet_bearings.iter().map(|bearing| one(subject, worked, bearing)).collect()
}

fn one(
    subject: &Gearbox,
    worked: &Worked<'_>,
    bearing: &train::PlanetBearing,
) -> Result<PlanetBearing, Error> {
    let Worked { analysis, input, operation, .. } = worked;
    let set = &subject.train.sets()[bearing.set];
    let is_back_driven = operation.as_ref().is_some_and(|at| at.direction == Direction::BackDrive);
    let case = if is_back_driven { analysis.back_driving() } else { analysis.driving() };
    let of_carrier = |case: &LoadCase| {
        let torques = case.members[bearing.set].as_ref()?;
        Some(torques.last()?.abs() / case.input.abs())
    };
    // Planets that differ share the torque according to their places and meshes; only their forces show how.
    let carrier_torque = case.and_then(of_carrier).filter(|_| bearing.is_only());
    let per_unit = case.map(|case| bearing.of_unit_input(case)).transpose()?.unwrap_or_default();
    let carrier = analysis.speed(set.carrier());
    let speed = input.speed.zip(carrier).map(|(speed, of)| speed * of);
    let at = operation.as_ref().and_then(|operation| operation.members[bearing.set].as_deref());
    let forces = bearing.forces(at, speed)?;
    let planet = analysis.sets()[bearing.set].planets[bearing.planet];
    // In a set that turns as a block, the difference of two equal speeds leaves a rounding error.
    let turning = input.speed.zip(planet).map(|(speed, planet)| speed * rounded(planet.relative));
    let life = match forces.total.zip(turning) {
        Some((force, turning)) => bearing.life(force, turning)?,
        None => None,
    };
    let axial = at.and_then(|torques| axial(subject, set, bearing, torques));
    // A list of transmissions gives sizes only for compound sets.
    let is_in_list = !subject.published.is_empty() && set.short().is_some();
    let missing = if is_in_list {
        vec![Lack::named(LackName::NoSizesInList)]
    } else {
        bearing.lacks.iter().map(|lack| Lack::of(set, lack)).collect()
    };
    // A plain bearing has no rating life.
    let rolling = bearing.load_rating.filter(|(_, rolling)| rolling.exponent().is_some());
    Ok(PlanetBearing {
        set: set.id().to_owned(),
        gear: analysis.gear().name().to_owned(),
        planet: planet_name(set, bearing.planet),
        planets: bearing.planets,
        carrier_radius_m: si(bearing.radius),
        planet_mass_kg: si(bearing.mass),
        carrier_torque_of_input: carrier_torque,
        carrier_torque_each_of_input: carrier_torque
            .zip(bearing.planets)
            .map(|(torque, count)| torque / f64::from(count)),
        tangential_force_n_per_input_n_m: si(per_unit.tangential),
        radial_force_n_per_input_n_m: si(per_unit.radial),
        tangential_force_n: si(forces.tangential),
        radial_force_n: si(forces.radial),
        centrifugal_force_n: si(forces.centrifugal),
        force_n: si(forces.total),
        axial_forces_n: axial.map(|axial| axial.forces.map(Physical::si)),
        tilting_moment_n_m: axial.map(|axial| axial.tilting_moment.si()),
        bearing_load_rating_n: rolling.map(|(rating, _)| rating.si()),
        bearing_speed_rad_s: si(turning),
        bearing_life_s: si(life),
        missing,
    })
}

/// Axial forces and tilting moment on one planet of a helical set, from the torques on sun and ring.
fn axial(
    subject: &Gearbox,
    set: &PlanetSet,
    bearing: &train::PlanetBearing,
    torques: &[Torque],
) -> Option<AxialForces> {
    let spec = set.short().filter(|spec| spec.is_helical())?;
    let toothed = spec.involute_set(&subject.rack)?.ok()?;
    let (sun, ring) = (torques.first()?.abs(), torques.get(1)?.abs());
    let planets = f64::from(bearing.planets?);
    // A carrier radius that is given beside the module sets the actual centre distance.
    let module = bearing.radius? / toothed.centre_distance();
    let [of_sun, _, of_ring] = toothed.gears();
    let tangential = [(sun, of_sun), (ring, of_ring)]
        .map(|(torque, gear)| 2.0 * torque / (planets * module * gear.reference_diameter()));
    Some(axial_forces([toothed.sun_mesh(), toothed.ring_mesh()], module, tangential.map(Into::into)))
}

fn si<T: Physical>(value: Option<T>) -> Option<f64> {
    value.map(Physical::si)
}
