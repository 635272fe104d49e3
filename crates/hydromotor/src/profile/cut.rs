//! The teeth of stator and rotor as the envelope of the satellite-shaped cutter that rolls along the track.
//!
//! Let the cutter be in contact at the arc length `s`, at its point `C`. `T` is the unit vector along the
//! track and `n` the one across it to the satellite. Each part of the outline is then explicit:
//!
//! ```text
//! flank    X = C − Δ·cos α·u        u = cos α·T ∓ sin α·n        Δ = s − s₀
//! fillet   X = F + ρ·e              e = (F − C)/|F − C|          F − C = R_F·sin ψ·T + (r − R_F·cos ψ)·n
//! root     X = C − h·n              tip    X = C + h_a·n
//! ```
//!
//! | symbol | meaning |
//! |---|---|
//! | `s₀` | contact where the flank cuts the centrode: half a space from `s_c`, `±` on its sides |
//! | `s_c` | middle of the flank's space |
//! | `ψ` | `±φ_F − (s − s_c)/r`, angle at the cutter's centre between contact and `F` |
//! | `F` | centre of the cutter's rounded tip |
//! | `R_F`, `φ_F` | radius and angle of `F` on the cutter |
//!
//! The flank's normal passes through the pitch point (law of gearing), and on an involute it touches the base
//! circle. As the pitch point runs along the pitch circle by `Δ`, the distance along the normal grows by
//! `Δ·cos α`, whatever the track's curvature. The *roll* `η = ±Δ` is positive towards the wheel's tip. The
//! envelope's derivatives, by which cusps are found:
//!
//! ```text
//! flank    dX/ds = ±(sin α − η·κ·cos α)·u⊥
//! fillet   dX/ds = [(κ − 1/r)·(D + ρ) − ρ/D·T·e⊥]·e⊥           D = |F − C|
//! ```
//!
//! with `κ` positive towards the satellite: Euler and Savary. The flank has a cusp at `η = tan α/κ`, on the
//! root's side where the wheel bulges towards the satellite, on the tip's side where it is hollow.

use super::Part;
use super::form::Teeth;
use super::track::{Frame, Side, Track};
use crate::Error;
use crate::motor::Shape;
use crate::quantity::WheelKind;
use crate::tolerance::{ALONGSIDE, LEAST_ADDENDUM, MET, STEP};
use epicyclic_numerics::roots::bracketed;
use std::f64::consts::PI;

/// Number of places of a flank in the search for cusps.
const PLACES: u32 = 24;

/// A formula of the outline.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Curve {
    /// Parallel to the centrode at a distance to the left.
    Parallel { across: f64 },
    /// Flank on the side `sign` of its space, with `s₀`.
    Flank { sign: f64, pitch: f64 },
    /// Fillet on the side `sign` of its space, with `s_c`.
    Fillet { sign: f64, middle: f64 },
}

/// A part of the outline between two arc lengths of contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Piece {
    pub(super) part: Part,
    pub(super) curve: Curve,
    pub(super) from: f64,
    pub(super) to: f64,
}

impl Piece {
    /// Returns the part moved by whole lobes.
    pub(super) fn shifted(self, by: f64) -> Self {
        let curve = match self.curve {
            Curve::Parallel { .. } => self.curve,
            Curve::Flank { sign, pitch } => Curve::Flank { sign, pitch: pitch + by },
            Curve::Fillet { sign, middle } => Curve::Fillet { sign, middle: middle + by },
        };
        Self { curve, from: self.from + by, to: self.to + by, ..self }
    }
}

/// A flank's ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Flank {
    pub(super) sign: f64,
    /// `s₀`.
    pub(super) pitch: f64,
    /// Contact of its end at the tip, and the foot of that end on the centrode.
    pub(super) tip: f64,
    pub(super) foot: f64,
    /// Missing height to the tip if the flank ends in a cusp before; the tooth goes on there along the
    /// centrode's normal.
    pub(super) missing: f64,
    /// Contact of its end at the fillet, and that of the fillet's end there.
    pub(super) end: f64,
    pub(super) fillet: f64,
    /// Contact at which the flank goes on to the fillet after a loop at its end, if only a loop is cut off.
    pub(super) again: Option<f64>,
    /// Whether the cutter removes a part of the flank.
    pub(super) undercut: bool,
}

