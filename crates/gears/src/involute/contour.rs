//! The outline of a gear as arcs of circles and cubic curves, for CAD.
//!
//! Tip and root circles are arcs. Fillets and flanks are cubic Bézier curves that have points and tangents in
//! common with the exact curve `p(t)` at their ends:
//!
//! ```text
//! b_0 = p(t_0)   b_1 = b_0 + p'(t_0)·h/3   b_2 = b_3 − p'(t_1)·h/3   b_3 = p(t_1)      h = t_1 − t_0
//! ```
//!
//! A piece is halved until its points lie near enough to the tangents of the exact curve at the same
//! parameters.

use super::curve::{Point, ToothCurve};
use crate::checks::positive;
use crate::{Error, Quantity};
use std::f64::consts::TAU;

/// Halvings of a fillet or flank at most.
const MOST_HALVINGS: u32 = 10;

/// Parts of a piece whose ends are compared: the deviation has one maximum, near the middle.
const COMPARED: u32 = 8;

/// Part of the deviation that the compared points may have: points between them lie further away.
const SAFE: f64 = 0.7;

/// Step of the differences that give tangents, over the whole fillet or flank. Their error is about
/// 1e-9 of its length, far below any deviation that is asked for.
const STEP: f64 = 1e-5;

/// A piece of an outline about the axis of the gear; lengths in modules.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Piece {
    /// An arc about the axis.
    Arc {
        /// Radius of the arc.
        radius: f64,
        /// Angles of its first and last point, rad.
        angles: [f64; 2],
    },
    /// A cubic Bézier curve by its control points.
    Cubic([[f64; 2]; 4]),
}

impl ToothCurve {
    /// The closed outline of the gear, counterclockwise, the centre line of a tooth along the first axis.
    ///
    /// Fillet and flank have pieces of their own, so that the corner where an undercut ends is sharp.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for a deviation of 0 or less, in modules.
    pub fn contour(&self, deviation: f64) -> Result<Vec<Piece>, Error> {
        positive(Quantity::ChordDeviation, deviation, "modules")?;
        let mut half = vec![];
        let [fillet, flank] = [Self::on_fillet, Self::on_flank];
        fit(&|t| fillet(self, t), [0.0, 1.0], 0, deviation, &mut half);
        fit(&|t| flank(self, t), [0.0, 1.0], 0, deviation, &mut half);
        let (root, tip) = (self.on_fillet(0.0), self.on_flank(1.0));
        let pitch = TAU / self.gear().teeth().as_f64();
        let mut tooth: Vec<Piece> =
            half.iter().map(|points| Piece::Cubic(points.map(|[x, y]| [x, -y]))).collect();
        tooth.push(Piece::Arc { radius: tip.radius, angles: [-tip.angle, tip.angle] });
        tooth.extend(half.iter().rev().map(|[a, b, c, d]| Piece::Cubic([*d, *c, *b, *a])));
        // Fillets of racks whose corners are one arc meet in the middle of the space.
        if (pitch - 2.0 * root.angle) * root.radius > deviation {
            tooth.push(Piece::Arc { radius: root.radius, angles: [root.angle, pitch - root.angle] });
        }
        let teeth = self.gear().teeth().get();
        Ok((0..teeth)
            .flat_map(|place| tooth.iter().map(move |piece| piece.turned(f64::from(place) * pitch)))
            .collect())
    }
}

impl Piece {
    /// The piece turned about the axis of the gear.
    #[must_use]
    pub fn turned(&self, angle: f64) -> Self {
        match *self {
            Self::Arc { radius, angles } => Self::Arc { radius, angles: angles.map(|own| own + angle) },
            Self::Cubic(points) => {
                let (sin, cos) = libm::sincos(angle);
                Self::Cubic(points.map(|[x, y]| [x * cos - y * sin, x * sin + y * cos]))
            }
        }
    }
}

/// Appends cubic curves for a part of a curve.
fn fit(
    at: &impl Fn(f64) -> Point,
    [from, to]: [f64; 2],
    depth: u32,
    deviation: f64,
    curves: &mut Vec<[[f64; 2]; 4]>,
) {
    let place = |t: f64| at(t).coordinates();
    let third = (to - from) / 3.0;
    let [[x0, y0], [x3, y3]] = [from, to].map(place);
    let [[u0, v0], [u3, v3]] = [from, to].map(|t| tangent(&place, t).map(|along| third * along));
    let curve = [[x0, y0], [x0 + u0, y0 + v0], [x3 - u3, y3 - v3], [x3, y3]];
    let is_near = |part: u32| {
        let part = f64::from(part) / f64::from(COMPARED);
        let t = from + part * (to - from);
        let ([x, y], [own_x, own_y], [u, v]) = (place(t), on(&curve, part), tangent(&place, t));
        let across = (u * (own_y - y) - v * (own_x - x)).abs();
        across <= SAFE * deviation * libm::hypot(u, v)
    };
    if depth >= MOST_HALVINGS || (1..COMPARED).all(is_near) {
        curves.push(curve);
        return;
    }
    let middle = f64::midpoint(from, to);
    fit(at, [from, middle], depth + 1, deviation, curves);
    fit(at, [middle, to], depth + 1, deviation, curves);
}

