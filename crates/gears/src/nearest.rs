//! A search for a ratio: what is near enough, and what came nearest.

use crate::Error;

/// Refuses a relative tolerance of a ratio outside 0 ≤ t < 1: from 100 % on it allows a ratio of 0.
///
/// # Errors
/// [`Error::Tolerance`].
pub fn check_tolerance(tolerance: f64) -> Result<(), Error> {
    if (0.0..1.0).contains(&tolerance) { Ok(()) } else { Err(Error::Tolerance { tolerance }) }
}

/// A search for a ratio: the target, and the nearest ratio found.
pub(crate) struct Search {
    wanted: f64,
    tolerance: f64,
    /// The nearest ratio, and its distance.
    nearest: Option<(f64, f64)>,
}

impl Search {
    pub(crate) fn new(wanted: f64, tolerance: f64) -> Result<Self, Error> {
        check_tolerance(tolerance)?;
        if wanted == 0.0 || !wanted.is_finite() {
            return Err(Error::Ratio { ratio: wanted });
        }
        Ok(Self { wanted, tolerance, nearest: None })
    }

    fn error(&self, ratio: f64) -> f64 {
        ratio / self.wanted - 1.0
    }

    /// Whether a ratio is within tolerance. A ratio that is off by the tolerance itself, but for rounding, is
    /// within.
    pub(crate) fn is_near(&self, ratio: f64) -> bool {
        self.error(ratio).abs() <= self.tolerance + 4.0 * f64::EPSILON
    }

    /// Whether a ratio is nearer than all those taken before.
    pub(crate) fn is_nearer(&self, ratio: f64) -> bool {
        self.nearest.is_none_or(|(_, least)| self.error(ratio).abs() < least)
    }

    /// Takes the ratio of a set that there is; its error where it is within tolerance.
    pub(crate) fn take(&mut self, ratio: f64) -> Option<f64> {
        let error = self.error(ratio);
        if self.is_nearer(ratio) {
            self.nearest = Some((ratio, error.abs()));
        }
        self.is_near(ratio).then_some(error)
    }

    /// The nearest ratio that was taken.
    pub(crate) fn nearest(&self) -> Option<f64> {
        self.nearest.map(|(ratio, _)| ratio)
    }
}
