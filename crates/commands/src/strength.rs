//! `strength`: safeties of teeth by ISO 6336.

pub mod answer;
pub mod options;
pub mod page;
pub mod request;
pub mod table;

pub use answer::Strength;
pub use options::Request;
