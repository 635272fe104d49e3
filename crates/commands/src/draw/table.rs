//! What was drawn, a line for each file.

use crate::draw::answer::{Drawing, Sheet};
use epicyclic_units::Dimension;
use epicyclic_units::format::trimmed;
use epicyclic_units::visible::one_line;

/// A line for each file: its path, the drawing's title and size.
#[must_use]
pub fn lines(drawing: &Drawing) -> String {
    let Some(Sheet { title, width_m, height_m }) = &drawing.sheet else { return String::new() };
    let mm = |length: f64| trimmed((length / Dimension::Length.usual_unit().factor).round(), 4);
    let (width, height) = (mm(*width_m), mm(*height_m));
    let line = |path: &str| one_line(&format!("{path}: {title}, {width} x {height} mm")).into_owned() + "\n";
    drawing.files.iter().map(|file| line(&file.path)).collect()
}
