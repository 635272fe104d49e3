//! SVG images drawn as pixels by a rasteriser: what the lines look like, not what the text says.

use epicyclic_drawing::{Color, Point, Scene, Shape, Style, Text, Vertex, svg};
use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree};

/// Pixels to a millimetre.
const SCALE: f32 = 4.0;

struct Picture {
    pixels: Pixmap,
    left: f64,
    top: f64,
}

impl Picture {
    fn of(scene: &Scene) -> Self {
        let image = svg::write(scene).expect("the scene can be drawn");
        let tree = Tree::from_str(&image, &Options::default()).expect("the rasteriser takes it");
        let bounds = scene.bounds().grown(svg::MARGIN_MM);
        // The image has its size in millimetres; the rasteriser counts 96 pixels to the inch.
        let scale = SCALE * 25.4 / 96.0;
        let pixels = |size: f32| (size * scale).ceil() as u32;
        let mut map = Pixmap::new(pixels(tree.size().width()), pixels(tree.size().height())).expect("a size");
        resvg::render(&tree, Transform::from_scale(scale, scale), &mut map.as_mut());
        Self { pixels: map, left: bounds.left, top: bounds.top }
    }

    fn at(&self, x: f64, y: f64) -> Color {
        let pixel = |mm: f64| (mm * f64::from(SCALE)) as u32;
        let color = self.pixels.pixel(pixel(x - self.left), pixel(self.top - y)).expect("inside the picture");
        Color::new(color.red(), color.green(), color.blue())
    }
}

const RED: Color = Color::new(255, 0, 0);

fn draw(shapes: &[Shape], style: Style) -> Picture {
    let mut scene = Scene::new("pixels");
    let layer = scene.layer("all", style).expect("a fit name");
    shapes.iter().for_each(|shape| scene.add(layer, shape.clone()));
    Picture::of(&scene)
}

#[test]
fn an_arc_runs_counter_clockwise_with_y_up() {
    let arc = Shape::Arc {
        centre: Point::new(0.0, 0.0),
        radius: 20.0,
        start_rad: 0.0,
        sweep_rad: std::f64::consts::FRAC_PI_2,
    };
    let box_around = Shape::rectangle([-25.0, -25.0], [25.0, 25.0]);
    let picture = draw(&[arc, box_around], Style::line(1.0).color(RED));
    let at = 20.0 * std::f64::consts::FRAC_1_SQRT_2;
    assert_eq!(picture.at(at, at), RED);
    for (x, y) in [(-at, at), (at, -at), (-at, -at), (0.0, 0.0)] {
        assert_eq!(picture.at(x, y), Color::WHITE, "{x} {y}");
    }
}

#[test]
fn bulges_bend_the_way_of_cad() {
    // From (10, 0) up and over to (−10, 0) counter-clockwise, and straight back.
    let vertices =
        [([10.0, 0.0], 1.0), ([-10.0, 0.0], 0.0)].map(|(at, bulge)| Vertex { at: at.into(), bulge });
    let shape = Shape::Polyline { vertices: vertices.to_vec(), closed: true };
    let box_around = Shape::rectangle([-15.0, -15.0], [15.0, 15.0]);
    let mut scene = Scene::new("half a disc");
    let layer = scene.layer("all", Style::line(0.5).fill(RED)).expect("a fit name");
    scene.add(layer, shape);
    scene.add_styled(layer, Style::line(0.5), box_around);
    let picture = Picture::of(&scene);
    assert_eq!(picture.at(0.0, 5.0), RED);
    assert_eq!(picture.at(0.0, -5.0), Color::WHITE);
    assert_eq!(picture.at(0.0, 0.1), Color::BLACK);
}

#[test]
fn large_arcs_and_full_circles_are_whole() {
    let arc = |start_rad, sweep_rad| Shape::Arc {
        centre: Point::new(0.0, 0.0),
        radius: 10.0,
        start_rad,
        sweep_rad,
    };
    let angles = [0.3, 1.9, 3.4, 5.0];
    let on = |picture: &Picture, angle: f64| picture.at(10.0 * libm::cos(angle), 10.0 * libm::sin(angle));
    let full = draw(&[arc(1.0, -std::f64::consts::TAU)], Style::line(1.0).color(RED));
    assert!(angles.iter().all(|angle| on(&full, *angle) == RED));
    let large = draw(&[arc(0.0, 4.0)], Style::line(1.0).color(RED));
    assert_eq!(angles.map(|angle| on(&large, angle) == RED), [true, true, true, false]);
}

#[test]
fn later_shapes_cover_earlier_ones_and_labels_do_no_harm() {
    let mut scene = Scene::new("cover");
    let under = scene.layer("under", Style::filled(Color::GREY)).expect("a fit name");
    let over = scene.layer("over", Style::filled(RED)).expect("a fit name");
    scene.add(over, Shape::rectangle([0.0, 0.0], [10.0, 10.0]));
    scene.add(under, Shape::rectangle([5.0, 0.0], [15.0, 10.0]));
    scene.add(over, Text::new([7.0, 5.0], 3.0, "a < b"));
    let picture = Picture::of(&scene);
    assert_eq!(picture.at(2.0, 1.0), RED);
    assert_eq!(picture.at(7.0, 1.0), Color::GREY);
}
