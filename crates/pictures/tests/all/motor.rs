//! Pictures of motors: no label on a line, areas and curves that are the motor's, pixels of the right colour.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "helpers of tests, which clippy does not know for such"
)]

use crate::common;

use epicyclic_drawing::{Color, Point, Scene, Shape, Vertex, svg, text};
use epicyclic_hydromotor::arcs::{Known, StatorArcs};
use epicyclic_hydromotor::centrode::Wheel;
use epicyclic_hydromotor::chambers::Phase;
use epicyclic_hydromotor::closure::Family;
use epicyclic_hydromotor::profile::{Profile, ToothForm};
use epicyclic_hydromotor::{Motor, MotorNumbers};
use epicyclic_pictures::motor::{
    TOLERANCE_MM, centrodes, chambers, construction, dimensions, outline, teeth, whole,
};
use proptest::prelude::*;
use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree};
use uom::si::angle::{degree, radian};
use uom::si::area::square_millimeter;
use uom::si::f64::{Angle, Length};
use uom::si::length::millimeter;
use uom::si::ratio::ratio;

fn mm(value: f64) -> Length {
    Length::new::<millimeter>(value)
}

fn turned(degrees: f64) -> Angle {
    Angle::new::<degree>(degrees)
}

fn two_arcs([stator, rotor, teeth, satellite]: [u32; 4], module_mm: f64, l_mm: f64) -> Motor {
    let numbers = MotorNumbers::new(stator, rotor, teeth, satellite).unwrap();
    Motor::of_two_arcs(numbers, mm(module_mm), mm(l_mm)).unwrap()
}

fn known() -> [Motor; 4] {
    let cosine = MotorNumbers::new(7, 5, 84, 11).unwrap();
    [
        two_arcs([5, 3, 55, 10], 2.0, 80.0),
        two_arcs([5, 3, 55, 10], 1.0, 30.0),
        two_arcs([6, 4, 66, 10], 2.0, 80.0),
        Motor::of_cosine_law(cosine, mm(3.0)).unwrap(),
    ]
}

fn any_motor() -> impl Strategy<Value = Motor> {
    let numbers = (2..=8_u32, 1..=3_u32, 6..=14_u32, 0.3..1.0_f64);
    (numbers, 0.02..0.98_f64, 0.5..20.0_f64, any::<bool>()).prop_filter_map(
        "no such motor",
        |((stator, more, per_lobe, size), part, module, cosine)| {
            let rotor = stator.checked_sub(more).filter(|rotor| *rotor > 0)?;
            let satellite = (size * f64::from(more * per_lobe) / 2.0) as u32;
            let numbers = MotorNumbers::new(stator, rotor, stator * per_lobe, satellite).ok()?;
            if cosine {
                return Motor::of_cosine_law(numbers, mm(module)).ok();
            }
            let arcs = Family::new(numbers, mm(module)).ok()?.at_part(part).ok()?;
            Motor::of_two_arcs(numbers, mm(module), arcs.trough_distance()).ok()
        },
    )
}

fn no_label_meets_a_line(view: &str, scene: &Scene) -> Result<(), TestCaseError> {
    let met = text::overlaps(scene);
    let label = met.first().map(|met| &scene.items()[met.label].shape);
    prop_assert!(met.is_empty(), "{view}: {label:?}");
    prop_assert!(scene.check().is_ok());
    common::prints(scene);
    Ok(())
}

fn nothing_overlaps(motor: &Motor, rotation: Angle) -> Result<(), TestCaseError> {
    let views = [
        ("centrodes", centrodes(motor, rotation).unwrap()),
        ("motor", whole(motor, rotation).unwrap()),
        ("chambers", chambers(motor, rotation).unwrap()),
        ("dimensions", dimensions(motor, None, Some(mm(40.0)), rotation).unwrap()),
    ];
    views.iter().try_for_each(|(view, scene)| no_label_meets_a_line(view, scene))
}

/// Every letter of the construction has its place, on no line; of arcs that do not close as well.
fn letters_of_the_construction(numbers: MotorNumbers, arcs: &StatorArcs) -> Result<(), TestCaseError> {
    let scene = construction(numbers, arcs).unwrap();
    no_label_meets_a_line("construction", &scene)?;
    let words: Vec<&str> = scene
        .items()
        .iter()
        .filter_map(|item| match &item.shape {
            Shape::Text(text) => Some(text.content.as_str()),
            _ => None,
        })
        .collect();
    for letter in ["O", "O₂", "P", "P₁", "B", "T", "Π", "θ₃", "a", "R₂"] {
        prop_assert!(words.contains(&letter), "{letter} in {words:?}");
    }
    Ok(())
}

