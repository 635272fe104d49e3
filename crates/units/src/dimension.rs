//! The kinds of quantity an engineer writes, by name.

use std::fmt;

/// Dimension of a quantity, in the sense of this crate.
///
/// Torque and energy have the same base units but are different things here: `520 N·m` is a torque, `520 J`
/// an energy. Of temperatures there are differences only, since their units have no offsets.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Dimension {
    /// A plain ratio: `0.977`, `97.7 %`.
    Dimensionless,
    /// SI unit: m.
    Length,
    /// Module of teeth: a length, or a diametral pitch. SI unit: m.
    Module,
    /// SI unit: m².
    Area,
    /// SI unit: m³.
    Volume,
    /// Volume per time. SI unit: m³/s.
    VolumeRate,
    /// SI unit: kg.
    Mass,
    /// Mass per volume. SI unit: kg/m³.
    Density,
    /// Mass moment of inertia. SI unit: kg·m².
    Inertia,
    /// Speed along a line. SI unit: m/s.
    Speed,
    /// SI unit: rad/s.
    AngularSpeed,
    /// SI unit: rad/s².
    AngularAcceleration,
    /// SI unit: rad.
    Angle,
    /// Cycles per time. SI unit: Hz. Not an angular speed.
    Frequency,
    /// SI unit: N.
    Force,
    /// Force per length that a spring is bent. SI unit: N/m.
    Stiffness,
    /// SI unit: N·m.
    Torque,
    /// Torque per angle that a shaft is twisted. SI unit: N·m/rad.
    TorsionalStiffness,
    /// SI unit: W.
    Power,
    /// Pressure and stress. SI unit: Pa.
    Pressure,
    /// Kinematic viscosity of an oil. SI unit: m²/s.
    Viscosity,
    /// Dynamic viscosity of an oil. SI unit: Pa·s.
    DynamicViscosity,
    /// SI unit: J.
    Energy,
    /// SI unit: s.
    Time,
    /// A difference of temperatures. SI unit: K.
    TemperatureDifference,
    /// Change of a length, relative, over a difference of temperatures. SI unit: 1/K.
    ThermalExpansion,
    /// SI unit: J/K.
    HeatCapacity,
    /// Heat flow over a difference of temperatures. SI unit: W/K.
    ThermalConductance,
    /// Power over an area. SI unit: W/m².
    PowerPerArea,
    /// Energy over an area. SI unit: J/m².
    EnergyPerArea,
}

impl Dimension {
    /// Every dimension, in the order of the enum.
    pub const ALL: [Self; 30] = [
        Self::Dimensionless,
        Self::Length,
        Self::Module,
        Self::Area,
        Self::Volume,
        Self::VolumeRate,
        Self::Mass,
        Self::Density,
        Self::Inertia,
        Self::Speed,
        Self::AngularSpeed,
        Self::AngularAcceleration,
        Self::Angle,
        Self::Frequency,
        Self::Force,
        Self::Stiffness,
        Self::Torque,
        Self::TorsionalStiffness,
        Self::Power,
        Self::Pressure,
        Self::Viscosity,
        Self::DynamicViscosity,
        Self::Energy,
        Self::Time,
        Self::TemperatureDifference,
        Self::ThermalExpansion,
        Self::HeatCapacity,
        Self::ThermalConductance,
        Self::PowerPerArea,
        Self::EnergyPerArea,
    ];

    /// Name in a sentence: `torque`, `moment of inertia`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Dimensionless => "plain number",
            Self::Length => "length",
            Self::Module => "module",
            Self::Area => "area",
            Self::Volume => "volume",
            Self::VolumeRate => "volume rate",
            Self::Mass => "mass",
            Self::Density => "density",
            Self::Inertia => "moment of inertia",
            Self::Speed => "speed",
            Self::AngularSpeed => "angular speed",
            Self::AngularAcceleration => "angular acceleration",
            Self::Angle => "angle",
            Self::Frequency => "frequency",
            Self::Force => "force",
            Self::Stiffness => "stiffness",
            Self::Torque => "torque",
            Self::TorsionalStiffness => "torsional stiffness",
            Self::Power => "power",
            Self::Pressure => "pressure",
            Self::Viscosity => "kinematic viscosity",
            Self::DynamicViscosity => "dynamic viscosity",
            Self::Energy => "energy",
            Self::Time => "time",
            Self::TemperatureDifference => "temperature difference",
            Self::ThermalExpansion => "thermal expansion",
            Self::HeatCapacity => "heat capacity",
            Self::ThermalConductance => "thermal conductance",
            Self::PowerPerArea => "power per area",
            Self::EnergyPerArea => "energy per area",
        }
    }

    /// The largest size of a quantity that is read, in the SI unit; a plain number has it too.
    ///
    /// Far beyond any machine, and so far below what a double holds that products of several stay finite.
    #[must_use]
    pub const fn largest(self) -> f64 {
        match self {
            Self::Length
            | Self::Module
            | Self::AngularSpeed
            | Self::Speed
            | Self::Angle
            | Self::VolumeRate
            | Self::Viscosity
            | Self::DynamicViscosity
            | Self::ThermalExpansion
            | Self::Density
            | Self::TemperatureDifference => 1e6,
            Self::Area
            | Self::Volume
            | Self::Mass
            | Self::AngularAcceleration
            | Self::Frequency
            | Self::Force
            | Self::Time
            | Self::HeatCapacity
            | Self::ThermalConductance => 1e9,
            Self::Dimensionless
            | Self::Inertia
            | Self::Stiffness
            | Self::Torque
            | Self::TorsionalStiffness
            | Self::Power
            | Self::Pressure => 1e12,
            Self::Energy | Self::PowerPerArea | Self::EnergyPerArea => 1e15,
        }
    }
}

impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
