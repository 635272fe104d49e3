//! `sheet`: data sheets of gears.

pub mod answer;
pub mod request;
pub mod table;

pub use answer::DataSheets;
pub use request::Request;
