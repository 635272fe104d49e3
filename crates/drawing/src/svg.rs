//! The scene as an SVG image, one user unit a millimetre.
//!
//! A layer is a group with the layer's name as its `id` and `class`, so that a page can restyle or hide it.
//! Shapes keep their order across layers: if other layers are drawn between shapes of a layer, it appears as
//! several groups, and the first has the `id`. Consecutive shapes with one style of their own share a group.

use std::f64::consts::PI;

use quick_xml::Writer;
use quick_xml::escape::partial_escape;
use quick_xml::events::{BytesEnd, BytesStart, BytesText, Event};

use crate::bounds::Bounds;
use crate::error::Error;
use crate::label::{Align, FONTS, Text, one_line};
use crate::scene::{Item, Piece, Point, Scene, Shape, Vertex, arc_of_side, sides};
use crate::style::{Color, Style};

/// Blank border of the image in millimetres.
pub const MARGIN_MM: f64 = 4.0;

/// The scene as an SVG image on white.
///
/// # Errors
/// As [`Scene::check`].
pub fn write(scene: &Scene) -> Result<String, Error> {
    image(scene, true, &letters)
}

/// SVG image for a page with others: its groups have no `id`, and the page sets its size.
///
/// # Errors
/// As [`Scene::check`].
pub fn embed(scene: &Scene) -> Result<String, Error> {
    image(scene, false, &letters)
}

/// SVG image with text as outlines, for which no font is needed.
///
/// # Errors
/// As [`Scene::check`].
#[cfg(feature = "print")]
pub fn outlined(scene: &Scene) -> Result<String, Error> {
    image(scene, true, &|image: &mut Image, text: &Text, style: Style| {
        let outline = crate::glyphs::outline(text);
        let data = outline.iter().map(|step| match step {
            crate::glyphs::Step::Move(to) => format!("M{}", place(*to)),
            crate::glyphs::Step::Line(to) => format!("L{}", place(*to)),
            crate::glyphs::Step::Curve([one, other], to) => {
                format!("C{} {} {}", place(*one), place(*other), place(*to))
            }
            crate::glyphs::Step::Close => "Z".to_owned(),
        });
        let data = data.collect::<String>();
        image.empty("path", &[("d", &data), ("fill", &style.color.hex()), ("stroke", "none")]);
    })
}

/// The page of a scene: what is drawn and the border around it.
pub(crate) fn page(scene: &Scene) -> Bounds {
    let bounds = scene.bounds();
    let bounds = if bounds.is_empty() { Shape::line([0.0, 0.0], [0.0, 0.0]).bounds() } else { bounds };
    bounds.grown(MARGIN_MM)
}

/// The elements of an image as they are written, each on its line; attributes in the order of their names.
struct Image(Writer<Vec<u8>>);

impl Image {
    fn new() -> Self {
        Self(Writer::new_with_indent(vec![], b' ', 0))
    }

    fn event(&mut self, event: Event<'_>) {
        let written = self.0.write_event(event);
        debug_assert!(written.is_ok(), "a vector takes all that is written");
    }

    fn open(&mut self, name: &str, attributes: &[(&str, &str)]) {
        self.event(Event::Start(element(name, attributes)));
    }

    fn close(&mut self, name: &str) {
        self.event(Event::End(BytesEnd::new(name)));
    }

    fn empty(&mut self, name: &str, attributes: &[(&str, &str)]) {
        self.event(Event::Empty(element(name, attributes)));
    }

    fn words(&mut self, name: &str, attributes: &[(&str, &str)], words: &str) {
        self.open(name, attributes);
        self.event(Event::Text(BytesText::from_escaped(partial_escape(words))));
        self.close(name);
    }

    fn text(self) -> String {
        String::from_utf8_lossy(&self.0.into_inner()).into_owned()
    }
}

fn element<'a>(name: &'a str, attributes: &[(&str, &str)]) -> BytesStart<'a> {
    BytesStart::new(name).with_attributes(attributes.iter().copied())
}

/// The scene, its text as a function writes it.
fn image(scene: &Scene, alone: bool, letters: &impl Fn(&mut Image, &Text, Style)) -> Result<String, Error> {
    scene.check()?;
    let bounds = page(scene);
    let [left, top, width, height] = [bounds.left, -bounds.top, bounds.width(), bounds.height()].map(number);
    let title = one_line(scene.title());
    let size = [&height, &width].map(|size| format!("{size}mm"));
    let frame = [&*left, &top, &width, &height].join(" ");
    let mut attributes = vec![
        ("aria-label", &*title),
        ("font-family", FONTS),
        ("height", &size[0]),
        ("role", "img"),
        ("viewBox", &frame),
        ("width", &size[1]),
        ("xmlns", "http://www.w3.org/2000/svg"),
    ];
    let has_text = scene.items().iter().any(|item| matches!(item.shape, Shape::Text(_)));
    attributes.retain(|(name, _)| match *name {
        "font-family" => has_text,
        "height" | "width" => alone,
        _ => true,
    });
    let mut image = Image::new();
    image.open("svg", &attributes);
    image.words("title", &[], &title);
    let paper = [("fill", "#ffffff"), ("height", &height), ("width", &width), ("x", &left), ("y", &top)];
    image.empty("rect", &paper);
    let mut seen = vec![false; scene.layers().len()];
    for run in scene.items().chunk_by(|one, next| one.layer == next.layer) {
        let Some(first) = run.first() else { continue };
        let layer = &scene.layers()[first.layer.0];
        let class = class(&layer.name);
        let is_first = !std::mem::replace(&mut seen[first.layer.0], true);
        group(&mut image, layer.style, Some((&class, alone && is_first)));
        for alike in run.chunk_by(|one, next| one.style == next.style) {
            let own = alike[0].style;
            if let Some(style) = own {
                group(&mut image, style, None);
            }
            for item in alike {
                add(&mut image, scene, item, letters);
            }
            if own.is_some() {
                image.close("g");
            }
        }
        image.close("g");
    }
    image.close("svg");
    Ok(image.text())
}

