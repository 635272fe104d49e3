//! Tables in plain text, and CSV.

use comfy_table::{CellAlignment, ColumnConstraint, ContentArrangement, Table, Width, presets};
use epicyclic_units::visible;
use std::collections::BTreeSet;
use std::io;
use std::ops::Range;

/// Width of text in columns if no terminal gives one.
pub const WIDTH: usize = 80;

/// Maximum width of lines of sentences; longer ones are hard to read, however wide the terminal is.
pub const WIDEST_SENTENCES: usize = 100;

/// Minimum number of letters in a line if a word must be broken.
const SYLLABLE: usize = 4;

/// Blanks beside a column of a table, on both sides together.
const PADDING: usize = 2;

/// Errors of an answer that cannot be shown.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// Text that cannot be written.
    #[error("the answer cannot be written as text: {0}")]
    Text(String),
    /// Picture that cannot be made.
    #[error(transparent)]
    Picture(#[from] epicyclic_pictures::Error),
    /// Drawing of a hydromotor's teeth that do not exist.
    #[error("the motor has no teeth of this form: {0}")]
    NoTeeth(Box<crate::error::Error>),
    /// Drawing of something that cannot be calculated.
    #[error(transparent)]
    Answer(Box<crate::error::Error>),
    /// Drawing of something that is not described.
    #[error("there is nothing to draw: it needs {0}")]
    Lacking(String),
    /// Figure of an answer that is infinite or NaN.
    #[error("not a finite number: {figure}; a given number is too small or too large for it")]
    NotFinite {
        /// Place of the figure in the answer.
        figure: String,
    },
}

/// Writes a header and rows as CSV, one by one.
pub fn csv(
    header: &[&str],
    rows: impl IntoIterator<Item = Vec<String>>,
    out: impl io::Write,
) -> io::Result<()> {
    let mut writer = csv::Writer::from_writer(out);
    writer.write_record(header)?;
    for row in rows {
        writer.write_record(row)?;
    }
    writer.flush()
}

/// Formats a header and rows as CSV text.
pub fn csv_text(header: &[&str], rows: impl IntoIterator<Item = Vec<String>>) -> Result<String, Error> {
    let mut bytes = vec![];
    csv(header, rows, &mut bytes).map_err(|error| Error::Text(error.to_string()))?;
    String::from_utf8(bytes).map_err(|error| Error::Text(error.to_string()))
}

/// Formats a plain table; the columns at `right` are aligned right.
///
/// Words and numbers are not broken between lines. If the columns do not fit side by side, the table
/// continues below, with the columns that name its rows repeated. A word that is still too wide is broken; a
/// number extends beyond the edge.
pub fn table(
    header: &[&str],
    rows: impl IntoIterator<Item = Vec<String>>,
    right: &[usize],
    width: usize,
) -> String {
    let shown = |row: Vec<String>| -> Vec<String> {
        row.iter().map(|cell| visible::one_line(cell).into_owned()).collect()
    };
    let header = header.iter().map(|title| visible::one_line(title).into_owned()).collect();
    let rows: Vec<Vec<String>> = rows.into_iter().map(shown).collect();
    let whole = Whole { header, rows, right };
    let parts = whole.parts(width).into_iter().map(|columns| whole.part(&columns, width));
    parts.collect::<Vec<_>>().join("\n")
}

/// Table before it is split into parts.
struct Whole<'a> {
    header: Vec<String>,
    rows: Vec<Vec<String>>,
    right: &'a [usize],
}

