//! Text as outlines of Noto Sans, for formats that show it without a font of the system.
//!
//! The widths of labels are those of Helvetica. A line that is wider in this font is compressed to its width,
//! so that labels keep clear of each other. The font lacks subscript digits, which are drawn as small digits;
//! any other missing character is an empty box.

use crate::bounds::Point;
use crate::label::{Align, Text, one_line};
use ttf_parser::{Face, GlyphId, OutlineBuilder};

/// Size of subscript digits over that of digits, and their distance below the line over the size of the font.
const SUBSCRIPT: [f64; 2] = [0.62, 0.14];

/// A step of an outline, in millimetres of the scene.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Step {
    Move(Point),
    Line(Point),
    /// A cubic curve: its control points and its end.
    Curve([Point; 2], Point),
    Close,
}

/// Outlines of a text's letters at their positions.
pub(crate) fn outline(text: &Text) -> Vec<Step> {
    let Ok(face) = Face::parse(ttf_noto_sans::REGULAR, 0) else { return vec![] };
    // Each glyph with its size and its height above the line, over the size of the font.
    let glyph = |c: char| {
        let (c, [size, low]) = match u32::from(c) {
            code @ 0x2080..=0x2089 => (char::from_u32(code - 0x2080 + 0x30).unwrap_or(c), SUBSCRIPT),
            _ => (c, [1.0, 0.0]),
        };
        (face.glyph_index(c).unwrap_or(GlyphId(0)), size, low)
    };
    let em = f64::from(face.units_per_em());
    let advance = |id: GlyphId| f64::from(face.glyph_hor_advance(id).unwrap_or(0)) / em;
    let letters: Vec<(GlyphId, f64, f64)> = one_line(&text.content).chars().map(glyph).collect();
    let wide: f64 = letters.iter().map(|(id, size, _)| size * advance(*id)).sum();
    // The letters are as high as capitals of the text.
    let capitals = face.capital_height().map_or(crate::label::CAP_HEIGHT, |height| f64::from(height) / em);
    let up = text.height_mm / capitals;
    let across = if wide > 0.0 { up.min(text.width_mm() / wide) } else { up };
    let left = across
        * wide
        * match text.align {
            Align::Left => 0.0,
            Align::Middle => -0.5,
            Align::Right => -1.0,
        };
    let mut pen =
        Pen { steps: vec![], at: Point::default(), start: Point::default(), place: Box::new(|point| point) };
    let (sin, cos) = libm::sincos(text.rotation_rad);
    let mut x = left;
    for (id, size, low) in letters {
        let (from, at) = (x, text.at);
        let base = -0.5 * text.height_mm - low * up;
        pen.place = Box::new(move |point: Point| {
            let (along, above) = (from + across * size * point.x / em, base + up * size * point.y / em);
            Point::new(at.x + along * cos - above * sin, at.y + along * sin + above * cos)
        });
        face.outline_glyph(id, &mut pen);
        x += across * size * advance(id);
    }
    pen.steps
}

/// Collects the outlines of glyphs.
struct Pen {
    steps: Vec<Step>,
    /// Position of the pen in units of the font.
    at: Point,
    start: Point,
    place: Box<dyn Fn(Point) -> Point>,
}

fn point(x: f32, y: f32) -> Point {
    Point::new(f64::from(x), f64::from(y))
}

impl OutlineBuilder for Pen {
    fn move_to(&mut self, x: f32, y: f32) {
        (self.at, self.start) = (point(x, y), point(x, y));
        self.steps.push(Step::Move((self.place)(self.at)));
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.at = point(x, y);
        self.steps.push(Step::Line((self.place)(self.at)));
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        // The cubic curve of the same shape has its control points two thirds of the way.
        let (bend, end) = (point(x1, y1), point(x, y));
        let near = |from: Point| {
            Point::new(from.x + 2.0 / 3.0 * (bend.x - from.x), from.y + 2.0 / 3.0 * (bend.y - from.y))
        };
        let bends = [near(self.at), near(end)].map(&self.place);
        self.steps.push(Step::Curve(bends, (self.place)(end)));
        self.at = end;
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        self.at = point(x, y);
        let bends = [point(x1, y1), point(x2, y2)].map(&self.place);
        self.steps.push(Step::Curve(bends, (self.place)(self.at)));
    }

    fn close(&mut self) {
        self.at = self.start;
        self.steps.push(Step::Close);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bounds::Bounds;

    fn bounds(text: &Text) -> Bounds {
        Bounds::of(outline(text).into_iter().filter_map(|step| match step {
            Step::Move(at) | Step::Line(at) | Step::Curve(_, at) => Some(at),
            Step::Close => None,
        }))
    }

    /// Letters keep within the box that their label is given, at every angle and in every alignment.
    #[test]
    fn outlines_keep_within_their_label() {
        for words in ["WIDE letters, 12 mm", "ω₁ = −2.5·k", "carrier Hg", "Ø 40 × 3°"] {
            for align in [Align::Left, Align::Middle, Align::Right] {
                for turn in [0.0, 0.5, std::f64::consts::FRAC_PI_2] {
                    let text = Text::new([10.0, -4.0], 2.5, words).align(align).turned(turn);
                    let (drawn, given) = (bounds(&text), text.bounds().grown(0.35));
                    assert!(
                        !drawn.is_empty() && drawn.with(given) == given,
                        "{words} {turn}: {drawn:?} {given:?}"
                    );
                }
            }
        }
    }

    #[test]
    fn capitals_are_as_high_as_the_text_says() {
        let drawn = bounds(&Text::new([0.0, 0.0], 3.5, "H"));
        assert!((drawn.height() - 3.5).abs() < 0.02 && (drawn.bottom + 1.75).abs() < 0.02, "{drawn:?}");
    }

    #[test]
    fn the_letters_of_the_drawings_have_glyphs() {
        let face = Face::parse(ttf_noto_sans::REGULAR, 0).unwrap();
        for c in ('!'..='~').chain("αβγηΔεδωϕρπΓν−×·°±²³–…Ø".chars()) {
            assert!(face.glyph_index(c).is_some(), "{c}");
        }
    }
}
