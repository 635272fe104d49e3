//! `design`: from speeds and power to a gearbox whose sizes hold.

pub mod answer;
mod factor;
mod gears;
mod limits;
mod load_step;
pub mod page;
pub mod request;
mod stages;
pub mod table;
mod values;

pub use answer::Design;
pub use factor::Factor;
pub use load_step::LoadStep;
pub use request::Request;
