//! Formats of an answer, and where it goes.

use crate::answer::write_json;
use crate::answer::{Answer, Warning};
use crate::desk::{Call, Content, Source};
use crate::draw::answer::FileFormat;
use crate::drawing_file;
use crate::error::Error;
use crate::failure::Failure;
use crate::finite;
use crate::page::{Imprint, Sheet};
use crate::refused::Refused;
use crate::table::report::{AsReport, Report};
use crate::table::text::WIDTH;
use clap::ArgMatches;
use epicyclic_units::visible;
use serde::Serialize;
use std::ffi::OsString;
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

/// The fewest columns of tables, below which most numbers have no room beside their names.
const NARROWEST: usize = 20;

/// Heading of options without one, if the options before them have a heading.
pub(crate) const NO_HEADING: Option<&'static str> = None;

/// How the answer is written and where.
#[derive(Debug, clap::Args)]
pub struct OutputArgs {
    /// How the answer is written. Default: by the end of the name of --output, .json or .csv; else tables.
    #[arg(long, value_enum, help_heading = NO_HEADING)]
    format: Option<Format>,

    #[command(flatten)]
    target: Target,
}

/// Request of a command without a file, and where its answer goes. The variant of the subcommand has the help
/// text: of the types here the last one would give it.
#[derive(Debug, clap::Args)]
pub(crate) struct WithOutput<Request: clap::Args> {
    #[command(flatten)]
    pub(crate) request: Request,

    #[command(flatten)]
    pub(crate) output: OutputArgs,
}

/// Where something is written.
#[derive(Debug, clap::Args)]
pub struct Target {
    /// File for the answer, written whole or not at all. Default: standard output.
    #[arg(short, long, value_name = "FILE", help_heading = NO_HEADING)]
    output: Option<PathBuf>,
}

/// An answer of any command, in every form in which it is written.
pub(crate) trait Reply {
    /// Refuses infinity and NaN.
    ///
    /// # Errors
    /// [`Error::NotFinite`] with the key of the number.
    fn check(&self) -> Result<(), Error>;

    /// Writes the record as JSON.
    ///
    /// # Errors
    /// Those of the writer.
    fn json(&self, out: &mut dyn io::Write) -> io::Result<()>;

    /// Report from which tables and CSV are written.
    fn as_report(&self) -> Report;
}

impl<A: Answer + AsReport> Reply for A {
    fn check(&self) -> Result<(), Error> {
        finite::check(self)
    }

    fn json(&self, out: &mut dyn io::Write) -> io::Result<()> {
        write_json(self, out)
    }

    fn as_report(&self) -> Report {
        self.report()
    }
}

/// How an answer is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum Format {
    /// Tables for people, in the units of drawings.
    Table,
    /// JSON in SI units, which stand in the names.
    Json,
    /// Comma-separated values with a header.
    Csv,
}

impl OutputArgs {
    /// The file that the answer goes to.
    pub(crate) fn file(&self) -> Option<&Path> {
        self.target.file()
    }

    /// A file for a drawing, where its name ends like one: for commands that draw.
    pub(crate) fn drawing(&self) -> Option<(&Path, FileFormat)> {
        let file = self.file()?;
        Some((file, drawing_file::format_of(&drawing_file::end_of(file)?)?))
    }

    /// Options for the answer beside a drawing: if `--output` names the drawing, the answer goes to standard
    /// output.
    pub(crate) fn but_for_drawings(&self) -> Self {
        let output = self.target.output.clone().filter(|_| self.drawing().is_none());
        Self { format: self.format, target: Target { output } }
    }

    /// Whether the answer goes to a file, out of sight.
    pub(crate) fn is_file(&self) -> bool {
        self.target.output.is_some()
    }

    /// Whether it goes to a file or a pipe.
    pub(crate) fn is_out_of_sight(&self, call: &Call<'_>) -> bool {
        self.is_file() || !call.desk.is_seen()
    }

    /// How the answer is written.
    pub(crate) fn format(&self) -> Format {
        self.format.unwrap_or_else(|| match self.end().as_deref() {
            Some("json") => Format::Json,
            Some("csv") => Format::Csv,
            _ => Format::Table,
        })
    }

    /// The end of the name of the file.
    fn end(&self) -> Option<String> {
        Some(self.file()?.extension()?.to_str()?.to_ascii_lowercase())
    }

