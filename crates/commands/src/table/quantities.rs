//! Figures for the SI numbers of a record.

use crate::table::figure::Figure;
use crate::table::report::Row;
use epicyclic_units::Dimension;
use epicyclic_units::format::{in_unit, sensible_unit};

/// Figure of a quantity in the unit that suits its size.
#[must_use]
pub fn quantity(dimension: Dimension, si: f64) -> Figure {
    Figure::Quantity { si, dimension }
}

/// Figure of a quantity, or of none.
#[must_use]
pub fn optional(dimension: Dimension, si: Option<f64>) -> Figure {
    si.map_or(Figure::Without(dimension), |si| quantity(dimension, si))
}

/// Figure of a quantity below a heading with its unit.
#[must_use]
pub fn column(dimension: Dimension, si: Option<f64>) -> Figure {
    si.map_or(Figure::None, |si| Figure::Column { si, dimension })
}

/// Text of a quantity in a sentence.
#[must_use]
pub fn words(dimension: Dimension, si: f64, digits: usize) -> String {
    in_unit(si, sensible_unit(dimension, si), digits)
}

/// Row with a remark.
#[must_use]
pub fn remarked(row: Row, remark: impl Into<String>) -> Row {
    Row { remark: remark.into(), ..row }
}
