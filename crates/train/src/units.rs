//! Conversions between `uom` quantities and the SI numbers of the kernels: all of this crate's.

use uom::si::angular_velocity::radian_per_second;
use uom::si::f64::{Angle, AngularVelocity, Force, Length, Mass, MassDensity, Power, Torque};
use uom::si::length::meter;
use uom::si::power::watt;
use uom::si::torque::newton_meter;

pub(crate) fn rad_per_s(speed: AngularVelocity) -> f64 {
    speed.get::<radian_per_second>()
}

pub(crate) fn angular_velocity(omega_rad_s: f64) -> AngularVelocity {
    AngularVelocity::new::<radian_per_second>(omega_rad_s)
}

/// A speed as messages tell it, to a millionth.
pub(crate) fn rpm(speed: AngularVelocity) -> f64 {
    const MILLIONTHS: f64 = 1e6;
    let speed_rpm = speed.get::<uom::si::angular_velocity::revolution_per_minute>();
    let rounded = (speed_rpm * MILLIONTHS).round() / MILLIONTHS;
    if rounded.is_finite() { rounded } else { speed_rpm }
}

pub(crate) fn n_m(torque: Torque) -> f64 {
    torque.get::<newton_meter>()
}

pub(crate) fn torque(torque_n_m: f64) -> Torque {
    Torque::new::<newton_meter>(torque_n_m)
}

pub(crate) fn watts(power: Power) -> f64 {
    power.get::<watt>()
}

pub(crate) fn power(power_w: f64) -> Power {
    Power::new::<watt>(power_w)
}

pub(crate) fn metres(length_m: f64) -> Length {
    Length::new::<meter>(length_m)
}

pub(crate) fn in_metres(length: Length) -> f64 {
    length.get::<meter>()
}

pub(crate) fn in_degrees(angle: Angle) -> f64 {
    angle.get::<uom::si::angle::degree>()
}

pub(crate) fn degrees(angle_deg: f64) -> Angle {
    Angle::new::<uom::si::angle::degree>(angle_deg)
}

pub(crate) fn kg_per_m3(density_kg_m3: f64) -> MassDensity {
    MassDensity::new::<uom::si::mass_density::kilogram_per_cubic_meter>(density_kg_m3)
}

pub(crate) fn kilograms(mass: Mass) -> f64 {
    mass.get::<uom::si::mass::kilogram>()
}

pub(crate) fn angle(angle_rad: f64) -> Angle {
    Angle::new::<uom::si::angle::radian>(angle_rad)
}

pub(crate) fn radians(angle: Angle) -> f64 {
    angle.get::<uom::si::angle::radian>()
}

pub(crate) fn force(force_n: f64) -> Force {
    Force::new::<uom::si::force::newton>(force_n)
}
