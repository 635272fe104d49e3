//! The planet sets of a gearbox seen from the front, and how fast each part turns in a gear: what a moving
//! picture is made of.
//!
//! Lengths are in a unit of each set's own: a module where its teeth are known, otherwise the pitch radius of
//! its sun. A part stands at its place when the first central gear has a tooth along the first axis, and
//! turns from there: a planet about itself with its speed, and with the carrier about the axis. With teeth
//! the outlines are those that a hob leaves of suns and planets, a shaper of rings; without them pitch
//! circles. There are as many planets as the file states, or up to [`SHOWN`].

mod circles;
mod gears;

use crate::answer::Answer;
use crate::error::Error;
use crate::shared::gearbox::Subject;
use crate::shared::number::plain;
use epicyclic_train::{Analysis, PlanetSet};
use epicyclic_units::Physical;
use schemars::JsonSchema;
use serde::Serialize;
use std::f64::consts::TAU;

/// Planets of a set of which the file does not say how many there are, where so many have room.
pub const SHOWN: u32 = 3;

/// Angles of the planets of one kind, rad: those of the set, or so many equal ones where it does not say how
/// many there are.
fn group_angles(set: &PlanetSet, count: u32) -> Vec<f64> {
    match set.planet_angles() {
        Some(angles) => angles.into_iter().map(Physical::si).collect(),
        None => (0..count).map(|copy| TAU * f64::from(copy) / f64::from(count)).collect(),
    }
}

/// A gearbox from the front.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Front {
    /// Name of the gearbox.
    pub gearbox: String,
    /// The gear whose speeds these are; null where none is chosen.
    pub gear: Option<String>,
    /// The sets that are shown.
    pub sets: Vec<FrontSet>,
    /// Sets that are not: pairs on fixed axes, bevel gears, and those whose tooth numbers are not known or
    /// leave their planets apart.
    pub left_out: Vec<String>,
    /// Sets whose tooth numbers are known and whose teeth are not shown, since no tool leaves them.
    pub uncut: Vec<Uncut>,
}

/// A set with teeth that no tool leaves.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Uncut {
    /// The set.
    pub set: String,
    /// What is wrong with its teeth.
    pub why: String,
}

impl Answer for Front {
    const NAME: &'static str = "front";
}

/// A set from the front.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct FrontSet {
    /// Name of the set.
    pub set: String,
    /// Whether its teeth are known; otherwise pitch circles are shown.
    pub has_teeth: bool,
    /// Whether the file says how many planets there are.
    pub planets_are_given: bool,
    /// Radius of a circle about all of it.
    pub reach: f64,
    /// Its gears: central ones, then those of its planets.
    pub gears: Vec<FrontGear>,
    /// Every planet that stands about the axis.
    pub planets: Vec<FrontPlanet>,
    /// Speed of the carrier over the input's; null where none follows.
    pub carrier_of_input: Option<f64>,
}

/// What a gear is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Part {
    /// A central gear with teeth outside.
    Sun,
    /// A central gear with teeth inside.
    Ring,
    /// A gear of a planet.
    Planet,
}

/// A gear of a set from the front.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct FrontGear {
    /// Its name within the set.
    pub name: String,
    /// What it is.
    pub part: Part,
    /// Teeth; null where they are not known.
    pub teeth: Option<u32>,
    /// Radius of its pitch circle; of the planet of a simple set that of its mesh with the sun.
    pub pitch_radius: f64,
    /// Outside of a ring; of other gears nearly their tips.
    pub rim_radius: f64,
    /// Angle by which the outline of a central gear is turned; of planets see there.
    pub turn_rad: f64,
    /// Its outline about its own axis, closed; empty without teeth.
    pub outline: Vec<[f64; 2]>,
    /// Its speed over the input's; null where none follows.
    pub speed_of_input: Option<f64>,
}

/// Where a planet stands.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct FrontPlanet {
    /// Distance of its centre from the axis.
    pub centre_distance: f64,
    /// Angle of its centre about the axis.
    pub angle_rad: f64,
    /// Its gears.
    pub gears: Vec<PlanetGear>,
}

/// A gear of a planet that stands somewhere.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct PlanetGear {
    /// Place of the gear in the set's.
    pub gear: usize,
    /// Angle by which its outline is turned.
    pub turn_rad: f64,
}

/// The planet sets of a gearbox, in a gear or at rest.
///
/// A set whose teeth no tool leaves is shown as its pitch circles, where it is a simple one.
///
/// # Errors
/// [`Error::NoGear`].
pub fn answer(subject: &Subject<'_>, gear: Option<&str>) -> Result<Front, Error> {
    let gearbox = &subject.gearbox;
    let analysis = gear.map(|gear| crate::analyze::answer::analysis(gearbox, gear)).transpose()?;
    let (mut sets, mut left_out, mut uncut) = (vec![], vec![], vec![]);
    for (place, set) in gearbox.sets().iter().enumerate() {
        let with_teeth = gears::of(set, &subject.rack).unwrap_or_else(|error| {
            uncut.push(Uncut { set: set.id().to_owned(), why: error.to_string() });
            None
        });
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

/// A set at rest.
struct Shape {
    /// Each with `(ω − ω_H)/(ω_1 − ω_H)` over the first central gear.
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
    let centrals = shape.gears.iter().filter(|(gear, _)| gear.part != Part::Planet).count();
    let gears: Vec<FrontGear> = shape
        .gears
        .into_iter()
        .enumerate()
        .map(|(index, (gear, factor))| {
            // A central gear turns with its link, as the answer of the gear has it.
            let known = (index < centrals).then(|| member(index)).flatten().map(plain);
            FrontGear { speed_of_input: known.or_else(|| speed(factor)), ..gear }
        })
        .collect();
    let outer = |planet: &FrontPlanet| {
        let own = planet.gears.iter().map(|own| gears[own.gear].rim_radius).fold(0.0, f64::max);
        planet.centre_distance + own
    };
    let centrals = gears.iter().filter(|gear| gear.part != Part::Planet).map(|gear| gear.rim_radius);
    FrontSet {
        set: set.id().to_owned(),
        has_teeth,
        planets_are_given: set.planet_count().is_some(),
        reach: centrals.chain(shape.planets.iter().map(outer)).fold(0.0, f64::max),
        gears,
        planets: shape.planets,
        carrier_of_input: carrier.map(plain),
    }
}

#[cfg(test)]
mod tests;
