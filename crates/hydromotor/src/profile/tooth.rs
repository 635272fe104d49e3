//! Single teeth in their own frame: sections across them and points of load on their flanks.
//!
//! The x axis is the tooth's middle line, from root to tip. Of the satellite it is the ray through the middle
//! of the tooth; of stator and rotor the normal of the centrode through the middle of the land at the tip,
//! since there the two flanks differ where the curvature changes.

use super::cut::{Curve, Piece, point};
use super::track::{Frame, Side};
use super::{Part, Profile, phases};
use crate::contact::{Conjugate, Contact};
use std::f64::consts::PI;

/// A section across a tooth, at right angles to its middle line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Section {
    /// Place on the middle line.
    pub(crate) x: f64,
    /// Middle of the section.
    pub(crate) y: f64,
    pub(crate) thickness: f64,
}

/// A tooth in modules.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Tooth {
    /// Sections from the tip to the root.
    pub(crate) sections: Vec<Section>,
    /// `6/s²` of each section, by which a moment of 1 bends it on a width of 1, and that times its `x` and
    /// `y`.
    moduli: [Vec<f64>; 3],
    origin: [f64; 2],
    axis: [f64; 2],
}

/// A point of load and the unit vector of the force on the tooth, in the tooth's frame.
pub(crate) type Loading = ([f64; 2], [f64; 2]);

impl Tooth {
    /// Tooth from the two sides of its outline, both from tip to root, in the wheel's frame.
    fn new(origin: [f64; 2], axis: [f64; 2], sides: [Vec<[f64; 2]>; 2]) -> Self {
        let mut tooth = Self { sections: Vec::new(), moduli: [const { Vec::new() }; 3], origin, axis };
        // Points that do not go down are dropped: at its end the fillet lies along the root.
        let falling = |side: Vec<[f64; 2]>| {
            let mut chain: Vec<[f64; 2]> = Vec::with_capacity(side.len());
            for at in side {
                let at = tooth.place(at);
                if chain.last().is_none_or(|last| at[0] < last[0]) {
                    chain.push(at);
                }
            }
            chain
        };
        let [one, other] = sides.map(falling);
        let across = |chain: &[[f64; 2]], x: f64| {
            let end = chain.partition_point(|at| at[0] > x);
            let (before, here) = (chain.get(end.checked_sub(1)?), *chain.get(end)?);
            let before = *before?;
            Some(before[1] + (here[1] - before[1]) * (before[0] - x) / (before[0] - here[0]))
        };
        let mut places: Vec<f64> = one.iter().chain(&other).map(|at| at[0]).collect();
        places.sort_by(|a, b| b.total_cmp(a));
        let section = |x: f64| {
            let (a, b) = (across(&one, x)?, across(&other, x)?);
            Some(Section { x, y: 0.5 * (a + b), thickness: (a - b).abs() })
        };
        tooth.sections = places.into_iter().filter_map(section).collect();
        let modulus = |section: &Section| 6.0 / (section.thickness * section.thickness);
        tooth.moduli = [
            tooth.sections.iter().map(modulus).collect(),
            tooth.sections.iter().map(|section| modulus(section) * section.x).collect(),
            tooth.sections.iter().map(|section| modulus(section) * section.y).collect(),
        ];
        tooth
    }

    /// Mirror image of the tooth in the x axis of the wheel's frame, turned.
    fn mirrored(&self, by: f64) -> Self {
        let (sin, cos) = libm::sincos(by);
        let image = |[x, y]: [f64; 2]| [x * cos + y * sin, x * sin - y * cos];
        let mut image = Self { origin: image(self.origin), axis: image(self.axis), ..self.clone() };
        for section in &mut image.sections {
            section.y = -section.y;
        }
        for moment in &mut image.moduli[2] {
            *moment = -*moment;
        }
        image
    }

