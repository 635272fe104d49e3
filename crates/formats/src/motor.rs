//! The file that describes a hydromotor with non-circular wheels: `epicyclic report motor.yaml`.
//!
//! ```yaml
//! title: Water motor 3x5
//! stator: 5
//! rotor: 3
//! z3: 55
//! zs: 10
//! module: 2 mm
//! l: 80 mm
//! width: 40 mm
//! pressure: 20 MPa
//! speed: 100 rpm
//! ```
//!
//! The first five are needed. The keys are the options of `epicyclic motor`.

use epicyclic_hydromotor::closure::Family;
use epicyclic_hydromotor::{Error as MotorError, Motor, MotorNumbers};
use schemars::JsonSchema;
use serde::Deserialize;
use uom::si::f64::{AngularVelocity, Length, Pressure};

use crate::{Document, Error, Path, Problem, Quantity};

/// A hydromotor: a ring with arches, a sun with lobes, floating satellites.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MotorFile {
    /// What the motor is for; the title of its page.
    pub title: Option<String>,
    /// `N`: arches of the stator.
    pub stator: u32,
    /// `n`: lobes of the rotor, one to three fewer.
    pub rotor: u32,
    /// `Z₃`: teeth of the stator, a multiple of its arches.
    pub z3: u32,
    /// `Z_s`: teeth of a satellite.
    pub zs: u32,
    /// Module.
    pub module: Quantity<Length>,
    /// How the wheels are shaped. Default `arcs`.
    pub law: Option<Law>,
    /// `l`: distance of the centre of a trough's arc from the axis. Default: the middle of the family.
    pub l: Option<Quantity<Length>>,
    /// Width of the wheels. Without it volumes, torques and flows are per width.
    pub width: Option<Quantity<Length>>,
    /// Pressure difference between the ports.
    pub pressure: Option<Quantity<Pressure>>,
    /// Speed of the rotor.
    pub speed: Option<Quantity<AngularVelocity>>,
}

/// How the wheels are shaped.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Law {
    /// The stator of two arcs, the rotor conjugate to it.
    Arcs,
    /// The rotor by a cosine law, the stator conjugate to it.
    Cosine,
}

impl MotorFile {
    /// The motor.
    ///
    /// # Errors
    /// As [`MotorNumbers::new`], [`Family::new`], [`Motor::of_two_arcs`] and [`Motor::of_cosine_law`].
    pub fn motor(&self) -> Result<Motor, MotorError> {
        let numbers = MotorNumbers::new(self.stator, self.rotor, self.z3, self.zs)?;
        let module = self.module.0;
        match (self.law.unwrap_or(Law::Arcs), self.l) {
            (Law::Cosine, _) => Motor::of_cosine_law(numbers, module),
            (Law::Arcs, Some(l)) => Motor::of_two_arcs(numbers, module, l.0),
            (Law::Arcs, None) => {
                let arcs = Family::new(numbers, module)?.at_part(0.5)?;
                Motor::of_two_arcs(numbers, module, arcs.trough_distance())
            }
        }
    }
}

/// The file and its motor.
///
/// # Errors
/// Faults of the file, and what makes no motor, at the key that would change it.
///
/// ```
/// use epicyclic_formats::{Document, motor};
///
/// let text = b"stator: 5\nrotor: 3\nz3: 55\nzs: 10\nmodule: 2 mm\nl: 10 mm\n";
/// let error = motor::read(&Document::parse_one("motor.yaml", text)?).unwrap_err();
/// assert!(error.to_string().starts_with("motor.yaml:6:4: l: l = 10 mm: a motor of these numbers closes for l from "));
/// # Ok::<(), epicyclic_formats::Error>(())
/// ```
pub fn read(document: &Document) -> Result<(MotorFile, Motor), Error> {
    let file: MotorFile = document.read()?;
    if file.law == Some(Law::Cosine) && file.l.is_some() {
        let message = "a cosine-law motor has no `l`: its numbers settle it; leave it out".to_owned();
        return Err(document.error(&Path::root().key("l"), Problem::Refused { message }));
    }
    let motor = file
        .motor()
        .map_err(|error| document.error(&place(&error), Problem::Refused { message: error.to_string() }))?;
    Ok((file, motor))
}

/// The key that a refusal of the numbers is about; the root where it is about all of them.
#[must_use]
pub fn place(error: &MotorError) -> Path {
    let of_wheel = |wheel: &str, stator, rotor, satellite| match wheel {
        "stator" => stator,
        "rotor" => rotor,
        _ => satellite,
    };
    let key = match error {
        MotorError::NoLobes { wheel } => of_wheel(wheel, "stator", "rotor", ""),
        MotorError::LobesNotMore { .. } | MotorError::LobesTooDifferent { .. } => "rotor",
        MotorError::NoTeeth { wheel }
        | MotorError::TooManyTeeth { wheel, .. }
        | MotorError::TeethPerLobe { wheel, .. } => of_wheel(wheel, "z3", "z3", "zs"),
        MotorError::SatelliteTooLarge { .. } | MotorError::NoFamily | MotorError::NoCosineRotor { .. } => {
            "zs"
        }
        MotorError::OutsideFamily { .. } => "l",
        MotorError::NotPositive { quantity, .. } | MotorError::NotFinite { quantity, .. } => {
            match *quantity {
                "module" => "module",
                "width" => "width",
                "pressure" => "pressure",
                "speed" => "speed",
                quantity if quantity.starts_with('l') => "l",
                _ => "",
            }
        }
        _ => "",
    };
    if key.is_empty() { Path::root() } else { Path::root().key(key) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn refusal(change: &str) -> String {
        let mut lines = vec!["stator: 5", "rotor: 3", "z3: 55", "zs: 10", "module: 2 mm"];
        let key = change.split(':').next().unwrap();
        lines.retain(|line| !line.starts_with(&format!("{key}:")));
        lines.push(change);
        let text = lines.join("\n") + "\n";
        read(&Document::parse_one("motor.yaml", text.as_bytes()).unwrap()).unwrap_err().to_string()
    }

    #[test]
    fn a_refusal_stands_at_its_key() {
        for (change, start) in [
            ("rotor: 5", "motor.yaml:5:8: rotor: 5 stator lobes on 5 rotor lobes: "),
            ("rotor: 1", "motor.yaml:5:8: rotor: 5 stator lobes on 1 rotor lobes: "),
            ("z3: 54", "motor.yaml:5:5: z3: 54 stator teeth on 5 lobes: "),
            ("zs: 11", "motor.yaml:5:5: zs: satellites of 11 teeth: "),
            ("zs: 0", "motor.yaml:5:5: zs: a satellite with 0 teeth"),
            ("module: 0 mm", "motor.yaml:5:9: module: module is 0 "),
            ("l: 1 mm", "motor.yaml:6:4: l: l = 1 mm: a motor of these numbers closes for l from "),
            ("law: cosines", "motor.yaml:6:6: law: "),
        ] {
            let refusal = refusal(change);
            assert!(refusal.starts_with(start), "{refusal}");
        }
    }
}
