//! The area that a port and a chamber share, exactly: Green's theorem over the pieces of both outlines.
//!
//! The contacts of a satellite lie on one ray from the axis, so that the rays of two neighbours bound the
//! chamber between them:
//!
//! ```text
//! θ₃(back) < θ < θ₃(front)        ρ₁(θ − φ) < ρ < ρ₃(θ)        outside of both satellites
//! ```
//!
//! Outlines are cut at their crossings. The parts of the port within the chamber, and the parts of the
//! chamber's walls within the port, bound the common area: `½∮(x·dy − y·dx)` over them. Arcs and straight
//! sides have it in closed form, the centrodes by the eight-point rule on their smooth pieces.

use crate::contact::{By, Conjugate};
use crate::motor::Motor;
use crate::ports::LEAST_COSINE;
use crate::ports::outline::{Piece, Port};
use crate::satellites::Place;
use epicyclic_numerics::quadrature::quadrature;
use epicyclic_numerics::roots::bracketed;
use std::f64::consts::{PI, TAU};

/// Number of places of a piece between which to look for a crossing with a centrode at first.
const PLACES: u32 = 24;

/// A piece that dips into a wall for less, over the square root of the port's area, is not followed: the
/// sliver between chord and wall, about a twelfth of the cube of this times the curvature, is less than
/// [`crate::tolerance::OPEN`].
const DIP: f64 = 1e-3;

/// Panels of the eight-point rule on a wall.
const PANELS: u32 = 4;

/// A chamber at an instant, in units of the module.
pub(crate) struct Region<'a> {
    pub(super) motor: &'a Motor,
    pub(super) rotation: f64,
    pub(super) back: Place,
    pub(super) front: Place,
    pub(super) r: f64,
}

/// A wall of a chamber along a centrode.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Wall {
    Stator,
    Rotor,
}

impl<'a> Region<'a> {
    /// The chamber in front of a satellite after a rotation.
    pub(crate) fn new(motor: &'a Motor, rotation: f64, index: u32) -> Self {
        let [back, front] = [index, index + 1].map(|index| motor.place(rotation, index));
        Self { motor, rotation, back, front, r: motor.shape.satellite_radius() }
    }

    pub(super) fn ends(&self) -> [f64; 2] {
        [self.back.contact.theta3, self.front.contact.theta3]
    }

    pub(super) fn radius(&self, wall: Wall, theta: f64) -> f64 {
        match wall {
            Wall::Stator => self.motor.shape.at(By::StatorAngle, theta).rho3,
            Wall::Rotor => self.motor.shape.at(By::RotorAngle, theta - self.rotation).rho1,
        }
    }

    /// Least and greatest radius of a wall.
    pub(super) fn radii(&self, wall: Wall) -> [f64; 2] {
        let (crest, trough) = (self.motor.shape.within(By::Phase, 0.0), self.motor.shape.trough());
        match wall {
            Wall::Stator => [trough.rho3, crest.rho3],
            Wall::Rotor => [trough.rho1, crest.rho1],
        }
    }

    /// Whether a point lies within.
    pub(crate) fn contains(&self, [x, y]: [f64; 2]) -> bool {
        let [from, to] = self.ends();
        let theta = from + (libm::atan2(y, x) - from).rem_euclid(TAU);
        let rho = libm::hypot(x, y);
        let free = |place: &Place| libm::hypot(x - place.centre[0], y - place.centre[1]) > self.r;
        theta < to
            && free(&self.back)
            && free(&self.front)
            && rho < self.radii(Wall::Stator)[1]
            && rho > self.radii(Wall::Rotor)[0]
            && rho < self.radius(Wall::Stator, theta)
            && rho > self.radius(Wall::Rotor, theta)
    }

    /// Whether a port is so far from the chamber that they share nothing.
    fn is_apart(&self, port: &Port) -> bool {
        let [from, to] = self.ends();
        let [angle, half] = port.reach();
        let (middle, width) = (0.5 * (from + to), 0.5 * (to - from));
        let off = (angle - middle + PI).rem_euclid(TAU) - PI;
        let [inner, outer] = port.radii();
        off.abs() > width + half
            || inner >= self.radii(Wall::Stator)[1]
            || outer <= self.radii(Wall::Rotor)[0]
    }

