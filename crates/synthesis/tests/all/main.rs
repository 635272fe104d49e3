//! The synthesis against second ways. One program: its tests run side by side.

#[path = "../common/bisection.rs"]
mod bisection;
#[path = "../common/mod.rs"]
mod common;
mod counts;
mod equal_k;
mod families;
#[path = "../common/found.rs"]
mod found;
mod refine;
mod rules;
mod search;
mod sharing;
mod side_by_side;
mod solver;
mod teeth;
mod work;
