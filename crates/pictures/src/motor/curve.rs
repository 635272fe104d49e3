//! Centrodes as closed polylines of arcs: exact where the curve consists of arcs, else biarcs with their
//! deviation.
//!
//! Between two points of a smooth curve, with its directions there, a *biarc* is a pair of arcs that touch
//! each other and the curve's ends in those directions. With the step `v`, the directions `t₀`, `t₁` and
//! `t = t₀ + t₁`
//!
//! ```text
//! d = v·v/(v·t + √((v·t)² + 2·(1 − t₀·t₁)·v·v))        P_m = (P₀ + P₁ + d·(t₀ − t₁))/2
//! ```
//!
//! for arcs whose tangents have one length `d`. The pieces are halved until the exact curve, looked at in
//! nine places of each, lies within [`TOLERANCE_MM`].

use std::f64::consts::TAU;

use epicyclic_drawing::{Point, Vertex};
use epicyclic_hydromotor::Motor;
use epicyclic_hydromotor::centrode::{Centrode, CurvePoint, Wheel};
use epicyclic_units::Physical;
use uom::si::f64::Length;

use crate::Error;
use crate::tolerance::CURVE;

/// The greatest distance between a curve that is no arc and the arcs drawn for it. For a curve longer than a
/// kilometre it is a ten-billionth of its length, the precision of coordinates.
pub const TOLERANCE_MM: f64 = 1e-4;

/// Number of places of a piece at which its distance is evaluated.
const PLACES: u32 = 9;

/// Largest number of halvings of a piece.
const MOST_HALVINGS: u32 = 16;

/// A closed curve of arcs, counter-clockwise.
#[derive(Debug, Clone, PartialEq)]
pub struct Outline {
    /// Vertices, each with the bulge of the arc that follows.
    pub vertices: Vec<Vertex>,
    /// Greatest distance of the exact curve from the outline; 0 of exact arcs.
    pub deviation_mm: f64,
}

impl Outline {
    /// Outline turned about the axis.
    pub(super) fn turned(mut self, angle_rad: f64) -> Self {
        for vertex in &mut self.vertices {
            vertex.at = turned(vertex.at, angle_rad);
        }
        self
    }
}

pub(super) fn turned(point: Point, angle_rad: f64) -> Point {
    let (sin, cos) = libm::sincos(angle_rad);
    Point::new(point.x * cos - point.y * sin, point.x * sin + point.y * cos)
}

/// The centrode of a wheel in its own frame: `2N` exact arcs for a stator of two arcs, a circle for a
/// satellite, else biarcs.
///
/// # Errors
/// [`Error::Motor`] where a curve has no point; of a closed motor it has.
///
/// # Example
/// ```
/// use epicyclic_hydromotor::centrode::Wheel;
/// use epicyclic_hydromotor::{Motor, MotorNumbers};
/// use epicyclic_pictures::motor::outline;
/// use uom::si::{f64::Length, length::millimeter};
///
/// let mm = Length::new::<millimeter>;
/// let motor = Motor::of_two_arcs(MotorNumbers::new(5, 3, 55, 10)?, mm(2.0), mm(80.0))?;
/// let (stator, rotor) = (outline(&motor, Wheel::Stator)?, outline(&motor, Wheel::Rotor)?);
/// assert_eq!((stator.vertices.len(), stator.deviation_mm), (10, 0.0));
/// assert!(rotor.deviation_mm < 1e-4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn outline(motor: &Motor, wheel: Wheel) -> Result<Outline, Error> {
    match (wheel, motor.arcs()) {
        (Wheel::Stator, Some(arcs)) => {
            let (a, r2, beta) =
                (arcs.crest_distance().mm(), arcs.crest_radius().mm(), arcs.crest_angle().si());
            let gamma = arcs.trough_angle().si();
            let junction = Point::new(a + r2 * libm::cos(beta), r2 * libm::sin(beta));
            let lobes = motor.numbers().stator_lobes();
            let of_lobe = |lobe: u32| {
                let turn = TAU * f64::from(lobe) / f64::from(lobes);
                let before = turned(Point::new(junction.x, -junction.y), turn);
                [
                    Vertex { at: before, bulge: libm::tan(0.5 * beta) },
                    Vertex { at: turned(junction, turn), bulge: -libm::tan(0.5 * gamma) },
                ]
            };
            Ok(Outline { vertices: (0..lobes).flat_map(of_lobe).collect(), deviation_mm: 0.0 })
        }
        (Wheel::Satellite, _) => {
            let r = motor.satellite_radius().mm();
            let half = |x: f64| Vertex { at: Point::new(x, 0.0), bulge: 1.0 };
            Ok(Outline { vertices: vec![half(r), half(-r)], deviation_mm: 0.0 })
        }
        _ => biarcs(motor, wheel),
    }
}

