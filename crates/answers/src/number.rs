//! Numbers of an answer: SI values without a negative zero.

use epicyclic_formats::Physical;

/// A number as it stands in an answer: zero has no sign.
#[must_use]
pub fn plain(value: f64) -> f64 {
    value + 0.0
}

/// A quantity in its SI unit.
pub fn si<T: Physical>(quantity: T) -> f64 {
    plain(quantity.si())
}

/// A quantity in its SI unit, if there is one.
pub fn maybe_si<T: Physical>(quantity: Option<T>) -> Option<f64> {
    quantity.map(si)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zero_has_no_sign() {
        assert!(plain(-0.0).is_sign_positive());
        assert_eq!(plain(-2.5), -2.5);
    }
}
