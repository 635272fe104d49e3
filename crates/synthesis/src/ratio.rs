//! Ratios as formulas: quotients of two polynomials in the ring-to-sun ratios, factored, common factors
//! cancelled.
//!
//! A polynomial of at most the first degree in each `kᵢ` has factors that share no `kᵢ`. Consider its
//! coefficients as a table, by the products within a set `U` of the `kᵢ` and the products of the others. The
//! polynomial splits over `U` if this table has rank 1; the table's first row and column are the factors.
//! With coefficients −1, 0 and 1 those of the factors are such, too.

use crate::motion::Speeds;
use crate::ternary::{Ternary, Word};
use epicyclic_train::formula::quotient::Quotient;
use epicyclic_train::formula::{self, subscript};
use std::fmt;

/// A polynomial in `k₁ … kₙ`, at most of the first degree in each, with coefficients −1, 0 and 1.
pub type Polynomial = Ternary<u64>;

impl Polynomial {
    /// The polynomial 1.
    pub const ONE: Self = Self { plus: 1, minus: 0 };

    /// The coefficient of the product of these `k`.
    #[must_use]
    pub const fn coefficient(self, product: usize) -> i8 {
        (self.plus >> product & 1) as i8 - (self.minus >> product & 1) as i8
    }

    /// Products that occur, in the order of their bits.
    fn products(self) -> impl Iterator<Item = usize> {
        let mut left = self.plus | self.minus;
        std::iter::from_fn(move || {
            let product = left.trailing_zeros() as usize;
            (left != 0).then(|| {
                left &= left - 1;
                product
            })
        })
    }

    /// The `k` that occur, as bits.
    #[must_use]
    pub fn variables(self) -> usize {
        self.products().fold(0, |all, product| all | product)
    }

    /// Value of the polynomial.
    ///
    /// Every variable needs its place in `k`: the value of a polynomial with more variables would be wrong.
    #[must_use]
    pub fn value(self, k: &[f64]) -> f64 {
        let term = |product: usize| {
            (0..k.len()).filter(|set| product >> set & 1 == 1).map(|set| k[set]).product::<f64>()
        };
        self.products().map(|product| f64::from(self.coefficient(product)) * term(product)).sum()
    }

    fn with(mut self, product: usize, coefficient: i8) -> Self {
        match coefficient {
            1 => self.plus |= 1 << product,
            -1 => self.minus |= 1 << product,
            _ => {}
        }
        self
    }

    /// Returns the polynomial with a first coefficient of 1, and whether the sign was changed.
    fn positive(self) -> (Self, bool) {
        let negative = self.products().next().is_some_and(|first| self.coefficient(first) < 0);
        (if negative { self.negated() } else { self }, negative)
    }

    /// Factors of the polynomial over the variables `within` and over the others, if it is such a product.
    fn split(self, within: usize) -> Option<(Self, Self)> {
        let base = self.products().next()?;
        let part = |mask: usize| {
            let zero = Self::default();
            self.products()
                .filter(|product| product & !mask == base & !mask)
                .fold(zero, |part, product| part.with(product & mask, self.coefficient(product)))
        };
        let (inner, outer) = (part(within), part(!within));
        // Both parts hold the coefficient of `base`.
        let outer = if self.coefficient(base) < 0 { outer.negated() } else { outer };
        (inner.times_other(outer) == self).then_some((inner, outer))
    }

    /// Factors that split no further, each with a first coefficient of 1, and whether their product has the
    /// other sign.
    ///
    /// The polynomial 0 has none, nor have 1 and −1.
    #[must_use]
    pub fn factors(self) -> (Vec<Self>, bool) {
        let (mut rest, mut negative) = self.positive();
        let mut factors = Vec::new();
        while rest.variables() != 0 {
            // The least set of variables with the lowest over which the rest splits gives a factor that
            // splits no further.
            let all = rest.variables();
            let lowest = all & all.wrapping_neg();
            let mut within: Vec<usize> =
                (1..=all).filter(|some| some & !all == 0 && some & lowest != 0).collect();
            within.sort_by_key(|some| some.count_ones());
            let Some((factor, other)) = within.into_iter().find_map(|within| rest.split(within)) else {
                break;
            };
            let ((factor, one), (other, two)) = (factor.positive(), other.positive());
            negative ^= one ^ two;
            factors.push(factor);
            rest = other;
        }
        factors.sort_unstable_by_key(|factor| (factor.variables(), factor.plus, factor.minus));
        (factors, negative)
    }

    /// The product of two polynomials without a common variable.
    fn times_other(self, other: Self) -> Self {
        self.products().fold(Self::default(), |product, one| {
            other.products().fold(product, |product, two| {
                product.with(one | two, self.coefficient(one) * other.coefficient(two))
            })
        })
    }
}

/// The ratio of a gear: input speed to output speed, `i = P/Q`, without common factors.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Ratio {
    /// `P`, the input's speed.
    pub numerator: Polynomial,
    /// `Q`, the output's speed; its first coefficient is 1.
    pub denominator: Polynomial,
}

impl Ratio {
    /// The ratio 1 of a direct gear.
    pub const ONE: Self = Self { numerator: Polynomial::ONE, denominator: Polynomial::ONE };

    /// Ratio of these speeds, unless input or output are at rest for every `k`.
    #[must_use]
    pub fn new(input: Polynomial, output: Polynomial) -> Option<Self> {
        if input.is_zero() || output.is_zero() {
            return None;
        }
        let (mut above, one) = input.factors();
        let (mut below, other) = output.factors();
        above.retain(|factor| {
            let common = below.iter().position(|candidate| candidate == factor);
            if let Some(place) = common {
                below.remove(place);
            }
            common.is_none()
        });
        let product = |factors: &[Polynomial]| {
            factors.iter().fold(Polynomial::ONE, |all, factor| all.times_other(*factor))
        };
        let (numerator, denominator) = (product(&above), product(&below));
        // Factors begin with a coefficient of 1, and so does their product.
        Some(Self { numerator: if one != other { numerator.negated() } else { numerator }, denominator })
    }

