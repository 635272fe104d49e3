//! Ctrl-C, and a request to end: the program ends at once, its temporary files removed; but a search that can tell what it has is asked
//! first, and ended at the second.

use std::fs;
use std::io::{Write as _, stderr};
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// The exit code of a program that Ctrl-C ends.
pub(crate) const INTERRUPTED: u8 = 130;

/// Temporary files of this program.
static PENDING: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// Temporary files of this program, which go when it is ended.
pub(crate) fn pending() -> MutexGuard<'static, Vec<PathBuf>> {
    PENDING.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Whether a search hears.
static HEARS: AtomicBool = AtomicBool::new(false);
/// Whether one that hears was asked to end.
static ASKED: AtomicBool = AtomicBool::new(false);

/// The length of a line of progress: what stood there before is covered.
pub(crate) const WIDTH: usize = 48;

/// Whether a line of progress stands on the terminal.
static SHOWS: AtomicBool = AtomicBool::new(false);

/// From here a line of progress may stand on the terminal, or no more.
pub(crate) fn line_stands(shows: bool) {
    SHOWS.store(shows, Ordering::SeqCst);
}

/// From here Ctrl-C and a request to end are heard. What comes earlier ends the program at once, and finds no temporary files.
pub(crate) fn hear() {
    let heard = || {
        if HEARS.load(Ordering::SeqCst) && !ASKED.swap(true, Ordering::SeqCst) {
            return;
        }
        for path in pending().iter() {
            let _ = fs::remove_file(path);
        }
        if SHOWS.load(Ordering::SeqCst) {
            let _ = write!(stderr(), "\r{:WIDTH$}\r", "");
        }
        std::process::exit(i32::from(INTERRUPTED));
    };
    // Where no handler can be set, a temporary file may be left, for the next call to remove.
    let _ = ctrlc::set_handler(heard);
}

/// A search that ends early where it is asked to. While this lives, the first Ctrl-C asks it; the second ends the program.
pub(crate) struct Hearing;

impl Hearing {
    /// A search that begins.
    pub(crate) fn new() -> Self {
        HEARS.store(true, Ordering::SeqCst);
        hear();
        Self
    }

    /// Whether it was asked to end.
    pub(crate) fn is_asked(&self) -> bool {
        ASKED.load(Ordering::SeqCst)
    }
}

impl Drop for Hearing {
    fn drop(&mut self) {
        HEARS.store(false, Ordering::SeqCst);
    }
}