impl Flank {
    pub(super) fn roll(&self, s: f64) -> f64 {
        self.sign * (s - self.pitch)
    }

    /// Mirrored in a crest, and whole lobes further on into the space with its middle at `middle`.
    fn mirrored(self, middle: f64, lobe: f64) -> Self {
        let shift = lobe * ((middle + self.pitch) / lobe).round();
        let mirror = |s: f64| shift - s;
        Self {
            sign: -self.sign,
            pitch: mirror(self.pitch),
            tip: mirror(self.tip),
            foot: mirror(self.foot),
            end: mirror(self.end),
            fillet: mirror(self.fillet),
            again: self.again.map(mirror),
            ..self
        }
    }
}

/// The teeth of a lobe.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Cut {
    pub(super) side: Side,
    /// Flanks of every space, first the one before its middle, then the one after.
    pub(super) flanks: Vec<[Flank; 2]>,
    /// The outline along the track, from a space on.
    pub(super) pieces: Vec<Piece>,
}

/// The point of a curve at a place of contact.
pub(super) fn point(teeth: &Teeth, curve: Curve, frame: &Frame) -> [f64; 2] {
    match curve {
        Curve::Parallel { across } => frame.point(0.0, across),
        Curve::Flank { sign, pitch } => {
            let path = (frame.s - pitch) * teeth.cos;
            frame.point(-path * teeth.cos, sign * path * teeth.sin)
        }
        Curve::Fillet { sign, middle } => {
            let (along, across) = round_centre(teeth, sign, middle, frame.s);
            let scale = 1.0 + teeth.fillet / libm::hypot(along, across);
            frame.point(along * scale, across * scale)
        }
    }
}

/// `F − C` along and across the track.
fn round_centre(teeth: &Teeth, sign: f64, middle: f64, s: f64) -> (f64, f64) {
    let (sin, cos) = libm::sincos(sign * teeth.round_angle - (s - middle) / teeth.r);
    (teeth.round_radius * sin, teeth.r - teeth.round_radius * cos)
}

/// `dX/ds`.
fn derivative(teeth: &Teeth, curve: Curve, frame: &Frame) -> [f64; 2] {
    let kappa = frame.curvature;
    let (along, across) = match curve {
        Curve::Parallel { across } => (1.0 - across * kappa, 0.0),
        Curve::Flank { sign, pitch } => {
            let rate = sign * teeth.sin - (frame.s - pitch) * kappa * teeth.cos;
            (rate * sign * teeth.sin, rate * teeth.cos)
        }
        Curve::Fillet { sign, middle } => {
            let (along, across) = round_centre(teeth, sign, middle, frame.s);
            let distance = libm::hypot(along, across);
            // e⊥ is e turned left.
            let (turned_along, turned_across) = (-across / distance, along / distance);
            let rate =
                (kappa - 1.0 / teeth.r) * (distance + teeth.fillet) - teeth.fillet / distance * turned_along;
            (rate * turned_along, rate * turned_across)
        }
    };
    let from = Frame { at: [0.0; 2], ..*frame };
    from.point(along, across)
}

/// Distance of the flank from a cusp, `sin α − η·κ·cos α`: positive on the branch that is cut.
pub(super) fn regularity(teeth: &Teeth, flank: &Flank, frame: &Frame) -> f64 {
    teeth.sin - flank.roll(frame.s) * frame.curvature * teeth.cos
}

fn apart([ax, ay]: [f64; 2], [bx, by]: [f64; 2]) -> [f64; 2] {
    [ax - bx, ay - by]
}

/// Contacts on two curves at their crossing, by Newton's method from near it.
fn meeting(teeth: &Teeth, track: &Track<'_>, curves: [Curve; 2], start: [f64; 2]) -> Option<[f64; 2]> {
    let mut s = start;
    for _ in 0..60 {
        let frames = s.map(|s| track.at(s));
        let [gx, gy] = apart(point(teeth, curves[0], &frames[0]), point(teeth, curves[1], &frames[1]));
        let ([ax, ay], [bx, by]) =
            (derivative(teeth, curves[0], &frames[0]), derivative(teeth, curves[1], &frames[1]));
        let determinant = ax * by - ay * bx;
        if determinant.abs() < ALONGSIDE {
            return None;
        }
        // At most a quarter of a pitch at once.
        let steps = [(gx * by - gy * bx) / determinant, (gx * ay - gy * ax) / determinant]
            .map(|step| step.clamp(-0.25 * PI, 0.25 * PI));
        s = [s[0] - steps[0], s[1] - steps[1]];
        if !(s[0].is_finite() && s[1].is_finite()) {
            return None;
        }
        if steps[0].abs() + steps[1].abs() < STEP * (1.0 + s[0].abs() + s[1].abs()) {
            return (libm::hypot(gx, gy) < MET).then_some(s);
        }
    }
    None
}

