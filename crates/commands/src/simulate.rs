//! `simulate`: a gearbox in motion, by a scenario.

pub mod answer;
pub mod page;
pub mod request;
pub mod table;

pub use crate::shared::scenario::Scenario;
pub use answer::Simulation;
pub use answer::sweep::Sweep;
pub use request::Request;
