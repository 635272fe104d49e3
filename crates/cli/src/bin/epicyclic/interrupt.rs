//! Ctrl-C, and a request to end: the program ends at once, its temporary files removed; but a search that can tell what it has is asked
//! first, and ended at the second.

use epicyclic::INTERRUPTED;
use epicyclic::desk::disk::remove_temporary;
use std::io::{Write as _, stderr};
use std::sync::atomic::{AtomicBool, Ordering};

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
        let _nothing_more_is_written = remove_temporary();
        if SHOWS.load(Ordering::SeqCst) {
            let _ = write!(stderr(), "\r{:WIDTH$}\r", "");
        }
        std::process::exit(i32::from(INTERRUPTED));
    };
    // Where no handler can be set, a temporary file may be left, for the next call to remove.
    let _ = ctrlc::set_handler(heard);
}

/// From here, or no more, the first Ctrl-C asks a search to end; the second ends the program.
pub(crate) fn search_hears(hears: bool) {
    HEARS.store(hears, Ordering::SeqCst);
    if hears {
        hear();
    }
}

/// Whether a search was asked to end.
pub(crate) fn is_asked() -> bool {
    ASKED.load(Ordering::SeqCst)
}
