//! The motor that the options describe, and the option that a refusal speaks of.

use super::{Design, Teeth};
use crate::failure::Failure;
use epicyclic_formats::{Document, Path, Problem, motor};
use epicyclic_hydromotor::closure::Family;
use epicyclic_hydromotor::profile::{Profile, ToothForm};
use epicyclic_hydromotor::quantity::{Quantity, WheelKind};
use epicyclic_hydromotor::{Error, Motor, MotorNumbers};
use uom::si::f64::{Angle, AngularVelocity, Length, Pressure};

/// How the motor was chosen from its family.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Chosen {
    /// By `--l`, `--a` or `--part`.
    Given,
    /// The middle of the family: nothing was said.
    Middle,
    /// There is no family.
    Cosine,
}

/// A motor with what it is to be reckoned for.
#[derive(Debug)]
pub(super) struct Drawn {
    pub(super) motor: Motor,
    pub(super) family: Option<Family>,
    pub(super) chosen: Chosen,
    pub(super) form: ToothForm,
    /// The teeth, or why there are none.
    pub(super) profile: Result<Profile, Error>,
    pub(super) width: Option<Length>,
    pub(super) pressure: Option<Pressure>,
    pub(super) speed: Option<AngularVelocity>,
    pub(super) angle: Angle,
}

const POSITIVE_DROP: &str = "it is high less low pressure, so above 0; the motor runs counter-clockwise";
const POSITIVE_SPEED: &str = "it must be above 0; a motor that runs backwards is its mirror image";

pub(super) fn read(args: &Design) -> Result<Drawn, Failure> {
    let (Some(stator), Some(rotor), Some(z3), Some(zs), Some(module)) =
        (args.stator, args.rotor, args.z3, args.zs, args.module)
    else {
        unreachable!("these options are required where there is no subcommand")
    };
    let module = module.0;
    let numbers = match args.z1 {
        Some(z1) => MotorNumbers::with_rotor_teeth(stator, rotor, z3, z1, zs),
        None => MotorNumbers::new(stator, rotor, z3, zs),
    }
    .map_err(refuse)?;
    let (motor, family, chosen) = if args.cosine {
        (Motor::of_cosine_law(numbers, module).map_err(refuse)?, None, Chosen::Cosine)
    } else {
        let family = Family::new(numbers, module).map_err(refuse)?;
        let arcs = match (args.l, args.a, args.part) {
            (Some(l), ..) => family.at(l.0),
            (_, Some(a), _) => family.at_crest_distance(a.0),
            (.., Some(part)) => family.at_part(part.get()),
            _ => family.at_part(0.5),
        }
        .map_err(refuse)?;
        let given = args.l.is_some() || args.a.is_some() || args.part.is_some();
        let chosen = if given { Chosen::Given } else { Chosen::Middle };
        let motor = Motor::of_two_arcs(numbers, module, arcs.trough_distance()).map_err(refuse)?;
        (motor, Some(family), chosen)
    };
    if args.pressure.is_some_and(|pressure| pressure.0.value <= 0.0) {
        return Err(Failure::Option { option: "--pressure", message: POSITIVE_DROP.to_owned() });
    }
    if args.speed.is_some_and(|speed| speed.0.value <= 0.0) {
        return Err(Failure::Option { option: "--speed", message: POSITIVE_SPEED.to_owned() });
    }
    let form = form(&args.teeth);
    let profile = profile(&motor, form).map_err(refuse)?;
    Ok(Drawn {
        motor,
        family,
        chosen,
        form,
        profile,
        width: args.width.map(|width| width.0),
        pressure: args.pressure.map(|pressure| pressure.0),
        speed: args.speed.map(|speed| speed.0),
        angle: args.angle.0,
    })
}

/// The teeth, or why this motor has none; a number that no teeth have is a fault whatever the motor.
fn profile(motor: &Motor, form: ToothForm) -> Result<Result<Profile, Error>, Error> {
    match Profile::new(motor, form) {
        Err(error @ (Error::OutOfRange { .. } | Error::NotFinite { .. } | Error::NotPositive { .. })) => {
            Err(error)
        }
        made => Ok(made),
    }
}

