//! Figures once, written three ways.
//!
//! A table shows them in the units of drawings, JSON in SI units named by the keys, CSV in the units of drawings
//! with a column that names them.

use crate::failure::Failure;
use crate::output::{self, Format};
use epicyclic_formats::quantity::format::{in_unit, sensible_unit, trimmed};
use epicyclic_formats::{Dimension, Physical};
use serde_json::{Map, Value, json};

/// Significant digits in a table.
const DIGITS: usize = 5;

/// Significant digits in CSV.
const EXACT_DIGITS: usize = 12;

/// An answer: sections of figures, then warnings.
#[derive(Debug)]
pub(super) struct Report {
    pub(super) title: Option<String>,
    pub(super) sections: Vec<Section>,
    /// Name and text.
    pub(super) warnings: Vec<(&'static str, String)>,
}

/// Figures that belong together.
#[derive(Debug)]
pub(super) struct Section {
    /// Its key.
    pub(super) name: &'static str,
    /// Its heading.
    pub(super) title: &'static str,
    /// Key and heading of each column; none where every figure stands alone.
    pub(super) columns: &'static [(&'static str, &'static str)],
    pub(super) rows: Vec<Row>,
    /// A note below the table; empty for none.
    pub(super) note: &'static str,
}

/// A figure, or one for each column.
#[derive(Debug)]
pub(super) struct Row {
    /// Its key without unit.
    pub(super) name: &'static str,
    /// What it is.
    pub(super) label: &'static str,
    /// Its symbol.
    pub(super) symbol: &'static str,
    pub(super) cells: Vec<Figure>,
    /// A remark, in the table only.
    pub(super) remark: String,
}

impl Row {
    pub(super) fn new(
        name: &'static str,
        label: &'static str,
        symbol: &'static str,
        cells: impl Into<Vec<Figure>>,
    ) -> Self {
        Self { name, label, symbol, cells: cells.into(), remark: String::new() }
    }
}

/// A value.
#[derive(Debug, Clone)]
pub(super) enum Figure {
    /// Nothing to say.
    None,
    Count(u32),
    Number(f64),
    /// A part of a whole, shown in per cent.
    Share(f64),
    Quantity {
        si: f64,
        dimension: Dimension,
    },
    /// Several quantities of one kind.
    List {
        si: Vec<f64>,
        dimension: Dimension,
    },
    Text(String),
    /// One of a few answers: its name, and in words.
    Answer(&'static str, &'static str),
}

/// A figure of a quantity.
pub(super) fn quantity<T: Physical>(value: T) -> Figure {
    Figure::Quantity { si: value.si(), dimension: T::DIMENSION }
}

impl Report {
    pub(super) fn text(&self, format: Format) -> Result<String, Failure> {
        match format {
            Format::Table => Ok(self.table()),
            Format::Json => output::json(&self.json()),
            Format::Csv => self.csv(),
        }
    }

    fn table(&self) -> String {
        let mut text = self.title.as_ref().map(|title| format!("{title}\n\n")).unwrap_or_default();
        for section in &self.sections {
            text += &section.table();
            text.push('\n');
        }
        text += match self.warnings.len() {
            0 => "No warnings.\n",
            1 => "Warning\n",
            _ => "Warnings\n",
        };
        for (_, warning) in &self.warnings {
            text += &wrapped(" -", warning);
        }
        text
    }

    fn json(&self) -> Value {
        let mut root = Map::new();
        if let Some(title) = &self.title {
            root.insert("title".to_owned(), json!(title));
        }
        for section in &self.sections {
            match (root.get_mut(section.name), section.json()) {
                // Sections of one name share one object.
                (Some(Value::Object(there)), Value::Object(more)) => there.extend(more),
                (_, value) => _ = root.insert(section.name.to_owned(), value),
            }
        }
        let warning = |(name, message): &(_, String)| json!({ "name": name, "message": message });
        root.insert("warnings".to_owned(), self.warnings.iter().map(warning).collect());
        Value::Object(root)
    }

