//! A motor: numbers, module, and a closed pair of centrodes.
//!
//! # Frame and signs
//! The stator rests, with the middle of a crest on the x axis; angles are counter-clockwise from there. The
//! *rotation* of the rotor is counter-clockwise from where one of its crests is on the x axis too, with
//! satellite 0 between.

use crate::quantity::Quantity;
use epicyclic_units::Physical;
use uom::si::f64::{Angle, Length};

use crate::Error;
use crate::arcs::StatorArcs;
use crate::closure::arcs_at;
use crate::contact::{By, Conjugate, Contact};
use crate::cosine::{Cosine, Law};
use crate::machine;
use crate::modules::length;
use crate::numbers::MotorNumbers;
use crate::ranges::{finite_angle, finite_modules};
use crate::second_harmonic::{self, HarmonicLaw};
use crate::two_arcs::TwoArcs;

/// A closed motor.
#[derive(Debug, Clone, PartialEq)]
pub struct Motor {
    numbers: MotorNumbers,
    module: Length,
    pub(crate) shape: Shape,
}

/// Form of the centrodes.
#[derive(Debug, Clone, PartialEq)]
#[allow(clippy::large_enum_variant)] // the larger one is the usual one; boxed, it would cost a search an allocation a motor
pub(crate) enum Shape {
    Arcs(StatorArcs, TwoArcs),
    Cosine(Cosine),
}

impl Motor {
    /// A motor whose stator consists of two arcs, at the distance `l` of its family.
    ///
    /// # Errors
    /// As [`crate::closure::arcs_at`]; [`Error::RotorInStator`], [`Error::NoChamber`].
    ///
    /// # Example
    /// ```
    /// use epicyclic_hydromotor::{Motor, MotorNumbers};
    /// use uom::si::{f64::Length, length::millimeter};
    ///
    /// let mm = Length::new::<millimeter>;
    /// let motor = Motor::of_two_arcs(MotorNumbers::new(5, 3, 55, 10)?, mm(1.0), mm(40.0))?;
    /// assert!((motor.satellite_radius() - mm(5.0)).get::<millimeter>().abs() < 1e-12);
    /// # Ok::<(), epicyclic_hydromotor::Error>(())
    /// ```
    pub fn of_two_arcs(
        numbers: MotorNumbers,
        module: Length,
        trough_distance: Length,
    ) -> Result<Self, Error> {
        Self::of_closed_arcs(numbers, arcs_at(numbers, module, trough_distance)?).turning()
    }

    /// Motor of arcs known to close; whether the rotor turns is not checked.
    pub(crate) fn of_closed_arcs(numbers: MotorNumbers, arcs: StatorArcs) -> Self {
        let lobe = TwoArcs::new(&arcs.arcs, f64::from(numbers.satellite_teeth()) / 2.0);
        Self { numbers, module: arcs.module, shape: Shape::Arcs(arcs, lobe) }
    }

    /// The motor with a cosine-law rotor ([`crate::cosine`]).
    ///
    /// # Errors
    /// [`Error::NotPositive`], [`Error::OutOfRange`] for the module, [`Error::NoCosineRotor`] where none
    /// closes; [`Error::RotorInStator`], [`Error::NoChamber`].
    pub fn of_cosine_law(numbers: MotorNumbers, module: Length) -> Result<Self, Error> {
        let module = machine::module(module)?;
        Self { numbers, module, shape: Shape::Cosine(Cosine::new(numbers)?) }.turning()
    }

