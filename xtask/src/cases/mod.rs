//! Spec cases: what the sources publish, held against what the crates compute.
//!
//! [`load`] reads a folder a source, [`run`] executes its cases and returns a [`run::Outcome`] for
//! every figure; reports are made of those and of nothing else.

pub mod case;
pub mod figure;
pub mod index;
pub mod load;
pub mod run;
pub mod snapshot;
pub mod tolerance;
