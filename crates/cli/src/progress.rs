//! How far a long search is: one line on standard error, on a terminal alone.

use std::io::{IsTerminal, Write as _, stderr};
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// How often it is shown; what is done sooner shows nothing.
const SHOWN_EVERY: Duration = Duration::from_millis(100);

/// Progress of one search, from any of its threads. The line goes when this does.
pub(crate) struct Progress {
    last: Option<Mutex<Instant>>,
}

impl Progress {
    /// A search that begins.
    pub(crate) fn new() -> Self {
        Self { last: stderr().is_terminal().then(|| Mutex::new(Instant::now())) }
    }

    /// The share that is done, from 0 to 1.
    pub(crate) fn at(&self, share: f64) {
        // A thread that finds another at it has nothing to add.
        if let Some(Ok(mut last)) = self.last.as_ref().map(Mutex::try_lock)
            && last.elapsed() >= SHOWN_EVERY
        {
            *last = Instant::now();
            let _ = write!(stderr(), "\rsearching: {:3.0} %", 100.0 * share);
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if self.last.is_some() {
            let _ = write!(stderr(), "\r                \r");
        }
    }
}
