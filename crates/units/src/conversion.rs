//! Every conversion between `uom` quantities and numbers: the only file that knows the units of `uom`.

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

/// Methods for values in other units than the SI's, with the factors of `uom`.
macro_rules! other_units {
    ($($quantity:ident in $unit:path: $get:ident, $new:ident;)*) => {$(
        #[doc = concat!("Value in the unit [`", stringify!($unit), "`].")]
        #[inline]
        fn $get(self) -> f64
        where
            Self: sealed::Is<si::$quantity>,
        {
            self.itself().get::<$unit>()
        }

        #[doc = concat!("Quantity from its value in the unit [`", stringify!($unit), "`].")]
        #[inline]
        #[must_use]
        fn $new(value: f64) -> Self
        where
            Self: sealed::Is<si::$quantity>,
        {
            Self::of(si::$quantity::new::<$unit>(value))
        }
    )*};
}

/// A `uom` quantity of one [`Dimension`], and its values as numbers. Only this crate implements it.
///
/// Besides the SI unit there are units of drawings and tables, each for one quantity.
///
/// ```
/// use epicyclic_units::Physical;
/// use uom::si::f64::Length;
///
/// let module = Length::from_mm(2.5);
/// assert_eq!((module.si(), module.mm()), (0.0025, 2.5));
/// ```
///
/// ```compile_fail
/// # use epicyclic_units::Physical;
/// # use uom::si::f64::Torque;
/// Torque::from_mm(2.5);
/// ```
pub trait Physical: Copy + sealed::Sealed {
    /// Dimension of the quantity.
    const DIMENSION: Dimension;

    /// Quantity from its value in the SI unit of the dimension.
    fn from_si(value: f64) -> Self;

    /// Value in the SI unit of the dimension.
    fn si(self) -> f64;

    other_units! {
        Angle in uom::si::angle::degree: degrees, from_degrees;
        AngularVelocity in uom::si::angular_velocity::revolution_per_minute: rpm, from_rpm;
        Area in uom::si::area::square_millimeter: mm2, from_mm2;
        KinematicViscosity in uom::si::kinematic_viscosity::square_millimeter_per_second: mm2_s, from_mm2_s;
        Length in uom::si::length::millimeter: mm, from_mm;
        Length in uom::si::length::micrometer: um, from_um;
        Power in uom::si::power::kilowatt: kw, from_kw;
        Pressure in uom::si::pressure::megapascal: mpa, from_mpa;
        Time in uom::si::time::hour: hours, from_hours;
        Volume in uom::si::volume::cubic_centimeter: cm3, from_cm3;
    }
}

mod sealed {
    pub trait Sealed {}

    /// Equality of two types: the condition on a method of one quantity.
    pub trait Is<T> {
        fn itself(self) -> T;
        fn of(value: T) -> Self;
    }

    impl<T> Is<T> for T {
        #[inline]
        fn itself(self) -> T {
            self
        }

        #[inline]
        fn of(value: T) -> T {
            value
        }
    }
}

macro_rules! physical {
    ($($quantity:ident in $unit:ident is $dimension:ident;)*) => {$(
        impl sealed::Sealed for si::$quantity {}

        impl Physical for si::$quantity {
            const DIMENSION: Dimension = Dimension::$dimension;

            #[inline]
            fn from_si(value: f64) -> Self {
                Self::new::<$unit>(value)
            }

            #[inline]
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

/// Torque per angle, for which `uom` has no quantity.
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

/// Module of teeth: a length that is also written as a diametral pitch.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct Module(si::Length);

impl Module {
    /// Length of the module.
    #[must_use]
    pub fn length(self) -> si::Length {
        self.0
    }
}

impl sealed::Sealed for Module {}

impl Physical for Module {
    const DIMENSION: Dimension = Dimension::Module;

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
