//! Tooth profiles: the satellite's involute, and stator and rotor as its envelope.
//!
//! # Contents
//!
//! | module | answers |
//! |---|---|
//! | [`form`] | the tooth form: pressure angle, heights, shift, backlash, fillet |
//! | `track` | a centrode as the track that the satellite rolls along |
//! | `cut` | the teeth of stator and rotor in closed form |
//! | `satellite` | the satellite's teeth, and how far a point is from them |
//! | [`limits`] | undercut, pointed tips, reach of the flanks: the failing limit, its place, the bound |
//! | `kept` | whether a motor keeps all limits in a form, for searches |
//! | `paths` | the path of contact of every flank |
//! | `tooth` | single teeth in their own frame: sections, points of load |
//! | [`clearance`] | how near the teeth come over a revolution |
//!
//! # In phase
//! A satellite's contact runs round it by `s₃/r` towards the stator and by `π + s₁/r` towards the rotor, with
//! a pitch of `p = π·m`. A satellite tooth at the stator's crest therefore meets a stator space there. On the
//! rotor's crest, `Z_s/2` pitches away, it meets a space for an even and a tooth for an odd `Z_s`; mirrored
//! in the crest either way. A lobe of either wheel is `Z₃/N = Z₁/n` whole pitches, so both wheels look the
//! same after a lobe. Every satellite finds the teeth as the previous one did: all `N + n` mesh at once, for
//! every admissible set. A fraction of a pitch in `Z₃/N` would remain between neighbours;
//! [`crate::MotorNumbers`] refuses it.
//!
//! # Why these defaults
//! A satellite of 10 teeth is the smaller wheel of every mesh, and decides. In the standard form of 20° and
//! full depth its rack undercuts it: `h_f − ρ·(1 − sin α) = 1.151` modules where `r·sin² α = 0.585` are
//! allowed. The wheels' tips also reach below its base circle.
//!
//! The default is chosen from a grid of forms:
//! - pressure angles from 20° to 30° in steps of 1°;
//! - in steps of 0.05 `h_a*` from 0.7 to 1, `c*` from 0.15 to 0.25, `x` from 0 to 0.4 and `ρ*` from 0.1 to
//!   0.25.
//!
//! Of these forms 453 keep every limit for 5×3 and 6×4 at `l = 40` modules, 5×3 at 30 and both in the middle
//! of their families. The lower the teeth, the wider the margins, but the shorter the path of contact, down
//! to one base pitch. The default is a compromise: a path of 1.12 base pitches, tips of half a module, and a
//! margin of 0.12 modules to undercut and roots. Towards the ends of a family the centrodes bend more sharply
//! and the default is undercut, at first by the cutter's clearance alone. A satellite of 9 teeth needs
//! `ρ* ≤ 0.0698`, a smaller one lower teeth.
//!
//! # Known wrong
//! An undercut wheel, which [`limits`] reports, may keep up to 1e-4 modules of the part that the cutter
//! removes. This occurs if a loop of its flank and the fillet cut the flank almost in one place.
//!
//! # Left out
//! Loads, which are in [`crate::flanks`]; modifications of the flank; the thickness across the face.

pub mod clearance;
mod cut;
pub mod form;
pub(crate) mod kept;
pub mod limits;
mod paths;
mod satellite;
mod tooth;
mod track;

#[cfg(test)]
mod tests;

pub use form::{Crest, ToothForm};

use crate::Error;
use crate::centrode::Wheel;
use crate::contact::Conjugate;
use crate::motor::Motor;
use crate::quantity::Quantity;
use crate::satellites::Point;
use cut::Cut;

pub(crate) use form::Teeth;
pub(crate) use paths::FlankPath;
use satellite::SatelliteTooth;
use std::f64::consts::PI;
#[cfg(test)]
pub(crate) use tooth::{Loading, Tooth};
pub(crate) use track::Side;
use track::Track;

/// The most points of an outline.
pub const MOST_POINTS: u32 = 10_000_000;

/// A part of a tooth's outline.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "names", derive(serde::Serialize, schemars::JsonSchema))]
#[cfg_attr(feature = "names", serde(rename_all = "snake_case"), schemars(rename = "ToothPart"))]
pub enum Part {
    /// The land at the tip.
    Tip,
    /// The part that meshes.
    Flank,
    /// The curve from the flank to the root.
    Fillet,
    /// The bottom of a space.
    Root,
}

