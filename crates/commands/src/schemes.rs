//! `schemes`: the catalogue of two and three speeds.

pub mod answer;
pub mod request;
pub mod table;

pub use answer::{Scheme, Schemes};
pub use request::Request;
