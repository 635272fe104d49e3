//! Report of an answer in several parts: as tables, as CSV, and as part of a page.
//!
//! Tables and CSV show figures in the units of drawings. CSV is a list of sections, items and quantities. If
//! the answer is one list of similar things, CSV is a table of them with the units in its header.

pub(crate) mod html;

use crate::answer::Warning;
use crate::table::figure::{self, Figure, suffix};
use crate::table::text::{self, Error};
use epicyclic_units::Dimension;
use epicyclic_units::visible::one_line;
use std::borrow::Cow;
use std::io;

/// Answer with a report for people.
pub trait AsReport {
    /// Returns the report: figures, lists, text, warnings.
    fn report(&self) -> Report;
}

/// Report of an answer: its parts, then warnings.
#[derive(Debug, Default)]
pub struct Report {
    /// Title of the report; `None` if the answer needs none.
    pub title: Option<String>,
    /// Parts in the order in which they are shown.
    pub parts: Vec<Part>,
    /// Warnings by name and message; `None` if the command never gives warnings.
    pub warnings: Option<Vec<(&'static str, String)>>,
}

/// Part of a report.
#[derive(Debug)]
pub enum Part {
    /// Figures, each of its own kind.
    Facts(Section),
    /// Similar things with the same figures.
    Records(Records),
    /// Text of paragraphs, a list or a table, for people only.
    Text(Text),
}

/// Text with or without a heading.
#[derive(Debug, Default)]
pub struct Text {
    /// Heading of the text.
    pub heading: Option<String>,
    /// Paragraphs of sentences.
    pub paragraphs: Vec<String>,
    /// Lines that are printed unchanged after the paragraphs; a line that is too long is continued with an
    /// indentation.
    pub lines: Vec<String>,
    /// Points of a list, printed after the lines.
    pub points: Vec<String>,
    /// Table of words or marks, printed after the points: its header, then its rows.
    pub table: Vec<Vec<String>>,
}

impl Text {
    /// Text of one paragraph.
    pub fn paragraph(paragraph: impl Into<String>) -> Self {
        Self { paragraphs: vec![paragraph.into()], ..Self::default() }
    }

    /// List below a heading.
    pub fn list(heading: impl Into<String>, points: Vec<String>) -> Self {
        Self { heading: Some(heading.into()), points, ..Self::default() }
    }

