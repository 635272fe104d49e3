//! `size`: sizes of sets that hold over a duty.

pub mod answer;
pub mod request;
pub mod table;
