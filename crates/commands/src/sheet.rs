//! `sheet`: data sheets of gears.

pub mod answer;
pub mod request;
pub mod table;
