//! Front view of sets with known tooth numbers: outlines, and the angles at which their gears mesh.
//!
//! Seen from gear `A` with centre `O_A`, a meshing gear `B` lies in direction `φ`. A tooth of one gear lies
//! in a space of the other if
//!
//! ```text
//! external   z_A·(φ − t_A) + z_B·(φ + π − t_B) = π
//! internal   z_B·(φ − t_B) − z_A·(φ − t_A) = π
//! ```
//!
//! up to turns of 2π. `t` is the angle of the centre line of a tooth. In an internal mesh `B` is the ring,
//! and `φ` is the angle of the planet's centre about the axis.
//!
//! The first central gear has a tooth along the first axis; every other gear follows from one with which it
//! meshes. The second gear of a planet that meshes with no placed gear is turned like the first.

use super::{FrontGear, FrontPlanet, Part, PlanetGear, SHOWN, Shape, group_angles};
use crate::error::Error;
use epicyclic_gears::geometry::GearKind;
use epicyclic_gears::involute::PlanetSet as ShiftedSet;
use epicyclic_gears::involute::curve::ToothCurve;
use epicyclic_gears::involute::{InvoluteGear, Profile};
use epicyclic_gears::rack::BasicRack;
use epicyclic_train::PlanetSet;
use epicyclic_train::compound::CentralKind;
use epicyclic_train::planet_set::{GearOf, MeshKind};
use epicyclic_train::set::{SetKind, SetSpec};
use epicyclic_train::spacing::Spacing;
use std::f64::consts::{PI, TAU};

/// Maximum deviation of an outline's sides from the curve, in modules: below what a screen shows for a gear
/// with 300 teeth.
const DEVIATION: f64 = 4e-3;

/// Rim thickness of a ring beyond its root circle, in modules.
const RIM: f64 = 3.0;

/// Gear to be placed.
struct Placed {
    of: GearOf,
    teeth: f64,
    gear: FrontGear,
    factor: f64,
}

/// Front view of a set with all its teeth; `None` if a tooth number is unknown, or the planets cannot be
/// placed.
pub(super) fn of(set: &PlanetSet, rack: &BasicRack) -> Result<Option<Shape>, Error> {
    let shifted =
        set.short().filter(|spec| spec.kind == SetKind::Simple).and_then(|spec| spec.toothed_set(rack));
    if let Some(Ok(shifted)) = shifted {
        return of_simple(set, &shifted).map(Some);
    }
    // The outlines below are for spur teeth only.
    if set.short().is_some_and(SetSpec::is_helical) {
        return Ok(None);
    }
    let Some(along) = set.along_axis() else { return Ok(None) };
    let mut gears = vec![];
    let profile = Profile::of_rack(*rack);
    for of in gears_of(set) {
        let (Some(mesh), Some(teeth)) =
            (set.meshes().iter().position(|mesh| mesh.gears.contains(&of)), set.teeth(of))
        else {
            return Ok(None);
        };
        let kind = if part(set, of) == Part::Ring { GearKind::Internal } else { GearKind::External };
        let curve = ToothCurve::new(InvoluteGear::new(kind, teeth, profile, 0.0)?)?;
        gears.push(placed(set, of, &curve, along.modules[mesh], curve.gear().reference_diameter())?);
    }
    let places: Vec<[f64; 2]> = along.planets;
    let count = set
        .planet_count()
        .unwrap_or_else(|| (1..=SHOWN).rev().find(|&count| have_room(&gears, &places, count)).unwrap_or(1));
    let angles = group_angles(set, count);
    Ok(Some(in_mesh(set, gears, &places, &angles)))
}