#[test]
fn the_construction_of_open_arcs_says_how_far_they_are_open() {
    let numbers = MotorNumbers::new(5, 3, 55, 10).unwrap();
    for (a_mm, words) in [
        (30.0, "Rotor: half a lobe stays open by 0.22184°, to the dashes"),
        (30.612_62, "Rotor: closes"),
        (31.0, "Rotor: half a lobe overlaps the next by 0.14738°, from the dashes"),
    ] {
        let known = [Known::TroughDistance(mm(80.0)), Known::CrestDistance(mm(a_mm))];
        let arcs = StatorArcs::with(numbers, mm(2.0), known).unwrap()[0];
        letters_of_the_construction(numbers, &arcs).unwrap();
        let scene = construction(numbers, &arcs).unwrap();
        let says = |item: &epicyclic_drawing::scene::Item| matches!(&item.shape, Shape::Text(text) if text.content == words);
        assert!(scene.items().iter().any(says), "{words}");
    }
}

#[test]
fn no_label_of_the_known_motors_meets_a_line() {
    for motor in known() {
        if let Some(arcs) = motor.arcs() {
            letters_of_the_construction(motor.numbers(), arcs).unwrap();
        }
        for angle in [0.0, 10.0, 20.0, 33.3, 60.0, 90.0, 200.0] {
            nothing_overlaps(&motor, turned(angle)).unwrap();
        }
    }
}

/// Diameters, radii and counts are drawn as the motor has them, each diameter between its two arrows;
/// tolerances are blank.
#[test]
fn the_dimensions_are_those_of_the_motor() {
    let motor = two_arcs([5, 3, 55, 10], 2.0, 80.0);
    let profile = Profile::new(&motor, ToothForm::default()).unwrap();
    let scene = dimensions(&motor, Some(&profile), Some(mm(40.0)), turned(0.0)).unwrap();
    common::check(&scene);
    let says = |words: &str| {
        let texts = scene
            .items()
            .iter()
            .filter(|item| matches!(&item.shape, Shape::Text(text) if text.content == words));
        texts.count()
    };
    // R₁, R₂, l, a of the source's vector, in five digits; satellites of 10 teeth of 2 mm.
    for words in
        ["R32.208", "R25.883", "a = 30.613", "l = 80", "80", "8× Ø20", "55 / 33 / 10", "Tolerance", "40"]
    {
        assert!(says(words) >= 1, "{words}");
    }
    let circle = number_of(2.0 * motor.ports().high[0].centre_radius.get::<millimeter>());
    assert_eq!(says(&format!("ports on Ø{circle}")), 1, "{circle}");
    // The line of l is 80 mm long, level, from the axis to the left.
    let lines: Vec<[Point; 2]> = scene
        .items()
        .iter()
        .filter_map(|item| match item.shape {
            Shape::Line { from, to } => Some([from, to]),
            _ => None,
        })
        .collect();
    let is_l = |[from, to]: &[Point; 2]| {
        (from.y - to.y).abs() < 1e-9 && from.x.abs() < 1e-9 && (to.x + 80.0).abs() < 1e-9
    };
    assert_eq!(lines.iter().filter(|line| is_l(line)).count(), 1);
    let arcs = motor.arcs().unwrap();
    let outer = 2.0 * (arcs.crest_distance() + arcs.crest_radius()).get::<millimeter>();
    assert_eq!(says(&format!("Ø{outer:.2}")), 1, "{outer}");
    let line = scene.items().iter().any(|item| match item.shape {
        Shape::Line { from, to } => from.y == to.y && ((to.x - from.x) - outer).abs() < 1e-9,
        _ => false,
    });
    assert!(line, "a dimension line of {outer}");
    // Without teeth and width the table says so, and leaves the width open.
    let bare = dimensions(&motor, None, None, turned(0.0)).unwrap();
    assert!(
        bare.items().iter().any(|item| matches!(&item.shape, Shape::Text(text) if text.content == "none"))
    );
}

