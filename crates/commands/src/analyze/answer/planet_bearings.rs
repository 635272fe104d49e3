//! Forces on the planet bearings, in one gear or in all.

use super::Worked;
use super::records::planet_name;
use crate::error::Error;
use crate::shared::gearbox::Subject;
use crate::tolerance::rounded;
use epicyclic_strength::planets::{AxialForces, axial_forces};
use epicyclic_train::planet_bearings as train;
use epicyclic_train::{Direction, LoadCase, PlanetSet};
use epicyclic_units::Physical;
use schemars::JsonSchema;
use serde::Serialize;
use uom::si::f64::Torque;

/// The bearing of each of the planets of one kind, in a gear.
///
/// Tangential forces are along the orbit, positive against the carrier; radial ones are those of the meshes,
/// positive outwards. All planets carry alike.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct PlanetBearing {
    /// The set.
    pub set: String,
    /// The gear.
    pub gear: String,
    /// The planet: its name, or its number in the set.
    pub planet: String,
    /// How many there are.
    pub planets: Option<u32>,
    /// Radius of their centres.
    pub carrier_radius_m: Option<f64>,
    /// Mass of one.
    pub planet_mass_kg: Option<f64>,
    /// Size of the torque of the set's carrier over the input's; none of a set of planets that differ, which
    /// share it.
    pub carrier_torque_of_input: Option<f64>,
    /// The part of it for each planet; none of a set of planets that differ.
    pub carrier_torque_each_of_input: Option<f64>,
    /// Tangential force in N at 1 N·m on the input.
    pub tangential_force_n_per_input_n_m: Option<f64>,
    /// Radial force in N at 1 N·m on the input.
    pub radial_force_n_per_input_n_m: Option<f64>,
    /// Tangential force at the load.
    pub tangential_force_n: Option<f64>,
    /// Radial force of the meshes at the load.
    pub radial_force_n: Option<f64>,
    /// Centrifugal force at the speed.
    pub centrifugal_force_n: Option<f64>,
    /// All of them together.
    pub force_n: Option<f64>,
    /// Axial forces of the meshes with sun and ring on the planet at the load, against each other; none of
    /// spur teeth.
    pub axial_forces_n: Option<[f64; 2]>,
    /// Moment by which they tilt the planet; it is no part of the force together.
    pub tilting_moment_n_m: Option<f64>,
    /// Basic dynamic load rating of a planet's bearings.
    pub bearing_load_rating_n: Option<f64>,
    /// Speed of the planet relative to its carrier.
    pub bearing_speed_rad_s: Option<f64>,
    /// Basic rating life, which 90 % of the bearings reach; none where a planet does not turn.
    pub bearing_life_s: Option<f64>,
    /// What is missing for forces, or why none follow.
    pub missing: Vec<Lack>,
}

/// What is missing for a force on a planet bearing.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Lack {
    /// What it is.
    pub lack: LackName,
    /// The other planet concerned: its name, or its number in the set.
    pub other_planet: Option<String>,
    /// Where two planets cannot stand in mesh: radius of this planet's centre and of the other's.
    pub radii_m: Option<[f64; 2]>,
    /// Where two planets cannot stand in mesh: distance of their centres by module and teeth.
    pub distance_m: Option<f64>,
}

/// Kinds of what is missing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum LackName {
    /// The number of planets.
    Planets,
    /// The radius of their centres, or the module with the teeth.
    Radius,
    /// One radius is given for planets that differ, and not taken.
    CommonRadius,
    /// The teeth, and with them the radial force of the meshes.
    Teeth,
    /// The radius of the centre of another planet in mesh.
    OtherRadius,
    /// Module or teeth of the mesh with another planet.
    Distance,
    /// Two planets in mesh cannot stand at their radii.
    Triangle,
    /// The mass of a planet, or its face width, for the centrifugal force.
    Mass,
    /// Forces on bevel planets are not computed.
    Bevel,
    /// The set is written in a list of transmissions, which has no sizes of such sets.
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

/// The planet bearings of one gear, where a force or a torque of theirs follows.
pub(super) fn of_gear(subject: &Subject<'_>, worked: &Worked<'_>) -> Result<Vec<PlanetBearing>, Error> {
    if has_sizes(subject) || worked.analysis.ideal().is_some() {
        bearings(subject, worked)
    } else {
        Ok(vec![])
    }
}

