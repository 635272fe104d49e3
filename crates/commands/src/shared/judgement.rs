//! Judgement of a gearbox: every rule of practice that its file has the data for.

pub mod answer;
pub(crate) mod judge;
mod loads;
pub(crate) mod table;
mod teeth;
pub(crate) mod whole;
