//! The simple sets of a gearbox seen from the front, and how fast each part turns in a gear: what a moving picture is made of.
//!
//! Lengths are in a unit of each set's own: its module where its teeth are known, otherwise the pitch radius of its sun. A part stands at its
//! place when the sun has a tooth along the first axis, and turns from there: a planet about itself with its speed, and with the carrier about
//! the axis. With teeth the outlines are those that a hob leaves of sun and planets, a shaper of rings; without them pitch circles, of as many
//! planets as the file states, or [`SHOWN`].

use crate::gearbox::Subject;
use crate::number::plain;
use crate::{Answer, Error};
use epicyclic_gears::involute::PlanetSet as ToothedSet;
use epicyclic_gears::involute::curve::ToothCurve;
use epicyclic_train::set::{Gearing, SetKind, SetSpec};
use epicyclic_train::{Analysis, PlanetSet};
use schemars::JsonSchema;
use serde::Serialize;
use std::f64::consts::TAU;

/// How far the sides of an outline may leave the curve, modules: below what a screen shows of a gear with 300 teeth.
const DEVIATION: f64 = 4e-3;

/// Planets of a set of which the file does not say how many there are.
pub const SHOWN: u32 = 3;

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
    /// Sets of other kinds.
    pub left_out: Vec<String>,
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
    /// Outside of the ring as it is shown.
    pub rim_radius: f64,
    /// Distance of the planets' centres from the axis.
    pub centre_distance: f64,
    /// Sun, planet and ring.
    pub gears: [FrontGear; 3],
    /// Where the planets stand.
    pub planets: Vec<FrontPlanet>,
    /// Speed of the carrier over the input's; null where none follows.
    pub carrier_of_input: Option<f64>,
}

/// A gear of a set from the front.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct FrontGear {
    /// Teeth; null where only `k` is known.
    pub teeth: Option<u32>,
    /// Radius of the working pitch circle; of the planet that of its mesh with the sun.
    pub pitch_radius: f64,
    /// Angle by which its outline is turned; of planets see there.
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
    /// Angle of its centre about the axis.
    pub angle_rad: f64,
    /// Angle by which its outline is turned.
    pub turn_rad: f64,
}

/// The simple sets of a gearbox, in a gear or at rest.
///
/// # Errors
/// [`Error::NoGear`]; [`Error::Gear`] for gears that the tools do not cut.
pub fn answer(subject: &Subject<'_>, gear: Option<&str>) -> Result<Front, Error> {
    let gearbox = &subject.gearbox;
    let analysis = gear.map(|gear| crate::analyze::analysis(gearbox, gear)).transpose()?;
    let (mut sets, mut left_out) = (vec![], vec![]);
    for (place, set) in gearbox.sets().iter().enumerate() {
        match set.short().filter(|spec| spec.kind == SetKind::Simple) {
            Some(spec) => sets.push(front_set(subject, set, spec, place, analysis.as_ref())?),
            None => left_out.push(set.id().to_owned()),
        }
    }
    Ok(Front {
        gearbox: gearbox.name().to_owned(),
        gear: analysis.map(|analysis| analysis.gear().name().to_owned()),
        sets,
        left_out,
    })
}

fn front_set(
    subject: &Subject<'_>,
    set: &PlanetSet,
    spec: &SetSpec,
    place: usize,
    analysis: Option<&Analysis<'_>>,
) -> Result<FrontSet, Error> {
    let motion = analysis.and_then(|analysis| analysis.sets().get(place));
    let member = |index: usize| motion.and_then(|motion| motion.members.get(index).copied().flatten());
    let relative = |factor: f64| -> Option<f64> {
        let (sun, carrier) = (member(0)?, member(2)?);
        Some(carrier - (sun - carrier) * factor)
    };
    let toothed = spec.toothed_set(&subject.rack).and_then(Result::ok).map(|set| match spec.planet_count {
        Some(_) => set,
        None => with_shown_planets(&set).unwrap_or(set),
    });
    let shape = match &toothed {
        Some(toothed) => of_teeth(toothed)?,
        None => of_circles(set, spec),
    };
    // Seen from the carrier a planet turns against the sun, by the ratio of their teeth.
    let planet = relative(shape.sun_over_planet);
    let speeds = [member(0), planet, member(1)];
    let mut gears = shape.gears;
    for (gear, speed) in gears.iter_mut().zip(speeds) {
        gear.speed_of_input = speed.map(plain);
    }
    Ok(FrontSet {
        set: set.id().to_owned(),
        has_teeth: toothed.is_some(),
        planets_are_given: spec.planet_count.is_some(),
        rim_radius: shape.rim_radius,
        centre_distance: shape.centre_distance,
        gears,
        planets: shape.planets,
        carrier_of_input: member(2).map(plain),
    })
}

/// The same gears with [`SHOWN`] planets; nothing where that many do not fit.
fn with_shown_planets(set: &ToothedSet) -> Option<ToothedSet> {
    let gears = set.gears().map(|gear| *gear);
    ToothedSet::new(gears, SHOWN, set.centre_distance()).ok().filter(|set| set.planet_gap() > 0.0)
}

/// A set at rest.
struct Shape {
    gears: [FrontGear; 3],
    planets: Vec<FrontPlanet>,
    rim_radius: f64,
    centre_distance: f64,
    /// Teeth of the sun over those of the planet.
    sun_over_planet: f64,
}

