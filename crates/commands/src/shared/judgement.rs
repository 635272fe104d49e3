//! Judgement of a gearbox: every rule of practice that its file has the data for.

pub mod answer;
mod judge;
mod loads;
pub(crate) mod table;
mod teeth;
mod whole;
