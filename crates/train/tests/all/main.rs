//! Gearboxes against second ways. One program: its tests run side by side.

mod circulation;
#[path = "../common/mod.rs"]
mod common;
mod drags;
mod formula;
mod in_mesh;
mod inputs;
mod invalid;
mod losses;
mod machines;
mod one_way;
mod oracle;
mod planets;
mod random;
mod rank;
mod states;
mod sweep;