/// The planet bearings of all gears, where the size of any set is known.
pub(super) fn of_gears(subject: &Subject<'_>, worked: &[Worked<'_>]) -> Result<Vec<PlanetBearing>, Error> {
    let mut all = vec![];
    if has_sizes(subject) {
        for worked in worked {
            all.extend(bearings(subject, worked)?);
        }
    }
    Ok(all)
}

fn has_sizes(subject: &Subject<'_>) -> bool {
    subject.planet_bearings.iter().any(|bearing| bearing.radius.is_some())
}

fn bearings(subject: &Subject<'_>, worked: &Worked<'_>) -> Result<Vec<PlanetBearing>, Error> {
    subject.planet_bearings.iter().map(|bearing| one(subject, worked, bearing)).collect()
}

fn one(
    subject: &Subject<'_>,
    worked: &Worked<'_>,
    bearing: &train::PlanetBearing,
) -> Result<PlanetBearing, Error> {
    let Worked { analysis, input, operation, .. } = worked;
    let set = &subject.gearbox.sets()[bearing.set];
    let is_back_driven = operation.as_ref().is_some_and(|at| at.direction == Direction::BackDrive);
    let case = if is_back_driven { analysis.back_driving() } else { analysis.driving() };
    let of_carrier = |case: &LoadCase| {
        let torques = case.members[bearing.set].as_ref()?;
        Some(torques.last()?.abs() / case.input.abs())
    };
    // Planets that differ share it as their places and meshes make them: their forces say how.
    let carrier_torque = case.and_then(of_carrier).filter(|_| bearing.is_only());
    let per_unit = case.map(|case| bearing.of_unit_input(case)).transpose()?.unwrap_or_default();
    let carrier = analysis.speed(set.carrier());
    let speed = input.speed.zip(carrier).map(|(speed, of)| speed * of);
    let at = operation.as_ref().and_then(|operation| operation.members[bearing.set].as_deref());
    let forces = bearing.forces(at, speed)?;
    let planet = analysis.sets()[bearing.set].planets[bearing.planet];
    // A set that turns as a block leaves the rounding of a difference.
    let turning = input.speed.zip(planet).map(|(speed, planet)| speed * rounded(planet.relative));
    let life = match forces.total.zip(turning) {
        Some((force, turning)) => bearing.life(force, turning)?,
        None => None,
    };
    let axial = at.and_then(|torques| axial(subject, set, bearing, torques));
    // A list of transmissions states sizes of compound sets alone.
    let is_in_list = !subject.published.is_empty() && set.short().is_some();
    let missing = if is_in_list {
        vec![Lack::named(LackName::NoSizesInList)]
    } else {
        bearing.lacks.iter().map(|lack| Lack::of(set, lack)).collect()
    };
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
        bearing_load_rating_n: bearing.load_rating.map(|(rating, _)| rating.si()),
        bearing_speed_rad_s: si(turning),
        bearing_life_s: si(life),
        missing,
    })
}

/// Axial forces of the meshes of a helical set on one planet, and their moment, of the torques on sun and
/// ring.
fn axial(
    subject: &Subject<'_>,
    set: &PlanetSet,
    bearing: &train::PlanetBearing,
    torques: &[Torque],
) -> Option<AxialForces> {
    let spec = set.short().filter(|spec| spec.is_helical())?;
    let toothed = spec.involute_set(&subject.rack)?.ok()?;
    let (sun, ring) = (torques.first()?.abs(), torques.get(1)?.abs());
    let planets = f64::from(bearing.planets?);
    // Where a carrier radius is given beside the module, the teeth stand on it.
    let module = bearing.radius? / toothed.centre_distance();
    let [of_sun, _, of_ring] = toothed.gears();
    let tangential = [(sun, of_sun), (ring, of_ring)]
        .map(|(torque, gear)| 2.0 * torque / (planets * module * gear.reference_diameter()));
    Some(axial_forces([toothed.sun_mesh(), toothed.ring_mesh()], module, tangential.map(Into::into)))
}

fn si<T: Physical>(value: Option<T>) -> Option<f64> {
    value.map(Physical::si)
}