/// Derivative by the parameter, from points of the curve alone: no point lies beyond its ends.
fn tangent(place: &impl Fn(f64) -> [f64; 2], t: f64) -> [f64; 2] {
    let step = if t > 0.5 { -STEP } else { STEP };
    if t > 0.0 && t < 1.0 {
        let [before, after] = [t - STEP, t + STEP].map(place);
        return [0, 1].map(|axis| (after[axis] - before[axis]) / (2.0 * STEP));
    }
    let [here, next, last] = [t, t + step, t + 2.0 * step].map(place);
    [0, 1].map(|axis| (4.0 * next[axis] - 3.0 * here[axis] - last[axis]) / (2.0 * step))
}

/// A point of a cubic Bézier curve.
fn on(curve: &[[f64; 2]; 4], t: f64) -> [f64; 2] {
    let s = 1.0 - t;
    let weights = [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t];
    [0, 1].map(|axis| curve.iter().zip(weights).map(|(point, weight)| weight * point[axis]).sum())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ToothCount;
    use crate::gear_kind::GearKind;
    use crate::involute::tool::{Shaper, Tool};
    use crate::involute::{InvoluteGear, Profile};
    use epicyclic_units::Physical;
    use uom::si::f64::Angle;

    fn curves() -> Vec<ToothCurve> {
        let gear = |kind, teeth, shift, profile| {
            InvoluteGear::new(kind, ToothCount::new(teeth).unwrap(), profile, shift).unwrap()
        };
        let usual = Profile::default();
        let helical = Profile { helix_angle: Angle::from_degrees(20.0), ..usual };
        let ground = Profile { protuberance: 0.06, stock: 0.03, fillet: 0.3, ..usual };
        let shaper = Tool::Shaper(Shaper::of_teeth(ToothCount::new(30).unwrap()));
        let gears = [
            gear(GearKind::External, 18, 0.389, usual),
            gear(GearKind::External, 9, 0.0, usual),
            gear(GearKind::External, 24, 0.2, helical),
            gear(GearKind::External, 30, 0.1, ground),
            gear(GearKind::External, 36, 0.5, usual).with_tool(shaper).unwrap(),
            gear(GearKind::Internal, 93, 0.117, usual).with_tool(shaper).unwrap(),
            gear(GearKind::Internal, 60, 0.0, usual).with_tool(Tool::Form { fillet: 0.3 }).unwrap(),
        ];
        gears.into_iter().map(|gear| ToothCurve::new(gear).unwrap()).collect()
    }

    fn ends(piece: &Piece) -> [[f64; 2]; 2] {
        match *piece {
            Piece::Arc { radius, angles } => angles.map(|angle| Point { radius, angle }.coordinates()),
            Piece::Cubic([first, .., last]) => [first, last],
        }
    }

    /// Points of the pieces against the exact curve by chords of 6000 parts, and no gap from piece to piece.
    #[test]
    fn the_pieces_lie_on_the_exact_tooth() {
        for curve in curves() {
            for deviation in [1e-3, 1e-5] {
                let pieces = curve.contour(deviation).unwrap();
                let teeth = curve.gear().teeth().get() as usize;
                assert!(pieces.len() <= 50 * teeth, "{}", pieces.len() / teeth);
                let exact = |samples: u32, of: &dyn Fn(f64) -> Point| -> Vec<[f64; 2]> {
                    let points = (0..=samples).map(|i| of(f64::from(i) / f64::from(samples)));
                    points.map(Point::coordinates).collect()
                };
                let chains = [exact(6000, &|t| curve.on_fillet(t)), exact(6000, &|t| curve.on_flank(t))];
                let distance = |[x, y]: [f64; 2]| {
                    // The tooth is symmetric about the first axis.
                    let y = y.abs();
                    let chords = chains.iter().flat_map(|chain| chain.windows(2));
                    let to_chord = chords.map(|ends| {
                        let ([x1, y1], [x2, y2]) = (ends[0], ends[1]);
                        let (dx, dy) = (x2 - x1, y2 - y1);
                        let square = dx * dx + dy * dy;
                        let share = ((x - x1) * dx + (y - y1) * dy) / if square > 0.0 { square } else { 1.0 };
                        let share = share.clamp(0.0, 1.0);
                        libm::hypot(x - x1 - share * dx, y - y1 - share * dy)
                    });
                    to_chord.fold(f64::INFINITY, f64::min)
                };
                let first_tooth = &pieces[..pieces.len() / teeth];
                let mut worst: f64 = 0.0;
                for piece in first_tooth {
                    if let Piece::Cubic(points) = piece {
                        for i in 0..=40 {
                            worst = worst.max(distance(on(points, f64::from(i) / 40.0)));
                        }
                    }
                }
                assert!(worst <= deviation, "{worst} {deviation}");
                for (one, next) in pieces.iter().zip(pieces.iter().cycle().skip(1)) {
                    let ([_, [x1, y1]], [[x2, y2], _]) = (ends(one), ends(next));
                    assert!(libm::hypot(x2 - x1, y2 - y1) <= 1e-9, "a gap");
                }
                let radii = [curve.root_radius(), curve.tip_radius()];
                let arcs: Vec<f64> = first_tooth
                    .iter()
                    .filter_map(|piece| match piece {
                        Piece::Arc { radius, .. } => Some(*radius),
                        Piece::Cubic(_) => None,
                    })
                    .collect();
                assert!(
                    arcs.len() == 2
                        && (arcs[0] - radii[1]).abs() < 1e-12
                        && (arcs[1] - radii[0]).abs() < 1e-12
                );
            }
        }
    }

    #[test]
    fn pieces_without_a_deviation_are_refused() {
        assert_eq!(curves()[0].contour(0.0).unwrap_err().name(), "not-positive");
    }
}
