//! Formats of an answer, and where it goes.

use crate::failure::Failure;
use comfy_table::{CellAlignment, ContentArrangement, Table, presets};
use serde::Serialize;
use std::fs;
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard};

/// Columns that every table fits in, on whatever terminal.
pub(crate) const WIDTH: u16 = 80;

/// How the answer is written and where.
#[derive(Debug, clap::Args)]
pub(crate) struct OutputArgs {
    /// How the answer is written.
    #[arg(long, value_enum, default_value_t = Format::Table)]
    pub(crate) format: Format,

    #[command(flatten)]
    target: Target,
}

/// Where something is written.
#[derive(Debug, clap::Args)]
pub(crate) struct Target {
    /// File for the answer, written whole or not at all. Default: standard output.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// How an answer is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum Format {
    /// Tables for people, in the units of drawings.
    Table,
    /// JSON in SI units, which stand in the names.
    Json,
    /// Comma-separated values with a header.
    Csv,
}

impl OutputArgs {
    /// Whether the answer goes to a file, out of sight.
    pub(crate) fn is_file(&self) -> bool {
        self.target.output.is_some()
    }

    /// Writes the answer.
    pub(crate) fn write(&self, answer: &str) -> Result<(), Failure> {
        self.target.write(answer.as_bytes())
    }
}

impl Target {
    /// Writes all of it.
    pub(crate) fn write(&self, answer: &[u8]) -> Result<(), Failure> {
        match &self.output {
            Some(file) => write_file(file, answer),
            None => print(answer).map_err(Failure::StandardOutput),
        }
    }
}

/// Writes a file whole or not at all.
pub(crate) fn write_file(file: &Path, content: &[u8]) -> Result<(), Failure> {
    replace(file, content).map_err(|source| Failure::Write { file: file.to_owned(), source })
}

/// Writes to standard output.
pub(crate) fn say(text: &str) -> Result<(), Failure> {
    print(text.as_bytes()).map_err(Failure::StandardOutput)
}

fn print(text: &[u8]) -> io::Result<()> {
    let mut out = io::stdout().lock();
    out.write_all(text)?;
    out.flush()
}

/// A line on standard error. Nothing can be done where that fails.
pub(crate) fn complain(line: &str) {
    // The tests of whole command lines have no reader for it.
    if cfg!(test) {
        return;
    }
    let _ = writeln!(io::stderr(), "{line}");
}

/// Puts `bytes` into a file in one step: through a temporary file beside it, which takes its name when it is
/// complete. An existing file stays as it is until then, and keeps its permissions.
fn replace(file: &Path, bytes: &[u8]) -> io::Result<()> {
    let existing = match fs::metadata(file) {
        Ok(metadata) if metadata.is_dir() => return Err(ErrorKind::IsADirectory.into()),
        // A device or a pipe has no content to keep.
        Ok(metadata) if !metadata.is_file() => return fs::write(file, bytes),
        Ok(metadata) => Some(metadata.permissions()),
        Err(error) if error.kind() == ErrorKind::NotFound => None,
        Err(error) => return Err(error),
    };
    if existing.as_ref().is_some_and(fs::Permissions::readonly) {
        return Err(ErrorKind::PermissionDenied.into());
    }
    // Through a link, so that the link stays one.
    let file = if existing.is_some() { fs::canonicalize(file)? } else { file.to_owned() };
    let folder = match file.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    let mut builder = tempfile::Builder::new();
    builder.prefix(".epicyclic-");
    #[cfg(unix)]
    {
        // As for any new file: the umask takes its part.
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    if !folder.is_dir() {
        return Err(io::Error::new(ErrorKind::NotFound, format!("there is no folder {}", folder.display())));
    }
    let _whole = Whole::new();
    // The reason alone: the error also names the temporary file, which nobody asked for.
    let mut temporary = builder.tempfile_in(folder).map_err(|error| io::Error::from(error.kind()))?;
    temporary.write_all(bytes)?;
    temporary.as_file().sync_all()?;
    if let Some(permissions) = existing {
        temporary.as_file().set_permissions(permissions)?;
    }
    temporary.persist(&file).map_err(|error| io::Error::from(error.error.kind()))?;
    Ok(())
}

/// While it lives, Ctrl-C and a request to end wait: the file is then complete and nothing lies beside it.
///
/// The temporary file exists only from here to the renaming, since the text is ready before. What comes earlier finds
/// no file, and ends the program at once.
struct Whole(#[allow(dead_code, reason = "held, not read")] Option<MutexGuard<'static, ()>>);

static WRITING: Mutex<()> = Mutex::new(());

/// The exit code of a program that Ctrl-C ends.
const INTERRUPTED: i32 = 130;

impl Whole {
    fn new() -> Self {
        let wait_and_end = || {
            let _written = WRITING.lock();
            std::process::exit(INTERRUPTED);
        };
        // Where no handler can be set the window is as it was: short.
        let _ = ctrlc::set_handler(wait_and_end);
        Self(WRITING.lock().ok())
    }
}

/// JSON of an answer, with a final line break.
pub(crate) fn json(answer: &impl Serialize) -> Result<String, Failure> {
    let text = serde_json::to_string_pretty(answer).map_err(|error| Failure::Format(error.to_string()))?;
    Ok(text + "\n")
}

/// CSV of a header and rows.
pub(crate) fn csv(header: &[&str], rows: impl IntoIterator<Item = Vec<String>>) -> Result<String, Failure> {
    let fail = |error: csv::Error| Failure::Format(error.to_string());
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(header).map_err(fail)?;
    for row in rows {
        writer.write_record(row).map_err(fail)?;
    }
    let bytes = writer.into_inner().map_err(|error| Failure::Format(error.to_string()))?;
    String::from_utf8(bytes).map_err(|error| Failure::Format(error.to_string()))
}

/// A plain table; the columns at `right` are aligned to the right.
pub(crate) fn table(header: &[&str], rows: impl IntoIterator<Item = Vec<String>>, right: &[usize]) -> String {
    let mut table = Table::new();
    table.load_style(presets::NOTHING).set_content_arrangement(ContentArrangement::Dynamic).set_width(WIDTH);
    if header.iter().any(|title| !title.is_empty()) {
        table.set_header(header.to_vec());
    }
    table.add_rows(rows);
    for index in right {
        if let Some(column) = table.column_mut(*index) {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
    let lines = table.lines().map(|line| line.trim_end().to_owned() + "\n");
    lines.collect()
}
