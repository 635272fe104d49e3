//! The scene as a DXF drawing in millimetres, for CAD.
//!
//! AutoCAD 2000 (`AC1015`): the oldest version with `LWPOLYLINE`, line weights and units, and one that every
//! reader takes. Lines, circles, arcs and text become entities of their kind, polylines `LWPOLYLINE` with
//! bulges; contours become `ARC` and, of their curves, cubic `SPLINE`; layers keep name, colour and dashes.
//! Fills are left out: a filled shape is its outline. The same scene gives the same text: no time and no
//! random number is in it.
//!
//! # Source
//! Autodesk, *DXF Reference*, AutoCAD 2000. Read back in the tests by an independent reader.

use std::fmt::{Display, Write};

use crate::error::Error;
use crate::label::{Align, Text, one_line};
use crate::scene::{Item, Piece, Point, Scene, Shape};
use crate::style::{Color, Dash, Style};
use crate::tolerance::SMOOTH;

/// Handles of what every drawing has.
mod handle {
    pub(super) const VPORT: u32 = 0x1;
    pub(super) const LTYPE: u32 = 0x2;
    pub(super) const LAYER: u32 = 0x3;
    pub(super) const STYLE: u32 = 0x4;
    pub(super) const VIEW: u32 = 0x5;
    pub(super) const UCS: u32 = 0x6;
    pub(super) const APPID: u32 = 0x7;
    pub(super) const DIMSTYLE: u32 = 0x8;
    pub(super) const BLOCK_RECORD: u32 = 0x9;
    pub(super) const DICTIONARY: u32 = 0xA;
    pub(super) const GROUPS: u32 = 0xB;
    pub(super) const MODEL: u32 = 0xC;
    pub(super) const PAPER: u32 = 0xD;
    pub(super) const FIRST_FREE: u32 = 0x10;
}

/// The scene as a DXF drawing.
///
/// # Errors
/// As [`Scene::check`].
pub fn write(scene: &Scene) -> Result<String, Error> {
    scene.check()?;
    // The body first: the header states the next free handle.
    let mut body = Writer { text: String::new(), next: handle::FIRST_FREE };
    body.tables(scene);
    body.blocks();
    body.section("ENTITIES", |to| scene.items().iter().for_each(|item| to.entity(scene, item)));
    body.section("OBJECTS", Writer::objects);
    body.pair(0, "EOF");
    let mut head = Writer { text: String::new(), next: 0 };
    head.pair(999, encoded(scene.title()));
    head.header(scene, body.next);
    Ok(head.text + &body.text)
}

struct Writer {
    text: String,
    next: u32,
}

impl Writer {
    fn pair(&mut self, code: u16, value: impl Display) {
        // Writing to a string cannot fail.
        let _ = writeln!(self.text, "{code:>3}\n{value}");
    }

    fn number(&mut self, code: u16, value: f64) {
        // To 1e-9 mm; a plain decimal number, with a point.
        let value = if value == 0.0 { 0.0 } else { value };
        let text = format!("{value:.9}");
        let text = text.trim_end_matches('0');
        let text = if text.ends_with('.') { format!("{text}0") } else { text.to_owned() };
        self.pair(code, text);
    }

    fn point(&mut self, code: u16, x: f64, y: f64) {
        self.number(code, x);
        self.number(code + 10, y);
        self.number(code + 20, 0.0);
    }

    fn handle(&mut self, code: u16, handle: u32) {
        self.pair(code, format_args!("{handle:X}"));
    }

    fn fresh(&mut self) -> u32 {
        self.next += 1;
        self.next - 1
    }

    fn section(&mut self, name: &str, write: impl FnOnce(&mut Self)) {
        self.pair(0, "SECTION");
        self.pair(2, name);
        write(self);
        self.pair(0, "ENDSEC");
    }

