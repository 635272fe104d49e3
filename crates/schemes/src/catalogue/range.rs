//! Which ring-to-sun ratios are used, and what a ratio does over them.

use crate::Error;
use epicyclic_gears::simple_set::RingToSunRatio;

/// Ring-to-sun ratios from one to another, ends included.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RingToSunRange {
    low: f64,
    high: f64,
}

impl RingToSunRange {
    /// What the source computes its ranges of ratios over: 1.7 to 7.
    pub const USED: Self = Self { low: 1.7, high: 7.0 };
    /// What it recommends: 1.3 to 10. Below, planets are too small for their bearings; above, the sun.
    pub const RECOMMENDED: Self = Self { low: 1.3, high: 10.0 };
    /// Where it finds size and mass best: 2.5 to 3.
    pub const BEST: Self = Self { low: 2.5, high: 3.0 };

    /// A range.
    ///
    /// # Errors
    /// [`Error::RingToSunRange`] unless `1 < low ≤ high`, both finite.
    pub fn new(low: f64, high: f64) -> Result<Self, Error> {
        if low > 1.0 && low <= high && high.is_finite() {
            Ok(Self { low, high })
        } else {
            Err(Error::RingToSunRange { low, high })
        }
    }

    /// Its lower end.
    #[must_use]
    pub fn low(self) -> f64 {
        self.low
    }

    /// Its upper end.
    #[must_use]
    pub fn high(self) -> f64 {
        self.high
    }

    /// Whether a ring-to-sun ratio lies in it.
    #[must_use]
    pub fn contains(self, k: RingToSunRatio) -> bool {
        (self.low..=self.high).contains(&k.get())
    }

    pub(crate) fn ends(self) -> [f64; 2] {
        [self.low, self.high]
    }
}

/// What a ratio does while the ring-to-sun ratios run over a range.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Reach {
    /// It takes every value between these, ends included.
    Between {
        /// The least.
        least: f64,
        /// The greatest.
        greatest: f64,
    },
    /// It changes its sign through 0: there the input is blocked while the output could turn.
    ThroughZero,
    /// It changes its sign through ±∞: there the output rests.
    ThroughInfinity,
}

impl Reach {
    /// Of a ratio `N(k₁, k₂)/D(k₁, k₂)` with `N` and `D` linear in `k₁` and in `k₂`.
    ///
    /// A function linear in each of two variables takes its extremes over a rectangle at the corners,
    /// so corners show every change of sign of `N` and `D`. Without one the ratio is monotonous along
    /// each edge direction, and its extremes are at corners too: the answer is exact.
    pub(crate) fn of(fraction: impl Fn(f64, f64) -> [f64; 2], range: RingToSunRange) -> Self {
        let mut corners = [[0.0; 2]; 4];
        for (place, corner) in corners.iter_mut().enumerate() {
            *corner = fraction(range.ends()[place / 2], range.ends()[place % 2]);
        }
        let keeps_sign =
            |part: usize| corners.iter().all(|c| c[part] > 0.0) || corners.iter().all(|c| c[part] < 0.0);
        if !keeps_sign(1) {
            return Self::ThroughInfinity;
        }
        if !keeps_sign(0) {
            return Self::ThroughZero;
        }
        let (mut least, mut greatest) = (f64::INFINITY, f64::NEG_INFINITY);
        for [n, d] in corners {
            least = least.min(n / d);
            greatest = greatest.max(n / d);
        }
        Self::Between { least, greatest }
    }

    /// Whether the ratio keeps its sign, and that sign is `sign`'s.
    #[must_use]
    pub fn has_sign_of(self, sign: f64) -> bool {
        matches!(self, Self::Between { least, .. } if least * sign > 0.0)
    }

    /// Whether some of its values slow down, `|i| > 1`.
    #[must_use]
    pub fn slows(self) -> bool {
        match self {
            Self::Between { least, greatest } => least.abs().max(greatest.abs()) > 1.0,
            Self::ThroughInfinity => true,
            Self::ThroughZero => false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_range_starts_above_one_and_ends_above_its_start() {
        assert!(RingToSunRange::new(1.0, 2.0).is_err());
        assert!(RingToSunRange::new(3.0, 2.0).is_err());
        assert!(RingToSunRange::new(2.0, f64::INFINITY).is_err());
        let range = RingToSunRange::new(1.7, 7.0).unwrap();
        assert_eq!(range, RingToSunRange::USED);
        assert!(range.contains(RingToSunRatio::new(7.0).unwrap()));
        assert!(!range.contains(RingToSunRatio::new(1.5).unwrap()));
    }

    #[test]
    fn a_change_of_sign_shows_at_the_corners() {
        let used = RingToSunRange::USED;
        assert_eq!(Reach::of(|k, l| [l - k, l], used), Reach::ThroughZero);
        assert_eq!(Reach::of(|k, l| [l, l - k], used), Reach::ThroughInfinity);
        let Reach::Between { least, greatest } = Reach::of(|k, l| [k, l], used) else { unreachable!() };
        assert!((least - 1.7 / 7.0).abs() < 1e-15 && (greatest - 7.0 / 1.7).abs() < 1e-15);
    }
}