/// Five digits, as drawings write them.
fn number_of(value: f64) -> String {
    format!("{value:.3}").trim_end_matches('0').trim_end_matches('.').to_owned()
}

#[test]
fn a_rotation_that_is_no_number_is_refused() {
    let (motor, nan) = (&known()[0], turned(f64::NAN));
    assert!(centrodes(motor, nan).is_err() && chambers(motor, nan).is_err() && whole(motor, nan).is_err());
}

/// Pairs of neighbouring vertices, round to the first.
fn sides(vertices: &[Vertex]) -> impl Iterator<Item = (&Vertex, &Vertex)> {
    vertices.iter().zip(vertices.iter().cycle().skip(1))
}

/// Area within a polygon, positive counter-clockwise.
fn area(shape: &Shape) -> f64 {
    let Shape::Polyline { vertices, closed: true } = shape else { panic!("a closed polyline") };
    sides(vertices).map(|(one, next)| 0.5 * (one.at.x * next.at.y - one.at.y * next.at.x)).sum()
}

/// Distance of a point from the nearest of a closed polyline's arcs.
fn distance(vertices: &[Vertex], point: [f64; 2]) -> f64 {
    let side = |(one, next): (&Vertex, &Vertex)| {
        let (dx, dy) = (next.at.x - one.at.x, next.at.y - one.at.y);
        let chord = libm::hypot(dx, dy);
        let sweep = 4.0 * libm::atan(one.bulge);
        // In the chord's frame: along it and to its left.
        let (px, py) = (point[0] - one.at.x, point[1] - one.at.y);
        let (along, left) = ((px * dx + py * dy) / chord, (py * dx - px * dy) / chord);
        let ends = libm::hypot(along, left).min(libm::hypot(along - chord, left));
        if sweep.abs() < 1e-9 {
            return if (0.0..=chord).contains(&along) { left.abs() } else { ends };
        }
        // Negative clockwise; the arc's middle lies to the right of the chord counter-clockwise.
        let radius = 0.5 * chord / libm::sin(0.5 * sweep);
        let (x, y) = (along - 0.5 * chord, left - radius * libm::cos(0.5 * sweep));
        let from_middle = libm::atan2(x, -y * radius.signum());
        if from_middle.abs() <= 0.5 * sweep.abs() { (libm::hypot(x, y) - radius.abs()).abs() } else { ends }
    };
    sides(vertices).map(side).fold(f64::INFINITY, f64::min)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn no_label_of_any_motor_meets_a_line(motor in any_motor(), rotation in -400.0..400.0_f64) {
        nothing_overlaps(&motor, turned(rotation))?;
        if let Some(arcs) = motor.arcs() {
            no_label_meets_a_line("construction", &construction(motor.numbers(), arcs).unwrap())?;
        }
    }

    #[test]
    fn teeth_of_any_motor_that_has_them_can_be_drawn(motor in any_motor(), rotation in -400.0..400.0_f64) {
        if let Ok(profile) = Profile::new(&motor, ToothForm::default()) {
            no_label_meets_a_line("teeth", &teeth(&profile, turned(rotation)).unwrap())?;
        }
    }

    #[test]
    fn chambers_are_drawn_as_large_as_they_are(motor in any_motor(), rotation in -400.0..400.0_f64) {
        let scene = chambers(&motor, turned(rotation)).unwrap();
        let is_chamber = |item: &&epicyclic_drawing::scene::Item| scene.layer_of(item).name.starts_with("chambers");
        let drawn: f64 = scene.items().iter().filter(is_chamber).map(|item| area(&item.shape)).sum();
        let there = motor.chambers(turned(rotation)).unwrap();
        let there: f64 = there.iter().map(|chamber| chamber.area.get::<square_millimeter>()).sum();
        // Straight sides leave segments out: 48 for a wall that turns by half a turn miss 7e-4 of its disc.
        let disc = motor.envelope().stator_outer.get::<millimeter>().powi(2);
        prop_assert!((drawn - there).abs() < 1e-3 * disc, "{drawn} {there}");
    }

    #[test]
    fn outlines_are_the_curves(motor in any_motor(), part in 0.0..1.0_f64) {
        for wheel in [Wheel::Stator, Wheel::Rotor, Wheel::Satellite] {
            let drawn = outline(&motor, wheel).unwrap();
            prop_assert!(drawn.deviation_mm <= TOLERANCE_MM, "{}", drawn.deviation_mm);
            let curve = motor.centrode(wheel);
            let point = curve.at(curve.length() * part).unwrap();
            let off = distance(&drawn.vertices, [point.x, point.y].map(|x| x.get::<millimeter>()));
            // The deviation may be a little greater between the nine places of a piece at which it is
            // evaluated.
            let slack = 1e-10 * curve.length().get::<millimeter>();
            prop_assert!(off <= 1.1 * drawn.deviation_mm + slack, "{wheel:?} {off:e} {:e}", drawn.deviation_mm);
        }
    }
}

