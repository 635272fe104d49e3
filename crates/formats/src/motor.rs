//! The file that describes a hydromotor with non-circular wheels: `epicyclic report motor.yaml`.
//!
//! ```yaml
//! title: Water motor 5×3
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
//! The numbers and the module are needed. The keys are the options of `epicyclic motor`.

mod made;

pub use made::{GapsGroup, Keys, MaterialGroup, OilGroup, PortGroup, PortsGroup, TurbulenceGroup};

use epicyclic_hydromotor::closure::Family;
use epicyclic_hydromotor::place::Place;
use epicyclic_hydromotor::profile::{self, ToothForm};
use epicyclic_hydromotor::quantity::{Quantity as Of, WheelKind};
use epicyclic_hydromotor::{Error as MotorError, Motor, MotorNumbers, machine, ranges};
use schemars::JsonSchema;
use serde::Deserialize;
use uom::si::f64::{Angle, AngularVelocity, Length, Pressure};

use crate::faults::Faults;
use crate::{Document, Error, FileKind, Path, Problem, Span};
use epicyclic_units::{Module, Number, Quantity};

/// A hydromotor: a ring with arches, a sun with lobes, floating satellites.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MotorFile {
    /// Purpose of the motor; the title of its page.
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
    #[serde(deserialize_with = "crate::module::one")]
    #[schemars(with = "Quantity<Module>")]
    pub module: Quantity<Length>,
    /// How the wheels are shaped. Default `arcs`.
    pub law: Option<Law>,
    /// `l`: distance of the centre of a trough's arc from the axis. Default: the middle of the family.
    pub l: Option<Quantity<Length>>,
    /// `a`: distance of the centre of a crest's arc from the axis, in place of `l`.
    pub a: Option<Quantity<Length>>,
    /// Part of the family, from 0, where the arcs of the troughs vanish, to 1, even in 1/l; in place of `l`.
    pub part: Option<Number>,
    /// `ε₂`: relative amplitude of a second harmonic of a rotor by the cosine law. Default 0.
    pub second_harmonic: Option<Number>,
    /// Width of the wheels. Without it volumes, torques and flows are per width.
    pub width: Option<Quantity<Length>>,
    /// Pressure difference between the ports.
    pub pressure: Option<Quantity<Pressure>>,
    /// Speed of the rotor.
    pub speed: Option<Quantity<AngularVelocity>>,
    /// Angle of the rotor in the drawings, from where one of its crests faces one of the stator's. Default 0.
    pub angle: Option<Quantity<Angle>>,
    /// Form of the teeth. Default: one that keeps every limit of usual motors.
    pub teeth: Option<TeethForm>,
    /// Material of all teeth. Default: steel, without limits.
    pub material: Option<MaterialGroup>,
    /// The fluid.
    pub oil: Option<OilGroup>,
    /// Gaps at the end faces, for the leaks.
    pub gaps: Option<GapsGroup>,
    /// Coefficient of friction of the flanks: one number, or a range `0.05..0.1` from the least to the
    /// greatest.
    pub friction: Option<Span<f64>>,
    /// Ports as made. Default: ideal ones.
    pub ports: Option<PortsGroup>,
}

/// Form of the teeth; lengths in modules.
#[derive(Debug, Clone, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TeethForm {
    /// Pressure angle of the satellites. Default 25 deg.
    pub pressure_angle: Option<Quantity<Angle>>,
    /// Addendum `h_a*`. Default 0.85.
    pub addendum: Option<Number>,
    /// Clearance `c*` of tips over roots. Default 0.25.
    pub clearance: Option<Number>,
    /// Profile shift `x` of the satellites; the wheels have −x. Default 0.2.
    pub shift: Option<Number>,
    /// Backlash `j*` along the pitch curves. Default 0.04.
    pub backlash: Option<Number>,
    /// Radius `ρ*` of the rounded tips of the cutters. Default 0.1.
    pub fillet: Option<Number>,
    /// Middle of the stator's crests. Default `space`.
    pub crest: Option<Crest>,
}

/// Middle of the stator's crests.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Crest {
    /// The middle of a space.
    Space,
    /// The middle of a tooth.
    Tooth,
}

impl TeethForm {
    /// The form, with the defaults of what is not given.
    #[must_use]
    pub fn form(&self) -> ToothForm {
        let usual = ToothForm::default();
        let number = |given: Option<Number>, usual: f64| given.map_or(usual, Number::get);
        ToothForm {
            pressure_angle: self.pressure_angle.map_or(usual.pressure_angle, |angle| angle.0),
            addendum: number(self.addendum, usual.addendum),
            clearance: number(self.clearance, usual.clearance),
            shift: number(self.shift, usual.shift),
            backlash: number(self.backlash, usual.backlash),
            fillet: number(self.fillet, usual.fillet),
            crest: match self.crest {
                Some(Crest::Space) => profile::Crest::Space,
                Some(Crest::Tooth) => profile::Crest::Tooth,
                None => usual.crest,
            },
            ..usual
        }
    }
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
    /// The file in a document.
    ///
    /// # Errors
    /// Another kind of file; all faults of its values.
    pub fn of(document: &Document) -> Result<Self, Error> {
        document.must_be(FileKind::Motor)?;
        document.read()
    }