    /// The greatest bending stress, at least 0, on a width of 1 among the sections below the point of load.
    ///
    /// Of a force of 1: above where its line crosses the middle line the moment has the other sign.
    pub(crate) fn bending(&self, (at, force): Loading) -> f64 {
        const LANES: usize = 4;
        let (along, across) = (force[0] * force[1].signum(), force[1].abs());
        let moment = at[0] * across - at[1] * along;
        let below = self.sections.partition_point(|section| section.x >= at[0]);
        let [plain, by_x, by_y] = self.moduli.each_ref().map(|of| &of[below..]);
        let stress = |i: usize| plain[i] * moment - by_x[i] * across + by_y[i] * along;
        let whole = plain.len() / LANES * LANES;
        let mut greatest = [0.0_f64; LANES];
        for ((plain, by_x), by_y) in
            plain.chunks_exact(LANES).zip(by_x.chunks_exact(LANES)).zip(by_y.chunks_exact(LANES))
        {
            for lane in 0..LANES {
                let stress = plain[lane] * moment - by_x[lane] * across + by_y[lane] * along;
                greatest[lane] = if stress > greatest[lane] { stress } else { greatest[lane] };
            }
        }
        (whole..plain.len()).map(stress).chain(greatest).fold(0.0, f64::max)
    }

    /// The section that is stressed most.
    pub(crate) fn weakest(&self, (at, force): Loading) -> Option<&Section> {
        let (along, across) = (force[0] * force[1].signum(), force[1].abs());
        let stress = |section: &Section| {
            let moment = (at[0] - section.x) * across - (at[1] - section.y) * along;
            6.0 * moment / (section.thickness * section.thickness)
        };
        let below = self.sections.partition_point(|section| section.x >= at[0]);
        self.sections[below..].iter().max_by(|a, b| stress(a).total_cmp(&stress(b)))
    }

    /// Distance of the frame from another.
    #[cfg(test)]
    pub(crate) fn apart(&self, other: &Self) -> f64 {
        let apart = |[ax, ay]: [f64; 2], [bx, by]: [f64; 2]| libm::hypot(ax - bx, ay - by);
        apart(self.origin, other.origin) + apart(self.axis, other.axis)
    }

    /// A vector of the wheel's frame in that of the tooth.
    fn turned(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [ax, ay] = self.axis;
        [x * ax + y * ay, y * ax - x * ay]
    }

    fn place(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        self.turned([x - self.origin[0], y - self.origin[1]])
    }
}

impl Profile {
    /// The teeth of a lobe of stator or rotor, each after the space of its index, with `points` points per
    /// fillet.
    ///
    /// About half of them are the mirror images, in the lobe's middle, of others.
    pub(crate) fn wheel_teeth(&self, side: Side, points: u32) -> Vec<Tooth> {
        let (track, cut) = (self.track(side), self.cut(side));
        let tips: Vec<usize> = (0..cut.pieces.len()).filter(|&i| cut.pieces[i].part == Part::Tip).collect();
        let trough = track.shape.trough();
        // The polar angle of a lobe; the rotor's track is clockwise.
        let lobe = match side {
            Side::Stator => 2.0 * trough.theta3,
            Side::Rotor => -2.0 * trough.theta1,
        };
        // Tooth i has its middle half a pitch behind that of space i.
        let last = tips.len().checked_sub(if self.offset(side) == 0.0 { 1 } else { 2 });
        let mut teeth: Vec<Tooth> = Vec::with_capacity(tips.len());
        for (i, &tip) in tips.iter().enumerate() {
            let tooth = match last.and_then(|last| last.checked_sub(i)).and_then(|image| teeth.get(image)) {
                Some(image) => image.mirrored(lobe),
                None => self.wheel_tooth(side, points, tip),
            };
            teeth.push(tooth);
        }
        teeth
    }

    /// The tooth with the land of this index among the pieces.
    fn wheel_tooth(&self, side: Side, points: u32, tip: usize) -> Tooth {
        let (track, cut, teeth) = (self.track(side), self.cut(side), self.teeth());
        let sampled = |piece: &Piece| -> Vec<[f64; 2]> {
            let count = if piece.part == Part::Fillet { points } else { points.div_ceil(2) };
            let frames = track.frames(piece.from, piece.to, count).chain([track.at(piece.to)]);
            frames.map(|frame| point(teeth, piece.curve, &frame)).collect()
        };
        let land = &cut.pieces[tip];
        let Frame { at, along: [tx, ty], .. } = track.at(0.5 * (land.from + land.to));
        let side_of = |piece: &Piece| matches!(piece.part, Part::Flank | Part::Fillet);
        let mut after: Vec<[f64; 2]> = Vec::new();
        for piece in cut.pieces[..tip].iter().rev().take_while(|piece| side_of(piece)) {
            after.extend(sampled(piece).into_iter().rev());
        }
        let (next, shift) = if tip + 1 < cut.pieces.len() { (tip + 1, 0.0) } else { (0, track.lobe()) };
        let mut before: Vec<[f64; 2]> = Vec::new();
        for piece in cut.pieces[next..].iter().take_while(|piece| side_of(piece)) {
            before.extend(sampled(&piece.shifted(shift)));
        }
        Tooth::new(at, [-ty, tx], [after, before])
    }

