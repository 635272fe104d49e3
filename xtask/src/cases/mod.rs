//! Spec cases: comparison of the published figures of the sources with the results of the crates.
//!
//! [`load`] reads the folder of a source. [`run`] executes its cases and returns a [`run::Outcome`] with
//! every figure; all reports are made of outcomes.

pub mod case;
pub mod figure;
pub mod index;
pub mod load;
pub mod run;
pub mod snapshot;
pub mod tolerance;
