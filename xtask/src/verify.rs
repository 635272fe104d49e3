//! `cargo xtask verify`: every published figure against what the crates compute.

use crate::cases::run::{Outcome, Snapshots, run as run_source};
use crate::cases::{index, load};
use crate::schema::write_whole;
use crate::{calculations, project_root, report};
use clap::{Args, ValueEnum};
use std::io::{self, Write};
use std::panic::resume_unwind;
use std::path::PathBuf;
use std::process::ExitCode;
use std::thread;

/// Run the spec cases and hold every published figure against the computed one.
///
/// Exit code 0 if everything holds, 1 if something does not, 2 if there was nothing to run.
#[derive(Debug, Default, Args)]
#[command(after_help = "Examples:\n  cargo xtask verify\n  cargo xtask verify excavator-dynamics\n  \
    cargo xtask verify shaft --format json\n  cargo xtask verify --html verification.html\n  cargo xtask verify --accept")]
pub struct Arguments {
    /// Only sources or cases whose name contains this.
    #[arg(default_value = "")]
    pub filter: String,
    /// How the outcome is written.
    #[arg(long, value_enum, default_value_t = Format::Human)]
    pub format: Format,
    /// Write the outcome as a page too: every figure with what is printed, computed and said of it.
    #[arg(long, value_name = "FILE")]
    pub html: Option<PathBuf>,
    /// Write changed snapshots and remove those without a case. Never touches what a case expects.
    #[arg(long)]
    pub accept: bool,
    /// Folder of the cases, one folder a source.
    #[arg(
        long,
        value_name = "FOLDER",
        help = "Folder of the cases, one folder a source [default: spec-cases]"
    )]
    pub cases: Option<PathBuf>,
}

/// How an outcome is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub enum Format {
    /// For people.
    #[default]
    Human,
    /// For programs: every figure with its place.
    Json,
    /// For continuous integration: a test a figure.
    Junit,
}

/// Runs the command.
///
/// # Errors
/// A message where the cases cannot be read at all.
pub fn run(arguments: &Arguments) -> Result<ExitCode, String> {
    let outcomes = outcomes(arguments)?;
    let text = match arguments.format {
        Format::Human => report::human::render(&outcomes, !arguments.filter.is_empty()),
        Format::Json => report::json::render(&outcomes)?,
        Format::Junit => report::junit::render(&outcomes)?,
    };
    if let Some(path) = &arguments.html {
        write_whole(path, &report::html::render(&outcomes))
            .map_err(|error| format!("{}: cannot be written: {error}", path.display()))?;
    }
    match io::stdout().lock().write_all(text.as_bytes()) {
        // A reader that has seen enough.
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => {}
        Err(error) => return Err(format!("the report cannot be written: {error}")),
        Ok(()) => {}
    }
    let holds = outcomes.iter().all(Outcome::holds);
    Ok(if holds { ExitCode::SUCCESS } else { ExitCode::from(1) })
}

/// Runs the cases that the arguments select.
///
/// # Errors
/// Errors of [`run`].
pub fn outcomes(arguments: &Arguments) -> Result<Vec<Outcome>, String> {
    let folder = arguments.cases.clone().unwrap_or_else(|| project_root().join("spec-cases"));
    let calculations = calculations::all();
    let sources = load::sources(&folder, &calculations)
        .map_err(|error| format!("the cases in {} cannot be read: {error}", folder.display()))?;
    if sources.is_empty() {
        let wanted = format!("a folder a source, each with {} and its cases", index::FILE);
        return Err(format!("no source in {}: it holds {wanted}", folder.display()));
    }
    let snapshots = if arguments.accept { Snapshots::Accept } else { Snapshots::Compare };
    let filter = arguments.filter.as_str();
    let selected = |outcome: &Outcome| {
        filter.is_empty()
            || outcome.cases > 0
            || outcome.source.contains(filter)
            || !outcome.faults.is_empty()
    };
    // Sources take nothing from each other: each runs in a thread of its own.
    let mut outcomes: Vec<Outcome> = thread::scope(|scope| {
        let calculations = &calculations;
        let run = |source| scope.spawn(move || run_source(source, calculations, filter, snapshots));
        let running: Vec<_> = sources.iter().map(run).collect();
        running.into_iter().map(|one| one.join().unwrap_or_else(|panic| resume_unwind(panic))).collect()
    });
    outcomes.retain(selected);
    if outcomes.iter().all(|outcome| outcome.cases == 0 && outcome.faults.is_empty()) {
        let names: Vec<&str> = sources.iter().map(|source| source.id.as_str()).collect();
        return Err(format!("no source or case has {filter:?} in its name; sources: {}", names.join(", ")));
    }
    report::texts::check(&folder.join("../"), filter.is_empty(), &mut outcomes);
    Ok(outcomes)
}
