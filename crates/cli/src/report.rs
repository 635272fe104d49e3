//! An answer of several parts, written three ways, and as part of a page.
//!
//! A table shows figures in the units of drawings, JSON in SI units named by the keys, CSV in the units of drawings:
//! as a list of sections, items and quantities, or, where the answer is one list of like things, as a table of them
//! with the units in its header.

mod html;

use crate::failure::Failure;
use crate::figure::{self, Figure, suffix};
use crate::output::{self, Format, OutputArgs, complain};
use crate::writing::Content;
use epicyclic_formats::Dimension;
use epicyclic_formats::visible::one_line;
use serde_json::{Map, Value, json};

/// An answer: its parts, then warnings.
#[derive(Debug, Default)]
pub(crate) struct Report {
    pub(crate) title: Option<String>,
    pub(crate) parts: Vec<Part>,
    /// Name and text; none at all where the command has no warnings to give.
    pub(crate) warnings: Option<Vec<(&'static str, String)>>,
}

/// A part of an answer.
#[derive(Debug)]
pub(crate) enum Part {
    /// Figures, each of its own kind.
    Facts(Section),
    /// Like things with like figures.
    Records(Records),
    /// Words, for people only.
    Words(String),
}

/// Figures that belong together.
#[derive(Debug)]
pub(crate) struct Section {
    /// Its key.
    pub(crate) name: &'static str,
    /// Its heading.
    pub(crate) title: &'static str,
    /// Key and heading of each column; none where every figure stands alone.
    pub(crate) columns: &'static [(&'static str, &'static str)],
    pub(crate) rows: Vec<Row>,
    /// A note below the table; empty for none.
    pub(crate) note: &'static str,
}

/// A figure, or one for each column.
#[derive(Debug)]
pub(crate) struct Row {
    /// Its key without unit.
    pub(crate) name: &'static str,
    /// What it is.
    pub(crate) label: &'static str,
    /// Its symbol.
    pub(crate) symbol: &'static str,
    pub(crate) cells: Vec<Figure>,
    /// A remark, in the table only.
    pub(crate) remark: String,
}

impl Row {
    pub(crate) fn new(
        name: &'static str,
        label: &'static str,
        symbol: &'static str,
        cells: impl Into<Vec<Figure>>,
    ) -> Self {
        Self { name, label, symbol, cells: cells.into(), remark: String::new() }
    }
}

/// Like things, each with one figure a column; the first names it.
#[derive(Debug)]
pub(crate) struct Records {
    /// The key of the list.
    pub(crate) name: &'static str,
    pub(crate) columns: Vec<Column>,
    pub(crate) rows: Vec<Vec<Figure>>,
    /// The tables it is shown as.
    pub(crate) views: Vec<View>,
    /// Whether this list is the answer: CSV then has one line for each of its things.
    pub(crate) is_answer: bool,
}

/// What one column says.
#[derive(Debug)]
pub(crate) struct Column {
    /// Its key without unit.
    pub(crate) name: &'static str,
    /// Its heading in tables.
    pub(crate) heading: String,
    /// What it measures.
    pub(crate) dimension: Option<Dimension>,
    /// Whether it holds numbers, which stand to the right.
    pub(crate) is_number: bool,
}

impl Column {
    /// A column of words.
    pub(crate) fn words(name: &'static str, heading: impl Into<String>) -> Self {
        Self { name, heading: heading.into(), dimension: None, is_number: false }
    }

    /// A column of plain numbers.
    pub(crate) fn number(name: &'static str, heading: impl Into<String>) -> Self {
        Self { is_number: true, ..Self::words(name, heading) }
    }

    /// A column of quantities, headed by their unit.
    pub(crate) fn quantity(name: &'static str, dimension: Dimension) -> Self {
        let heading = dimension.usual_unit().symbol;
        Self { dimension: Some(dimension), ..Self::number(name, heading) }
    }

    fn key(&self, format: Format) -> String {
        format!("{}{}", self.name, self.dimension.map_or("", |dimension| suffix(dimension, format)))
    }
}

/// Some columns of a list as a table.
#[derive(Debug)]
pub(crate) struct View {
    pub(crate) title: String,
    /// Names of columns, in order; those that the list lacks are passed over.
    pub(crate) columns: Vec<&'static str>,
    /// A note below the table; empty for none.
    pub(crate) note: String,
}

impl View {
    pub(crate) fn new(title: impl Into<String>, columns: &[&'static str]) -> Self {
        Self { title: title.into(), columns: columns.to_vec(), note: String::new() }
    }
}

impl Report {
    /// Writes the answer where it is to go; warnings that are out of sight there are shown as well.
    pub(crate) fn deliver(&self, output: &OutputArgs) -> Result<(), Failure> {
        self.deliver_with(vec![], output)
    }

    /// The same with other files of the call: all of them are written or none.
    pub(crate) fn deliver_with(&self, files: Vec<Content>, output: &OutputArgs) -> Result<(), Failure> {
        output.write_with(files, &self.text(output.format)?)?;
        if output.is_file() {
            for (_, warning) in self.warnings.iter().flatten() {
                complain(&format!("warning: {}", one_line(warning)));
            }
        }
        Ok(())
    }

    fn text(&self, format: Format) -> Result<String, Failure> {
        self.refuse_infinite()?;
        match format {
            Format::Table => Ok(self.table()),
            Format::Json => output::json(&self.json()),
            Format::Csv => self.csv(),
        }
    }

    /// No `inf` or `NaN` leaves the program, however the answer is written.
    pub(crate) fn refuse_infinite(&self) -> Result<(), Failure> {
        let refuse = |figure: String| Err(Failure::NotFinite { figure });
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
                Part::Words(_) => {}
            }
        }
        Ok(())
    }

