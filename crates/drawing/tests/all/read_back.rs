//! DXF drawings read back by a reader that shares no code with the writer.

use std::f64::consts::PI;
use std::io::Cursor;

use ::dxf::Drawing;
use ::dxf::entities::{Entity, EntityType};
use ::dxf::enums::{AcadVersion, Units};
use epicyclic_drawing::{Align, Color, Dash, Piece, Point, Scene, Shape, Style, Text, Vertex, dxf};
use proptest::prelude::*;

fn read(scene: &Scene) -> Drawing {
    let text = dxf::write(scene).expect("the scene can be drawn");
    Drawing::load(&mut Cursor::new(text.into_bytes())).expect("the reader takes it")
}

fn one(style: Style, shape: impl Into<Shape>) -> Entity {
    let mut scene = Scene::new("one");
    let layer = scene.layer("wheel", style).expect("a fit name");
    scene.add(layer, shape);
    let drawing = read(&scene);
    let mut entities: Vec<Entity> = drawing.entities().cloned().collect();
    assert_eq!(entities.len(), 1);
    entities.remove(0)
}

#[test]
fn the_drawing_is_in_millimetres_and_its_layers_keep_name_colour_and_dashes() {
    let mut scene = Scene::new("layers");
    scene.layer("pitch curves", Style::centre_line().color(Color::new(255, 0, 0))).expect("a fit name");
    scene.layer("Ротор", Style::line(0.5)).expect("a fit name");
    let drawing = read(&scene);
    assert_eq!(drawing.header.version, AcadVersion::R2000);
    assert_eq!(drawing.header.default_drawing_units, Units::Millimeters);
    let layers: Vec<_> =
        drawing.layers().map(|l| (l.name.as_str(), l.color.index(), l.line_type_name.as_str())).collect();
    assert_eq!(
        layers,
        [("0", Some(7), "Continuous"), ("pitch curves", Some(1), "CENTER"), ("Ротор", Some(7), "Continuous")]
    );
    let center = drawing.line_types().find(|l| l.name == "CENTER").expect("the layer's dashes");
    assert_eq!(center.dash_dot_space_lengths, [6.0, -1.0, 0.5, -1.0]);
    assert_eq!(Dash::DashDot.pattern_mm().iter().sum::<f64>(), center.total_pattern_length);
}

#[test]
fn an_arc_is_counter_clockwise_in_degrees() {
    for (start, sweep) in [(0.0, PI / 2.0), (PI / 2.0, -PI / 2.0)] {
        let arc =
            Shape::Arc { centre: Point::new(1.0, 2.0), radius: 3.0, start_rad: start, sweep_rad: sweep };
        let EntityType::Arc(arc) = one(Style::line(0.5), arc).specific else { panic!("an arc is an arc") };
        assert!((arc.center.x - 1.0).abs() + (arc.radius - 3.0).abs() < 1e-9);
        assert!(arc.start_angle.abs() + (arc.end_angle - 90.0).abs() < 1e-9);
    }
}

#[test]
fn text_keeps_its_letters_height_and_place() {
    let text = Text::new([5.0, 6.0], 2.5, "ω₁ → Ø 40").align(Align::Right).turned(PI / 2.0);
    let entity = one(Style::line(0.2), text);
    let EntityType::Text(read) = entity.specific else { panic!("text is text") };
    assert_eq!(read.value, "ω₁ → Ø 40");
    assert!((read.second_alignment_point.x - 5.0).abs() + (read.second_alignment_point.y - 6.0).abs() < 1e-9);
    assert!((read.text_height - 2.5).abs() + (read.rotation - 90.0).abs() < 1e-9);
    assert_eq!(entity.common.layer, "wheel");
}

#[test]
fn a_style_of_its_own_is_kept() {
    let mut scene = Scene::new("style");
    let layer = scene.layer("all", Style::line(0.2)).expect("a fit name");
    let red = Style::line(1.0).color(Color::new(255, 0, 0)).dash(Dash::Dotted);
    scene.add_styled(layer, red, Shape::line([0.0, 0.0], [1.0, 1.0]));
    let drawing = read(&scene);
    let line = drawing.entities().next().expect("the line");
    assert_eq!((line.common.color.index(), line.common.line_type_name.as_str()), (Some(1), "DOT"));
    assert_eq!(line.common.lineweight_enum_value, 100);
}

#[test]
fn the_same_scene_gives_the_same_text() {
    let mut scene = Scene::new("twice");
    let layer = scene.layer("all", Style::line(0.2)).expect("a fit name");
    scene.add(layer, Shape::Circle { centre: Point::new(0.0, 0.0), radius: 1.0 });
    assert_eq!(dxf::write(&scene), dxf::write(&scene));
}

/// A point of a spline by the recursion of de Boor.
fn on_spline(spline: &::dxf::entities::Spline, t: f64) -> [f64; 2] {
    let knots = &spline.knot_values;
    let span =
        (3..spline.control_points.len()).rfind(|&i| knots[i] <= t && knots[i] < knots[i + 1]).unwrap_or(3);
    let mut points: Vec<[f64; 2]> =
        (0..4).map(|i| &spline.control_points[span - 3 + i]).map(|point| [point.x, point.y]).collect();
    for level in 1..4 {
        for i in (level..4).rev() {
            let [from, to] = [knots[span - 3 + i], knots[span + 1 + i - level]];
            let share = (t - from) / (to - from);
            points[i] = [0, 1].map(|axis| (1.0 - share) * points[i - 1][axis] + share * points[i][axis]);
        }
    }
    points[3]
}

