//! How an outcome is shown: for people, as a page, for programs, for continuous integration; and what the
//! texts of the project say of it.

pub mod html;
pub mod human;
pub mod json;
pub mod junit;
pub mod texts;
