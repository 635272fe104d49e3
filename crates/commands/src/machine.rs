//! `machine`: speeds of mining machines.

pub mod answer;
pub mod options;
pub mod request;
pub mod table;
