//! Ranges of a quantity by severity.

use crate::Severity;
use crate::tolerance::ROUNDING;

/// Range of allowed values; an end may be infinite.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range {
    /// Least value.
    pub least: f64,
    /// Greatest value.
    pub most: f64,
}

impl Range {
    /// Range without ends.
    pub const OPEN: Self = Self { least: f64::NEG_INFINITY, most: f64::INFINITY };

    /// Range between two values.
    #[must_use]
    pub const fn between(least: f64, most: f64) -> Self {
        Self { least, most }
    }

    /// Range from a value on.
    #[must_use]
    pub const fn at_least(least: f64) -> Self {
        Self { least, most: f64::INFINITY }
    }

    /// Range up to a value.
    #[must_use]
    pub const fn at_most(most: f64) -> Self {
        Self { least: f64::NEG_INFINITY, most }
    }

    /// Whether a value lies inside, but for rounding. No value that is not a number does.
    #[must_use]
    pub fn contains(self, value: f64) -> bool {
        self.room(value) >= -ROUNDING
    }

    /// Distance from the nearest end, over the width of the range, or over its only end; below 0 outside.
    fn room(self, value: f64) -> f64 {
        let ends = [value - self.least, self.most - value];
        if value.is_nan() {
            return f64::NEG_INFINITY;
        }
        let size = match [self.least, self.most].map(f64::is_finite) {
            [true, true] => self.most - self.least,
            [true, false] => self.least.abs(),
            [false, true] => self.most.abs(),
            [false, false] => return f64::INFINITY,
        };
        ends[0].min(ends[1]) / if size > 0.0 { size } else { 1.0 }
    }

    /// End that is nearest to a value, or that it passes.
    #[must_use]
    pub fn nearest_end(self, value: f64) -> f64 {
        if value - self.least < self.most - value { self.least } else { self.most }
    }

    fn moved(self, by: f64) -> Self {
        Self { least: self.least + by, most: self.most + by }
    }

    /// Range of the values that lie in both.
    const fn within(self, other: Self) -> Self {
        Self { least: self.least.max(other.least), most: self.most.min(other.most) }
    }

    /// Least range that holds both.
    fn with(self, other: Self) -> Self {
        Self { least: self.least.min(other.least), most: self.most.max(other.most) }
    }
}

/// Ranges of a quantity, one for each severity, in the order of [`Severity::ALL`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds(pub [Range; 3]);

impl Bounds {
    /// Bounds of one severity alone.
    #[must_use]
    pub const fn of(severity: Severity, range: Range) -> Self {
        let mut all = [Range::OPEN; 3];
        all[severity as usize] = range;
        Self(all)
    }

    /// Adds the range of another severity.
    #[must_use]
    pub const fn and(mut self, severity: Severity, range: Range) -> Self {
        self.0[severity as usize] = range;
        self
    }

    /// Moves all ends.
    #[must_use]
    pub fn moved(self, by: f64) -> Self {
        Self(self.0.map(|range| range.moved(by)))
    }

    /// A stated range in place of that for warnings: no remark comes before it, and no error inside it.
    #[must_use]
    pub fn stated(self, range: Range) -> Self {
        Self([Range::OPEN, range, self.0[Severity::Error as usize].with(range)])
    }

    /// The worst severity that a value outside has, with the end that it passes.
    #[must_use]
    pub fn missed(self, value: f64) -> Option<(Severity, f64)> {
        let outside = |severity: &&Severity| !self.0[**severity as usize].contains(value);
        let worst = Severity::ALL.iter().rev().find(outside)?;
        Some((*worst, self.0[*worst as usize].nearest_end(value)))
    }

    /// Range of good values: without warnings and errors; of a rule that has neither, without remarks.
    #[must_use]
    pub fn required(self) -> Range {
        let [remark, warning, error] = self.0;
        // A limit that is asked for may be narrower than the usual one, though it makes an error.
        Some(warning.within(error)).filter(|range| *range != Range::OPEN).unwrap_or(remark)
    }
}
