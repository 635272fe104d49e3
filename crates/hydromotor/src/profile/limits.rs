//! Limits of the teeth: the conditions on a tooth form at every place of the centrodes.
//!
//! Paths run along the line of action from the pitch point; `κ` is the centrode's curvature towards the
//! satellite.
//!
//! Limits of stator and rotor, unless another wheel is named:
//! - *Undercut*: the path of contact with the cutter where the flank begins is at most `sin α/|κ|`, where the
//!   flank would have a cusp. For the satellite the same path with its rack is at most `r·sin α`, the base
//!   circle.
//! - *Cusp at the tip*: where the centrode is hollow, the path of contact at the tip is at most `sin α/κ`.
//! - *Foreign root*: the path of contact at the wheel's tip, or its reach into the fillet, is at most that at
//!   which the satellite's involute begins.
//! - *Own root*: the path of contact at the satellite's tip is at most that at which the wheel's flank
//!   begins.
//! - *Tip*, of all wheels: the thickness of the thinnest tip is at least 0.2 modules.
//! - *Contact*: the shortest path of contact is at least a base pitch, `p·cos α`.
//! - *Root curve*: the cutter's addendum is at most the radius of the centrode's sharpest bulge towards the
//!   satellite.
//! - *Tip curve*: the wheel's addendum is at most the radius of its sharpest hollow.
//! - *Neighbours*, of the satellite: the least distance of satellites' centres is at least the tip circle's
//!   diameter.
//! - *Wheels*, of the rotor: the stator's least radius less the rotor's greatest is at least both addenda.
//!
//! A wheel's tip that keeps the *foreign root* may still run into the satellite's fillet. Its corner goes on
//! from the involute's beginning on a path of its own; if that is bent less than the fillet, it leaves less
//! than the `½·j·cos α` between flanks. The value of *foreign root* is then the bound plus the missing part
//! of that distance.
//!
//! If a flank ends in a cusp below the tip, the value of *cusp at the tip* is the cusp's path plus the
//! missing height to the tip.
//!
//! Values and bounds are lengths. For each kind and wheel the place is returned where value and bound are
//! nearest or the bound is most exceeded.

use uom::si::f64::Length;

use super::cut::{Flank, Piece};
use super::form::Teeth;
use super::satellite::SatelliteTooth;
use super::track::{Frame, Side, Track};
use super::{Part, Profile};
use crate::centrode::Wheel;
use crate::contact::{By, Conjugate};
use crate::modules::modules;
use epicyclic_numerics::extremes::golden;
use std::f64::consts::PI;

/// Kind of a limit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, strum::IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
#[cfg_attr(feature = "names", derive(serde::Serialize, schemars::JsonSchema))]
#[cfg_attr(feature = "names", serde(rename_all = "snake_case"), schemars(rename = "LimitKind"))]
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

impl LimitKind {
    /// Name of the limit in words.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::Undercut => "undercut: path to its start",
            Self::TipCusp => "cusp at the tip: path to it",
            Self::SatelliteRoot => "reach into the satellite: path",
            Self::WheelRoot => "reach of the satellite: path",
            Self::TipThickness => "thickness of the thinnest tip",
            Self::ContactPath => "shortest path of contact",
            Self::RootCurve => "root curve without cusps",
            Self::TipCurve => "tip curve without cusps",
            Self::Neighbours => "satellites' centres, distance",
            Self::Wheels => "stator above the rotor",
        }
    }

    /// Name of the limit, which is also that of its warning.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.into()
    }
}

/// Side of its bound on which a value is allowed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "names", derive(serde::Serialize, schemars::JsonSchema))]
#[cfg_attr(feature = "names", serde(rename_all = "snake_case"), schemars(rename = "Side"))]
pub enum Bound {
    /// The value is not below the bound.
    AtLeast,
    /// The value is not above the bound.
    AtMost,
}

impl Bound {
    /// Side in words.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::AtLeast => "at least",
            Self::AtMost => "at most",
        }
    }
}

/// A limit of a wheel's teeth where it is nearest to failing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limit {
    /// Kind of the limit.
    pub kind: LimitKind,
    /// Whose teeth.
    pub wheel: Wheel,
    /// Value that is limited.
    pub value: Length,
    /// Side of the bound.
    pub sense: Bound,
    /// The bound.
    pub bound: Length,
    /// Arc length on the centrode from the middle of a crest; `None` for a satellite.
    pub at: Option<Length>,
}