impl Cut {
    /// The teeth of one lobe with a space in the middle of the crest or half a pitch further.
    pub(super) fn new(
        shape: &Shape,
        side: Side,
        teeth: &Teeth,
        teeth_per_lobe: u32,
        offset: f64,
    ) -> Result<Self, Error> {
        let track = Track { shape, side };
        let after = (0..teeth_per_lobe)
            .map(|i| Self::flank(&track, teeth, offset + PI * f64::from(i), 1.0))
            .collect::<Result<Vec<_>, _>>()?;
        Self::of_flanks(&track, teeth, offset, &after)
    }

    /// Teeth of a lobe from the flanks after the middles of its spaces.
    pub(super) fn of_flanks(
        track: &Track<'_>,
        teeth: &Teeth,
        offset: f64,
        after: &[Flank],
    ) -> Result<Self, Error> {
        let (side, lobe, teeth_per_lobe) = (track.side, track.lobe(), after.len() as u32);
        let middle = |i: u32| offset + PI * f64::from(i);
        // The flanks before the middles are the mirror images, in the crest, of those after the middles of
        // other spaces.
        let opposite = if offset == 0.0 { teeth_per_lobe } else { teeth_per_lobe - 1 };
        let flanks: Vec<[Flank; 2]> = (0..teeth_per_lobe)
            .map(|i| {
                [
                    after[((opposite - i) % teeth_per_lobe) as usize].mirrored(middle(i), lobe),
                    after[i as usize],
                ]
            })
            .collect();
        let mut pieces = Vec::with_capacity(7 * flanks.len());
        for (i, [before, after]) in flanks.iter().enumerate() {
            let middle = offset + PI * i as f64;
            let round = teeth.r * teeth.round_angle;
            let next = match flanks.get(i + 1) {
                Some([next, _]) => next.foot,
                None => flanks[0][0].foot + lobe,
            };
            let land = next - after.foot;
            if land <= 0.0 {
                return Err(Error::PointedTip {
                    wheel: if side == Side::Stator { WheelKind::Stator } else { WheelKind::Rotor },
                    addendum: teeth.wheel_addendum,
                    most: Self::greatest_addendum(track, teeth, middle),
                });
            }
            let flank = |flank: &Flank| Curve::Flank { sign: flank.sign, pitch: flank.pitch };
            let fillet = |sign: f64| Curve::Fillet { sign, middle };
            let piece = |part, curve, from, to| Piece { part, curve, from, to };
            let cutter_end = |flank: &Flank| flank.pitch + flank.sign * teeth.cutter_roll;
            pieces.push(piece(Part::Flank, flank(before), before.tip, before.end));
            pieces.extend(
                before.again.map(|again| piece(Part::Flank, flank(before), again, cutter_end(before))),
            );
            pieces.extend([
                piece(Part::Fillet, fillet(-1.0), before.fillet, middle - round),
                piece(
                    Part::Root,
                    Curve::Parallel { across: -teeth.cutter_addendum },
                    middle - round,
                    middle + round,
                ),
                piece(Part::Fillet, fillet(1.0), middle + round, after.fillet),
            ]);
            pieces
                .extend(after.again.map(|again| piece(Part::Flank, flank(after), cutter_end(after), again)));
            pieces.extend([
                piece(Part::Flank, flank(after), after.end, after.tip),
                piece(Part::Tip, Curve::Parallel { across: teeth.wheel_addendum }, after.foot, next),
            ]);
        }
        Ok(Self { side, flanks, pieces })
    }

