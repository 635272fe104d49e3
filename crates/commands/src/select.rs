//! `select`: the gearbox for given speeds.

pub mod answer;
pub mod page;
pub mod request;
pub mod table;

pub use answer::Select;
pub use request::Request;