    /// The teeth with none taken for a mirror image.
    #[cfg(test)]
    pub(crate) fn wheel_teeth_one_by_one(&self, side: Side, points: u32) -> Vec<Tooth> {
        let pieces = &self.cut(side).pieces;
        let tips = (0..pieces.len()).filter(|&i| pieces[i].part == Part::Tip);
        tips.map(|tip| self.wheel_tooth(side, points, tip)).collect()
    }

    /// Arc length from a crest to the middle of the first space.
    fn offset(&self, side: Side) -> f64 {
        let offsets = phases(self.form.crest, self.motor.numbers().satellite_teeth());
        match side {
            Side::Stator => offsets[0],
            Side::Rotor => offsets[1],
        }
    }

    /// Index, within its lobe, of the tooth that a flank at `pitch` belongs to, and the arc length of that
    /// lobe's beginning.
    pub(crate) fn tooth_of(&self, side: Side, sign: f64, pitch: f64) -> (usize, f64) {
        let first = self.cut(side).flanks[0][1].pitch;
        let count = self.cut(side).flanks.len() as f64;
        let half = self.teeth().half_space;
        // The space after whose middle, or before whose middle, the flank lies.
        let space = ((pitch - sign * half - (first - half)) / PI).round();
        let tooth = if sign > 0.0 { space } else { space - 1.0 };
        let lobes = (tooth / count).floor();
        ((tooth - lobes * count) as usize, lobes * self.lobe_length(side))
    }

    /// Point and direction of the force on a tooth of stator or rotor with contact at an arc length of its
    /// own lobe.
    #[cfg(test)]
    pub(crate) fn wheel_loading(&self, side: Side, tooth: &Tooth, sign: f64, pitch: f64, s: f64) -> Loading {
        self.loading(tooth, sign, pitch, self.track(side).at(s))
    }

    /// Point and direction of the force on a flank at `pitch` in a lobe that begins at the arc length `lobe`,
    /// by the contact.
    pub(crate) fn wheel_loading_at(
        &self,
        side: Side,
        tooth: &Tooth,
        sign: f64,
        pitch: f64,
        lobe: f64,
        contact: &Contact,
    ) -> Loading {
        let track = self.track(side);
        let own = contact.lobes_back((lobe / track.lobe()).round(), track.shape.trough());
        self.loading(tooth, sign, pitch - lobe, track.frame(&own))
    }

    fn loading(&self, tooth: &Tooth, sign: f64, pitch: f64, frame: Frame) -> Loading {
        let teeth = self.teeth();
        let at = point(teeth, Curve::Flank { sign, pitch }, &frame);
        let from = Frame { at: [0.0; 2], ..frame };
        (tooth.place(at), tooth.turned(from.point(sign * teeth.cos, -teeth.sin)))
    }

    /// The satellite's tooth, with `points` points per fillet.
    pub(crate) fn satellite_tooth(&self, points: u32) -> Tooth {
        let (flank, fillet) = (points.div_ceil(2), points);
        let mut side: Vec<[f64; 2]> = Vec::new();
        for (index, count) in [(3, flank), (4, fillet)] {
            side.extend((0..=count).map(|i| self.satellite.on(index, f64::from(i) / f64::from(count))));
        }
        let mirrored = side.iter().map(|&[x, y]| [x, -y]).collect();
        Tooth::new([0.0; 2], [1.0, 0.0], [side, mirrored])
    }

    /// Point and direction of the force on the satellite's tooth with contact at `e` along the line of
    /// action.
    pub(crate) fn satellite_loading(&self, e: f64) -> Loading {
        let teeth = self.teeth();
        let t = teeth.tan - e / teeth.base;
        // The line of action touches the base circle where the involute has unwound from.
        let (sin, cos) = libm::sincos(teeth.half_angle(teeth.half_tooth, 0.0) - t);
        (self.satellite.on_flank(t), [sin, -cos])
    }
}