    /// The area shared with a port.
    pub(crate) fn shared(&self, port: &Port) -> f64 {
        if self.is_apart(port) {
            return 0.0;
        }
        let [inner, outer] = port.radii();
        let dip = DIP * port.area().sqrt();
        let discs = [&self.back, &self.front];
        // Angles at which a wall is cut: on the satellites about their centres, on the centrodes about the
        // axis.
        let mut on_discs = [vec![], vec![]];
        let mut on_walls = [vec![], vec![]];
        let mut sum = 0.0;
        for piece in port.pieces() {
            let mut cuts = vec![0.0, 1.0];
            for (disc, angles) in discs.iter().zip(&mut on_discs) {
                for part in piece.across_circle(disc.centre, self.r) {
                    cuts.push(part);
                    let [x, y] = piece.at(part);
                    angles.push(libm::atan2(y - disc.centre[1], x - disc.centre[0]));
                }
            }
            for (wall, angles) in [Wall::Stator, Wall::Rotor].into_iter().zip(&mut on_walls) {
                let [least, greatest] = self.radii(wall);
                if outer <= least || inner >= greatest {
                    continue;
                }
                for part in self.across_wall(&piece, wall, dip) {
                    cuts.push(part);
                    let [x, y] = piece.at(part);
                    angles.push(libm::atan2(y, x));
                }
            }
            cuts.sort_by(f64::total_cmp);
            let within =
                |pair: &&[f64]| pair[1] > pair[0] && self.contains(piece.at(0.5 * (pair[0] + pair[1])));
            sum += cuts.windows(2).filter(within).map(|pair| piece.swept(pair[0], pair[1])).sum::<f64>();
        }
        for ((disc, is_front), angles) in discs.into_iter().zip([false, true]).zip(&on_discs) {
            sum += self.of_disc(port, disc, is_front, angles);
        }
        for (wall, angles) in [Wall::Stator, Wall::Rotor].into_iter().zip(&on_walls) {
            let [least, greatest] = self.radii(wall);
            if outer > least && inner < greatest {
                sum += self.of_wall(port, wall, angles);
            }
        }
        sum.max(0.0)
    }

    /// Parts of a piece at which it crosses a centrode: between places on different sides of it, and between
    /// those on one side where so near that the piece may reach across, halved until they are nearer than
    /// `dip`.
    fn across_wall(&self, piece: &Piece, wall: Wall, dip: f64) -> Vec<f64> {
        let off = |part: f64| {
            let [x, y] = piece.at(part);
            libm::hypot(x, y) - self.radius(wall, libm::atan2(y, x))
        };
        let length = piece.length();
        let mut found = vec![];
        let mut before = (0.0, off(0.0));
        for i in 1..=PLACES {
            let part = f64::from(i) / f64::from(PLACES);
            let mut ahead = vec![(part, off(part))];
            while let Some(&next) = ahead.last() {
                let apart = (next.0 - before.0) * length;
                if (before.1 < 0.0) != (next.1 < 0.0) {
                    found.push(bracketed(before.0, next.0, off));
                } else if apart > dip && before.1.abs() + next.1.abs() < apart / LEAST_COSINE {
                    let middle = 0.5 * (before.0 + next.0);
                    ahead.push((middle, off(middle)));
                    continue;
                }
                before = next;
                ahead.pop();
            }
        }
        found
    }

    /// Contribution of the wall along a satellite: clockwise about it, from the one contact to the other.
    fn of_disc(&self, port: &Port, disc: &Place, is_front: bool, cuts: &[f64]) -> f64 {
        let (theta, mu) = (disc.contact.theta3, disc.contact.mu);
        let [from, to] = if is_front { [theta + mu - PI, theta - mu] } else { [theta - mu, theta + mu + PI] };
        let mut ends = vec![from, to];
        ends.extend(
            cuts.iter().map(|angle| from + (angle - from).rem_euclid(TAU)).filter(|&angle| angle < to),
        );
        ends.sort_by(f64::total_cmp);
        let of_pair = |pair: &[f64]| {
            let arc = Piece::Arc(disc.centre, self.r, pair[0], pair[1] - pair[0]);
            if port.contains(arc.at(0.5)) { -arc.swept(0.0, 1.0) } else { 0.0 }
        };
        ends.windows(2).map(of_pair).sum()
    }

    /// Contribution of the wall along a centrode: counter-clockwise along the stator, back along the rotor.
    fn of_wall(&self, port: &Port, wall: Wall, cuts: &[f64]) -> f64 {
        let [from, to] = self.ends();
        let (kinks, sign) = match wall {
            Wall::Stator => (self.kinks(By::StatorAngle, [from, to]), 1.0),
            Wall::Rotor => {
                let kinks = self.kinks(By::RotorAngle, [from, to].map(|end| end - self.rotation));
                (kinks.into_iter().map(|kink| kink + self.rotation).collect(), -1.0)
            }
        };
        let mut ends = vec![from, to];
        let around = cuts.iter().map(|angle| from + (angle - from).rem_euclid(TAU));
        ends.extend(around.chain(kinks).filter(|&angle| angle > from && angle < to));
        ends.sort_by(f64::total_cmp);
        let of_pair = |pair: &[f64]| {
            let middle = 0.5 * (pair[0] + pair[1]);
            let (sin, cos) = libm::sincos(middle);
            let rho = self.radius(wall, middle);
            if port.contains([rho * cos, rho * sin]) {
                let square = |theta: f64| self.radius(wall, theta).powi(2);
                sign * 0.5 * quadrature(pair[0], pair[1], PANELS, square)
            } else {
                0.0
            }
        };
        ends.windows(2).map(of_pair).sum()
    }

    /// Angles between two on a centrode at which its curvature jumps.
    fn kinks(&self, by: By, [from, to]: [f64; 2]) -> Vec<f64> {
        let Some(phase) = self.motor.shape.kink() else { return vec![] };
        let at = self.motor.shape.within(By::Phase, phase).get(by);
        let lobe = 2.0 * self.motor.shape.trough().get(by);
        let mut found = vec![];
        for side in [-at, at] {
            let mut angle = side + lobe * ((from - side) / lobe).ceil();
            while angle < to {
                found.push(angle);
                angle += lobe;
            }
        }
        found
    }
}
