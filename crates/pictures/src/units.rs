//! Millimetres and radians of `uom` quantities; no other file of the crate converts.

use uom::si::angle::{degree, radian};
use uom::si::area::square_millimeter;
use uom::si::f64::{Angle, Area, Force, Length};
use uom::si::force::newton;
use uom::si::length::millimeter;

pub(crate) fn mm(value: Length) -> f64 {
    value.get::<millimeter>()
}

pub(crate) fn of_mm(value_mm: f64) -> Length {
    Length::new::<millimeter>(value_mm)
}

pub(crate) fn mm2(value: Area) -> f64 {
    value.get::<square_millimeter>()
}

pub(crate) fn rad(value: Angle) -> f64 {
    value.get::<radian>()
}

pub(crate) fn deg(value: Angle) -> f64 {
    value.get::<degree>()
}

pub(crate) fn newtons(value: Force) -> f64 {
    value.get::<newton>()
}