proptest! {
    /// Curves that go over into each other are one spline, through the same points.
    #[test]
    fn smooth_curves_come_back_as_one_spline(
        steps in prop::collection::vec((0.2..3.0_f64, -1.0..1.0_f64), 4..9), corner: bool,
    ) {
        // Points and arms along a line that bends; both arms of a point lie on one line.
        let (mut at, mut direction, mut joints) = (Point::new(5.0, 0.0), 0.0, vec![]);
        for (length, bend) in &steps {
            joints.push((at, direction, *length));
            direction += bend;
            at = Point::polar(at, 3.0 * length, direction);
        }
        let curves: Vec<[Point; 4]> = joints
            .windows(2)
            .map(|ends| {
                let ([(from, out, reach), (to, into, mates)], own) = ([ends[0], ends[1]], 0.4);
                [from, Point::polar(from, own * reach, out), Point::polar(to, -0.7 * own * mates, into), to]
            })
            .collect();
        let mut pieces: Vec<Piece> = curves.iter().copied().map(Piece::Cubic).collect();
        let (start, end) = (curves[0][0], curves[curves.len() - 1][3]);
        if corner {
            pieces.push(Piece::Cubic([end, Point::new(end.x, end.y + 1.0), Point::new(start.x, -9.0), start]));
        }
        let mut scene = Scene::new("contour");
        let layer = scene.layer("wheel", Style::line(0.5)).expect("a fit name");
        scene.add(layer, Shape::Contour(pieces.clone()));
        let drawing = read(&scene);
        let splines: Vec<_> = drawing
            .entities()
            .map(|entity| match &entity.specific {
                EntityType::Spline(spline) => spline.clone(),
                other => panic!("a spline is a spline: {other:?}"),
            })
            .collect();
        prop_assert_eq!(splines.len(), 1 + usize::from(corner));
        let spline = &splines[0];
        prop_assert_eq!(spline.control_points.len(), 2 * curves.len() + 2);
        prop_assert_eq!(spline.knot_values.len(), spline.control_points.len() + 4);
        let mut ends = spline.knot_values.clone();
        ends.dedup();
        for (curve, knots) in curves.iter().zip(ends.windows(2)) {
            for part in 0..=10 {
                let t = f64::from(part) / 10.0;
                let weights = [(1.0 - t).powi(3), 3.0 * t * (1.0 - t).powi(2), 3.0 * t * t * (1.0 - t), t.powi(3)];
                let sum = |of: &dyn Fn(&Point) -> f64| -> f64 {
                    curve.iter().zip(weights).map(|(point, weight)| weight * of(point)).sum()
                };
                // Ends belong to two curves.
                let inside = knots[0] + (knots[1] - knots[0]) * t.clamp(1e-12, 1.0 - 1e-12);
                let [x, y] = on_spline(spline, inside);
                prop_assert!(libm::hypot(x - sum(&|point| point.x), y - sum(&|point| point.y)) < 1e-7, "{t}");
            }
        }
    }

    #[test]
    fn polylines_come_back_to_a_nanometre(
        points in prop::collection::vec((-1e4..1e4_f64, -1e4..1e4_f64, -2.0..2.0_f64), 2..40), closed: bool,
    ) {
        let vertices: Vec<_> =
            points.iter().map(|&(x, y, bulge)| Vertex { at: Point::new(x, y), bulge }).collect();
        let shape = Shape::Polyline { vertices: vertices.clone(), closed };
        let EntityType::LwPolyline(read) = one(Style::line(0.5), shape).specific else {
            panic!("a polyline is a polyline")
        };
        prop_assert_eq!(read.is_closed(), closed);
        prop_assert_eq!(read.vertices.len(), vertices.len());
        for (read, written) in read.vertices.iter().zip(&vertices) {
            let apart = (read.x - written.at.x).abs() + (read.y - written.at.y).abs();
            prop_assert!(apart < 2e-9 && (read.bulge - written.bulge).abs() < 1e-9);
        }
    }

    #[test]
    fn nothing_panics_and_what_is_written_can_be_read(
        numbers in prop::array::uniform6(any::<f64>()), name in ".*", content in ".*", closed: bool,
    ) {
        let [a, b, c, d, e, f] = numbers;
        let mut scene = Scene::new(content.clone());
        if let Ok(layer) = scene.layer(name, Style::line(a)) {
            scene.add(layer, Shape::Arc { centre: Point::new(a, b), radius: c, start_rad: d, sweep_rad: e });
            scene.add(layer, Text::new([a, b], c, content).turned(d));
            let vertices = [[a, b], [c, d], [e, f]].map(|at| Vertex { at: at.into(), bulge: f });
            scene.add(layer, Shape::Polyline { vertices: vertices.to_vec(), closed });
            if let Ok(text) = dxf::write(&scene) {
                prop_assert!(Drawing::load(&mut Cursor::new(text.into_bytes())).is_ok());
            }
            if let Ok(image) = epicyclic_drawing::svg::write(&scene) {
                let image = resvg::usvg::Tree::from_str(&image, &resvg::usvg::Options::default());
                prop_assert!(image.is_ok(), "{:?}", image.err());
            }
        }
    }
}
