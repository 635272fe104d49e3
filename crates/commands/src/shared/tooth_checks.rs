//! What teeth in mesh must keep.

pub mod answer;
pub mod table;
