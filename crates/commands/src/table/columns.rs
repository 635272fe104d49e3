//! Tables whose columns are declared once, with key, heading, quantity and the value in a row.
//!
//! ```text
//! Table::new("gears", &losses.gears)
//!     .text("gear", "gear", |gear| &gear.gear)
//!     .quantity("loss", "lost", Power, |gear| gear.loss_w)
//!     .view("Losses", "gear loss")
//!     .records()
//! ```
//!
//! The key and the unit of drawings name a column in CSV: `loss_kw`. Heading and unit head it in a table:
//! `lost, kW`.

use crate::table::figure::{Figure, multiple};
use crate::table::quantities;
use crate::table::report::{Column, Records, View};
use epicyclic_units::Dimension;

/// Number of columns that most tables do not exceed.
const COLUMNS: usize = 16;

/// Table of rows, to which columns are added.
pub(crate) struct Table<Row> {
    rows: Vec<Row>,
    records: Records,
}

impl<Row> Table<Row> {
    /// Table without columns.
    pub(crate) fn new(name: &'static str, rows: impl IntoIterator<Item = Row>) -> Self {
        let rows: Vec<Row> = rows.into_iter().collect();
        // Streamed lists make tables a few rows at a time, where growing column by column would cost as much
        // as the cells.
        let cells = rows.iter().map(|_| Vec::with_capacity(COLUMNS)).collect();
        let records = Records { name, columns: vec![], rows: cells, views: vec![], is_answer: false };
        Self { rows, records }
    }

    /// Adds a column with a function for its cells.
    pub(crate) fn column<F: Into<Figure>>(mut self, column: Column, cell: impl Fn(&Row) -> F) -> Self {
        self.records.columns.push(column);
        for (cells, row) in self.records.rows.iter_mut().zip(&self.rows) {
            cells.push(cell(row).into());
        }
        self
    }

    /// Adds a column of names.
    pub(crate) fn text(self, key: &'static str, heading: &str, of: impl Fn(&Row) -> &str) -> Self {
        self.words(key, heading, |row| Figure::Text(of(row).to_owned()))
    }

    /// Adds a column of words, aligned left.
    pub(crate) fn words<F: Into<Figure>>(
        self,
        key: &'static str,
        heading: &str,
        of: impl Fn(&Row) -> F,
    ) -> Self {
        self.column(Column::words(key, heading), of)
    }

    /// Adds a column of numbers, aligned right.
    pub(crate) fn number<F: Into<Figure>>(
        self,
        key: &'static str,
        heading: &str,
        of: impl Fn(&Row) -> F,
    ) -> Self {
        self.column(Column::number(key, heading), of)
    }

    /// Adds a column of multiples, efficiencies and ratios.
    pub(crate) fn multiple<V: Into<Option<f64>>>(
        self,
        key: &'static str,
        heading: &str,
        of: impl Fn(&Row) -> V,
    ) -> Self {
        self.number(key, heading, |row| multiple(of(row).into()))
    }

    /// Adds a column of quantities in SI units, shown in the units of drawings, which the heading names.
    pub(crate) fn quantity<V: Into<Option<f64>>>(
        self,
        key: &'static str,
        heading: &str,
        dimension: Dimension,
        of: impl Fn(&Row) -> V,
    ) -> Self {
        self.headed(key, &with_unit(heading, dimension), dimension, of)
    }

    /// Adds a column of quantities in SI units whose heading does not name the unit.
    pub(crate) fn headed<V: Into<Option<f64>>>(
        self,
        key: &'static str,
        heading: &str,
        dimension: Dimension,
        of: impl Fn(&Row) -> V,
    ) -> Self {
        let cell = |row: &Row| quantities::column(dimension, of(row).into());
        self.column(Column::headed(key, heading, dimension), cell)
    }

    /// Adds a column of lists of quantities of one kind, in the units of drawings.
    pub(crate) fn list(
        self,
        key: &'static str,
        heading: &str,
        dimension: Dimension,
        of: impl Fn(&Row) -> Vec<f64>,
    ) -> Self {
        let cell = |row: &Row| Figure::List { si: of(row), dimension };
        self.column(Column::headed(key, with_unit(heading, dimension), dimension), cell)
    }

