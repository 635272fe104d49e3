//! Tables of plain text, and CSV.

use comfy_table::{CellAlignment, ContentArrangement, Table, presets};
use epicyclic_formats::visible;

/// Columns that every table fits in, on whatever terminal.
pub const WIDTH: u16 = 80;

/// An answer that cannot be shown.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// Text that cannot be written.
    #[error("the answer cannot be written as text: {0}")]
    Text(String),
    /// A picture that cannot be made.
    #[error(transparent)]
    Picture(#[from] epicyclic_pictures::Error),
    /// The teeth of a hydromotor that are drawn and are not there.
    #[error("the motor has no teeth of this form: {0}")]
    NoTeeth(Box<epicyclic_answers::Error>),
    /// A figure of an answer that no double holds.
    #[error("not a finite number: {figure}; a given number is too small or too large for it")]
    NotFinite {
        /// Where it stands in the answer.
        figure: String,
    },
}

/// CSV of a header and rows.
pub fn csv(header: &[&str], rows: impl IntoIterator<Item = Vec<String>>) -> Result<String, Error> {
    let fail = |error: csv::Error| Error::Text(error.to_string());
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(header).map_err(fail)?;
    for row in rows {
        writer.write_record(row).map_err(fail)?;
    }
    let bytes = writer.into_inner().map_err(|error| Error::Text(error.to_string()))?;
    String::from_utf8(bytes).map_err(|error| Error::Text(error.to_string()))
}

/// A plain table; the columns at `right` are aligned to the right.
pub fn table(header: &[&str], rows: impl IntoIterator<Item = Vec<String>>, right: &[usize]) -> String {
    let mut table = Table::new();
    table.load_style(presets::NOTHING).set_content_arrangement(ContentArrangement::Dynamic).set_width(WIDTH);
    if header.iter().any(|title| !title.is_empty()) {
        table.set_header(header.iter().map(|title| visible::one_line(title)));
    }
    let shown = |row: Vec<String>| -> Vec<String> {
        row.iter().map(|cell| visible::one_line(cell).into_owned()).collect()
    };
    table.add_rows(rows.into_iter().map(shown));
    for index in right {
        if let Some(column) = table.column_mut(*index) {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
    let lines = table.lines().map(|line| line.trim_end().to_owned() + "\n");
    lines.collect()
}
