//! Modes of a planet set seen along its axis: each body at rest and displaced.

use crate::plot::LETTERS_MM;
use epicyclic_drawing::{Color, Dash, Error, Point, Scene, Shape, Style, Text};

/// Modes side by side.
const COLUMNS: usize = 4;
/// Width and height that a mode takes.
const CELL_MM: [f64; 2] = [48.0, 54.0];
/// Radius of the largest body on the sheet.
const RADIUS_MM: f64 = 17.0;
/// The largest displacement over that radius.
const LARGEST: f64 = 0.22;

/// Part that a body represents.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "names", derive(serde::Serialize, schemars::JsonSchema))]
#[cfg_attr(feature = "names", serde(rename_all = "snake_case"), schemars(rename = "Member"))]
pub enum Part {
    /// The sun.
    Sun,
    /// The ring.
    Ring,
    /// The carrier, as the circle of its planets.
    Carrier,
    /// A planet.
    Planet,
}

impl Part {
    fn style(self) -> Style {
        let color = match self {
            Self::Sun => Color::new(190, 0, 30),
            Self::Ring => Color::new(0, 90, 160),
            Self::Carrier => Color::new(120, 60, 140),
            Self::Planet => Color::new(20, 120, 50),
        };
        let style = Style::line(0.35).color(color);
        if self == Self::Carrier { style.dash(Dash::DashDot) } else { style }
    }
}

/// A body with its motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Body {
    /// The part.
    pub part: Part,
    /// Centre at rest.
    pub centre: [f64; 2],
    /// Radius, in the unit of the centre.
    pub radius: f64,
    /// Displacement `x`, `y` of the centre and `u`, its rotation times the radius, over the largest of the
    /// mode.
    pub motion: [f64; 3],
}

/// A mode.
#[derive(Debug, Clone, PartialEq)]
pub struct Mode {
    /// Text below the picture of the mode.
    pub name: String,
    /// The bodies.
    pub bodies: Vec<Body>,
}

/// The modes in rows, at rest grey, displaced in colour. A mark on each circle shows its rotation;
/// displacements are enlarged.
///
/// # Errors
/// As [`Scene::layer`] and [`Scene::check`]; not for any finite values.
pub fn scene(title: &str, modes: &[Mode]) -> Result<Scene, Error> {
    let mut scene = Scene::new(title.to_owned());
    let rest = scene.layer("rest", Style::line(0.13).color(Color::new(170, 170, 170)))?;
    let moved = scene.layer("displaced", Style::line(0.35))?;
    let labels = scene.layer("labels", Style::line(0.1))?;
    let largest = |mode: &Mode| mode.bodies.iter().map(|body| body.radius).fold(0.0, f64::max);
    let scale = RADIUS_MM / modes.iter().map(largest).fold(f64::MIN_POSITIVE, f64::max);
    for (place, mode) in modes.iter().enumerate() {
        let at = [(place % COLUMNS) as f64 * CELL_MM[0], -((place / COLUMNS) as f64) * CELL_MM[1]];
        for body in &mode.bodies {
            let [x, y, u] = body.motion.map(|part| part * LARGEST * RADIUS_MM);
            let centre = Point::new(at[0] + body.centre[0] * scale, at[1] + body.centre[1] * scale);
            let radius = body.radius * scale;
            // Marks of planets point outwards, others to the right.
            let outwards = libm::atan2(body.centre[1], body.centre[0]);
            let circle = |scene: &mut Scene, centre: Point, angle: f64, style: Option<Style>| {
                let rim = Point::polar(centre, radius, angle);
                let inner = Point::polar(centre, 0.6 * radius, angle);
                for shape in [Shape::Circle { centre, radius }, Shape::line(inner, rim)] {
                    match style {
                        Some(style) => scene.add_styled(moved, style, shape),
                        None => scene.add(rest, shape),
                    }
                }
            };
            circle(&mut scene, centre, outwards, None);
            let displaced = Point::new(centre.x + x, centre.y + y);
            circle(&mut scene, displaced, outwards + u / radius, Some(body.part.style()));
        }
        let below = [at[0], at[1] - (1.0 + LARGEST) * RADIUS_MM - 4.0];
        scene.add(labels, Text::new(below, 0.9 * LETTERS_MM, mode.name.clone()));
    }
    let middle = 0.5 * (COLUMNS.min(modes.len()).max(1) - 1) as f64 * CELL_MM[0];
    let above = (1.0 + LARGEST) * RADIUS_MM + 6.0;
    scene.add(labels, Text::new([middle, above], 1.2 * LETTERS_MM, title.to_owned()));
    scene.check()?;
    Ok(scene)
}

#[cfg(test)]
mod tests {
    use super::*;
    use epicyclic_drawing::text::overlaps;

    fn body(part: Part, centre: [f64; 2], radius: f64, motion: [f64; 3]) -> Body {
        Body { part, centre, radius, motion }
    }

    #[test]
    fn labels_stand_free_below_their_modes() {
        let bodies = vec![
            body(Part::Ring, [0.0, 0.0], 0.117, [0.0, -1.0, 0.3]),
            body(Part::Sun, [0.0, 0.0], 0.035, [1.0, 0.0, 0.0]),
            body(Part::Planet, [0.081, 0.0], 0.041, [0.0, 0.0, 1.0]),
        ];
        let mode = |number: usize| Mode {
            name: format!("{number}: 12345.6 Hz, translational"),
            bodies: bodies.clone(),
        };
        let scene = scene("fan drive, set P, gear slow", &(1..=7).map(mode).collect::<Vec<_>>()).unwrap();
        assert_eq!(overlaps(&scene), vec![]);
        // Two circles and two marks of each body.
        let shapes = scene.items().iter().filter(|item| scene.layer_of(item).name != "labels").count();
        assert_eq!(shapes, 7 * 3 * 4);
    }

    #[test]
    fn the_largest_displacement_has_its_size_on_the_sheet() {
        let only = body(Part::Sun, [0.0, 0.0], 2.0, [0.6, 0.8, 0.0]);
        let scene = scene("one", &[Mode { name: "1".to_owned(), bodies: vec![only] }]).unwrap();
        let centres: Vec<Point> = scene
            .items()
            .iter()
            .filter_map(|item| match item.shape {
                Shape::Circle { centre, radius } => {
                    assert!((radius - RADIUS_MM).abs() < 1e-9);
                    Some(centre)
                }
                _ => None,
            })
            .collect();
        let apart = libm::hypot(centres[1].x - centres[0].x, centres[1].y - centres[0].y);
        assert!((apart - LARGEST * RADIUS_MM).abs() < 1e-9, "{apart}");
    }
}
