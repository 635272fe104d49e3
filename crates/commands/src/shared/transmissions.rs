//! The transmissions of a file to choose from.

pub mod answer;
pub mod table;