    fn text(&self, width: usize) -> String {
        let mut text = String::new();
        if let Some(heading) = &self.heading {
            text += &unmarked(&one_line(heading), width);
        }
        for paragraph in &self.paragraphs {
            text += &unmarked(&one_line(paragraph), width);
        }
        for line in &self.lines {
            text += &continued(&one_line(line), width);
        }
        for point in &self.points {
            text += &wrapped(" -", &one_line(point), width);
        }
        if let Some((header, rows)) = self.table.split_first() {
            let header: Vec<&str> = header.iter().map(String::as_str).collect();
            text += &text::table(&header, rows.iter().cloned(), &[], width);
        }
        text
    }
}

/// Section of figures that belong together.
#[derive(Debug)]
pub struct Section {
    /// Key of the section.
    pub name: &'static str,
    /// Heading of the section.
    pub title: &'static str,
    /// Key and heading of each column; empty if every row has a single figure.
    pub columns: &'static [(&'static str, &'static str)],
    /// Rows of the section.
    pub rows: Vec<Row>,
    /// Note below the table; empty for none.
    pub note: &'static str,
}

/// Row with one figure, or with one for each column.
#[derive(Debug)]
pub struct Row {
    /// Key of the row without unit.
    pub name: &'static str,
    /// Label of the row.
    pub label: &'static str,
    /// Symbol of the quantity.
    pub symbol: &'static str,
    /// Figures: one, or one for each column.
    pub cells: Vec<Figure>,
    /// Remark, shown in the table only.
    pub remark: String,
}

impl Row {
    /// Row without a remark.
    pub fn new(
        name: &'static str,
        label: &'static str,
        symbol: &'static str,
        cells: impl Into<Vec<Figure>>,
    ) -> Self {
        Self { name, label, symbol, cells: cells.into(), remark: String::new() }
    }
}

/// List of similar things, each with one figure per column; the first figure names the thing.
#[derive(Debug)]
pub struct Records {
    /// Key of the list.
    pub name: &'static str,
    /// Columns of the list.
    pub columns: Vec<Column>,
    /// Rows with a figure for each column.
    pub rows: Vec<Vec<Figure>>,
    /// Tables in which the list is shown.
    pub views: Vec<View>,
    /// Whether this list is the answer, so that CSV has one line for each of its rows.
    pub is_answer: bool,
}

/// Column of a list.
#[derive(Debug)]
pub struct Column {
    /// Key of the column without unit. Corresponding columns of several things, such as the shift elements,
    /// have one name.
    pub name: &'static str,
    /// Thing to which the column belongs, if there are several; the prefix of its key.
    pub of: Option<String>,
    /// Heading of the column in tables.
    pub heading: String,
    /// Dimension of the quantities; `None` for other values.
    pub dimension: Option<Dimension>,
    /// Whether the column holds numbers, which are aligned right.
    pub is_number: bool,
    /// Whether CSV leaves the column out, because other columns have its content for programs.
    pub is_for_people: bool,
}

/// Title after the first warning of its answer, which is the most severe.
pub(crate) fn headline(title: String, warnings: &[Warning]) -> String {
    match warnings.first() {
        Some(Warning { message, .. }) => format!("Warning: {message}. {title}"),
        None => title,
    }
}

/// Warnings of an answer in the form of a report.
pub(crate) fn warned(warnings: &[Warning]) -> Option<Vec<(&'static str, String)>> {
    Some(warnings.iter().map(|warning| (warning.name, warning.message.clone())).collect())
}

impl Column {
    /// Column of words.
    pub fn words(name: &'static str, heading: impl Into<String>) -> Self {
        Self {
            name,
            of: None,
            heading: heading.into(),
            dimension: None,
            is_number: false,
            is_for_people: false,
        }
    }

    /// Column of plain numbers.
    pub fn number(name: &'static str, heading: impl Into<String>) -> Self {
        Self { is_number: true, ..Self::words(name, heading) }
    }

    /// Leaves the column out of CSV.
    #[must_use]
    pub fn for_people(self) -> Self {
        Self { is_for_people: true, ..self }
    }

    /// Column of quantities with their unit as heading.
    #[must_use]
    pub fn quantity(name: &'static str, dimension: Dimension) -> Self {
        let heading = dimension.usual_unit().symbol;
        Self { dimension: Some(dimension), ..Self::number(name, heading) }
    }

    /// Column of quantities with its own heading.
    pub fn headed(name: &'static str, heading: impl Into<String>, dimension: Dimension) -> Self {
        Self { heading: heading.into(), ..Self::quantity(name, dimension) }
    }

    /// Assigns the column to one of several things, whose name becomes its heading.
    #[must_use]
    pub fn of(self, thing: impl Into<String>) -> Self {
        let thing = thing.into();
        Self { heading: thing.clone(), of: Some(thing), ..self }
    }

    fn full_name(&self) -> String {
        self.of.iter().map(|of| format!("{of}_")).chain([self.name.to_owned()]).collect()
    }