    fn header(&mut self, scene: &Scene, next_handle: u32) {
        let bounds = scene.bounds();
        let bounds = if bounds.is_empty() { Shape::line([0.0, 0.0], [0.0, 0.0]).bounds() } else { bounds };
        self.section("HEADER", |to| {
            to.pair(9, "$ACADVER");
            to.pair(1, "AC1015");
            to.pair(9, "$DWGCODEPAGE");
            to.pair(3, "ANSI_1252");
            to.pair(9, "$INSUNITS");
            to.pair(70, 4); // millimetres
            to.pair(9, "$MEASUREMENT");
            to.pair(70, 1); // metric
            to.pair(9, "$EXTMIN");
            to.point(10, bounds.left, bounds.bottom);
            to.pair(9, "$EXTMAX");
            to.point(10, bounds.right, bounds.top);
            to.pair(9, "$LTSCALE");
            to.number(40, 1.0);
            to.pair(9, "$HANDSEED");
            to.handle(5, next_handle);
        });
    }

    fn table(&mut self, name: &str, own: u32, count: usize, write: impl FnOnce(&mut Self)) {
        self.pair(0, "TABLE");
        self.pair(2, name);
        self.handle(5, own);
        self.handle(330, 0);
        self.pair(100, "AcDbSymbolTable");
        self.pair(70, count);
        write(self);
        self.pair(0, "ENDTAB");
    }

    fn record(&mut self, kind: &str, own: Option<u32>, table: u32, subclass: &str, name: &str) {
        let own = own.unwrap_or_else(|| self.fresh());
        self.pair(0, kind);
        self.handle(if kind == "DIMSTYLE" { 105 } else { 5 }, own);
        self.handle(330, table);
        self.pair(100, "AcDbSymbolTableRecord");
        self.pair(100, subclass);
        self.pair(2, name);
        if kind != "BLOCK_RECORD" {
            self.pair(70, 0);
        }
    }

    fn tables(&mut self, scene: &Scene) {
        self.section("TABLES", |to| {
            to.table("VPORT", handle::VPORT, 1, |to| to.view_port(scene));
            let dashes = [Dash::Dashed, Dash::DashDot, Dash::Dotted];
            to.table("LTYPE", handle::LTYPE, 3 + dashes.len(), |to| {
                for name in ["ByBlock", "ByLayer", "Continuous"] {
                    to.line_type(name, "", &[]);
                }
                for dash in dashes {
                    let (name, picture) = line_type(dash);
                    to.line_type(name, picture, dash.pattern_mm());
                }
            });
            to.table("LAYER", handle::LAYER, 1 + scene.layers().len(), |to| {
                to.layer("0", Style::line(0.25));
                for layer in scene.layers() {
                    to.layer(&encoded(&layer.name), layer.style);
                }
            });
            to.table("STYLE", handle::STYLE, 1, |to| {
                to.record("STYLE", None, handle::STYLE, "AcDbTextStyleTableRecord", "Standard");
                to.number(40, 0.0);
                to.number(41, 1.0);
                to.number(50, 0.0);
                to.pair(71, 0);
                to.number(42, 2.5);
                to.pair(3, "arial.ttf");
                to.pair(4, "");
            });
            to.table("VIEW", handle::VIEW, 0, |_| {});
            to.table("UCS", handle::UCS, 0, |_| {});
            to.table("APPID", handle::APPID, 1, |to| {
                to.record("APPID", None, handle::APPID, "AcDbRegAppTableRecord", "ACAD");
            });
            to.table("DIMSTYLE", handle::DIMSTYLE, 1, |to| {
                to.pair(100, "AcDbDimStyleTable");
                to.pair(71, 0);
                to.record("DIMSTYLE", None, handle::DIMSTYLE, "AcDbDimStyleTableRecord", "Standard");
            });
            to.table("BLOCK_RECORD", handle::BLOCK_RECORD, 2, |to| {
                for (own, name) in [(handle::MODEL, "*Model_Space"), (handle::PAPER, "*Paper_Space")] {
                    to.record("BLOCK_RECORD", Some(own), handle::BLOCK_RECORD, "AcDbBlockTableRecord", name);
                    to.handle(340, 0);
                }
            });
        });
    }

