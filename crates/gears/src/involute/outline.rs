//! Outlines of teeth and gears as polylines whose chords leave the curve by no more than a given length.

use super::curve::{Point, ToothCurve};
use crate::checks::positive;
use crate::{Error, Quantity};
use std::f64::consts::TAU;

/// Halvings of a piece at most: 2^12 chords of a fillet or flank.
const MOST_HALVINGS: u32 = 12;

/// Halvings of every piece: three points show the deviation of a chord only where the piece bends one way.
const LEAST_HALVINGS: u32 = 2;

impl ToothCurve {
    /// Half of a tooth from the root to the corner of the tip, the crests of root and tip left out.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for a deviation of 0 or less, in modules.
    pub fn half(&self, deviation: f64) -> Result<Vec<Point>, Error> {
        positive(Quantity::ChordDeviation, deviation, "modules")?;
        let (fillet, flank) = (|t: f64| self.on_fillet(t), |t: f64| self.on_flank(t));
        let mut points = vec![fillet(0.0)];
        halve(&fillet, [0.0, 1.0], 0, deviation, &mut points);
        halve(&flank, [0.0, 1.0], 0, deviation, &mut points);
        Ok(points)
    }

    /// A point of the fillet as it is left: 0 at the root, 1 where the involute takes over.
    pub(super) fn on_fillet(&self, t: f64) -> Point {
        self.fillet(t * self.joint())
    }

    /// A point of the flank: 0 where it takes over from the fillet, 1 at the tip.
    pub(super) fn on_flank(&self, t: f64) -> Point {
        // Along the angle of roll: the involute is a parabola in it.
        let gear = self.gear();
        let [from, to] =
            [self.joint_radius(), self.tip_radius()].map(|radius| gear.curvature_radius(2.0 * radius));
        self.involute(libm::hypot(gear.base_diameter() / 2.0, from + t * (to - from)))
    }

    /// The closed outline of the gear, counterclockwise: coordinates about its axis, the centre line of a
    /// tooth along the first axis.
    ///
    /// The first point is not repeated at the end.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for a deviation of 0 or less, in modules.
    pub fn outline(&self, deviation: f64) -> Result<Vec<[f64; 2]>, Error> {
        let half = self.half(deviation)?;
        let pitch = TAU / self.gear().teeth().as_f64();
        let crest = |from: f64, to: f64, radius: f64| {
            let step = 2.0 * libm::acos(1.0 - (deviation / radius).min(1.0));
            let parts = ((to - from) / step).ceil().max(1.0) as u32;
            // Without its ends, which the flanks have.
            (1..parts).map(move |part| Point {
                radius,
                angle: from + (to - from) * f64::from(part) / f64::from(parts),
            })
        };
        let mirrored = |point: &Point| Point { angle: -point.angle, ..*point };
        let (Some(root), Some(tip)) = (half.first(), half.last()) else { return Ok(Vec::new()) };
        let mut tooth: Vec<Point> = half.iter().map(mirrored).collect();
        tooth.extend(crest(-tip.angle, tip.angle, tip.radius));
        tooth.extend(half.iter().rev());
        tooth.extend(crest(root.angle, pitch - root.angle, root.radius));
        let teeth = self.gear().teeth().get();
        let turned = |place: u32| {
            let angle = f64::from(place) * pitch;
            tooth.iter().map(move |point| Point { angle: point.angle + angle, ..*point }.coordinates())
        };
        Ok((0..teeth).flat_map(turned).collect())
    }
}

