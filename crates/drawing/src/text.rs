//! Text, the room that it takes, labels that overlap.
//!
//! Widths are those of Helvetica, which Arial and Liberation Sans share; characters outside its table count as wide ones. Boxes
//! are therefore as wide as the text or a little wider in any of these fonts.

use crate::scene::{Bounds, Point, Scene, Shape, arc_of_side, sides};

/// The fonts that a picture asks for, all of one width.
pub const FONTS: &str = "Arial, Helvetica, 'Liberation Sans', Arimo, sans-serif";

/// Height of capitals over the size of the font.
pub(crate) const CAP_HEIGHT: f64 = 0.716;
/// What reaches below the base line, over the size of the font.
const DESCENT: f64 = 0.21;

/// Where a text stands about its point.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Align {
    /// The point is its left end.
    Left,
    /// The point is its middle.
    #[default]
    Middle,
    /// The point is its right end.
    Right,
}

/// A line of text, its capitals centred on its point in height.
#[derive(Debug, Clone, PartialEq)]
pub struct Text {
    /// The point.
    pub at: Point,
    /// Height of its capitals.
    pub height_mm: f64,
    /// What it says.
    pub content: String,
    /// Where it stands about the point.
    pub align: Align,
    /// Angle of its line about the point.
    pub rotation_rad: f64,
}

impl Text {
    /// Text about its middle.
    #[must_use]
    pub fn new(at: impl Into<Point>, height_mm: f64, content: impl Into<String>) -> Self {
        Self { at: at.into(), height_mm, content: content.into(), align: Align::Middle, rotation_rad: 0.0 }
    }

    /// The same with its point elsewhere.
    #[must_use]
    pub fn align(self, align: Align) -> Self {
        Self { align, ..self }
    }

    /// The same, turned about its point.
    #[must_use]
    pub fn turned(self, rotation_rad: f64) -> Self {
        Self { rotation_rad, ..self }
    }

    /// Size of the font: capitals take 0.716 of it.
    #[must_use]
    pub fn font_size_mm(&self) -> f64 {
        self.height_mm / CAP_HEIGHT
    }

    /// Width.
    #[must_use]
    pub fn width_mm(&self) -> f64 {
        self.content.chars().map(width).sum::<f64>() / 1000.0 * self.font_size_mm()
    }

    /// The box around it.
    #[must_use]
    pub fn bounds(&self) -> Bounds {
        let width = self.width_mm();
        let left = match self.align {
            Align::Left => 0.0,
            Align::Middle => -0.5 * width,
            Align::Right => -width,
        };
        let (low, high) = (-0.5 * self.height_mm - DESCENT * self.font_size_mm(), 0.5 * self.height_mm);
        let (sin, cos) = self.rotation_rad.sin_cos();
        let corners = [[left, low], [left + width, low], [left + width, high], [left, high]];
        Bounds::of(
            corners.map(|[x, y]| Point::new(self.at.x + x * cos - y * sin, self.at.y + x * sin + y * cos)),
        )
    }
}

/// The text without breaks and other controls, which neither file can hold.
pub(crate) fn one_line(text: &str) -> String {
    let refused = |c: char| c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}');
    text.chars().map(|c| if refused(c) { ' ' } else { c }).collect()
}

/// Advance of a character in thousandths of the font's size.
fn width(c: char) -> f64 {
    f64::from(match c {
        'i' | 'j' | 'l' | '\'' | '|' => 222_u16,
        ' ' | '!' | ',' | '.' | '/' | ':' | ';' | '[' | ']' | 'I' | 'f' | 't' | '\\' | '·' | '\u{a0}' => 278,
        '(' | ')' | '-' | 'r' | '`' | '¹' | '²' | '³' => 333,
        '"' => 355,
        '*' => 389,
        '°' => 400,
        'J' | 'c' | 'k' | 's' | 'v' | 'x' | 'y' | 'z' => 500,
        'a' | 'b' | 'd' | 'e' | 'g' | 'h' | 'n' | 'o' | 'p' | 'q' | 'u' | 'L' | '0'..='9' | '?' | '–' => {
            556
        }
        '+' | '<' | '=' | '>' | '~' | '×' | '−' => 584,
        'F' | 'T' | 'Z' => 611,
        'A' | 'B' | 'E' | 'K' | 'P' | 'S' | 'V' | 'X' | 'Y' | '&' => 667,
        'C' | 'D' | 'H' | 'N' | 'R' | 'U' | 'w' => 722,
        'G' | 'O' | 'Q' => 778,
        'M' | 'm' => 833,
        '%' => 889,
        'W' => 944,
        '₀'..='₉' => 400,
        'α'..='ω' => 630,
        _ => 1000,
    })
}

/// What stands in a label's way.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Overlap {
    /// Place of the label among [`Scene::items`].
    pub label: usize,
    /// Place of the label or line that it meets.
    pub with: usize,
}

/// Labels that meet another label, or a line or circle that runs through them; each pair once. Fills do not count.
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
                None => scene.style(item).width_mm > 0.0 && line_meets(&item.shape, bounds),
            };
            if met {
                found.push(Overlap { label: at, with: other });
            }
        }
    }
    found
}

/// Whether a text, with a margin about it, meets nothing that a scene has: no label, line or circle. Fills do not count.
#[must_use]
pub fn is_free(scene: &Scene, text: &Text, margin_mm: f64) -> bool {
    let bounds = text.bounds().grown(margin_mm);
    scene.items().iter().all(|item| match &item.shape {
        Shape::Text(other) => other.content.trim().is_empty() || !bounds.overlaps(other.bounds()),
        shape => scene.style(item).width_mm <= 0.0 || !line_meets(shape, bounds),
    })
}

/// Whether a shape's line runs through the inside of a box; never for text. Arcs are followed in steps of at most 3°.
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
    let arc = |centre: Point, radius: f64, start: f64, sweep: f64| {
        let steps = (sweep.abs() / 0.05).ceil().clamp(1.0, 200.0);
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // 1 to 200
        let point = move |i: u32| Point::polar(centre, radius, start + sweep * f64::from(i) / steps);
        (0..steps as u32).any(|i| segment_meets(point(i), point(i + 1), bounds))
    };
    match shape {
        Shape::Line { from, to } => segment_meets(*from, *to, bounds),
        Shape::Circle { centre, radius } => arc(*centre, *radius, 0.0, std::f64::consts::TAU),
        Shape::Arc { centre, radius, start_rad, sweep_rad } => arc(*centre, *radius, *start_rad, *sweep_rad),
        Shape::Polyline { vertices, closed } => {
            sides(vertices, *closed).any(|(from, to, bulge)| match arc_of_side(from, to, bulge) {
                Some((centre, radius, start, sweep)) => arc(centre, radius, start, sweep),
                None => segment_meets(from, to, bounds),
            })
        }
        Shape::Text(_) => false,
    }
}

/// Whether a straight line runs through the inside of a box: what is left of it between the four sides (Liang and Barsky).
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
    fn the_width_is_that_of_helvetica() {
        assert!((Text::new([0.0, 0.0], 3.58, "00").width_mm() - 5.56).abs() < 1e-9);
    }

    #[test]
    fn the_box_turns_with_the_text() {
        let level = Text::new([0.0, 0.0], 3.0, "ring gear");
        let upright = level.clone().turned(std::f64::consts::FRAC_PI_2);
        assert!((level.bounds().width() - upright.bounds().height()).abs() < 1e-9);
        assert!((level.bounds().height() - upright.bounds().width()).abs() < 1e-9);
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
