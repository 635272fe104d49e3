//! `design`: from speeds and power to a gearbox whose sizes hold.

pub mod answer;
pub mod page;
pub mod request;
pub mod table;

pub use answer::Design;
pub use request::Request;
