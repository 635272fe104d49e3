//! Millimetres and radians of `uom` quantities; no other file of the motors' pictures converts.

use uom::si::angle::{degree, radian};
use uom::si::area::square_millimeter;
use uom::si::f64::{Angle, Area, Length};
use uom::si::length::millimeter;

pub(super) fn mm(value: Length) -> f64 {
    value.get::<millimeter>()
}

pub(super) fn of_mm(value_mm: f64) -> Length {
    Length::new::<millimeter>(value_mm)
}

pub(super) fn mm2(value: Area) -> f64 {
    value.get::<square_millimeter>()
}

pub(super) fn rad(value: Angle) -> f64 {
    value.get::<radian>()
}

pub(super) fn deg(value: Angle) -> f64 {
    value.get::<degree>()
}
