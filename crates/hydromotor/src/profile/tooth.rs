//! Single teeth in their own frame: sections across them and points of load on their flanks.
//!
//! The x axis is the tooth's middle line, from root to tip. Of the satellite it is the ray through the middle of the tooth; of stator and
//! rotor the normal of the centrode through the middle of the land at the tip, since there the two flanks differ where the curvature changes.

use super::cut::{Curve, Piece, point};
use super::track::{Frame, Side};
use super::{Part, Profile};
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
    /// From the tip to the root.
    pub(crate) sections: Vec<Section>,
    origin: [f64; 2],
    axis: [f64; 2],
}

/// A point of load and the unit vector of the force on the tooth, in the tooth's frame.
pub(crate) type Loading = ([f64; 2], [f64; 2]);

impl Tooth {
    /// From the two sides of its outline, both from tip to root, in the wheel's frame.
    fn new(origin: [f64; 2], axis: [f64; 2], sides: [Vec<[f64; 2]>; 2]) -> Self {
        let mut tooth = Self { sections: Vec::new(), origin, axis };
        // Only what goes down: at its end the fillet lies along the root.
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
        tooth
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
    /// The teeth of a lobe of stator or rotor, each after the space of its index, with so many points a fillet.
    pub(crate) fn wheel_teeth(&self, side: Side, points: u32) -> Vec<Tooth> {
        let (track, cut, teeth) = (self.track(side), self.cut(side), self.teeth());
        let lobe = track.lobe();
        let tips: Vec<usize> = (0..cut.pieces.len()).filter(|&i| cut.pieces[i].part == Part::Tip).collect();
        let sampled = |piece: &Piece| -> Vec<[f64; 2]> {
            let count = if piece.part == Part::Fillet { points } else { points.div_ceil(2) };
            let frames = track.frames(piece.from, piece.to, count).chain([track.at(piece.to)]);
            frames.map(|frame| point(teeth, piece.curve, &frame)).collect()
        };
        let tooth = |&tip: &usize| {
            let land = &cut.pieces[tip];
            let Frame { at, along: [tx, ty], .. } = track.at(0.5 * (land.from + land.to));
            let side_of = |piece: &Piece| matches!(piece.part, Part::Flank | Part::Fillet);
            let mut after: Vec<[f64; 2]> = Vec::new();
            for piece in cut.pieces[..tip].iter().rev().take_while(|piece| side_of(piece)) {
                after.extend(sampled(piece).into_iter().rev());
            }
            let (next, shift) = if tip + 1 < cut.pieces.len() { (tip + 1, 0.0) } else { (0, lobe) };
            let mut before: Vec<[f64; 2]> = Vec::new();
            for piece in cut.pieces[next..].iter().take_while(|piece| side_of(piece)) {
                before.extend(sampled(&piece.shifted(shift)));
            }
            Tooth::new(at, [-ty, tx], [after, before])
        };
        tips.iter().map(tooth).collect()
    }

    /// Index, within its lobe, of the tooth that a flank at `pitch` belongs to, and the arc length of that lobe's beginning.
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

    /// Point and direction of the force on a tooth of stator or rotor with contact at an arc length of its own lobe.
    pub(crate) fn wheel_loading(&self, side: Side, tooth: &Tooth, sign: f64, pitch: f64, s: f64) -> Loading {
        let teeth = self.teeth();
        let frame = self.track(side).at(s);
        let at = point(teeth, Curve::Flank { sign, pitch }, &frame);
        let from = Frame { at: [0.0; 2], ..frame };
        (tooth.place(at), tooth.turned(from.point(sign * teeth.cos, -teeth.sin)))
    }

    /// The satellite's tooth, with so many points a fillet.
    pub(crate) fn satellite_tooth(&self, points: u32) -> Tooth {
        let (flank, fillet) = (points.div_ceil(2), points);
        let mut side: Vec<[f64; 2]> = Vec::new();
        for (index, count) in [(3, flank), (4, fillet)] {
            side.extend((0..=count).map(|i| self.satellite.on(index, f64::from(i) / f64::from(count))));
        }
        let mirrored = side.iter().map(|&[x, y]| [x, -y]).collect();
        Tooth::new([0.0; 2], [1.0, 0.0], [side, mirrored])
    }

    /// Point and direction of the force on the satellite's tooth with contact at `e` along the line of action.
    pub(crate) fn satellite_loading(&self, e: f64) -> Loading {
        let teeth = self.teeth();
        let t = teeth.tan - e / teeth.base;
        // The line of action touches the base circle where the involute has unwound from.
        let (sin, cos) = (teeth.half_angle(teeth.half_tooth, 0.0) - t).sin_cos();
        (self.satellite.on_flank(t), [sin, -cos])
    }
}
