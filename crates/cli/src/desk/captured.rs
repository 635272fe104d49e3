//! Desk with the files of the disk that keeps answer and messages in memory: for programs that call, and for
//! tests.

use super::disk;
use epicyclic_commands::desk::{Content, Desk, NotWritten, Source, Text};
use std::io;
use std::path::Path;
use std::sync::{Mutex, PoisonError};
use std::time::Instant;

/// Desk with the disk and without standard input that keeps answer and messages.
#[derive(Debug)]
pub struct Captured {
    told: Mutex<Told>,
    begun: Instant,
}

/// Answer and messages of a call.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Told {
    /// Answer that a program writes to its standard output.
    pub answer: Vec<u8>,
    /// Answer as JSON, if it goes to a file or has another format; without an answer, the reason.
    pub record: Option<Vec<u8>>,
    /// Messages besides the answer, each of one line or more.
    pub messages: Vec<String>,
}

impl Default for Captured {
    fn default() -> Self {
        Self { told: Mutex::default(), begun: Instant::now() }
    }
}

impl Captured {
    /// Returns the answer and messages.
    #[must_use]
    pub fn into_told(self) -> Told {
        self.told.into_inner().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Desk for Captured {
    fn read(&self, file: Option<&Path>, most: u64) -> io::Result<Text> {
        file.map_or(Ok(Text::Whole(vec![])), |file| disk::read(file, most))
    }

    fn exists(&self, file: &Path) -> bool {
        file.exists()
    }

    fn are_one_file(&self, one: &Path, other: &Path) -> bool {
        disk::are_one_file(one, other)
    }

    fn write(&self, files: &[Content], streamed: Option<(&Path, &mut Source)>) -> Result<(), NotWritten> {
        disk::write(files, streamed)
    }

    fn make_folder(&self, folder: &Path) -> io::Result<()> {
        disk::make_folder(folder)
    }

    fn remove(&self, file: &Path) -> io::Result<()> {
        disk::remove(file)
    }

    fn answer(&self, source: &mut Source) -> io::Result<()> {
        let mut part = vec![];
        let done = source(&mut part);
        self.told.lock().unwrap_or_else(PoisonError::into_inner).answer.append(&mut part);
        done
    }

    fn record(&self, source: &mut Source) -> io::Result<()> {
        let mut record = vec![];
        source(&mut record)?;
        // If an answer explains why nothing was found, the error behind it is less informative, so the first
        // record is kept.
        self.told.lock().unwrap_or_else(PoisonError::into_inner).record.get_or_insert(record);
        Ok(())
    }

    fn message(&self, text: &str) {
        self.told.lock().unwrap_or_else(PoisonError::into_inner).messages.push(text.to_owned());
    }

    fn threads(&self) -> usize {
        std::thread::available_parallelism().map_or(1, usize::from)
    }

    fn seconds(&self) -> f64 {
        self.begun.elapsed().as_secs_f64()
    }
}
