//! Hydromotors with non-circular wheels and floating satellites.

pub mod arcs;
pub mod closure;
pub mod error;
pub mod junction;
pub mod numbers;
mod real;
mod roots;
mod units;

pub use error::Error;
pub use numbers::MotorNumbers;
