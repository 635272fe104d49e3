//! `motor --construction`: the arcs of a stator and the junction on its rotor.

pub mod answer;
pub mod request;
pub mod table;