    fn csv(&self) -> Result<String, Failure> {
        let figures = self.sections.iter().flat_map(|section| {
            section.rows.iter().flat_map(move |row| {
                row.cells.iter().enumerate().map(move |(index, cell)| {
                    let column = section.columns.get(index).map_or("", |(key, _)| key);
                    let (value, unit) = cell.csv();
                    vec![section.name.to_owned(), column.to_owned(), row.name.to_owned(), value, unit]
                })
            })
        });
        let warnings = self.warnings.iter().map(|(name, message)| {
            vec!["warnings".to_owned(), String::new(), (*name).to_owned(), message.clone(), String::new()]
        });
        output::csv(&["section", "item", "quantity", "value", "unit"], figures.chain(warnings))
    }
}

impl Section {
    fn table(&self) -> String {
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
        let right: Vec<usize> = (2..2 + self.columns.len().max(1) + usize::from(remarks)).collect();
        let note = if self.note.is_empty() { String::new() } else { wrapped("", self.note) };
        format!("{}\n{}{note}", self.title, output::table(&header, rows, &right))
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
}

impl Figure {
    fn table(&self) -> String {
        match self {
            Self::None => "-".to_owned(),
            Self::Count(count) => count.to_string(),
            Self::Number(value) => trimmed(*value, DIGITS),
            Self::Share(value) => format!("{} %", trimmed(100.0 * value, 3)),
            Self::Quantity { si, dimension } => in_unit(*si, sensible_unit(*dimension, *si), DIGITS),
            Self::List { si, dimension } => {
                let unit = dimension.usual_unit();
                let values: Vec<String> = si.iter().map(|si| trimmed(si / unit.factor, DIGITS)).collect();
                format!("{} {}", values.join(" "), unit.symbol)
            }
            Self::Text(text) => text.clone(),
            Self::Answer(_, words) => (*words).to_owned(),
        }
    }

    fn csv(&self) -> (String, String) {
        let usual =
            |dimension: &Dimension| (dimension.usual_unit().factor, dimension.usual_unit().symbol.to_owned());
        match self {
            Self::None => (String::new(), String::new()),
            Self::Count(count) => (count.to_string(), String::new()),
            Self::Number(value) | Self::Share(value) => (trimmed(*value, EXACT_DIGITS), String::new()),
            Self::Quantity { si, dimension } => {
                let (factor, symbol) = usual(dimension);
                (trimmed(si / factor, EXACT_DIGITS), symbol)
            }
            Self::List { si, dimension } => {
                let (factor, symbol) = usual(dimension);
                let values: Vec<String> = si.iter().map(|si| trimmed(si / factor, EXACT_DIGITS)).collect();
                (values.join(" "), symbol)
            }
            Self::Text(text) => (text.clone(), String::new()),
            Self::Answer(name, _) => ((*name).to_owned(), String::new()),
        }
    }

    fn json(&self) -> Value {
        match self {
            Self::None => Value::Null,
            Self::Count(count) => json!(count),
            Self::Number(value) | Self::Share(value) | Self::Quantity { si: value, .. } => json!(value),
            Self::List { si, .. } => json!(si),
            Self::Text(text) => json!(text),
            Self::Answer(name, _) => json!(name),
        }
    }

    /// The SI unit as part of a key: `_kg_m2`.
    const fn suffix(&self) -> &'static str {
        match self {
            Self::Quantity { dimension, .. } | Self::List { dimension, .. } => match dimension {
                Dimension::Length => "_m",
                Dimension::Mass => "_kg",
                Dimension::Inertia => "_kg_m2",
                Dimension::AngularSpeed => "_rad_s",
                Dimension::AngularAcceleration => "_rad_s2",
                Dimension::Angle => "_rad",
                Dimension::Force => "_n",
                Dimension::Torque => "_n_m",
                Dimension::Power => "_w",
                Dimension::Pressure => "_pa",
                Dimension::Energy => "_j",
                Dimension::Time => "_s",
                _ => "",
            },
            _ => "",
        }
    }
}

/// Text within the width of the tables, after a list mark or none.
fn wrapped(mark: &str, text: &str) -> String {
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
