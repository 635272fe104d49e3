//! Common parts of the pictures of a motor: layers, sizes, text, and labels where they have room.

use epicyclic_drawing::{Align, Color, LayerId, Point, Scene, Shape, Style, Text, text};
use epicyclic_hydromotor::{Motor, MotorNumbers};
use epicyclic_units::Physical;
use uom::si::f64::Length;

use super::curve::Outline;
use crate::Error;

/// High pressure.
pub(super) const HIGH: Color = Color::new(200, 50, 47);
/// Low pressure.
pub(super) const LOW: Color = Color::new(38, 110, 184);
/// Pressure that is neither high nor low.
pub(super) const IDLE: Color = Color::new(150, 150, 150);
/// Bodies.
pub(super) const STEEL: Color = Color::new(226, 229, 233);
/// Auxiliary lines of a construction.
pub(super) const AUXILIARY: Color = Color::new(120, 120, 120);

/// A picture of a motor in the making.
#[derive(Debug)]
pub(super) struct Sheet {
    pub(super) scene: Scene,
    /// Unit of the sizes of text and lines: a hundredth of the stator's greatest diameter, or of a picture's
    /// width.
    pub(super) unit: f64,
    words: Option<LayerId>,
    pen: Point,
}

impl Sheet {
    pub(super) fn new(motor: &Motor, view: &str) -> Self {
        let unit = motor.envelope().stator_outer.mm() / 100.0;
        Self::of(&name(motor.numbers(), motor.module()), view, unit)
    }

    /// Sheet for the motor with this name.
    pub(super) fn of(name: &str, view: &str, unit: f64) -> Self {
        let title = format!("{name}: {view}");
        Self { scene: Scene::new(title), unit, words: None, pen: Point::default() }
    }

    /// Adds a layer; the width of its line is in units of the sheet.
    pub(super) fn layer(&mut self, name: &str, style: Style) -> Result<LayerId, Error> {
        let style = style.width(style.width_mm * self.unit);
        Ok(self.scene.layer(name, style)?)
    }

    pub(super) fn outline(&mut self, layer: LayerId, outline: Outline) {
        self.scene.add(layer, Shape::Polyline { vertices: outline.vertices, closed: true });
    }

    pub(super) fn circle(&mut self, layer: LayerId, centre: Point, radius: f64) {
        self.scene.add(layer, Shape::Circle { centre, radius });
    }

    pub(super) fn line(&mut self, layer: LayerId, from: Point, to: Point) {
        self.scene.add(layer, Shape::line(from, to));
    }

    /// An arrowhead at a point, pointing in a direction.
    pub(super) fn arrowhead(&mut self, layer: LayerId, tip: Point, direction_rad: f64) {
        let wing = |side: f64| Point::polar(tip, 2.0 * self.unit, direction_rad + side);
        let (one, other) = (wing(std::f64::consts::PI - 0.25), wing(std::f64::consts::PI + 0.25));
        self.scene.add(layer, Shape::polyline([one, tip, other]));
    }

    /// Height of the letters.
    pub(super) fn letter(&self) -> f64 {
        2.2 * self.unit
    }

    /// Opens the column of words to the right of what has been drawn; its heading is the motor's name.
    pub(super) fn column(&mut self, motor: &Motor) -> Result<(), Error> {
        let bounds = self.scene.bounds();
        let pen = Point::new(bounds.right + 6.0 * self.unit, bounds.top - self.letter());
        self.open(pen, &name(motor.numbers(), motor.module()))
    }

    /// Opens a column of words below a heading.
    pub(super) fn open(&mut self, pen: Point, heading: &str) -> Result<(), Error> {
        let layer = match self.words {
            Some(layer) => layer,
            None => self.layer("words", Style::line(0.15))?,
        };
        self.words = Some(layer);
        self.pen = pen;
        let height = 1.25 * self.letter();
        self.write(layer, height, heading);
        self.pen.y -= self.letter();
        Ok(())
    }

    /// A line of the column.
    pub(super) fn say(&mut self, words: &str) {
        if let Some(layer) = self.words {
            self.write(layer, self.letter(), words);
        }
    }

    /// A line of the column behind a patch of colour.
    pub(super) fn legend(&mut self, color: Color, words: &str) {
        if let Some(layer) = self.words {
            let (x, y, side) = (self.pen.x, self.pen.y, self.letter());
            let patch = Shape::rectangle([x, y - 0.5 * side], [x + 1.5 * side, y + 0.5 * side]);
            self.scene.add_styled(layer, Style::filled(color), patch);
            self.pen.x += 2.2 * side;
            self.write(layer, side, words);
            self.pen.x = x;
        }
    }

    /// Room between paragraphs.
    pub(super) fn skip(&mut self) {
        self.pen.y -= self.letter();
    }

    fn write(&mut self, layer: LayerId, height: f64, words: &str) {
        self.scene.add(layer, Text::new(self.pen, height, words).align(Align::Left));
        self.pen.y -= 1.8 * height;
    }

    /// Writes a label near a point, at the first free place around it. Returns whether a place was free.
    pub(super) fn label(&mut self, layer: LayerId, at: Point, words: &str) -> bool {
        let height = self.letter();
        let around = [1.6, 2.4, 3.4, 4.6].into_iter().flat_map(move |ring| {
            (0..16).map(move |step| {
                Point::polar(at, ring * height, std::f64::consts::TAU * (f64::from(step) + 2.0) / 16.0)
            })
        });
        self.label_at(layer, around, words)
    }

    /// Words at the first of the places where they meet no line and no letter.
    pub(super) fn label_at(
        &mut self,
        layer: LayerId,
        places: impl IntoIterator<Item = Point>,
        words: &str,
    ) -> bool {
        let height = self.letter();
        let mut texts = places.into_iter().map(|place| Text::new(place, height, words));
        let Some(text) = texts.find(|text| text::is_free(&self.scene, text, 0.25 * height)) else {
            return false;
        };
        self.scene.add(layer, text);
        true
    }
}

/// `5×3, 55/33/10 teeth, module 2 mm`.
pub(super) fn name(numbers: MotorNumbers, module: Length) -> String {
    format!(
        "{}×{}, {}/{}/{} teeth, module {}",
        numbers.stator_lobes(),
        numbers.rotor_lobes(),
        numbers.stator_teeth(),
        numbers.rotor_teeth(),
        numbers.satellite_teeth(),
        millimetres(module.mm())
    )
}

/// A length to five significant digits, as drawings write it.
pub(super) fn millimetres(value_mm: f64) -> String {
    format!("{} mm", number(value_mm))
}

/// Five significant digits, without trailing zeros.
pub(super) fn number(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return value.abs().to_string();
    }
    let before = libm::log10(value.abs()).floor().clamp(-9.0, 9.0) as i32;
    let decimals = usize::try_from(4 - before).unwrap_or(0);
    let text = format!("{value:.decimals$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

#[cfg(test)]
mod tests {
    use super::number;

    #[test]
    fn numbers_have_five_digits() {
        for (value, shown) in [
            (2.0, "2"),
            (15.306_31, "15.306"),
            (0.001_234_567, "0.0012346"),
            (123_456.0, "123456"),
            (0.0, "0"),
        ] {
            assert_eq!(number(value), shown);
        }
    }
}
