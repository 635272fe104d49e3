//! Ports as made: holes and kidneys of given size in the cover, at rest with the stator.
//!
//! # Contents
//!
//! | module | answers |
//! |---|---|
//! | `outline` | the closed loop of a port |
//! | `overlap` | the area that a port and a chamber share, exactly |
//! | `depth` | whether a port is open or closed throughout a stretch of rotation |
//! | `land` | the least distance of two ports, exactly |
//! | [`timing`] | when each chamber opens and closes, closed angles, short circuits |
//! | [`trapped`] | pressure of a closed chamber, charge of the volume that is never emptied |
//! | [`throttling`] | the pressure drop over the openings |
//!
//! # Frame and signs
//! That of [`crate::motor`]. One high and one low port belong to every crest; their angles are polar angles
//! from the crest, counter-clockwise. For a rotor that runs counter-clockwise the high ports lie behind the
//! crests, at negative angles, and the low ones before. A chamber is known by its *phase*: the rotation of
//! the rotor since it was greatest, with a stator crest in its middle. It is least half a cycle later; a
//! cycle is `2π/N + 2π/n`, and all chambers go through the same. Between `−π/N − π/n` and 0 it grows.
//!
//! Chambers are bounded by the centrodes and the pitch circles of the satellites, as in [`crate::chambers`]:
//! the gaps between the teeth are left out.

mod depth;
mod land;
mod outline;
mod overlap;
pub mod throttling;
pub mod timing;
pub mod trapped;

use epicyclic_numerics::values::largest_absolute;
use epicyclic_units::Physical;
use uom::si::f64::{Angle, Area, Length};

use crate::Error;
use crate::contact::{By, Conjugate};
use crate::modules::{area, length};
use crate::motor::Motor;
use crate::quantity::{PortSide, Quantity, WheelKind};
use crate::ranges::finite_angle;
use crate::satellites::Point;
use outline::{Piece, Port};
use overlap::Region;
use std::f64::consts::TAU;

/// The shape of a port and its place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PortShape {
    /// A round hole.
    Hole {
        /// Diameter of the hole.
        diameter: Length,
        /// Distance of its centre from the axis.
        pitch_radius: Length,
        /// Polar angle of its centre from the crest.
        angle: Angle,
    },
    /// A part of a ring about the axis.
    Kidney {
        /// Inner radius.
        inner_radius: Length,
        /// Outer radius.
        outer_radius: Length,
        /// Polar angle of its middle from the crest.
        angle: Angle,
        /// Angle from end to end.
        span: Angle,
        /// Radius of its four corners; 0 of sharp ones, half the height of round ends.
        corner: Length,
    },
}

impl PortShape {
    /// Returns the shape mirrored in the crest.
    #[must_use]
    pub fn mirrored(self) -> Self {
        match self {
            Self::Hole { diameter, pitch_radius, angle } => {
                Self::Hole { diameter, pitch_radius, angle: -angle }
            }
            Self::Kidney { inner_radius, outer_radius, angle, span, corner } => {
                Self::Kidney { inner_radius, outer_radius, angle: -angle, span, corner }
            }
        }
    }
}

/// A motor with its ports.
#[derive(Debug, Clone, PartialEq)]
pub struct PortPlate {
    motor: Motor,
    shapes: [PortShape; 2],
    ports: [Port; 2],
}

/// A port that is open to a chamber.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Opening {
    /// Pressure of the port.
    pub side: PortSide,
    /// The crest that it belongs to, from 0, counter-clockwise.
    pub crest: u32,
    /// The chamber.
    pub chamber: u32,
    /// The area that both share.
    pub area: Area,
}

/// The outline of a port as a closed loop, counter-clockwise.
#[derive(Debug, Clone, PartialEq)]
pub struct PortOutline {
    /// Pressure of the port.
    pub side: PortSide,
    /// The crest that it belongs to.
    pub crest: u32,
    /// Corners of the outline, each with the way to the next; the last leads to the first.
    pub vertices: Vec<OutlineVertex>,
}

