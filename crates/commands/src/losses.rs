//! `losses`: what heats a gearbox at work, and its efficiency over speed and torque.

pub mod answer;
pub mod request;
pub mod table;

pub use answer::{LossMap, Losses};
pub use request::Request;
