//! Gearboxes and hydromotors as scenes to draw.
//!
//! | module | draws |
//! |---|---|
//! | [`gearbox`] | kinematic schemes, speed diagrams, lever diagrams, ratio ladders |
//! | [`gear_set`] | a gear set along its axis |
//! | [`motor`] | centrodes, teeth, chambers, a motor at an angle |
//! | [`toothed_sets`] | gear sets along their axis, every tooth in mesh |
//! | [`plot`] | curves over an axis |
//! | [`modes`] | modes of a planet set along its axis |
//! | [`campbell`] | natural frequencies and orders of excitation over the speed |
//! | [`contours`] | lines of equal value over two axes |
//!
//! Each function takes what a domain crate computed and returns an [`epicyclic_drawing::Scene`]; nothing here
//! computes a speed or a curve, and nothing opens a file.

pub mod campbell;
pub mod contours;
mod error;
pub mod gear_set;
pub mod gearbox;
pub mod modes;
pub mod motor;
pub mod plot;
mod tolerance;
pub mod toothed_sets;

pub use error::Error;
