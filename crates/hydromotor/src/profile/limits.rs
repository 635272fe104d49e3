//! The limits of the teeth: what a tooth form must keep on every place of the centrodes.
//!
//! Paths run along the line of action from the pitch point; `κ` is the centrode's curvature towards the satellite.
//!
//! | kind | wheel | value | bound |
//! |---|---|---|---|
//! | undercut | stator, rotor | path of contact with the cutter where the flank begins | at most `sin α/\|κ\|`, where the flank would have a cusp |
//! | undercut | satellite | the same path with its rack | at most `r·sin α`, the base circle |
//! | cusp at the tip | stator, rotor | path of contact at the tip, where the centrode is hollow | at most `sin α/κ` |
//! | foreign root | stator, rotor | path of contact at the wheel's tip, or reach into the fillet | at most that at which the satellite's involute begins |
//! | own root | stator, rotor | path of contact at the satellite's tip | at most that at which the wheel's flank begins |
//! | tip | all | thickness of the thinnest tip | at least 0.2 modules |
//! | contact | stator, rotor | shortest path of contact | at least a base pitch, `p·cos α` |
//! | root curve | stator, rotor | the cutter's addendum | at most the radius of the centrode's sharpest bulge towards the satellite |
//! | tip curve | stator, rotor | the wheel's addendum | at most the radius of its sharpest hollow |
//! | neighbours | satellite | least distance of satellites' centres | at least the tip circle's diameter |
//! | wheels | rotor | stator's least radius less rotor's greatest | at least both addenda |
//!
//! A wheel's tip that keeps the *foreign root* may still run into the satellite's fillet: its corner goes on from the involute's
//! beginning on a path of its own, and where that is bent less than the fillet it leaves less than the `½·j·cos α` between flanks. The value of
//! *foreign root* is then the bound and what is missing of that distance.
//!
//! Of a flank that ends in a cusp below the tip, the value of *cusp at the tip* is the cusp's path and what is missing to the tip.
//!
//! Values and bounds are lengths; of each kind and wheel the place is returned where value and bound are nearest or the bound is most
//! exceeded.

use uom::si::f64::Length;

use super::cut::Flank;
use super::track::{Frame, Side, Track};
use super::{Part, Profile};
use crate::centrode::Wheel;
use crate::contact::{By, Conjugate};
use crate::roots::golden;
use crate::units::modules;
use std::f64::consts::PI;

/// What is limited.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum LimitKind {
    /// The cutter's tip removes a part of the flank.
    Undercut,
    /// The flank has a cusp before the tip.
    TipCusp,
    /// The wheel's tip reaches below the satellite's involute, or into its fillet.
    SatelliteRoot,
    /// The satellite's tip reaches below the wheel's flank.
    WheelRoot,
    /// Thickness of the tip.
    TipThickness,
    /// Length of the path of contact: a new pair of flanks meets before the last one parts.
    ContactPath,
    /// The root's parallel of the centrode has cusps.
    RootCurve,
    /// The tip's parallel of the centrode has cusps.
    TipCurve,
    /// Tip circles of neighbouring satellites.
    Neighbours,
    /// The rotor's crest passes the stator's trough.
    Wheels,
}

/// On which side of its bound a value lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Bound {
    /// Not below it.
    AtLeast,
    /// Not above it.
    AtMost,
}

/// A limit of a wheel's teeth where it is nearest to failing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limit {
    /// What is limited.
    pub kind: LimitKind,
    /// Whose teeth.
    pub wheel: Wheel,
    /// Its value.
    pub value: Length,
    /// Side of the bound.
    pub sense: Bound,
    /// The bound.
    pub bound: Length,
    /// Where: arc length on the centrode from the middle of a crest; of a satellite none.
    pub at: Option<Length>,
}

impl Limit {
    /// How far the value is on the allowed side of the bound; negative if the limit fails.
    #[must_use]
    pub fn margin(&self) -> Length {
        match self.sense {
            Bound::AtLeast => self.value - self.bound,
            Bound::AtMost => self.bound - self.value,
        }
    }

    /// Whether the limit is kept.
    #[must_use]
    pub fn holds(&self) -> bool {
        match self.sense {
            Bound::AtLeast => self.value >= self.bound,
            Bound::AtMost => self.value <= self.bound,
        }
    }
}

/// The least thickness of a tip in modules.
pub const LEAST_TIP: f64 = 0.2;

/// Places of a flank at which it is looked at, besides its ends.
const PLACES: u32 = 24;

/// A limit in modules, with its place.
#[derive(Clone, Copy)]
struct Worst {
    value: f64,
    bound: f64,
    at: f64,
}