    /// The motor, and the family that it is of; a cosine-law motor has none.
    ///
    /// # Errors
    /// All independent faults: those of [`MotorNumbers::all_faults`], a module that no machine has, keys that
    /// do not go together; without these the one of [`Place::motor`].
    pub fn motor(&self) -> Result<(Motor, Option<Family>), Faults> {
        let mut faults = self.in_conflict();
        let is_cosine = self.law == Some(Law::Cosine);
        let part = self.part.filter(|_| !is_cosine).and_then(|part| ranges::family_part(part.get()).err());
        let mut errors = MotorNumbers::all_faults(self.stator, self.rotor, self.z3, self.zs);
        errors.extend(machine::module(self.module.0).err());
        errors.extend(part);
        if faults.is_empty() && errors.is_empty() {
            let numbers = MotorNumbers::new(self.stator, self.rotor, self.z3, self.zs);
            match numbers.and_then(|numbers| self.place().motor(numbers, self.module.0)) {
                Ok(motor) => return Ok(motor),
                Err(error) => errors.push(error),
            }
        }
        for error in errors {
            faults.add(place(&error), error);
        }
        Err(faults)
    }

    /// Place of the motor in the family of motors with the same numbers.
    #[must_use]
    pub fn place(&self) -> Place {
        if self.law == Some(Law::Cosine) {
            return self
                .second_harmonic
                .map_or(Place::CosineLaw, |second| Place::SecondHarmonic(second.get()));
        }
        match (self.l, self.a, self.part) {
            (Some(l), ..) => Place::TroughDistance(l.0),
            (_, Some(a), _) => Place::CrestDistance(a.0),
            (.., Some(part)) => Place::Part(part.get()),
            _ => Place::Middle,
        }
    }

    /// Keys that do not go together.
    fn in_conflict(&self) -> Faults {
        let mut faults = Faults::default();
        let is_cosine = self.law == Some(Law::Cosine);
        if self.second_harmonic.is_some() && !is_cosine {
            let reason = "it is of a rotor by the cosine law: give law: cosine, too";
            faults.push("second_harmonic", Problem::refused("second-harmonic", reason));
        }
        let mut places = self.place_keys();
        match (places.next(), places.next()) {
            (Some(key), _) if is_cosine => {
                let reason = "a cosine-law motor has no family: its numbers settle it; leave it out";
                faults.push(key, Problem::refused("cosine-family", reason));
            }
            (Some(key), Some(_)) => {
                let reason = "one of l, a and part says which motor of the family is meant; give one";
                faults.push(key, Problem::refused("several-places", reason));
            }
            _ => {}
        }
        faults
    }

    /// Data besides the geometry.
    #[must_use]
    pub fn made(&self) -> Keys {
        Keys {
            material: self.material.clone(),
            oil: self.oil.clone(),
            gaps: self.gaps.clone(),
            friction: self.friction,
            ports: self.ports.clone(),
        }
    }

    fn place_keys(&self) -> impl Iterator<Item = &'static str> {
        let given = [("l", self.l.is_some()), ("a", self.a.is_some()), ("part", self.part.is_some())];
        given.into_iter().filter_map(|(key, is_given)| is_given.then_some(key))
    }
}

/// The file and its motor.
///
/// # Errors
/// All independent faults of the file, and what makes no motor, at the keys that would change it.
///
/// ```
/// use epicyclic_formats::{Document, motor};
///
/// let text = b"stator: 5\nrotor: 3\nz3: 55\nzs: 10\nmodule: 2 mm\nl: 10 mm\n";
/// let error = motor::read(&Document::parse_one("motor.yaml", text)?).unwrap_err();
/// assert!(error.to_string().starts_with("motor.yaml:6:4: l: l = 10 mm: a motor of these numbers closes for l from "));
/// # Ok::<(), epicyclic_formats::Error>(())
/// ```
pub fn read(document: &Document) -> Result<(MotorFile, Motor, Option<Family>), Error> {
    let file = MotorFile::of(document)?;
    let (motor, family) = file.motor().map_err(|faults| faults.placed(document, &Path::root()))?;
    Ok((file, motor, family))
}

