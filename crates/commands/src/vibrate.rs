//! `vibrate`: natural frequencies, modes and resonances of sets.

pub mod answer;
pub mod options;
pub mod page;
pub mod request;
pub mod table;

pub use answer::Vibration;
pub use options::Request;
