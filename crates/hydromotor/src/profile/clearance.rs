//! Clearances of the teeth over a revolution.
//!
//! The clearance is the signed distance of every point of a wheel's outline from a satellite's; negative if
//! teeth overlap. The satellites are in the middle of their backlash, as rolling without slip places them.
//!
//! # Why one satellite and half a lobe are enough
//! All satellites run through the same states, one behind the other ([`crate::satellites`]). After a lobe of
//! both wheels a satellite meets the same teeth again, itself turned by whole pitches, since lobes are whole
//! numbers of pitches. The teeth are mirror images in the middle of a crest, so that the state at `−Φ` is
//! that at `Φ` mirrored. `Φ` from 0 to `π/N + π/n` therefore holds every state of every satellite in a
//! revolution.
//!
//! Rotations are sampled; at each, the nearest of the wheel's sampled points is refined along its curve, and
//! the nearest rotation by golden section at last. Where flanks mesh the distance is `½·j·cos α` at each of
//! their contacts.

use crate::quantity::Quantity;
use epicyclic_units::Physical;
use uom::si::f64::{Angle, Length};

use super::cut::{Piece, point};
use super::track::{Side, Track};
use super::{Part, Profile};
use crate::Error;
use crate::centrode::Wheel;
use crate::contact::{By, Conjugate};
use crate::ranges::finite_angle;
use crate::satellites::Point;
use epicyclic_numerics::extremes::golden;
use std::f64::consts::PI;

/// Place at which teeth come nearest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Nearest {
    /// The wheel that the satellite comes near.
    pub wheel: Wheel,
    /// The least distance of the outlines; negative if they overlap.
    pub clearance: Length,
    /// The part of the wheel's tooth.
    pub part: Part,
    /// The satellite.
    pub satellite: u32,
    /// The rotation of the rotor.
    pub rotation: Angle,
    /// The point of the wheel, in the stator's frame.
    pub at: Point,
}

/// The least distances over a revolution.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Clearances {
    /// Least distance between satellites and stator.
    pub stator: Nearest,
    /// Least distance between satellites and rotor.
    pub rotor: Nearest,
    /// Least distance between the tip circles of neighbouring satellites, and the rotation at which they have
    /// it.
    pub neighbours: (Length, Angle),
    /// Distance between the tips of the rotor's crests and the stator's troughs.
    pub wheels: Length,
}

impl Clearances {
    /// The least of all.
    #[must_use]
    pub fn least(&self) -> Length {
        let others = [self.rotor.clearance, self.neighbours.0, self.wheels];
        others
            .into_iter()
            .fold(self.stator.clearance, |least, other| if other < least { other } else { least })
    }

    /// Whether nothing overlaps.
    #[must_use]
    pub fn free(&self) -> bool {
        self.least() >= Length::default()
    }
}

/// A point of a wheel's outline in its own frame, with the way back to its curve.
struct Sample {
    at: [f64; 2],
    piece: usize,
    s: f64,
    /// Half the distance to the neighbouring samples along the curve's contacts.
    reach: f64,
}

/// The teeth of a wheel along some lobes.
struct Teeth<'a> {
    profile: &'a Profile,
    track: Track<'a>,
    pieces: Vec<Piece>,
    samples: Vec<Sample>,
}

/// A nearest point in modules.
#[derive(Clone, Copy)]
struct Found {
    distance: f64,
    part: Part,
    at: [f64; 2],
}

impl<'a> Teeth<'a> {
    /// Teeth from `before` lobes behind the crest at 0 to `after` lobes ahead.
    fn new(profile: &'a Profile, side: Side, before: i32, after: i32) -> Self {
        let track = profile.track(side);
        let lobe = track.lobe();
        let mut teeth = Self { profile, track, pieces: Vec::new(), samples: Vec::new() };
        for k in -before..=after {
            for piece in &profile.cut(side).pieces {
                let piece = piece.shifted(lobe * f64::from(k));
                let count = match piece.part {
                    Part::Flank => 24,
                    Part::Fillet => 12,
                    Part::Tip | Part::Root => 6,
                };
                let reach = ((piece.to - piece.from) / f64::from(count)).abs();
                let index = teeth.pieces.len();
                let frames = track.frames(piece.from, piece.to, count).chain([track.at(piece.to)]);
                teeth.samples.extend(frames.map(|frame| Sample {
                    at: point(&profile.teeth, piece.curve, &frame),
                    piece: index,
                    s: frame.s,
                    reach,
                }));
                teeth.pieces.push(piece);
            }
        }
        teeth
    }

    /// The point nearest to a satellite of a phase that the rotor reaches by a rotation.
    fn nearest(&self, phase: f64, rotation: f64) -> Option<Found> {
        let profile = self.profile;
        let satellite = &profile.satellite;
        let pose = Pose::of(profile, self.track.side, phase, rotation);
        let reach = satellite.tip_radius();
        let mut best: Option<(f64, &Sample)> = None;
        for sample in &self.samples {
            let local = pose.local(sample.at);
            let far = libm::hypot(local[0], local[1]) - reach;
            if best.is_none_or(|(distance, _)| far < distance) {
                let distance = satellite.distance(local);
                if best.is_none_or(|(least, _)| distance < least) {
                    best = Some((distance, sample));
                }
            }
        }
        let (distance, sample) = best?;
        let piece = &self.pieces[sample.piece];
        let (low, high) = (piece.from.min(piece.to), piece.from.max(piece.to));
        let on = |s: f64| point(&profile.teeth, piece.curve, &self.track.at(s));
        let (s, refined) = golden(
            (sample.s - 1.5 * sample.reach).max(low),
            (sample.s + 1.5 * sample.reach).min(high),
            32,
            |s| satellite.distance(pose.local(on(s))),
        );
        let (distance, at) = if refined < distance { (refined, on(s)) } else { (distance, sample.at) };
        Some(Found { distance, part: piece.part, at: turned(at, pose.wheel) })
    }
}

