//! Conversions of units: all of this crate's.

use uom::si::angular_velocity::{radian_per_second, revolution_per_minute};
use uom::si::f64::{AngularVelocity, Time};
use uom::si::time::{hour, minute, second};

/// A speed in the unit of drawings.
pub(crate) fn rpm(speed_rad_s: f64) -> f64 {
    AngularVelocity::new::<radian_per_second>(speed_rad_s).get::<revolution_per_minute>()
}

/// The frequency, Hz, of so many turns at a rpm.
pub(crate) fn hertz_of_rpm(turns: f64) -> f64 {
    turns / Time::new::<minute>(1.0).get::<second>()
}

/// A life in hours.
pub(crate) fn hours(seconds: f64) -> f64 {
    Time::new::<second>(seconds).get::<hour>()
}