    /// The motor with a second-harmonic rotor of an amplitude `ε₂` ([`crate::second_harmonic`]); with 0 that
    /// of the cosine law.
    ///
    /// # Errors
    /// [`Error::NotPositive`], [`Error::OutOfRange`] for the module, [`Error::NotFinite`] for `ε₂`,
    /// [`Error::RotorInStator`], [`Error::NoChamber`], [`Error::OutsideHarmonic`] where none closes without
    /// cusps with this `ε₂`, [`Error::NoSecondHarmonicRotor`] where none does with any.
    ///
    /// # Example
    /// ```
    /// use epicyclic_hydromotor::{Motor, MotorNumbers};
    /// use uom::si::{area::square_millimeter, f64::Length, length::millimeter};
    ///
    /// let numbers = MotorNumbers::new(6, 4, 66, 10)?;
    /// let motor = Motor::of_second_harmonic(numbers, Length::new::<millimeter>(1.0), 0.015)?;
    /// let [least, greatest] = motor.chamber_extremes();
    /// assert!(((greatest - least).get::<square_millimeter>() - 96.395).abs() < 5e-4);
    /// # Ok::<(), epicyclic_hydromotor::Error>(())
    /// ```
    pub fn of_second_harmonic(
        numbers: MotorNumbers,
        module: Length,
        second_amplitude: f64,
    ) -> Result<Self, Error> {
        let module = machine::module(module)?;
        let shape = Shape::Cosine(second_harmonic::lobe(numbers, second_amplitude)?);
        Self { numbers, module, shape }.turning()
    }

    /// Motor of a law known to close without cusps; whether the rotor turns is not checked.
    pub(crate) fn of_law(numbers: MotorNumbers, module: Length, law: Law) -> Self {
        Self { numbers, module, shape: Shape::Cosine(Cosine::of_law(law)) }
    }

    /// The motor, if its rotor turns within the stator and its least chamber has an area
    /// ([`crate::machine`]).
    pub(crate) fn turning(self) -> Result<Self, Error> {
        let [rotor, stator] = self.facing_radii();
        // The two radii decide whether the wheels overlap at any angle: see `crate::machine`.
        if rotor >= stator {
            let [rotor_mm, stator_mm] = [rotor, stator].map(|value| length(value, self.module()).mm());
            return Err(Error::RotorInStator { rotor_mm, stator_mm });
        }
        let [least, _] = self.chamber_extremes();
        let area_mm2 = least.mm2();
        if area_mm2 > 0.0 { Ok(self) } else { Err(Error::NoChamber { area_mm2 }) }
    }

    /// The rotor's greatest radius and the stator's least, in modules: the radii of crest and trough where
    /// they face each other.
    pub(crate) fn facing_radii(&self) -> [f64; 2] {
        [self.shape.at(By::Phase, 0.0).rho1, self.shape.trough().rho3]
    }

    /// The numbers.
    #[must_use]
    pub fn numbers(&self) -> MotorNumbers {
        self.numbers
    }

    /// The module.
    #[must_use]
    pub fn module(&self) -> Length {
        self.module
    }

    /// The stator's arcs, of a motor of two arcs.
    #[must_use]
    pub fn arcs(&self) -> Option<&StatorArcs> {
        match &self.shape {
            Shape::Arcs(arcs, _) => Some(arcs),
            Shape::Cosine(_) => None,
        }
    }

    /// The rotor's law, of a motor with a cosine-law rotor; none with a second harmonic.
    #[must_use]
    pub fn cosine_law(&self) -> Option<CosineLaw> {
        match &self.shape {
            Shape::Cosine(cosine) if cosine.law().second == 0.0 => Some(CosineLaw {
                mean_radius: self.length(cosine.law().c),
                amplitude: cosine.law().amplitude,
                cusp_amplitude: cosine.cusp_amplitude(),
            }),
            _ => None,
        }
    }

    /// The rotor's law, of a motor with a cosine-law rotor, with or without a second harmonic.
    #[must_use]
    pub fn harmonic_law(&self) -> Option<HarmonicLaw> {
        match &self.shape {
            Shape::Arcs(..) => None,
            Shape::Cosine(cosine) => Some(HarmonicLaw::of(cosine.law(), self.module)),
        }
    }

    /// Pitch radius of a satellite, `r = m·Z_s/2`.
    #[must_use]
    pub fn satellite_radius(&self) -> Length {
        self.length(self.shape.satellite_radius())
    }

