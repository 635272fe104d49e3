//! Numerics without engineering: what the crates of gears, motion and motors share.
//!
//! | module | content |
//! |---|---|
//! | [`front`] | non-dominated designs: the Pareto front of any number of costs |
//! | [`linear`] | dense linear equations, triangles of a matrix, independent rows |
//! | [`values`] | products, largest sizes, the larger and the smaller of two numbers |

pub mod front;
pub mod linear;
pub mod values;
