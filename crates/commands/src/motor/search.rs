//! `motor search`: motors for a displacement or torque.

pub mod answer;
pub mod request;
pub mod table;
