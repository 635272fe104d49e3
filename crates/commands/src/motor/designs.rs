//! What both searches for motors share: numbers and size, what is shown, drawn and written.

pub mod answer;
pub mod request;
pub mod table;
