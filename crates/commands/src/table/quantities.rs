//! Figures of the SI numbers in a record.

use crate::table::figure::Figure;
use crate::table::report::Row;
use epicyclic_units::Dimension;
use epicyclic_units::format::{in_unit, sensible_unit};

/// A quantity in the unit that suits its size.
#[must_use]
pub fn quantity(dimension: Dimension, si: f64) -> Figure {
    Figure::Quantity { si, dimension }
}

/// The same, if there is one.
#[must_use]
pub fn optional(dimension: Dimension, si: Option<f64>) -> Figure {
    si.map_or(Figure::Without(dimension), |si| quantity(dimension, si))
}

/// A quantity below a heading with its unit.
#[must_use]
pub fn column(dimension: Dimension, si: Option<f64>) -> Figure {
    si.map_or(Figure::None, |si| Figure::Column { si, dimension })
}

/// A quantity in a sentence.
#[must_use]
pub fn words(dimension: Dimension, si: f64, digits: usize) -> String {
    in_unit(si, sensible_unit(dimension, si), digits)
}

/// A row with a remark.
#[must_use]
pub fn remarked(row: Row, remark: impl Into<String>) -> Row {
    Row { remark: remark.into(), ..row }
}
