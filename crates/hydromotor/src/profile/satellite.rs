//! The satellite's teeth: involutes, and the root that a rack with rounded tips cuts.
//!
//! The outline is half a tooth about its middle, the other half mirrored. The rack is the one that the
//! involutes belong to, with the addendum `h_a + c − x` and tips rounded by `ρ`. As its pitch line has rolled
//! by `v` from the middle of the space:
//!
//! ```text
//! X = r·e_r + (1 + ρ/D)·[(v_F − v)·e_t − h_F·e_r]        D² = (v_F − v)² + h_F²
//! ```
//!
//! `h_F`, `v_F`: depth of the rounding's centre below the pitch line and its distance from the middle of the
//! rack's tooth. The involute begins at the roll angle `t = tan α − (h_F + ρ·sin α)/(r·sin α·cos α)`; below 0
//! the rack undercuts the tooth, and the involute begins where the rack's rounding leaves it.
//!
//! Distances from the outline are exact. For the fillet a chain of chords gives the nearest place, and the
//! foot near there follows from its normal. With the rack at `v` the normal passes through the pitch point,
//! so that `P − C` and `F − C` have one direction.

use super::Part;
use super::form::{Teeth, involute};
use crate::Error;
use crate::quantity::WheelKind;
use epicyclic_numerics::roots::bracketed;
use std::f64::consts::PI;

/// Number of chords of a fillet in the search for its nearest place.
const CHORDS: u32 = 64;

/// A satellite's tooth in modules.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct SatelliteTooth {
    teeth: Teeth,
    /// Half the angle of a pitch.
    half_pitch: f64,
    /// Angle of the middle of a tooth.
    pub(super) offset: f64,
    /// Roll angles of the involute's ends.
    pub(super) from: f64,
    pub(super) to: f64,
    /// The rack's roll where the fillet begins, at the involute.
    fillet: f64,
    pub(super) undercut: bool,
    chain: Vec<[f64; 2]>,
    /// Angles from the middle of the tooth to the tip's corner and to where the root circle begins.
    tip_angle: f64,
    root_angle: f64,
    corner: [f64; 2],
    /// Radius where the involute begins.
    foot: f64,
}

impl SatelliteTooth {
    /// Tooth with its middle at the angle `offset`.
    pub(super) fn new(teeth: &Teeth, satellite_teeth: u32, offset: f64) -> Result<Self, Error> {
        let from = teeth.tan + teeth.rack_roll / teeth.r;
        let rack_pitch = 0.5 * PI - teeth.half_tooth;
        let mut tooth = Self {
            teeth: *teeth,
            half_pitch: PI / f64::from(satellite_teeth),
            offset,
            from,
            to: teeth.roll_angle(teeth.tip),
            fillet: rack_pitch + teeth.rack_roll,
            undercut: from < 0.0,
            chain: Vec::new(),
            tip_angle: teeth.tip_angle(),
            root_angle: PI / f64::from(satellite_teeth) - teeth.rack_half / teeth.r,
            corner: [0.0; 2],
            foot: 0.0,
        };
        if tooth.undercut {
            let Some(fillet) = tooth.leaving() else {
                return Err(Error::NoFlank { wheel: WheelKind::Satellite });
            };
            tooth.fillet = fillet;
            tooth.from = teeth.roll_angle(radius(tooth.fillet_point(fillet)));
        }
        if tooth.from >= tooth.to {
            return Err(Error::NoFlank { wheel: WheelKind::Satellite });
        }
        tooth.corner = tooth.on_flank(tooth.to);
        tooth.foot = radius(tooth.on_flank(tooth.from));
        tooth.chain = (0..=CHORDS).map(|i| tooth.on_fillet(f64::from(i) / f64::from(CHORDS))).collect();
        Ok(tooth)
    }

