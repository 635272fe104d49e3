//! Conversions to units other than the SI's, which [`Physical`](epicyclic_units::Physical) has.

use uom::si::angular_velocity::{radian_per_second, revolution_per_minute};
use uom::si::f64::{AngularVelocity, Frequency, Length, Time};
use uom::si::frequency::hertz;
use uom::si::length::millimeter;
use uom::si::time::hour;

pub(crate) fn millimetres(length: Length) -> f64 {
    length.get::<millimeter>()
}

pub(crate) fn rpm(speed: AngularVelocity) -> f64 {
    speed.get::<revolution_per_minute>()
}

pub(crate) fn hours(time: Time) -> f64 {
    time.get::<hour>()
}

pub(crate) fn of_millimetres(millimetres: f64) -> Length {
    Length::new::<millimeter>(millimetres)
}

/// The angular frequency of a frequency, `2π·f`.
pub(crate) fn per_second(frequency: Frequency) -> AngularVelocity {
    AngularVelocity::new::<radian_per_second>(std::f64::consts::TAU * frequency.get::<hertz>())
}