    /// The window in which a CAD program opens the drawing: all of it.
    fn view_port(&mut self, scene: &Scene) {
        let bounds = scene.bounds();
        let (x, y, height) = if bounds.is_empty() {
            (0.0, 0.0, 100.0)
        } else {
            let height = bounds.height().max(0.6 * bounds.width()).max(1.0);
            (0.5 * (bounds.left + bounds.right), 0.5 * (bounds.bottom + bounds.top), 1.1 * height)
        };
        self.record("VPORT", None, handle::VPORT, "AcDbViewportTableRecord", "*Active");
        for (code, [x, y]) in [(10, [0.0, 0.0]), (11, [1.0, 1.0]), (12, [x, y])] {
            self.number(code, x);
            self.number(code + 10, y);
        }
        self.number(40, height);
        self.number(41, 1.5);
    }

    fn line_type(&mut self, name: &str, picture: &str, pattern: &[f64]) {
        self.record("LTYPE", None, handle::LTYPE, "AcDbLinetypeTableRecord", name);
        self.pair(3, picture);
        self.pair(72, 65);
        self.pair(73, pattern.len());
        self.number(40, pattern.iter().sum());
        for (at, length) in pattern.iter().enumerate() {
            // A gap is a negative dash.
            self.number(49, if at % 2 == 0 { *length } else { -length });
            self.pair(74, 0);
        }
    }

    fn layer(&mut self, name: &str, style: Style) {
        self.record("LAYER", None, handle::LAYER, "AcDbLayerTableRecord", name);
        self.pair(62, color_of(style));
        self.pair(6, line_type(style.dash).0);
        self.pair(370, line_weight(style.width_mm));
        self.handle(390, 0);
    }

    fn blocks(&mut self) {
        self.section("BLOCKS", |to| {
            for (own, name) in [(handle::MODEL, "*Model_Space"), (handle::PAPER, "*Paper_Space")] {
                for (kind, subclass) in [("BLOCK", "AcDbBlockBegin"), ("ENDBLK", "AcDbBlockEnd")] {
                    let fresh = to.fresh();
                    to.pair(0, kind);
                    to.handle(5, fresh);
                    to.handle(330, own);
                    to.pair(100, "AcDbEntity");
                    if own == handle::PAPER {
                        to.pair(67, 1);
                    }
                    to.pair(8, "0");
                    to.pair(100, subclass);
                    if kind == "BLOCK" {
                        to.pair(2, name);
                        to.pair(70, 0);
                        to.point(10, 0.0, 0.0);
                        to.pair(3, name);
                        to.pair(1, "");
                    }
                }
            }
        });
    }

    fn objects(&mut self) {
        let dictionary = |to: &mut Self, own: u32, owner: u32| {
            to.pair(0, "DICTIONARY");
            to.handle(5, own);
            to.handle(330, owner);
            to.pair(100, "AcDbDictionary");
            to.pair(281, 1);
        };
        dictionary(self, handle::DICTIONARY, 0);
        self.pair(3, "ACAD_GROUP");
        self.handle(350, handle::GROUPS);
        dictionary(self, handle::GROUPS, handle::DICTIONARY);
    }

    /// Groups that every entity of a shape begins with.
    fn begin(&mut self, kind: &str, scene: &Scene, item: &Item) {
        let own = self.fresh();
        self.pair(0, kind);
        self.handle(5, own);
        self.handle(330, handle::MODEL);
        self.pair(100, "AcDbEntity");
        self.pair(8, encoded(&scene.layers()[item.layer.0].name));
        if let Some(style) = item.style {
            self.pair(62, color_of(style));
            self.pair(6, line_type(style.dash).0);
            self.pair(370, line_weight(style.width_mm));
        }
    }

