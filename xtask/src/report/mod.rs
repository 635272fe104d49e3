//! How an outcome is shown: for people, for programs, for continuous integration.

pub mod human;
pub mod json;
pub mod junit;