    fn key(&self) -> String {
        format!("{}{}", self.full_name(), self.dimension.map_or("", |dimension| suffix(dimension)))
    }
}

/// View of some columns of a list as a table.
#[derive(Debug)]
pub struct View {
    /// Heading of the table.
    pub title: String,
    /// Names of columns in order, each for all columns of that name; names that the list lacks are skipped.
    pub columns: Vec<&'static str>,
    /// Note below the table; empty for none.
    pub note: String,
}

impl View {
    /// View without a note.
    pub fn new(title: impl Into<String>, columns: &[&'static str]) -> Self {
        Self { title: title.into(), columns: columns.to_vec(), note: String::new() }
    }
}

impl Report {
    /// Refuses `inf` and `NaN`, so that neither is printed in any format.
    pub fn refuse_infinite(&self) -> Result<(), Error> {
        let refuse = |figure: String| Err(Error::NotFinite { figure });
        for part in &self.parts {
            match part {
                Part::Facts(section) => {
                    let found = section.rows.iter().find(|row| !row.cells.iter().all(Figure::is_finite));
                    if let Some(row) = found {
                        return refuse(format!("{}.{}", section.name, row.name));
                    }
                }
                Part::Records(records) => {
                    for (column, place) in records.columns.iter().zip(0..) {
                        if let Some(row) = records.rows.iter().find(|row| !row[place].is_finite()) {
                            let item = row[0].csv().0;
                            return refuse(format!("{}.{} of {item}", records.name, column.name));
                        }
                    }
                }
                Part::Text(_) => {}
            }
        }
        Ok(())
    }

    /// Formats the report as tables for people, in lines of this width.
    #[must_use]
    pub fn table(&self, width: usize) -> String {
        let title = self.title.as_ref().map(|title| unmarked(&one_line(title), width));
        let parts = self.parts.iter().flat_map(|part| part.tables(width));
        let text = title.into_iter().chain(parts).collect::<Vec<_>>().join("\n");
        let Some(warnings) = &self.warnings else { return text };
        let heading = match warnings.len() {
            0 => "No warnings.\n",
            1 => "Warning\n",
            _ => "Warnings\n",
        };
        let warnings: String =
            warnings.iter().map(|(_, warning)| wrapped(" -", &one_line(warning), width)).collect();
        format!("{text}\n{heading}{warnings}")
    }

    /// Writes the report as CSV without buffering it.
    ///
    /// # Errors
    /// Errors of the writer.
    pub fn csv(&self, out: impl io::Write) -> io::Result<()> {
        for part in &self.parts {
            if let Part::Records(records) = part
                && records.is_answer
            {
                return records.csv(out);
            }
        }
        let figures = self.parts.iter().flat_map(|part| match part {
            Part::Facts(section) => section.lines(),
            Part::Records(records) => records.lines(),
            Part::Text(_) => vec![],
        });
        let warnings = self.warnings.iter().flatten().map(|(name, message)| {
            vec!["warnings".to_owned(), String::new(), (*name).to_owned(), message.clone(), String::new()]
        });
        text::csv(&["section", "item", "quantity", "value", "unit"], figures.chain(warnings), out)
    }
}

impl Report {
    /// Whether CSV has one line for each row of a list, and no place for warnings.
    #[must_use]
    pub fn is_list(&self) -> bool {
        self.parts.iter().any(|part| matches!(part, Part::Records(records) if records.is_answer))
    }
}

impl Part {
    fn tables(&self, width: usize) -> Vec<String> {
        match self {
            Self::Facts(section) => vec![section.grid().text(width)],
            Self::Records(records) => {
                records.views.iter().map(|view| records.grid(view).text(width)).collect()
            }
            Self::Text(text) => vec![text.text(width)],
        }
    }
}

/// Cells of a table as text, for all formats.
struct Grid<'a> {
    title: &'a str,
    header: Vec<&'a str>,
    rows: Vec<Vec<String>>,
    /// Places of the columns whose cells are aligned right.
    right: Vec<usize>,
    note: &'a str,
}

impl Grid<'_> {
    fn text(self, width: usize) -> String {
        let note =
            if self.note.is_empty() { String::new() } else { wrapped("", &one_line(self.note), width) };
        let table = text::table(&self.header, self.rows, &self.right, width);
        format!("{}{table}{note}", unmarked(&one_line(self.title), width))
    }
}

