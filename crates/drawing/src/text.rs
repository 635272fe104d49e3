//! Text, and labels that overlap.

pub use crate::label::{Align, FONTS, Text};
use crate::scene::{Bounds, Piece, Point, Scene, Shape, arc_of_side, sides};

/// Overlap of a label with another label or a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Overlap {
    /// Place of the label among [`Scene::items`].
    pub label: usize,
    /// Place of the label or line that it meets.
    pub with: usize,
}

/// Labels that meet another label, or a line or circle that runs through them; each pair once. Fills do not
/// count.
#[must_use]
pub fn overlaps(scene: &Scene) -> Vec<Overlap> {
    let items = scene.items();
    let label = |at: usize| match &items[at].shape {
        Shape::Text(text) if !text.content.trim().is_empty() => Some(text.bounds()),
        _ => None,
    };
    let mut found = vec![];
    for (at, bounds) in (0..items.len()).filter_map(|at| Some((at, label(at)?))) {
        for (other, item) in items.iter().enumerate() {
            let met = match label(other) {
                Some(next) => other > at && bounds.overlaps(next),
                // Two labels find each other twice: only the pair with the later one counts.
                None => scene.style(item).width_mm > 0.0 && line_meets(&item.shape, bounds),
            };
            if met {
                found.push(Overlap { label: at, with: other });
            }
        }
    }
    found
}

/// Whether a text, with a margin about it, meets nothing that a scene has: no label, line or circle. Fills do
/// not count.
#[must_use]
pub fn is_free(scene: &Scene, text: &Text, margin_mm: f64) -> bool {
    let bounds = text.bounds().grown(margin_mm);
    scene.items().iter().all(|item| match &item.shape {
        Shape::Text(other) => other.content.trim().is_empty() || !bounds.overlaps(other.bounds()),
        shape => scene.style(item).width_mm <= 0.0 || !line_meets(shape, bounds),
    })
}

/// Whether a shape's line runs through the inside of a box; never for text. Arcs are followed in steps of at
/// most 3°.
///
/// ```
/// use epicyclic_drawing::{Shape, Text, text::line_meets};
///
/// let label = Text::new([0.0, 0.0], 2.5, "K1").bounds();
/// assert!(line_meets(&Shape::line([-9.0, 0.0], [9.0, 0.0]), label));
/// assert!(!line_meets(&Shape::line([-9.0, 5.0], [9.0, 5.0]), label));
/// ```
#[must_use]
pub fn line_meets(shape: &Shape, bounds: Bounds) -> bool {
    let mut meets = false;
    pieces(shape, |from, to| meets = meets || segment_meets(from, to, bounds));
    meets
}

/// The least distance between a straight line and a shape's line, 0 where they cross; infinite of text. Arcs
/// are followed in steps of at most 3°.
///
/// ```
/// use epicyclic_drawing::{Point, Shape, text::distance};
///
/// let level = Shape::line([0.0, 0.0], [9.0, 0.0]);
/// assert_eq!(distance(Point::new(4.0, 3.0), Point::new(4.0, -1.0), &level), 0.0);
/// assert_eq!(distance(Point::new(13.0, 3.0), Point::new(20.0, 3.0), &level), 5.0);
/// ```
#[must_use]
pub fn distance(from: Point, to: Point, shape: &Shape) -> f64 {
    let mut least = f64::INFINITY;
    pieces(shape, |start, end| least = least.min(square_apart([from, to], [start, end])));
    least.sqrt()
}

