//! What ends the program.

use std::io;
use std::path::PathBuf;

/// A refusal, shown after `error: `; the program then exits with 1.
#[derive(Debug, thiserror::Error)]
pub(crate) enum Failure {
    /// A file that cannot be read.
    #[error("{}: cannot be read: {source}", file.display())]
    Read {
        /// The file.
        file: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// An answer that cannot be written.
    #[error("{}: cannot be written: {source}{}", file.display(), if file.is_file() { "; it is unchanged" } else { "" })]
    Write {
        /// The file.
        file: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// Standard output that takes nothing.
    #[error("standard output: {0}")]
    StandardOutput(io::Error),
    /// A fault in a file, with its line and column.
    #[error(transparent)]
    Document(#[from] epicyclic_formats::Error),
    /// A demand that no gear meets.
    #[error(transparent)]
    Gear(#[from] epicyclic_gears::Error),
    /// A gearbox that cannot be analysed so.
    #[error(transparent)]
    Gearbox(#[from] epicyclic_schemes::Error),
    /// A demand on the catalogue or of a machine that nothing meets.
    #[error(transparent)]
    Design(#[from] epicyclic_schemes::DesignError),
    /// A selection that cannot be made.
    #[error(transparent)]
    Selection(epicyclic_schemes::selection::SelectionError),
    /// A hydromotor that cannot be.
    #[error(transparent)]
    Motor(#[from] epicyclic_hydromotor::Error),
    /// A search that no hydromotor passes.
    #[error("no motor within the limits: {funnel}")]
    NoMotor {
        /// What refused them.
        funnel: String,
    },
    /// A drawing that cannot be made.
    #[error(transparent)]
    Picture(#[from] epicyclic_pictures::Error),
    /// What an option says cannot be.
    #[error("{option}: {message}")]
    Option {
        /// The option.
        option: &'static str,
        /// Why.
        message: String,
    },
    /// Bounds of an option that its defaults contradict.
    #[error("{option} {error}")]
    Range {
        /// The option.
        option: &'static str,
        /// Why.
        error: epicyclic_formats::RangeError,
    },
    /// A range of teeth in which every wheel is undercut.
    #[error("{option} ..{most}: every such wheel is undercut; without undercut at least {least} teeth")]
    AllUndercut {
        /// The option.
        option: &'static str,
        /// The most teeth it allows.
        most: u32,
        /// The fewest without undercut.
        least: u32,
    },
    /// An answer that cannot be put in its format.
    #[error("the answer cannot be written as text: {0}")]
    Format(String),
}