impl Whole<'_> {
    fn columns(&self) -> Range<usize> {
        0..self.rows.iter().map(Vec::len).chain([self.header.len()]).max().unwrap_or(0)
    }

    /// Largest measure of the cells in a column.
    fn widest(&self, column: usize, measure: impl Fn(&str) -> usize) -> usize {
        let cells = self.rows.iter().chain([&self.header]).filter_map(|row| row.get(column));
        cells.map(|cell| measure(cell)).max().unwrap_or(0)
    }

    /// Least width of a column with its padding: that of its longest word.
    fn least(&self, column: usize) -> usize {
        let word = |cell: &str| cell.split(' ').map(|word| word.chars().count()).max().unwrap_or(0);
        PADDING + self.widest(column, word)
    }

    /// Least width of a column if words may be broken too, and only numbers stay whole.
    fn least_in_need(&self, column: usize) -> usize {
        if self.right.contains(&column) {
            self.least(column)
        } else {
            self.least(column).min(PADDING + SYLLABLE)
        }
    }

    /// Width of a column with its padding if each cell has one line.
    fn natural(&self, column: usize) -> usize {
        PADDING + self.widest(column, |cell| cell.chars().count())
    }

    /// Number of first columns that together identify each row.
    fn naming(&self) -> usize {
        let are_apart = |count: &usize| {
            let mut seen = BTreeSet::new();
            self.rows.iter().all(|row| seen.insert(&row[..(*count).min(row.len())]))
        };
        self.columns().skip(1).find(are_apart).unwrap_or(1)
    }

    /// Columns of each part.
    fn parts(&self, width: usize) -> Vec<Vec<usize>> {
        let sum = |columns: Range<usize>| columns.map(|column| self.least(column)).sum::<usize>();
        if sum(self.columns()) <= width {
            return vec![self.columns().collect()];
        }
        let naming = 0..self.naming();
        let (mut parts, mut part, mut used) = (vec![], vec![], sum(naming.clone()));
        for column in naming.end..self.columns().end {
            let least = self.least(column);
            if !part.is_empty() && used + least > width {
                parts.push(naming.clone().chain(std::mem::take(&mut part)).collect());
                used = sum(naming.clone());
            }
            part.push(column);
            used += least;
        }
        parts.push(naming.chain(part).collect());
        parts
    }

    fn part(&self, columns: &[usize], width: usize) -> String {
        let is_wrapped = columns.iter().map(|column| self.natural(*column)).sum::<usize>() > width;
        let sum = |least: fn(&Self, usize) -> usize| columns.iter().map(|column| least(self, *column)).sum();
        let (least, width): (fn(&Self, usize) -> usize, usize) = match sum(Self::least) {
            least if least <= width => (Self::least, width),
            _ => (Self::least_in_need, width.max(sum(Self::least_in_need))),
        };
        let mut table = Table::new();
        let arranged = ContentArrangement::Dynamic;
        let most = u16::try_from(width).unwrap_or(u16::MAX);
        table.load_style(presets::NOTHING).set_content_arrangement(arranged).set_width(most);
        let of = |row: &Vec<String>| -> Vec<String> {
            columns.iter().filter_map(|column| row.get(*column).cloned()).collect()
        };
        if self.header.iter().any(|title| !title.is_empty()) {
            table.set_header(of(&self.header));
        }
        table.add_rows(self.rows.iter().map(of));
        for (place, column) in columns.iter().enumerate() {
            let Some(shown) = table.column_mut(place) else { continue };
            if self.right.contains(column) {
                shown.set_cell_alignment(CellAlignment::Right);
            }
            if let Some(least) = u16::try_from(least(self, *column)).ok().filter(|_| is_wrapped) {
                shown.set_constraint(ColumnConstraint::LowerBoundary(Width::Fixed(least)));
            }
        }
        table.lines().map(|line| line.trim_end().to_owned() + "\n").collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(width: usize) -> String {
        let cells = |cells: &[&str]| cells.iter().map(|cell| (*cell).to_owned()).collect::<Vec<_>>();
        let rows = [
            cells(&["1", "A B C", "4.7143", "1000033/700007"]),
            cells(&["R", "A B D", "-3.2952", "-346/105"]),
        ];
        table(&["gear", "engaged elements", "i", "exact"], rows, &[2, 3], width)
    }

    #[test]
    fn a_narrow_table_wraps_between_words_and_goes_on_below() {
        let wide = " gear  engaged elements        i           exact\n 1     A B C              4.7143  1000033/700007\n R     A B D             -3.2952        -346/105\n";
        assert_eq!(shown(80), wide);
        for width in (20..80).chain([200]) {
            let text = shown(width);
            // The gear and the longest fraction take 22 columns.
            assert!(text.lines().all(|line| line.chars().count() <= width.max(22)), "{width}\n{text}");
            assert!(text.contains("1000033/700007") && text.contains("-3.2952"), "{width}\n{text}");
        }
        let narrow = shown(30);
        assert_eq!(narrow.matches("gear").count(), 2, "the rows are named in each part: {narrow}");
    }

    #[test]
    fn rows_that_one_column_does_not_tell_apart_are_named_by_two() {
        let rows = [["slow", "1", "1781.2"], ["slow", "2", "1415.7"]];
        let rows = rows.map(|row| row.map(str::to_owned).to_vec());
        let text = table(&["gear", "set", "tangential"], rows.clone(), &[2], 18);
        assert_eq!(text.matches("set").count(), 1, "{text}");
        let rows = rows.map(|row| [row, vec!["1938.8".to_owned()]].concat());
        let text = table(&["gear", "set", "tangential", "together"], rows, &[2, 3], 26);
        assert_eq!(text.matches("set").count(), 2, "{text}");
    }
}