/// A corner of an outline.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OutlineVertex {
    /// Position of the corner.
    pub at: Point,
    /// The way to the next: 0 a straight line, else an arc, `tan(sweep/4)`, positive counter-clockwise.
    pub bulge: f64,
}

/// The part of the greatest diameter that a satellite covers with which ports of a motor are tried that has
/// none: a land remains.
pub const IDEAL_PART: f64 = 0.95;

/// The steepest contact that ports admit, `|μ|`.
const STEEPEST: f64 = 0.125 * TAU;

/// The cosine of the steepest contact, `μ` from the radius, is above this: [`rays_part_chambers`] admits none
/// beyond 45° and looks at 64 phases.
const LEAST_COSINE: f64 = 0.65;

/// Pressures of the ports, high first.
const SIDES: [PortSide; 2] = [PortSide::High, PortSide::Low];

impl PortPlate {
    /// Ports of a motor: one of each shape at every crest.
    ///
    /// # Errors
    /// [`Error::NotPositive`], [`Error::NotFinite`] and [`Error::OutOfRange`] for the sizes of a shape;
    /// [`Error::PortOutside`]; [`Error::PortsOverlap`]; [`Error::SteepCentrode`],
    /// [`Error::SatelliteAcrossRay`], [`Error::SatelliteInWheel`].
    ///
    /// # Example
    /// ```
    /// use epicyclic_hydromotor::ports::{PortPlate, PortShape};
    /// use epicyclic_hydromotor::{Motor, MotorNumbers};
    /// use uom::si::{angle::degree, f64::{Angle, Length}, length::millimeter};
    ///
    /// let mm = Length::new::<millimeter>;
    /// let motor = Motor::of_two_arcs(MotorNumbers::new(6, 4, 66, 10)?, mm(0.75), mm(30.0))?;
    /// let angle = Angle::new::<degree>(-15.1);
    /// let hole = PortShape::Hole { diameter: mm(4.5), pitch_radius: mm(19.66), angle };
    /// let plate = PortPlate::new(&motor, hole, hole.mirrored())?;
    /// let timing = plate.timing()?;
    /// assert!(timing.short_circuits.is_empty());
    /// // Closed about the greatest and about the least.
    /// assert_eq!(timing.closed.len(), 2);
    /// # Ok::<(), epicyclic_hydromotor::Error>(())
    /// ```
    pub fn new(motor: &Motor, high: PortShape, low: PortShape) -> Result<Self, Error> {
        let module = motor.module();
        let lobes = motor.numbers().stator_lobes();
        let ports = [Port::new(high, module, lobes)?, Port::new(low, module, lobes)?];
        rays_part_chambers(motor)?;
        let (crest, trough) = (motor.shape.within(By::Phase, 0.0), motor.shape.trough());
        for (side, port) in SIDES.into_iter().zip(&ports) {
            let [from, to] = port.radii();
            if from >= crest.rho3 || to <= trough.rho1 {
                let [from_mm, to_mm, low_mm, high_mm] =
                    [from, to, trough.rho1, crest.rho3].map(|value| length(value, module).mm());
                return Err(Error::PortOutside { side, from_mm, to_mm, low_mm, high_mm });
            }
        }
        let plate = Self { motor: motor.clone(), shapes: [high, low], ports };
        if plate.least_land() <= 0.0 {
            return Err(Error::PortsOverlap);
        }
        Ok(plate)
    }

    /// The ideal ports of a motor as round holes of a part of the greatest diameter that a satellite covers.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless the part is between 0 and 1; errors of [`PortPlate::new`], above all if
    /// no such hole exists.
    pub fn of_ideal_holes(motor: &Motor, part: f64) -> Result<Self, Error> {
        let part = crate::ranges::ranging(Quantity::HoleDiameter, part, [0.0, 1.0], "of the greatest")?;
        let ideal = motor.ports();
        let shape = |port: &crate::forces::Port| PortShape::Hole {
            diameter: part * port.greatest_diameter,
            pitch_radius: port.centre_radius,
            angle: port.angle,
        };
        Self::new(motor, shape(&ideal.high[0]), shape(&ideal.low[0]))
    }

