//! Drags: torques of seals, bearings, oil and open shift elements between two links, by a curve over their
//! relative speed.
//!
//! ```text
//! s = ω_1 − ω_2     T_1 = −M(|s|)·sign s     T_2 = −T_1
//! M(|s|)·sign s = M_0·sign s + m(s)          M_0 = M(0),  m odd, m(0) = 0
//! ```
//!
//! `m` is smooth at `s = 0`; between the points of the curve it is linear, and the end of a segment is an
//! event. `M_0` is dry friction, carried by a friction element that slips or sticks as any other: at `s = 0`
//! it holds up to `M_0`, without smoothing. A curve through 0 has no dry friction, and needs no event at
//! rest.
//!
//! A shift element or a load may act between the same links. `M_0` then adds to the torque that it carries
//! and holds, so that their shares are determined. While they stick, the element has all the torque that it
//! can carry, and the drag the rest.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | `s` | speed of the first link relative to the second | rad/s |
//! | `M` | size of the torque, by the curve | N·m |
//! | `M_0` | torque at rest; before the first point of a curve that goes on level the torque there | N·m |
//! | `T_1`, `T_2` | torques on the links | N·m |

use crate::mechanism::Place;
use crate::table;
use epicyclic_train::drag::{Beyond, DragCurve};
use epicyclic_units::Physical;

/// A drag between two links.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Drag {
    pub(crate) name: String,
    pub(crate) places: [Place; 2],
    /// `s` over the coordinates.
    pub(crate) slip: Vec<f64>,
    pub(crate) curve: Curve,
    /// The element that carries `M_0`, and the sign of its slip where `s` is above 0.
    pub(crate) carrier: Option<(usize, f64)>,
}

/// `M_0` and `m`.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Curve {
    /// `M_0`.
    pub(crate) dry: f64,
    /// `m` over `s`, both signs, without its point at 0.
    points: Vec<[f64; 2]>,
    /// First and last speed that the file gives.
    range: [f64; 2],
    /// Whether speeds outside the curve are refused.
    is_refused: bool,
    /// Whether the segment at 0 is outside.
    has_gap: bool,
}

impl Curve {
    pub(crate) fn new(curve: &DragCurve) -> Self {
        let given: Vec<[f64; 2]> = curve.points().map(|(speed, torque)| [speed.si(), torque.si()]).collect();
        let is_refused = curve.beyond() == Beyond::Refused;
        let first = given.first().copied().unwrap_or_default();
        let starts_at_rest = first[0] == 0.0;
        let dry = if starts_at_rest || !is_refused { first[1] } else { 0.0 };
        let upper = given.iter().filter(|point| point[0] > 0.0).map(|&[speed, torque]| [speed, torque - dry]);
        let lower = upper.clone().rev().map(|[speed, torque]| [-speed, -torque]);
        Self {
            dry,
            range: curve.speeds().map(Physical::si),
            is_refused,
            has_gap: is_refused && (!starts_at_rest || given.len() == 1),
            points: lower.chain(upper.clone()).collect(),
        }
    }

    pub(crate) fn range(&self) -> [f64; 2] {
        self.range
    }

    /// `m` in a segment.
    pub(crate) fn at(&self, segment: usize, slip: f64) -> f64 {
        table::value(&self.points, segment, slip)
    }

    pub(crate) fn segment(&self, slip: f64) -> usize {
        table::segment(&self.points, slip, true)
    }

    /// Ends of a segment; the segment outside the curve around 0 is left as soon as anything turns.
    pub(crate) fn ends(&self, segment: usize) -> [Option<f64>; 2] {
        if self.is_gap(segment) { [Some(0.0); 2] } else { table::ends(&self.points, segment) }
    }

    /// Whether the curve gives no torque in this segment.
    pub(crate) fn is_outside(&self, segment: usize) -> bool {
        let is_end = !self.points.is_empty() && (segment == 0 || segment == self.points.len());
        self.is_gap(segment) || self.is_refused && is_end
    }

    fn is_gap(&self, segment: usize) -> bool {
        self.has_gap && segment == self.points.len() / 2
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use uom::si::f64::{AngularVelocity, Torque};

    fn omega(value: f64) -> AngularVelocity {
        AngularVelocity::from_si(value)
    }

    fn curve(points: &[(f64, f64)], beyond: Beyond) -> Curve {
        let points: Vec<_> = points.iter().map(|&(speed, on)| (omega(speed), Torque::from_si(on))).collect();
        Curve::new(&DragCurve::new(&points, beyond).unwrap())
    }

    /// Dry friction and the rest add up to the curve, whatever the sign of the speed.
    #[test]
    fn dry_friction_and_the_rest_are_the_curve() {
        for points in [
            &[(0.0, 2.0), (10.0, 3.0), (30.0, 1.0)][..],
            &[(0.0, 0.0), (10.0, 3.0)],
            &[(5.0, 2.0), (10.0, 4.0)],
            &[(0.0, 1.5)],
            &[(7.0, 1.5)],
        ] {
            let made = curve(points, Beyond::Constant);
            let given: Vec<_> =
                points.iter().map(|&(speed, on)| (omega(speed), Torque::from_si(on))).collect();
            let given = DragCurve::new(&given, Beyond::Constant).unwrap();
            for slip in [0.5, 5.0, 7.5, 10.0, 20.0, 40.0] {
                for sign in [1.0, -1.0] {
                    let slip = sign * slip;
                    let found = made.at(made.segment(slip), slip) + sign * made.dry;
                    let due = sign * given.at(omega(slip)).unwrap().si();
                    assert!((found - due).abs() < 1e-14, "{points:?} {slip}: {found} {due}");
                    assert!(!made.is_outside(made.segment(slip)));
                }
            }
            assert_eq!(made.at(made.segment(0.0), 0.0), 0.0);
        }
    }

    #[test]
    fn outside_is_what_the_curve_does_not_tell() {
        let outside = |made: &Curve, slip: f64| made.is_outside(made.segment(slip));
        let from_rest = curve(&[(0.0, 2.0), (10.0, 3.0)], Beyond::Refused);
        assert_eq!(
            [-11.0, -9.0, 0.0, 9.0, 11.0].map(|slip| outside(&from_rest, slip)),
            [true, false, false, false, true]
        );
        let later = curve(&[(5.0, 2.0), (10.0, 3.0)], Beyond::Refused);
        assert_eq!([-6.0, 0.0, 4.0, 6.0].map(|slip| outside(&later, slip)), [false, true, true, false]);
        assert_eq!((later.dry, later.ends(later.segment(0.0))), (0.0, [Some(0.0); 2]));
        let only = curve(&[(0.0, 2.0)], Beyond::Refused);
        assert!(outside(&only, 1.0) && only.dry == 2.0);
    }
}