#[test]
fn the_stators_arcs_have_the_radii_of_the_motor() {
    let stator = outline(&two_arcs([5, 3, 55, 10], 2.0, 80.0), Wheel::Stator).unwrap();
    assert_eq!((stator.vertices.len(), stator.deviation_mm), (10, 0.0));
    let radii: Vec<f64> = sides(&stator.vertices)
        .map(|(one, next)| {
            let chord = libm::hypot(next.at.x - one.at.x, next.at.y - one.at.y);
            0.5 * chord / libm::sin(2.0 * libm::atan(one.bulge))
        })
        .collect();
    // R₂ and R₁ of the source's vector, for a module of 2 mm; R₁ bends the other way.
    assert!((radii[0] - 25.883_299_8).abs() < 1e-6 && (radii[1] + 32.207_592_2).abs() < 1e-6, "{radii:?}");
}

/// Pixels to a millimetre.
const SCALE: f32 = 4.0;

/// A picture as pixels.
struct Picture {
    pixels: Pixmap,
    left: f64,
    top: f64,
}

impl Picture {
    fn of(scene: &Scene) -> Self {
        let tree = Tree::from_str(&svg::write(scene).unwrap(), &Options::default()).unwrap();
        let bounds = scene.bounds().grown(svg::MARGIN_MM);
        let scale = SCALE * 25.4 / 96.0;
        let pixels = |size: f32| (size * scale).ceil() as u32;
        let mut map = Pixmap::new(pixels(tree.size().width()), pixels(tree.size().height())).unwrap();
        resvg::render(&tree, Transform::from_scale(scale, scale), &mut map.as_mut());
        Self { pixels: map, left: bounds.left, top: bounds.top }
    }

    fn at(&self, point: Point) -> Color {
        let pixel = |mm: f64| (mm * f64::from(SCALE)) as u32;
        let color = self.pixels.pixel(pixel(point.x - self.left), pixel(self.top - point.y)).unwrap();
        Color::new(color.red(), color.green(), color.blue())
    }
}

#[test]
fn filling_chambers_are_red_and_emptying_ones_blue() {
    for motor in &known()[..3] {
        let rotation = Angle::new::<radian>(0.35);
        let picture = Picture::of(&chambers(motor, rotation).unwrap());
        let all = motor.chambers(rotation).unwrap();
        let mut seen = [0, 0];
        for chamber in &all {
            // Just inside the middle of the stator's wall.
            let wall = motor.chamber_outline(rotation, chamber.index, 48).unwrap()[24];
            let inward = 1.0 - (0.6 * motor.module() / wall.x.hypot(wall.y)).get::<ratio>();
            let [x, y] = [wall.x, wall.y].map(|x| inward * x.get::<millimeter>());
            let color = picture.at(Point::new(x, y));
            match Phase::of(chamber, &all) {
                Phase::Filling => {
                    assert!(color.red > 180 && color.blue < 160, "{chamber:?} {color:?}");
                    seen[0] += 1;
                }
                Phase::Emptying => {
                    assert!(color.blue > 180 && color.red < 160, "{chamber:?} {color:?}");
                    seen[1] += 1;
                }
                Phase::AtExtreme => {}
            }
        }
        assert!(seen[0] >= 3 && seen[1] >= 3, "{seen:?}");
    }
}