    /// The roll at which the rack's rounding leaves the involute of an undercut tooth: above the base circle
    /// it goes from outside the tooth to within.
    fn leaving(&self) -> Option<f64> {
        const COUNT: u32 = 256;
        let inside = |v: f64| {
            let point = self.fillet_point(v);
            let t = self.teeth.roll_angle(radius(point));
            libm::atan2(point[1], point[0]) - self.teeth.half_angle(self.teeth.half_tooth, t)
        };
        let at =
            |i: u32| self.fillet + (self.teeth.rack_half - self.fillet) * f64::from(i) / f64::from(COUNT);
        (0..COUNT)
            .map(|i| (at(i), at(i + 1)))
            .take_while(|&(_, v)| radius(self.fillet_point(v)) > self.teeth.base)
            .find(|&(_, v)| inside(v) < 0.0)
            .map(|(v, next)| bracketed(v, next, inside))
    }

    /// The fillet's point at a roll of the rack, about the middle of the tooth.
    fn fillet_point(&self, v: f64) -> [f64; 2] {
        let Teeth { r, rack_half, rack_depth, fillet, .. } = self.teeth;
        let along = rack_half - v;
        let scale = 1.0 + fillet / libm::hypot(along, rack_depth);
        let (radial, along) = (r - rack_depth * scale, along * scale);
        // The middle of the space lies half a pitch ahead, and the roll counts back from there.
        polar(libm::hypot(radial, along), self.half_pitch - v / r - libm::atan2(along, radial))
    }

    /// A point of the fillet from the involute, 0, to the root circle, 1.
    fn on_fillet(&self, part: f64) -> [f64; 2] {
        self.fillet_point(self.fillet + (self.teeth.rack_half - self.fillet) * part)
    }

    /// The point of the involute at a roll angle.
    pub(crate) fn on_flank(&self, t: f64) -> [f64; 2] {
        let radius = self.teeth.base * (1.0 + t * t).sqrt();
        polar(radius, self.teeth.half_angle(self.teeth.half_tooth, t))
    }

    /// The part of a tooth at a share of its length, counter-clockwise; parts in the order of
    /// [`Self::parts`].
    pub(crate) fn on(&self, index: usize, part: f64) -> [f64; 2] {
        let mirrored = |[x, y]: [f64; 2]| [x, -y];
        let (tip, root) = (self.tip_angle, self.root_angle);
        let roll = |part: f64| self.from + (self.to - self.from) * part;
        match index {
            0 => mirrored(self.on_fillet(1.0 - part)),
            1 => mirrored(self.on_flank(roll(part))),
            2 => polar(self.teeth.tip, tip * (2.0 * part - 1.0)),
            3 => self.on_flank(roll(1.0 - part)),
            4 => self.on_fillet(part),
            _ => polar(self.teeth.root, root + 2.0 * (self.half_pitch - root) * part),
        }
    }

    /// The outline, counter-clockwise, with `count` points of each part.
    pub(super) fn outline(&self, count: impl Fn(Part) -> u32, mut add: impl FnMut(Part, [f64; 2], bool)) {
        let parts = [Part::Fillet, Part::Flank, Part::Tip, Part::Flank, Part::Fillet, Part::Root];
        let tooth: Vec<(Part, [f64; 2], bool)> = parts
            .into_iter()
            .enumerate()
            .flat_map(|(index, part)| {
                let count = count(part);
                (0..count).map(move |i| (part, index, f64::from(i) / f64::from(count), i == 0))
            })
            .map(|(part, index, share, first)| (part, self.on(index, share), first))
            .collect();
        for k in 0..(PI / self.half_pitch).round() as u32 {
            let (sin, cos) = libm::sincos(self.offset + 2.0 * self.half_pitch * f64::from(k));
            for &(part, [x, y], first) in &tooth {
                add(part, [x * cos - y * sin, x * sin + y * cos], first);
            }
        }
    }

