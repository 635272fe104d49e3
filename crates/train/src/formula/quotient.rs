//! Quotients of polynomials, factored, without common factors.

use super::polynomial::{Polynomial, greatest_divisor};
use crate::elimination::Scalar;
use epicyclic_gears::simple_set::Fraction;

/// A quotient of two polynomials: a number, and factors that share none between numerator and denominator.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Quotient {
    number: [i64; 2],
    factors: [Vec<Polynomial>; 2],
}

impl Quotient {
    /// The quotient of two polynomials, unless one is 0.
    #[must_use]
    pub fn new(numerator: &Polynomial, denominator: &Polynomial) -> Option<Self> {
        let ((above, mut numerator), (below, mut denominator)) = (numerator.factors(), denominator.factors());
        if above == 0 || below == 0 {
            return None;
        }
        numerator.retain(|factor| {
            let common = denominator.iter().position(|other| other == factor);
            if let Some(place) = common {
                denominator.remove(place);
            }
            common.is_none()
        });
        let divisor = greatest_divisor(above, below) * below.signum();
        let mut number = [above / divisor, below / divisor];
        // A factor with a term to subtract takes a minus sign from the front: k₂ − k₁ for −(k₁ − k₂).
        let mut turned = denominator.iter_mut().chain(&mut numerator);
        if number[0] < 0
            && let Some(factor) = turned.find(|factor| factor.products().any(|(_, of)| of < 0))
        {
            *factor = factor.negated();
            number[0] = -number[0];
        }
        Some(Self { number, factors: [numerator, denominator] })
    }

    /// Factors of the numerator, a number other than 1 first; their product is the numerator.
    #[must_use]
    pub fn numerator(&self) -> Vec<Polynomial> {
        self.side(0)
    }

    /// Factors of the denominator, a number other than 1 first. Its number is positive.
    #[must_use]
    pub fn denominator(&self) -> Vec<Polynomial> {
        self.side(1)
    }

    fn side(&self, side: usize) -> Vec<Polynomial> {
        let number = self.number[side];
        let constant = (number != 1 || self.factors[side].is_empty()).then(|| Polynomial::constant(number));
        constant.into_iter().chain(self.factors[side].iter().cloned()).collect()
    }

    /// The symbols that occur, as bits.
    pub(super) fn variables(&self) -> u32 {
        self.factors.iter().flatten().fold(0, |all, factor| all | factor.variables())
    }

    /// Value of the quotient for these values of the symbols.
    #[must_use]
    pub fn value(&self, symbol: &dyn Fn(usize) -> f64) -> f64 {
        let of = |side: usize| {
            self.factors[side].iter().map(|factor| factor.value(symbol)).product::<f64>()
                * self.number[side] as f64
        };
        of(0) / of(1)
    }

    /// Exact value of the quotient for these values of the symbols; `None` if an integer overflows.
    pub(super) fn exact_value(&self, symbols: &[Fraction]) -> Option<Fraction> {
        let of = |side: usize| {
            let number = Fraction::from_integer(i128::from(self.number[side]));
            self.factors[side]
                .iter()
                .try_fold(number, |product, factor| Scalar::times(&product, &factor.exact_value(symbols)?))
        };
        Scalar::over(&of(0)?, &of(1)?)
    }

