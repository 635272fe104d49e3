//! The motor described by the options, and the option that an error refers to.

use super::{Request, Teeth};
use crate::failure::Failure;
use crate::motor::answer::{Designed, Motor, Question, answer, design};
use epicyclic_formats::motor;
use epicyclic_hydromotor::place::Place;
use epicyclic_hydromotor::profile::ToothForm;
use epicyclic_hydromotor::quantity::{Quantity, WheelKind};
use epicyclic_hydromotor::{Error, MotorNumbers};
use uom::si::f64::{Angle, Length};

impl Request {
    /// The motor of these numbers.
    ///
    /// # Errors
    /// [`Failure::Option`] for a number that is missing or cannot be.
    pub fn designed(&self) -> Result<Designed, Failure> {
        let (numbers, module) = self.numbers()?;
        let question = Question {
            numbers,
            module,
            place: self.place(),
            form: form(&self.teeth),
            width: self.width.map(|width| width.0),
            pressure: self.pressure.map(|pressure| pressure.0),
            speed: self.speed.map(|speed| speed.0),
            angle: self.angle.as_ref().map_or_else(Angle::default, |angle| angle.0),
            made: self.made.groups(),
        };
        design(&question).map_err(refuse)
    }

    /// Calculates the motor of these numbers.
    ///
    /// # Errors
    /// [`Failure::Option`] for a number that is missing or cannot be.
    pub fn answer(&self) -> Result<Motor, Failure> {
        answer(&self.designed()?).map_err(refuse)
    }

    /// Lobes, teeth and module; where no teeth of a satellite are given, with the least satellite.
    pub(crate) fn numbers(&self) -> Result<(MotorNumbers, Length), Failure> {
        let (Some(stator), Some(rotor), Some(z3), Some(module)) =
            (self.stator, self.rotor, self.z3, self.module)
        else {
            let message = "a motor has --stator, --rotor, --z3 and --module";
            return Err(Failure::missing("--stator", message.to_owned()));
        };
        let zs = self.zs.unwrap_or(1);
        let numbers = match self.z1 {
            Some(z1) => MotorNumbers::with_rotor_teeth(stator, rotor, z3, z1, zs),
            None => MotorNumbers::new(stator, rotor, z3, zs),
        };
        Ok((numbers.map_err(|error| refuse(error.into()))?, module.0.length()))
    }

    pub(crate) fn place(&self) -> Place {
        match (self.cosine, self.l, self.a, self.part) {
            (true, ..) => {
                self.second_harmonic.map_or(Place::CosineLaw, |second| Place::SecondHarmonic(second.get()))
            }
            (_, Some(l), ..) => Place::TroughDistance(l.0),
            (_, _, Some(a), _) => Place::CrestDistance(a.0),
            (.., Some(part)) => Place::Part(part.get()),
            _ => Place::Middle,
        }
    }
}

pub(crate) fn form(teeth: &Teeth) -> ToothForm {
    ToothForm {
        pressure_angle: teeth.pressure_angle.0,
        addendum: teeth.addendum.get(),
        clearance: teeth.clearance.get(),
        shift: teeth.shift.get(),
        backlash: teeth.backlash.get(),
        fillet: teeth.fillet.get(),
        crest: teeth.crest.of_search(),
        ..ToothForm::default()
    }
}

/// Converts an error to a failure with the option that caused it.
pub(crate) fn refuse(error: crate::error::Error) -> Failure {
    let key = match &error {
        crate::error::Error::MotorKey { key, .. } => Some((*key).to_owned()),
        crate::error::Error::Motor(error) => Some(motor::place(error).to_string()),
        _ => None,
    };
    // Keys of a group share one option; the rest of the key goes into the message.
    if let Some((option, of)) = key.as_deref().and_then(of_group) {
        let message = if of.is_empty() { error.to_string() } else { format!("{of}: {error}") };
        return Failure::named(error.name(), option, message);
    }
    let option = match &error {
        crate::error::Error::Motor(error) => of_motor(error),
        crate::error::Error::PressureDrop => Some("--pressure"),
        crate::error::Error::RotorSpeed => Some("--speed"),
        crate::error::Error::CentrodePoints { .. } => Some("--points"),
        crate::error::Error::NoSuchDesign { .. } => Some("--design"),
        crate::error::Error::NoConstruction { .. } => Some("--l, --a"),
        crate::error::Error::NoArcs => Some("--construction"),
        crate::error::Error::TooManyToList { .. } => Some("--z3"),
        _ => None,
    };
    match option {
        Some(option) => Failure::of_option(option, &error),
        None => error.into(),
    }
}

