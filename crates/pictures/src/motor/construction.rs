//! The construction of half a lobe: the stator's two arcs by system (1), and `P₁`, where the rotor's arcs
//! meet, by (2)–(8).
//!
//! The satellite is where the stator's arcs meet, at `P`. By Kennedy's theorem the line `OP` meets its circle
//! in `P` and in `P₁`, its contact with the rotor. `T` is the angle from the stator's trough to that line,
//! `Π` from the rotor's trough.

use std::f64::consts::PI;

use epicyclic_drawing::{Bounds, Color, Dash, LayerId, Point, Scene, Shape, Style, Vertex};
use epicyclic_hydromotor::MotorNumbers;
use epicyclic_hydromotor::arcs::StatorArcs;
use epicyclic_hydromotor::closure::{Closure, closure};
use epicyclic_hydromotor::junction::{Junction, junction, rolled};
use epicyclic_hydromotor::motor::SatelliteContact;
use epicyclic_units::Physical;
use uom::si::f64::{Angle, Length};

use super::sheet::{AUXILIARY, Sheet, millimetres, name, number};
use crate::Error;

/// Distance outside the stator, over its greatest radius, up to which a centre of arc 1 is drawn.
const REACH: f64 = 1.9;

/// Points of the rotor's curve on the image of each arc.
const POINTS: u32 = 60;

/// Half a lobe of a stator of two arcs, closed or not, with the half-lobe that it rolls on the rotor.
///
/// # Errors
/// [`Error::Motor`] for arcs on which no satellite rolls, [`Error::Drawing`] for a motor too large for a
/// drawing.
pub fn construction(numbers: MotorNumbers, arcs: &StatorArcs) -> Result<Scene, Error> {
    let (found, points) = (junction(numbers, arcs)?, rolled(numbers, arcs, POINTS)?);
    let figure = Figure::new(arcs, &found, &points);
    let name = name(numbers, arcs.module());
    let mut sheet = Sheet::of(&name, "construction", figure.width() / 75.0);
    let stator = sheet.layer("stator", Style::line(0.5))?;
    let rotor = sheet.layer("rotor", Style::line(0.5).color(Color::new(140, 60, 20)))?;
    let satellite = sheet.layer("satellite", Style::line(0.25).color(Color::new(30, 110, 60)))?;
    let rays = sheet.layer("axes", Style::line(0.12).color(AUXILIARY).dash(Dash::DashDot))?;
    let lines = sheet.layer("construction", Style::line(0.2).color(Color::new(40, 70, 130)))?;
    let gap = sheet.layer("gap", Style::line(0.3).color(Color::new(190, 30, 60)).dash(Dash::Dashed))?;

    figure.stator(&mut sheet, stator);
    sheet.scene.add(rotor, Shape::polyline(figure.rotor.iter().copied()));
    let r = arcs.module().mm() * f64::from(numbers.satellite_teeth()) / 2.0;
    let centre = Point::polar(figure.o2, figure.r2 - r, figure.beta);
    sheet.circle(satellite, centre, r);
    sheet.circle(satellite, centre, 0.4 * sheet.unit);
    let closed = closure(numbers, arcs)?;
    let due = figure.rotor_trough + PI / f64::from(numbers.rotor_lobes());
    let [from, to] =
        [0.35, 1.1].map(|part| Point::polar(Point::default(), part * figure.rotor_crest_radius, due));
    if !closed.closes() {
        sheet.line(gap, from, to);
    }
    figure.draw(&mut sheet, rays, lines);
    if !closed.closes() {
        sheet.label(gap, to, &format!("π/{}", numbers.rotor_lobes()));
    }

    let bounds = sheet.scene.bounds();
    let top = Point::new(bounds.left, bounds.bottom - 3.0 * sheet.letter());
    sheet.open(top, &name)?;
    for words in words(arcs, &found, &closed) {
        sheet.say(&words);
    }
    Ok(sheet.scene)
}

