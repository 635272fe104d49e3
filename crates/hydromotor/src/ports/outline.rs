//! The outline of a port: a closed loop of arcs and straight sides, counter-clockwise, in units of the
//! module.

use crate::quantity::Quantity;
use std::f64::consts::{PI, TAU};

use crate::Error;
use crate::modules::modules;
use crate::ports::PortShape;
use crate::ranges::{finite_angle, positive_modules};
use crate::tolerance::SLACK;
use epicyclic_units::Physical;
use uom::si::f64::{Angle, Length};

/// A straight side or an arc.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Piece {
    /// Straight side from one point to another.
    Line([f64; 2], [f64; 2]),
    /// Arc about a centre: radius, start and sweep; a negative sweep is clockwise.
    Arc([f64; 2], f64, f64, f64),
}

impl Piece {
    /// The point after a part of it.
    pub(crate) fn at(&self, part: f64) -> [f64; 2] {
        match *self {
            Self::Line(from, to) => [0, 1].map(|i| from[i] + part * (to[i] - from[i])),
            Self::Arc(centre, radius, start, sweep) => {
                let (sin, cos) = libm::sincos(start + part * sweep);
                [centre[0] + radius * cos, centre[1] + radius * sin]
            }
        }
    }

    /// Length of the piece from end to end.
    pub(crate) fn length(&self) -> f64 {
        match *self {
            Self::Line(from, to) => libm::hypot(to[0] - from[0], to[1] - from[1]),
            Self::Arc(_, radius, _, sweep) => radius * sweep.abs(),
        }
    }

    /// `½∮(x·dy − y·dx)` between two parts of it.
    pub(crate) fn swept(&self, from: f64, to: f64) -> f64 {
        match *self {
            Self::Line(..) => {
                let (a, b) = (self.at(from), self.at(to));
                0.5 * (a[0] * b[1] - a[1] * b[0])
            }
            Self::Arc(centre, radius, start, sweep) => {
                let (a, b) = (start + from * sweep, start + to * sweep);
                let across =
                    centre[0] * (libm::sin(b) - libm::sin(a)) - centre[1] * (libm::cos(b) - libm::cos(a));
                0.5 * radius * (radius * (b - a) + across)
            }
        }
    }

    /// Whether the piece is an arc that covers the direction of a point from its centre.
    pub(crate) fn faces(&self, [x, y]: [f64; 2]) -> bool {
        let Self::Arc(centre, _, start, sweep) = *self else { return false };
        let angle = libm::atan2(y - centre[1], x - centre[0]);
        let turn = if sweep > 0.0 { angle - start } else { start - angle };
        turn.rem_euclid(TAU) <= sweep.abs()
    }

    /// Points of the piece whose normal goes through a point.
    pub(crate) fn normal_to(&self, point: [f64; 2]) -> Vec<[f64; 2]> {
        match *self {
            Self::Line(from, to) => {
                let along = [to[0] - from[0], to[1] - from[1]];
                let square = along[0] * along[0] + along[1] * along[1];
                let part = (along[0] * (point[0] - from[0]) + along[1] * (point[1] - from[1])) / square;
                if (0.0..=1.0).contains(&part) { vec![self.at(part)] } else { vec![] }
            }
            Self::Arc(centre, radius, ..) => {
                let off = [0, 1].map(|i| point[i] - centre[i]);
                let apart = libm::hypot(off[0], off[1]);
                let at = |side: f64| [0, 1].map(|i| centre[i] + side * radius * off[i] / apart);
                [1.0, -1.0].map(at).into_iter().filter(|&at| self.faces(at)).collect()
            }
        }
    }

    /// Point of the piece nearest to another.
    pub(crate) fn nearest(&self, point: [f64; 2]) -> [f64; 2] {
        let apart = |[x, y]: &[f64; 2]| libm::hypot(x - point[0], y - point[1]);
        let mut nearest = self.at(0.0);
        for other in std::iter::once(self.at(1.0)).chain(self.normal_to(point)) {
            if apart(&other) < apart(&nearest) {
                nearest = other;
            }
        }
        nearest
    }

