//! How an outcome is shown: for people, as a page, for programs, for continuous integration.

pub mod html;
pub mod human;
pub mod json;
pub mod junit;
