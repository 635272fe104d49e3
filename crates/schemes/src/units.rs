//! Conversions between `uom` quantities and the SI numbers of the kernels: all of this crate's.

use uom::si::angular_velocity::radian_per_second;
use uom::si::f64::{AngularVelocity, Power, Torque};
use uom::si::power::watt;
use uom::si::torque::newton_meter;

pub(crate) fn rad_per_s(speed: AngularVelocity) -> f64 {
    speed.get::<radian_per_second>()
}

pub(crate) fn angular_velocity(omega_rad_s: f64) -> AngularVelocity {
    AngularVelocity::new::<radian_per_second>(omega_rad_s)
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