/// Beginning of a part in an outline.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Segment {
    /// Part of the tooth.
    pub part: Part,
    /// Index of its first point; it goes on to the first point of the next segment.
    pub start: usize,
}

/// A closed outline, counter-clockwise; the last point is joined to the first.
#[derive(Debug, Clone, PartialEq)]
pub struct Outline {
    /// Points of the outline.
    pub points: Vec<Point>,
    /// Parts of the outline in order, the first from point 0.
    pub segments: Vec<Segment>,
}

/// The teeth of a motor.
#[derive(Debug, Clone, PartialEq)]
pub struct Profile {
    motor: Motor,
    form: ToothForm,
    teeth: Teeth,
    pub(crate) satellite: SatelliteTooth,
    /// Teeth of stator and rotor.
    cuts: [Cut; 2],
}

impl Profile {
    /// Generates the teeth of a motor in a form.
    ///
    /// Undercut and other limits that leave an outline are no errors; they are in [`Profile::limits`].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] and [`Error::NotFinite`] for a number of the form; [`Error::PointedTip`] and
    /// [`Error::FilletTooLarge`] for one that leaves no tooth; [`Error::NoTip`] and [`Error::NoFlank`] if
    /// flanks end before they are of use.
    ///
    /// # Example
    /// ```
    /// use epicyclic_hydromotor::centrode::Wheel;
    /// use epicyclic_hydromotor::profile::{Profile, ToothForm};
    /// use epicyclic_hydromotor::{Motor, MotorNumbers};
    /// use uom::si::{f64::Length, length::millimeter};
    ///
    /// let mm = Length::new::<millimeter>;
    /// let motor = Motor::of_two_arcs(MotorNumbers::new(5, 3, 55, 10)?, mm(2.0), mm(80.0))?;
    /// let profile = Profile::new(&motor, ToothForm::default())?;
    /// assert!(profile.limits().iter().all(|limit| limit.holds()));
    /// let rotor = profile.outline(Wheel::Rotor, 3300)?;
    /// assert_eq!(rotor.points.len(), 3300);
    /// # Ok::<(), epicyclic_hydromotor::Error>(())
    /// ```
    pub fn new(motor: &Motor, form: ToothForm) -> Result<Self, Error> {
        let numbers = motor.numbers();
        let teeth = Teeth::new(form, numbers.satellite_teeth())?;
        let least = motor.shape.trough().rho1;
        if teeth.cutter_addendum >= least {
            return Err(Error::OutOfRange {
                quantity: Quantity::RotorDedendum,
                value: teeth.cutter_addendum,
                low: 0.0,
                high: least,
                unit: "modules",
            });
        }
        let offsets = phases(form.crest, numbers.satellite_teeth());
        let cut = |side, offset| Cut::new(&motor.shape, side, &teeth, numbers.teeth_per_lobe(), offset);
        let cuts = [cut(Side::Stator, offsets[0])?, cut(Side::Rotor, offsets[1])?];
        let satellite = SatelliteTooth::new(&teeth, numbers.satellite_teeth(), offsets[0] / teeth.r)?;
        Ok(Self { motor: motor.clone(), form, teeth, satellite, cuts })
    }

    /// The form.
    #[must_use]
    pub fn form(&self) -> ToothForm {
        self.form
    }

    /// The motor.
    #[must_use]
    pub fn motor(&self) -> &Motor {
        &self.motor
    }

    /// Tip and root circle of a satellite: their radii.
    #[must_use]
    pub fn satellite_radii(&self) -> [uom::si::f64::Length; 2] {
        [self.teeth.tip, self.teeth.root].map(|radius| self.motor.length(radius))
    }