    /// Adds a column of parts of a whole, in per cent.
    pub(crate) fn share<V: Into<Option<f64>>>(
        self,
        key: &'static str,
        heading: &str,
        of: impl Fn(&Row) -> V,
    ) -> Self {
        self.number(key, heading, |row| of(row).into().map(Figure::Share))
    }

    /// Adds a column of numbers with so many decimals.
    pub(crate) fn printed<V: Into<Option<f64>>>(
        self,
        key: &'static str,
        heading: &str,
        decimals: usize,
        of: impl Fn(&Row) -> V,
    ) -> Self {
        self.number(key, heading, |row| of(row).into().map(|number| Figure::Printed(number, decimals)))
    }

    /// Adds a column of quantities with so many decimals in the unit of drawings.
    pub(crate) fn measured<V: Into<Option<f64>>>(
        self,
        key: &'static str,
        heading: &str,
        dimension: Dimension,
        decimals: usize,
        of: impl Fn(&Row) -> V,
    ) -> Self {
        let cell = |row: &Row| of(row).into().map(|si| Figure::Measured { si, dimension, decimals });
        self.column(Column::headed(key, with_unit(heading, dimension), dimension), cell)
    }

    /// Adds the columns of each of several things.
    pub(crate) fn each<Of>(
        self,
        all: impl IntoIterator<Item = Of>,
        add: impl FnMut(Self, Of) -> Self,
    ) -> Self {
        all.into_iter().fold(self, add)
    }

    /// Makes the last column that of one of several things, which heads it.
    pub(crate) fn of(mut self, thing: &str) -> Self {
        if let Some(last) = self.records.columns.pop() {
            self.records.columns.push(last.of(thing));
        }
        self
    }

    /// Takes the last column away where the condition does not hold.
    pub(crate) fn only_if(mut self, holds: bool) -> Self {
        if !holds {
            self.records.columns.pop();
            self.records.rows.iter_mut().for_each(|cells| drop(cells.pop()));
        }
        self
    }

    /// Leaves the last column out of CSV, where other columns have its content for programs.
    pub(crate) fn for_people(mut self) -> Self {
        if let Some(last) = self.records.columns.last_mut() {
            last.is_for_people = true;
        }
        self
    }

    /// Shows the columns with these keys, in order.
    pub(crate) fn view(self, title: impl Into<String>, keys: &'static str) -> Self {
        let keys: Vec<&'static str> = keys.split_ascii_whitespace().collect();
        self.view_of(title, &keys)
    }

    /// Shows columns by keys that depend on the rows.
    pub(crate) fn view_of(mut self, title: impl Into<String>, keys: &[&'static str]) -> Self {
        self.records.views.push(View::new(title, keys));
        self
    }

    /// Shows all columns.
    pub(crate) fn all(self, title: impl Into<String>) -> Self {
        let mut keys: Vec<&'static str> = self.records.columns.iter().map(|column| column.name).collect();
        // A key is for all columns of its name.
        keys.dedup();
        self.view_of(title, &keys)
    }

    /// Replaces the views.
    pub(crate) fn views(mut self, views: Vec<View>) -> Self {
        self.records.views = views;
        self
    }

    /// Adds a note below the last view.
    pub(crate) fn note(mut self, note: impl Into<String>) -> Self {
        if let Some(last) = self.records.views.last_mut() {
            last.note = note.into();
        }
        self
    }

    /// Makes the list the answer: CSV has one line for each of its rows.
    pub(crate) fn the_answer(self) -> Self {
        self.the_answer_if(true)
    }

    /// Makes the list the answer on a condition.
    pub(crate) fn the_answer_if(mut self, is_answer: bool) -> Self {
        self.records.is_answer = is_answer;
        self
    }

    /// Returns the finished table.
    pub(crate) fn records(self) -> Records {
        self.records
    }
}

/// Heading with the unit of drawings, or the unit alone for an empty heading.
fn with_unit(heading: &str, dimension: Dimension) -> String {
    let unit = dimension.usual_unit().symbol;
    if heading.is_empty() { unit.to_owned() } else { format!("{heading}, {unit}") }
}