    fn entity(&mut self, scene: &Scene, item: &Item) {
        match &item.shape {
            Shape::Line { from, to } => {
                self.begin("LINE", scene, item);
                self.pair(100, "AcDbLine");
                self.point(10, from.x, from.y);
                self.point(11, to.x, to.y);
            }
            Shape::Circle { centre, radius } => {
                self.begin("CIRCLE", scene, item);
                self.pair(100, "AcDbCircle");
                self.point(10, centre.x, centre.y);
                self.number(40, *radius);
            }
            Shape::Arc { centre, radius, start_rad, sweep_rad } => {
                self.begin("ARC", scene, item);
                self.arc(*centre, *radius, [*start_rad, start_rad + sweep_rad]);
            }
            Shape::Polyline { vertices, closed } => {
                self.begin("LWPOLYLINE", scene, item);
                self.pair(100, "AcDbPolyline");
                self.pair(90, vertices.len());
                self.pair(70, u8::from(*closed));
                for vertex in vertices {
                    self.number(10, vertex.at.x);
                    self.number(20, vertex.at.y);
                    if vertex.bulge != 0.0 {
                        self.number(42, vertex.bulge);
                    }
                }
            }
            Shape::Contour(pieces) => {
                for run in pieces.chunk_by(goes_on) {
                    match *run {
                        [Piece::Arc { centre, radius, start_rad, sweep_rad }] => {
                            self.begin("ARC", scene, item);
                            self.arc(centre, radius, [start_rad, start_rad + sweep_rad]);
                        }
                        _ => {
                            self.begin("SPLINE", scene, item);
                            self.spline(run);
                        }
                    }
                }
            }
            Shape::Text(text) => {
                self.begin("TEXT", scene, item);
                self.label(text);
            }
        }
    }

    fn arc(&mut self, centre: Point, radius: f64, ends_rad: [f64; 2]) {
        self.pair(100, "AcDbCircle");
        self.point(10, centre.x, centre.y);
        self.number(40, radius);
        self.pair(100, "AcDbArc");
        // Always counter-clockwise, in degrees.
        let [from, to] = ends_rad.map(f64::to_degrees);
        let [from, to] = if to < from { [to, from] } else { [from, to] };
        self.number(50, from.rem_euclid(360.0));
        self.number(51, to.rem_euclid(360.0));
    }

    /// Cubic curves that go smoothly over into each other, as one spline. Where two meet, a double knot
    /// leaves out their common point: it lies between its neighbours as the knots say.
    fn spline(&mut self, curves: &[Piece]) {
        let mut points: Vec<Point> = curves.first().map(Piece::start).into_iter().collect();
        let (mut knots, mut knot) = (vec![0.0; 4], 0.0);
        let mut before: Option<([Point; 2], f64)> = None;
        for piece in curves {
            let Piece::Cubic([start, one, other, end]) = *piece else { continue };
            let length = before.map_or(1.0, |([handle, joint], length)| {
                // Equal speeds along both curves where they meet.
                points.pop();
                knots.push(knot);
                length * apart(start, one) / apart(handle, joint)
            });
            points.extend([one, other, end]);
            knot += length;
            knots.push(knot);
            before = Some(([other, end], length));
        }
        knots.extend([knot; 3]);
        self.pair(100, "AcDbSpline");
        self.number(210, 0.0);
        self.number(220, 0.0);
        self.number(230, 1.0);
        self.pair(70, 8); // in a plane
        self.pair(71, 3);
        self.pair(72, knots.len());
        self.pair(73, points.len());
        self.pair(74, 0);
        // Knots are numbers without a unit, and need all their digits.
        knots.into_iter().for_each(|knot| self.pair(40, format_args!("{knot:?}")));
        points.into_iter().for_each(|point| self.point(10, point.x, point.y));
    }

    fn label(&mut self, text: &Text) {
        let left = text.width_mm()
            * match text.align {
                Align::Left => 0.0,
                Align::Middle => 0.5,
                Align::Right => 1.0,
            };
        let (sin, cos) = libm::sincos(text.rotation_rad);
        let low = 0.5 * text.height_mm;
        self.pair(100, "AcDbText");
        self.point(10, text.at.x - left * cos + low * sin, text.at.y - left * sin - low * cos);
        self.number(40, text.height_mm);
        self.pair(1, encoded(&text.content));
        self.number(50, text.rotation_rad.to_degrees());
        self.pair(7, "Standard");
        let horizontal = match text.align {
            Align::Left => 0,
            Align::Middle => 1,
            Align::Right => 2,
        };
        self.pair(72, horizontal);
        self.point(11, text.at.x, text.at.y);
        self.pair(100, "AcDbText");
        self.pair(73, 2); // middle in height
    }
}