    fn table(&self) -> String {
        let title = self.title.as_ref().map(|title| format!("{}\n", one_line(title)));
        let parts = self.parts.iter().flat_map(Part::tables);
        let text = title.into_iter().chain(parts).collect::<Vec<_>>().join("\n");
        let Some(warnings) = &self.warnings else { return text };
        let heading = match warnings.len() {
            0 => "No warnings.\n",
            1 => "Warning\n",
            _ => "Warnings\n",
        };
        let warnings: String =
            warnings.iter().map(|(_, warning)| wrapped(" -", &one_line(warning))).collect();
        format!("{text}\n{heading}{warnings}")
    }

    fn json(&self) -> Value {
        let mut root = Map::new();
        if let Some(title) = &self.title {
            root.insert("title".to_owned(), json!(title));
        }
        for part in &self.parts {
            let (name, value) = match part {
                Part::Facts(section) => (section.name, section.json()),
                Part::Records(records) => (records.name, records.json()),
                Part::Words(_) => continue,
            };
            match (root.get_mut(name), value) {
                // Sections of one name share one object.
                (Some(Value::Object(there)), Value::Object(more)) => there.extend(more),
                (_, value) => _ = root.insert(name.to_owned(), value),
            }
        }
        if let Some(warnings) = &self.warnings {
            let warning = |(name, message): &(_, String)| json!({ "name": name, "message": message });
            root.insert("warnings".to_owned(), warnings.iter().map(warning).collect());
        }
        Value::Object(root)
    }

    fn csv(&self) -> Result<String, Failure> {
        for part in &self.parts {
            if let Part::Records(records) = part
                && records.is_answer
            {
                return records.csv();
            }
        }
        let figures = self.parts.iter().flat_map(|part| match part {
            Part::Facts(section) => section.lines(),
            Part::Records(records) => records.lines(),
            Part::Words(_) => vec![],
        });
        let warnings = self.warnings.iter().flatten().map(|(name, message)| {
            vec!["warnings".to_owned(), String::new(), (*name).to_owned(), message.clone(), String::new()]
        });
        output::csv(&["section", "item", "quantity", "value", "unit"], figures.chain(warnings))
    }
}

impl Part {
    fn tables(&self) -> Vec<String> {
        match self {
            Self::Facts(section) => vec![section.grid().text()],
            Self::Records(records) => records.views.iter().map(|view| records.grid(view).text()).collect(),
            Self::Words(words) => vec![words.clone()],
        }
    }
}

/// A table's cells as text, however it is written.
struct Grid<'a> {
    title: &'a str,
    header: Vec<&'a str>,
    rows: Vec<Vec<String>>,
    /// Places of the columns whose cells stand to the right.
    right: Vec<usize>,
    note: &'a str,
}

impl Grid<'_> {
    fn text(self) -> String {
        let note = if self.note.is_empty() { String::new() } else { wrapped("", self.note) };
        format!("{}\n{}{note}", one_line(self.title), output::table(&self.header, self.rows, &self.right))
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

    fn json(&self) -> Value {
        let of_column = |index: usize| -> Value {
            let cells = self.rows.iter().filter_map(|row| Some((row.name, row.cells.get(index)?)));
            cells.map(|(name, cell)| (format!("{name}{}", cell.suffix()), cell.json())).collect()
        };
        if self.columns.is_empty() {
            return of_column(0);
        }
        let columns = self.columns.iter().enumerate();
        columns.map(|(index, (key, _))| ((*key).to_owned(), of_column(index))).collect()
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
        let places: Vec<usize> = view
            .columns
            .iter()
            .filter_map(|name| self.columns.iter().position(|column| column.name == *name))
            .collect();
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

    fn json(&self) -> Value {
        let record = |row: &Vec<Figure>| -> Value {
            let cells = self.columns.iter().zip(row);
            cells.map(|(column, cell)| (column.key(Format::Json), cell.json())).collect()
        };
        self.rows.iter().map(record).collect()
    }

    fn csv(&self) -> Result<String, Failure> {
        let header: Vec<String> = self.columns.iter().map(|column| column.key(Format::Csv)).collect();
        let header: Vec<&str> = header.iter().map(String::as_str).collect();
        output::csv(&header, self.rows.iter().map(|row| row.iter().map(|cell| cell.csv().0).collect()))
    }

    fn lines(&self) -> Vec<Vec<String>> {
        // As many columns as it takes to tell the things apart.
        let are_apart = |named: &usize| {
            let mut seen = std::collections::BTreeSet::new();
            self.rows.iter().all(|row| seen.insert(named_by(row, *named)))
        };
        let named = (1..self.columns.len()).find(are_apart).unwrap_or(1);
        let line = |item: &str, column: &Column, cell: &Figure| {
            let (value, unit) = cell.csv();
            vec![self.name.to_owned(), item.to_owned(), column.name.to_owned(), value, unit]
        };
        let record = |row: &Vec<Figure>| -> Vec<Vec<String>> {
            let item = named_by(row, named);
            self.columns.iter().zip(row).skip(named).map(|(column, cell)| line(&item, column, cell)).collect()
        };
        self.rows.iter().flat_map(record).collect()
    }
}

/// Text within the width of the tables, after a list mark or none.
pub(crate) fn wrapped(mark: &str, text: &str) -> String {
    let width = usize::from(output::WIDTH);
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

/// The cells of the first columns, which name a thing.
fn named_by(row: &[Figure], columns: usize) -> String {
    row[..columns].iter().map(|cell| cell.csv().0).collect::<Vec<_>>().join(" ")
}
