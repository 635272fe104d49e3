//! How far a long search is: one line on standard error, on a terminal alone.

use std::io::{IsTerminal, Write as _, stderr};
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// How often it is shown; what is done sooner shows nothing.
const SHOWN_EVERY: Duration = Duration::from_millis(100);

/// How long a search runs before it is told how long it will.
const TOLD_AFTER: Duration = Duration::from_secs(3);

/// The line's length: what stood there before is covered.
const WIDTH: usize = 40;

/// A duration in words: `40 s`, `12 min`, `3.5 h`, `8 days`.
pub(crate) fn duration(seconds: f64) -> String {
    const MINUTE: f64 = 60.0;
    const HOUR: f64 = 3600.0;
    const DAY: f64 = 86400.0;
    match seconds {
        s if s < 100.0 => format!("{:.0} s", s.max(1.0)),
        s if s < 100.0 * MINUTE => format!("{:.0} min", s / MINUTE),
        s if s < 10.0 * HOUR => format!("{:.1} h", s / HOUR),
        s if s < 2.0 * DAY => format!("{:.0} h", s / HOUR),
        s if s < 1000.0 * DAY => format!("{:.0} days", s / DAY),
        s => format!("{:.0} years", s / DAY / 365.0),
    }
}

/// Progress of one search, from any of its threads. The line goes when this does.
pub(crate) struct Progress {
    last: Option<Mutex<Instant>>,
    begun: Instant,
    /// What was done before it began.
    before: f64,
}

impl Progress {
    /// A search that begins.
    pub(crate) fn new() -> Self {
        Self::from(0.0)
    }

    /// A search of which this share is done already.
    pub(crate) fn from(before: f64) -> Self {
        let begun = Instant::now();
        Self { last: stderr().is_terminal().then(|| Mutex::new(begun)), begun, before }
    }

    /// How long it will take from here, if it goes on as it went.
    fn left(&self, share: f64) -> String {
        let done = share - self.before;
        if self.begun.elapsed() < TOLD_AFTER || done <= 0.0 {
            return String::new();
        }
        format!(", about {} left", duration(self.begun.elapsed().as_secs_f64() * (1.0 - share) / done))
    }

    /// The share that is done, from 0 to 1.
    pub(crate) fn at(&self, share: f64) {
        // A thread that finds another at it has nothing to add.
        if let Some(Ok(mut last)) = self.last.as_ref().map(Mutex::try_lock)
            && last.elapsed() >= SHOWN_EVERY
        {
            *last = Instant::now();
            let line = format!("searching: {:3.0} %{}", 100.0 * share, self.left(share));
            let _ = write!(stderr(), "\r{line:WIDTH$}");
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if self.last.is_some() {
            let _ = write!(stderr(), "\r{:WIDTH$}\r", "");
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn durations_are_told_in_words() {
        for (seconds, told) in [
            (0.2, "1 s"),
            (75.4, "75 s"),
            (150.0, "2 min"),
            (5000.0, "83 min"),
            (9000.0, "2.5 h"),
            (40_000.0, "11 h"),
            (1e6, "12 days"),
            (1e9, "32 years"),
        ] {
            assert_eq!(duration(seconds), told);
        }
    }
}
