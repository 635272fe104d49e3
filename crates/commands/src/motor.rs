//! `motor`: a hydromotor and its drawings, and searches for one.

pub mod answer;
pub mod construction;
pub mod designs;
pub mod forms;
pub mod options;
pub mod page;
pub mod request;
pub mod satellites;
pub mod search;
pub mod table;

pub use answer::Motor;
pub use options::Request;
