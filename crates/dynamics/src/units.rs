//! Conversions between `uom` quantities and the SI numbers of the kernels: all of this crate's.

use uom::si::angle::degree;
use uom::si::angular_acceleration::radian_per_second_squared;
use uom::si::angular_velocity::{radian_per_second, revolution_per_minute};
use uom::si::energy::joule;
use uom::si::f64::{
    Angle, AngularAcceleration, AngularVelocity, Energy, Force, Length, Mass, MassDensity, MomentOfInertia,
    Power, Pressure, Time, Torque, Velocity,
};
use uom::si::force::newton;
use uom::si::length::{meter, millimeter};
use uom::si::mass::kilogram;
use uom::si::mass_density::kilogram_per_cubic_meter;
use uom::si::moment_of_inertia::kilogram_square_meter;
use uom::si::power::{kilowatt, watt};
use uom::si::pressure::{megapascal, pascal};
use uom::si::time::second;
use uom::si::torque::newton_meter;
use uom::si::velocity::meter_per_second;

macro_rules! conversions {
    ($($quantity:ty, $unit:ty: $get:ident, $new:ident;)*) => {$(
        #[allow(dead_code, reason = "some are used by the tests alone")]
        pub(crate) fn $get(quantity: $quantity) -> f64 {
            quantity.get::<$unit>()
        }

        #[allow(dead_code, reason = "some are used by the tests alone")]
        pub(crate) fn $new(value: f64) -> $quantity {
            <$quantity>::new::<$unit>(value)
        }
    )*};
}

conversions! {
    AngularAcceleration, radian_per_second_squared: rad_per_s2, angular_acceleration;
    AngularVelocity, radian_per_second: rad_per_s, angular_velocity;
    Energy, joule: joules, energy;
    Force, newton: newtons, force;
    Length, meter: meters, length;
    Mass, kilogram: kilograms, mass;
    MomentOfInertia, kilogram_square_meter: kg_m2, inertia;
    Power, watt: watts, power;
    Time, second: seconds, time;
    Torque, newton_meter: n_m, torque;
    Velocity, meter_per_second: m_per_s, velocity;
}

pub(crate) fn degrees(angle: Angle) -> f64 {
    angle.get::<degree>()
}

pub(crate) fn millimeters(length: Length) -> f64 {
    length.get::<millimeter>()
}

pub(crate) fn kilowatts(power: Power) -> f64 {
    power.get::<kilowatt>()
}

pub(crate) fn rpm(speed: AngularVelocity) -> f64 {
    speed.get::<revolution_per_minute>()
}

pub(crate) fn pascals(pressure: Pressure) -> f64 {
    pressure.get::<pascal>()
}

pub(crate) fn megapascals(pressure: Pressure) -> f64 {
    pressure.get::<megapascal>()
}

pub(crate) fn stress(value_mpa: f64) -> Pressure {
    Pressure::new::<megapascal>(value_mpa)
}

pub(crate) fn density(value_kg_m3: f64) -> MassDensity {
    MassDensity::new::<kilogram_per_cubic_meter>(value_kg_m3)
}