    /// Refuses tables in a file that its name says to be something else.
    fn check_end(&self) -> Result<(), Failure> {
        let Some(end) = self.end().filter(|_| self.format() == Format::Table) else { return Ok(()) };
        let remedy = match end.as_str() {
            "html" | "htm" => {
                "no page is made of this answer; `report` makes one of a gearbox, drive, motor or scenario, and compare, drive, motor, select and \
                 synthesize of theirs in a file that ends in .html"
            }
            "pdf" => "no PDF is made of it; print a page in a browser",
            "json" | "csv" => "these are tables; leave --format out, or name the file .txt",
            "png" | "svg" | "dxf" => "`draw` makes pictures",
            _ => return Ok(()),
        };
        Err(Failure::invalid("--output", format!("a file that ends in .{end}: {remedy}")))
    }

    /// Whether a page is asked for: tables into a file whose name ends in `.html`.
    pub(crate) fn is_page(&self) -> bool {
        self.format() == Format::Table && self.end().as_deref() == Some("html")
    }

    /// Writes an answer: JSON as it is, tables and CSV as they show it. Warnings that go to a file out of
    /// sight are shown as well, and those that CSV does not have.
    pub(crate) fn deliver(&self, call: &Call<'_>, answer: &dyn Reply) -> Result<(), Failure> {
        self.deliver_with(call, vec![], answer)
    }

    /// Delivers the answer together with other files of the call: either all are written or none.
    pub(crate) fn deliver_with(
        &self,
        call: &Call<'_>,
        files: Vec<Content>,
        answer: &dyn Reply,
    ) -> Result<(), Failure> {
        self.check_end()?;
        answer.check()?;
        // A view is made where it is shown, or where its warnings go to people beside a file.
        let report = (self.format() != Format::Json || self.is_file()).then(|| answer.as_report());
        match (self.format(), &report) {
            (Format::Json, _) => self.stream(call, &files, &mut |out| answer.json(out))?,
            (format, Some(report)) => {
                // In the units of drawings a number can be too large that is not in SI units.
                report.refuse_infinite()?;
                if format == Format::Csv {
                    self.stream(call, &files, &mut |out| report.csv(out))?;
                } else {
                    self.write_with(call, files, &report.table(self.width(call)))?;
                }
            }
            _ => unreachable!("a report is made for tables and CSV"),
        }
        self.record(call, answer)?;
        // A list in CSV has no place for them.
        if let Some(report) =
            report.filter(|one| self.is_file() || (self.format() == Format::Csv && one.is_list()))
        {
            tell(call, &report);
        }
        Ok(())
    }

    /// Writes an answer for programs as it comes, and other files of the same call: into a file whole or not
    /// at all.
    pub(crate) fn stream(
        &self,
        call: &Call<'_>,
        files: &[Content],
        source: &mut Source,
    ) -> Result<(), Failure> {
        if let Some(file) = self.file() {
            return call.write_and(files, Some((file, source)));
        }
        call.write(files)?;
        if !call.desk.is_seen() {
            return call.answer(source);
        }
        call.answer(&mut |out| {
            let mut shown = Shown { out, line: vec![] };
            source(&mut shown)?;
            shown.flush()
        })
    }

    /// Warnings of an answer that was streamed: where it goes to a file, out of sight, and where CSV has no
    /// place for them.
    pub(crate) fn tell_warnings(&self, call: &Call<'_>, warnings: &[Warning]) {
        if self.is_file() || self.format() == Format::Csv {
            warnings.iter().for_each(|warning| tell_warning(call, &warning.message));
        }
    }

    /// Columns of the lines of tables: as many as whoever reads the answer has; 80 in a file.
    fn width(&self, call: &Call<'_>) -> usize {
        if self.is_file() {
            return WIDTH;
        }
        call.desk.columns().map_or(WIDTH, |columns| columns.max(NARROWEST))
    }

    /// Writes a page about an answer, with other files of the same call, all of them or none. What the answer
    /// warns of is shown here as well.
    pub(crate) fn deliver_page(
        &self,
        call: &Call<'_>,
        files: Vec<Content>,
        answer: &dyn Reply,
        sheet: Result<Sheet, crate::table::text::Error>,
        imprint: &Imprint,
    ) -> Result<(), Failure> {
        answer.check()?;
        let report = answer.as_report();
        report.refuse_infinite()?;
        self.write_with(call, files, &sheet?.html(imprint)?)?;
        self.record(call, answer)?;
        tell(call, &report);
        Ok(())
    }

    /// Hands over the record, unless standard output has it.
    fn record(&self, call: &Call<'_>, answer: &dyn Reply) -> Result<(), Failure> {
        if self.has_json_out() { Ok(()) } else { call.record(&mut |out| answer.json(out)) }
    }

    /// Whether standard output has the answer as JSON.
    pub(crate) fn has_json_out(&self) -> bool {
        self.format() == Format::Json && !self.is_file()
    }