/// A refusal of a motor from a file: an option where it is about one, else for its place in the file.
pub(crate) fn refuse_of_file(error: crate::error::Error, has_angle: bool) -> Failure {
    match &error {
        crate::error::Error::CentrodePoints { .. } => refuse(error),
        crate::error::Error::Motor(Error::NotFinite { quantity: Quantity::Rotation, .. }) if has_angle => {
            refuse(error)
        }
        _ => error.into(),
    }
}

/// The option of a group of keys, and the rest of the key.
fn of_group(key: &str) -> Option<(&'static str, &str)> {
    let (group, rest) = key.split_once('.').unwrap_or((key, ""));
    let option = match group {
        "material" => "--material",
        "oil" => "--oil",
        "gaps" => "--gaps",
        "friction" => "--friction",
        "ports" => "--ports",
        _ => return None,
    };
    Some((option, rest))
}

fn of_motor(error: &Error) -> Option<&'static str> {
    // Lobes and teeth of a gear have options of their own; a satellite has no lobes.
    let wheel_option = |wheel: &WheelKind, lobes: bool| match (wheel, lobes) {
        (WheelKind::Stator, true) => Some("--stator"),
        (WheelKind::Rotor, true) => Some("--rotor"),
        (WheelKind::Stator, false) => Some("--z3"),
        (WheelKind::Rotor, false) => Some("--z1"),
        (WheelKind::Satellite, _) => Some("--zs"),
        _ => None,
    };
    match error {
        Error::NoLobes { wheel } => wheel_option(wheel, true),
        Error::NoTeeth { wheel } | Error::TooManyTeeth { wheel, .. } | Error::TeethPerLobe { wheel, .. } => {
            wheel_option(wheel, false)
        }
        Error::LobesNotMore { .. } | Error::LobesTooDifferent { .. } => Some("--stator, --rotor"),
        Error::TeethPerLobeDiffer { .. } => Some("--z1"),
        Error::SatelliteTooLarge { .. } | Error::RotorInStator { .. } | Error::NoChamber { .. } => {
            Some("--zs")
        }
        Error::OutsideFamily { .. } => Some("--l"),
        Error::OutsideFamilyByCrest { .. } => Some("--a"),
        Error::NoCosineRotor { .. } | Error::NoSecondHarmonicRotor { .. } => Some("--cosine"),
        Error::OutsideHarmonic { .. } => Some("--second-harmonic"),
        Error::NoModules => Some("--module"),
        Error::TooManySets { .. } => Some("--stator, --z3, --zs"),
        Error::NotPositive { quantity, .. }
        | Error::NotFinite { quantity, .. }
        | Error::OutOfRange { quantity, .. } => quantity_option(*quantity),
        _ => None,
    }
}

fn quantity_option(quantity: Quantity) -> Option<&'static str> {
    Some(match quantity {
        Quantity::Module => "--module",
        Quantity::TroughDistance => "--l",
        Quantity::CrestDistance => "--a",
        Quantity::FamilyPart => "--part",
        Quantity::SecondAmplitude => "--second-harmonic",
        Quantity::Width => "--width",
        Quantity::PressureDrop | Quantity::HighPressure => "--pressure",
        Quantity::Speed => "--speed",
        Quantity::Rotation => "--angle",
        Quantity::PressureAngle => "--pressure-angle",
        Quantity::Addendum => "--addendum",
        Quantity::Clearance => "--clearance",
        Quantity::ProfileShift => "--shift",
        Quantity::Backlash => "--backlash",
        Quantity::Fillet => "--fillet",
        Quantity::Displacement => "--displacement",
        Quantity::Torque => "--torque",
        Quantity::DisplacementTolerance => "--tolerance",
        Quantity::WidthOverDiameter => "--width-over-diameter",
        Quantity::OuterDiameter => "--outer-diameter",
        Quantity::Ripple => "--ripple",
        Quantity::FlankRipple => "--flank-ripple",
        Quantity::LeastTorque => "--least-torque",
        Quantity::FamilyPoints => "--places",
        Quantity::Resolution => "--resolution",
        _ => return None,
    })
}
