//! Conversions to units other than the SI's, which [`Physical`](epicyclic_formats::Physical) has.

use uom::si::f64::Length;
use uom::si::length::millimeter;

pub(crate) fn millimetres(length: Length) -> f64 {
    length.get::<millimeter>()
}

pub(crate) fn of_millimetres(millimetres: f64) -> Length {
    Length::new::<millimeter>(millimetres)
}
