//! `vibrate`: natural frequencies, modes and resonances of sets.

pub mod answer;
pub mod page;
pub mod request;
pub mod table;

pub use answer::Vibration;
pub use request::Request;
