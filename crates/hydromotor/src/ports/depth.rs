//! Proof whether a port is open to a chamber, or closed, throughout a stretch of the chamber's cycle.
//!
//! The depth of a point within a chamber is at most its distance from the chamber's walls:
//!
//! ```text
//! d(p, φ) = min( |p − c| − r of both satellites, 0.6·distances from both rays,
//!                c_w·(ρ₃(θ) − ρ), c_w·(ρ − ρ₁(θ − φ)) )
//! c_w     = 1/√(1 + (ρ_w·tan μ/ρ)²)
//! ```
//!
//! The depth changes by no more than 1 with the way of the point. With the rotation of the rotor a ray turns
//! by `dθ₃/dΦ < 1`, and the depth changes by no more than:
//!
//! ```text
//! max( ρ₁/(2·cos μ), 0.6·ρ₃, c_w·ρ₁·tan μ )
//! ```
//!
//! The first term is the speed of the centre of a satellite, which rolls on the stator. Let the greatest
//! change over half the stretch be the margin. A port is open throughout the stretch if some point of its
//! outline is deeper than the margin in the middle of the stretch. It is closed if every point is farther
//! outside than the margin. The deepest point is found by halving the pieces of the outline, the most
//! promising first.

use crate::ports::LEAST_COSINE;
use crate::ports::outline::{Piece, Port};
use crate::ports::overlap::{Region, Wall};
use crate::satellites::Place;
use crate::tolerance::{LOWEST, OPEN};
use std::f64::consts::{PI, TAU};

/// State of a port towards a chamber throughout a stretch.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Throughout {
    Open,
    Closed,
    /// Neither is proven.
    Unsure,
}

/// A part of an outline, with the depth of its middle and the greatest that it may have.
struct Part {
    piece: Piece,
    from: f64,
    to: f64,
    depth: f64,
    most: f64,
}

impl Region<'_> {
    /// State of a port towards the chamber for all rotations that differ from this one by no more than
    /// `half`.
    pub(super) fn throughout(&self, port: &Port, half: f64) -> Throughout {
        let [inner, outer] = port.radii();
        let [from, to] = self.ends();
        let [angle, reach] = port.reach();
        let (middle, width) = (0.5 * (from + to), 0.5 * (to - from));
        let off = (angle - middle + PI).rem_euclid(TAU) - PI;
        let greatest = self.radii(Wall::Stator)[1];
        if off.abs() > width + reach + half || inner >= greatest || outer <= self.radii(Wall::Rotor)[0] {
            return Throughout::Closed;
        }
        let margin = half * self.swiftest();
        // A quarter of a circle of this radius is larger than the least area that counts as open.
        let open = margin + (10.0 * OPEN * port.area()).sqrt();
        let pieces = port.pieces().into_iter();
        let mut parts: Vec<Part> = pieces.map(|piece| self.part(piece, [0.0, 1.0], margin)).collect();
        loop {
            let best = parts.iter().enumerate().max_by(|one, other| one.1.most.total_cmp(&other.1.most));
            let Some((best, part)) = best else { break };
            if part.depth > open {
                return Throughout::Open;
            }
            if part.most < -margin {
                break;
            }
            if part.most - part.depth < margin {
                return Throughout::Unsure;
            }
            let Part { piece, from, to, .. } = parts.swap_remove(best);
            let middle = 0.5 * (from + to);
            let halves = [[from, middle], [middle, to]].map(|ends| self.part(piece, ends, margin));
            parts.extend(halves.into_iter().filter(|part| part.most >= -margin));
        }
        // The outline stays outside: the chamber lies within it as a whole, or not at all.
        let (sin, cos) = libm::sincos(middle);
        let rho = 0.5 * (self.radius(Wall::Stator, middle) + self.radius(Wall::Rotor, middle));
        let point = [rho * cos, rho * sin];
        match (port.contains(point), self.contains(point)) {
            (true, true) => Throughout::Open,
            (true, false) => Throughout::Unsure,
            (false, _) => Throughout::Closed,
        }
    }

    /// Greatest change of the depth of a point with the rotation of the rotor.
    fn swiftest(&self) -> f64 {
        let [rotor, stator] = [Wall::Rotor, Wall::Stator].map(|wall| self.radii(wall)[1]);
        let of_rotor = rotor * STEEPEST / (1.0 + (rotor * STEEPEST / stator).powi(2)).sqrt();
        (0.5 * rotor / LEAST_COSINE).max(OF_RAY * stator).max(of_rotor)
    }

    fn part(&self, piece: Piece, [from, to]: [f64; 2], margin: f64) -> Part {
        let reach = 0.5 * (to - from) * piece.length();
        let depth = self.depth(piece.at(0.5 * (from + to)), reach, margin);
        Part { piece, from, to, depth, most: depth + reach }
    }

    /// The depth of a point; none within `reach` of it is deeper by more than that. Of one that is so far
    /// outside that none there is less than `margin` outside, some bound.
    fn depth(&self, [x, y]: [f64; 2], reach: f64, margin: f64) -> f64 {
        let of_satellite = |place: &Place| libm::hypot(x - place.centre[0], y - place.centre[1]) - self.r;
        let (rho, theta) = (libm::hypot(x, y), libm::atan2(y, x));
        let [from, to] = self.ends();
        let off = (theta - 0.5 * (from + to) + PI).rem_euclid(TAU) - PI;
        let of_ray = OF_RAY * rho * libm::sin((0.5 * (to - from) - off.abs()).clamp(-0.5 * PI, 0.5 * PI));
        let mut depth = of_satellite(&self.back).min(of_satellite(&self.front)).min(of_ray);
        // The least radius within reach, for the slope of a wall's radius across.
        let lowest = (rho - reach).max(LOWEST);
        for wall in [Wall::Stator, Wall::Rotor] {
            let [least, greatest] = self.radii(wall);
            let inward = |radius: f64| if wall == Wall::Stator { radius - rho } else { rho - radius };
            let (low, high) = (inward(least), inward(greatest));
            depth = depth.min(low.max(high));
            if depth + reach < -margin {
                return depth;
            }
            let steepness = greatest * STEEPEST / lowest;
            let scale = 1.0 / (1.0 + steepness * steepness).sqrt();
            // The nearest radius may show that the wall does not bound the depth.
            if scale * low.min(high) < depth {
                depth = depth.min(scale * inward(self.radius(wall, theta)));
            }
        }
        depth
    }
}

/// The part of the distance from a ray that counts as depth.
const OF_RAY: f64 = 0.6;

/// `tan μ` of the steepest contact: that of [`LEAST_COSINE`].
const STEEPEST: f64 = 1.170;
