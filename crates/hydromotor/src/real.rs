//! Numbers that the closure is written for once: `f64`, and [`Dual`] numbers that carry derivatives with it.

use std::ops::{Add, Div, Mul, Sub};

use crate::tolerance::SERIES;

/// Operations that the kernels of system (1) and of the closure need of a number.
pub(crate) trait Real:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    /// A constant.
    fn of(value: f64) -> Self;
    /// Square root.
    fn sqrt(self) -> Self;
    /// Arc tangent of a number that is not below 0.
    fn atan(self) -> Self;
    /// `A(z) = ∫₀¹ dt/(1 + z·t²)`, of [`arc`].
    fn arc(self) -> Self;
}

/// `A(z) = ∫₀¹ dt/(1 + z·t²)`: `atan(√z)/√z` above 0, `atanh(√−z)/√−z` below, 1 at 0; not a number at
/// `z ≤ −1`.
///
/// Both branches of the integral `J` in one function that is smooth where they meet. Nothing cancels near 0.
pub(crate) fn arc(z: f64) -> f64 {
    let root = z.abs().sqrt();
    if root < SERIES {
        1.0 - z / 3.0
    } else if z > 0.0 {
        libm::atan(root) / root
    } else if z > -1.0 {
        libm::atanh(root) / root
    } else {
        f64::NAN
    }
}

/// `A′(z) = −∫₀¹ t²/(1 + z·t²)² dt`.
pub(crate) fn arc_slope(z: f64) -> f64 {
    if z.abs() < 0.05 {
        // −1/3 + 2z/5 − 3z²/7 + …, as (1/(1 + z) − A)/(2z) cancels here.
        let series = (1..=16).rev().map(f64::from);
        return -series.fold(0.0, |sum, k| k / (2.0 * k + 1.0) - z * sum);
    }
    (1.0 / (1.0 + z) - arc(z)) / (2.0 * z)
}

impl Real for f64 {
    fn of(value: f64) -> Self {
        value
    }

    fn sqrt(self) -> Self {
        self.sqrt()
    }

    fn atan(self) -> Self {
        libm::atan(self)
    }

    fn arc(self) -> Self {
        arc(self)
    }
}

/// A value with its derivatives by the two distances `l` and `a`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Dual {
    pub(crate) value: f64,
    pub(crate) by_l: f64,
    pub(crate) by_a: f64,
}

impl Dual {
    fn chain(self, value: f64, slope: f64) -> Self {
        Self { value, by_l: slope * self.by_l, by_a: slope * self.by_a }
    }
}

impl Add for Dual {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { value: self.value + other.value, by_l: self.by_l + other.by_l, by_a: self.by_a + other.by_a }
    }
}

impl Sub for Dual {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self { value: self.value - other.value, by_l: self.by_l - other.by_l, by_a: self.by_a - other.by_a }
    }
}

impl Mul for Dual {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self {
            value: self.value * other.value,
            by_l: self.by_l * other.value + self.value * other.by_l,
            by_a: self.by_a * other.value + self.value * other.by_a,
        }
    }
}

impl Div for Dual {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        Self {
            value,
            by_l: (self.by_l - value * other.by_l) / other.value,
            by_a: (self.by_a - value * other.by_a) / other.value,
        }
    }
}

impl Real for Dual {
    fn of(value: f64) -> Self {
        Self { value, by_l: 0.0, by_a: 0.0 }
    }

    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.chain(root, 0.5 / root)
    }

    fn atan(self) -> Self {
        self.chain(libm::atan(self.value), 1.0 / (1.0 + self.value * self.value))
    }

    fn arc(self) -> Self {
        self.chain(arc(self.value), arc_slope(self.value))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::FRAC_PI_4;

    #[test]
    fn both_branches_meet_in_the_limit_between() {
        assert!((arc(1.0) - FRAC_PI_4).abs() < 1e-16);
        assert!((arc(-0.25) - 2.0 * libm::atanh(0.5_f64)).abs() < 1e-15);
        assert_eq!(arc(0.0), 1.0);
        for z in [1e-3, 1e-9, 1e-15, 1e-17] {
            let reach = z * z + 1e-15;
            assert!((arc(z) - (1.0 - z / 3.0)).abs() < reach && (arc(-z) - (1.0 + z / 3.0)).abs() < reach);
        }
        assert!(arc(-1.0).is_nan() && arc(-2.0).is_nan());
    }

    #[test]
    fn the_slope_is_that_of_the_integral() {
        for z in [-0.9, -0.3, -0.051, -0.049, -1e-4, 0.0, 1e-4, 0.049, 0.051, 0.7, 20.0] {
            let h = 1e-5;
            let difference = (arc(z + h) - arc(z - h)) / (2.0 * h);
            assert!((arc_slope(z) - difference).abs() < 1e-7 * difference.abs(), "{z}");
        }
    }
}