/// The key that a refusal of the numbers is about; the root where it is about all of them.
#[must_use]
pub fn place(error: &MotorError) -> Path {
    let of_wheel = |wheel: &WheelKind, stator, rotor, satellite| match wheel {
        WheelKind::Stator => stator,
        WheelKind::Rotor => rotor,
        _ => satellite,
    };
    let key = match error {
        MotorError::NoLobes { wheel } => of_wheel(wheel, "stator", "rotor", ""),
        MotorError::LobesNotMore { .. } | MotorError::LobesTooDifferent { .. } => "rotor",
        MotorError::NoTeeth { wheel }
        | MotorError::TooManyTeeth { wheel, .. }
        | MotorError::TeethPerLobe { wheel, .. } => of_wheel(wheel, "z3", "z3", "zs"),
        MotorError::SatelliteTooLarge { .. }
        | MotorError::NoFamily { .. }
        | MotorError::NoCosineRotor { .. }
        | MotorError::NoSecondHarmonicRotor { .. }
        | MotorError::NoArcs { .. }
        | MotorError::RotorInStator { .. }
        | MotorError::NoChamber { .. } => "zs",
        MotorError::TeethPerLobeDiffer { .. } => "z3",
        MotorError::FilletTooLarge { .. } => "teeth.fillet",
        MotorError::PointedTip { .. }
        | MotorError::NoTip { .. }
        | MotorError::NoFlank { .. }
        | MotorError::OutOfRange {
            quantity: Of::SatelliteTooth | Of::WheelTooth | Of::SatelliteDedendum,
            ..
        } => "teeth",
        MotorError::OutsideHarmonic { .. } => "second_harmonic",
        MotorError::OutsideFamily { .. } => "l",
        MotorError::OutsideFamilyByCrest { .. } => "a",
        MotorError::CannotHold { .. } => "teeth.pressure_angle",
        MotorError::PortOutside { .. }
        | MotorError::PortsOverlap
        | MotorError::SteepCentrode { .. }
        | MotorError::SatelliteAcrossRay { .. }
        | MotorError::SatelliteInWheel { .. }
        | MotorError::PortNeverOpens { .. }
        | MotorError::PortNeverCloses { .. }
        | MotorError::NoOpening { .. } => "ports",
        MotorError::NotLaminar { wheel, .. } => of_wheel(wheel, "gaps", "gaps.rotor", "gaps.satellites"),
        MotorError::PlayClosed { .. } => "gaps.temperature_rise",
        MotorError::NotPositive { quantity, .. }
        | MotorError::NotFinite { quantity, .. }
        | MotorError::OutOfRange { quantity, .. } => of_quantity(*quantity),
        _ => "",
    };
    Path::dotted(key)
}

/// The key of a quantity.
fn of_quantity(quantity: Of) -> &'static str {
    match quantity {
        Of::Module => "module",
        Of::TroughDistance => "l",
        Of::CrestDistance => "a",
        Of::FamilyPart => "part",
        Of::SecondAmplitude => "second_harmonic",
        Of::Width => "width",
        Of::PressureDrop | Of::HighPressure => "pressure",
        Of::Speed => "speed",
        Of::Rotation => "angle",
        Of::PressureAngle => "teeth.pressure_angle",
        Of::Addendum => "teeth.addendum",
        Of::Clearance => "teeth.clearance",
        Of::ProfileShift => "teeth.shift",
        Of::Backlash => "teeth.backlash",
        Of::Fillet => "teeth.fillet",
        Of::ElasticModulus | Of::ContactModulus => "material.youngs_modulus",
        Of::PoissonRatio => "material.poissons_ratio",
        Of::ContactLimit => "material.contact_limit",
        Of::RootLimit => "material.root_limit",
        Of::Viscosity => "oil.viscosity",
        Of::Density => "oil.density",
        Of::BulkModulus => "oil.bulk_modulus",
        Of::TurbulentFactor => "oil.turbulence.factor",
        Of::TurbulentExponent => "oil.turbulence.exponent",
        Of::SatelliteGap => "gaps.satellites",
        Of::RotorGap => "gaps.rotor",
        Of::AxialPlay => "gaps",
        Of::BoreRadius => "gaps.rotor_bore",
        Of::Expansion => "gaps.expansion",
        Of::TemperatureDifference => "gaps.temperature_rise",
        Of::FrictionCoefficient => "friction",
        Of::HoleDiameter
        | Of::PitchCircleRadius
        | Of::PortAngle
        | Of::KidneyInnerRadius
        | Of::KidneyOuterRadius
        | Of::KidneySpan
        | Of::KidneyCorner => "ports",
        Of::DeadArea => "ports.dead_volume",
        Of::DischargeCoefficient => "ports.discharge",
        _ => "",
    }
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
            ("part: 2", "motor.yaml:6:7: part: part of the family is 2; it must lie between 0 and 1"),
            ("a: 1 mm", "motor.yaml:6:4: a: a = 1 mm: a motor of these numbers closes for a from "),
            ("law: cosines", "motor.yaml:6:6: law: "),
        ] {
            let refusal = refusal(change);
            assert!(refusal.starts_with(start), "{refusal}");
        }
    }
}
