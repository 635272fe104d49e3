//! Ranges of ring-to-sun ratios, and the values that a ratio takes over them.

use crate::Error;
use epicyclic_gears::simple_set::RingToSunRatio;

/// Ring-to-sun ratios from one to another, ends included.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RingToSunRange {
    low: f64,
    high: f64,
}

impl RingToSunRange {
    /// Range over which the source computes its ratios: 1.7 to 7.
    pub const USED: Self = Self { low: 1.7, high: 7.0 };
    /// Range that the source recommends: 1.3 to 10. Below, planets are too small for their bearings; above,
    /// the sun.
    pub const RECOMMENDED: Self = Self { low: 1.3, high: 10.0 };
    /// Range in which the source finds size and mass best: 2.5 to 3.
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

    /// Lower end.
    #[must_use]
    pub fn low(self) -> f64 {
        self.low
    }

    /// Upper end.
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

/// The ratios at `k → 1` and `k → ∞`, the smaller first, of a fraction with parts linear in `k`.
pub(crate) fn limits(fraction: impl Fn(f64) -> [f64; 2]) -> [f64; 2] {
    let [one, two] = [fraction(1.0), fraction(2.0)];
    let at_one = one[0] / one[1];
    // At infinity the ratio is that of the slopes.
    let at_infinity = (two[0] - one[0]) / (two[1] - one[1]);
    [at_one.min(at_infinity), at_one.max(at_infinity)]
}

/// Values of a ratio while the ring-to-sun ratios run over a range.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Reach {
    /// The ratio takes every value between these, ends included, and keeps its sign.
    Between {
        /// The least.
        least: f64,
        /// The greatest.
        greatest: f64,
    },
    /// The ratio takes every value between these and changes its sign through 0. At 0 the input is blocked
    /// while the output could turn.
    ThroughZero {
        /// The least, below 0 or 0.
        least: f64,
        /// The greatest, above 0 or 0.
        greatest: f64,
    },
    /// The ratio changes its sign through ±∞, where the output rests, and takes every value *outside* these.
    ThroughInfinity {
        /// The greatest below the gap.
        below: f64,
        /// The least above the gap.
        above: f64,
    },
}

impl Reach {
    /// Values of a ratio `N(k₁, k₂)/D(k₁, k₂)` with `N` and `D` linear in `k₁` and in `k₂`.
    ///
    /// A function linear in each of two variables takes its extremes over a rectangle at the corners, so
    /// corners show every change of sign of `N` and `D`. Between zeros and poles the ratio is monotonous
    /// along each edge direction, and its extremes are at corners too: the answer is exact.
    pub(crate) fn of(fraction: impl Fn(f64, f64) -> [f64; 2], ends: [f64; 2]) -> Self {
        let corners = [0, 1, 2, 3].map(|place| fraction(ends[place / 2], ends[place % 2]));
        let values = corners.map(|[n, d]| n / d);
        let keeps_sign =
            |part: usize| corners.iter().all(|c| c[part] > 0.0) || corners.iter().all(|c| c[part] < 0.0);
        let least = |of: &mut dyn Iterator<Item = f64>| of.fold(f64::INFINITY, f64::min);
        let greatest = |of: &mut dyn Iterator<Item = f64>| of.fold(f64::NEG_INFINITY, f64::max);
        if !keeps_sign(1) {
            return Self::ThroughInfinity {
                below: greatest(&mut values.into_iter().filter(|i| *i < 0.0)),
                above: least(&mut values.into_iter().filter(|i| *i > 0.0)),
            };
        }
        let (least, greatest) = (least(&mut values.into_iter()), greatest(&mut values.into_iter()));
        if keeps_sign(0) { Self::Between { least, greatest } } else { Self::ThroughZero { least, greatest } }
    }

    /// The sign that the ratio keeps; `None` where it changes.
    #[must_use]
    pub fn sign(self) -> Option<f64> {
        match self {
            Self::Between { least, .. } => Some(least.signum()),
            Self::ThroughZero { .. } | Self::ThroughInfinity { .. } => None,
        }
    }

    /// Whether some of its values of this sign slow down, `|i| > 1`.
    #[must_use]
    pub fn slows_with_sign_of(self, sign: f64) -> bool {
        match self {
            Self::Between { least, greatest } | Self::ThroughZero { least, greatest } => {
                if sign > 0.0 {
                    greatest > 1.0
                } else {
                    least < -1.0
                }
            }
            Self::ThroughInfinity { .. } => true,
        }
    }

    /// Whether some of its values slow down, `|i| > 1`.
    #[must_use]
    pub fn slows(self) -> bool {
        self.slows_with_sign_of(1.0) || self.slows_with_sign_of(-1.0)
    }

    /// Whether the ratio takes a value between `from` and `to`, both widened by `slack`.
    #[must_use]
    pub fn meets(self, from: f64, to: f64, slack: f64) -> bool {
        match self {
            Self::Between { least, greatest } | Self::ThroughZero { least, greatest } => {
                to >= least - slack && from <= greatest + slack
            }
            Self::ThroughInfinity { below, above } => from <= below + slack || to >= above - slack,
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
        let used = RingToSunRange::USED.ends();
        let Reach::ThroughZero { least, greatest } = Reach::of(|k, l| [l - k, l], used) else {
            unreachable!()
        };
        assert!((least - (1.7 - 7.0) / 1.7).abs() < 1e-15 && (greatest - (7.0 - 1.7) / 7.0).abs() < 1e-15);
        let Reach::ThroughInfinity { below, above } = Reach::of(|k, l| [l, l - k], used) else {
            unreachable!()
        };
        assert!((below - 1.7 / (1.7 - 7.0)).abs() < 1e-15 && (above - 7.0 / (7.0 - 1.7)).abs() < 1e-15);
        let Reach::Between { least, greatest } = Reach::of(|k, l| [k, l], used) else { unreachable!() };
        assert!((least - 1.7 / 7.0).abs() < 1e-15 && (greatest - 7.0 / 1.7).abs() < 1e-15);
    }

    #[test]
    fn a_ratio_through_zero_slows_where_its_extremes_do() {
        let used = RingToSunRange::USED.ends();
        // (l − k)/l reaches (1.7 − 7)/1.7 = −3.1, but never more than 0.76 forward.
        let reach = Reach::of(|k, l| [l - k, l], used);
        assert!(reach.slows() && reach.slows_with_sign_of(-1.0) && !reach.slows_with_sign_of(1.0));
        assert_eq!(reach.sign(), None);
        // (l − k)/7 never does: ±0.76.
        assert!(!Reach::of(|k, l| [l - k, 7.0], used).slows());
        assert!(Reach::of(|k, l| [l, l - k], used).slows());
        assert!(!Reach::of(|k, _| [1.0, k], used).slows());
    }
}
