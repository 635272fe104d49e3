//! What a gearbox does in its gears, as tables.

mod combinations;
mod formulas;
mod gear;
pub mod inputs;
pub(crate) mod overview;
mod planet_bearings;
pub(crate) mod sets;
mod shared;
mod shifts;

pub(crate) use shared::kind as kind_of;
