//! `report`: a page about a file.

pub mod answer;
pub mod page;
pub mod request;
pub mod side_by_side;
pub mod table;

pub use answer::Report;
pub use request::Request;
