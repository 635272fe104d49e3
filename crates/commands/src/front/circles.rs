//! Pitch circles of simple and double-planet sets with known ratio and unknown tooth numbers.

use super::{FrontGear, FrontPlanet, Part, PlanetGear, SHOWN, Shape};
use epicyclic_train::PlanetSet;
use epicyclic_train::planet_set::GearOf;
use epicyclic_train::set::SetKind;

/// Radius of each of two equal meshing planets over the radial space between sun and ring. At a quarter both
/// would lie on one line with the axis.
const EACH_OF_TWO: f64 = 0.29;

/// Pitch circles of a set: the ring's radius is `k` times the sun's.
pub(super) fn of(set: &PlanetSet) -> Option<Shape> {
    let k = set.ratio_between(0, 1).abs();
    let angles = set.shown_angles(set.planet_count().unwrap_or(SHOWN));
    // Centre radius, pitch radius and `(ω − ω_H)/(ω_1 − ω_H)` of each planet.
    let planets: Vec<[f64; 3]> = match set.kind()? {
        SetKind::Simple => {
            let radius = 0.5 * (k - 1.0);
            vec![[1.0 + radius, radius, -1.0 / radius]]
        }
        SetKind::DoublePlanet if k > 1.0 => {
            let radius = EACH_OF_TWO * (k - 1.0);
            vec![[1.0 + radius, radius, -1.0 / radius], [k - radius, radius, 1.0 / radius]]
        }
        _ => return None,
    };
    let circle = |of: GearOf, part: Part, radius: f64| FrontGear {
        name: set.gear_name(of),
        part,
        teeth: set.teeth(of).map(epicyclic_gears::ToothCount::get),
        pitch_radius: radius,
        rim_radius: if part == Part::Ring { 1.08 * radius } else { radius },
        centre: [0.0; 2],
        turn_rad: 0.0,
        outline: vec![],
        speed_of_input: None,
    };
    let mut gears = vec![
        (circle(GearOf::Central(0), Part::Sun, 1.0), 1.0),
        (circle(GearOf::Central(1), Part::Ring, k), set.ratio_between(1, 0)),
    ];
    for (planet, [_, radius, factor]) in planets.iter().enumerate() {
        gears.push((circle(GearOf::Planet(planet, 0), Part::Planet, *radius), *factor));
    }
    let apart = match planets.as_slice() {
        [[first, radius, _], [second, ..]] => {
            let between = 2.0 * radius;
            libm::acos((first * first + second * second - between * between) / (2.0 * first * second))
        }
        _ => 0.0,
    };
    let standing = |at: f64, planet: usize| FrontPlanet {
        centre_distance: planets[planet][0],
        angle_rad: at + apart * planet as f64,
        gears: vec![PlanetGear { gear: 2 + planet, turn_rad: 0.0 }],
    };
    let planets = angles.into_iter().flat_map(|at| (0..planets.len()).map(move |planet| (at, planet)));
    Some(Shape { gears, planets: planets.map(|(at, planet)| standing(at, planet)).collect() })
}