/// A satellite as seen from a wheel.
struct Pose {
    centre: [f64; 2],
    sin: f64,
    cos: f64,
    /// Rotation of the wheel.
    wheel: f64,
}

impl Pose {
    fn of(profile: &Profile, side: Side, phase: f64, rotation: f64) -> Self {
        let place = profile.motor.place_at(phase);
        let contact = place.contact;
        let spin = contact.theta3 - contact.mu - contact.s3 / profile.teeth.r;
        let wheel = match side {
            Side::Stator => 0.0,
            Side::Rotor => rotation,
        };
        let (sin, cos) = libm::sincos(spin - wheel);
        Self { centre: turned(place.centre, -wheel), sin, cos, wheel }
    }

    /// A point of the wheel in the satellite's frame.
    fn local(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let (x, y) = (x - self.centre[0], y - self.centre[1]);
        [x * self.cos + y * self.sin, y * self.cos - x * self.sin]
    }
}

fn turned([x, y]: [f64; 2], angle: f64) -> [f64; 2] {
    let (sin, cos) = libm::sincos(angle);
    [x * cos - y * sin, x * sin + y * cos]
}

impl Profile {
    /// The least distances over a revolution, of rotations in `steps` equal pieces of the half-lobe that
    /// holds them all.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless there are 1 to 100 000 steps.
    ///
    /// # Example
    /// ```
    /// use epicyclic_hydromotor::profile::{Profile, ToothForm};
    /// use epicyclic_hydromotor::{Motor, MotorNumbers};
    /// use uom::si::{f64::Length, length::millimeter};
    ///
    /// let mm = Length::new::<millimeter>;
    /// let motor = Motor::of_two_arcs(MotorNumbers::new(5, 3, 55, 10)?, mm(1.0), mm(40.0))?;
    /// let clearances = Profile::new(&motor, ToothForm::default())?.clearances(30)?;
    /// assert!(clearances.free());
    /// # Ok::<(), epicyclic_hydromotor::Error>(())
    /// ```
    pub fn clearances(&self, steps: u32) -> Result<Clearances, Error> {
        if !(1..=100_000).contains(&steps) {
            let (quantity, value) = (Quantity::Steps, f64::from(steps));
            return Err(Error::OutOfRange { quantity, value, low: 1.0, high: 1e5, unit: "" });
        }
        let end = self.motor.shape.trough().phase;
        let search = |side: Side| {
            let lobe = self.track(side).lobe();
            // Half a satellite's circumference either way.
            let before = (PI * self.teeth.r / lobe).ceil() as i32;
            let teeth = Teeth::new(self, side, before, before);
            let at = |phase: f64| teeth.nearest(phase, phase).map_or(f64::INFINITY, |found| found.distance);
            let phase = |i: u32| end * f64::from(i) / f64::from(steps);
            let (least, i) = (0..=steps)
                .map(|i| (at(phase(i)), i))
                .fold((f64::INFINITY, 0), |a, b| if b.0 < a.0 { b } else { a });
            let (refined, distance) = golden(phase(i.saturating_sub(1)), phase((i + 1).min(steps)), 24, at);
            let phase = if distance < least { refined } else { phase(i) };
            self.found(side, teeth.nearest(phase, phase), 0, phase)
        };
        let (distance, rotation) = self.motor.least_neighbour_distance();
        let gap = self.motor.shape.trough().rho3 - self.motor.shape.at(By::Phase, 0.0).rho1;
        Ok(Clearances {
            stator: search(Side::Stator),
            rotor: search(Side::Rotor),
            neighbours: (distance - self.motor.length(2.0 * self.teeth.tip), rotation),
            wheels: self.motor.length(gap - 2.0 * self.teeth.wheel_addendum),
        })
    }

    /// Least distances of each satellite from stator and rotor after a rotation of the rotor, by trial along
    /// whole wheels.
    ///
    /// # Errors
    /// [`Error::NotFinite`].
    pub fn clearances_at(&self, rotation: Angle) -> Result<Vec<[Nearest; 2]>, Error> {
        let rotation = finite_angle(Quantity::Rotation, rotation)?;
        let numbers = self.motor.numbers();
        let whole = |side, lobes: u32| Teeth::new(self, side, 0, lobes as i32 - 1);
        let wheels = [whole(Side::Stator, numbers.stator_lobes()), whole(Side::Rotor, numbers.rotor_lobes())];
        let satellite = |index: u32| {
            let phase = self.motor.phase(rotation, index);
            [0, 1].map(|i| self.found(Side::BOTH[i], wheels[i].nearest(phase, rotation), index, rotation))
        };
        Ok((0..numbers.satellites()).map(satellite).collect())
    }

    fn found(&self, side: Side, found: Option<Found>, satellite: u32, rotation: f64) -> Nearest {
        // There is always one: a wheel has teeth.
        let Found { distance, part, at: [x, y] } =
            found.unwrap_or(Found { distance: f64::INFINITY, part: Part::Tip, at: [0.0; 2] });
        let length = |modules| self.motor.length(modules);
        Nearest {
            wheel: side.wheel(),
            clearance: length(distance),
            part,
            satellite,
            rotation: Angle::from_si(rotation),
            at: Point { x: length(x), y: length(y) },
        }
    }
}
