//! The files of the disk, with the answer and the messages of a call kept in memory: for programs that call,
//! and for tests.

use super::disk;
use epicyclic_commands::desk::{Content, Desk, NotWritten, Source, Text};
use std::io;
use std::path::Path;
use std::sync::{Mutex, PoisonError};
use std::time::Instant;

/// A desk with the disk, without standard input, that keeps what is told.
#[derive(Debug)]
pub struct Captured {
    told: Mutex<Told>,
    begun: Instant,
}

/// What a call told.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Told {
    /// The answer: what a program writes to its standard output.
    pub answer: Vec<u8>,
    /// The answer as JSON, where it goes to a file or in another form; where there is none, why.
    pub record: Option<Vec<u8>>,
    /// What stands beside the answer, each message of one line or more.
    pub messages: Vec<String>,
}

impl Default for Captured {
    fn default() -> Self {
        Self { told: Mutex::default(), begun: Instant::now() }
    }
}

impl Captured {
    /// What was told.
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
        // Where an answer says why nothing was found, the refusal behind it says less.
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