    /// A flank of the space with its middle at `middle`.
    pub(super) fn flank(track: &Track<'_>, teeth: &Teeth, middle: f64, sign: f64) -> Result<Flank, Error> {
        let pitch = middle + sign * teeth.half_space;
        let Some((tip, foot, missing)) = Self::tip(track, teeth, pitch, sign, teeth.wheel_addendum) else {
            return Err(Error::NoTip {
                wheel: if track.side == Side::Stator { WheelKind::Stator } else { WheelKind::Rotor },
                addendum: teeth.wheel_addendum,
            });
        };
        let end = pitch + sign * teeth.cutter_roll;
        let mut flank =
            Flank { sign, pitch, tip, foot, missing, end, fillet: end, again: None, undercut: false };
        flank.undercut = (1..=PLACES)
            .map(|i| pitch + (end - pitch) * f64::from(i) / f64::from(PLACES))
            .chain(track.jumps(pitch, end))
            .map(|s| track.at(s))
            .any(|frame| regularity(teeth, &flank, &frame) <= 0.0);
        if flank.undercut
            && let Some((curve, [leaves, onto])) = Self::undercut(track, teeth, &flank, middle)
        {
            flank.end = leaves;
            match curve {
                Curve::Fillet { .. } => flank.fillet = onto,
                _ => flank.again = Some(onto),
            }
        }
        Ok(flank)
    }

    /// End of a flank: the crossing with the parallel of the centrode at the addendum, or a cusp before.
    /// Returns the contact, the foot on the centrode, and the height missing.
    pub(super) fn tip(
        track: &Track<'_>,
        teeth: &Teeth,
        pitch: f64,
        sign: f64,
        addendum: f64,
    ) -> Option<(f64, f64, f64)> {
        let roll = sign * addendum / (teeth.sin * teeth.cos);
        let flank = Curve::Flank { sign, pitch };
        let curves = [flank, Curve::Parallel { across: addendum }];
        let start = [pitch + roll, pitch + roll * teeth.sin * teeth.sin];
        let regular = |s: f64| teeth.sin - sign * (s - pitch) * track.at(s).curvature * teeth.cos;
        if let Some([tip, foot]) = meeting(teeth, track, curves, start)
            && sign * (tip - pitch) > 0.0
            && (1..=8).all(|i| regular(pitch + (tip - pitch) * f64::from(i) / 8.0) > 0.0)
        {
            return Some((tip, foot, 0.0));
        }
        let step = |i: u32| pitch + sign * 0.05 * f64::from(i);
        let beyond = (1..400).find(|&i| regular(step(i)) <= 0.0)?;
        let cusp = bracketed(step(beyond - 1), step(beyond), regular);
        let point = point(teeth, flank, &track.at(cusp));
        // Its foot on the centrode, by Newton's method.
        let mut foot = pitch + (cusp - pitch) * teeth.sin * teeth.sin;
        for _ in 0..60 {
            let frame = track.at(foot);
            let [x, y] = apart(point, frame.at);
            let [tx, ty] = frame.along;
            let (along, height) = (x * tx + y * ty, y * tx - x * ty);
            let move_by = along / (1.0 - height * frame.curvature);
            if move_by.abs() < STEP * (1.0 + foot.abs()) {
                return (height > 0.0 && height < addendum).then_some((cusp, foot, addendum - height));
            }
            foot += move_by.clamp(-0.25 * PI, 0.25 * PI);
        }
        None
    }

    /// The addendum at which the tooth after the space with its middle at `middle` is pointed.
    fn greatest_addendum(track: &Track<'_>, teeth: &Teeth, middle: f64) -> f64 {
        let land = |addendum: f64| {
            let foot = |pitch: f64, sign: f64| {
                Self::tip(track, teeth, pitch, sign, addendum).map(|(_, foot, _)| foot)
            };
            let (after, next) = (middle + teeth.half_space, middle + PI - teeth.half_space);
            match (foot(after, 1.0), foot(next, -1.0)) {
                (Some(after), Some(next)) => next - after,
                _ => f64::NAN,
            }
        };
        bracketed(LEAST_ADDENDUM, teeth.wheel_addendum, |addendum| -land(addendum))
    }

