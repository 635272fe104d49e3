//! `draw`: schemes, speed diagrams, lever diagrams and ratio ladders as SVG and DXF.

pub mod answer;
pub mod request;
pub mod table;

pub use answer::Drawing;
pub use request::Request;