#[test]
fn bodies_are_drawn_over_the_ports() {
    let motor = &known()[2];
    let rotation = turned(20.0);
    let picture = Picture::of(&whole(motor, rotation).unwrap());
    let grey = |color: Color| color.red.abs_diff(color.blue) < 20 && color.red > 200;
    for satellite in motor.satellites(rotation).unwrap() {
        let [x, y] = [satellite.centre.x, satellite.centre.y].map(|x| x.get::<millimeter>());
        // Beside the mark in its middle.
        assert!(
            grey(picture.at(Point::new(x + 1.0, y + 1.0))) || grey(picture.at(Point::new(x - 1.0, y - 1.0)))
        );
    }
    assert!(grey(picture.at(Point::new(3.0, 3.0))));
    let ports = motor.ports();
    let color = |port: &epicyclic_hydromotor::forces::Port| {
        let angle = port.angle.get::<radian>();
        picture.at(Point::polar(Point::default(), port.centre_radius.get::<millimeter>(), angle))
    };
    let red = ports.high.iter().filter(|port| color(port).red > color(port).blue.saturating_add(60)).count();
    let blue = ports.low.iter().filter(|port| color(port).blue > color(port).red.saturating_add(60)).count();
    assert!(red >= 2 && blue >= 2, "{red} {blue}");
}

#[test]
fn every_tooth_is_drawn_once_and_satellites_leave_the_others_visible() {
    for motor in &known()[..3] {
        let profile = Profile::new(motor, ToothForm::default()).unwrap();
        let scene = teeth(&profile, turned(20.0)).unwrap();
        no_label_meets_a_line("teeth", &scene).unwrap();
        let vertices = |layer: &str| -> Vec<usize> {
            let of_layer = scene.items().iter().filter(|item| scene.layer_of(item).name == layer);
            of_layer
                .map(|item| match &item.shape {
                    Shape::Polyline { vertices, closed: true } => vertices.len(),
                    other => panic!("{other:?}"),
                })
                .collect()
        };
        let numbers = motor.numbers();
        assert_eq!(vertices("stator teeth"), [120 * numbers.stator_teeth() as usize]);
        assert_eq!(vertices("rotor teeth"), [120 * numbers.rotor_teeth() as usize]);
        let satellites = vertices("satellite teeth");
        assert_eq!(satellites, vec![120 * numbers.satellite_teeth() as usize; numbers.satellites() as usize]);
    }
}

#[test]
fn the_sides_of_the_teeth_miss_the_curves_by_what_the_picture_says() {
    let profile = Profile::new(&known()[0], ToothForm::default()).unwrap();
    let scene = teeth(&profile, turned(0.0)).unwrap();
    let said = scene.items().iter().find_map(|item| match &item.shape {
        Shape::Text(text) => text.content.strip_prefix("about ")?.split(' ').next()?.parse::<f64>().ok(),
        _ => None,
    });
    let points = |count| {
        let outline = profile.outline(Wheel::Rotor, count).unwrap();
        let points = outline.points.iter().map(|point| [point.x, point.y].map(|x| x.get::<millimeter>()));
        points.collect::<Vec<_>>()
    };
    let drawn: Vec<Vertex> =
        points(120 * 33).into_iter().map(|at| Vertex { at: at.into(), bulge: 0.0 }).collect();
    let missed = points(1000 * 33)[..11_000]
        .iter()
        .step_by(7)
        .map(|&point| distance(&drawn, point))
        .fold(0.0, f64::max);
    assert!(missed <= said.unwrap() && missed > 0.02 * said.unwrap(), "{missed} {said:?}");
}

#[test]
fn motors_of_any_size_are_drawn_or_refused() {
    let numbers = MotorNumbers::new(5, 3, 55, 10).unwrap();
    for exponent in [-300, -30, -9, -4, -3, 0, 1, 2, 3, 4, 9, 36, 150, 300] {
        let module = mm(10_f64.powi(exponent));
        let family = Family::new(numbers, module);
        assert_eq!(family.is_ok(), (-3..=3).contains(&exponent), "1e{exponent} mm");
        let Ok(family) = family else { continue };
        let arcs = family.at_part(0.5).unwrap();
        let motor = Motor::of_two_arcs(numbers, module, arcs.trough_distance()).unwrap();
        let drawn = centrodes(&motor, turned(10.0)).is_ok_and(|scene| svg::write(&scene).is_ok());
        assert!(drawn, "1e{exponent} mm");
    }
    // Far from 0 an angle loses its digits, not its picture.
    let scene = chambers(&known()[0], Angle::new::<radian>(1e16)).unwrap();
    assert!(svg::write(&scene).is_ok());
}
