//! Front view of the sets of a gearbox, with the speeds of their parts in a gear, for an animated picture.
//!
//! Lengths are in a unit of each set: its module if the tooth numbers are known, otherwise the pitch radius
//! of its sun. In the initial position the first central gear has a tooth along the first axis. A planet
//! turns about its own axis with its speed, and with the carrier about the main axis.
//!
//! If the tooth numbers are known, outlines are those that the tools of the gears leave, placed by
//! [`PlanetSet::in_mesh`]; otherwise pitch circles are shown. The number of planets is that of the file,
//! otherwise at most 3.

mod circles;
mod gears;

use crate::answer::Answer;
use crate::error::Error;
use crate::shared::gearbox::Gearbox;
use crate::shared::number::plain;
use crate::shared::toothed::{SHOWN, WithoutTeeth, in_mesh};
use epicyclic_train::compound::CentralKind;
use epicyclic_train::in_mesh::Unplaced;
use epicyclic_train::toothed::Untoothed;
use epicyclic_train::{Analysis, PlanetSet};
use schemars::JsonSchema;
use serde::Serialize;

/// Front view of a gearbox.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Front {
    /// Name of the gearbox.
    pub gearbox: String,
    /// Gear whose speeds are given; null if none is chosen.
    pub gear: Option<String>,
    /// Sets that are shown.
    pub sets: Vec<FrontSet>,
    /// Sets that are not shown: bevel gears, and sets without teeth whose `k` does not give all pitch
    /// circles.
    pub left_out: Vec<String>,
    /// Sets with known tooth numbers whose teeth are not shown: no tool can cut them, or they do not mesh.
    pub uncut: Vec<WithoutTeeth>,
}

impl Answer for Front {
    const NAME: &'static str = "front";
}

/// Front view of a set.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct FrontSet {
    /// Name of the set.
    pub set: String,
    /// Whether the tooth numbers are known; otherwise pitch circles are shown.
    pub has_teeth: bool,
    /// Whether the file gives the number of planets; true for a pair, which has none.
    pub planets_are_given: bool,
    /// Radius of a circle around the whole set, in units of the set.
    pub reach: f64,
    /// Gears of the set: central gears, then those of its planets.
    pub gears: Vec<FrontGear>,
    /// Planets at their places about the axis.
    pub planets: Vec<FrontPlanet>,
    /// Speed of the carrier relative to the input speed; null if unknown.
    pub carrier_of_input: Option<f64>,
}

/// Kinds of gears.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Part {
    /// Central gear with external teeth.
    Sun,
    /// Central gear with internal teeth.
    Ring,
    /// Gear of a planet.
    Planet,
}

/// Gear of a set in front view.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct FrontGear {
    /// Name of the gear within the set.
    pub name: String,
    /// Kind of the gear.
    pub part: Part,
    /// Tooth number; null if unknown.
    pub teeth: Option<u32>,
    /// Working pitch radius in units of the set; for a gear with several meshes that of the first.
    pub pitch_radius: f64,
    /// Outer radius of a ring in units of the set; for other gears approximately the tip radius.
    pub rim_radius: f64,
    /// Centre of a central gear in units of the set: the origin, except for a pair on fixed axes. For planets
    /// the centre is given with each planet.
    pub centre: [f64; 2],
    /// Angle by which the outline of a central gear is turned, in rad; for planets the angle is given with
    /// each planet.
    pub turn_rad: f64,
    /// Closed outline about the gear's own axis, in units of the set; empty without teeth.
    pub outline: Vec<[f64; 2]>,
    /// Speed of the gear relative to the input speed; null if unknown.
    pub speed_of_input: Option<f64>,
}

/// Planet at its place.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct FrontPlanet {
    /// Distance of the planet centre from the axis, in units of the set.
    pub centre_distance: f64,
    /// Angle of the planet centre about the axis, in rad.
    pub angle_rad: f64,
    /// Gears of the planet.
    pub gears: Vec<PlanetGear>,
}

/// Gear of a planet at its place.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct PlanetGear {
    /// Index of the gear in the list of the set.
    pub gear: usize,
    /// Angle by which the outline of the gear is turned, in rad.
    pub turn_rad: f64,
}

