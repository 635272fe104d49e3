//! Surroundings of a call: files, a place for its answer and for messages, a clock, a way to end it.
//!
//! The program has a terminal and the disk for it, a page in a browser keeps files in memory, and
//! other languages mix both. No command reads, writes or prints but through its `Call`, so that all
//! of them answer alike.
//!
//! [`memory`] keeps files, answer and messages in memory; the desks with the disk are the program's.

pub mod apart;
pub mod memory;

use crate::failure::Failure;
use apart::Files;
use epicyclic_units::visible;
use std::ffi::OsString;
use std::io;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

/// A file that is to be written, and all of its content.
pub type Content = (PathBuf, Vec<u8>);

/// A writer of a content, piece by piece.
pub type Source<'a> = dyn FnMut(&mut dyn io::Write) -> io::Result<()> + 'a;

/// Content of a file that is read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Text {
    /// The whole content.
    Whole(Vec<u8>),
    /// More than is allowed, with its size in bytes; a device or pipe does not say how many.
    TooLarge {
        /// Size in bytes, where it is known.
        size: Option<u64>,
    },
}

/// A file that cannot be written, and why.
#[derive(Debug, thiserror::Error)]
#[error("{}: cannot be written: {why}", file.display())]
pub struct NotWritten {
    /// The file as it was named.
    pub file: PathBuf,
    /// Why.
    #[source]
    pub why: io::Error,
}

/// The surroundings of a call. Progress is reported from any thread, everything else from the
/// thread of the call.
pub trait Desk: Sync {
    /// The content of a file, or of standard input where no file is named, unless it has more bytes
    /// than `most`.
    ///
    /// # Errors
    /// Where it cannot be read.
    fn read(&self, file: Option<&Path>, most: u64) -> io::Result<Text>;

    /// Whether there is a file or anything else of this name.
    fn exists(&self, file: &Path) -> bool;

    /// Whether two paths mean one file, which may not be there yet. Nothing in a device or pipe is
    /// replaced, so these are never one.
    fn are_one_file(&self, one: &Path, other: &Path) -> bool;

    /// Writes files, each whole, and all of them or none; the last may be written as it comes.
    ///
    /// # Errors
    /// The file that cannot be written: then none is.
    fn write(&self, files: &[Content], streamed: Option<(&Path, &mut Source)>) -> Result<(), NotWritten>;

    /// Makes a folder, where it is not there.
    ///
    /// # Errors
    /// Where it cannot be made.
    fn make_folder(&self, folder: &Path) -> io::Result<()>;

    /// Removes a file, where it is there.
    ///
    /// # Errors
    /// Where it cannot be removed.
    fn remove(&self, file: &Path) -> io::Result<()>;

    /// Takes the answer, or a part of it.
    ///
    /// # Errors
    /// Where its reader takes no more.
    fn answer(&self, source: &mut Source) -> io::Result<()>;

    /// Takes the answer as JSON, where it goes to a file or in another form; a refusal, too. By
    /// default nobody wants it.
    ///
    /// # Errors
    /// Where it cannot be written as JSON.
    fn record(&self, source: &mut Source) -> io::Result<()> {
        let _ = source;
        Ok(())
    }

    /// Takes a message: a warning, a note, or why there is no answer.
    fn message(&self, text: &str);

    /// Takes help, which is an answer, or what is wrong with the words of a call. By default without colours.
    ///
    /// # Errors
    /// Where its reader takes no more.
    fn usage(&self, usage: &clap::Error) -> io::Result<()> {
        let text = usage.render().to_string();
        if usage.use_stderr() {
            self.message(text.trim_end());
            return Ok(());
        }
        self.answer(&mut |out| out.write_all(text.as_bytes()))
    }

    /// Whether the answer goes to a terminal.
    fn is_seen(&self) -> bool {
        false
    }

    /// Columns of the lines of tables; 80 where nothing is known of them.
    fn columns(&self) -> Option<usize> {
        None
    }

    /// Whether the progress of a search is wanted.
    fn shows_progress(&self) -> bool {
        false
    }

    /// Takes the progress of a search: a line for people, and the share that is done where it is
    /// known. `None` when it is over.
    fn progress(&self, told: Option<(&str, Option<f64>)>) {
        let _ = told;
    }

