//! Front view of sets with known tooth numbers: outlines, and the angles at which their gears mesh.

use super::{FrontGear, FrontPlanet, Part, PlanetGear, Shape};
use epicyclic_gears::Error;
use epicyclic_train::PlanetSet;
use epicyclic_train::in_mesh::{GearInMesh, InMesh};
use epicyclic_train::planet_set::GearOf;

/// Maximum deviation of an outline's sides from the curve, in modules: below what a screen shows for a gear
/// with 300 teeth.
const DEVIATION: f64 = 4e-3;

/// Shape of a set from its gears in mesh.
pub(super) fn of(set: &PlanetSet, in_mesh: &InMesh) -> Result<Shape, Error> {
    let unit = in_mesh.meshes.first().map_or(1.0, |mesh| mesh.module);
    let mut gears = vec![];
    for gear in &in_mesh.gears {
        gears.push(shown(set, gear, unit)?);
    }
    for placed in &in_mesh.centrals {
        let (gear, _) = &mut gears[placed.gear];
        gear.turn_rad = placed.turn_rad;
        gear.centre = placed.centre.map(|along| along / unit);
    }
    let planets = in_mesh.planets.iter().map(|planet| FrontPlanet {
        centre_distance: planet.centre_distance / unit,
        angle_rad: planet.angle_rad,
        gears: planet.gears.iter().map(|own| PlanetGear { gear: own.gear, turn_rad: own.turn_rad }).collect(),
    });
    Ok(Shape { planets: planets.collect(), gears })
}

/// Gear about its own axis, and its speed ratio to the first central gear.
fn shown(set: &PlanetSet, gear: &GearInMesh, unit: f64) -> Result<(FrontGear, f64), Error> {
    let part = match gear.of {
        GearOf::Planet(..) => Part::Planet,
        GearOf::Central(_) if gear.is_ring() => Part::Ring,
        GearOf::Central(_) => Part::Sun,
    };
    let factor = match gear.of {
        GearOf::Central(central) => set.ratio_between(central, 0),
        GearOf::Planet(planet, _) => set.planet_factor(planet).unwrap_or(f64::NAN),
    };
    let module = gear.module / unit;
    let curve = &gear.curve;
    let outline = curve.outline(DEVIATION)?;
    let shown = FrontGear {
        name: set.gear_name(gear.of),
        part,
        teeth: Some(curve.gear().teeth().get()),
        pitch_radius: gear.working_radius / unit,
        rim_radius: gear.outer_radius() / unit,
        centre: [0.0; 2],
        turn_rad: 0.0,
        outline: outline.into_iter().map(|point| point.map(|along| module * along)).collect(),
        speed_of_input: None,
    };
    Ok((shown, factor))
}