    /// A satellite's contact with both wheels after a rotation of the rotor since it stood between two
    /// crests.
    ///
    /// # Errors
    /// [`Error::NotFinite`].
    pub fn contact(&self, rotation: Angle) -> Result<SatelliteContact, Error> {
        Ok(self.contact_by(By::Phase, finite_angle(Quantity::Rotation, rotation)?))
    }

    /// A satellite's contact where it has rolled an arc of the stator since it stood between two crests.
    ///
    /// # Errors
    /// [`Error::NotFinite`].
    pub fn contact_at_stator_arc(&self, arc: Length) -> Result<SatelliteContact, Error> {
        Ok(self.contact_by(By::StatorArc, finite_modules(Quantity::StatorArc, arc, self.module)?))
    }

    fn contact_by(&self, by: By, value: f64) -> SatelliteContact {
        SatelliteContact::of(&self.shape.at(by, value), self.module)
    }

    /// Phase of a satellite: satellite `j` is `j/n` of a turn of the rotor ahead of satellite 0.
    pub(crate) fn phase(&self, rotation_rad: f64, satellite: u32) -> f64 {
        rotation_rad + self.chamber_phase() * f64::from(satellite)
    }

    /// The phase between neighbouring satellites, `2π/n`.
    pub(crate) fn chamber_phase(&self) -> f64 {
        std::f64::consts::TAU / f64::from(self.numbers.rotor_lobes())
    }

    pub(crate) fn length(&self, modules: f64) -> Length {
        length(modules, self.module)
    }
}

/// Contact of a satellite with both wheels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SatelliteContact {
    /// `Φ = θ₃ + θ₁`: rotation of the rotor since the satellite stood between two crests.
    pub rotation: Angle,
    /// `θ₃`: polar angle on the stator, from that crest, the way that the rotor turns.
    pub stator_angle: Angle,
    /// `ρ₃`: distance of that point from the axis.
    pub stator_radius: Length,
    /// `θ₁`: polar angle on the rotor from its crest, against the way that it turns.
    pub rotor_angle: Angle,
    /// `ρ₁`: distance of that point from the axis.
    pub rotor_radius: Length,
    /// `μ`: polar angle less angle of the normal; 0 at crests and troughs, negative on the way from crest to
    /// trough.
    pub slope_angle: Angle,
    /// `s₃`: arc rolled on the stator.
    pub stator_arc: Length,
    /// `s₁`: arc rolled on the rotor, `s₃ + 2·r·μ`.
    pub rotor_arc: Length,
}

impl SatelliteContact {
    /// Converts a contact from modules.
    pub(crate) fn of(contact: &Contact, module: Length) -> Self {
        Self {
            rotation: Angle::from_si(contact.phase),
            stator_angle: Angle::from_si(contact.theta3),
            stator_radius: length(contact.rho3, module),
            rotor_angle: Angle::from_si(contact.theta1),
            rotor_radius: length(contact.rho1, module),
            slope_angle: Angle::from_si(contact.mu),
            stator_arc: length(contact.s3, module),
            rotor_arc: length(contact.s1, module),
        }
    }
}

/// The law of a cosine-law rotor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CosineLaw {
    /// `c`.
    pub mean_radius: Length,
    /// `ε`.
    pub amplitude: f64,
    /// The amplitude at which a rotor of this mean radius gives the stator cusps.
    pub cusp_amplitude: f64,
}

impl Shape {
    /// The quantity in which the shape is explicit: a contact by it takes no search.
    pub(crate) fn explicit(&self) -> By {
        match self {
            Self::Arcs(..) => By::StatorArc,
            Self::Cosine(_) => By::RotorAngle,
        }
    }

    /// The contact where the curvature jumps, if it does.
    pub(crate) fn kink_contact(&self) -> Option<&Contact> {
        match self {
            Self::Arcs(_, lobe) => Some(lobe.junction()),
            Self::Cosine(_) => None,
        }
    }
}