/// Computes the front view of the sets of a gearbox, in a gear or at rest.
///
/// A simple set whose teeth no tool can cut is shown by its pitch circles.
///
/// # Errors
/// [`Error::NoGear`].
pub fn answer(subject: &Gearbox, gear: Option<&str>) -> Result<Front, Error> {
    let gearbox = &subject.train;
    let analysis = gear.map(|gear| crate::analyze::answer::analysis(gearbox, gear)).transpose()?;
    let (mut sets, mut left_out, mut uncut) = (vec![], vec![], vec![]);
    for (place, set) in gearbox.sets().iter().enumerate() {
        let with_teeth = in_mesh(subject, set).and_then(|in_mesh| Ok(gears::of(set, &in_mesh)?));
        if let Err(why) = &with_teeth
            && !lacks_teeth(why)
        {
            uncut.push(WithoutTeeth::new(set, why));
        }
        let with_teeth = with_teeth.ok();
        let shape = match with_teeth {
            Some(shape) => Some((shape, true)),
            None => circles::of(set).map(|shape| (shape, false)),
        };
        match shape {
            Some((shape, has_teeth)) => sets.push(moving(set, shape, has_teeth, place, analysis.as_ref())),
            None => left_out.push(set.id().to_owned()),
        }
    }
    Ok(Front {
        gearbox: gearbox.name().to_owned(),
        gear: analysis.map(|analysis| analysis.gear().name().to_owned()),
        sets,
        left_out,
        uncut,
    })
}

/// Whether teeth are not known at all.
fn lacks_teeth(why: &Unplaced) -> bool {
    use Untoothed::{Bevel, PlanetTeeth, Teeth};
    matches!(why, Unplaced::Untoothed(Teeth | PlanetTeeth | Bevel))
}

/// Set at rest.
struct Shape {
    /// Gears, each with its speed ratio to the first central gear relative to the carrier,
    /// `(ω − ω_H)/(ω_1 − ω_H)`.
    gears: Vec<(FrontGear, f64)>,
    planets: Vec<FrontPlanet>,
}

fn moving(
    set: &PlanetSet,
    shape: Shape,
    has_teeth: bool,
    place: usize,
    analysis: Option<&Analysis<'_>>,
) -> FrontSet {
    let motion = analysis.and_then(|analysis| analysis.sets().get(place));
    let member = |index: usize| motion.and_then(|motion| motion.members.get(index).copied().flatten());
    let (first, carrier) = (member(0), member(set.centrals().len()));
    let speed =
        |factor: f64| first.zip(carrier).map(|(first, carrier)| plain(carrier + factor * (first - carrier)));
    // A central gear turns with its link, as in the answer for the gear; a planet shaft has no gear.
    let is_gear = |central: &usize| set.centrals()[*central].kind != CentralKind::PlanetShaft;
    let centrals: Vec<usize> = (0..set.centrals().len()).filter(is_gear).collect();
    let gears: Vec<FrontGear> = shape
        .gears
        .into_iter()
        .enumerate()
        .map(|(index, (gear, factor))| {
            let known = centrals.get(index).and_then(|central| member(*central)).map(plain);
            FrontGear { speed_of_input: known.or_else(|| speed(factor)), ..gear }
        })
        .collect();
    let outer = |planet: &FrontPlanet| {
        let own = planet.gears.iter().map(|own| gears[own.gear].rim_radius).fold(0.0, f64::max);
        planet.centre_distance + own
    };
    let centrals = gears.iter().filter(|gear| gear.part != Part::Planet);
    let centrals = centrals.map(|gear| libm::hypot(gear.centre[0], gear.centre[1]) + gear.rim_radius);
    FrontSet {
        set: set.id().to_owned(),
        has_teeth,
        planets_are_given: set.planet_count().is_some() || set.is_pair(),
        reach: centrals.chain(shape.planets.iter().map(outer)).fold(0.0, f64::max),
        gears,
        planets: shape.planets,
        carrier_of_input: carrier.map(plain),
    }
}

#[cfg(test)]
mod tests;