impl Section {
    fn grid(&self) -> Grid<'_> {
        let remarks = self.rows.iter().any(|row| !row.remark.is_empty());
        let mut header = vec!["", ""];
        header.extend(self.columns.iter().map(|(_, heading)| *heading));
        let rows = self.rows.iter().map(|row| {
            let mut cells = vec![row.label.to_owned(), row.symbol.to_owned()];
            cells.extend(row.cells.iter().map(Figure::table));
            if remarks {
                cells.push(row.remark.clone());
            }
            cells
        });
        let right = (2..2 + self.columns.len().max(1) + usize::from(remarks)).collect();
        Grid { title: self.title, rows: rows.collect(), header, right, note: self.note }
    }

    fn lines(&self) -> Vec<Vec<String>> {
        let cells = |row: &Row| -> Vec<Vec<String>> {
            let cell = |(index, cell): (usize, &Figure)| {
                let column = self.columns.get(index).map_or("", |(key, _)| key);
                let (value, unit) = cell.csv();
                vec![self.name.to_owned(), column.to_owned(), row.name.to_owned(), value, unit]
            };
            row.cells.iter().enumerate().map(cell).collect()
        };
        self.rows.iter().flat_map(cells).collect()
    }
}

impl Records {
    fn grid<'a>(&'a self, view: &'a View) -> Grid<'a> {
        let named = |name: &&'static str| {
            let name = *name;
            self.columns.iter().enumerate().filter(move |(_, column)| column.name == name)
        };
        let places: Vec<usize> = view.columns.iter().flat_map(named).map(|(place, _)| place).collect();
        let header: Vec<&str> = places.iter().map(|&place| self.columns[place].heading.as_str()).collect();
        let decimals: Vec<usize> =
            places.iter().map(|&place| figure::decimals(self.rows.iter().map(|row| &row[place]))).collect();
        let cells = |row: &Vec<Figure>| {
            places.iter().zip(&decimals).map(|(&place, decimals)| row[place].in_column(*decimals)).collect()
        };
        let rows = self.rows.iter().map(cells).collect();
        let is_number = |shown: &usize| self.columns[places[*shown]].is_number;
        let right = (0..places.len()).filter(is_number).collect();
        Grid { title: &view.title, header, rows, right, note: &view.note }
    }

    fn csv(&self, out: impl io::Write) -> io::Result<()> {
        rows_as_csv(&self.columns, self.rows.iter().map(Cow::Borrowed), out)
    }

    fn lines(&self) -> Vec<Vec<String>> {
        // The first columns that together identify each row form its name.
        let are_apart = |named: &usize| {
            let mut seen = std::collections::BTreeSet::new();
            self.rows.iter().all(|row| seen.insert(named_by(row, *named)))
        };
        let named = (1..self.columns.len()).find(are_apart).unwrap_or(1);
        let line = |item: &str, column: &Column, cell: &Figure| {
            let (value, unit) = cell.csv();
            vec![self.name.to_owned(), item.to_owned(), column.full_name(), value, unit]
        };
        let record = |row: &Vec<Figure>| -> Vec<Vec<String>> {
            let item = named_by(row, named);
            let cells = self.columns.iter().zip(row).skip(named).filter(|(column, _)| !column.is_for_people);
            cells.map(|(column, cell)| line(&item, column, cell)).collect()
        };
        self.rows.iter().flat_map(record).collect()
    }
}

/// Names of columns in CSV, all different. If a name would occur twice, a point separates the thing from the
/// key, as in `output.torque_n_m` for a brake called `output`.
fn keys<'c>(columns: impl Iterator<Item = &'c Column> + Clone) -> Vec<String> {
    let all: Vec<String> = columns.clone().map(Column::key).collect();
    let is_taken = |key: &String| all.iter().filter(|other| *other == key).count() > 1;
    columns
        .zip(&all)
        .map(|(column, key)| match &column.of {
            Some(of) if is_taken(key) => format!("{of}.{}", &key[of.len() + 1..]),
            _ => key.clone(),
        })
        .collect()
}

/// Writes rows of a list as CSV, one by one.
fn rows_as_csv<'a>(
    columns: &[Column],
    rows: impl Iterator<Item = Cow<'a, Vec<Figure>>>,
    out: impl io::Write,
) -> io::Result<()> {
    let places: Vec<usize> = (0..columns.len()).filter(|&place| !columns[place].is_for_people).collect();
    let header = keys(places.iter().map(|&place| &columns[place]));
    let header: Vec<&str> = header.iter().map(String::as_str).collect();
    let rows = rows.map(|row| places.iter().map(|&place| row[place].csv().0).collect());
    text::csv(&header, rows, out)
}