    /// Outline of a wheel in its own frame, with at least this number of points: equally many of each tooth,
    /// at least 6, and a few more where an undercut flank has a loop removed.
    ///
    /// The frames are those of [`crate::centrode`]. In place, a satellite's is turned by its
    /// [`rotation`](crate::satellites::Satellite::rotation) and moved to its centre, the rotor's is turned by
    /// the rotation of the rotor.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless there are 1 to [`MOST_POINTS`] points.
    pub fn outline(&self, wheel: Wheel, points: u32) -> Result<Outline, Error> {
        if !(1..=MOST_POINTS).contains(&points) {
            let (value, high) = (f64::from(points), f64::from(MOST_POINTS));
            return Err(Error::OutOfRange { quantity: Quantity::Points, value, low: 1.0, high, unit: "" });
        }
        let numbers = self.motor.numbers();
        let (z, lobes) = match wheel {
            Wheel::Stator => (numbers.stator_teeth(), numbers.stator_lobes()),
            Wheel::Rotor => (numbers.rotor_teeth(), numbers.rotor_lobes()),
            Wheel::Satellite => (numbers.satellite_teeth(), 1),
        };
        let share = Share::of(points.div_ceil(z).max(6));
        let total = share.tooth() as usize * z as usize;
        let mut outline =
            Outline { points: Vec::with_capacity(total), segments: Vec::with_capacity(6 * z as usize) };
        let module = self.motor.module();
        let point = |[x, y]: [f64; 2]| Point { x: module * x, y: module * y };
        let side = match wheel {
            Wheel::Satellite => {
                self.satellite.outline(
                    |part| share.count(part),
                    |part, xy, first| {
                        if first {
                            outline.segments.push(Segment { part, start: outline.points.len() });
                        }
                        outline.points.push(point(xy));
                    },
                );
                return Ok(outline);
            }
            Wheel::Stator => Side::Stator,
            Wheel::Rotor => Side::Rotor,
        };
        let lobe = self.lobe(side, share, &mut outline.segments);
        let (parts, count) = (outline.segments.len(), lobe.len());
        for k in 0..lobes {
            // The rotor's track is clockwise, but its mirror image in the crest is itself.
            let (sin, cos) = libm::sincos(std::f64::consts::TAU * f64::from(k) / f64::from(lobes));
            let mirror = if side == Side::Stator { 1.0 } else { -1.0 };
            outline.points.extend(lobe.iter().map(|&[x, y]| {
                let y = mirror * y;
                point([x * cos - y * sin, x * sin + y * cos])
            }));
            if k > 0 {
                for i in 0..parts {
                    let Segment { part, start } = outline.segments[i];
                    outline.segments.push(Segment { part, start: start + count * k as usize });
                }
            }
        }
        Ok(outline)
    }

    /// The points of a lobe along its track, and where its parts begin.
    fn lobe(&self, side: Side, share: Share, segments: &mut Vec<Segment>) -> Vec<[f64; 2]> {
        let track = self.track(side);
        let cut = self.cut(side);
        let mut points = Vec::with_capacity(cut.flanks.len() * share.tooth() as usize);
        for piece in &cut.pieces {
            segments.push(Segment { part: piece.part, start: points.len() });
            let frames = track.frames(piece.from, piece.to, share.count(piece.part));
            points.extend(frames.map(|frame| cut::point(&self.teeth, piece.curve, &frame)));
        }
        points
    }

    fn track(&self, side: Side) -> Track<'_> {
        Track { shape: &self.motor.shape, side }
    }

    fn cut(&self, side: Side) -> &Cut {
        match side {
            Side::Stator => &self.cuts[0],
            Side::Rotor => &self.cuts[1],
        }
    }
}

/// Arc lengths from a crest to the middle of a space, of stator and rotor; the stator's is also that from the
/// satellite's contact there to the middle of its tooth.
fn phases(crest: Crest, satellite_teeth: u32) -> [f64; 2] {
    let stator = match crest {
        Crest::Space => 0.0,
        Crest::Tooth => 0.5 * PI,
    };
    // Half a satellite is a whole number of pitches, or half a pitch more.
    let rotor = stator + if satellite_teeth.is_multiple_of(2) { 0.0 } else { 0.5 * PI };
    [stator, rotor % PI]
}

/// Numbers of a tooth's points on its parts.
#[derive(Debug, Clone, Copy)]
struct Share {
    flank: u32,
    fillet: u32,
    tip: u32,
    root: u32,
}

impl Share {
    /// Distribution of at least 6 points.
    fn of(points: u32) -> Self {
        let (flank, fillet) = ((points / 4).max(1), (points * 3 / 16).max(1));
        let rest = points - 2 * (flank + fillet);
        Self { flank, fillet, tip: rest / 2, root: rest - rest / 2 }
    }

    fn count(self, part: Part) -> u32 {
        match part {
            Part::Tip => self.tip,
            Part::Flank => self.flank,
            Part::Fillet => self.fillet,
            Part::Root => self.root,
        }
    }

    fn tooth(self) -> u32 {
        2 * (self.flank + self.fillet) + self.tip + self.root
    }
}
