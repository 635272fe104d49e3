//! Conversions between `uom` quantities and the SI numbers of the kernels: all of this crate's.

use uom::si::angle::radian;
use uom::si::angular_acceleration::radian_per_second_squared;
use uom::si::angular_velocity::radian_per_second;
use uom::si::energy::joule;
use uom::si::f64::{
    Angle, AngularAcceleration, AngularVelocity, Energy, Length, Mass, MomentOfInertia, Power, Time, Torque,
};
use uom::si::length::meter;
use uom::si::mass::kilogram;
use uom::si::moment_of_inertia::kilogram_square_meter;
use uom::si::power::watt;
use uom::si::time::second;
use uom::si::torque::newton_meter;

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
    Angle, radian: radians, angle;
    AngularAcceleration, radian_per_second_squared: rad_per_s2, angular_acceleration;
    AngularVelocity, radian_per_second: rad_per_s, angular_velocity;
    Energy, joule: joules, energy;
    Length, meter: meters, length;
    Mass, kilogram: kilograms, mass;
    MomentOfInertia, kilogram_square_meter: kg_m2, inertia;
    Power, watt: watts, power;
    Time, second: seconds, time;
    Torque, newton_meter: n_m, torque;
}
