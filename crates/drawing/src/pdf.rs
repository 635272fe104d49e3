//! The scene as a PDF page of its size, with the border of the image.
//!
//! Lines, arcs and fills are those of the scene, text is drawn as outlines: no font is needed, and none can
//! be searched. The same scene gives the same bytes: no time and no random number is in them.
//!
//! # Source
//! ISO 32000-1, page description and content streams.

use std::f64::consts::FRAC_PI_2;
use std::io::Write as _;

use flate2::Compression;
use flate2::write::ZlibEncoder;
use pdf_writer::types::{LineCapStyle, LineJoinStyle};
use pdf_writer::{Content, Filter, Pdf, Rect, Ref, TextStr};

use crate::bounds::Point;
use crate::error::Error;
use crate::glyphs::{self, Step};
use crate::label::one_line;
use crate::scene::{Piece, Scene, Shape, arc_of_side, sides};
use crate::style::{Color, Style};
use crate::svg::page;

/// The largest page in millimetres: 14400 points.
pub const MOST_MM: f64 = 5080.0;

/// Points to a millimetre.
const POINTS: f64 = 72.0 / 25.4;

/// The scene as a PDF document of one page.
///
/// # Errors
/// As [`Scene::check`]; [`Error::PageSize`].
pub fn write(scene: &Scene) -> Result<Vec<u8>, Error> {
    scene.check()?;
    let bounds = page(scene);
    let (width_mm, height_mm) = (bounds.width(), bounds.height());
    if width_mm.max(height_mm) > MOST_MM {
        return Err(Error::PageSize { width_mm, height_mm, most_mm: MOST_MM });
    }
    let mut content = Content::new();
    content.transform([POINTS, 0.0, 0.0, POINTS, -POINTS * bounds.left, -POINTS * bounds.bottom].map(single));
    content.set_line_join(LineJoinStyle::RoundJoin);
    for item in scene.items() {
        let style = scene.style(item);
        match &item.shape {
            Shape::Text(text) => {
                fill_color(&mut content, style.color);
                let steps = glyphs::outline(text);
                if !steps.is_empty() {
                    steps.into_iter().for_each(|step| draw(&mut content, step));
                    content.fill_nonzero();
                }
            }
            shape => paint(&mut content, style, shape),
        }
    }
    let [catalog, pages, sheet, stream, info] = [1, 2, 3, 4, 5].map(Ref::new);
    let mut pdf = Pdf::new();
    pdf.catalog(catalog).pages(pages);
    pdf.pages(pages).kids([sheet]).count(1);
    let media = Rect::new(0.0, 0.0, single(POINTS * width_mm), single(POINTS * height_mm));
    let mut leaf = pdf.page(sheet);
    leaf.parent(pages).media_box(media).contents(stream);
    leaf.resources();
    drop(leaf);
    let mut packed = ZlibEncoder::new(vec![], Compression::default());
    // Writing to memory cannot fail.
    let _ = packed.write_all(&content.finish());
    let packed = packed.finish().unwrap_or_default();
    pdf.stream(stream, &packed).filter(Filter::FlateDecode);
    pdf.document_info(info).title(TextStr(&one_line(scene.title()))).creator(TextStr("epicyclic"));
    Ok(pdf.finish())
}

/// Number with the single precision of a content stream.
#[allow(clippy::cast_possible_truncation)] // within ±1e5, checked
fn single(value: f64) -> f32 {
    value as f32
}

fn rgb(color: Color) -> [f32; 3] {
    [color.red, color.green, color.blue].map(|channel| f32::from(channel) / 255.0)
}

fn fill_color(content: &mut Content, color: Color) {
    let [red, green, blue] = rgb(color);
    content.set_fill_rgb(red, green, blue);
}

fn paint(content: &mut Content, style: Style, shape: &Shape) {
    let has_line = style.width_mm > 0.0;
    if has_line {
        let [red, green, blue] = rgb(style.color);
        let pattern = style.dash.pattern_mm();
        // Round ends would close the gaps.
        let cap = if pattern.is_empty() { LineCapStyle::RoundCap } else { LineCapStyle::ButtCap };
        content.set_stroke_rgb(red, green, blue).set_line_width(single(style.width_mm)).set_line_cap(cap);
        content.set_dash_pattern(pattern.iter().map(|length| single(*length)), 0.0);
    }
    if let Some(color) = style.fill {
        fill_color(content, color);
    }
    path(content, shape);
    match (style.fill.is_some(), has_line) {
        (true, true) => content.fill_nonzero_and_stroke(),
        (true, false) => content.fill_nonzero(),
        (false, true) => content.stroke(),
        (false, false) => content.end_path(),
    };
}

