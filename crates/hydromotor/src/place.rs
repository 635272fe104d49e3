//! Choice among the motors of given numbers.

use crate::Error;
use crate::arcs::StatorArcs;
use crate::closure::Family;
use crate::motor::Motor;
use crate::numbers::MotorNumbers;
use uom::si::f64::Length;

/// Ways to choose a motor of given numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Place {
    /// Stator of two arcs, in the middle of the family.
    Middle,
    /// Distance `l` of the centres of the stator's arcs at the troughs.
    TroughDistance(Length),
    /// Distance `a` of the centres of the stator's arcs at the crests.
    CrestDistance(Length),
    /// Part of the family, from 0 to 1.
    Part(f64),
    /// Rotor by the cosine law: one motor, no family.
    CosineLaw,
    /// Rotor by the cosine law with a second harmonic of this relative amplitude `ε₂`.
    SecondHarmonic(f64),
}

impl Place {
    /// Family of motors with these numbers, and the arcs at this place of it; `None` for a rotor by the
    /// cosine law.
    ///
    /// # Errors
    /// Errors of [`Family::new`], [`Family::at`] and its sisters.
    pub fn arcs(self, numbers: MotorNumbers, module: Length) -> Result<Option<(Family, StatorArcs)>, Error> {
        if matches!(self, Self::CosineLaw | Self::SecondHarmonic(_)) {
            return Ok(None);
        }
        let family = Family::new(numbers, module)?;
        let arcs = match self {
            Self::TroughDistance(l) => family.at(l),
            Self::CrestDistance(a) => family.at_crest_distance(a),
            Self::Part(part) => family.at_part(part),
            Self::Middle | Self::CosineLaw | Self::SecondHarmonic(_) => family.at_part(0.5),
        }?;
        Ok(Some((family, arcs)))
    }

    /// The motor of these numbers at this place, and its family; a cosine-law motor has none.
    ///
    /// # Errors
    /// Errors of [`Place::arcs`], [`Motor::of_two_arcs`], [`Motor::of_cosine_law`],
    /// [`Motor::of_second_harmonic`].
    ///
    /// # Example
    /// ```
    /// use epicyclic_hydromotor::MotorNumbers;
    /// use epicyclic_hydromotor::place::Place;
    /// use uom::si::{f64::Length, length::millimeter};
    ///
    /// let (numbers, module) = (MotorNumbers::new(7, 5, 84, 11)?, Length::new::<millimeter>(1.0));
    /// let (motor, family) = Place::CosineLaw.motor(numbers, module)?;
    /// assert!(motor.arcs().is_none() && family.is_none());
    /// # Ok::<(), epicyclic_hydromotor::Error>(())
    /// ```
    pub fn motor(self, numbers: MotorNumbers, module: Length) -> Result<(Motor, Option<Family>), Error> {
        let motor = match (self, self.arcs(numbers, module)?) {
            (_, Some((family, arcs))) => {
                let motor = Motor::of_two_arcs(numbers, module, arcs.trough_distance())?;
                return Ok((motor, Some(family)));
            }
            (Self::SecondHarmonic(second), None) => Motor::of_second_harmonic(numbers, module, second)?,
            (_, None) => Motor::of_cosine_law(numbers, module)?,
        };
        Ok((motor, None))
    }
}
