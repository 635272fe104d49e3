//! Refusal of an output that is an input or another output.
//!
//! The files that a command line names are found by its arguments, so that no command can forget the check: a
//! positional argument that is a path is read, an option that is one is written, but for those of [`READ`].
//! These are compared before anything is read or computed. Every file that is read joins them, also one that
//! only another file names: [`Files::keep`] compares it with the outputs of the command line,
//! [`Files::may_write`] every file that is written with all that were read.

use super::Desk;
use crate::failure::Failure;
use clap::parser::ValueSource;
use clap::{Arg, ArgMatches, ValueHint};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

/// The open file of standard input on systems that have it as a path; nothing of this name exists on others.
const STANDARD_INPUT: &str = "/dev/stdin";

/// Options whose file is read.
pub const READ: [&str; 4] = ["explain", "merge", "basis", "bearings"];

/// The files of a call.
#[derive(Debug, Default)]
pub struct Files {
    /// Inputs that the command line names, and every file that was read.
    read: Mutex<Vec<PathBuf>>,
    /// Outputs that the command line names, with their options.
    written: Vec<(String, PathBuf)>,
}

/// Whether an argument names a file.
#[must_use]
pub fn is_file(arg: &Arg) -> bool {
    matches!(arg.get_value_hint(), ValueHint::AnyPath | ValueHint::FilePath)
}

impl Files {
    /// Of a command line, with all commands below the program's.
    #[must_use]
    pub fn of(command: &clap::Command, matches: &ArgMatches) -> Self {
        let (mut read, mut written) = (vec![], vec![]);
        let mut level = Some((command, matches));
        while let Some((command, matches)) = level {
            for arg in command.get_arguments().filter(|arg| is_file(arg)) {
                let id = arg.get_id().as_str();
                if matches.value_source(id) != Some(ValueSource::CommandLine) {
                    continue;
                }
                for value in matches.get_raw(id).into_iter().flatten() {
                    match arg.get_long() {
                        Some(option) if READ.contains(&option) => read.push(value.into()),
                        Some(option) => written.push((format!("--{option}"), value.into())),
                        None => read.push(value.into()),
                    }
                }
            }
            level =
                matches.subcommand().and_then(|(name, below)| Some((command.find_subcommand(name)?, below)));
        }
        Self { read: Mutex::new(read), written }
    }

    /// Refuses two files of the command line that are one, and an output named `-`, which is standard input
    /// where something is read.
    pub fn are_apart(&self, desk: &dyn Desk) -> Result<(), Failure> {
        if let Some((option, _)) = self.written.iter().find(|(_, file)| file.as_os_str() == "-") {
            return Err(Failure::WrittenDash { option: option.clone() });
        }
        for (place, (option, file)) in self.written.iter().enumerate() {
            self.may_write(desk, file)?;
            let before = &self.written[..place];
            if let Some((first, other)) = before.iter().find(|(_, other)| desk.are_one_file(other, file)) {
                return Err(Failure::OneFile {
                    one: named(first, other),
                    other: named(option, file),
                    remedy: "name a file for each",
                });
            }
        }
        Ok(())
    }

    /// Keeps a file that is about to be read from the outputs of the call; standard input without a name.
    pub fn keep(&self, desk: &dyn Desk, input: Option<&Path>) -> Result<(), Failure> {
        let input = input.unwrap_or(Path::new(STANDARD_INPUT));
        match self.written.iter().find(|(_, file)| desk.are_one_file(input, file)) {
            Some((_, file)) if desk.exists(input) => Err(self.would_be_lost(input, file)),
            _ => {
                self.read.lock().unwrap_or_else(PoisonError::into_inner).push(input.to_owned());
                Ok(())
            }
        }
    }

    /// Refuses a file to write that is one of those read.
    pub fn may_write(&self, desk: &dyn Desk, file: &Path) -> Result<(), Failure> {
        let read = self.read.lock().unwrap_or_else(PoisonError::into_inner);
        let found = read.iter().find(|input| desk.exists(input) && desk.are_one_file(input, file));
        found.map_or(Ok(()), |input| Err(self.would_be_lost(input, file)))
    }

    fn would_be_lost(&self, input: &Path, file: &Path) -> Failure {
        let option = self.written.iter().find(|(_, written)| written == file);
        let other = if input == Path::new(STANDARD_INPUT) {
            "the file of standard input".to_owned()
        } else {
            named("the input", input)
        };
        Failure::OneFile {
            one: option.map_or_else(|| file.display().to_string(), |(option, file)| named(option, file)),
            other,
            remedy: "the input would be lost; name another file to write",
        }
    }
}

fn named(what: &str, file: &Path) -> String {
    format!("{what} {}", file.display())
}