impl Worst {
    /// Keeps the one with the lesser margin, of value over bound.
    fn keep(worst: &mut Option<Self>, sense: Bound, value: f64, bound: f64, at: f64) {
        let margin = |value: f64, bound: f64| match sense {
            Bound::AtLeast => value - bound,
            Bound::AtMost => bound - value,
        };
        if worst.is_none_or(|old| margin(value, bound) < margin(old.value, old.bound)) {
            *worst = Some(Self { value, bound, at });
        }
    }
}

impl Profile {
    /// Every limit that applies; of a centrode that is nowhere hollow there is none of its hollow.
    ///
    /// # Example
    /// ```
    /// use epicyclic_hydromotor::centrode::Wheel;
    /// use epicyclic_hydromotor::profile::limits::LimitKind;
    /// use epicyclic_hydromotor::profile::{Profile, ToothForm};
    /// use epicyclic_hydromotor::{Motor, MotorNumbers};
    /// use uom::si::{f64::Length, length::millimeter};
    ///
    /// let mm = Length::new::<millimeter>;
    /// let motor = Motor::of_two_arcs(MotorNumbers::new(5, 3, 55, 10)?, mm(1.0), mm(40.0))?;
    /// // A standard satellite of 10 teeth is undercut.
    /// let limits = Profile::new(&motor, ToothForm::full_depth())?.limits();
    /// let failing = limits.iter().find(|limit| !limit.holds() && limit.wheel == Wheel::Satellite);
    /// assert_eq!(failing.map(|limit| limit.kind), Some(LimitKind::Undercut));
    /// # Ok::<(), epicyclic_hydromotor::Error>(())
    /// ```
    #[must_use]
    pub fn limits(&self) -> Vec<Limit> {
        let mut limits = Vec::new();
        for side in Side::BOTH {
            self.wheel_limits(side, &mut limits);
        }
        let teeth = &self.teeth;
        let mut add = |kind, wheel, value, sense, bound| {
            limits.push(self.limit(kind, wheel, value, sense, bound, None));
        };
        let path = -teeth.rack_roll * teeth.cos;
        add(LimitKind::Undercut, Wheel::Satellite, path, Bound::AtMost, teeth.r * teeth.sin);
        let tip = 2.0 * teeth.tip * teeth.tip_angle();
        add(LimitKind::TipThickness, Wheel::Satellite, tip, Bound::AtLeast, LEAST_TIP);
        let distance = modules(self.motor.least_neighbour_distance().0, self.motor.module());
        add(LimitKind::Neighbours, Wheel::Satellite, distance, Bound::AtLeast, 2.0 * teeth.tip);
        let gap = self.motor.shape.trough().rho3 - self.motor.shape.at(By::Phase, 0.0).rho1;
        add(LimitKind::Wheels, Wheel::Rotor, gap, Bound::AtLeast, 2.0 * teeth.wheel_addendum);
        limits
    }

    fn limit(
        &self,
        kind: LimitKind,
        wheel: Wheel,
        value: f64,
        sense: Bound,
        bound: f64,
        at: Option<f64>,
    ) -> Limit {
        let length = |modules| self.motor.length(modules);
        Limit { kind, wheel, value: length(value), sense, bound: length(bound), at: at.map(length) }
    }

