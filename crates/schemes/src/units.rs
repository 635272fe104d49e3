//! Conversions between `uom` quantities and the SI numbers of the kernels: all of this crate's.

use uom::si::acceleration::meter_per_second_squared;
use uom::si::angle::{degree, radian};
use uom::si::angular_velocity::radian_per_second;
use uom::si::f64::{Acceleration, Angle, AngularVelocity, Force, Length, Velocity};
use uom::si::force::newton;
use uom::si::length::meter;
use uom::si::velocity::meter_per_second;

pub(crate) fn metres(length: Length) -> f64 {
    length.get::<meter>()
}

pub(crate) fn metres_per_second(speed: Velocity) -> f64 {
    speed.get::<meter_per_second>()
}

pub(crate) fn newtons(force: Force) -> f64 {
    force.get::<newton>()
}

pub(crate) fn rad_per_s(speed: AngularVelocity) -> f64 {
    speed.get::<radian_per_second>()
}

pub(crate) fn angular_velocity(omega_rad_s: f64) -> AngularVelocity {
    AngularVelocity::new::<radian_per_second>(omega_rad_s)
}

pub(crate) fn radians(angle: Angle) -> f64 {
    angle.get::<radian>()
}

pub(crate) fn degrees(angle: Angle) -> f64 {
    angle.get::<degree>()
}

pub(crate) fn m_per_s2(acceleration: Acceleration) -> f64 {
    acceleration.get::<meter_per_second_squared>()
}

pub(crate) fn acceleration(a_m_s2: f64) -> Acceleration {
    Acceleration::new::<meter_per_second_squared>(a_m_s2)
}
