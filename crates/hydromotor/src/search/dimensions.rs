//! Size of a design: module and width with the working data that follow.

use super::point::Working;
use super::requirements::{Requirements, mean_flow};
use crate::modules::{length, volume};
use epicyclic_units::Physical;
use std::f64::consts::FRAC_PI_4;
use uom::si::f64::{Length, Power, Torque, Volume, VolumeRate};

/// A design in one size.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dimensions {
    /// Module.
    pub module: Length,
    /// Width.
    pub width: Length,
    /// Diameter of the stator's centrode; roots and housing come on top.
    pub outer_diameter: Length,
    /// Volume of the cylinder about the stator's centrode.
    pub volume: Volume,
    /// Displacement a revolution; the wanted one but for the tolerance of
    /// [`Size::ModulesAndWidth`](super::Size).
    pub displacement: Volume,
    /// Mean torque at the pressure wanted, without losses.
    pub torque: Option<Torque>,
    /// The least torque over a revolution, without losses, satellites sealing at the pitch points.
    pub least_torque: Option<Torque>,
    /// Mean flow at the speed wanted.
    pub flow: Option<VolumeRate>,
    /// Power at that speed and the pressure wanted, without losses.
    pub power: Option<Power>,
}

impl Dimensions {
    /// Size of a motor with this module and width, in metres.
    pub(super) fn of(requirements: &Requirements, working: &Working, [module, width]: [f64; 2]) -> Self {
        let (module, width) = (Length::from_si(module), Length::from_si(width));
        // In units of the module, as the diameter is; `volume` converts with module and width.
        let disc = FRAC_PI_4 * working.diameter * working.diameter;
        let [mean, least] =
            [mean_flow(working.displacement), working.flow[0]].map(|flow| volume(flow, module, width));
        let torque = requirements.pressure_drop.map(|drop| Torque::from(mean * drop));
        Self {
            module,
            width,
            outer_diameter: length(working.diameter, module),
            volume: volume(disc, module, width),
            displacement: volume(working.displacement, module, width),
            torque,
            least_torque: requirements.pressure_drop.map(|drop| (least * drop).into()),
            flow: requirements.speed.map(|speed| mean * speed),
            power: torque.zip(requirements.speed).map(|(torque, speed)| torque * speed),
        }
    }
}