/// Appends the points of a piece after its first, halved until its middle lies near to its chord.
fn halve(
    at: &impl Fn(f64) -> Point,
    [from, to]: [f64; 2],
    depth: u32,
    deviation: f64,
    points: &mut Vec<Point>,
) {
    let middle = f64::midpoint(from, to);
    let [start, halfway, end] = [from, middle, to].map(|t| at(t).coordinates());
    let chord = [end[0] - start[0], end[1] - start[1]];
    let off = [halfway[0] - start[0], halfway[1] - start[1]];
    let length = libm::hypot(chord[0], chord[1]);
    let distance = if length > 0.0 {
        (chord[0] * off[1] - chord[1] * off[0]).abs() / length
    } else {
        libm::hypot(off[0], off[1])
    };
    if depth >= LEAST_HALVINGS && (distance <= deviation || depth >= MOST_HALVINGS) {
        points.push(at(to));
        return;
    }
    halve(at, [from, middle], depth + 1, deviation, points);
    halve(at, [middle, to], depth + 1, deviation, points);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ToothCount;
    use crate::gear_kind::GearKind;
    use crate::involute::tool::{Shaper, Tool};
    use crate::involute::{InvoluteGear, Profile};
    use std::f64::consts::PI;

    fn curves() -> Vec<ToothCurve> {
        let gear = |kind, teeth, shift| {
            InvoluteGear::new(kind, ToothCount::new(teeth).unwrap(), Profile::default(), shift).unwrap()
        };
        let shaper = Tool::Shaper(Shaper::of_teeth(ToothCount::new(30).unwrap()));
        vec![
            ToothCurve::new(gear(GearKind::External, 18, 0.389)).unwrap(),
            ToothCurve::new(gear(GearKind::External, 9, 0.0)).unwrap(),
            ToothCurve::new(gear(GearKind::External, 36, 0.5).with_tool(shaper).unwrap()).unwrap(),
            ToothCurve::new(gear(GearKind::Internal, 93, 0.117).with_tool(shaper).unwrap()).unwrap(),
        ]
    }

    #[test]
    fn no_chord_leaves_the_curve_by_more_than_asked() {
        for curve in curves() {
            let deviation = 1e-3;
            let coarse = curve.half(deviation).unwrap();
            let fine = curve.half(1e-7).unwrap();
            assert!(coarse.len() < 60, "{}", coarse.len());
            for point in fine {
                let [x, y] = point.coordinates();
                let nearest = coarse
                    .windows(2)
                    .map(|ends| {
                        let [[x1, y1], [x2, y2]] = [ends[0].coordinates(), ends[1].coordinates()];
                        let (dx, dy) = (x2 - x1, y2 - y1);
                        let share = (((x - x1) * dx + (y - y1) * dy) / (dx * dx + dy * dy)).clamp(0.0, 1.0);
                        libm::hypot(x - x1 - share * dx, y - y1 - share * dy)
                    })
                    .fold(f64::INFINITY, f64::min);
                assert!(nearest <= 1.2 * deviation, "{nearest}");
            }
        }
    }

    /// Compares the area by the shoelace formula with teeth cut into thin rings.
    #[test]
    fn an_outline_encloses_the_area_of_its_teeth() {
        for curve in curves() {
            let outline = curve.outline(1e-5).unwrap();
            let next = outline.iter().cycle().skip(1);
            let area =
                outline.iter().zip(next).map(|([x1, y1], [x2, y2])| x1 * y2 - x2 * y1).sum::<f64>() / 2.0;
            let (root, tip) = (curve.root_radius(), curve.tip_radius());
            let steps = 4000;
            let thickness = |step: u32| {
                let radius = root + (tip - root) * (f64::from(step) + 0.5) / f64::from(steps);
                2.0 * radius * curve.half_angle(radius)
            };
            let teeth: f64 = (0..steps).map(thickness).sum::<f64>() * (tip - root) / f64::from(steps);
            let rings = PI * root * root + curve.gear().teeth().as_f64() * teeth;
            assert!((area / rings - 1.0).abs() < 2e-5, "{area} {rings}");
        }
    }

    #[test]
    fn chords_without_a_deviation_are_refused() {
        assert_eq!(curves()[0].outline(0.0).unwrap_err().name(), "not-positive");
        assert_eq!(curves()[0].half(f64::NAN).unwrap_err().name(), "not-positive");
    }
}