/// Front view of a simple set with profile shifts, with planets at the assembly angles closest to equal
/// spacing.
fn of_simple(set: &PlanetSet, shifted: &ShiftedSet) -> Result<Shape, Error> {
    let fewer =
        |count| ShiftedSet::new(shifted.gears().map(|gear| *gear), count, shifted.centre_distance()).ok();
    let shown = match set.planet_count() {
        Some(_) => None,
        None => (1..=SHOWN).rev().filter_map(fewer).find(|set| set.planet_gap() > 0.0 || set.planets() == 1),
    };
    let shifted = shown.as_ref().unwrap_or(shifted);
    let [[of_sun, of_planet], [_, of_ring]] =
        [shifted.sun_mesh(), shifted.ring_mesh()].map(epicyclic_gears::involute::Pair::working_diameters);
    let curves = shifted.tooth_curves()?;
    let order = [GearOf::Central(0), GearOf::Planet(0, 0), GearOf::Central(1)];
    let mut gears = vec![];
    for ((of, curve), diameter) in order.into_iter().zip(&curves).zip([of_sun, of_planet, of_ring]) {
        gears.push(placed(set, of, curve, 1.0, diameter)?);
    }
    gears.swap(1, 2);
    let angles = if *set.spacing() == Spacing::default() {
        shifted.placed_planets().iter().map(|planet| planet.angle_rad).collect()
    } else {
        group_angles(set, shifted.planets())
    };
    Ok(in_mesh(set, gears, &[[shifted.centre_distance(), 0.0]], &angles))
}

/// Gears of a set: central gears, then those of its planets. The shaft of a planet is not a gear.
fn gears_of(set: &PlanetSet) -> Vec<GearOf> {
    let centrals =
        (0..set.centrals().len()).filter(|&central| set.centrals()[central].kind != CentralKind::PlanetShaft);
    let planets = set.planets().iter().enumerate();
    let planets =
        planets.flat_map(|(planet, of)| (0..of.gears.len()).map(move |step| GearOf::Planet(planet, step)));
    centrals.map(GearOf::Central).chain(planets).collect()
}

fn part(set: &PlanetSet, of: GearOf) -> Part {
    match of {
        GearOf::Planet(..) => Part::Planet,
        GearOf::Central(central) if set.centrals()[central].kind == CentralKind::Ring => Part::Ring,
        GearOf::Central(_) => Part::Sun,
    }
}

fn placed(
    set: &PlanetSet,
    of: GearOf,
    curve: &ToothCurve,
    module: f64,
    diameter: f64,
) -> Result<Placed, Error> {
    let part = part(set, of);
    let outline = curve.outline(DEVIATION)?;
    let rim = if part == Part::Ring { curve.root_radius() + RIM } else { curve.tip_radius() };
    let factor = match of {
        GearOf::Central(central) => set.ratio_between(central, 0),
        GearOf::Planet(planet, _) => set.planet_factor(planet).unwrap_or(f64::NAN),
    };
    let gear = FrontGear {
        name: set.gear_name(of),
        part,
        teeth: Some(curve.gear().teeth().get()),
        pitch_radius: 0.5 * module * diameter,
        rim_radius: module * rim,
        turn_rad: 0.0,
        outline: outline.into_iter().map(|point| point.map(|along| module * along)).collect(),
        speed_of_input: None,
    };
    Ok(Placed { of, teeth: curve.gear().teeth().as_f64(), gear, factor })
}

/// Whether so many planets of each kind do not overlap.
fn have_room(gears: &[Placed], places: &[[f64; 2]], count: u32) -> bool {
    let step = TAU / f64::from(count);
    let tip = |planet: usize| {
        let own = gears.iter().filter(|one| matches!(one.of, GearOf::Planet(of, _) if of == planet));
        own.map(|one| one.gear.rim_radius).fold(0.0, f64::max)
    };
    (1..count).all(|copy| {
        let pairs = (0..places.len()).flat_map(|one| (0..places.len()).map(move |other| (one, other)));
        pairs.into_iter().all(|(one, other)| {
            let ([r1, a1], [r2, a2]) = (places[one], places[other]);
            let angle = a2 + step * f64::from(copy) - a1;
            let apart = (r1 * r1 + r2 * r2 - 2.0 * r1 * r2 * libm::cos(angle)).sqrt();
            apart > tip(one) + tip(other)
        })
    })
}

