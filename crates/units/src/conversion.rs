//! Every conversion between written quantities and `uom` types: the only file that knows both.

use uom::si::{
    angle::radian, angular_acceleration::radian_per_second_squared, angular_velocity::radian_per_second,
    area::square_meter, dynamic_viscosity::pascal_second, energy::joule, f64 as si, force::newton,
    frequency::hertz, heat_capacity::joule_per_kelvin, heat_flux_density::watt_per_square_meter,
    kinematic_viscosity::square_meter_per_second, length::meter, mass::kilogram,
    mass_density::kilogram_per_cubic_meter, moment_of_inertia::kilogram_square_meter, power::watt,
    pressure::pascal, radiant_exposure::joule_per_square_meter, ratio::ratio,
    surface_tension::newton_per_meter, temperature_coefficient::per_kelvin, temperature_interval::kelvin,
    thermal_conductance::watt_per_kelvin, time::second, torque::newton_meter, velocity::meter_per_second,
    volume::cubic_meter, volume_rate::cubic_meter_per_second,
};

use super::dimension::Dimension;

/// A `uom` quantity of one [`Dimension`]. Only this crate implements it.
pub trait Physical: Copy + sealed::Sealed {
    /// What it is a quantity of.
    const DIMENSION: Dimension;

    /// From its value in the SI unit of the dimension.
    fn from_si(value: f64) -> Self;

    /// Its value in the SI unit of the dimension.
    fn si(self) -> f64;
}

mod sealed {
    pub trait Sealed {}
}

macro_rules! physical {
    ($($quantity:ident in $unit:ident is $dimension:ident;)*) => {$(
        impl sealed::Sealed for si::$quantity {}

        impl Physical for si::$quantity {
            const DIMENSION: Dimension = Dimension::$dimension;

            fn from_si(value: f64) -> Self {
                Self::new::<$unit>(value)
            }

            fn si(self) -> f64 {
                self.get::<$unit>()
            }
        }
    )*};
}

physical! {
    Ratio in ratio is Dimensionless;
    Length in meter is Length;
    Area in square_meter is Area;
    Volume in cubic_meter is Volume;
    VolumeRate in cubic_meter_per_second is VolumeRate;
    Mass in kilogram is Mass;
    MassDensity in kilogram_per_cubic_meter is Density;
    MomentOfInertia in kilogram_square_meter is Inertia;
    Velocity in meter_per_second is Speed;
    AngularVelocity in radian_per_second is AngularSpeed;
    AngularAcceleration in radian_per_second_squared is AngularAcceleration;
    Angle in radian is Angle;
    Frequency in hertz is Frequency;
    Force in newton is Force;
    SurfaceTension in newton_per_meter is Stiffness;
    Torque in newton_meter is Torque;
    Power in watt is Power;
    Pressure in pascal is Pressure;
    KinematicViscosity in square_meter_per_second is Viscosity;
    DynamicViscosity in pascal_second is DynamicViscosity;
    Energy in joule is Energy;
    Time in second is Time;
    TemperatureInterval in kelvin is TemperatureDifference;
    TemperatureCoefficient in per_kelvin is ThermalExpansion;
    HeatCapacity in joule_per_kelvin is HeatCapacity;
    ThermalConductance in watt_per_kelvin is ThermalConductance;
    HeatFluxDensity in watt_per_square_meter is PowerPerArea;
    RadiantExposure in joule_per_square_meter is EnergyPerArea;
}

/// A torque per angle, of which `uom` has no quantity of its own.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TorsionalStiffness(si::Torque);

impl TorsionalStiffness {
    /// The torque at one radian.
    #[must_use]
    pub fn per_radian(self) -> si::Torque {
        self.0
    }
}

impl sealed::Sealed for TorsionalStiffness {}

impl Physical for TorsionalStiffness {
    const DIMENSION: Dimension = Dimension::TorsionalStiffness;

    fn from_si(value: f64) -> Self {
        Self(Physical::from_si(value))
    }

    fn si(self) -> f64 {
        self.0.si()
    }
}

#[cfg(test)]
mod tests {
    use uom::si::{
        angular_velocity::revolution_per_minute, power::horsepower_metric, pressure::bar,
        torque::kilonewton_meter,
    };

    use super::*;

    // 1e-7: uom rounds the metric horsepower to seven digits; ours is exact.
    fn agrees(written: &str, si_value: f64) {
        let ours = crate::parse(written).unwrap().si();
        assert!((ours - si_value).abs() <= 1e-7 * si_value.abs(), "{written}: {ours} is not {si_value}");
    }

    #[test]
    fn our_factors_agree_with_those_of_uom() {
        agrees("1950 rpm", si::AngularVelocity::new::<revolution_per_minute>(1950.0).si());
        agrees("100 PS", si::Power::new::<horsepower_metric>(100.0).si());
        agrees("1.2 kN·m", si::Torque::new::<kilonewton_meter>(1.2).si());
        agrees("160 bar", si::Pressure::new::<bar>(160.0).si());
        agrees("3 kg·m²", si::MomentOfInertia::new::<kilogram_square_meter>(3.0).si());
        agrees(
            "7.85 g/cm3",
            si::MassDensity::new::<uom::si::mass_density::gram_per_cubic_centimeter>(7.85).si(),
        );
        agrees("36 km/h", si::Velocity::new::<uom::si::velocity::kilometer_per_hour>(36.0).si());
        agrees("12 deg", si::Angle::new::<uom::si::angle::degree>(12.0).si());
        agrees("63 l/min", si::VolumeRate::new::<uom::si::volume_rate::liter_per_minute>(63.0).si());
    }
}
