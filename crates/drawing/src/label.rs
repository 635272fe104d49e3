//! A line of text and the room that it takes.
//!
//! Widths are those of Helvetica, which Arial and Liberation Sans share; characters outside its table count
//! as wide ones. Boxes are therefore as wide as the text or a little wider in any of these fonts.

use crate::bounds::{Bounds, Point};

/// Fonts of the pictures, all of one width.
pub const FONTS: &str = "Arial, Helvetica, 'Liberation Sans', Arimo, sans-serif";

/// Height of capitals over the size of the font.
pub(crate) const CAP_HEIGHT: f64 = 0.716;
/// Letters of a line that no font makes much longer.
const LONG: usize = 4;

/// Height of the parts below the base line, over the size of the font.
const DESCENT: f64 = 0.21;

/// Alignment of a text to its point.
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
    /// The characters of the line.
    pub content: String,
    /// Alignment to the point.
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

    /// Text with another alignment to its point.
    #[must_use]
    pub fn align(self, align: Align) -> Self {
        Self { align, ..self }
    }

    /// Text turned about its point.
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

    /// Width of a line that a wider font would make longer than it may be: of those that have some letters,
    /// each of a width that is known.
    pub(crate) fn fixed_width_mm(&self) -> Option<f64> {
        let is_long = self.content.chars().nth(LONG).is_some();
        (is_long && self.content.chars().all(|c| known(c).is_some())).then(|| self.width_mm())
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
        let (sin, cos) = libm::sincos(self.rotation_rad);
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
    f64::from(known(c).unwrap_or(1000))
}

/// Advance of a character in the table of Helvetica, or of one whose width is much the same in its fonts.
fn known(c: char) -> Option<u16> {
    Some(match c {
        'i' | 'j' | 'l' | '\'' | '|' => 222,
        ' ' | '!' | ',' | '.' | '/' | ':' | ';' | '[' | ']' | 'I' | 'f' | 't' | '\\' | '·' | '\u{a0}' => 278,
        '(' | ')' | '-' | 'r' | '`' | '¹' | '²' | '³' => 333,
        '"' => 355,
        '*' => 389,
        '°' => 400,
        'J' | 'c' | 'k' | 's' | 'v' | 'x' | 'y' | 'z' => 500,
        'a'
        | 'b'
        | 'd'
        | 'e'
        | 'g'
        | 'h'
        | 'n'
        | 'o'
        | 'p'
        | 'q'
        | 'u'
        | 'L'
        | '0'..='9'
        | '?'
        | '–'
        | '_' => 556,
        '+' | '<' | '=' | '>' | '~' | '×' | '−' => 584,
        'F' | 'T' | 'Z' => 611,
        'A' | 'B' | 'E' | 'K' | 'P' | 'S' | 'V' | 'X' | 'Y' | '&' => 667,
        'C' | 'D' | 'H' | 'N' | 'R' | 'U' | 'w' => 722,
        'G' | 'O' | 'Q' | 'Ø' => 778,
        'M' | 'm' => 833,
        '%' => 889,
        'W' => 944,
        '₀'..='₉' => 400,
        'α'..='ω' => 630,
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

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
}