fn biarcs(motor: &Motor, wheel: Wheel) -> Result<Outline, Error> {
    let curve = motor.centrode(wheel);
    let lobes = match wheel {
        Wheel::Stator => motor.numbers().stator_lobes(),
        _ => motor.numbers().rotor_lobes(),
    };
    let half = curve.length().mm() / f64::from(2 * lobes);
    let tolerance_mm = TOLERANCE_MM.max(CURVE * curve.length().mm());
    // The curvature jumps where the images of the stator's arcs meet: a piece ends there.
    let mut ends = vec![0.0];
    if let Some(arcs) = motor.arcs() {
        let rolled = arcs.crest_radius() * arcs.crest_angle().si();
        ends.push(motor.contact_at_stator_arc(rolled)?.rotor_arc.mm());
    }
    ends.push(half);
    let (mut nodes, mut deviation_mm) = (vec![], 0.0_f64);
    for pair in ends.windows(2) {
        deviation_mm = deviation_mm.max(pieces(&curve, [pair[0], pair[1]], tolerance_mm, 0, &mut nodes)?);
    }
    nodes.push(half);
    // There and back for each lobe.
    let back: Vec<f64> = nodes.iter().rev().skip(1).map(|s| 2.0 * half - s).collect();
    nodes.extend(back);
    nodes.pop();
    let mut points = vec![];
    for lobe in 0..lobes {
        for node in &nodes {
            points.push(curve.at(Length::from_mm(node + 2.0 * half * f64::from(lobe)))?);
        }
    }
    let next = points.iter().cycle().skip(1);
    let vertices = points.iter().zip(next).flat_map(|(one, next)| Biarc::new(one, next).vertices());
    Ok(Outline { vertices: vertices.collect(), deviation_mm })
}

/// Start points of the pieces of the curve, and the distance of the curve from the pieces. Pieces are halved
/// until each is near enough or [`MOST_HALVINGS`] are reached.
fn pieces(
    curve: &Centrode<'_>,
    [from, to]: [f64; 2],
    tolerance_mm: f64,
    halvings: u32,
    nodes: &mut Vec<f64>,
) -> Result<f64, Error> {
    if halvings > 0 {
        let (start, end) = (curve.at(Length::from_mm(from))?, curve.at(Length::from_mm(to))?);
        let biarc = Biarc::new(&start, &end);
        let mut missed = 0.0_f64;
        for place in 1..=PLACES {
            let point =
                curve.at(Length::from_mm(from + (to - from) * f64::from(place) / f64::from(PLACES + 1)))?;
            missed = missed.max(biarc.distance([point.x.mm(), point.y.mm()]));
        }
        if missed <= tolerance_mm || halvings > MOST_HALVINGS {
            nodes.push(from);
            return Ok(missed);
        }
    }
    let middle = 0.5 * (from + to);
    let first = pieces(curve, [from, middle], tolerance_mm, halvings + 1, nodes)?;
    Ok(first.max(pieces(curve, [middle, to], tolerance_mm, halvings + 1, nodes)?))
}

type Vector = [f64; 2];

fn less(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1]]
}

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn cross(a: Vector, b: Vector) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

/// Two arcs that touch.
#[derive(Debug, Clone, Copy)]
struct Biarc {
    start: Vector,
    middle: Vector,
    /// Directions at the start and in the middle.
    along: [Vector; 2],
    bulges: [f64; 2],
    curvatures: [f64; 2],
}

impl Biarc {
    fn new(start: &CurvePoint, end: &CurvePoint) -> Self {
        let at = |point: &CurvePoint| [point.x.mm(), point.y.mm()];
        let direction = |point: &CurvePoint| {
            let (sin, cos) = libm::sincos(point.tangent.si());
            [cos, sin]
        };
        let ([p0, p1], [t0, t1]) = ([at(start), at(end)], [direction(start), direction(end)]);
        let v = less(p1, p0);
        let along = dot(v, t0) + dot(v, t1);
        let square = dot(v, v);
        // 1 − t₀·t₁, without its cancellation.
        let turn = 0.5 * dot(less(t0, t1), less(t0, t1));
        let d = square / (along + (along * along + 2.0 * turn * square).sqrt());
        let middle = [0, 1].map(|i| 0.5 * (p0[i] + p1[i] + d * (t0[i] - t1[i])));
        let (one, other) = (less(middle, p0), less(p1, middle));
        // tan(sweep/4) from the angle between chord and tangent, half the sweep.
        let bulge = |chord: Vector, sine: f64, cosine: f64| sine / (dot(chord, chord).sqrt() + cosine);
        let bulges =
            [bulge(one, cross(t0, one), dot(t0, one)), bulge(other, cross(other, t1), dot(other, t1))];
        let curvature =
            |chord: Vector, bulge: f64| 4.0 * bulge / (1.0 + bulge * bulge) / dot(chord, chord).sqrt();
        let curvatures = [curvature(one, bulges[0]), curvature(other, bulges[1])];
        let (sin, cos) = libm::sincos(4.0 * libm::atan(bulges[0]));
        let turned = [t0[0] * cos - t0[1] * sin, t0[0] * sin + t0[1] * cos];
        Self { start: p0, middle, along: [t0, turned], bulges, curvatures }
    }

    fn vertices(self) -> [Vertex; 2] {
        [
            Vertex { at: self.start.into(), bulge: self.bulges[0] },
            Vertex { at: self.middle.into(), bulge: self.bulges[1] },
        ]
    }

    /// Distance of a point from the nearer arc.
    fn distance(&self, point: Vector) -> f64 {
        let second = usize::from(dot(less(point, self.middle), self.along[1]) > 0.0);
        let (t, kappa) = (self.along[second], self.curvatures[second]);
        let d = less(point, if second == 1 { self.middle } else { self.start });
        let (ahead, aside) = (dot(d, t), cross(t, d));
        let to_centre = libm::hypot(1.0 - kappa * aside, kappa * ahead);
        ((2.0 * aside - kappa * dot(d, d)) / (1.0 + to_centre)).abs()
    }
}