/// Rows that become cells together.
const TOGETHER: usize = 64;

/// Rows of a list as CSV, a few at a time as they come and after a check that their numbers are finite;
/// `records` is the list of given rows.
pub(crate) fn checked_rows_as_csv<R, E: Into<Box<dyn std::error::Error + Send + Sync>>>(
    mut rows: impl Iterator<Item = Result<R, E>>,
    records: impl Fn(&[R]) -> Records,
    out: impl io::Write,
) -> io::Result<()> {
    let Records { name: list, columns, .. } = records(&[]);
    let cells = std::iter::from_fn(|| {
        let mut fault = None;
        let next = rows.by_ref().take(TOGETHER);
        let next: Vec<R> = next.map_while(|row| row.map_err(|error| fault = Some(error)).ok()).collect();
        let fault = fault.map(|error| Err(io::Error::other(error)));
        let cells: Vec<io::Result<_>> = records(&next).rows.into_iter().map(Ok).chain(fault).collect();
        (!cells.is_empty()).then_some(cells)
    });
    let checked = |row: io::Result<Vec<Figure>>| {
        let row = row?;
        match columns.iter().zip(&row).find(|(_, figure)| !figure.is_finite()) {
            None => Ok(row),
            Some((column, _)) => {
                let figure = format!("{list}.{} of {}", column.name, row[0].csv().0);
                Err(io::Error::other(Error::NotFinite { figure }))
            }
        }
    };
    let mut fault = None;
    let rows = cells.flatten().map(checked).map_while(|row| row.map_err(|error| fault = Some(error)).ok());
    let written = rows_as_csv(&columns, rows.map(Cow::Owned), out);
    fault.map_or(written, Err)
}

/// Wraps sentences to lines of this width, after a list mark or none.
#[must_use]
pub fn wrapped(mark: &str, text: &str, width: usize) -> String {
    let width = width.min(text::WIDEST_SENTENCES);
    let mut lines = String::new();
    let mut line = mark.to_owned();
    for word in text.split(' ') {
        if line.chars().count() + 1 + word.chars().count() > width {
            lines += &line;
            lines.push('\n');
            line = " ".repeat(mark.len());
        }
        line.push(' ');
        line += word;
    }
    lines + &line + "\n"
}

/// Wraps a line to this width with an indentation; a sign stays with the word after it.
fn continued(text: &str, width: usize) -> String {
    let words = text.trim_start();
    let margin = text.len() - words.len();
    let mut lines = String::new();
    let mut line = " ".repeat(margin);
    let mut sign = String::new();
    for word in words.split(' ') {
        if matches!(word, "+" | "−" | "=") {
            sign += word;
            sign.push(' ');
            continue;
        }
        let word = std::mem::take(&mut sign) + word;
        let is_first = line.trim().is_empty();
        if !is_first && line.chars().count() + 1 + word.chars().count() > width {
            lines += &line;
            lines.push('\n');
            line = " ".repeat(margin + 4);
        } else if !is_first {
            line.push(' ');
        }
        line += &word;
    }
    lines + &line + "\n"
}

/// Wraps a paragraph to lines of this width.
fn unmarked(text: &str, width: usize) -> String {
    wrapped("", text, width)
        .lines()
        .map(|line| format!("{}\n", line.strip_prefix(' ').unwrap_or(line)))
        .collect()
}

/// Name of a row from the cells of its first columns.
fn named_by(row: &[Figure], columns: usize) -> String {
    row[..columns].iter().map(|cell| cell.csv().0).collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_line_goes_on_further_in_and_signs_stay_with_what_follows() {
        let term = "a".repeat(30);
        let line = format!("  i = {term} + {term} − {term} = 1");
        assert_eq!(continued(&line, 80), format!("  i = {term} + {term}\n      − {term} = 1\n"));
        assert_eq!(continued("  i = 1", 80), "  i = 1\n");
    }
}
