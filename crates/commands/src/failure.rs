//! Failures that end the program, with their exit codes.
//!
//! - 0: answered
//! - 1: nothing found: the question is sound and has no answer within its bounds
//! - 2: wrong usage, or an invalid input
//! - 3: a file or stream that cannot be read or written
//! - 130: asked to end: Ctrl-C, or SIGTERM

use crate::refused::Refused;
use crate::shared::drawability::answer::Conflict;
use crate::shared::drawability::table as drawability;
use crate::shared::fault::Fault;
use epicyclic_formats::gearbox::gear_place;
use epicyclic_formats::{Document, Path, Problem, motor};
use epicyclic_units::visible::one_line;
use std::io;
use std::ops::ControlFlow;
use std::path::PathBuf;

/// Nothing meets the requirements.
const NOTHING_FOUND: u8 = 1;
/// Wrong usage, or an input that cannot be.
pub const WRONG: u8 = 2;
/// A file or stream that fails.
const INPUT_OUTPUT: u8 = 3;
/// Asked to end.
pub const INTERRUPTED: u8 = 130;

/// Message of a call that was ended before any result existed.
pub const NOTHING_TO_SHOW: &str = "interrupted: ended before there was an answer; no file is half-written";

/// Exit codes, as shown in the help.
pub const EXIT_CODES: &str = "\
Exit codes:
  0  answered
  1  nothing found: no design, set of tooth numbers, scheme or motor meets
     the requirements
  2  wrong usage, or an input that cannot be
  3  a file or stream that cannot be read or written; a reader that
     leaves before the end, as head does, is told nothing
  130  asked to end, by Ctrl-C or SIGTERM; within a second, with what was
     found where there is something to show, and no file half-written";

