//! Formats of an outcome: for people, as a page, for programs, for continuous integration; and the check of
//! the project's texts.

pub mod html;
pub mod human;
pub mod json;
pub mod junit;
pub mod texts;
