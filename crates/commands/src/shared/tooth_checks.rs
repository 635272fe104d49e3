//! Checks of teeth in mesh.

pub mod answer;
pub mod table;
