//! Numbers of twice a double's digits: the sum of two doubles, exact to some 2⁻¹⁰⁰ of itself.
//!
//! Sums and products of doubles are split into the rounded value and its exact error (Dekker), and the errors
//! are carried along. These numbers serve the few objectives whose point of the grid a double does not
//! decide.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// `high + low`, `high` the nearest double.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub(super) struct Double {
    pub(super) high: f64,
    low: f64,
}

impl From<f64> for Double {
    fn from(value: f64) -> Self {
        Self { high: value, low: 0.0 }
    }
}

impl Double {
    /// A sum whose first part is the larger.
    fn of(high: f64, low: f64) -> Self {
        let sum = high + low;
        Self { high: sum, low: low - (sum - high) }
    }

    pub(super) fn abs(self) -> Self {
        if self.high < 0.0 { -self } else { self }
    }

    pub(super) fn min(self, other: Self) -> Self {
        if other < self { other } else { self }
    }

    pub(super) fn max(self, other: Self) -> Self {
        if other > self { other } else { self }
    }
}

impl Neg for Double {
    type Output = Self;

    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

impl Add for Double {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let sum = |a: f64, b: f64| {
            let sum = a + b;
            let of_b = sum - a;
            (sum, (a - (sum - of_b)) + (b - of_b))
        };
        let (high, error) = sum(self.high, other.high);
        let (low, rest) = sum(self.low, other.low);
        let first = Self::of(high, error + low);
        Self::of(first.high, first.low + rest)
    }
}

impl Sub for Double {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Double {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        // Halves of 26 digits, whose products are exact.
        let halves = |value: f64| {
            let shifted = 134_217_729.0 * value;
            let high = shifted - (shifted - value);
            (high, value - high)
        };
        let product = self.high * other.high;
        let ((a, b), (c, d)) = (halves(self.high), halves(other.high));
        let error = ((a * c - product) + a * d + b * c) + b * d;
        Self::of(product, error + (self.high * other.low + self.low * other.high))
    }
}

impl Div for Double {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let first = self.high / other.high;
        let rest = self - other * first.into();
        let second = rest.high / other.high;
        let rest = rest - other * second.into();
        Self::of(first, second) + (rest.high / other.high).into()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn double(value: f64) -> Double {
        value.into()
    }

    proptest! {
        /// `(a² − b²)/(a − b) = a + b`, and of thirds and sevenths what doubles lose.
        #[test]
        fn the_laws_of_fractions_hold(a in 1.0..2000.0_f64, b in 1.0..2000.0_f64, c in 1_u32..1000) {
            prop_assume!((a - b).abs() > 1e-3);
            let (a, b, c) = (double(a), double(b), double(f64::from(c)));
            let near = |one: Double, other: Double| (one - other).abs().high <= other.abs().high * 1e-24;
            prop_assert!(near((a * a - b * b) / (a - b), a + b));
            prop_assert!(near(a / c * c, a) && near((a / c + b / c) * c, a + b));
        }
    }

    #[test]
    fn what_doubles_lose_is_kept() {
        let third = double(1.0) / double(3.0);
        assert!((third + third + third - double(1.0)).abs().high < 1e-31);
        assert_eq!((double(1.0) + double(1e-20) - double(1.0)).high, 1e-20);
        assert!(double(1.0) + double(1e-20) > double(1.0) && double(2.0).min(third) == third);
    }
}
