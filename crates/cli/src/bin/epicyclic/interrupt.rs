//! Ctrl-C, and a request to end (SIGTERM, SIGHUP): the program ends at once, its temporary files removed; but
//! where something was found that can be told, it is asked first to end by itself, and ended at the second
//! signal, or where it does not end in time.

use epicyclic::desk::disk::remove_temporary;
use epicyclic_commands::failure::{INTERRUPTED, NOTHING_TO_SHOW};
use std::io::{Write as _, stderr};
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, AtomicU8, Ordering};
use std::thread;
use std::time::{Duration, Instant};

/// What was found has to be told so long after the first signal.
const TO_TELL: Duration = Duration::from_millis(600);
/// What is not over so long after it is ended: work that does not hear.
const TO_STOP: Duration = Duration::from_millis(900);
/// And where what was found is being told: somebody who reads it may be slow, but not for ever.
const TO_WRITE: Duration = Duration::from_secs(3);

/// Whether there is something to tell.
static HEARS: AtomicBool = AtomicBool::new(false);
/// When the program was asked to end.
static ASKED: OnceLock<Instant> = OnceLock::new();
/// How much of the answer is written, one of these.
static WRITTEN: AtomicU8 = AtomicU8::new(NOTHING);
const NOTHING: u8 = 0;
const PART: u8 = 1;
const ALL: u8 = 2;

/// The length of a line of progress: what stood there before is covered.
pub(crate) const WIDTH: usize = 48;

/// Whether a line of progress stands on the terminal.
static SHOWS: AtomicBool = AtomicBool::new(false);

/// From here a line of progress may stand on the terminal, or no more.
pub(crate) fn line_stands(shows: bool) {
    SHOWS.store(shows, Ordering::SeqCst);
}

/// From here a part of the answer is written, or all that there was so far.
pub(crate) fn answers(is_whole: bool) {
    WRITTEN.store(if is_whole { ALL } else { PART }, Ordering::SeqCst);
}

/// From here signals are heard.
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
    // Where no handler can be set the signal ends the program, and a temporary file may be left, for the next
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

/// From here, or no more, there is something to tell: the first signal asks for it, the second ends the
/// program.
pub(crate) fn search_hears(hears: bool) {
    HEARS.store(hears, Ordering::SeqCst);
}

/// Whether the program was asked to end: then how many seconds are left to tell what was found.
pub(crate) fn asked() -> Option<f64> {
    let asked = ASKED.get()?;
    Some(TO_TELL.saturating_sub(asked.elapsed()).as_secs_f64())
}
