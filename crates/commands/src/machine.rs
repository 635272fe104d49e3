//! `machine`: speeds of mining machines.

pub mod answer;
pub mod request;
pub mod table;
