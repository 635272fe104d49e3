//! A call of the command line over a desk that Python furnishes: files in its memory before those of the
//! disk.

use crate::work::{self, Shared};
use epicyclic::desk::captured::{Captured, Told};
use epicyclic::desk::{Content, Desk, NotWritten, Source, Text};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

/// The desk of a call from Python.
struct Desktop<'s> {
    /// The disk, the answer and the messages.
    captured: Captured,
    /// Files in Python's memory.
    files: BTreeMap<PathBuf, Vec<u8>>,
    /// Names of files that go back to Python in place of the disk, and those that did.
    kept: Vec<PathBuf>,
    written: Mutex<Vec<Content>>,
    shared: &'s Shared,
}

impl Desk for Desktop<'_> {
    fn read(&self, file: Option<&Path>, most: u64) -> io::Result<Text> {
        match file.and_then(|file| self.files.get(file)) {
            Some(bytes) if bytes.len() as u64 > most => Ok(Text::TooLarge { size: Some(bytes.len() as u64) }),
            Some(bytes) => Ok(Text::Whole(bytes.clone())),
            None => self.captured.read(file, most),
        }
    }

    fn exists(&self, file: &Path) -> bool {
        self.files.contains_key(file) || self.captured.exists(file)
    }

    fn are_one_file(&self, one: &Path, other: &Path) -> bool {
        let is_in_memory =
            |file: &Path| self.files.contains_key(file) || self.kept.iter().any(|own| own == file);
        if is_in_memory(one) || is_in_memory(other) {
            one == other
        } else {
            self.captured.are_one_file(one, other)
        }
    }

    fn write(&self, files: &[Content], streamed: Option<(&Path, &mut Source)>) -> Result<(), NotWritten> {
        let (kept, others): (Vec<&Content>, Vec<&Content>) =
            files.iter().partition(|(file, _)| self.kept.contains(file));
        let mut written: Vec<Content> = kept.into_iter().cloned().collect();
        let others: Vec<Content> = others.into_iter().cloned().collect();
        match streamed {
            Some((file, source)) if self.kept.iter().any(|own| own == file) => {
                let mut content = vec![];
                source(&mut content).map_err(|why| NotWritten { file: file.to_owned(), why })?;
                written.push((file.to_owned(), content));
                self.captured.write(&others, None)?;
            }
            streamed => self.captured.write(&others, streamed)?,
        }
        self.written.lock().unwrap_or_else(PoisonError::into_inner).append(&mut written);
        Ok(())
    }

    fn make_folder(&self, folder: &Path) -> io::Result<()> {
        self.captured.make_folder(folder)
    }

    fn remove(&self, file: &Path) -> io::Result<()> {
        self.captured.remove(file)
    }

    fn answer(&self, source: &mut Source) -> io::Result<()> {
        self.captured.answer(source)
    }

    fn record(&self, source: &mut Source) -> io::Result<()> {
        self.captured.record(source)
    }

    fn message(&self, text: &str) {
        self.captured.message(text);
    }

    fn shows_progress(&self) -> bool {
        true
    }

    fn progress(&self, told: Option<(&str, Option<f64>)>) {
        if let Some((line, _)) = told {
            self.shared.tell(line.to_owned());
        }
    }

    fn asked_to_end(&self) -> Option<f64> {
        self.shared.is_ended().then_some(0.0)
    }

    fn threads(&self) -> usize {
        self.captured.threads()
    }

    fn seconds(&self) -> f64 {
        self.captured.seconds()
    }
}

/// Exit code, answer with messages, and the written files that are returned to Python.
type Called = (u8, Told, Vec<Content>);

fn called(
    words: Vec<String>,
    files: BTreeMap<PathBuf, Vec<u8>>,
    kept: Vec<PathBuf>,
    shared: &Shared,
) -> Called {
    let desk = Desktop { captured: Captured::default(), files, kept, written: Mutex::default(), shared };
    let code = epicyclic::call(words, &desk);
    (code, desk.captured.into_told(), desk.written.into_inner().unwrap_or_else(PoisonError::into_inner))
}

/// Result for Python: exit code, answer, record if it differs from the answer, messages, and files.
type Answer<'py> =
    (u8, Bound<'py, PyBytes>, Option<Bound<'py, PyBytes>>, String, BTreeMap<String, Bound<'py, PyBytes>>);

/// Answers the words of a command line, without the name of the program.
///
/// `files` take precedence over files on disk. A file that is written under a name in `kept` is returned
/// instead.
#[pyfunction]
#[pyo3(signature = (line, files, kept, progress=None))]
pub(crate) fn call<'py>(
    py: Python<'py>,
    line: Vec<String>,
    files: BTreeMap<PathBuf, Vec<u8>>,
    kept: Vec<PathBuf>,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<Answer<'py>> {
    let (code, told, written) = work::done(py, progress, move |shared| called(line, files, kept, shared))?;
    let written = written
        .into_iter()
        .map(|(file, content)| (file.display().to_string(), PyBytes::new(py, &content)))
        .collect();
    let record = told.record.map(|record| PyBytes::new(py, &record));
    Ok((code, PyBytes::new(py, &told.answer), record, told.messages.join("\n"), written))
}