fn path(content: &mut Content, shape: &Shape) {
    let moved = |content: &mut Content, to: Point| draw(content, Step::Move(to));
    match shape {
        Shape::Line { from, to } => {
            moved(content, *from);
            draw(content, Step::Line(*to));
        }
        Shape::Circle { centre, radius } => {
            moved(content, Point::polar(*centre, *radius, 0.0));
            arc(content, *centre, *radius, 0.0, 4.0 * FRAC_PI_2);
            content.close_path();
        }
        Shape::Arc { centre, radius, start_rad, sweep_rad } => {
            moved(content, Point::polar(*centre, *radius, *start_rad));
            arc(content, *centre, *radius, *start_rad, *sweep_rad);
        }
        Shape::Polyline { vertices, closed } => {
            if let Some(first) = vertices.first() {
                moved(content, first.at);
            }
            for (from, to, bulge) in sides(vertices, *closed) {
                match arc_of_side(from, to, bulge) {
                    Some((centre, radius, start, sweep)) => arc(content, centre, radius, start, sweep),
                    None => draw(content, Step::Line(to)),
                }
            }
            if *closed {
                content.close_path();
            }
        }
        Shape::Contour(pieces) => {
            if let Some(first) = pieces.first() {
                moved(content, first.start());
            }
            for piece in pieces {
                match *piece {
                    Piece::Arc { centre, radius, start_rad, sweep_rad } => {
                        arc(content, centre, radius, start_rad, sweep_rad);
                    }
                    Piece::Cubic([_, one, other, to]) => draw(content, Step::Curve([one, other], to)),
                }
            }
            content.close_path();
        }
        Shape::Text(_) => {}
    }
}

/// An arc from where the path is, in cubic curves of at most a quarter turn: off the circle by less than 3e-4
/// of its radius.
///
/// The control points of a piece of angle `θ` lie `4/3·tan(θ/4)` radii along the tangents at its ends.
fn arc(content: &mut Content, centre: Point, radius: f64, start: f64, sweep: f64) {
    let pieces = (sweep.abs() / FRAC_PI_2).ceil().max(1.0);
    let piece = sweep / pieces;
    let reach = 4.0 / 3.0 * libm::tan(0.25 * piece) * radius;
    let mut from = start;
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // a few quarters
    for _ in 0..pieces as u32 {
        let to = from + piece;
        let one = Point::polar(Point::polar(centre, radius, from), reach, from + FRAC_PI_2);
        let other = Point::polar(Point::polar(centre, radius, to), -reach, to + FRAC_PI_2);
        draw(content, Step::Curve([one, other], Point::polar(centre, radius, to)));
        from = to;
    }
}

fn draw(content: &mut Content, step: Step) {
    // To a tenth of a micrometre, as in SVG.
    let round = |value: f64| single((1e4 * value).round() / 1e4);
    let xy = |point: Point| (round(point.x), round(point.y));
    match step {
        Step::Move(to) => content.move_to(xy(to).0, xy(to).1),
        Step::Line(to) => content.line_to(xy(to).0, xy(to).1),
        Step::Curve([one, other], to) => {
            content.cubic_to(xy(one).0, xy(one).1, xy(other).0, xy(other).1, xy(to).0, xy(to).1)
        }
        Step::Close => content.close_path(),
    };
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::label::Text;
    use crate::style::Dash;

    fn scene() -> Scene {
        let mut scene = Scene::new("A ring, Ω");
        let layer = scene.layer("all", Style::line(0.5).dash(Dash::Dashed).fill(Color::GREY)).unwrap();
        scene.add(layer, Shape::Circle { centre: Point::new(0.0, 0.0), radius: 20.0 });
        scene.add(layer, Shape::line([-20.0, 0.0], [20.0, 0.0]));
        scene.add(layer, Text::new([0.0, 5.0], 2.5, "ω₁ = 1"));
        scene
    }

    #[test]
    fn one_scene_gives_one_page_of_its_size_in_the_same_bytes() {
        let (one, other) = (write(&scene()).unwrap(), write(&scene()).unwrap());
        assert_eq!(one, other);
        assert!(one.starts_with(b"%PDF-1.7"));
        let text = String::from_utf8_lossy(&one);
        // 40 mm and two borders of 4 mm are 136.06 points.
        assert!(text.contains("/MediaBox [0 0 136.06") && text.contains("/Count 1"), "{text}");
        assert!(!text.contains("/CreationDate"), "{text}");
    }

    #[test]
    fn a_scene_larger_than_a_page_is_refused() {
        let mut large = scene();
        let layer = large.layer("far", Style::line(0.5)).unwrap();
        large.add(layer, Shape::line([0.0, 0.0], [6000.0, 0.0]));
        assert!(matches!(write(&large), Err(Error::PageSize { .. })));
    }

    /// Checks the radius of the curves of a quarter circle against the stated deviation.
    #[test]
    fn the_curves_of_an_arc_are_round() {
        let reach = 4.0 / 3.0 * libm::tan(0.25 * FRAC_PI_2);
        let points = [[1.0, 0.0], [1.0, reach], [reach, 1.0], [0.0, 1.0]];
        for step in 0..=100 {
            let t = f64::from(step) / 100.0;
            let weights =
                [(1.0 - t).powi(3), 3.0 * t * (1.0 - t).powi(2), 3.0 * t * t * (1.0 - t), t.powi(3)];
            let at = [0, 1].map(|axis| weights.iter().zip(points).map(|(w, p)| w * p[axis]).sum::<f64>());
            assert!((libm::hypot(at[0], at[1]) - 1.0).abs() < 3e-4, "{t}");
        }
    }
}