/// Square of the distance of two straight lines: 0 where they cross, else that of an end from the other line.
/// Only the least of all distances needs a root.
fn square_apart(one: [Point; 2], other: [Point; 2]) -> f64 {
    let aside = |[a, b]: [Point; 2], p: Point| (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    let parted = |line: [Point; 2], ends: [Point; 2]| aside(line, ends[0]) * aside(line, ends[1]) < 0.0;
    if parted(one, other) && parted(other, one) {
        return 0.0;
    }
    // Two lines that do not cross are nearest at an end of one of them.
    let to_line = |[a, b]: [Point; 2], p: Point| {
        let (dx, dy) = (b.x - a.x, b.y - a.y);
        let square = dx * dx + dy * dy;
        let along = if square == 0.0 { 0.0 } else { ((p.x - a.x) * dx + (p.y - a.y) * dy) / square };
        let along = along.clamp(0.0, 1.0);
        let (x, y) = (p.x - a.x - along * dx, p.y - a.y - along * dy);
        x * x + y * y
    };
    let ends = one.map(|end| to_line(other, end)).into_iter().chain(other.map(|end| to_line(one, end)));
    ends.fold(f64::INFINITY, f64::min)
}

/// The straight pieces that a shape's line is followed in, arcs by pieces of at most 3°; none of text.
fn pieces(shape: &Shape, mut each: impl FnMut(Point, Point)) {
    let arc = |centre: Point, radius: f64, start: f64, sweep: f64, each: &mut dyn FnMut(Point, Point)| {
        let steps = (sweep.abs() / 0.05).ceil().clamp(1.0, 200.0);
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // 1 to 200
        let point = |i: u32| Point::polar(centre, radius, start + sweep * f64::from(i) / steps);
        for i in 0..steps as u32 {
            each(point(i), point(i + 1));
        }
    };
    match shape {
        Shape::Line { from, to } => each(*from, *to),
        Shape::Circle { centre, radius } => arc(*centre, *radius, 0.0, std::f64::consts::TAU, &mut each),
        Shape::Arc { centre, radius, start_rad, sweep_rad } => {
            arc(*centre, *radius, *start_rad, *sweep_rad, &mut each);
        }
        Shape::Polyline { vertices, closed } => {
            for (from, to, bulge) in sides(vertices, *closed) {
                match arc_of_side(from, to, bulge) {
                    Some((centre, radius, start, sweep)) => arc(centre, radius, start, sweep, &mut each),
                    None => each(from, to),
                }
            }
        }
        Shape::Contour(pieces) => {
            for piece in pieces {
                match *piece {
                    Piece::Arc { centre, radius, start_rad, sweep_rad } => {
                        arc(centre, radius, start_rad, sweep_rad, &mut each);
                    }
                    // Its control polygon, which lies around it.
                    Piece::Cubic(points) => points.windows(2).for_each(|ends| each(ends[0], ends[1])),
                }
            }
        }
        Shape::Text(_) => {}
    }
}

/// Whether a straight line runs through the inside of a box: what is left of it between the four sides (Liang
/// and Barsky).
fn segment_meets(from: Point, to: Point, bounds: Bounds) -> bool {
    let (dx, dy) = (to.x - from.x, to.y - from.y);
    let mut part = (0.0_f64, 1.0_f64);
    for (step, room) in [
        (-dx, from.x - bounds.left),
        (dx, bounds.right - from.x),
        (-dy, from.y - bounds.bottom),
        (dy, bounds.top - from.y),
    ] {
        if step == 0.0 {
            if room <= 0.0 {
                return false;
            }
        } else if step < 0.0 {
            part.0 = part.0.max(room / step);
        } else {
            part.1 = part.1.min(room / step);
        }
    }
    part.0 < part.1
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::style::{Color, Style};

    fn met(first: Shape, second: Shape) -> usize {
        let mut scene = Scene::new("two");
        let layer = scene.layer("all", Style::line(0.2)).unwrap();
        scene.add(layer, first);
        scene.add(layer, second);
        overlaps(&scene).len()
    }

    fn label(x: f64) -> Shape {
        Text::new([x, 0.0], 3.58, "00").into() // font of 5 mm: 5.56 mm wide
    }

    #[test]
    fn labels_meet_labels_and_lines_but_no_fills() {
        assert_eq!(met(label(0.0), label(5.5)), 1);
        assert_eq!(met(label(0.0), label(5.6)), 0);
        assert_eq!(met(label(0.0), Shape::line([-9.0, 0.0], [9.0, 0.5])), 1);
        assert_eq!(met(label(0.0), Shape::line([-9.0, 4.0], [9.0, 4.0])), 0);
        let around = Shape::Circle { centre: Point::new(0.0, 0.0), radius: 9.0 };
        assert_eq!(met(label(0.0), around.clone()), 0);
        assert_eq!(met(label(9.0), around.clone()), 1);
        let mut scene = Scene::new("fill");
        let layer = scene.layer("fill", Style::filled(Color::GREY)).unwrap();
        scene.add(layer, around);
        scene.add(layer, label(9.0));
        assert!(overlaps(&scene).is_empty());
    }

    #[test]
    fn a_place_is_free_where_the_label_would_overlap_nothing() {
        let mut scene = Scene::new("room");
        let layer = scene.layer("all", Style::line(0.2)).unwrap();
        scene.add(layer, label(0.0));
        let text = |x: f64| Text::new([x, 0.0], 3.58, "00");
        assert!(!is_free(&scene, &text(5.5), 0.0));
        assert!(is_free(&scene, &text(5.6), 0.0) && !is_free(&scene, &text(5.6), 0.1));
        scene.add(layer, Shape::line([9.0, -9.0], [9.0, 9.0]));
        assert!(!is_free(&scene, &text(8.0), 0.0));
    }
}
