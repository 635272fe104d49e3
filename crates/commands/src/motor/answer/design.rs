//! Choice of a motor from its family.

use super::faults::Faults;
use super::made::{Groups, Inputs, Made, Point};
use crate::error::Error;
use epicyclic_formats::motor::MotorFile;
use epicyclic_formats::{Document, Path};
use epicyclic_hydromotor::closure::Family;
use epicyclic_hydromotor::place::Place;
use epicyclic_hydromotor::profile::{Profile, ToothForm};
use epicyclic_hydromotor::{Error as MotorError, Motor, MotorNumbers};
use schemars::JsonSchema;
use serde::Serialize;
use uom::si::f64::{Angle, AngularVelocity, Length, Pressure};

/// Motor to be designed, with its operating data.
#[derive(Debug, Clone, PartialEq)]
pub struct Question {
    /// Numbers of lobes and teeth.
    pub numbers: MotorNumbers,
    /// Module.
    pub module: Length,
    /// Choice among the motors of these numbers.
    pub place: Place,
    /// Form of the teeth.
    pub form: ToothForm,
    /// Width of the wheels.
    pub width: Option<Length>,
    /// Pressure drop, high minus low.
    pub pressure: Option<Pressure>,
    /// Speed of the rotor.
    pub speed: Option<AngularVelocity>,
    /// Rotor angle from the position in which a crest of the rotor faces a crest of the stator.
    pub angle: Angle,
    /// Material, oil, gaps, friction and ports.
    pub made: Groups,
}

/// Reasons for the choice of a motor from its family.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Chosen {
    /// Given by the distance of an arc's centre, or by a part of the family.
    Given,
    /// Middle of the family, because nothing was given.
    Middle,
}

/// Designed motor with its operating data.
#[derive(Debug, Clone)]
pub struct Designed {
    /// The motor.
    pub motor: Motor,
    /// Family of the motor; `None` for a rotor by the cosine law.
    pub family: Option<Family>,
    /// Reason for the choice from the family.
    pub chosen: Chosen,
    /// Form of the teeth.
    pub form: ToothForm,
    /// Tooth profile, or the reason why none exists.
    pub profile: Result<Profile, MotorError>,
    /// Width of the wheels.
    pub width: Option<Length>,
    /// Pressure drop, high minus low.
    pub pressure: Option<Pressure>,
    /// Speed of the rotor.
    pub speed: Option<AngularVelocity>,
    /// Angle of the rotor.
    pub angle: Angle,
    /// Manufacturing data, and the results that follow from them.
    pub made: Made,
}

/// Designs the motor that the question describes.
///
/// # Errors
/// [`Error::Motor`] for numbers with which no motor closes, a place outside its family, or an impossible
/// tooth form; [`Error::PressureDrop`], [`Error::RotorSpeed`] unless these are above 0.
pub fn design(question: &Question) -> Result<Designed, Error> {
    let &Question { numbers, module, place, form, width, pressure, speed, angle, ref made } = question;
    let (motor, family) = place.motor(numbers, module)?;
    let chosen = chosen(place);
    let point = Point { form, width, pressure, speed };
    let inputs = Inputs::of(made, point)?;
    let profile = profile(&motor, form)?;
    let made = Made::of(&motor, &inputs, point)?;
    Ok(Designed { motor, family, chosen, form, profile, width, pressure, speed, angle, made })
}

fn chosen(place: Place) -> Chosen {
    if place == Place::Middle { Chosen::Middle } else { Chosen::Given }
}

/// Tooth profile, or the reason why this motor has none; a number that is impossible for any motor is an
/// error.
pub(crate) fn profile(motor: &Motor, form: ToothForm) -> Result<Result<Profile, MotorError>, MotorError> {
    match Profile::new(motor, form) {
        Err(
            error @ (MotorError::OutOfRange { .. }
            | MotorError::NotFinite { .. }
            | MotorError::NotPositive { .. }),
        ) => Err(error),
        made => Ok(made),
    }
}

/// Reads title and motor from a file.
///
/// # Errors
/// [`Error::Document`] with all independent faults at the keys that they are about.
pub fn of_file(document: &Document) -> Result<(Option<String>, Designed), Error> {
    let file = MotorFile::of(document)?;
    let form = file.teeth.clone().unwrap_or_default().form();
    let width = file.width.map(|width| width.0);
    let (pressure, speed) = (file.pressure.map(|drop| drop.0), file.speed.map(|speed| speed.0));
    let point = Point { form, width, pressure, speed };
    let ((motor, family), inputs) = match (file.motor(), Inputs::of(&file.made(), point)) {
        (Ok(motor), Ok(inputs)) => (motor, inputs),
        (motor, inputs) => return Err(placed(document, motor.err(), inputs.err())),
    };
    let mut faults = Faults::default();
    let profile = faults.keep(profile(&motor, form));
    let made = Made::of(&motor, &inputs, point).map_err(|found| faults.extend(found)).ok();
    let (Some(profile), Some(made)) = (profile, made) else {
        return Err(placed(document, None, Some(faults)));
    };
    let chosen = chosen(file.place());
    let angle = file.angle.map_or_else(Angle::default, |angle| angle.0);
    let designed = Designed { motor, family, chosen, form, profile, width, pressure, speed, angle, made };
    Ok((file.title, designed))
}

/// Faults of the file and of its values, at their places.
fn placed(document: &Document, of_file: Option<epicyclic_formats::Faults>, others: Option<Faults>) -> Error {
    let mut all = of_file.unwrap_or_default();
    if let Some(others) = others {
        others.put_into(&mut all);
    }
    Error::Document(all.placed(document, &Path::root()))
}