fn apart(one: Point, other: Point) -> f64 {
    libm::hypot(other.x - one.x, other.y - one.y)
}

/// Whether two pieces are curves that have a tangent in common where they meet.
fn goes_on(one: &Piece, next: &Piece) -> bool {
    let (Piece::Cubic([.., handle, end]), Piece::Cubic([start, first, ..])) = (one, next) else {
        return false;
    };
    let (reach, length) = (apart(*handle, *end), apart(*start, *first));
    let [x1, y1] = [end.x - handle.x, end.y - handle.y];
    let [x2, y2] = [first.x - start.x, first.y - start.y];
    let (ahead, across) = (x1 * x2 + y1 * y2, x1 * y2 - y1 * x2);
    // Without a tangent at the end of one of them there is no knot between them.
    reach.min(length) > SMOOTH * reach.max(length) && ahead > 0.0 && across.abs() < SMOOTH * ahead
}

/// Text in ASCII: other characters as `\U+XXXX`, those beyond the first plane as `?`. The reader does not
/// know the code page of the file.
fn encoded(text: &str) -> String {
    let mut out = String::new();
    for c in one_line(text).chars() {
        match u32::from(c) {
            0x20..=0x7e => out.push(c),
            code @ 0x7f..=0xffff => {
                let _ = write!(out, "\\U+{code:04X}");
            }
            _ => out.push('?'),
        }
    }
    out
}

/// Name and picture of a line type.
fn line_type(dash: Dash) -> (&'static str, &'static str) {
    match dash {
        Dash::Solid => ("Continuous", ""),
        Dash::Dashed => ("DASHED", "__ __ __ __"),
        Dash::DashDot => ("CENTER", "____ _ ____ _"),
        Dash::Dotted => ("DOT", ". . . . . ."),
    }
}

/// The nearest line weight that DXF has, in hundredths of a millimetre.
fn line_weight(width_mm: f64) -> u16 {
    const WEIGHTS: [u16; 24] =
        [0, 5, 9, 13, 15, 18, 20, 25, 30, 35, 40, 50, 53, 60, 70, 80, 90, 100, 106, 120, 140, 158, 200, 211];
    let distance = |weight: u16| (f64::from(weight) - 100.0 * width_mm).abs();
    WEIGHTS.into_iter().min_by(|a, b| distance(*a).total_cmp(&distance(*b))).unwrap_or(25)
}

/// The colour of a style: that of its line, of a mere fill that of the fill.
fn color_of(style: Style) -> u16 {
    color_index(if style.width_mm > 0.0 { style.color } else { style.fill.unwrap_or(style.color) })
}

/// The least contrast of every colour with white paper and with a black screen: that which WCAG 2 asks of
/// graphics.
pub const LEAST_CONTRAST: f64 = 3.0;

/// Colours by their AutoCAD index that print on white and are seen on black, each with a contrast of at least
/// [`LEAST_CONTRAST`] to both. Besides them there is only 7, which is black on white and white on black.
const PRINTED: [(u16, Color); 8] = [
    (1, Color::new(255, 0, 0)),
    (32, Color::new(165, 82, 0)),
    (42, Color::new(165, 124, 0)),
    (94, Color::new(0, 127, 0)),
    (134, Color::new(0, 127, 127)),
    (150, Color::new(0, 127, 255)),
    (200, Color::new(191, 0, 255)),
    (230, Color::new(255, 0, 127)),
];

/// Neutral grey that prints.
const GREY: (u16, Color) = (8, Color::new(128, 128, 128));

/// Black on white, white on black.
const FOREGROUND: u16 = 7;

/// Channels that differ by less are neutral.
const NEUTRAL: u8 = 40;

