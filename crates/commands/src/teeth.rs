//! `teeth`: tooth numbers for a ratio.

pub mod answer;
pub mod request;
pub mod table;
