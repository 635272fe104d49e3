//! `size`: sizes of sets that hold over a duty.

pub mod answer;
pub mod options;
pub mod request;
pub mod table;

pub use answer::{Size, saved};
pub use options::Request;