    fn wheel_limits(&self, side: Side, limits: &mut Vec<Limit>) {
        let teeth = &self.teeth;
        let track = self.track(side);
        let cut = self.cut(side);
        let [
            mut undercut,
            mut cusp,
            mut foreign,
            mut own,
            mut tip,
            mut contact,
            mut root_curve,
            mut tip_curve,
        ] = [None; 8];
        let satellite_path = teeth.base * (teeth.tan - self.satellite.from);
        for flank in cut.flanks.iter().flatten() {
            let at = flank.pitch;
            for frame in flank_frames(&track, flank, flank.pitch + flank.sign * teeth.cutter_roll) {
                let path = flank.roll(frame.s) * teeth.cos;
                let bound = teeth.sin / frame.curvature.abs();
                if path < 0.0 && frame.curvature < 0.0 {
                    Worst::keep(&mut undercut, Bound::AtMost, -path, bound, at);
                } else if path > 0.0 && frame.curvature > 0.0 {
                    Worst::keep(&mut cusp, Bound::AtMost, path, bound, at);
                }
                if frame.curvature < 0.0 {
                    let radius = -1.0 / frame.curvature;
                    Worst::keep(&mut root_curve, Bound::AtMost, teeth.cutter_addendum, radius, frame.s);
                } else if frame.curvature > 0.0 {
                    let radius = 1.0 / frame.curvature;
                    Worst::keep(&mut tip_curve, Bound::AtMost, teeth.wheel_addendum, radius, frame.s);
                }
            }
            let wheel_tip = flank.roll(flank.tip) * teeth.cos;
            if flank.missing > 0.0 {
                Worst::keep(&mut cusp, Bound::AtMost, wheel_tip + flank.missing, wheel_tip, at);
            }
            // The flanks on the other side of the spaces are mirror images.
            let intrusion = if flank.sign > 0.0 { self.intrusion(&track, flank) } else { 0.0 };
            let reach = if intrusion > 0.0 { wheel_tip.max(satellite_path + intrusion) } else { wheel_tip };
            Worst::keep(&mut foreign, Bound::AtMost, reach, satellite_path, at);
            let satellite_tip = -teeth.tip_roll() * teeth.cos;
            let begins = -flank.roll(flank.end) * teeth.cos;
            Worst::keep(&mut own, Bound::AtMost, satellite_tip, begins, at);
            let path = wheel_tip.min(satellite_path) + satellite_tip.min(begins);
            Worst::keep(&mut contact, Bound::AtLeast, path, PI * teeth.cos, at);
        }
        for piece in cut.pieces.iter().filter(|piece| piece.part == Part::Tip) {
            let frames: Vec<Frame> =
                track.frames(piece.from, piece.to, 8).chain([track.at(piece.to)]).collect();
            let point = |frame: &Frame| frame.point(0.0, teeth.wheel_addendum);
            let thickness: f64 = frames
                .windows(2)
                .map(|ends| {
                    let ([ax, ay], [bx, by]) = (point(&ends[0]), point(&ends[1]));
                    (ax - bx).hypot(ay - by)
                })
                .sum();
            Worst::keep(&mut tip, Bound::AtLeast, thickness, LEAST_TIP, 0.5 * (piece.from + piece.to));
        }
        let kinds = [
            (LimitKind::Undercut, Bound::AtMost, undercut),
            (LimitKind::TipCusp, Bound::AtMost, cusp),
            (LimitKind::SatelliteRoot, Bound::AtMost, foreign),
            (LimitKind::WheelRoot, Bound::AtMost, own),
            (LimitKind::TipThickness, Bound::AtLeast, tip),
            (LimitKind::ContactPath, Bound::AtLeast, contact),
            (LimitKind::RootCurve, Bound::AtMost, root_curve),
            (LimitKind::TipCurve, Bound::AtMost, tip_curve),
        ];
        for (kind, sense, worst) in kinds {
            if let Some(Worst { value, bound, at }) = worst {
                limits.push(self.limit(kind, side.wheel(), value, sense, bound, Some(at)));
            }
        }
    }
}

impl Profile {
    /// How much nearer than the flanks the corner of a wheel's tip comes to the satellite's fillet, as contact goes on from the tip to
    /// the corner's foot; 0 if it does not.
    fn intrusion(&self, track: &Track<'_>, flank: &Flank) -> f64 {
        let teeth = &self.teeth;
        let corner = track.at(flank.foot).point(0.0, teeth.wheel_addendum);
        let middle = flank.pitch - flank.sign * teeth.half_space;
        let distance = |s: f64| {
            let Frame { at: [x, y], along: [tx, ty], .. } = track.at(s);
            let (x, y) = (corner[0] - x, corner[1] - y);
            let (along, towards) = (x * tx + y * ty, x * ty - y * tx);
            // About the middle of the satellite's tooth that comes into this space.
            let (out, turned) = (teeth.r + towards, (s - middle) / teeth.r);
            let (radius, angle) = (out.hypot(along), flank.sign * (along.atan2(out) + turned));
            match self.satellite.fillet_distance([radius * angle.cos(), radius * angle.sin()]) {
                (distance, true) => distance,
                _ => f64::INFINITY,
            }
        };
        // Ever denser towards the tip: the corner comes nearest soon after the involute.
        let place = |i: u32| {
            let part = f64::from(i.min(PLACES)) / f64::from(PLACES);
            flank.tip + (flank.foot - flank.tip) * part * part
        };
        let (least, i) = (0..=PLACES)
            .map(|i| (distance(place(i)), i))
            .fold((f64::INFINITY, 0), |a, b| if b.0 < a.0 { b } else { a });
        let (_, refined) = golden(place(i.saturating_sub(1)), place(i + 1), 32, distance);
        (0.5 * teeth.backlash * teeth.cos - least.min(refined)).max(0.0)
    }
}

/// Places of a flank from its tip to the cutter's end, both included, and on either side of the arcs' junction.
fn flank_frames<'a>(track: &'a Track<'_>, flank: &Flank, end: f64) -> impl Iterator<Item = Frame> + 'a {
    let ends = track.jumps(flank.tip, end).into_iter().chain([end]).map(|s| track.at(s));
    track.frames(flank.tip, end, PLACES).chain(ends)
}