fn add(image: &mut Image, scene: &Scene, item: &Item, letters: &impl Fn(&mut Image, &Text, Style)) {
    match &item.shape {
        Shape::Circle { centre, radius } => {
            let [x, y, r] = [centre.x, -centre.y, *radius].map(number);
            image.empty("circle", &[("cx", &x), ("cy", &y), ("r", &r)]);
        }
        Shape::Text(text) => letters(image, text, scene.style(item)),
        other => image.empty("path", &[("d", &path(other))]),
    }
}

/// Opens the group of a style; that of a layer has its class, and its identifier where so asked.
fn group(image: &mut Image, style: Style, layer: Option<(&str, bool)>) {
    let Style { color, width_mm, dash, fill } = style;
    let fill = fill.map_or("none".into(), Color::hex);
    let (stroke, width) = (color.hex(), number(width_mm));
    let pattern: Vec<String> = dash.pattern_mm().iter().map(|length| number(*length)).collect();
    let pattern = pattern.join(" ");
    let mut attributes = vec![];
    if let Some((class, _)) = layer {
        attributes.push(("class", class));
    }
    attributes.push(("fill", &fill));
    if let Some((class, true)) = layer {
        attributes.push(("id", class));
    }
    if width_mm > 0.0 {
        attributes.push(("stroke", &stroke));
        if !pattern.is_empty() {
            attributes.push(("stroke-dasharray", &pattern));
        }
        attributes.push(("stroke-linecap", if pattern.is_empty() { "round" } else { "butt" }));
        attributes.extend([("stroke-linejoin", "round"), ("stroke-width", &width)]);
    } else {
        attributes.push(("stroke", "none"));
    }
    image.open("g", &attributes);
}

fn letters(image: &mut Image, text: &Text, style: Style) {
    let anchor = match text.align {
        Align::Left => "start",
        Align::Middle => "middle",
        Align::Right => "end",
    };
    let [x, y] = [text.at.x, -text.at.y].map(number);
    // Capitals centred on the point: the base line is half their height lower.
    let [lower, size] = [0.5 * text.height_mm, text.font_size_mm()].map(number);
    let fill = style.color.hex();
    let mut attributes = vec![("dy", &*lower), ("fill", &fill), ("font-size", &size)];
    // If none of the fonts is installed, another is compressed to the calculated width.
    let width = text.fixed_width_mm().map(number);
    if width.is_some() {
        attributes.push(("lengthAdjust", "spacingAndGlyphs"));
    }
    attributes.extend([("stroke", "none"), ("text-anchor", anchor)]);
    if let Some(width) = &width {
        attributes.push(("textLength", width));
    }
    let turn = format!("rotate({} {x} {y})", number(-text.rotation_rad.to_degrees()));
    if text.rotation_rad != 0.0 {
        attributes.push(("transform", &turn));
    }
    attributes.extend([("x", &*x), ("y", &y)]);
    image.words("text", &attributes, &one_line(&text.content));
}

/// Path data of a line, an arc, a polyline or a contour.
fn path(shape: &Shape) -> String {
    match shape {
        Shape::Line { from, to } => format!("M{}L{}", place(*from), place(*to)),
        Shape::Arc { centre, radius, start_rad, sweep_rad } => {
            let at = |part: f64| Point::polar(*centre, *radius, start_rad + part * sweep_rad);
            // In halves, so that each is less than half a turn.
            let half = |to: f64| arc(*radius, *sweep_rad, false, at(to));
            format!("M{}{}{}", place(at(0.0)), half(0.5), half(1.0))
        }
        Shape::Polyline { vertices, closed } => polyline(vertices, *closed),
        Shape::Contour(pieces) => contour(pieces),
        Shape::Circle { .. } | Shape::Text(_) => String::new(),
    }
}

fn polyline(vertices: &[Vertex], closed: bool) -> String {
    let mut data = vertices.first().map_or_else(String::new, |vertex| format!("M{}", place(vertex.at)));
    for (from, to, bulge) in sides(vertices, closed) {
        match arc_of_side(from, to, bulge) {
            Some((_, radius, _, sweep)) => data += &arc(radius, sweep, bulge.abs() > 1.0, to),
            None => data += &format!("L{}", place(to)),
        }
    }
    if closed {
        data.push('Z');
    }
    data
}