    /// Ratio of the speeds of a gear, unless input or output are at rest for every `k`.
    #[must_use]
    pub fn of<W: Word>(speeds: Speeds<W>) -> Option<Self> {
        let wide = |speed: Ternary<W>| Ternary { plus: speed.plus.into(), minus: speed.minus.into() };
        Self::new(wide(speeds.input), wide(speeds.output))
    }

    /// Words of the ratio, by which ratios are ordered.
    pub(crate) const fn words(self) -> [u64; 4] {
        let Self { numerator, denominator } = self;
        [numerator.plus, numerator.minus, denominator.plus, denominator.minus]
    }

    /// Value of the ratio; infinite or not a number if the output is at rest.
    #[must_use]
    pub fn value(self, k: &[f64]) -> f64 {
        self.numerator.value(k) / self.denominator.value(k)
    }

    /// Formats the ratio with the given names of the `k`.
    #[must_use]
    pub fn text(self, name: &dyn Fn(usize) -> String) -> String {
        match Quotient::new(&written(self.numerator), &written(self.denominator)) {
            Some(quotient) => quotient.text(name),
            None => {
                format!("{}/{}", written(self.numerator).text(name), written(self.denominator).text(name))
            }
        }
    }

    /// The `k` on which it depends, as bits.
    #[must_use]
    pub fn variables(self) -> usize {
        self.numerator.variables() | self.denominator.variables()
    }
}

/// Converts a polynomial to the solver's form, which can be written as text.
fn written(polynomial: Polynomial) -> formula::polynomial::Polynomial {
    let term =
        |product: usize| Some((u32::try_from(product).ok()?, i64::from(polynomial.coefficient(product))));
    polynomial.products().filter_map(term).collect()
}

fn name(set: usize) -> String {
    subscript('k', set + 1)
}

impl fmt::Display for Polynomial {
    /// `1 + k₁ + k₁·k₂`, lower degrees first.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&written(*self).text(&name))
    }
}

impl fmt::Display for Ratio {
    /// `(1 + k₁)·(1 + k₂)/(1 − k₁·k₂)`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&self.text(&name))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A polynomial from its coefficients, those of products of few `k` first in the order of their bits.
    fn polynomial(terms: &[(usize, i8)]) -> Polynomial {
        terms
            .iter()
            .fold(Polynomial::default(), |all, (product, coefficient)| all.with(*product, *coefficient))
    }

    #[test]
    fn factors_are_found_and_written() {
        // (1 + k₁)·(1 − k₂·k₃)
        let product = polynomial(&[(0, 1), (1, 1), (0b110, -1), (0b111, -1)]);
        let (factors, negative) = product.factors();
        assert!(!negative);
        assert_eq!(factors, [polynomial(&[(0, 1), (1, 1)]), polynomial(&[(0, 1), (0b110, -1)])]);
        let whole = polynomial(&[(0, 1), (1, 1), (0b11, 1)]);
        assert_eq!(whole.factors().0, [whole]);
        assert_eq!(whole.to_string(), "1 + k₁ + k₁·k₂");
        assert_eq!(polynomial(&[(0b1, -1)]).factors(), (vec![polynomial(&[(1, 1)])], true));
    }

    #[test]
    fn common_factors_are_cancelled() {
        // (k₁ − k₂)·(1 + k₃) over (k₁ − k₂)·k₃
        let above = polynomial(&[(1, 1), (2, -1), (0b101, 1), (0b110, -1)]);
        let below = polynomial(&[(0b101, -1), (0b110, 1)]);
        let ratio = Ratio::new(above, below).unwrap();
        assert_eq!(ratio.to_string(), "−(1 + k₃)/k₃");
        assert!((ratio.value(&[2.0, 3.0, 4.0]) + 1.25).abs() < 1e-15);
        assert_eq!(ratio.variables(), 0b100);
    }

    /// The solver's formulas divide and cancel by other means: integers in a tree, not bits.
    #[test]
    fn products_are_cancelled_as_by_the_formulas_of_the_solver() {
        let factors = [
            polynomial(&[(0, 1), (1, 1)]),
            polynomial(&[(0b10, 1), (0b100, -1)]),
            polynomial(&[(0b1000, -1)]),
            polynomial(&[(0, 1), (0b1001, -1)]),
            polynomial(&[(0, 1), (0b10, 1), (0b110, 1)]),
            Polynomial::ONE.negated(),
        ];
        let mut tried = 0;
        for above in factors {
            for below in factors {
                for common in factors {
                    let apart = |one: Polynomial| one.variables() & common.variables() == 0;
                    if apart(above) && apart(below) {
                        let (above, below) = (above.times_other(common), below.times_other(common));
                        let text = Quotient::new(&written(above), &written(below)).unwrap().text(&name);
                        assert_eq!(Ratio::new(above, below).unwrap().to_string(), text);
                        tried += 1;
                    }
                }
            }
        }
        assert!(tried > 80, "{tried}");
    }

    #[test]
    fn a_ratio_needs_both_speeds() {
        assert!(Ratio::new(Polynomial::default(), Polynomial::ONE).is_none());
        assert!(Ratio::new(Polynomial::ONE, Polynomial::default()).is_none());
        let direct = Ratio { numerator: Polynomial::ONE, denominator: Polynomial::ONE };
        assert_eq!(Ratio::new(Polynomial::ONE, Polynomial::ONE), Some(direct));
    }
}
