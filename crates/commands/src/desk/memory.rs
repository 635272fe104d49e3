//! Files, answer and messages kept in memory: for a page in a browser, and for tests.

use super::{Content, Desk, NotWritten, Source, Text};
use std::collections::BTreeMap;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// A desk in memory, with the files that a call may read. File names are compared as text: `a` and `./a` are
/// two files.
#[derive(Debug, Default)]
pub struct Memory {
    kept: Mutex<Kept>,
    clock: Option<fn() -> f64>,
}

/// Contents of a desk in memory.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Kept {
    /// The files, those that a call wrote among them.
    pub files: BTreeMap<PathBuf, Vec<u8>>,
    /// The names of the files that were written, in their order.
    pub written: Vec<PathBuf>,
    /// The answer: what a program writes to its standard output.
    pub answer: Vec<u8>,
    /// Messages written apart from the answer, each of one line or more.
    pub messages: Vec<String>,
}

impl Memory {
    /// A desk with these files. Without a clock no time passes.
    #[must_use]
    pub fn new(files: BTreeMap<PathBuf, Vec<u8>>, clock: Option<fn() -> f64>) -> Self {
        Self { kept: Mutex::new(Kept { files, ..Kept::default() }), clock }
    }

    /// Returns the contents after a call.
    #[must_use]
    pub fn into_kept(self) -> Kept {
        self.kept.into_inner().unwrap_or_else(PoisonError::into_inner)
    }

    fn kept(&self) -> MutexGuard<'_, Kept> {
        self.kept.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

fn no_file() -> io::Error {
    io::Error::new(ErrorKind::NotFound, "there is no file of this name")
}

impl Desk for Memory {
    fn read(&self, file: Option<&Path>, most: u64) -> io::Result<Text> {
        let kept = self.kept();
        let bytes = match file {
            Some(file) => kept.files.get(file).cloned().ok_or_else(no_file)?,
            None => vec![],
        };
        let size = bytes.len() as u64;
        Ok(if size > most { Text::TooLarge { size: Some(size) } } else { Text::Whole(bytes) })
    }

    fn exists(&self, file: &Path) -> bool {
        self.kept().files.contains_key(file)
    }

    fn are_one_file(&self, one: &Path, other: &Path) -> bool {
        one == other
    }

    fn write(&self, files: &[Content], streamed: Option<(&Path, &mut Source)>) -> Result<(), NotWritten> {
        let mut all = files.to_vec();
        if let Some((file, source)) = streamed {
            let mut content = vec![];
            source(&mut content).map_err(|why| NotWritten { file: file.to_owned(), why })?;
            all.push((file.to_owned(), content));
        }
        let mut kept = self.kept();
        for (file, content) in all {
            kept.written.push(file.clone());
            kept.files.insert(file, content);
        }
        Ok(())
    }

    fn make_folder(&self, _: &Path) -> io::Result<()> {
        Ok(())
    }

    fn remove(&self, file: &Path) -> io::Result<()> {
        let mut kept = self.kept();
        kept.files.remove(file);
        kept.written.retain(|written| written != file);
        Ok(())
    }

    fn answer(&self, source: &mut Source) -> io::Result<()> {
        // Not held while the answer is made: what makes it may ask for a file.
        let mut part = vec![];
        let done = source(&mut part);
        self.kept().answer.append(&mut part);
        done
    }

    fn message(&self, text: &str) {
        self.kept().messages.push(text.to_owned());
    }

    fn seconds(&self) -> f64 {
        self.clock.map_or(0.0, |clock| clock())
    }
}
