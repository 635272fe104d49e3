//! Faults of a motor, all those that are independent of each other.

use crate::error::Error;
use crate::shared::fault::Fault as _;
use epicyclic_formats::{Path, motor as file};

/// Faults in the order in which they were found.
#[derive(Debug, Default)]
pub(crate) struct Faults(Vec<Error>);

impl Faults {
    /// The value, or `None` and its fault.
    pub(crate) fn keep<T, E: Into<Error>>(&mut self, value: Result<T, E>) -> Option<T> {
        value.map_err(|error| self.0.push(error.into())).ok()
    }

    /// Adds a fault.
    pub(crate) fn push(&mut self, fault: Error) {
        self.0.push(fault);
    }

    /// Adds these faults.
    pub(crate) fn extend<E: Into<Error>>(&mut self, faults: impl IntoIterator<Item = E>) {
        self.0.extend(faults.into_iter().map(Into::into));
    }

    /// The value, unless there are faults.
    pub(crate) fn or<T>(self, value: T) -> Result<T, Self> {
        if self.0.is_empty() { Ok(value) } else { Err(self) }
    }

    /// Adds these faults to others of the file, each at the key that it is about.
    pub(crate) fn put_into(&self, faults: &mut epicyclic_formats::Faults) {
        for error in &self.0 {
            let key = match error {
                Error::Motor(error) => file::place(error),
                Error::MotorKey { key, .. } => key.split('.').fold(Path::root(), Path::key),
                Error::PressureDrop => Path::root().key("pressure"),
                Error::RotorSpeed => Path::root().key("speed"),
                _ => Path::root(),
            };
            faults.add(key, error.problem());
        }
    }
}

impl IntoIterator for Faults {
    type Item = Error;
    type IntoIter = std::vec::IntoIter<Error>;

    fn into_iter(self) -> Self::IntoIter {
        self.0.into_iter()
    }
}

/// The first fault; there is one.
impl From<Faults> for Error {
    fn from(Faults(mut faults): Faults) -> Self {
        faults.swap_remove(0)
    }
}

#[cfg(test)]
mod tests {
    use crate::drive::answer as drive;
    use crate::error::Error;
    use crate::motor::answer as motor;
    use epicyclic_formats::Document;

    const MOTOR: &str = "\
stator: 5
rotor: 3
z3: 55
zs: 10
module: 2 mm
l: 80 mm
width: 40 mm
pressure: 20 MPa
speed: 100 rpm
teeth: { pressure_angle: 25 deg, addendum: 0.85, clearance: 0.25, backlash: 0.04, fillet: 0.1 }
material: { youngs_modulus: 206 GPa, poissons_ratio: 0.3, contact_limit: 2 GPa, root_limit: 400 MPa }
oil: { viscosity: 46 mm²/s, density: 870 kg/m³, bulk_modulus: 1.4 GPa, turbulence: { factor: 0.3, exponent: 0.25 } }
gaps: { satellites: 10 µm, rotor: 12 µm, rotor_bore: 10 mm }
friction: 0.05..0.1
ports: { part: 0.8, discharge: 0.7 }
";

    const DRIVE: &str = "\
power: 30 kW
speed: 1450 rpm
ratio: 5
gear_set: { module: 5 mm, face_width: 50 mm, sun_bore: 30 mm, planet_bore: 50 mm }
";

    type Case = (&'static str, &'static str, &'static str, &'static str);