    /// Distance of a point of the satellite's frame from its outline, negative within.
    ///
    /// Halves of teeth are mirror images, so that the nearest point lies in the half that the point lies in.
    pub(super) fn distance(&self, [x, y]: [f64; 2]) -> f64 {
        let radius = libm::hypot(x, y);
        let pitch = 2.0 * self.half_pitch;
        let angle = libm::atan2(y, x) - self.offset;
        let angle = (angle - pitch * (angle / pitch).round()).abs();
        let folded = polar(radius, angle);
        let nearer = |one: f64, other: f64| if other.abs() < one.abs() { other } else { one };
        let mut nearest = f64::INFINITY;
        if angle <= self.tip_angle {
            nearest = nearer(nearest, radius - self.teeth.tip);
        } else {
            let [cx, cy] = self.corner;
            nearest = nearer(nearest, libm::hypot(folded[0] - cx, folded[1] - cy));
        }
        if let Some((distance, t)) = self.flank_distance(radius, angle)
            && (self.from..=self.to).contains(&t)
        {
            nearest = nearer(nearest, distance);
        }
        if angle >= self.root_angle {
            nearest = nearer(nearest, radius - self.teeth.root);
        }
        if radius - self.foot < nearest.abs() {
            nearest = nearer(nearest, self.fillet_distance(folded).0);
        }
        nearest
    }

    /// Distance of a point, about the middle of the tooth, from the fillet, negative within the tooth, and
    /// whether its foot lies between the fillet's ends.
    pub(super) fn fillet_distance(&self, point: [f64; 2]) -> (f64, bool) {
        let (mut nearest, mut chord) = (f64::INFINITY, 0);
        for (i, ends) in self.chain.windows(2).enumerate() {
            let [[ax, ay], [bx, by]] = [ends[0], ends[1]];
            let (ux, uy, vx, vy) = (bx - ax, by - ay, point[0] - ax, point[1] - ay);
            let share = ((ux * vx + uy * vy) / (ux * ux + uy * uy)).clamp(0.0, 1.0);
            let distance = libm::hypot(vx - share * ux, vy - share * uy);
            if distance < nearest.abs() {
                // From the involute to the root the space lies to the right; an undercut tooth's edge is
                // convex.
                let edge = self.undercut && i == 0 && share == 0.0;
                let outside = edge || ux * vy - uy * vx <= 0.0;
                (nearest, chord) = (if outside { distance } else { -distance }, i);
            }
        }
        let Teeth { r, rack_half, rack_depth, fillet, .. } = self.teeth;
        let (radius, angle) = (radius(point), libm::atan2(point[1], point[0]));
        // From the pitch point with the rack at `v`, outwards and along the rack.
        let from_contact = |v: f64| {
            let (sin, cos) = libm::sincos(self.half_pitch - v / r - angle);
            [radius * cos - r, radius * sin]
        };
        let aside = |v: f64| {
            let [out, along] = from_contact(v);
            out * (rack_half - v) + along * rack_depth
        };
        let node = |i: usize| self.fillet + (rack_half - self.fillet) * i as f64 / f64::from(CHORDS);
        let (low, high) = (node(chord.saturating_sub(1)), node((chord + 2).min(CHORDS as usize)));
        if !(aside(low) < 0.0 && aside(high) >= 0.0) {
            return (nearest, false);
        }
        let v = bracketed(low, high, aside);
        let [out, along] = from_contact(v);
        let to_centre = libm::hypot(rack_half - v, rack_depth);
        (to_centre + fillet - (along * (rack_half - v) - out * rack_depth) / to_centre, true)
    }

    /// Distance along the normal from the involute, however far that goes on, and the roll angle of the foot.
    ///
    /// Points at one distance from an involute lie on the involute turned by that distance over the base
    /// radius.
    pub(super) fn flank_distance(&self, radius: f64, angle: f64) -> Option<(f64, f64)> {
        let Teeth { base, r, tan, half_tooth, .. } = self.teeth;
        if radius < base {
            return None;
        }
        let t = self.teeth.roll_angle(radius);
        let turned = angle - (half_tooth / r + involute(tan) - involute(t));
        Some((base * turned, t - turned))
    }

    /// The greatest radius.
    pub(super) fn tip_radius(&self) -> f64 {
        self.teeth.tip
    }
}

fn polar(radius: f64, angle: f64) -> [f64; 2] {
    [radius * libm::cos(angle), radius * libm::sin(angle)]
}

fn radius([x, y]: [f64; 2]) -> f64 {
    libm::hypot(x, y)
}
