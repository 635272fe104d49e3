//! The scene as an SVG image, one user unit a millimetre.
//!
//! A layer is a group with the layer's name as its `id` and `class`, so that a page can restyle or hide it. Shapes keep their order
//! across layers: a layer whose shapes are drawn in several goes appears as several groups, of which the first has the `id`.

use svg::Document;
use svg::node::Node;
use svg::node::element::{Circle, Group, Path, Rectangle, Text as TextElement, Title};

use crate::bounds::Bounds;
use crate::error::Error;
use crate::label::{Align, FONTS, Text, one_line};
use crate::scene::{Item, Point, Scene, Shape, Vertex, arc_of_side, sides};
use crate::style::{Color, Style};

/// Blank border of the image in millimetres.
pub const MARGIN_MM: f64 = 4.0;

/// The scene as an SVG image on white.
///
/// # Errors
/// As [`Scene::check`].
pub fn write(scene: &Scene) -> Result<String, Error> {
    image(scene, true, &element)
}

/// The same to stand among others in one page: its groups have no `id`, and the page sets its size.
///
/// # Errors
/// As [`Scene::check`].
pub fn embed(scene: &Scene) -> Result<String, Error> {
    image(scene, false, &element)
}

/// The same with text as outlines, for which no font is needed.
///
/// # Errors
/// As [`Scene::check`].
#[cfg(feature = "print")]
pub fn outlined(scene: &Scene) -> Result<String, Error> {
    image(scene, true, &|text: &Text, style: Style| {
        let outline = crate::glyphs::outline(text);
        let data = outline.iter().map(|step| match step {
            crate::glyphs::Step::Move(to) => format!("M{}", place(*to)),
            crate::glyphs::Step::Line(to) => format!("L{}", place(*to)),
            crate::glyphs::Step::Curve([one, other], to) => {
                format!("C{} {} {}", place(*one), place(*other), place(*to))
            }
            crate::glyphs::Step::Close => "Z".to_owned(),
        });
        Path::new().set("d", data.collect::<String>()).set("fill", style.color.hex()).set("stroke", "none")
    })
}

/// The page of a scene: what is drawn and the border around it.
pub(crate) fn page(scene: &Scene) -> Bounds {
    let bounds = scene.bounds();
    let bounds = if bounds.is_empty() { Shape::line([0.0, 0.0], [0.0, 0.0]).bounds() } else { bounds };
    bounds.grown(MARGIN_MM)
}

/// The scene, its text as the elements that a function makes.
fn image<T: Node>(scene: &Scene, alone: bool, text: &impl Fn(&Text, Style) -> T) -> Result<String, Error> {
    scene.check()?;
    let bounds = page(scene);
    let (left, top) = (bounds.left, -bounds.top);
    let (width, height) = (bounds.width(), bounds.height());
    let paper = Rectangle::new()
        .set("x", number(left))
        .set("y", number(top))
        .set("width", number(width))
        .set("height", number(height))
        .set("fill", "#ffffff");
    let mut document = Document::new();
    if alone {
        document = document
            .set("width", format!("{}mm", number(width)))
            .set("height", format!("{}mm", number(height)));
    }
    document = document
        .set("viewBox", [left, top, width, height].map(number).join(" "))
        .set("role", "img")
        .set("aria-label", one_line(scene.title()))
        .add(Title::new(one_line(scene.title())))
        .add(paper);
    let mut seen = vec![false; scene.layers().len()];
    for run in scene.items().chunk_by(|one, next| one.layer == next.layer) {
        let Some(first) = run.first() else { continue };
        let layer = &scene.layers()[first.layer.0];
        let mut group = style_group(layer.style).set("class", class(&layer.name));
        if alone && !std::mem::replace(&mut seen[first.layer.0], true) {
            group = group.set("id", class(&layer.name));
        }
        document = document.add(run.iter().fold(group, |group, item| add(group, scene, item, text)));
    }
    Ok(document.to_string())
}

fn add<T: Node>(group: Group, scene: &Scene, item: &Item, element: &impl Fn(&Text, Style) -> T) -> Group {
    let shape = |group: Group| match &item.shape {
        Shape::Circle { centre, radius } => group.add(
            Circle::new().set("cx", number(centre.x)).set("cy", number(-centre.y)).set("r", number(*radius)),
        ),
        Shape::Text(text) => group.add(element(text, scene.style(item))),
        other => group.add(Path::new().set("d", path(other))),
    };
    match item.style {
        None => shape(group),
        Some(style) => group.add(shape(style_group(style))),
    }
}

fn style_group(style: Style) -> Group {
    let Style { color, width_mm, dash, fill } = style;
    let mut group = Group::new().set("fill", fill.map_or("none".into(), Color::hex));
    if width_mm > 0.0 {
        group = group
            .set("stroke", color.hex())
            .set("stroke-width", number(width_mm))
            .set("stroke-linecap", "round")
            .set("stroke-linejoin", "round");
        if !dash.pattern_mm().is_empty() {
            let pattern: Vec<String> = dash.pattern_mm().iter().map(|length| number(*length)).collect();
            group = group.set("stroke-dasharray", pattern.join(" ")).set("stroke-linecap", "butt");
        }
    } else {
        group = group.set("stroke", "none");
    }
    group
}

fn element(text: &Text, style: Style) -> TextElement {
    let anchor = match text.align {
        Align::Left => "start",
        Align::Middle => "middle",
        Align::Right => "end",
    };
    let (x, y) = (text.at.x, -text.at.y);
    let mut element = TextElement::new(one_line(&text.content))
        .set("x", number(x))
        .set("y", number(y))
        // Capitals centred on the point: the base line is half their height lower.
        .set("dy", number(0.5 * text.height_mm))
        .set("font-family", FONTS)
        .set("font-size", number(text.font_size_mm()))
        .set("text-anchor", anchor)
        .set("fill", style.color.hex())
        .set("stroke", "none");
    // Where none of the fonts is there, another is drawn together to the width that was counted on.
    if let Some(width) = text.fixed_width_mm() {
        element = element.set("textLength", number(width)).set("lengthAdjust", "spacingAndGlyphs");
    }
    if text.rotation_rad != 0.0 {
        let degrees = -text.rotation_rad.to_degrees();
        element =
            element.set("transform", format!("rotate({} {} {})", number(degrees), number(x), number(y)));
    }
    element
}

/// Path data of a line, an arc or a polyline.
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

fn arc(radius: f64, sweep: f64, large: bool, to: Point) -> String {
    let radius = number(radius);
    // Counter-clockwise with y up is SVG's negative direction.
    format!("A{radius} {radius} 0 {} {} {}", u8::from(large), u8::from(sweep < 0.0), place(to))
}

fn place(point: Point) -> String {
    format!("{} {}", number(point.x), number(-point.y))
}

/// To a tenth of a micrometre, without trailing zeros.
fn number(value: f64) -> String {
    let scaled = value.abs() * 1e4;
    // As the formatting of the library rounds, in whole numbers; what is almost half is left to it, and what is large.
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