impl Conjugate for Shape {
    fn satellite_radius(&self) -> f64 {
        match self {
            Self::Arcs(_, lobe) => lobe.satellite_radius(),
            Self::Cosine(lobe) => lobe.satellite_radius(),
        }
    }

    fn trough(&self) -> &Contact {
        match self {
            Self::Arcs(_, lobe) => lobe.trough(),
            Self::Cosine(lobe) => lobe.trough(),
        }
    }

    fn within(&self, by: By, value: f64) -> Contact {
        match self {
            Self::Arcs(_, lobe) => lobe.within(by, value),
            Self::Cosine(lobe) => lobe.within(by, value),
        }
    }

    fn kink(&self) -> Option<f64> {
        match self {
            Self::Arcs(_, lobe) => lobe.kink(),
            Self::Cosine(lobe) => lobe.kink(),
        }
    }

    fn flow_within(&self, phase: f64) -> (f64, f64) {
        match self {
            Self::Arcs(_, lobe) => lobe.flow_within(phase),
            Self::Cosine(lobe) => lobe.flow_within(phase),
        }
    }

    fn curvature_extremes(&self) -> [f64; 4] {
        match self {
            Self::Arcs(_, lobe) => lobe.curvature_extremes(),
            Self::Cosine(lobe) => lobe.curvature_extremes(),
        }
    }

    fn centre_within(&self, phase: f64) -> [f64; 2] {
        match self {
            Self::Arcs(_, lobe) => lobe.centre_within(phase),
            Self::Cosine(lobe) => lobe.centre_within(phase),
        }
    }

    fn rotor_area(&self) -> f64 {
        match self {
            Self::Arcs(_, lobe) => lobe.rotor_area(),
            Self::Cosine(lobe) => lobe.rotor_area(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::centrode::Wheel;
    use crate::checks::ToothHeights;
    use proptest::prelude::*;
    use uom::si::f64::{AngularVelocity, Pressure};

    fn m(value: f64) -> Length {
        Length::from_si(value)
    }

    /// Everything a motor answers.
    fn ask(motor: &Motor, x: f64) {
        let (rotation, length) = (Angle::from_si(x), m(x));
        let pressure = Pressure::from_si(x);
        let speed = AngularVelocity::from_si(x);
        let _ = (motor.contact(rotation), motor.contact_at_stator_arc(length), motor.satellites(rotation));
        for wheel in [Wheel::Stator, Wheel::Rotor, Wheel::Satellite] {
            let curve = motor.centrode(wheel);
            let _ = (curve.at(length), curve.at_polar_angle(rotation), curve.at_rotation(rotation));
        }
        let _ = (motor.chambers(rotation), motor.chamber_outline(rotation, 7, 3), motor.displacement(length));
        let _ = (motor.flow_per_width(rotation), motor.torque(rotation, length, pressure));
        let _ = (motor.theoretical_power(length, pressure, speed), motor.mean_flow(length, speed));
        let _ = motor.satellite_forces(rotation, length, pressure, -pressure);
        let _ = motor.checks(ToothHeights { addendum: x, dedendum: 1.0 });
        let _ = (motor.ripple(), motor.ports(), motor.envelope(), motor.chamber_extremes());
    }

    proptest! {
        #[test]
        fn no_finite_input_panics(
            set in (2..11_u32, 1..4_u32, 1..1200_u32, 1..60_u32), l in any::<f64>(), x in any::<f64>(), part in 0.0..5.0,
        ) {
            let (lobes, fewer, per_lobe, satellite) = set;
            if let Ok(numbers) = MotorNumbers::new(lobes, lobes.saturating_sub(fewer), lobes * per_lobe, satellite) {
                let near = part * f64::from(numbers.stator_teeth());
                for (module, l) in [(m(1.0), m(near)), (m(x.abs()), m(near) * x.abs()), (m(1.0), m(l))] {
                    let motors = [Motor::of_two_arcs(numbers, module, l), Motor::of_cosine_law(numbers, module)];
                    motors.iter().flatten().for_each(|motor| ask(motor, x));
                }
            }
        }
    }
}
