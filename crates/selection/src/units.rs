//! Conversions between `uom` quantities and the SI numbers of the kernels: all of this crate's.

use uom::si::f64::{Length, Pressure, Torque};
use uom::si::length::meter;
use uom::si::torque::newton_meter;

pub(crate) fn n_m(torque: Torque) -> f64 {
    torque.get::<newton_meter>()
}

#[cfg(test)]
pub(crate) fn torque(torque_n_m: f64) -> Torque {
    Torque::new::<newton_meter>(torque_n_m)
}

pub(crate) fn pascal(pressure: Pressure) -> f64 {
    pressure.get::<uom::si::pressure::pascal>()
}

#[cfg(test)]
pub(crate) fn pressure(pressure_pa: f64) -> Pressure {
    Pressure::new::<uom::si::pressure::pascal>(pressure_pa)
}

pub(crate) fn metres(length_m: f64) -> Length {
    Length::new::<meter>(length_m)
}

pub(crate) fn in_metres(length: Length) -> f64 {
    length.get::<meter>()
}