    /// Finds the undercut of a flank, followed from the tip to its first cusp: the curve that cuts it, the
    /// flank itself or the fillet, and the contacts on both.
    fn undercut(track: &Track<'_>, teeth: &Teeth, flank: &Flank, middle: f64) -> Option<(Curve, [f64; 2])> {
        const COUNT: u32 = 40;
        let on_flank = Curve::Flank { sign: flank.sign, pitch: flank.pitch };
        let on_fillet = Curve::Fillet { sign: flank.sign, middle };
        // Evenly in the arc length: where the rotor is nearly straight the shape's own parameter has few
        // places.
        let step = (flank.end - flank.tip) / f64::from(COUNT);
        let mut places: Vec<f64> = (0..=COUNT).map(|i| flank.tip + step * f64::from(i)).collect();
        places.extend(track.jumps(flank.tip, flank.end));
        places.sort_by(|a, b| (flank.sign * b).total_cmp(&(flank.sign * a)));
        let frames: Vec<Frame> = places.into_iter().map(|s| track.at(s)).collect();
        let regular = |frame: &Frame| regularity(teeth, flank, frame) > 0.0;
        let edge =
            |i: usize| bracketed(frames[i - 1].s, frames[i].s, |s| regularity(teeth, flank, &track.at(s)));
        // Ever denser towards the start: loops are small where the limit is hardly exceeded.
        let from = |curve: Curve, start: f64, to: f64| -> Vec<(Curve, f64, [f64; 2])> {
            let place = |i: u32| {
                let part = f64::from(i) / f64::from(COUNT);
                start + (to - start) * part * part
            };
            (0..=COUNT).map(place).map(|s| (curve, s, point(teeth, curve, &track.at(s)))).collect()
        };
        let cusp = frames.iter().position(|frame| !regular(frame)).filter(|&cusp| cusp > 0)?;
        let mut upper = from(on_flank, edge(cusp), flank.tip);
        upper.reverse();
        // After the cusp the flank runs backwards, up to a second one if the track bends less there.
        let mut lower = match frames[cusp..].iter().position(regular) {
            Some(back) => from(on_flank, edge(cusp + back), flank.end),
            None => Vec::new(),
        };
        lower.extend(from(on_fillet, flank.end, middle + flank.sign * teeth.r * teeth.round_angle));
        for one in upper.windows(2) {
            for other in lower.windows(2).filter(|other| other[0].0 == other[1].0) {
                if cross(one[0].2, one[1].2, other[0].2, other[1].2) {
                    let curves = [on_flank, other[0].0];
                    let ranges = [[one[0].1, one[1].1], [other[0].1, other[1].1]];
                    if let Some(met) = crossing(teeth, track, curves, ranges) {
                        return Some((other[0].0, met));
                    }
                }
            }
        }
        None
    }
}

/// Crossing of two curves whose chords cross: Newton's method, from ever shorter chords if it leaves them.
fn crossing(
    teeth: &Teeth,
    track: &Track<'_>,
    curves: [Curve; 2],
    mut ranges: [[f64; 2]; 2],
) -> Option<[f64; 2]> {
    const PARTS: u32 = 8;
    for _ in 0..12 {
        let met = meeting(teeth, track, curves, ranges.map(|[a, b]| 0.5 * (a + b)));
        let near = |s: f64, [a, b]: [f64; 2]| (s - 0.5 * (a + b)).abs() <= (a - b).abs();
        if let Some(met) = met
            && near(met[0], ranges[0])
            && near(met[1], ranges[1])
        {
            return Some(met);
        }
        let chains = [0, 1].map(|i| -> Vec<(f64, [f64; 2])> {
            let [a, b] = ranges[i];
            (0..=PARTS)
                .map(|k| a + (b - a) * f64::from(k) / f64::from(PARTS))
                .map(|s| (s, point(teeth, curves[i], &track.at(s))))
                .collect()
        });
        let pairs = chains[0].windows(2).flat_map(|one| chains[1].windows(2).map(move |other| (one, other)));
        let (one, other) =
            pairs.into_iter().find(|(one, other)| cross(one[0].1, one[1].1, other[0].1, other[1].1))?;
        ranges = [[one[0].0, one[1].0], [other[0].0, other[1].0]];
    }
    None
}

/// Whether two segments cross.
fn cross(a: [f64; 2], b: [f64; 2], c: [f64; 2], d: [f64; 2]) -> bool {
    let turn = |p: [f64; 2], q: [f64; 2], x: [f64; 2]| {
        let ([ux, uy], [vx, vy]) = (apart(q, p), apart(x, p));
        ux * vy - uy * vx
    };
    turn(a, b, c) * turn(a, b, d) <= 0.0 && turn(c, d, a) * turn(c, d, b) <= 0.0
}