impl Limit {
    /// Distance of the value from the bound on the allowed side; negative if the limit fails.
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

/// Number of places of a flank that are evaluated, besides its ends.
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
    /// Every limit that applies; a centrode that is nowhere hollow has no limit of its hollow.
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
        let (track, cut) = (self.track(side), self.cut(side));
        let mesh = Mesh { teeth: &self.teeth, satellite: &self.satellite };
        let mut worsts = Worsts::default();
        for flank in cut.flanks.iter().flatten() {
            worsts.flank(mesh, &track, flank);
            worsts.fillet(mesh, &track, flank);
        }
        for piece in cut.pieces.iter().filter(|piece| piece.part == Part::Tip) {
            worsts.tip(mesh, &track, piece);
        }
        for ((kind, sense), worst) in KINDS.into_iter().zip(worsts.0) {
            if let Some(Worst { value, bound, at }) = worst {
                limits.push(self.limit(kind, side.wheel(), value, sense, bound, Some(at)));
            }
        }
    }
}

/// Limits of a wheel, in the order in which they are listed.
const KINDS: [(LimitKind, Bound); 8] = [
    (LimitKind::Undercut, Bound::AtMost),
    (LimitKind::TipCusp, Bound::AtMost),
    (LimitKind::SatelliteRoot, Bound::AtMost),
    (LimitKind::WheelRoot, Bound::AtMost),
    (LimitKind::TipThickness, Bound::AtLeast),
    (LimitKind::ContactPath, Bound::AtLeast),
    (LimitKind::RootCurve, Bound::AtMost),
    (LimitKind::TipCurve, Bound::AtMost),
];

/// The teeth that a wheel's limits depend on.
#[derive(Clone, Copy)]
pub(super) struct Mesh<'a> {
    pub(super) teeth: &'a Teeth,
    pub(super) satellite: &'a SatelliteTooth,
}

impl Mesh<'_> {
    /// Path at which the satellite's involute begins.
    pub(super) fn satellite_path(self) -> f64 {
        self.teeth.base * (self.teeth.tan - self.satellite.from)
    }

    /// Path at the satellite's tip.
    pub(super) fn satellite_tip(self) -> f64 {
        -self.teeth.tip_roll() * self.teeth.cos
    }
}

/// The worst of each of [`KINDS`] among the flanks and tips evaluated.
#[derive(Default)]
pub(super) struct Worsts([Option<Worst>; KINDS.len()]);

impl Worsts {
    fn keep(&mut self, kind: LimitKind, value: f64, bound: f64, at: f64) {
        for ((own, sense), worst) in KINDS.into_iter().zip(&mut self.0) {
            if own == kind {
                Worst::keep(worst, sense, value, bound, at);
            }
        }
    }

    /// The first that fails.
    pub(super) fn failing(&self) -> Option<LimitKind> {
        let fails = |((kind, sense), worst): ((LimitKind, Bound), &Option<Worst>)| {
            let Worst { value, bound, .. } = worst.as_ref()?;
            let holds = match sense {
                Bound::AtLeast => value >= bound,
                Bound::AtMost => value <= bound,
            };
            (!holds).then_some(kind)
        };
        KINDS.into_iter().zip(&self.0).find_map(fails)
    }

    /// Shortest path of contact of the flanks evaluated.
    pub(super) fn contact_path(&self) -> Option<f64> {
        let of = KINDS.iter().position(|(kind, _)| *kind == LimitKind::ContactPath)?;
        self.0[of].as_ref().map(|worst| worst.value)
    }