    /// The motor.
    #[must_use]
    pub fn motor(&self) -> &Motor {
        &self.motor
    }

    /// The shape of the ports of a pressure.
    #[must_use]
    pub fn shape(&self, side: PortSide) -> PortShape {
        self.shapes[of(side)]
    }

    /// The area of a port.
    #[must_use]
    pub fn port_area(&self, side: PortSide) -> Area {
        area(self.ports[of(side)].area(), self.motor.module())
    }

    /// Openings after a rotation: every port with every chamber with which it shares an area.
    ///
    /// # Errors
    /// [`Error::NotFinite`].
    pub fn openings(&self, rotation: Angle) -> Result<Vec<Opening>, Error> {
        let rotation = finite_angle(Quantity::Rotation, rotation)?;
        let mut found = vec![];
        for chamber in 0..self.motor.numbers().satellites() {
            let region = Region::new(&self.motor, rotation, chamber);
            for side in SIDES {
                for crest in 0..self.motor.numbers().stator_lobes() {
                    let shared = region.shared(&self.port(side, crest));
                    if shared > crate::tolerance::OPEN * self.ports[of(side)].area() {
                        found.push(Opening { side, crest, chamber, area: area(shared, self.motor.module()) });
                    }
                }
            }
        }
        Ok(found)
    }

    /// The outlines of all ports, for a drawing: closed loops of arcs and straight sides.
    #[must_use]
    pub fn outlines(&self) -> Vec<PortOutline> {
        let crests = 0..self.motor.numbers().stator_lobes();
        let outline = |side: PortSide, crest: u32| {
            let vertex = |piece: &Piece| {
                let [x, y] = piece.at(0.0);
                let bulge = match *piece {
                    Piece::Line(..) => 0.0,
                    Piece::Arc(_, _, _, sweep) => libm::tan(0.25 * sweep),
                };
                OutlineVertex { at: Point { x: self.motor.length(x), y: self.motor.length(y) }, bulge }
            };
            // A side of no length, of round ends, has no vertex.
            let pieces = self.port(side, crest).pieces();
            let sides = pieces.iter().filter(|piece| {
                let ([x0, y0], [x1, y1]) = (piece.at(0.0), piece.at(1.0));
                libm::hypot(x1 - x0, y1 - y0) > crate::tolerance::MET
            });
            PortOutline { side, crest, vertices: sides.map(vertex).collect() }
        };
        crests.flat_map(|crest| SIDES.map(|side| outline(side, crest))).collect()
    }

    /// The least distance of a high-pressure from a low-pressure port: the land that parts the pressures.
    #[must_use]
    pub fn land(&self) -> Length {
        self.motor.length(self.least_land())
    }

    /// Least distance of a high-pressure from a low-pressure port, in units of the module; 0 if ports
    /// overlap.
    fn least_land(&self) -> f64 {
        let [high, low] = self.ports;
        let lobes = self.motor.numbers().stator_lobes();
        let turned = |crest: u32| low.turned(TAU * f64::from(crest) / f64::from(lobes));
        (0..lobes).map(|crest| land::between(&high, &turned(crest))).fold(f64::INFINITY, f64::min)
    }

    fn port(&self, side: PortSide, crest: u32) -> Port {
        self.ports[of(side)].turned(TAU * f64::from(crest) / f64::from(self.motor.numbers().stator_lobes()))
    }

    /// Area that a chamber at a phase shares with the ports of a pressure, in units of the module.
    fn opening(&self, side: PortSide, phase: f64) -> f64 {
        let region = Region::new(&self.motor, phase - 0.5 * self.motor.chamber_phase(), 0);
        let crests = 0..self.motor.numbers().stator_lobes();
        crests.map(|crest| region.shared(&self.port(side, crest))).sum()
    }

    /// The area of the opening of a chamber to the ports of a pressure, at a phase of the chamber.
    ///
    /// # Errors
    /// [`Error::NotFinite`].
    pub fn opening_at(&self, side: PortSide, phase: Angle) -> Result<Area, Error> {
        let phase = finite_angle(Quantity::Rotation, phase)?;
        Ok(area(self.opening(side, phase), self.motor.module()))
    }

