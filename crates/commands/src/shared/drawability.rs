//! Parts of a gearbox that cannot be drawn together.

pub mod answer;
pub mod table;