/// A refusal, shown after `error: `.
#[derive(Debug, thiserror::Error, strum::IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
pub enum Failure {
    /// A file that cannot be read.
    #[error("{}: cannot be read: {source}", file.display())]
    #[strum(serialize = "cannot-be-read")]
    Read {
        /// The file.
        file: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// An answer that cannot be written.
    #[error("{}: cannot be written: {source}{}", file.display(), if file.is_file() { "; it is unchanged" } else { "" })]
    #[strum(serialize = "cannot-be-written")]
    Write {
        /// The file.
        file: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// A file to write that is named `-`.
    #[error(
        "{option} -: a - is no file; leave --output out for standard output, or write ./- for a file of that name"
    )]
    WrittenDash {
        /// The option.
        option: String,
    },
    /// Standard output that takes nothing.
    #[error("standard output: {0}")]
    StandardOutput(io::Error),
    /// A fault in a file, with its line and column.
    #[error(transparent)]
    Document(#[from] epicyclic_formats::Error),
    /// A question without an answer.
    #[error(transparent)]
    Answer(#[from] crate::error::Error),
    /// An answer that cannot be shown.
    #[error(transparent)]
    #[strum(serialize = "not-finite")]
    View(crate::table::text::Error),
    /// Requirements that no gear meets.
    #[error(transparent)]
    Gear(#[from] epicyclic_gears::Error),
    /// A ratio that no set of tooth numbers has, and how several sets have it.
    #[error("{error}{hint}")]
    NoToothNumbers {
        /// The ratio and the bounds.
        error: epicyclic_gears::Error,
        /// Several sets in series, or nothing.
        hint: String,
    },
    /// A gearbox that cannot be analysed so.
    #[error(transparent)]
    Gearbox(#[from] epicyclic_train::Error),
    /// Requirements on the catalogue or of a machine that nothing meets.
    #[error(transparent)]
    Design(#[from] epicyclic_schemes::Error),
    /// A selection that cannot be made.
    #[error(transparent)]
    Selection(epicyclic_selection::Error),
    /// A gearbox that no drawing in the half-plane exists of.
    #[error(
        "{gearbox} crosses itself: {}\n{}\nwithout any one of these the rest can be drawn; views without a scheme: speeds, levers, ladder",
        drawability::shut_in(conflict),
        drawability::together(conflict)
    )]
    SelfCrossing {
        /// The gearbox.
        gearbox: String,
        /// Links and sets that prevent the drawing.
        conflict: Box<Conflict>,
    },
    /// A picture that cannot be made.
    #[error(transparent)]
    #[strum(serialize = "no-picture")]
    Picture(#[from] epicyclic_pictures::Error),
    /// An answer that lists no solution.
    #[error("{0}")]
    NothingFound(String),
    /// A call that was asked to end.
    #[error("{0}")]
    Interrupted(String),
    /// A search that takes too long here, with the commands to divide it.
    #[error("{0}")]
    TooLong(String),
    /// A table of a search that cannot be used.
    #[cfg(feature = "tables")]
    #[error(transparent)]
    Table(#[from] epicyclic_tables::Error),
    /// A hydromotor that cannot be.
    #[error(transparent)]
    Motor(#[from] epicyclic_hydromotor::Error),
    /// An invalid value of an option.
    #[error("{option}: {message}")]
    Option {
        /// The name of the fault.
        name: &'static str,
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
    /// An output that would replace the input, or another output.
    #[error("{one} and {other} are one file; {remedy}")]
    OneFile {
        /// The option and its file.
        one: String,
        /// The other option, or what is read, and its file.
        other: String,
        /// Change that resolves the conflict.
        remedy: &'static str,
    },
    /// An answer that cannot be put in its format.
    #[error("the answer cannot be written as text: {0}")]
    #[strum(serialize = "not-writable")]
    Format(String),
}

/// Name of the fault of a value that an option cannot have; clap's faults have its own kinds as names.
pub const INVALID: &str = "invalid-value";

impl Failure {
    /// Refuses the value of an option.
    pub fn invalid(option: &'static str, message: impl Into<String>) -> Self {
        Self::named(INVALID, option, message)
    }

    /// Refuses an option by the name of a fault.
    pub(crate) fn named(name: &'static str, option: &'static str, message: impl Into<String>) -> Self {
        Self::Option { name, option, message: message.into() }
    }

    /// Refuses the place of a design beyond those that were found.
    pub(crate) fn no_such_design(message: impl Into<String>) -> Self {
        Self::named("no-such-design", "--nth", message)
    }

    /// Refuses an option that does not go with another one, or with what is read.
    pub(crate) fn conflict(option: &'static str, message: impl Into<String>) -> Self {
        Self::named("argument-conflict", option, message)
    }

    /// Asks for an option.
    pub(crate) fn missing(option: &'static str, message: impl Into<String>) -> Self {
        Self::named("missing-argument", option, message)
    }

    /// Refuses what an option says, by the error that it leads to.
    pub(crate) fn of_option(option: &'static str, error: &impl Fault) -> Self {
        Self::named(error.name(), option, error.to_string())
    }

    /// The failure as it is, or [`Failure::Interrupted`] where the call was asked to end: that ended the
    /// search, whatever it says.
    #[must_use]
    pub fn unless_asked_to_end(self, goes_on: ControlFlow<()>) -> Self {
        match self {
            Self::Interrupted(_) | Self::Read { .. } | Self::Write { .. } | Self::StandardOutput(_) => self,
            _ if goes_on.is_continue() => self,
            _ => Self::Interrupted(NOTHING_TO_SHOW.to_owned()),
        }
    }

    /// The exit code.
    #[must_use]
    pub fn code(&self) -> u8 {
        match self {
            Self::NothingFound(_)
            | Self::NoToothNumbers { .. }
            | Self::SelfCrossing { .. }
            | Self::Gear(
                epicyclic_gears::Error::NoToothNumbers { .. }
                | epicyclic_gears::Error::NoDoublePlanetSet { .. }
                | epicyclic_gears::Error::NoArrangement { .. },
            ) => NOTHING_FOUND,
            Self::Answer(error) if error.is_nothing_found() => NOTHING_FOUND,
            Self::Interrupted(_) => INTERRUPTED,
            Self::Read { .. } | Self::Write { .. } | Self::StandardOutput(_) | Self::Format(_) => {
                INPUT_OUTPUT
            }
            _ => WRONG,
        }
    }

    /// The name of the failure, which does not change: `no-tooth-numbers`.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Document(error) => error.name(),
            Self::Answer(error) => error.name(),
            Self::Gear(error) | Self::NoToothNumbers { error, .. } => error.name(),
            Self::Gearbox(error) => error.name(),
            Self::Design(error) => error.name(),
            Self::Selection(error) => error.name(),
            Self::Motor(error) => error.name(),
            Self::Option { name, .. } => name,
            Self::Range { .. } => INVALID,
            named => named.into(),
        }
    }

    /// The failure as an answer.
    #[must_use]
    pub fn as_answer(&self) -> Refused {
        let option = match self {
            Self::Option { option, .. } | Self::Range { option, .. } | Self::AllUndercut { option, .. } => {
                Some((*option).to_owned())
            }
            Self::WrittenDash { option } => Some(option.clone()),
            _ => None,
        };
        let refused = match self {
            Self::Answer(error) => Refused::of_answer(error, self.code()),
            _ => Refused::new(self.name(), self.to_string(), self.code()),
        };
        match self {
            Self::Document(error) => refused.in_file(error),
            _ => refused.of_option(option),
        }
    }

    /// Text of the failure for people. Names cannot break the line; only messages that list several things
    /// have several lines.
    pub fn told(&self) -> String {
        let text = self.to_string();
        match self {
            Self::SelfCrossing { .. } | Self::NothingFound(_) | Self::TooLong(_) => text,
            // Lines to paste are YAML as they stand.
            Self::Answer(crate::error::Error::MissingKeys { .. }) => {
                text.lines().map(one_line).collect::<Vec<_>>().join("\n")
            }
            // Names to choose from stand below each other, set in.
            Self::Option { .. } => text.split("\n  ").map(one_line).collect::<Vec<_>>().join("\n  "),
            // Each fault of a file is one line already, with its own `error: `.
            Self::Document(error) | Self::Answer(crate::error::Error::Document(error)) => {
                error.faults().map(ToString::to_string).collect::<Vec<_>>().join("\nerror: ")
            }
            _ => one_line(&text).into_owned(),
        }
    }

    /// Whether there is nothing to say: the reader has seen enough, as in `epicyclic … | head`.
    #[must_use]
    pub fn is_quiet(&self) -> bool {
        matches!(self, Self::StandardOutput(error) if error.kind() == io::ErrorKind::BrokenPipe)
    }
}

impl Failure {
    /// Adds the place in the file to an error of a picture or a figure: the name of a gear, otherwise the
    /// description of the gearbox or motor.
    pub fn in_file(self, document: &Document, base: &Path) -> Self {
        use epicyclic_pictures::Error as E;
        let gearbox = |key: &str| {
            let path = base.clone().key(key);
            if document.value_at(&path).is_some() { path } else { base.clone() }
        };
        let place = match &self {
            Self::Picture(E::SpeedsUnknown { gear, .. } | E::NoPower { gear, .. }) => {
                gear_place(document, base, gear, "name")
            }
            Self::Picture(E::NoRatio { .. }) => gearbox("gears"),
            Self::Picture(E::Motor(error))
            | Self::Motor(error)
            | Self::Answer(crate::error::Error::Motor(error)) => motor::place(error),
            Self::Answer(crate::error::Error::MotorKey { key, .. }) => {
                key.split('.').fold(Path::root(), Path::key)
            }
            Self::Picture(_)
            | Self::Answer(crate::error::Error::NotFinite { .. })
            | Self::View(crate::table::text::Error::NotFinite { .. }) => base.clone(),
            _ => return self,
        };
        document.error(&place, Problem::refused(self.name(), self.to_string())).into()
    }
}

impl From<crate::table::text::Error> for Failure {
    fn from(error: crate::table::text::Error) -> Self {
        match error {
            crate::table::text::Error::Picture(error) => Self::Picture(error),
            error => Self::View(error),
        }
    }
}

impl From<epicyclic_drawing::Error> for Failure {
    fn from(error: epicyclic_drawing::Error) -> Self {
        Self::Picture(error.into())
    }
}