    /// Right text, wrong text, key and name of the fault.
    const VALUES: [Case; 26] = [
        ("rotor: 3", "rotor: 5", "rotor", "lobes-not-more"),
        ("z3: 55", "z3: 54", "z3", "teeth-per-lobe"),
        ("module: 2 mm", "module: 0 mm", "module", "not-positive"),
        ("l: 80 mm", "part: 2", "part", "out-of-range"),
        ("l: 80 mm", "l: 80 mm\nsecond_harmonic: 0.1", "second_harmonic", "second-harmonic"),
        ("width: 40 mm", "width: 40 km", "width", "out-of-range"),
        ("pressure: 20 MPa", "pressure: 0 MPa", "pressure", "pressure-drop"),
        ("speed: 100 rpm", "speed: -100 rpm", "speed", "rotor-speed"),
        ("25 deg", "50 deg", "teeth.pressure_angle", "out-of-range"),
        ("addendum: 0.85", "addendum: 3", "teeth.addendum", "out-of-range"),
        ("clearance: 0.25", "clearance: 2", "teeth.clearance", "out-of-range"),
        ("backlash: 0.04", "backlash: 1", "teeth.backlash", "out-of-range"),
        ("fillet: 0.1", "fillet: -1", "teeth.fillet", "out-of-range"),
        ("206 GPa", "0 GPa", "material.youngs_modulus", "not-positive"),
        ("ratio: 0.3", "ratio: 0.6", "material.poissons_ratio", "out-of-range"),
        ("contact_limit: 2 GPa", "contact_limit: 0 GPa", "material.contact_limit", "not-positive"),
        ("root_limit: 400 MPa", "root_limit: -1 MPa", "material.root_limit", "not-positive"),
        ("viscosity: 46", "viscosity: -46", "oil.viscosity", "not-positive"),
        ("bulk_modulus: 1.4", "bulk_modulus: 0", "oil.bulk_modulus", "not-positive"),
        ("factor: 0.3", "factor: 0", "oil.turbulence.factor", "not-positive"),
        ("exponent: 0.25", "exponent: 2", "oil.turbulence.exponent", "out-of-range"),
        ("satellites: 10", "satellites: -10", "gaps.satellites", "out-of-range"),
        ("rotor: 12", "rotor: -12", "gaps.rotor", "out-of-range"),
        ("0.05..0.1", "2", "friction", "out-of-range"),
        ("part: 0.8, ", "", "ports", "motor-key"),
        ("discharge: 0.7", "discharge: 7", "ports.discharge", "out-of-range"),
    ];

    const OF_A_MOTOR: [Case; 2] = [
        ("bore: 10 mm", "bore: 1 m", "gaps.rotor_bore", "out-of-range"),
        ("part: 0.8", "part: 3", "ports", "out-of-range"),
    ];

    const OF_A_DRIVE: [Case; 2] = [
        ("sun_bore: 30 mm", "sun_bore: 3 m", "gear_set.sun_bore", "bore-too-large"),
        ("planet_bore: 50 mm", "planet_bore: 5 m", "gear_set.planet_bore", "bore-too-large"),
    ];

    /// Puts faults in alone and in pairs: exactly those are found, at their keys.
    fn are_found_together(text: &str, cases: &[Case], read: fn(&Document) -> Result<(), Error>) {
        let faults = |text: &str| match read(&Document::parse_one("x.yaml", text.as_bytes()).unwrap()) {
            Ok(()) => vec![],
            Err(Error::Document(error)) => {
                let mut found: Vec<_> = error
                    .faults()
                    .map(|fault| (fault.at.path.to_string(), fault.problem.name().to_owned()))
                    .collect();
                found.sort();
                found
            }
            Err(error) => panic!("{error}"),
        };
        assert_eq!(faults(text), []);
        for one in cases {
            for other in cases {
                let with_one = text.replacen(one.0, one.1, 1);
                assert_ne!(with_one, text, "{}", one.0);
                let mut expected = vec![(one.2.to_owned(), one.3.to_owned())];
                if one == other {
                    assert_eq!(faults(&with_one), expected, "{with_one}");
                } else if text.replacen(one.0, "", 1).contains(other.0) {
                    expected.push((other.2.to_owned(), other.3.to_owned()));
                    expected.sort();
                    let with_both = with_one.replacen(other.0, other.1, 1);
                    assert_eq!(faults(&with_both), expected, "{with_both}");
                }
            }
        }
    }

    #[test]
    fn independent_faults_of_a_motor_are_found_together() {
        let read = |document: &Document| motor::of_file(document).map(drop);
        are_found_together(MOTOR, &VALUES, read);
        are_found_together(MOTOR, &OF_A_MOTOR, read);
    }

    #[test]
    fn independent_faults_of_the_parts_of_a_drive_are_found_together() {
        are_found_together(DRIVE, &OF_A_DRIVE, |document| drive::of_file(document).map(drop));
    }
}