fn of_teeth(set: &ToothedSet) -> Result<Shape, Error> {
    let [sun, planet, ring] = set.tooth_curves()?;
    let [[of_sun, of_planet], [_, of_ring]] =
        [set.sun_mesh(), set.ring_mesh()].map(epicyclic_gears::involute::Pair::working_diameters);
    let gear = |curve: &ToothCurve, diameter: f64, turn_rad: f64| -> Result<FrontGear, Error> {
        Ok(FrontGear {
            teeth: Some(curve.gear().teeth().get()),
            pitch_radius: 0.5 * diameter,
            turn_rad,
            outline: curve.outline(DEVIATION)?,
            speed_of_input: None,
        })
    };
    let placed = set.placed_planets().into_iter();
    let [of_the_sun, of_the_planet, _] = set.gears().map(|gear| gear.teeth().as_f64());
    Ok(Shape {
        rim_radius: ring.root_radius() + 3.0,
        gears: [
            gear(&sun, of_sun, 0.0)?,
            gear(&planet, of_planet, 0.0)?,
            gear(&ring, of_ring, set.ring_turn_rad())?,
        ],
        planets: placed.map(|at| FrontPlanet { angle_rad: at.angle_rad, turn_rad: at.turn_rad }).collect(),
        centre_distance: set.centre_distance(),
        sun_over_planet: of_the_sun / of_the_planet,
    })
}

/// Pitch circles that touch: the ring's is `k` times the sun's.
fn of_circles(set: &PlanetSet, spec: &SetSpec) -> Shape {
    let k = set.ratio_between(0, 1).abs();
    let teeth = match spec.gearing {
        Gearing::Teeth(sun, ring) => [Some(sun.get()), None, Some(ring.get())],
        Gearing::BasicRatio(_) => [None; 3],
    };
    let planet = 0.5 * (k - 1.0);
    let radii = [1.0, planet, k];
    let gear = |place: usize| FrontGear {
        teeth: teeth[place],
        pitch_radius: radii[place],
        turn_rad: 0.0,
        outline: vec![],
        speed_of_input: None,
    };
    let count = spec.planet_count.unwrap_or(SHOWN);
    let at = |index: u32| FrontPlanet { angle_rad: TAU * f64::from(index) / f64::from(count), turn_rad: 0.0 };
    Shape {
        gears: [gear(0), gear(1), gear(2)],
        planets: (0..count).map(at).collect(),
        rim_radius: 1.08 * k,
        centre_distance: 1.0 + planet,
        sun_over_planet: 1.0 / planet,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gearbox::{Choice, one};
    use epicyclic_formats::Document;

    fn front_of(sets: &str, gear: Option<&str>) -> Front {
        let text = format!(
            "gearbox: g\ninput: D\noutput: B\nsets:\n{sets}\nbrakes: [{{ id: K, link: T }}]\ngears: [{{ name: '1', engaged: [K] }}]\n"
        );
        let document = Document::parse_one("g.yaml", text.as_bytes()).unwrap();
        let subject = one(&document, &Choice::default()).unwrap();
        answer(&subject, gear).unwrap()
    }

    const TOOTHED: &str = "  - { id: P, sun: D, ring: T, carrier: B, teeth: [24, 72], planets: 4 }";

    #[test]
    fn points_of_contact_have_one_speed_on_both_gears() {
        for sets in [TOOTHED, "  - { id: P, sun: D, ring: T, carrier: B, k: 2.94 }"] {
            let front = front_of(sets, Some("1"));
            let set = &front.sets[0];
            let [sun, planet, ring] = &set.gears;
            let [omega_s, omega_p, omega_r] = [sun, planet, ring].map(|gear| gear.speed_of_input.unwrap());
            let carrier = set.carrier_of_input.unwrap();
            let centre = carrier * set.centre_distance;
            assert!((omega_s * sun.pitch_radius - (centre - omega_p * planet.pitch_radius)).abs() < 1e-12);
            assert!((omega_r * ring.pitch_radius - (centre + omega_p * planet.pitch_radius)).abs() < 1e-12);
            assert_eq!(omega_r, 0.0);
        }
    }

    #[test]
    fn teeth_give_outlines_and_k_gives_circles_of_three_planets() {
        let toothed = &front_of(TOOTHED, None).sets[0];
        assert!(toothed.has_teeth && toothed.planets.len() == 4 && toothed.carrier_of_input.is_none());
        assert!(toothed.gears.iter().all(|gear| gear.outline.len() > 200));
        let reach = |points: &[[f64; 2]]| points.iter().map(|[x, y]| x.hypot(*y)).fold(0.0, f64::max);
        assert!(reach(&toothed.gears[2].outline) < toothed.rim_radius);
        let unsaid = &front_of(&TOOTHED.replace(", planets: 4", ""), None).sets[0];
        assert!(!unsaid.planets_are_given && unsaid.planets.len() == 3);
        let circles = &front_of("  - { id: P, sun: D, ring: T, carrier: B, k: 3 }", None).sets[0];
        assert!(!circles.has_teeth && !circles.planets_are_given && circles.planets.len() == 3);
        assert_eq!(circles.gears.clone().map(|gear| gear.pitch_radius), [1.0, 1.0, 3.0]);
    }

    #[test]
    fn sets_of_other_kinds_are_named() {
        let front =
            front_of("  - { id: P, kind: double_planet, sun: D, ring: T, carrier: B, k: 2.5 }", Some("1"));
        assert_eq!((front.sets.len(), front.left_out), (0, vec!["P".to_owned()]));
    }
}
