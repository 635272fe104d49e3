//! Numerics without engineering: what the crates of gears, motion and motors share.
//!
//! | module | content |
//! |---|---|
//! | [`front`] | non-dominated designs: the Pareto front of any number of costs |
//! | [`values`] | the larger and the smaller of two numbers |

pub mod front;
pub mod values;
