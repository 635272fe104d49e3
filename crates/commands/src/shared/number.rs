//! Numbers of an answer: SI values without a negative zero.

use crate::tolerance::SHORT;
use epicyclic_units::Physical;

/// Returns a number for an answer: zero has no sign.
#[must_use]
pub fn plain(value: f64) -> f64 {
    value + 0.0
}

/// The number with the fewest digits that is this one but for rounding, `SHORT` of it: `2` for
/// `1.9999999999999996`.
#[must_use]
pub fn short(value: f64) -> f64 {
    let of_digits = |digits: usize| format!("{value:.digits$e}").parse::<f64>().ok();
    let near = |number: &f64| (number - value).abs() <= SHORT * value.abs();
    (0..=16).filter_map(of_digits).find(near).unwrap_or(value)
}

/// A quantity in its SI unit.
pub fn si<T: Physical>(quantity: T) -> f64 {
    plain(quantity.si())
}

/// A quantity in its SI unit, if there is one.
pub fn maybe_si<T: Physical>(quantity: Option<T>) -> Option<f64> {
    quantity.map(si)
}

/// The least power of ten from `least` on that a residual of rounding keeps within: more of it says nothing.
pub(crate) fn power_of_ten_above(residual: f64, least: f64) -> f64 {
    let mut within = least;
    while within < residual {
        within *= 10.0;
    }
    within
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zero_has_no_sign() {
        assert!(plain(-0.0).is_sign_positive());
        assert_eq!(plain(-2.5), -2.5);
    }

    #[test]
    fn a_number_loses_the_digits_of_rounding_alone() {
        assert_eq!(short(1.999_999_999_999_999_1), 2.0);
        assert_eq!(short(-0.1 - 0.2), -0.3);
        assert_eq!(short(0.0), 0.0);
        assert_eq!(short(2.000_000_002), 2.000_000_002);
    }
}