/// Lines of text below the picture.
fn words(arcs: &StatorArcs, found: &Junction, closed: &Closure) -> Vec<String> {
    let length = |length: Length| millimetres(length.mm());
    let angle = |angle: Angle| format!("{}°", number(angle.degrees()));
    let open = closed.open();
    let by = number(open.degrees().abs());
    let closes = if closed.closes() {
        "Rotor: closes".to_owned()
    } else if open.degrees() > 0.0 {
        format!("Rotor: half a lobe stays open by {by}°, to the dashes")
    } else {
        format!("Rotor: half a lobe overlaps the next by {by}°, from the dashes")
    };
    vec![
        format!("(1)  l = {}, a = {}", length(arcs.trough_distance()), length(arcs.crest_distance())),
        format!("R₁ = {}, R₂ = {}", length(arcs.trough_radius()), length(arcs.crest_radius())),
        format!(
            "θ₃ = {}, Γ = {}, B = {}",
            angle(arcs.piece_angle()),
            angle(arcs.trough_angle()),
            angle(arcs.crest_angle())
        ),
        format!("(4) OP = {},  (2) OP₁ = {}", length(found.stator_radius), length(found.rotor_radius)),
        format!("(3) b = {},  (6) h = {},  (7) k = {}", number(found.b), number(found.h), number(found.k)),
        format!("(5) Π = {},  (8) T = {}", angle(found.rotor_angle), angle(found.stator_angle)),
        closes,
    ]
}

/// Places and angles of the picture, mm and rad, in the frame of the stator: its crest on the x axis.
struct Figure {
    theta: f64,
    gamma: f64,
    beta: f64,
    r1: f64,
    r2: f64,
    o1: Point,
    o2: Point,
    p: Point,
    p1: Point,
    /// Direction of the line `OP`.
    to_p: f64,
    /// Directions of the rotor's trough and crest.
    rotor_trough: f64,
    rotor_crest: f64,
    rotor_crest_radius: f64,
    /// The rotor's curve from crest to trough.
    rotor: Vec<Point>,
    /// The stator's greatest radius.
    outer: f64,
    /// Whether `O₁` is within the picture.
    is_near: bool,
}

impl Figure {
    fn new(arcs: &StatorArcs, found: &Junction, points: &[SatelliteContact]) -> Self {
        let o = Point::default();
        let theta = arcs.piece_angle().si();
        let (l, a) = (arcs.trough_distance().mm(), arcs.crest_distance().mm());
        let (r1, r2) = (arcs.trough_radius().mm(), arcs.crest_radius().mm());
        let to_p = theta - found.stator_angle.si();
        let rotor_trough = to_p - found.rotor_angle.si();
        let span = points.last().map_or(0.0, |trough| trough.rotor_angle.si());
        let rotor_crest = rotor_trough + span;
        // The rotor's angles run against those of the stator, from its crest.
        let on_rotor = |contact: &SatelliteContact| {
            Point::polar(o, contact.rotor_radius.mm(), rotor_crest - contact.rotor_angle.si())
        };
        let rotor: Vec<Point> = points.iter().map(on_rotor).collect();
        let outer = a + r2;
        Self {
            theta,
            gamma: arcs.trough_angle().si(),
            beta: arcs.crest_angle().si(),
            r1,
            r2,
            o1: Point::polar(o, l, theta),
            o2: Point::new(a, 0.0),
            p: Point::polar(o, found.stator_radius.mm(), to_p),
            p1: Point::polar(o, found.rotor_radius.mm(), to_p),
            to_p,
            rotor_trough,
            rotor_crest,
            rotor_crest_radius: points.first().map_or(outer, |crest| crest.rotor_radius.mm()),
            rotor,
            outer,
            is_near: l <= REACH * outer,
        }
    }

    /// `O₁`, or as much of the way to it as the picture has room for.
    fn towards_o1(&self) -> Point {
        if self.is_near { self.o1 } else { Point::polar(Point::default(), 1.15 * self.outer, self.theta) }
    }

    fn width(&self) -> f64 {
        let all = [self.towards_o1(), Point::new(1.06 * self.outer, 0.0), Point::default(), self.p];
        Bounds::of(all.into_iter().chain(self.rotor.iter().copied())).width()
    }

    fn stator(&self, sheet: &mut Sheet, layer: LayerId) {
        let trough = Point::polar(self.o1, self.r1, self.theta + PI);
        let vertices = vec![
            Vertex { at: Point::new(self.outer, 0.0), bulge: libm::tan(0.25 * self.beta) },
            Vertex { at: self.p, bulge: -libm::tan(0.25 * self.gamma) },
            Vertex { at: trough, bulge: 0.0 },
        ];
        sheet.scene.add(layer, Shape::Polyline { vertices, closed: false });
    }

