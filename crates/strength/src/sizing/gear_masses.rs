//! Masses of the gears of a layout over their face width, and the bores of planets.

use super::task::{Body, Layout, Task};
use crate::tolerance::RIM;
use epicyclic_gears::geometry::GearKind;
use epicyclic_units::Physical;
use std::f64::consts::FRAC_PI_4;
use uom::si::f64::Length;

/// Masses of the gears of a layout over their face width.
pub(super) struct Masses {
    /// Central gears of each family together, kg/m.
    central: Vec<f64>,
    /// One solid planet of each kind, by family, kg/m.
    planets: Vec<Vec<f64>>,
    /// Density of one planet of each kind, by family, kg/m³.
    bored: Vec<Vec<f64>>,
    /// The largest bore that leaves each kind of planets its rim, m.
    pub(super) largest_bore: Vec<f64>,
    /// Reference diameter of the smallest sun of each family, or of its smallest gear, m.
    pub(super) diameters: Vec<f64>,
    pub(super) ring: Option<Length>,
    /// Diameter of the ring, or of the largest gear, m.
    pub(super) largest: f64,
}

impl Masses {
    pub(super) fn new(task: &Task, layout: &Layout) -> Self {
        let families = task.face_widths.len();
        let mut own = Self {
            central: vec![0.0; families],
            planets: vec![vec![0.0; families]; task.planets.len()],
            bored: vec![vec![0.0; families]; task.planets.len()],
            largest_bore: vec![],
            diameters: (0..families).map(|family| smallest(task, layout, family)).collect(),
            ring: layout.ring_diameter(task),
            largest: largest(task, layout),
        };
        for (place, gear) in layout.gears.iter().enumerate() {
            let sized = &task.gears[place];
            let (module, density) = (layout.module(task, place), sized.gear.material.density.si());
            let filled = gear.filled_area() * module.si().powi(2);
            let one = density
                * match gear.kind() {
                    GearKind::External => filled,
                    GearKind::Internal => {
                        let rim = task.ring_rim(place, module).si();
                        FRAC_PI_4 * (gear.root_diameter() * module.si() + 2.0 * rim).powi(2) - filled
                    }
                };
            match sized.body {
                Body::Central => own.central[sized.family] += one,
                Body::Planet(planet) => {
                    own.planets[planet][sized.family] += one;
                    own.bored[planet][sized.family] += density;
                }
            }
        }
        let bore = |planet: usize| {
            let most = widest_bore(task, layout, planet);
            let bores = task.bores(planet).map(Physical::si);
            bores.filter(|bore| *bore <= most).fold(f64::NEG_INFINITY, f64::max)
        };
        own.largest_bore = (0..task.planets.len()).map(bore).collect();
        own
    }

    /// Mass of all gears with these bores and widths, kg.
    pub(super) fn all(&self, planets: u32, bores: impl Iterator<Item = f64>, widths: &[f64]) -> f64 {
        let central: f64 = self.central.iter().zip(widths).map(|(one, width)| one * width).sum();
        let one: f64 = bores.enumerate().map(|(planet, bore)| self.planet(planet, bore, widths)).sum();
        central + f64::from(planets) * one
    }

    /// Mass of carrier and housing, kg.
    pub(super) fn structure(&self, widths: &[f64]) -> f64 {
        super::structure(self.largest, widths.iter().sum())
    }

    /// Length along the axis, m.
    pub(super) fn length(&self, widths: &[f64]) -> f64 {
        super::length(self.largest, widths.iter().sum())
    }

    /// Mass of a planet, kg.
    pub(super) fn planet(&self, planet: usize, bore: f64, widths: &[f64]) -> f64 {
        let own = self.planets[planet].iter().zip(&self.bored[planet]).zip(widths);
        own.map(|((solid, density), width)| width * (solid - FRAC_PI_4 * bore * bore * density)).sum()
    }
}

/// Diameter in m that ring, planets and tips reach to.
fn largest(task: &Task, layout: &Layout) -> f64 {
    let tips = || {
        layout
            .gears
            .iter()
            .enumerate()
            .map(|(place, gear)| gear.tip_diameter() * layout.module(task, place).si())
    };
    let without_ring = || tips().fold(layout.swept_diameter(task).si(), f64::max);
    layout.ring_diameter(task).map_or_else(without_ring, Physical::si)
}

/// Reference diameter in m of the smallest sun of a family, or of its smallest gear.
fn smallest(task: &Task, layout: &Layout, family: usize) -> f64 {
    let gears = || (0..layout.gears.len()).filter(|gear| task.gears[*gear].family == family);
    let is_sun = |gear: &usize| {
        task.gears[*gear].body == Body::Central && layout.gears[*gear].kind() == GearKind::External
    };
    let diameter = |gear: usize| layout.gears[gear].reference_diameter() * layout.modules[family].si();
    let of_sun = gears().filter(is_sun).map(diameter).reduce(f64::min);
    of_sun.or_else(|| gears().map(diameter).reduce(f64::min)).unwrap_or(f64::INFINITY)
}

/// The widest bore that leaves each gear of the planets its rim, m; 0 where none does.
pub(super) fn widest_bore(task: &Task, layout: &Layout, planet: usize) -> f64 {
    let bore = |gear: usize| {
        let module = layout.module(task, gear).si();
        let stated = task.gears[gear].gear.rim.map_or(0.0, Physical::si);
        let rim = (task.planet_rim * module).max(stated) * (1.0 - RIM);
        layout.gears[gear].root_diameter() * module - 2.0 * rim
    };
    task.gears_of(planet).map(bore).fold(f64::INFINITY, f64::min).max(0.0)
}

impl Task {
    /// Bores that planets may have; 0 of solid ones.
    pub(super) fn bores(&self, planet: usize) -> impl Iterator<Item = Length> + '_ {
        let own = &self.planets[planet];
        let alone = own.bearings.is_empty().then(|| own.bore.unwrap_or_default());
        own.eligible().map(|bearing| bearing.outside_diameter).chain(alone)
    }
}
