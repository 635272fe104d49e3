//! `motor search`: motors for a displacement or torque.

pub mod answer;
pub mod request;
pub mod table;

pub use answer::{MotorSearch, SearchedMotors};
pub use request::Request;
