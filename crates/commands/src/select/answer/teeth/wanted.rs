//! Requirements for the choice over tooth numbers.

use super::SizeLimits;
use crate::select::answer::duty::Duty;
use crate::shared::profile_shift::WantedShifts;
use epicyclic_gears::synthesis::Bounds;
use epicyclic_selection::{Order, Requirements, Space};
use uom::si::f64::Velocity;

/// Requirements for the choice over tooth numbers.
#[derive(Debug, Clone)]
pub struct Wanted {
    /// Ratios, tolerance and limits; one ratio or two.
    pub requirements: Requirements,
    /// Objectives in the order in which they decide.
    pub order: Order,
    /// Mechanisms to choose among.
    pub space: Space,
    /// Bounds of tooth numbers and of planets.
    pub bounds: Bounds,
    /// Profile shifts of the sets; `None` for sets without profile shift.
    pub shifts: Option<WantedShifts>,
    /// Limits of the size that a set may need at the load factor.
    pub limits: SizeLimits,
    /// Maximum number of designs listed.
    pub most: usize,
    /// Number of the design that is shown in full, from 1.
    pub nth: usize,
    /// Speeds of the machine, the slowest first, if they determine the ratios.
    pub speeds: Vec<Velocity>,
    /// Speed and load of the input.
    pub duty: Duty,
}