/// Turns every gear so that it meshes; planets are placed from each of the angles onwards.
fn in_mesh(set: &PlanetSet, mut gears: Vec<Placed>, places: &[[f64; 2]], angles: &[f64]) -> Shape {
    let index = |of: GearOf| gears.iter().position(|one| one.of == of);
    let meshes: Vec<(usize, usize, bool)> = set
        .meshes()
        .iter()
        .filter_map(|mesh| {
            let [one, other] = mesh.gears;
            let (one, other) = (index(one)?, index(other)?);
            // In an internal mesh the ring is the second gear.
            let is_internal = mesh.kind == MeshKind::Internal;
            let turned = gears[one].gear.part == Part::Ring;
            Some(if turned { (other, one, is_internal) } else { (one, other, is_internal) })
        })
        .collect();
    let mut central_turns: Vec<Option<f64>> = vec![None; gears.len()];
    if let Some(first) = central_turns.first_mut() {
        *first = Some(0.0);
    }
    let mut planets = vec![];
    for &start in angles {
        let angle = |planet: usize| start + places[planet][1];
        let centre = |gear: usize| match gears[gear].of {
            GearOf::Central(_) => [0.0; 2],
            GearOf::Planet(planet, _) => {
                let (sin, cos) = libm::sincos(angle(planet));
                [places[planet][0] * cos, places[planet][0] * sin]
            }
        };
        let mut turns = central_turns.clone();
        // If a round places no new gear, the angle of a planet is passed on to its other gears.
        while let Some(unplaced) = turns.iter().position(Option::is_none) {
            let mut is_new = false;
            for &(one, other, is_internal) in &meshes {
                let (from, to) = match (turns[one], turns[other]) {
                    (Some(_), None) => (one, other),
                    (None, Some(_)) => (other, one),
                    _ => continue,
                };
                let (turn, [z_from, z_to]) =
                    (turns[from].unwrap_or_default(), [from, to].map(|of| gears[of].teeth));
                let ([x1, y1], [x2, y2]) = (centre(from), centre(to));
                turns[to] = Some(if is_internal {
                    // In both cases the planet centre is seen from the main axis.
                    let [x, y] = if from == other { [x2, y2] } else { [x1, y1] };
                    let direction = libm::atan2(y, x);
                    let phase = z_from * (direction - turn) + PI;
                    direction - phase / z_to
                } else {
                    let direction = libm::atan2(y2 - y1, x2 - x1);
                    direction + PI - (PI - z_from * (direction - turn)) / z_to
                });
                is_new = true;
            }
            if !is_new {
                let body = |gear: usize| set.body(gears[gear].of);
                let with =
                    (0..gears.len()).find(|&gear| turns[gear].is_some() && body(gear) == body(unplaced));
                turns[unplaced] = Some(with.and_then(|gear| turns[gear]).unwrap_or(0.0));
            }
        }
        for (planet, [radius, _]) in places.iter().enumerate() {
            let own = (0..gears.len())
                .filter(|&gear| matches!(gears[gear].of, GearOf::Planet(of, _) if of == planet));
            planets.push(FrontPlanet {
                centre_distance: *radius,
                angle_rad: angle(planet),
                gears: own
                    .map(|gear| PlanetGear { gear, turn_rad: turns[gear].unwrap_or_default() })
                    .collect(),
            });
        }
        for (gear, turn) in turns.into_iter().enumerate() {
            if matches!(gears[gear].of, GearOf::Central(_)) {
                central_turns[gear] = turn;
            }
        }
    }
    for (one, turn) in gears.iter_mut().zip(central_turns) {
        one.gear.turn_rad = turn.filter(|_| one.gear.part != Part::Planet).unwrap_or_default();
    }
    Shape { gears: gears.into_iter().map(|one| (one.gear, one.factor)).collect(), planets }
}