    /// Adds the limits of a flank, without that of the satellite's fillet.
    pub(super) fn flank(&mut self, mesh: Mesh<'_>, track: &Track<'_>, flank: &Flank) {
        let teeth = mesh.teeth;
        let at = flank.pitch;
        for frame in flank_frames(track, flank, flank.pitch + flank.sign * teeth.cutter_roll) {
            let path = flank.roll(frame.s) * teeth.cos;
            let bound = teeth.sin / frame.curvature.abs();
            if path < 0.0 && frame.curvature < 0.0 {
                self.keep(LimitKind::Undercut, -path, bound, at);
            } else if path > 0.0 && frame.curvature > 0.0 {
                self.keep(LimitKind::TipCusp, path, bound, at);
            }
            let radius = 1.0 / frame.curvature.abs();
            if frame.curvature < 0.0 {
                self.keep(LimitKind::RootCurve, teeth.cutter_addendum, radius, frame.s);
            } else if frame.curvature > 0.0 {
                self.keep(LimitKind::TipCurve, teeth.wheel_addendum, radius, frame.s);
            }
        }
        let wheel_tip = flank.roll(flank.tip) * teeth.cos;
        if flank.missing > 0.0 {
            self.keep(LimitKind::TipCusp, wheel_tip + flank.missing, wheel_tip, at);
        }
        let (satellite_path, satellite_tip) = (mesh.satellite_path(), mesh.satellite_tip());
        self.keep(LimitKind::SatelliteRoot, wheel_tip, satellite_path, at);
        let begins = -flank.roll(flank.end) * teeth.cos;
        self.keep(LimitKind::WheelRoot, satellite_tip, begins, at);
        let path = wheel_tip.min(satellite_path) + satellite_tip.min(begins);
        self.keep(LimitKind::ContactPath, path, PI * teeth.cos, at);
    }

    /// Adds the limit of the corner of the wheel's tip, beyond a flank, against the satellite's fillet.
    pub(super) fn fillet(&mut self, mesh: Mesh<'_>, track: &Track<'_>, flank: &Flank) {
        // The flanks on the other side of the spaces are mirror images.
        let intrusion = if flank.sign > 0.0 { intrusion(mesh, track, flank) } else { 0.0 };
        if intrusion > 0.0 {
            let (wheel_tip, path) = (flank.roll(flank.tip) * mesh.teeth.cos, mesh.satellite_path());
            self.keep(LimitKind::SatelliteRoot, wheel_tip.max(path + intrusion), path, flank.pitch);
        }
    }

    /// Adds the limit of the land at a tip.
    pub(super) fn tip(&mut self, mesh: Mesh<'_>, track: &Track<'_>, piece: &Piece) {
        let frames: Vec<Frame> = track.frames(piece.from, piece.to, 8).chain([track.at(piece.to)]).collect();
        let point = |frame: &Frame| frame.point(0.0, mesh.teeth.wheel_addendum);
        let thickness: f64 = frames
            .windows(2)
            .map(|ends| {
                let ([ax, ay], [bx, by]) = (point(&ends[0]), point(&ends[1]));
                libm::hypot(ax - bx, ay - by)
            })
            .sum();
        self.keep(LimitKind::TipThickness, thickness, LEAST_TIP, 0.5 * (piece.from + piece.to));
    }
}

/// Amount by which the corner of a wheel's tip comes nearer to the satellite's fillet than the flanks do, as
/// contact goes on from the tip to the corner's foot; 0 if it does not.
fn intrusion(Mesh { teeth, satellite }: Mesh<'_>, track: &Track<'_>, flank: &Flank) -> f64 {
    let corner = track.at(flank.foot).point(0.0, teeth.wheel_addendum);
    let middle = flank.pitch - flank.sign * teeth.half_space;
    let distance = |s: f64| {
        let Frame { at: [x, y], along: [tx, ty], .. } = track.at(s);
        let (x, y) = (corner[0] - x, corner[1] - y);
        let (along, towards) = (x * tx + y * ty, x * ty - y * tx);
        // About the middle of the satellite's tooth that comes into this space.
        let (out, turned) = (teeth.r + towards, (s - middle) / teeth.r);
        let (radius, angle) = (libm::hypot(out, along), flank.sign * (libm::atan2(along, out) + turned));
        match satellite.fillet_distance([radius * libm::cos(angle), radius * libm::sin(angle)]) {
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

/// Places of a flank from its tip to the cutter's end, both included, and on either side of the arcs'
/// junction.
fn flank_frames<'a>(track: &'a Track<'_>, flank: &Flank, end: f64) -> impl Iterator<Item = Frame> + 'a {
    let ends = track.jumps(flank.tip, end).into_iter().chain([end]).map(|s| track.at(s));
    track.frames(flank.tip, end, PLACES).chain(ends)
}
