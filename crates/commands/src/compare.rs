//! `compare`: gearboxes side by side.

pub mod answer;
pub mod page;
pub mod request;
pub mod table;

pub use answer::{Candidate, Comparison};
pub use request::Request;