    /// Writes the answer and other files of the same call, all of them or none.
    pub(crate) fn write_with(
        &self,
        call: &Call<'_>,
        files: Vec<Content>,
        answer: &str,
    ) -> Result<(), Failure> {
        // For people, who may look at it in a terminal now or later.
        self.target.write_with(call, files, visible::lines(answer).as_bytes())
    }
}

/// Shows the warnings of a report.
fn tell(call: &Call<'_>, report: &Report) {
    report.warnings.iter().flatten().for_each(|(_, warning)| tell_warning(call, warning));
}

fn tell_warning(call: &Call<'_>, warning: &str) {
    call.complain(&format!("warning: {}", visible::one_line(warning)));
}

/// A terminal, which gets line by line what it can show.
struct Shown<'a> {
    out: &'a mut dyn io::Write,
    /// A line that has not ended.
    line: Vec<u8>,
}

impl io::Write for Shown<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.line.extend_from_slice(bytes);
        if let Some(end) = self.line.iter().rposition(|byte| *byte == b'\n') {
            let rest = self.line.split_off(end + 1);
            self.flush()?;
            self.line = rest;
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.write_all(visible::lines(&String::from_utf8_lossy(&self.line)).as_bytes())?;
        self.line.clear();
        Ok(())
    }
}

impl Target {
    /// The file that is written; `None` for standard output.
    pub(crate) fn file(&self) -> Option<&Path> {
        self.output.as_deref()
    }

    /// Refuses a page in a file that its name says to be something else.
    pub(crate) fn is_for_a_page(&self, is_page: bool) -> Result<(), Failure> {
        let end = self.output.as_deref().and_then(Path::extension).and_then(|end| end.to_str());
        let end = end.map(str::to_ascii_lowercase).filter(|_| is_page);
        let remedy = match end.as_deref() {
            Some("pdf") => "a page is HTML: name it .html, and print it in a browser",
            Some("json") => "a page is HTML: name it .html, or give --format json",
            Some("csv" | "txt" | "svg" | "png" | "dxf") => "a page is HTML: name it .html",
            _ => return Ok(()),
        };
        let end = end.unwrap_or_default();
        Err(Failure::invalid("--output", format!("a file that ends in .{end}: {remedy}")))
    }

    /// Writes all of it.
    pub fn write(&self, call: &Call<'_>, answer: &[u8]) -> Result<(), Failure> {
        self.write_with(call, vec![], answer)
    }

    fn write_with(&self, call: &Call<'_>, mut files: Vec<Content>, answer: &[u8]) -> Result<(), Failure> {
        match &self.output {
            Some(file) => {
                files.push((file.clone(), answer.to_vec()));
                call.write(&files)
            }
            None => {
                call.write(&files)?;
                match std::str::from_utf8(answer) {
                    // Programs get what there is, a terminal only what it can show.
                    Ok(text) if call.desk.is_seen() => call.say(&visible::lines(text)),
                    _ => call.answer(&mut |out| out.write_all(answer)),
                }
            }
        }
    }
}

/// Whether a command line asks for JSON on standard output.
#[must_use]
pub fn is_json_to_standard_output(matches: &ArgMatches) -> bool {
    let mut level = matches;
    while let Some((_, below)) = level.subcommand() {
        level = below;
    }
    let given = |id: &str| level.try_get_raw(id).ok().flatten().and_then(|mut values| values.next());
    given("format").is_some_and(|format| format == "json") && given("output").is_none()
}

/// Whether words that are no command line ask for JSON on standard output.
#[must_use]
pub fn asks_for_json(words: &[OsString]) -> bool {
    let words: Vec<_> =
        words.iter().map(|word| word.to_string_lossy()).take_while(|word| word != "--").collect();
    let is_json = words.iter().any(|word| word == "--format=json")
        || words.windows(2).any(|pair| pair[0] == "--format" && pair[1] == "json");
    let goes_to_a_file = |word: &str| {
        word == "--output"
            || word.starts_with("--output=")
            || (word.starts_with("-o") && !word.starts_with("--"))
    };
    is_json && !words.iter().any(|word| goes_to_a_file(word))
}

/// Writes the reason of a failure in place of the answer, unless an answer was written. Errors of this
/// writing are ignored: the failure was already shown.
pub fn in_place_of_an_answer(call: &Call<'_>, refused: &Refused) {
    if !call.has_answered() {
        let _ = call.answer(&mut |out| write_json(refused, out));
    }
}

/// JSON of an answer, with a final line break.
pub fn json(answer: &impl Serialize) -> Result<String, Failure> {
    let text = serde_json::to_string_pretty(answer).map_err(|error| Failure::Format(error.to_string()))?;
    Ok(text + "\n")
}
