//! Numerics without engineering: what the crates of gears, motion and motors share.
//!
//! | module | content |
//! |---|---|
//! | [`extremes`] | least and greatest values of functions of one variable |
//! | [`front`] | non-dominated designs: the Pareto front of any number of costs |
//! | [`linear`] | dense linear equations, triangles of a matrix, independent rows |
//! | [`quadrature`] | integrals by Gauss–Legendre rules |
//! | [`roots`] | roots of functions of one variable, the end of a property, arguments of a value |
//! | [`threads`] | work on many items, with the feature `parallel` on all threads |
//! | [`values`] | products, largest sizes, the larger and the smaller of two numbers |

pub mod extremes;
pub mod front;
pub mod linear;
pub mod quadrature;
pub mod roots;
pub mod threads;
pub mod values;