    /// From here on (`true`) a call that is asked to end answers with what was found; `false` withdraws that.
    fn hears(&self, hears: bool) {
        let _ = hears;
    }

    /// Seconds left for an answer after the call was asked to end, 0 if no time is left; `None` while the
    /// call goes on. Every search, motion and table asks from its thread after at most about 50 ms of work.
    fn asked_to_end(&self) -> Option<f64> {
        None
    }

    /// Threads that a search may take.
    fn threads(&self) -> usize {
        1
    }

    /// Seconds since any one moment.
    fn seconds(&self) -> f64;
}

/// Whether the call of a desk goes on.
pub fn goes_on(desk: &dyn Desk) -> ControlFlow<()> {
    if desk.asked_to_end().is_some() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
}

/// One call: its desk, its words, and whether it has answered.
pub struct Call<'d> {
    /// Files, streams and clock of the call.
    pub desk: &'d dyn Desk,
    /// Without the name of the program.
    pub words: Vec<OsString>,
    files: Files,
    has_answered: AtomicBool,
}

impl<'d> Call<'d> {
    /// A call that has not answered.
    pub fn new(desk: &'d dyn Desk, words: Vec<OsString>, files: Files) -> Self {
        Self { desk, words, files, has_answered: AtomicBool::new(false) }
    }

    /// Refuses outputs that are one file with an input or with each other.
    pub fn check_files(&self) -> Result<(), Failure> {
        self.files.are_apart(self.desk)
    }

    /// Reads an input, or standard input without a name: from here on no output of this call replaces it.
    pub fn read(&self, file: Option<&Path>, name: &str, most: u64) -> Result<Text, Failure> {
        self.files.keep(self.desk, file)?;
        self.desk.read(file, most).map_err(|source| Failure::Read { file: name.into(), source })
    }

    /// Whether the call goes on: the one means by which everything that takes long is ended.
    pub fn goes_on(&self) -> ControlFlow<()> {
        goes_on(self.desk)
    }

    /// Whether anything was answered: then there is an answer, whatever fails later.
    pub fn has_answered(&self) -> bool {
        self.has_answered.load(Ordering::Relaxed)
    }

    /// Writes to standard output.
    pub fn answer(&self, source: &mut Source) -> Result<(), Failure> {
        self.has_answered.store(true, Ordering::Relaxed);
        self.desk.answer(source).map_err(Failure::StandardOutput)
    }

    /// Writes a text to standard output.
    pub fn say(&self, text: &str) -> Result<(), Failure> {
        self.answer(&mut |out| out.write_all(text.as_bytes()))
    }

    /// Hands over the record of an answer that goes to a file or in another form.
    pub fn record(&self, answer: &mut Source) -> Result<(), Failure> {
        self.desk.record(answer).map_err(Failure::StandardOutput)
    }

    /// A line, or lines, beside the answer.
    pub fn complain(&self, text: &str) {
        self.desk.message(&visible::lines(text));
    }

    /// Writes files: all of them whole, or none.
    pub fn write(&self, files: &[Content]) -> Result<(), Failure> {
        self.write_and(files, None)
    }

    /// Writes files and one more, piece by piece, whose content is never held in memory: all of them or none.
    pub fn write_and(
        &self,
        files: &[Content],
        streamed: Option<(&Path, &mut Source)>,
    ) -> Result<(), Failure> {
        let named = files.iter().map(|(file, _)| file.as_path());
        for file in named.chain(streamed.as_ref().map(|(file, _)| *file)) {
            self.files.may_write(self.desk, file)?;
        }
        let written = self.desk.write(files, streamed);
        written.map_err(|NotWritten { file, why }| Failure::Write { file, source: why })
    }
}

/// A stretch of a call in which a request to end is answered with what was found.
pub struct Hearing<'d>(&'d dyn Desk);

impl<'d> Hearing<'d> {
    /// Begins the stretch.
    pub fn new(call: &Call<'d>) -> Self {
        call.desk.hears(true);
        Self(call.desk)
    }
}

impl Drop for Hearing<'_> {
    fn drop(&mut self) {
        self.0.hears(false);
    }
}
