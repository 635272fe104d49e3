//! `motor forms`: motors with the tooth form free.

pub mod answer;
pub mod request;
pub mod table;

pub use answer::{MotorForms, SearchedForms};
pub use request::Request;
