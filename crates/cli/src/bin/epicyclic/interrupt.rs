//! Handling of Ctrl-C and of requests to end (SIGTERM, SIGHUP): the program removes its temporary files and
//! ends at once. If a search has results to print, it is first asked to stop. It is ended at the second
//! signal, or if it does not stop in time.

use epicyclic::desk::disk::remove_temporary;
use epicyclic_commands::failure::{INTERRUPTED, NOTHING_TO_SHOW};
use std::io::{Write as _, stderr};
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, AtomicU8, Ordering};
use std::thread;
use std::time::{Duration, Instant};

/// Time after the first signal by which a search must begin to print its results.
const TO_TELL: Duration = Duration::from_millis(600);
/// Time after the first signal at which work that does not react is ended.
const TO_STOP: Duration = Duration::from_millis(900);
/// Time after the first signal at which the program ends while it prints results: a reader may be slow, but
/// not forever.
const TO_WRITE: Duration = Duration::from_secs(3);

/// Whether a search has results to print, and is asked to stop.
static HEARS: AtomicBool = AtomicBool::new(false);
/// Time of the first signal.
static ASKED: OnceLock<Instant> = OnceLock::new();
/// Progress of the output: one of the constants below.
static WRITTEN: AtomicU8 = AtomicU8::new(NOTHING);
const NOTHING: u8 = 0;
const PART: u8 = 1;
const ALL: u8 = 2;

/// Width of a line of progress, which covers the previous one.
pub(crate) const WIDTH: usize = 48;

/// Whether a line of progress is shown on the terminal.
static SHOWS: AtomicBool = AtomicBool::new(false);

/// Sets whether a line of progress is shown on the terminal.
pub(crate) fn line_stands(shows: bool) {
    SHOWS.store(shows, Ordering::SeqCst);
}

/// Records that a part of the answer is written, or all results so far.
pub(crate) fn answers(is_whole: bool) {
    WRITTEN.store(if is_whole { ALL } else { PART }, Ordering::SeqCst);
}

/// Installs the signal handlers.
pub(crate) fn hear() {
    let heard = || {
        if !HEARS.load(Ordering::SeqCst) || ASKED.set(Instant::now()).is_err() {
            end();
        }
        let last = || {
            thread::sleep(TO_STOP);
            if !HEARS.load(Ordering::SeqCst) {
                thread::sleep(TO_WRITE - TO_STOP);
            }
            end();
        };
        if thread::Builder::new().spawn(last).is_err() {
            end();
        }
    };
    // If no handler can be set, the signal ends the program, and a temporary file may remain for the next
    // call to remove.
    let _ = ctrlc::set_handler(heard);
}

/// Ends the program.
fn end() -> ! {
    let _nothing_more_is_written = remove_temporary();
    if SHOWS.load(Ordering::SeqCst) {
        let _ = write!(stderr(), "\r{:WIDTH$}\r", "");
    }
    let told = match WRITTEN.load(Ordering::SeqCst) {
        NOTHING => NOTHING_TO_SHOW,
        PART => "interrupted: ended while the answer was written; it is not whole",
        _ => "interrupted",
    };
    let _ = writeln!(stderr(), "error: {told}");
    std::process::exit(i32::from(INTERRUPTED));
}

/// Sets whether a search has results to print: the first signal then asks it to stop, the second ends the
/// program.
pub(crate) fn search_hears(hears: bool) {
    HEARS.store(hears, Ordering::SeqCst);
}

/// Seconds left to print results if the program was asked to end; otherwise `None`.
pub(crate) fn asked() -> Option<f64> {
    let asked = ASKED.get()?;
    Some(TO_TELL.saturating_sub(asked.elapsed()).as_secs_f64())
}
