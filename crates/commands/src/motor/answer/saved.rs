//! A motor as a file that `motor`, `report` and `serve` read.

use super::Designed;
use crate::error::Error;
use epicyclic_formats::motor::MaterialGroup;
use epicyclic_formats::yaml::{Mapping, Value, to_string};
use epicyclic_hydromotor::profile::{Crest, ToothForm};
use epicyclic_units::format::trimmed;
use epicyclic_units::{Physical, Quantity};
use uom::si::f64::Pressure;

/// Significant digits of a quantity; more would show only the rounding of binary fractions.
const DIGITS: usize = 14;

/// Motor file below a line of comment, with the material of its teeth if given.
///
/// # Errors
/// [`Error::Json`] for a file that cannot be written.
pub(crate) fn file(
    designed: &Designed,
    material: Option<&MaterialGroup>,
    title: &str,
    comment: &str,
) -> Result<String, Error> {
    let Designed { motor, form, width, pressure, speed, .. } = designed;
    let numbers = motor.numbers();
    let mut keys = vec![
        ("title", Value::from(title)),
        ("stator", Value::from(numbers.stator_lobes())),
        ("rotor", Value::from(numbers.rotor_lobes())),
        ("z3", Value::from(numbers.stator_teeth())),
        ("zs", Value::from(numbers.satellite_teeth())),
        ("module", quantity(motor.module())),
    ];
    if let Some(arcs) = motor.arcs() {
        keys.push(("l", quantity(arcs.trough_distance())));
    } else {
        keys.push(("law", Value::from("cosine")));
        // A motor by the pure cosine law has no second harmonic, which differs from one of amplitude 0.
        if let (None, Some(law)) = (motor.cosine_law(), motor.harmonic_law()) {
            keys.push(("second_harmonic", number(law.second_amplitude)));
        }
    }
    keys.extend(width.map(|width| ("width", quantity(width))));
    keys.extend(pressure.map(|pressure| ("pressure", quantity(pressure))));
    keys.extend(speed.map(|speed| ("speed", quantity(speed))));
    keys.push(("teeth", teeth(form)));
    keys.extend(material.map(|material| ("material", group(material))));
    let text = to_string(&mapping(keys)).map_err(|error| Error::Json(error.to_string()))?;
    Ok(format!("# {comment}\n{text}"))
}

fn teeth(form: &ToothForm) -> Value {
    let crest = match form.crest {
        Crest::Space => "space",
        Crest::Tooth => "tooth",
    };
    mapping(vec![
        ("pressure_angle", quantity(form.pressure_angle)),
        ("addendum", number(form.addendum)),
        ("clearance", number(form.clearance)),
        ("shift", number(form.shift)),
        ("backlash", number(form.backlash)),
        ("fillet", number(form.fillet)),
        ("crest", Value::from(crest)),
    ])
}

fn group(material: &MaterialGroup) -> Value {
    let &MaterialGroup { youngs_modulus, poissons_ratio, contact_limit, root_limit } = material;
    let stress = |key: &'static str, stress: Option<Quantity<Pressure>>| {
        stress.map(|stress| (key, quantity(stress.0)))
    };
    let keys = [
        stress("youngs_modulus", youngs_modulus),
        poissons_ratio.map(|ratio| ("poissons_ratio", number(ratio.get()))),
        stress("contact_limit", contact_limit),
        stress("root_limit", root_limit),
    ];
    mapping(keys.into_iter().flatten().collect())
}

fn mapping(keys: Vec<(&str, Value)>) -> Value {
    Value::Mapping(keys.into_iter().map(|(key, value)| (Value::from(key), value)).collect::<Mapping>())
}

fn number(value: f64) -> Value {
    Value::from(trimmed(value, DIGITS).parse().unwrap_or(value))
}

/// Formats a quantity in the usual unit of its kind.
fn quantity<T: Physical>(quantity: T) -> Value {
    let unit = T::DIMENSION.usual_unit();
    Value::from(format!("{} {}", trimmed(quantity.si() / unit.factor, DIGITS), unit.symbol))
}
