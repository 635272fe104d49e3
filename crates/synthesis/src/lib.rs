//! Synthesis of planetary gearboxes from a list of ratios.

pub mod class;
pub mod count;
pub mod enumerate;
mod error;
pub mod structure;

pub mod exterior;
pub mod gearbox;
pub mod judge;
mod library;
pub mod motion;
pub mod parts;
pub mod ratio;
pub mod refine;
pub mod run;
pub mod search;
pub mod solve;
pub mod ternary;

pub use class::{Class, Kind};
pub use error::Error;
pub use structure::Structure;