/// Neutral colours darker than this are the foreground's.
const DARK: u8 = 70;

/// The printed colour of the nearest hue, however light or dark; black and dark greys as the foreground,
/// others as grey.
fn color_index(color: Color) -> u16 {
    let channels = [color.red, color.green, color.blue];
    let (least, most) = (channels.into_iter().min().unwrap_or(0), channels.into_iter().max().unwrap_or(0));
    if most - least < NEUTRAL {
        return if most < DARK { FOREGROUND } else { GREY.0 };
    }
    // Angle between hues, on the circle.
    let apart = |other: Color| libm::cos(hue_rad(color) - hue_rad(other));
    PRINTED.iter().max_by(|a, b| apart(a.1).total_cmp(&apart(b.1))).map_or(FOREGROUND, |(index, _)| *index)
}

/// The angle of a colour's hue, red at 0, green at a third of a turn.
fn hue_rad(color: Color) -> f64 {
    let [red, green, blue] = [color.red, color.green, color.blue].map(f64::from);
    libm::atan2(3.0_f64.sqrt() * (green - blue), 2.0 * red - green - blue)
}

/// The contrast of an index with white and with black, `(L₁ + 0.05)/(L₂ + 0.05)` of the relative luminances;
/// `None` of one that no drawing has.
///
/// ```
/// use epicyclic_drawing::dxf::{LEAST_CONTRAST, contrast};
///
/// assert_eq!(contrast(7), Some([21.0, 21.0])); // black on white, white on black
/// assert!(contrast(94).is_some_and(|both| both.iter().all(|contrast| *contrast >= LEAST_CONTRAST)));
/// assert_eq!(contrast(2), None); // yellow, which nobody sees on paper
/// ```
///
/// # Source
/// Web Content Accessibility Guidelines 2.1, relative luminance and contrast ratio.
#[must_use]
pub fn contrast(index: u16) -> Option<[f64; 2]> {
    let of = |color: Color| {
        let linear = |channel: u8| {
            let part = f64::from(channel) / 255.0;
            if part <= 0.03928 { part / 12.92 } else { libm::pow((part + 0.055) / 1.055, 2.4) }
        };
        let luminance =
            0.2126 * linear(color.red) + 0.7152 * linear(color.green) + 0.0722 * linear(color.blue);
        [1.05 / (luminance + 0.05), (luminance + 0.05) / 0.05]
    };
    if index == FOREGROUND {
        return Some([21.0, 21.0]);
    }
    PRINTED.iter().chain([&GREY]).find(|(other, _)| *other == index).map(|(_, color)| of(*color))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_and_weights_are_the_nearest_that_dxf_has() {
        assert_eq!(color_index(Color::new(250, 5, 5)), 1);
        assert_eq!(color_index(Color::new(10, 10, 10)), 7);
        // Light fills of a hue as the hue, light greys as grey; the line of a filled shape counts before its
        // fill.
        assert_eq!([Color::new(120, 170, 215), Color::new(226, 229, 233)].map(color_index), [150, 8]);
        assert_eq!(color_of(Style::line(0.4).fill(Color::WHITE)), 7);
        assert_eq!(color_of(Style::filled(Color::new(240, 140, 20))), 32);
        assert_eq!([0.0, 0.18, 0.5, 9.0].map(line_weight), [0, 18, 50, 211]);
    }

    #[test]
    fn every_colour_prints_and_is_seen_on_a_screen() {
        for red in (0..=255).step_by(15) {
            for green in (0..=255).step_by(15) {
                for blue in (0..=255).step_by(15) {
                    let index = color_index(Color::new(red, green, blue));
                    let [white, black] = contrast(index).unwrap();
                    assert!(white >= LEAST_CONTRAST && black >= LEAST_CONTRAST, "{index}: {white} {black}");
                }
            }
        }
    }

    #[test]
    fn text_is_ascii_on_one_line() {
        assert_eq!(encoded("ω₁ = 2\n🚜"), "\\U+03C9\\U+2081 = 2 ?");
    }
}