    /// `(1 + k₁)·(1 + k₂)/(k₁·k₂ − 1)`, with these names of the symbols.
    #[must_use]
    pub fn text(&self, name: &dyn Fn(usize) -> String) -> String {
        let product = |side: usize| {
            let size = self.number[side].abs();
            let number = (size != 1).then(|| size.to_string());
            let factor = |factor: &Polynomial| {
                if factor.len() > 1 { format!("({})", factor.text(name)) } else { factor.text(name) }
            };
            let parts: Vec<String> =
                number.into_iter().chain(self.factors[side].iter().map(factor)).collect();
            let is_product = parts.len() > 1;
            (if parts.is_empty() { "1".to_owned() } else { parts.join("·") }, is_product)
        };
        let sign = if self.number[0] < 0 { "−" } else { "" };
        let ((above, _), (below, is_product)) = (product(0), product(1));
        if below == "1" {
            return match self.factors[0].as_slice() {
                [only] if self.number[0] == 1 => only.text(name),
                _ => format!("{sign}{above}"),
            };
        }
        if is_product { format!("{sign}{above}/({below})") } else { format!("{sign}{above}/{below}") }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polynomial(terms: &[(u32, i64)]) -> Polynomial {
        terms.iter().copied().collect()
    }

    fn text(above: &[(u32, i64)], below: &[(u32, i64)]) -> String {
        let quotient = Quotient::new(&polynomial(above), &polynomial(below)).unwrap();
        quotient.text(&|symbol| format!("k{}", symbol + 1))
    }

    #[test]
    fn common_factors_and_numbers_are_cancelled() {
        // −2·(k₁ − k₂)·(1 + k₃) over 4·(k₁ − k₂)·k₃
        let above = polynomial(&[(1, -2), (2, 2), (0b101, -2), (0b110, 2)]);
        let below = polynomial(&[(0b101, 4), (0b110, -4)]);
        let quotient = Quotient::new(&above, &below).unwrap();
        assert_eq!(quotient.text(&|symbol| format!("k{}", symbol + 1)), "−(1 + k3)/(2·k3)");
        assert_eq!(quotient.variables(), 0b100);
        assert!((quotient.value(&|_| 4.0) + 0.625).abs() < 1e-15);
        assert_eq!(quotient.numerator(), [Polynomial::constant(-1), polynomial(&[(0, 1), (4, 1)])]);
        assert_eq!(quotient.denominator(), [Polynomial::constant(2), polynomial(&[(4, 1)])]);
    }

    #[test]
    fn brackets_stand_where_they_are_needed() {
        assert_eq!(text(&[(0, 1), (1, 1)], &[(0, 1)]), "1 + k1");
        assert_eq!(text(&[(0, -1), (1, -1)], &[(0, 1)]), "−(1 + k1)");
        assert_eq!(text(&[(1, -1)], &[(0, 1)]), "−k1");
        assert_eq!(text(&[(0, 1)], &[(0, 1)]), "1");
        assert_eq!(text(&[(0, 1)], &[(1, 1)]), "1/k1");
        assert_eq!(text(&[(0, 1), (1, 1)], &[(1, -1)]), "−(1 + k1)/k1");
        assert_eq!(text(&[(0, 1), (1, 1)], &[(3, 1)]), "(1 + k1)/(k1·k2)");
        let product = [(0, 1), (1, 1), (2, 1), (3, 1)];
        assert_eq!(text(&product, &[(0, 1), (3, -1)]), "(1 + k1)·(1 + k2)/(1 − k1·k2)");
        assert_eq!(text(&product, &[(0, -1), (3, 1)]), "(1 + k1)·(1 + k2)/(k1·k2 − 1)");
    }

    #[test]
    fn a_factor_takes_the_minus_sign_where_one_can() {
        assert_eq!(text(&[(2, 1), (3, 1)], &[(1, -1), (2, 1)]), "(1 + k1)·k2/(k2 − k1)");
        assert_eq!(text(&[(2, 1), (3, 1)], &[(1, 1), (2, -1)]), "(1 + k1)·k2/(k1 − k2)");
        assert_eq!(text(&[(1, -1), (2, 1)], &[(4, 1)]), "(k2 − k1)/k3");
        assert_eq!(text(&[(0, -2), (1, -2)], &[(2, 1)]), "−2·(1 + k1)/k2");
        let quotient = Quotient::new(&polynomial(&[(1, -1), (2, 1)]), &polynomial(&[(4, 1)])).unwrap();
        assert!((quotient.value(&|symbol| (symbol + 1) as f64) - 1.0 / 3.0).abs() < 1e-15);
    }

    #[test]
    fn nothing_over_something_is_no_quotient() {
        assert!(Quotient::new(&Polynomial::default(), &Polynomial::constant(1)).is_none());
        assert!(Quotient::new(&Polynomial::constant(1), &Polynomial::default()).is_none());
    }
}
