//! Size and progress of a long search, if the desk shows progress.

use crate::desk::{Call, Desk, goes_on};
use std::ops::ControlFlow;
use std::sync::{Mutex, Once};

/// Interval between two progress lines, s; shorter searches show none.
const SHOWN_EVERY: f64 = 0.1;

/// Running time from which on the remaining time is shown, s.
const TOLD_AFTER: f64 = 3.0;

/// Estimated duration from which on the size of a search is shown, s.
const TOLD: f64 = 1.0;

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

/// Progress of one search, reported from any of its threads. The line is removed when the value is dropped.
pub(crate) struct Progress<'d> {
    desk: &'d dyn Desk,
    /// Time of the last progress line, s; `None` if the desk shows no progress.
    last: Option<Mutex<f64>>,
    begun: f64,
    /// Share done before the search began.
    before: f64,
    /// Activity in the line: `searching`.
    doing: &'static str,
    sized: Once,
}

impl<'d> Progress<'d> {
    /// A search that begins.
    pub(crate) fn new(call: &Call<'d>) -> Self {
        Self::from(call, 0.0)
    }

    /// An answer that is written.
    pub(crate) fn of_writing(call: &Call<'d>) -> Self {
        Self::of(call, "writing", 0.0)
    }

    /// Solutions that are judged.
    pub(crate) fn of_judging(call: &Call<'d>) -> Self {
        Self::of(call, "judging", 0.0)
    }

    /// Runs of a sweep.
    pub(crate) fn of_runs(call: &Call<'d>) -> Self {
        Self::of(call, "running", 0.0)
    }

    /// Progress of a search that resumes with this share already done.
    pub(crate) fn from(call: &Call<'d>, before: f64) -> Self {
        Self::of(call, "searching", before)
    }

    fn of(call: &Call<'d>, doing: &'static str, before: f64) -> Self {
        let desk = call.desk;
        let begun = desk.seconds();
        let last = desk.shows_progress().then(|| Mutex::new(begun));
        Self { desk, last, begun, before, doing, sized: Once::new() }
    }

    /// Shows the size of a search once, if `parts` at `in_a_second` parts per second take long.
    pub(crate) fn size(&self, parts: f64, in_a_second: f64, words: impl FnOnce() -> String) {
        if self.last.is_some() && parts / in_a_second >= TOLD {
            self.sized.call_once(|| {
                self.desk.progress(None);
                self.desk.message(&format!("searching {}", words()));
            });
        }
    }

    /// Remaining time at the average rate so far.
    fn left(&self, share: f64) -> String {
        let (done, took) = (share - self.before, self.desk.seconds() - self.begun);
        if took < TOLD_AFTER || done <= 0.0 {
            return String::new();
        }
        format!(", about {} left", duration(took * (1.0 - share) / done))
    }

    /// Shows a pass with the share of it that is done; the number of passes is unknown in advance.
    pub(crate) fn at_pass(&self, pass: u32, share: f64) -> ControlFlow<()> {
        self.show(None, || format!("refining, pass {pass}: {:3.0} %", 100.0 * share))
    }

    /// Shows the share that is done, from 0 to 1; returns a break if the call is asked to end.
    pub(crate) fn at(&self, share: f64) -> ControlFlow<()> {
        self.show(Some(share), || format!("{}: {:3.0} %{}", self.doing, 100.0 * share, self.left(share)))
    }

    fn show(&self, share: Option<f64>, line: impl FnOnce() -> String) -> ControlFlow<()> {
        // A thread that finds another at it has nothing to add.
        if let Some(Ok(mut last)) = self.last.as_ref().map(Mutex::try_lock) {
            let now = self.desk.seconds();
            if now - *last >= SHOWN_EVERY {
                *last = now;
                self.desk.progress(Some((&line(), share)));
            }
        }
        goes_on(self.desk)
    }
}

impl Drop for Progress<'_> {
    fn drop(&mut self) {
        if self.last.is_some() {
            self.desk.progress(None);
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
