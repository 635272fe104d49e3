//! Conversions to units other than the SI's, which [`Physical`](epicyclic_formats::Physical) has.

use uom::si::angular_velocity::revolution_per_minute;
use uom::si::f64::{AngularVelocity, Length, Time};
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