fn contour(pieces: &[Piece]) -> String {
    let mut data = pieces.first().map_or_else(String::new, |piece| format!("M{}", place(piece.start())));
    for piece in pieces {
        data += &match *piece {
            Piece::Arc { centre, radius, start_rad, sweep_rad } => {
                let to = Point::polar(centre, radius, start_rad + sweep_rad);
                arc(radius, sweep_rad, sweep_rad.abs() > PI, to)
            }
            Piece::Cubic([_, one, other, to]) => format!("C{} {} {}", place(one), place(other), place(to)),
        };
    }
    data.push('Z');
    data
}

fn arc(radius: f64, sweep: f64, large: bool, to: Point) -> String {
    let radius = number(radius);
    // Counter-clockwise with y up is SVG's negative direction.
    format!("A{radius} {radius} 0 {} {} {}", u8::from(large), u8::from(sweep < 0.0), place(to))
}

fn place(point: Point) -> String {
    format!("{} {}", number(point.x), number(-point.y))
}

/// Writes a number to a tenth of a micrometre, without trailing zeros.
fn number(value: f64) -> String {
    let scaled = value.abs() * 1e4;
    // Integers round as the formatting of the library does; it handles values near a half and large values.
    let is_sure = scaled < 1e12 && (scaled.fract() - 0.5).abs() > 1e-3;
    if !is_sure {
        return formatted(value);
    }
    let units = scaled.round() as u64;
    let sign = if value < 0.0 && units > 0 { "-" } else { "" };
    let (whole, part) = (units / 10_000, units % 10_000);
    match part {
        0 => format!("{sign}{whole}"),
        part if part % 1000 == 0 => format!("{sign}{whole}.{}", part / 1000),
        part if part % 100 == 0 => format!("{sign}{whole}.{:02}", part / 100),
        part if part % 10 == 0 => format!("{sign}{whole}.{:03}", part / 10),
        part => format!("{sign}{whole}.{part:04}"),
    }
}

fn formatted(value: f64) -> String {
    let text = format!("{value:.4}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".into() } else { text.into() }
}

/// A layer's name as an identifier of a page.
fn class(name: &str) -> String {
    let plain = |c: char| if c.is_alphanumeric() || c == '-' { c } else { '-' };
    format!("layer-{}", name.chars().map(plain).collect::<String>().to_lowercase())
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn numbers_are_short() {
        assert_eq!([0.1 + 0.2, -0.00001, 5.0, -1.25].map(number), ["0.3", "0", "5", "-1.25"]);
    }

    proptest! {
        #[test]
        fn numbers_are_those_of_the_formatting(units in -20_000_000..20_000_000_i64, off in -1.0..1.0_f64, exact in 0..4_u8) {
            let value = match exact {
                0 => units as f64 / 1e4,
                1 => units as f64 / 2e4,
                2 => units as f64 / 8.0,
                _ => units as f64 / 1e4 + off,
            };
            prop_assert_eq!(number(value), formatted(value));
            prop_assert_eq!(number(value * 1e9), formatted(value * 1e9));
        }
    }

    #[test]
    fn y_points_up_and_arcs_turn_the_same_way() {
        let quarter = Shape::Arc {
            centre: Point::new(0.0, 0.0),
            radius: 1.0,
            start_rad: 0.0,
            sweep_rad: std::f64::consts::FRAC_PI_2,
        };
        assert_eq!(path(&quarter), "M1 0A1 1 0 0 0 0.7071 -0.7071A1 1 0 0 0 0 -1");
    }

    #[test]
    fn text_is_escaped() {
        let mut scene = Scene::new("<&>");
        let layer = scene.layer("all", Style::line(0.2)).unwrap();
        scene.add(layer, Text::new([0.0, 0.0], 3.0, "a < b & \"c\""));
        let image = write(&scene).unwrap();
        assert!(image.contains("a &lt; b &amp; "), "{image}");
        assert!(!image.contains("<&>"), "{image}");
    }

    #[test]
    fn a_layer_is_a_group_and_the_order_is_kept() {
        let mut scene = Scene::new("order");
        let below = scene.layer("below", Style::filled(Color::GREY)).unwrap();
        let above = scene.layer("above it", Style::line(0.5)).unwrap();
        for layer in [below, above, below] {
            scene.add(layer, Shape::rectangle([0.0, 0.0], [1.0, 1.0]));
        }
        let image = write(&scene).unwrap();
        assert_eq!(image.matches("class=\"layer-below\"").count(), 2);
        assert_eq!(image.matches("id=\"layer-below\"").count(), 1);
        assert_eq!(image.matches("id=\"layer-above-it\"").count(), 1);
        assert_eq!(embed(&scene).unwrap().matches("id=").count(), 0);
    }

    #[test]
    fn an_empty_scene_is_an_empty_page() {
        assert!(write(&Scene::new("nothing")).unwrap().contains("viewBox=\"-4 -4 8 8\""));
    }
}
