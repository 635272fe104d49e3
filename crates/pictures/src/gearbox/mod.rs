//! Pictures of gearboxes.
//!
//! | module | draws |
//! |---|---|
//! | [`scheme`] | the kinematic scheme in the half-plane; a gear's engaged elements and power flow |
//! | [`speeds`] | the speed diagram of a gear (Kutzbach): velocities over radius, and rays of angular speed |
//! | [`levers`] | sets as levers, a gear as a line across each |
//! | [`ladder`] | ratios of all gears on a logarithmic scale, with their steps |
//!
//! Sizes are those of a drawing on paper: letters of 2.5 mm, shafts of 0.7 mm. No label meets another or a
//! line, and no leader runs through a sign. The tests check this for every picture of the catalogue, of five
//! gearboxes in service, of the examples and of the cases.

pub mod ladder;
pub mod levers;
mod obstacles;
mod place;
mod radii;
pub mod scheme;
pub mod speeds;
mod words;

pub use crate::Error;

use epicyclic_drawing::Color;

/// Height of letters.
const LETTERS_MM: f64 = 2.5;
/// Height of titles.
const TITLE_MM: f64 = 3.5;
/// Engaged shift elements.
const ENGAGED: Color = Color::new(214, 48, 32);
/// Parts at rest.
const RESTING: Color = Color::new(165, 165, 165);
/// Power on its way from input to output.
const POWER: Color = Color::new(30, 95, 170);
/// Circulating power.
const CIRCULATING: Color = Color::new(240, 140, 20);
/// Colours of curves and rays, which also differ in lightness.
const COLORS: [Color; 6] = [
    Color::new(0, 90, 160),
    Color::new(200, 60, 20),
    Color::new(20, 130, 60),
    Color::new(120, 60, 150),
    Color::new(150, 105, 0),
    Color::new(90, 90, 90),
];
