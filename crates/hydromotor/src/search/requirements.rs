//! Requirements for a motor: displacement or torque, and the given part of its size.

use crate::quantity::Quantity;
use std::f64::consts::{PI, TAU};
use std::ops::RangeInclusive;

use epicyclic_units::Physical;
use uom::si::f64::{AngularVelocity, Length, Pressure, Torque, Volume};

use crate::Error;
use crate::machine::{self, MODULE_MM, WIDTH_MM};
use crate::ranges::{finite_speed, positive, positive_length};
use crate::tolerance::SLACK;

/// The first series of modules of ISO 54, in millimetres.
pub const PREFERRED_MODULES_MM: [f64; 18] =
    [1.0, 1.25, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0, 12.0, 16.0, 20.0, 25.0, 32.0, 40.0, 50.0];

/// Requirements for a motor.
#[derive(Debug, Clone, PartialEq)]
pub struct Requirements {
    /// Displacement a revolution of the rotor, `q`.
    pub displacement: Volume,
    /// High less low pressure, `Δp`: with it the answer has torques.
    pub pressure_drop: Option<Pressure>,
    /// Speed of the rotor: with it the answer has the flow, and with the pressure the power.
    pub speed: Option<AngularVelocity>,
    /// Given part of the size.
    pub size: Size,
}

impl Requirements {
    /// A motor of a displacement, with the default [`Size`].
    #[must_use]
    pub fn of_displacement(displacement: Volume) -> Self {
        Self { displacement, pressure_drop: None, speed: None, size: Size::default() }
    }

    /// A motor of a mean torque without losses, `q = 2π·M/Δp`, with the default [`Size`].
    ///
    /// # Errors
    /// [`Error::NotPositive`] for torque and pressure.
    ///
    /// # Example
    /// ```
    /// use epicyclic_hydromotor::search::Requirements;
    /// use uom::si::f64::{Pressure, Torque};
    /// use uom::si::{pressure::megapascal, torque::newton_meter, volume::cubic_centimeter};
    ///
    /// let torque = Torque::new::<newton_meter>(900.0);
    /// let requirements = Requirements::of_torque(torque, Pressure::new::<megapascal>(20.0))?;
    /// assert!((requirements.displacement.get::<cubic_centimeter>() - 282.743).abs() < 1e-3); // 2π·900/20
    /// # Ok::<(), epicyclic_hydromotor::Error>(())
    /// ```
    pub fn of_torque(torque: Torque, pressure_drop: Pressure) -> Result<Self, Error> {
        positive(Quantity::Torque, torque.si(), "N·m")?;
        positive(Quantity::PressureDrop, pressure_drop.mpa(), "MPa")?;
        let displacement = TAU * (torque / pressure_drop);
        Ok(Self { pressure_drop: Some(pressure_drop), ..Self::of_displacement(displacement) })
    }

    pub(super) fn checked(&self) -> Result<(), Error> {
        positive(Quantity::Displacement, self.displacement.cm3(), "cm³")?;
        positive(Quantity::Displacement, self.displacement.si(), "m³")?;
        if let Some(pressure) = self.pressure_drop {
            positive(Quantity::PressureDrop, pressure.mpa(), "MPa")?;
        }
        self.speed.map_or(Ok(()), |speed| finite_speed(speed).map(|_| ()))
    }
}

/// Given part of the size; the rest follows from `q = q̂·m²·b`, with `q̂` the displacement of module 1 and
/// width 1.
#[derive(Debug, Clone, PartialEq)]
pub enum Size {
    /// Modules to choose from; the width of each follows, `b = q/(q̂·m²)`.
    Modules(Vec<Length>),
    /// The width; the module follows, `m = √(q/(q̂·b))`, rarely a preferred one.
    Width(Length),
    /// Modules to choose from and the width: the displacement follows from them.
    ModulesAndWidth {
        /// The modules.
        modules: Vec<Length>,
        /// The width.
        width: Length,
        /// Tolerance of the displacement, relative.
        tolerance: f64,
    },
    /// Width over outer diameter; both follow, `m = ∛(q/(q̂·λ·D̂))`.
    WidthOverDiameter(f64),
}

impl Default for Size {
    /// The preferred modules.
    fn default() -> Self {
        Self::Modules(PREFERRED_MODULES_MM.iter().map(|mm| Length::from_si(mm / 1e3)).collect())
    }
}

/// Limits of the size.
#[derive(Debug, Clone, PartialEq)]
pub struct SizeLimits {
    /// Greatest diameter of the stator's centrode
    /// ([`Envelope::stator_outer`](crate::checks::Envelope::stator_outer)).
    pub outer_diameter: Option<Length>,
    /// Width.
    pub width: Option<RangeInclusive<Length>>,
    /// Width over that diameter; not asked of [`Size::WidthOverDiameter`].
    pub width_over_diameter: RangeInclusive<f64>,
}

impl Default for SizeLimits {
    /// Width from 0.1 to 1 of the diameter, else none: a plate or a rod would be the answer of some module.
    fn default() -> Self {
        Self { outer_diameter: None, width: None, width_over_diameter: 0.1..=1.0 }
    }
}

/// Requirements and limits of the size as numbers, SI.
#[derive(Debug, Clone)]
pub(super) struct Sizing {
    displacement: f64,
    choice: Choice,
    diameter: f64,
    width: [f64; 2],
    ratio: [f64; 2],
}

#[derive(Debug, Clone)]
enum Choice {
    Modules(Vec<f64>),
    Width(f64),
    Both { modules: Vec<f64>, width: f64, tolerance: f64 },
    Ratio(f64),
}