    /// The rotation of the rotor at which a chamber has a phase.
    #[must_use]
    pub fn rotation_of(&self, chamber: u32, phase: Angle) -> Angle {
        phase - Angle::from_si(self.motor.chamber_phase() * (f64::from(chamber) + 0.5))
    }
}

/// Checks that the rays through the contacts part the chambers. The error is the first of three causes with
/// its greatest extent: a contact steeper than 45°, a satellite across its neighbour's ray, a satellite that
/// cuts into a wheel. The check covers 64 phases of a cycle and the jumps of the curvature, and 64 points of
/// a satellite.
pub(crate) fn rays_part_chambers(motor: &Motor) -> Result<(), Error> {
    const PLACES: u32 = 64;
    let (cycle, r) = (2.0 * motor.shape.trough().phase, motor.shape.satellite_radius());
    let phases = || (0..PLACES).map(|i| cycle * f64::from(i) / f64::from(PLACES));
    let mm = |modules: f64| motor.length(modules).mm();
    let slopes = phases().map(|phase| motor.place_at(phase).contact.mu);
    let steepest = largest_absolute(slopes.chain(motor.shape.kink_contact().map(|contact| contact.mu)));
    if steepest > STEEPEST {
        let [slope_deg, most_deg] = [steepest, STEEPEST].map(|slope| Angle::from_si(slope).degrees());
        return Err(Error::SteepCentrode { slope_deg, most_deg });
    }
    let across = phases().filter_map(|phase| {
        let [back, front] = [phase, phase + motor.chamber_phase()].map(|phase| motor.place_at(phase));
        let beyond = |[x, y]: [f64; 2], theta: f64| y * libm::cos(theta) - x * libm::sin(theta);
        let least = beyond(front.centre, back.contact.theta3).min(-beyond(back.centre, front.contact.theta3));
        let is_beside = front.contact.theta3 - back.contact.theta3 <= 0.25 * TAU;
        (is_beside && least < r).then_some((r - least, phase))
    });
    if let Some((by, phase)) = greatest(across) {
        return Err(Error::SatelliteAcrossRay {
            by_mm: mm(by),
            rotation_deg: Angle::from_si(phase).degrees(),
        });
    }
    let [rotor, stator] = motor.facing_radii();
    // The other half of the cycle mirrors this one.
    for (wheel, is_stator) in [(WheelKind::Stator, true), (WheelKind::Rotor, false)] {
        let within = phases().take(PLACES as usize / 2 + 1).flat_map(|phase| {
            let [x, y] = motor.place_at(phase).centre;
            (0..PLACES).map(move |j| {
                let (sin, cos) = libm::sincos(TAU * f64::from(j) / f64::from(PLACES));
                ([x + r * cos, y + r * sin], phase)
            })
        });
        // Within the stator's least radius, and outside the rotor's greatest, the curves are not evaluated.
        let cut = within.filter_map(|([x, y], phase)| {
            let (rho, theta) = (libm::hypot(x, y), libm::atan2(y, x));
            let by = if is_stator {
                if rho <= stator {
                    return None;
                }
                rho - motor.shape.at(By::StatorAngle, theta).rho3
            } else {
                if rho >= rotor {
                    return None;
                }
                motor.shape.at(By::RotorAngle, theta - phase).rho1 - rho
            };
            Some((by, phase))
        });
        if let Some((by, phase)) = greatest(cut.filter(|(by, _)| *by > crate::tolerance::MET)) {
            return Err(Error::SatelliteInWheel {
                wheel,
                by_mm: mm(by),
                rotation_deg: Angle::from_si(phase).degrees(),
            });
        }
    }
    Ok(())
}

/// The greatest extent, and its phase.
fn greatest(extents: impl Iterator<Item = (f64, f64)>) -> Option<(f64, f64)> {
    extents.reduce(|most, other| if other.0 > most.0 { other } else { most })
}

/// The place of a pressure in a pair.
fn of(side: PortSide) -> usize {
    match side {
        PortSide::High => 0,
        PortSide::Low => 1,
    }
}

#[cfg(test)]
mod tests;
