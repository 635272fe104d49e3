//! Quantities in units of the module, as the kernels have them: lengths over `m`, areas over `m²`.

use uom::si::f64::{Area, Curvature, Length, Volume};

/// Length of a number of modules.
pub(crate) fn length(modules: f64, module: Length) -> Length {
    module * modules
}

/// Length in modules.
pub(crate) fn modules(value: Length, module: Length) -> f64 {
    (value / module).value
}

/// Area of a number of squared modules.
pub(crate) fn area(square_modules: f64, module: Length) -> Area {
    square_modules * module * module
}

/// A curvature of so much over the module.
pub(crate) fn curvature(per_module: f64, module: Length) -> Curvature {
    (per_module / module).into()
}

/// Volume of an area of a number of squared modules over a width.
pub(crate) fn volume(square_modules: f64, module: Length, width: Length) -> Volume {
    area(square_modules, module) * width
}
