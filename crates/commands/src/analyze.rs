//! `analyze`: every gear of any planetary gearbox.

pub mod answer;
pub mod request;
pub mod table;

pub use request::{Analysis, Request};
