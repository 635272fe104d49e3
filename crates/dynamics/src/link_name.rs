//! Names of the links of a drive and of their properties, as errors give them.

use std::fmt;

/// Name of a link.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum LinkName {
    /// The sun of a drive, with or without the motor.
    Sun,
    /// The rotor of the motor.
    Motor,
    /// The planets of a drive.
    Planets,
    /// The carrier of a drive, with or without the driven machine.
    Carrier,
    /// The driven machine.
    Machine,
    /// A single shaft.
    Shaft,
    /// A link of a gearbox, by its name.
    Named(String),
    /// The planets of a set of a gearbox, by the set's name.
    PlanetsOf(String),
}

impl From<&str> for LinkName {
    fn from(name: &str) -> Self {
        Self::Named(name.to_owned())
    }
}

impl fmt::Display for LinkName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Sun => "sun",
            Self::Motor => "motor",
            Self::Planets => "planets",
            Self::Carrier => "carrier",
            Self::Machine => "driven machine",
            Self::Shaft => "the shaft",
            Self::Named(name) => name,
            Self::PlanetsOf(set) => return write!(f, "planets of {set}"),
        })
    }
}

/// A property of a link that an error names.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Property {
    /// Mass.
    Mass,
    /// Inertia.
    Inertia,
    /// Radius of the circle of its centre.
    Radius,
    /// Speed over that of the driving shaft.
    SpeedRatio,
    /// Speed of its circling over that of the driving shaft.
    OrbitSpeedRatio,
    /// Torque on it.
    Torque,
}

impl fmt::Display for Property {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Mass => "mass",
            Self::Inertia => "inertia",
            Self::Radius => "radius",
            Self::SpeedRatio => "speed ratio",
            Self::OrbitSpeedRatio => "orbit's speed ratio",
            Self::Torque => "torque",
        })
    }
}