    /// Parts at which it crosses a circle.
    pub(crate) fn across_circle(&self, centre: [f64; 2], radius: f64) -> Vec<f64> {
        let inside = |part: &f64| (0.0..=1.0).contains(part);
        match *self {
            Self::Line(from, to) => {
                let along = [to[0] - from[0], to[1] - from[1]];
                let off = [from[0] - centre[0], from[1] - centre[1]];
                let a = along[0] * along[0] + along[1] * along[1];
                let b = along[0] * off[0] + along[1] * off[1];
                let c = off[0] * off[0] + off[1] * off[1] - radius * radius;
                let square = b * b - a * c;
                if square <= 0.0 || a == 0.0 {
                    return vec![];
                }
                [-1.0, 1.0].map(|side| (-b + side * square.sqrt()) / a).into_iter().filter(inside).collect()
            }
            Self::Arc(own, own_radius, start, sweep) => {
                let (dx, dy) = (centre[0] - own[0], centre[1] - own[1]);
                let apart = libm::hypot(dx, dy);
                let cosine =
                    (apart * apart + own_radius * own_radius - radius * radius) / (2.0 * apart * own_radius);
                if apart == 0.0 || !(-1.0..1.0).contains(&cosine) {
                    return vec![];
                }
                let (towards, half) = (libm::atan2(dy, dx), libm::acos(cosine));
                let part = |angle: f64| {
                    let turn = if sweep > 0.0 { angle - start } else { start - angle };
                    turn.rem_euclid(TAU) / sweep.abs()
                };
                [towards - half, towards + half].map(part).into_iter().filter(inside).collect()
            }
        }
    }
}

/// A port in the module's units, turned to an angle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Port {
    /// Radius of the hole, distance of its centre from the axis, polar angle.
    Hole(f64, f64, f64),
    /// Inner and outer radius, polar angle of the middle, half the span, radius of the corners.
    Kidney(f64, f64, f64, f64, f64),
}

impl Port {
    /// Checks a shape.
    pub(crate) fn new(shape: PortShape, module: Length, lobes: u32) -> Result<Self, Error> {
        match shape {
            PortShape::Hole { diameter, pitch_radius, angle } => Ok(Self::Hole(
                0.5 * positive_modules(Quantity::HoleDiameter, diameter, module)?,
                positive_modules(Quantity::PitchCircleRadius, pitch_radius, module)?,
                finite_angle(Quantity::PortAngle, angle)?,
            )),
            PortShape::Kidney { inner_radius, outer_radius, angle, span, corner } => {
                let inner = positive_modules(Quantity::KidneyInnerRadius, inner_radius, module)?;
                let outer = positive_modules(Quantity::KidneyOuterRadius, outer_radius, module)?;
                let angle = finite_angle(Quantity::PortAngle, angle)?;
                let half = 0.5 * finite_angle(Quantity::KidneySpan, span)?;
                let corner = modules(corner, module);
                let millimetre = module.mm();
                if outer <= inner {
                    let [value, low] = [outer, inner].map(|value| value * millimetre);
                    let quantity = Quantity::KidneyOuterRadius;
                    return Err(Error::OutOfRange { quantity, value, low, high: f64::INFINITY, unit: "mm" });
                }
                // The corners take half the height at most, and their arcs the span.
                let fits = |corner: f64| {
                    2.0 * corner <= (outer - inner) * (1.0 + SLACK)
                        && libm::asin(corner / (inner + corner)) <= half
                };
                if !(corner >= 0.0 && fits(corner)) {
                    let by_span = {
                        let sine = libm::sin(half.min(0.5 * PI));
                        if sine < 1.0 { inner * sine / (1.0 - sine) } else { f64::INFINITY }
                    };
                    let high = by_span.min(0.5 * (outer - inner)) * millimetre;
                    let (quantity, value) = (Quantity::KidneyCorner, corner * millimetre);
                    return Err(Error::OutOfRange { quantity, value, low: 0.0, high, unit: "mm" });
                }
                let most = PI / f64::from(lobes);
                if !(half > 0.0 && half < most) {
                    let (quantity, value) = (Quantity::KidneySpan, span.degrees());
                    let high = Angle::from_si(2.0 * most).degrees();
                    return Err(Error::OutOfRange { quantity, value, low: 0.0, high, unit: "°" });
                }
                Ok(Self::Kidney(inner, outer, angle, half, corner.min(0.5 * (outer - inner))))
            }
        }
    }

