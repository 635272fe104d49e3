//! Shared by both searches for motors: numbers and size, tables, drawings, files.

pub mod answer;
pub mod request;
pub mod table;

pub use answer::{Listing, Searched};
pub use request::Goal;
