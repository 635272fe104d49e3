//! Planet sets seen along their axis with every tooth in mesh: exact involutes and fillets.

use crate::Error;
use epicyclic_drawing::{Align, Color, Point, Scene, Shape, Style, Text};
use epicyclic_gears::involute::PlanetSet;
use epicyclic_gears::involute::curve::ToothCurve;
use epicyclic_units::Physical;
use uom::si::f64::Length;

/// A set to draw.
#[derive(Debug, Clone, PartialEq)]
pub struct ToothedSet {
    /// Name of the set.
    pub name: String,
    /// Gears of the set.
    pub set: PlanetSet,
    /// Module of the set.
    pub module: Length,
}

/// Largest distance of the sides of an outline from the curve, modules.
const DEVIATION: f64 = 1e-3;

/// Parts of a degree to which a helix angle is given.
const PART_OF_DEGREE: f64 = 1e4;

/// Sets side by side, 1 mm of the drawing 1 mm of each; sun and planets as a hob leaves them, rings as a
/// shaper does.
///
/// # Errors
/// [`Error::Gear`] for gears that the tools do not cut, [`Error::Drawing`] for sets larger than a drawing.
pub fn scene(title: &str, sets: &[ToothedSet]) -> Result<Scene, Error> {
    let mut scene = Scene::new(title);
    let rings = scene.layer("rings", Style::line(0.13).fill(Color::new(226, 226, 230)))?;
    let planets = scene.layer("planets", Style::line(0.13).fill(Color::new(214, 228, 242)))?;
    let suns = scene.layer("suns", Style::line(0.13).fill(Color::new(246, 226, 206)))?;
    let circles = scene.layer("working circles", Style::centre_line().width(0.1))?;
    let labels = scene.layer("labels", Style::line(0.1))?;
    let mut left = 0.0;
    for ToothedSet { name, set, module } in sets {
        let m = module.mm();
        let [sun, planet, ring] = set.tooth_curves()?;
        // A rim of some modules about the roots; letters keep their proportion to the set.
        let rim = m * (ring.root_radius() + 3.0);
        let letter = rim / 22.0;
        let centre = Point::new(left + rim, 0.0);
        let outline = |curve: &ToothCurve, at: Point, turn: f64| -> Result<Shape, Error> {
            let (sin, cos) = libm::sincos(turn);
            let points = curve.outline(DEVIATION)?;
            let placed = points.into_iter();
            Ok(Shape::polygon(
                placed
                    .map(|[x, y]| Point::new(at.x + m * (x * cos - y * sin), at.y + m * (x * sin + y * cos))),
            ))
        };
        let circle = |centre: Point, diameter: f64| Shape::Circle { centre, radius: 0.5 * m * diameter };
        scene.add(rings, Shape::Circle { centre, radius: rim });
        let inner = Style::line(0.13).fill(Color::WHITE);
        scene.add_styled(rings, inner, outline(&ring, centre, set.ring_turn_rad())?);
        scene.add(suns, outline(&sun, centre, 0.0)?);
        let [[of_sun, of_planet], [_, of_ring]] =
            [set.sun_mesh(), set.ring_mesh()].map(epicyclic_gears::involute::Pair::working_diameters);
        scene.add(circles, circle(centre, of_sun));
        scene.add(circles, circle(centre, of_ring));
        for placed in set.placed_planets() {
            let at = Point::polar(centre, m * set.centre_distance(), placed.angle_rad);
            scene.add(planets, outline(&planet, at, placed.turn_rad)?);
            scene.add(circles, circle(at, of_planet));
        }
        let shift = |place: usize| set.gears()[place].shift();
        let a = m * set.centre_distance();
        let helix = (sun.gear().profile().helix_angle.degrees() * PART_OF_DEGREE).round() / PART_OF_DEGREE;
        let lines = [
            format!("set {name}: {}/{}/{}", sun.gear().teeth(), planet.gear().teeth(), ring.gear().teeth()),
            format!("x = {:.4}, {:.4}, {:.4}", shift(0), shift(1), shift(2)),
            if helix == 0.0 {
                format!("m = {m} mm, a = {a:.3} mm")
            } else {
                format!("m_n = {m} mm, β = {helix}°, a = {a:.3} mm")
            },
        ];
        for (line, place) in lines.into_iter().zip([1.5, 3.0, 4.5]) {
            let at = [left + rim, -rim - place * letter];
            scene.add(labels, Text::new(at, letter, line).align(Align::Middle));
        }
        left += 2.0 * rim + 2.0 * letter;
    }
    scene.check()?;
    Ok(scene)
}

#[cfg(test)]
mod tests {
    use super::*;
    use epicyclic_drawing::text::overlaps;
    use epicyclic_gears::ToothCount;
    use epicyclic_gears::involute::closing::Closing;

    #[test]
    fn sets_stand_side_by_side_with_all_their_teeth() {
        let set = |name: &str, counts: [u32; 3], module| {
            let teeth = counts.map(|count| ToothCount::new(count).unwrap());
            let set = Closing::default().close(teeth).unwrap().set;
            ToothedSet { name: name.to_owned(), set, module: Length::from_mm(module) }
        };
        let scene = scene("two", &[set("1", [18, 36, 93], 2.0), set("2", [21, 43, 108], 1.75)]).unwrap();
        assert_eq!(overlaps(&scene), []);
        let polygons = scene
            .items()
            .iter()
            .filter(|item| matches!(item.shape, Shape::Polyline { closed: true, .. }))
            .count();
        // Sun, ring and three planets of each.
        assert_eq!(polygons, 10);
        let rim = |teeth: f64, module: f64| module * (teeth + 6.0);
        assert!(scene.bounds().width() > rim(93.0, 2.0) + rim(108.0, 1.75));
    }
}