/// The motor of a file.
pub(super) fn of_file(document: &Document) -> Result<(Option<String>, Drawn), Failure> {
    let (file, motor, family) = motor::read(document)?;
    for (key, is_positive, message) in [
        ("pressure", file.pressure.is_none_or(|pressure| pressure.0.value > 0.0), POSITIVE_DROP),
        ("speed", file.speed.is_none_or(|speed| speed.0.value > 0.0), POSITIVE_SPEED),
    ] {
        if !is_positive {
            let problem = Problem::Refused { message: message.to_owned() };
            return Err(document.error(&Path::root().key(key), problem).into());
        }
    }
    let form = file.teeth.clone().unwrap_or_default().form();
    let profile = profile(&motor, form).map_err(|error| {
        document.error(&motor::place(&error), Problem::Refused { message: error.to_string() })
    })?;
    let chosen = match &family {
        None => Chosen::Cosine,
        Some(_) if file.places() => Chosen::Given,
        Some(_) => Chosen::Middle,
    };
    let drawn = Drawn {
        motor,
        family,
        chosen,
        form,
        profile,
        width: file.width.map(|width| width.0),
        pressure: file.pressure.map(|pressure| pressure.0),
        speed: file.speed.map(|speed| speed.0),
        angle: file.angle.map_or_else(Angle::default, |angle| angle.0),
    };
    Ok((file.title, drawn))
}

fn form(teeth: &Teeth) -> ToothForm {
    ToothForm {
        pressure_angle: teeth.pressure_angle.0,
        addendum: teeth.addendum.get(),
        clearance: teeth.clearance.get(),
        shift: teeth.shift.get(),
        backlash: teeth.backlash.get(),
        fillet: teeth.fillet.get(),
        ..ToothForm::default()
    }
}

/// A refusal with the option that it speaks of.
pub(super) fn refuse(error: Error) -> Failure {
    let wheel_option = |wheel: &WheelKind, lobes: bool| match (wheel, lobes) {
        (WheelKind::Stator, true) => Some("--stator"),
        (WheelKind::Rotor, true) => Some("--rotor"),
        (WheelKind::Stator, false) => Some("--z3"),
        (WheelKind::Rotor, false) => Some("--z1"),
        (WheelKind::Satellite, _) => Some("--zs"),
        _ => None,
    };
    let option = match &error {
        Error::NoLobes { wheel } => wheel_option(wheel, true),
        Error::NoTeeth { wheel } | Error::TooManyTeeth { wheel, .. } | Error::TeethPerLobe { wheel, .. } => {
            wheel_option(wheel, false)
        }
        Error::LobesNotMore { .. } | Error::LobesTooDifferent { .. } => Some("--stator, --rotor"),
        Error::TeethPerLobeDiffer { .. } => Some("--z1"),
        Error::SatelliteTooLarge { .. } => Some("--zs"),
        Error::OutsideFamily { .. } => Some("--l"),
        Error::OutsideFamilyByCrest { .. } => Some("--a"),
        Error::NoCosineRotor { .. } => Some("--cosine"),
        Error::NoModules => Some("--module"),
        Error::TooManySets { .. } => Some("--stator, --z3, --zs"),
        Error::NotPositive { quantity, .. }
        | Error::NotFinite { quantity, .. }
        | Error::OutOfRange { quantity, .. } => quantity_option(*quantity),
        _ => None,
    };
    match option {
        Some(option) => Failure::Option { option, message: error.to_string() },
        None => error.into(),
    }
}

fn quantity_option(quantity: Quantity) -> Option<&'static str> {
    Some(match quantity {
        Quantity::Module => "--module",
        Quantity::TroughDistance => "--l",
        Quantity::CrestDistance => "--a",
        Quantity::FamilyPart => "--part",
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
        Quantity::FamilyPoints => "--places",
        Quantity::Resolution => "--resolution",
        _ => return None,
    })
}