impl Sizing {
    pub(super) fn new(requirements: &Requirements, limits: &SizeLimits) -> Result<Self, Error> {
        requirements.checked()?;
        let modules = |modules: &[Length]| {
            if modules.is_empty() {
                return Err(Error::NoModules);
            }
            modules.iter().map(|&module| machine::module(module).map(Physical::si)).collect::<Result<_, _>>()
        };
        let mut ratio = [*limits.width_over_diameter.start(), *limits.width_over_diameter.end()];
        ordered(Quantity::WidthOverDiameter, ratio, "")?;
        let choice = match &requirements.size {
            Size::Modules(list) => Choice::Modules(modules(list)?),
            Size::Width(width) => Choice::Width(machine::width(*width)?.si()),
            Size::ModulesAndWidth { modules: list, width, tolerance } => {
                if !(*tolerance > 0.0 && *tolerance <= 1.0) {
                    let (quantity, value, unit) = (Quantity::DisplacementTolerance, *tolerance, "");
                    return Err(Error::OutOfRange { quantity, value, low: 0.0, high: 1.0, unit });
                }
                let width = machine::width(*width)?.si();
                Choice::Both { modules: modules(list)?, width, tolerance: *tolerance }
            }
            Size::WidthOverDiameter(part) => {
                ratio = [0.0, f64::INFINITY];
                Choice::Ratio(positive(Quantity::WidthOverDiameter, *part, "")?)
            }
        };
        let width = match &limits.width {
            Some(range) => {
                let ends = [*range.start(), *range.end()];
                ordered(Quantity::Width, ends.map(Physical::mm), "mm")?;
                ends.map(Physical::si)
            }
            None => [0.0, f64::INFINITY],
        };
        let diameter = match limits.outer_diameter {
            Some(diameter) => positive_length(Quantity::OuterDiameter, diameter)?.si(),
            None => f64::INFINITY,
        };
        Ok(Self { displacement: requirements.displacement.si(), choice, diameter, width, ratio })
    }

    /// Module and width of each choice, and how far they keep within the limits.
    fn choices(&self, displacement: f64, diameter: f64) -> impl Iterator<Item = ([f64; 2], f64)> + '_ {
        let wanted = self.displacement;
        let (modules, free): (&[f64], _) = match &self.choice {
            Choice::Modules(modules) | Choice::Both { modules, .. } => (modules, None),
            Choice::Width(width) => (&[], Some([(wanted / (displacement * width)).sqrt(), *width])),
            Choice::Ratio(ratio) => {
                let module = libm::cbrt(wanted / (displacement * ratio * diameter));
                (&[], Some([module, ratio * diameter * module]))
            }
        };
        let sized = move |module: f64| match self.choice {
            Choice::Both { width, .. } => [module, width],
            _ => [module, wanted / displacement / module / module],
        };
        modules.iter().map(move |&module| sized(module)).chain(free).map(move |size| {
            (size, self.keeping(size, displacement * size[0] * size[0] * size[1], diameter * size[0]))
        })
    }

    /// Margin of a size within the limits, relative to them; 0 and above is within.
    fn keeping(&self, [module, width]: [f64; 2], displacement: f64, diameter: f64) -> f64 {
        let ratio = width / diameter;
        let mut least = f64::INFINITY;
        // A little slack, so that a size requested to the last digit is not refused by rounding.
        let mut keep = |margin: f64| least = least.min(margin + SLACK);
        keep(self.diameter / diameter - 1.0);
        let [modules, widths] = [MODULE_MM, WIDTH_MM].map(|range| range.map(|mm| mm / 1e3));
        let ranges = [(module, modules), (width, widths), (width, self.width), (ratio, self.ratio)];
        for (value, [low, high]) in ranges {
            keep(if low > 0.0 { value / low - 1.0 } else { f64::INFINITY });
            keep(high / value - 1.0);
        }
        if let Choice::Both { tolerance, .. } = self.choice {
            keep(1.0 - (displacement / self.displacement - 1.0).abs() / tolerance);
        }
        let all = [module, width, diameter, ratio, displacement, PI * diameter * diameter * width];
        let sound = all.iter().all(|value| value.is_finite() && *value > 0.0) && !least.is_nan();
        if sound { least } else { -1.0 }
    }

    /// Margin of the best choice within the limits.
    pub(super) fn margin(&self, displacement: f64, diameter: f64) -> f64 {
        self.choices(displacement, diameter).map(|(_, margin)| margin).fold(-1.0, f64::max)
    }

    /// Module and width of every choice within the limits, m.
    pub(super) fn sizes(&self, displacement: f64, diameter: f64) -> Vec<[f64; 2]> {
        let choices = self.choices(displacement, diameter);
        choices.filter(|(_, margin)| *margin >= 0.0).map(|(size, _)| size).collect()
    }
}

/// Ends of a range in their order, not below 0.
fn ordered(what: Quantity, [from, to]: [f64; 2], unit: &'static str) -> Result<(), Error> {
    if from >= 0.0 && from <= to { Ok(()) } else { Err(Error::EmptyLimits { what, from, to, unit }) }
}

/// Mean flow a radian over width from the displacement over width.
pub(super) fn mean_flow(displacement: f64) -> f64 {
    displacement / TAU
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_size_beyond_a_machine_is_refused() {
        let all = [0.0, f64::INFINITY];
        let sizing =
            Sizing { displacement: 1.0, choice: Choice::Ratio(1.0), diameter: 1e200, width: all, ratio: all };
        for (size, is_kept) in
            [(1e-120, false), (1e-7, false), (1e-5, true), (1.0, true), (2.0, false), (1e120, false)]
        {
            assert_eq!(sizing.keeping([size, size], size, size) >= 0.0, is_kept, "{size:e}");
        }
    }
}
