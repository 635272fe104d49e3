//! Colours, line widths and dashes.

/// A colour by its red, green and blue parts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Color {
    /// Red.
    pub red: u8,
    /// Green.
    pub green: u8,
    /// Blue.
    pub blue: u8,
}

impl Color {
    /// Black.
    pub const BLACK: Self = Self::new(0, 0, 0);
    /// White.
    pub const WHITE: Self = Self::new(255, 255, 255);
    /// Grey of auxiliary lines.
    pub const GREY: Self = Self::new(128, 128, 128);

    /// Colour from its channels.
    #[must_use]
    pub const fn new(red: u8, green: u8, blue: u8) -> Self {
        Self { red, green, blue }
    }

    /// Colour at `part` of the way from this to another, each channel separately; `part` outside 0…1 means
    /// the nearer end.
    #[must_use]
    pub fn towards(self, other: Self, part: f64) -> Self {
        let part = if part.is_nan() { 0.0 } else { part.clamp(0.0, 1.0) };
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // between two u8
        let mix = |a: u8, b: u8| (f64::from(a) + part * (f64::from(b) - f64::from(a))).round() as u8;
        Self::new(mix(self.red, other.red), mix(self.green, other.green), mix(self.blue, other.blue))
    }

    /// Colour as SVG and CSS write it, `#rrggbb`.
    #[must_use]
    pub fn hex(self) -> String {
        format!("#{:02x}{:02x}{:02x}", self.red, self.green, self.blue)
    }
}

/// Dashes of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Dash {
    /// Without breaks.
    #[default]
    Solid,
    /// Dashes: hidden or removed.
    Dashed,
    /// Long dashes and dots: axes and pitch curves.
    DashDot,
    /// Dots.
    Dotted,
}

impl Dash {
    /// Lengths of dash, gap, dash, gap… in millimetres; empty for a solid line. A dot is a dash of 0.2 mm.
    #[must_use]
    pub const fn pattern_mm(self) -> &'static [f64] {
        match self {
            Self::Solid => &[],
            Self::Dashed => &[3.0, 1.5],
            Self::DashDot => &[6.0, 1.0, 0.5, 1.0],
            Self::Dotted => &[0.2, 0.8],
        }
    }
}

/// Style of a shape.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Style {
    /// Colour of lines and text.
    pub color: Color,
    /// Width of lines in millimetres; 0 draws no line.
    pub width_mm: f64,
    /// Dashes of the line.
    pub dash: Dash,
    /// Colour that a closed shape is filled with. SVG only: in DXF a fill is its outline.
    pub fill: Option<Color>,
}

impl Style {
    /// A solid black line.
    #[must_use]
    pub const fn line(width_mm: f64) -> Self {
        Self { color: Color::BLACK, width_mm, dash: Dash::Solid, fill: None }
    }

    /// A thin grey line of dashes and dots.
    #[must_use]
    pub const fn centre_line() -> Self {
        Self { color: Color::GREY, width_mm: 0.18, dash: Dash::DashDot, fill: None }
    }

    /// A filled shape without a line.
    #[must_use]
    pub const fn filled(color: Color) -> Self {
        Self { color, width_mm: 0.0, dash: Dash::Solid, fill: Some(color) }
    }

    /// Style in another colour.
    #[must_use]
    pub const fn color(self, color: Color) -> Self {
        Self { color, ..self }
    }

    /// Style with another line width.
    #[must_use]
    pub const fn width(self, width_mm: f64) -> Self {
        Self { width_mm, ..self }
    }

    /// Style with other dashes.
    #[must_use]
    pub const fn dash(self, dash: Dash) -> Self {
        Self { dash, ..self }
    }

    /// Style with a fill.
    #[must_use]
    pub const fn fill(self, fill: Color) -> Self {
        Self { fill: Some(fill), ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_mix_by_channel_and_write_as_hex() {
        let half = Color::BLACK.towards(Color::new(255, 100, 0), 0.5);
        assert_eq!(half, Color::new(128, 50, 0));
        assert_eq!(half.hex(), "#803200");
        assert_eq!(Color::BLACK.towards(Color::WHITE, f64::NAN), Color::BLACK);
        assert_eq!(Color::BLACK.towards(Color::WHITE, 7.0), Color::WHITE);
    }
}
