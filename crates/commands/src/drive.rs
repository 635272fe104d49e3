//! `drive`: a whole planetary drive from a file.

pub mod answer;
pub mod page;
pub mod request;
pub mod table;

pub use answer::{Drive, of_file};