    /// Rays, lines, angles, and their letters.
    fn draw(&self, sheet: &mut Sheet, rays: LayerId, lines: LayerId) {
        let o = Point::default();
        let far = self.towards_o1();
        sheet.line(rays, o, Point::new(1.06 * self.outer, 0.0));
        sheet.line(rays, o, far);
        for ray in [self.rotor_trough, self.rotor_crest] {
            sheet.line(rays, o, Point::polar(o, 1.06 * self.rotor_crest_radius, ray));
        }
        sheet.line(lines, self.o2, self.p);
        sheet.line(lines, o, self.p);
        let mark = 0.6 * sheet.unit;
        for at in [o, self.o2, self.p, self.p1] {
            sheet.circle(lines, at, mark);
        }
        let op1 = libm::hypot(self.p1.x, self.p1.y);
        let inward = self.theta + PI;
        let mut angles = vec![
            ("B", self.o2, 0.4 * self.r2, [0.0, self.beta]),
            ("θ₃", o, 0.3 * op1, [0.0, self.theta]),
            ("Π", o, 0.55 * op1, [self.rotor_trough, self.to_p]),
            ("T", o, 0.8 * op1, [self.to_p, self.theta]),
        ];
        let mut lengths = vec![("R₂", self.o2, self.p), ("a", o, self.o2)];
        if self.is_near {
            sheet.line(lines, self.p, self.o1);
            sheet.circle(lines, self.o1, mark);
            angles.push(("Γ", self.o1, 0.55 * self.r1, [inward, inward + self.gamma]));
            let outside = Point::polar(o, self.outer, self.theta);
            lengths.extend([("R₁", self.p, self.o1), ("l", self.o1, outside)]);
        } else {
            sheet.arrowhead(lines, far, self.theta);
        }
        for &(_, centre, radius, [from, to]) in &angles {
            sheet.scene.add(lines, Shape::Arc { centre, radius, start_rad: from, sweep_rad: to - from });
        }
        // Letters last: each keeps clear of all that is drawn before it.
        for (letter, at, radius, directions) in angles {
            within(sheet, lines, letter, at, radius, directions);
        }
        for (letter, from, to) in lengths {
            along(sheet, lines, letter, from, to);
        }
        let mut points = vec![
            (o, "O"),
            (self.o2, "O₂"),
            (self.p, "P"),
            (self.p1, "P₁"),
            (Point::new(self.outer, 0.0), "stator"),
        ];
        points.extend(self.rotor.last().map(|trough| (*trough, "rotor")));
        points.push(if self.is_near { (self.o1, "O₁") } else { (far, "to O₁") });
        for (at, words) in points {
            sheet.label(lines, at, words);
        }
    }
}

/// The letter of an angle between two directions at a point, by its arc on the bisector.
fn within(sheet: &mut Sheet, layer: LayerId, letter: &str, at: Point, radius: f64, [from, to]: [f64; 2]) {
    let middle = 0.5 * (from + to);
    // Beside the bisector where a line lies on it.
    let directions = [0.0, 0.2, -0.2, 0.35, -0.35].map(|part| middle + part * (to - from));
    let offsets = [-0.9, 1.1, -1.3, 1.6, 2.2, 2.9, 3.6].map(|letters| radius + letters * sheet.letter());
    let places = offsets.into_iter().flat_map(|radius| directions.map(|way| Point::polar(at, radius, way)));
    if !sheet.label_at(layer, places, letter) {
        sheet.label(layer, Point::polar(at, radius, middle), letter);
    }
}

/// Writes a letter close to a line, to the right of its direction if it has room there.
fn along(sheet: &mut Sheet, layer: LayerId, letter: &str, from: Point, to: Point) {
    let direction = libm::atan2(to.y - from.y, to.x - from.x);
    let part = |part: f64| Point::new(from.x + part * (to.x - from.x), from.y + part * (to.y - from.y));
    let offset = 1.1 * sheet.letter();
    let beside = [0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8].into_iter().flat_map(|along| {
        [-PI / 2.0, PI / 2.0].map(|side| Point::polar(part(along), offset, direction + side))
    });
    if !sheet.label_at(layer, beside, letter) {
        sheet.label(layer, part(0.5), letter);
    }
}
