//! Tables of named columns as Parquet, and back. The bytes depend on the content alone: no time, no name of a
//! machine.

use crate::error::Error;
use bytes::Bytes;
use parquet::basic::Compression;
use parquet::column::writer::ColumnWriter;
use parquet::data_type::ByteArray;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::file::writer::{SerializedColumnWriter, SerializedFileWriter};
use parquet::record::Row;
use parquet::schema::parser::parse_message_type;
use std::fmt::Write as _;
use std::sync::Arc;

/// Rows of a row group, which a reader takes at once.
const GROUP: usize = 1 << 18;

/// A column: one value, or one list, in each row.
pub(crate) enum Column {
    Int(Vec<i32>),
    Long(Vec<i64>),
    Flag(Vec<bool>),
    Text(Vec<String>),
    Longs(Vec<Vec<i64>>),
    Doubles(Vec<Vec<f64>>),
    Texts(Vec<Vec<String>>),
}

impl Column {
    fn len(&self) -> usize {
        match self {
            Self::Int(values) => values.len(),
            Self::Long(values) => values.len(),
            Self::Flag(values) => values.len(),
            Self::Text(values) => values.len(),
            Self::Longs(values) => values.len(),
            Self::Doubles(values) => values.len(),
            Self::Texts(values) => values.len(),
        }
    }

    /// Line of the schema for this column.
    fn schema(&self, name: &str) -> String {
        let list = |of: &str| {
            format!("required group {name} (LIST) {{ repeated group list {{ required {of}; }} }}\n")
        };
        match self {
            Self::Int(_) => format!("required int32 {name};\n"),
            Self::Long(_) => format!("required int64 {name};\n"),
            Self::Flag(_) => format!("required boolean {name};\n"),
            Self::Text(_) => format!("required binary {name} (STRING);\n"),
            Self::Longs(_) => list("int64 element"),
            Self::Doubles(_) => list("double element"),
            Self::Texts(_) => list("binary element (STRING)"),
        }
    }

    /// Writes some rows.
    fn write(&self, rows: std::ops::Range<usize>, mut to: SerializedColumnWriter<'_>) -> Result<(), Error> {
        let bytes = |text: &String| ByteArray::from(text.as_str());
        match (self, to.untyped()) {
            (Self::Int(values), ColumnWriter::Int32ColumnWriter(to)) => {
                to.write_batch(&values[rows], None, None)?;
            }
            (Self::Long(values), ColumnWriter::Int64ColumnWriter(to)) => {
                to.write_batch(&values[rows], None, None)?;
            }
            (Self::Flag(values), ColumnWriter::BoolColumnWriter(to)) => {
                to.write_batch(&values[rows], None, None)?;
            }
            (Self::Text(values), ColumnWriter::ByteArrayColumnWriter(to)) => {
                let values: Vec<ByteArray> = values[rows].iter().map(bytes).collect();
                to.write_batch(&values, None, None)?;
            }
            (Self::Longs(lists), ColumnWriter::Int64ColumnWriter(to)) => {
                let (defined, repeated) = levels(&lists[rows.clone()]);
                to.write_batch(&lists[rows].concat(), Some(&defined), Some(&repeated))?;
            }
            (Self::Doubles(lists), ColumnWriter::DoubleColumnWriter(to)) => {
                let (defined, repeated) = levels(&lists[rows.clone()]);
                to.write_batch(&lists[rows].concat(), Some(&defined), Some(&repeated))?;
            }
            (Self::Texts(lists), ColumnWriter::ByteArrayColumnWriter(to)) => {
                let (defined, repeated) = levels(&lists[rows.clone()]);
                let values: Vec<ByteArray> = lists[rows].iter().flatten().map(bytes).collect();
                to.write_batch(&values, Some(&defined), Some(&repeated))?;
            }
            _ => unreachable!("the schema has the columns in their order"),
        }
        Ok(to.close()?)
    }
}

/// Levels of definition and of repetition: an empty list has one entry that is not defined, the others one
/// for each value.
fn levels<T>(lists: &[Vec<T>]) -> (Vec<i16>, Vec<i16>) {
    let entries = |list: &Vec<T>| list.len().max(1);
    let defined = lists.iter().flat_map(|list| vec![i16::from(!list.is_empty()); entries(list)]);
    let repeated = lists.iter().flat_map(|list| (0..entries(list)).map(|entry| i16::from(entry > 0)));
    (defined.collect(), repeated.collect())
}

/// Writes a table with its metadata.
pub(crate) fn write(
    name: &str,
    columns: &[(&str, Column)],
    told: &[(String, String)],
) -> Result<Vec<u8>, Error> {
    let mut schema = format!("message {name} {{\n");
    columns.iter().for_each(|(name, column)| schema.push_str(&column.schema(name)));
    let _ = write!(schema, "}}");
    let schema = Arc::new(parse_message_type(&schema)?);
    let told = told.iter().map(|(key, value)| KeyValue::new(key.clone(), value.clone())).collect();
    let properties = WriterProperties::builder()
        .set_compression(Compression::SNAPPY)
        .set_key_value_metadata(Some(told))
        .build();
    let mut bytes = Vec::new();
    let mut file = SerializedFileWriter::new(&mut bytes, schema, Arc::new(properties))?;
    let rows = columns.first().map_or(0, |(_, column)| column.len());
    for from in (0..rows).step_by(GROUP) {
        let mut group = file.next_row_group()?;
        let mut left = columns.iter();
        while let Some(to) = group.next_column()? {
            if let Some((_, column)) = left.next() {
                column.write(from..rows.min(from + GROUP), to)?;
            }
        }
        group.close()?;
    }
    file.close()?;
    Ok(bytes)
}

/// A table that was read: its rows and its metadata.
pub(crate) struct Read {
    pub(crate) rows: Vec<Row>,
    told: Vec<KeyValue>,
}

impl Read {
    /// Reads the bytes of a file.
    pub(crate) fn new(bytes: Vec<u8>) -> Result<Self, Error> {
        let file = SerializedFileReader::new(Bytes::from(bytes))?;
        let told = file.metadata().file_metadata().key_value_metadata().cloned().unwrap_or_default();
        let rows = file.get_row_iter(None)?.collect::<Result<_, _>>()?;
        Ok(Self { rows, told })
    }

    /// Metadata value of a key.
    pub(crate) fn told(&self, key: &str) -> Option<&str> {
        self.told.iter().find(|told| told.key == key).and_then(|told| told.value.as_deref())
    }

    /// Metadata whose keys begin with `below`, without that beginning.
    pub(crate) fn told_below<'t>(&'t self, below: &'t str) -> impl Iterator<Item = (&'t str, &'t str)> {
        self.told.iter().filter_map(move |told| Some((told.key.strip_prefix(below)?, told.value.as_deref()?)))
    }
}
