//! `motor` without `--zs`: the satellites that the other numbers admit.

pub mod answer;
pub mod request;
pub mod table;