    /// Returns the port turned about the axis.
    pub(crate) fn turned(self, by: f64) -> Self {
        match self {
            Self::Hole(radius, distance, angle) => Self::Hole(radius, distance, angle + by),
            Self::Kidney(inner, outer, angle, half, corner) => {
                Self::Kidney(inner, outer, angle + by, half, corner)
            }
        }
    }

    /// Least and greatest distance from the axis.
    pub(crate) fn radii(&self) -> [f64; 2] {
        match *self {
            Self::Hole(radius, distance, _) => [(distance - radius).max(0.0), distance + radius],
            Self::Kidney(inner, outer, ..) => [inner, outer],
        }
    }

    /// Polar angle of the middle, and half the angle that it takes.
    pub(crate) fn reach(&self) -> [f64; 2] {
        match *self {
            Self::Hole(radius, distance, angle) => {
                [angle, if radius < distance { libm::asin(radius / distance) } else { PI }]
            }
            Self::Kidney(_, _, angle, half, _) => [angle, half],
        }
    }

    pub(crate) fn area(&self) -> f64 {
        self.pieces().iter().map(|piece| piece.swept(0.0, 1.0)).sum()
    }

    /// Whether a point lies within.
    pub(crate) fn contains(&self, [x, y]: [f64; 2]) -> bool {
        match *self {
            Self::Hole(radius, distance, angle) => {
                let (sin, cos) = libm::sincos(angle);
                libm::hypot(x - distance * cos, y - distance * sin) < radius
            }
            Self::Kidney(inner, outer, angle, half, corner) => {
                let rho = libm::hypot(x, y);
                let off = (libm::atan2(y, x) - angle + PI).rem_euclid(TAU) - PI;
                let edge = half - off.abs();
                if rho <= inner || rho >= outer || edge <= 0.0 {
                    return false;
                }
                // In the frame of the edge: along it, and away from it.
                let (along, away) = (rho * libm::cos(edge), rho * libm::sin(edge));
                let rounded_off = |centre: f64, side: f64| {
                    let foot = (centre * centre - corner * corner).max(0.0).sqrt();
                    let in_corner = side * (along - foot) > 0.0 && edge < libm::asin(corner / centre);
                    in_corner && libm::hypot(along - foot, away - corner) >= corner
                };
                corner == 0.0 || !(rounded_off(outer - corner, 1.0) || rounded_off(inner + corner, -1.0))
            }
        }
    }

    /// The outline, counter-clockwise.
    pub(crate) fn pieces(&self) -> Vec<Piece> {
        match *self {
            Self::Hole(radius, distance, angle) => {
                let (sin, cos) = libm::sincos(angle);
                let centre = [distance * cos, distance * sin];
                vec![Piece::Arc(centre, radius, angle, PI), Piece::Arc(centre, radius, angle + PI, PI)]
            }
            Self::Kidney(inner, outer, angle, half, corner) => {
                let polar = |rho: f64, theta: f64| [rho * libm::cos(theta), rho * libm::sin(theta)];
                let [out, into] = [outer - corner, inner + corner];
                let [out_turn, in_turn] = [out, into].map(|centre| half - libm::asin(corner / centre));
                let [out_foot, in_foot] =
                    [out, into].map(|centre| (centre * centre - corner * corner).max(0.0).sqrt());
                let (low, high) = (angle - half, angle + half);
                let axis = [0.0, 0.0];
                let mut pieces = vec![Piece::Arc(axis, outer, angle - out_turn, 2.0 * out_turn)];
                let round = |pieces: &mut Vec<Piece>, centre: [f64; 2], start: f64, end: f64| {
                    if corner > 0.0 {
                        pieces.push(Piece::Arc(centre, corner, start, end - start));
                    }
                };
                round(&mut pieces, polar(out, angle + out_turn), angle + out_turn, high + 0.5 * PI);
                pieces.push(Piece::Line(polar(out_foot, high), polar(in_foot, high)));
                round(&mut pieces, polar(into, angle + in_turn), high + 0.5 * PI, angle + in_turn + PI);
                pieces.push(Piece::Arc(axis, inner, angle + in_turn, -2.0 * in_turn));
                round(&mut pieces, polar(into, angle - in_turn), angle - in_turn + PI, low + 1.5 * PI);
                pieces.push(Piece::Line(polar(in_foot, low), polar(out_foot, low)));
                round(&mut pieces, polar(out, angle - out_turn), low - 0.5 * PI, angle - out_turn);
                pieces
            }
        }
    }
}
